#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/drydock/commands.h"

namespace {

/// CLI11 only says that a sub-command is required; this names the word that is none.
void RequireKnownCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(command->get_name());
  if (word.starts_with("-") || std::find(known.begin(), known.end(), word) != known.end()) return;
  throw CLI::ExtrasError(
      fmt::format("unknown command '{}', must be one of {}", word, fmt::join(known, ", ")),
      CLI::ExitCodes::ExtrasError);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace drydock::cli;  // NOLINT(google-build-using-namespace): the commands are all it
                                 // has.
  CLI::App app("Drydock: underwater SLAM, developed without dives");
  app.require_subcommand(1);
  app.footer("Exit codes: 0 all criteria met, 1 a criterion missed, 2 could not run.");
  Action chosen;
#ifdef DRYDOCK_WITH_SIM
  AddRunCommand(app, chosen);
  AddSimulateCommand(app, chosen);
  AddCompareCommand(app, chosen);
#endif
  AddEstimateCommand(app, chosen);
  AddScoreCommand(app, chosen);
  AddListCommand(app, chosen);
  try {
    if (argc > 1) RequireKnownCommand(app, argv[1]);
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kPassed : kCouldNotRun;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return kCouldNotRun;
  }
}
