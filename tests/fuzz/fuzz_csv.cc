// Every row of any text is read or refused with an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scenarios/dataset/csv.h"
#include "sensors_models/base/check.h"
#include "tests/fuzz/require.h"

namespace drydock::fuzz {
namespace {

/// Calls `read`, which may refuse.
template <typename Read>
void Try(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with("fuzz.csv:"), "an error names its place");
  }
}

void Run(std::string_view text) {
  dataset::CsvReader csv(text, "fuzz.csv", {"timestamp", "value", "name", "more"}, 3);
  Try([&] {
    while (csv.Next()) {
      Require(csv.size() == 3 || csv.size() == 4, "a row has as many fields as are allowed");
      for (std::size_t column = 0; column < csv.size(); ++column) {
        Try([&] { Require(std::isfinite(csv.Real(column)), "numbers are finite"); });
        Try([&] { csv.Integer(column); });
        Try([&] { Require(csv.Stamp(column).ns >= 0, "times are not negative"); });
        Try([&] { Require(!csv.Text(column).empty(), "text is not empty"); });
        Try([&] {
          const std::string_view name = csv.FileName(column);
          Require(name.find('/') == std::string_view::npos && name != "..", "names are plain");
        });
      }
      Try([&] { csv.IncreasingStamp(0); });
    }
  });
}

}  // namespace
}  // namespace drydock::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
