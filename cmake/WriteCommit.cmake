# Run at each build: writes ${OUTPUT} anew only if the commit has changed.
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [=[
#include "scenarios/version/version.h"

namespace drydock {

std::string_view Commit() { return "@commit@"; }

}  // namespace drydock
]=] @ONLY)
