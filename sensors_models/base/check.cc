#include "sensors_models/base/check.h"

namespace drydock::internal {

void ThrowInputError(std::string message) { throw InputError(message); }
void ThrowLogicError(std::string message) { throw std::logic_error(message); }

}  // namespace drydock::internal
