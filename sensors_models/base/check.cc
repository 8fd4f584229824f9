#include "sensors_models/base/check.h"

namespace drydock::internal {

void ThrowInputError(const std::string& message) { throw InputError(message); }
void ThrowLogicError(const std::string& message) { throw std::logic_error(message); }

}  // namespace drydock::internal
