// Runs the program as a user does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace drydock::testing {

struct Outcome {
  int exit_code = -1;  ///< -1 if the program was ended by a signal, 124 if it took too long.
  std::string out;
  std::string err;
};

/// `drydock ARGUMENTS` in `folder`, with no terminal and no input. What it says goes to files
/// beside `folder`, not into it. Ended after `limit_s` seconds.
Outcome RunDrydock(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                   int limit_s = 240);

/// The bus dive with dead reckoning from the true start: what most tests swim a second of.
std::string BusScenario();

}  // namespace drydock::testing
