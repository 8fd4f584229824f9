#include "tools/drydock/realtime_arguments.h"

#include <fmt/format.h>

namespace drydock::cli {

void AddRealtimeOptions(CLI::App& command, RealtimeArguments& arguments) {
  CLI::Option* realtime = command.add_flag(
      "--realtime", arguments.realtime,
      "The estimator takes the time that it takes on this machine, and misses the stereo frames "
      "that come too fast; no longer reproducible");
  command
      .add_option("--frame-queue", arguments.config.frame_queue,
                  "How many stereo frames may wait for it before the oldest is dropped")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000))
      ->needs(realtime);
}

void PrintRealtime(const std::optional<RealtimeReport>& report) {
  if (!report) return;
  fmt::print("in real time: {} of {} stereo frames dropped, longest wait {:.2f} s\n",
             report->drops.size(), report->frames, report->longest_wait.Seconds());
}

}  // namespace drydock::cli
