// Any text is a trajectory or refused with an InputError; a trajectory is written and read again
// without loss.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "scenarios/dataset/parse.h"
#include "scenarios/dataset/tum.h"
#include "sensors_models/base/check.h"
#include "tests/fuzz/require.h"

namespace drydock::fuzz {
namespace {

void Run(std::string_view text) {
  if (const auto t = dataset::ParseSeconds(text)) {
    Require(dataset::ParseSeconds(dataset::FormatSeconds(*t)) == t, "a time comes back");
  }
  Trajectory trajectory;
  try {
    trajectory = dataset::ParseTum(text, "fuzz.tum");
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with("fuzz.tum:"), "an error names its place");
    return;
  }
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    Require(i == 0 || trajectory[i - 1].t < trajectory[i].t, "times increase");
    Require(trajectory[i].T_WI.p().allFinite(), "positions are finite");
  }
  const std::string written = dataset::FormatTum(trajectory);
  Require(dataset::FormatTum(dataset::ParseTum(written, "written")) == written,
          "a trajectory comes back");
}

}  // namespace
}  // namespace drydock::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
