#include "tests/support/temporary_folder.h"

#include <string>

#include <stdlib.h>

#include "sensors_models/base/check.h"

namespace drydock::testing {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "drydock-test-XXXXXX").string();
  Check(::mkdtemp(name.data()) != nullptr, "no temporary folder can be made");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace drydock::testing
