#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "tools/drydock/commands.h"

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
#endif
  AddEstimateCommand(app, chosen);
  AddScoreCommand(app, chosen);
  AddListCommand(app, chosen);
  try {
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kPassed : kCouldNotRun;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return kCouldNotRun;
  }
}
