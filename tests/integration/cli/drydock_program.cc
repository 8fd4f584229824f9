#include "tests/integration/cli/drydock_program.h"

#include <cstdlib>

#include <fmt/format.h>
#include <sys/wait.h>

#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

std::string Quoted(const std::string& text) { return "'" + text + "'"; }

}  // namespace

Outcome RunDrydock(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                   int limit_s) {
  const TemporaryFolder said;
  const std::filesystem::path out = said.path() / "out", err = said.path() / "err";
  std::string command = fmt::format("cd {} && timeout {} {}", Quoted(folder.string()), limit_s,
                                    Quoted(DRYDOCK_PROGRAM));
  for (const std::string& argument : arguments) command += " " + Quoted(argument);
  command += fmt::format(" </dev/null >{} 2>{}", Quoted(out.string()), Quoted(err.string()));
  const int status = std::system(command.c_str());
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  outcome.out = ReadFile(out);
  outcome.err = ReadFile(err);
  return outcome;
}

std::string BusScenario() { return DRYDOCK_SOURCE_DIR "/tests/data/dead_reckoning/bus.yaml"; }

}  // namespace drydock::testing
