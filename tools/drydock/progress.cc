#include "tools/drydock/progress.h"

#include <chrono>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

namespace drydock::cli {
namespace {

using Clock = std::chrono::steady_clock;

class Progress {
 public:
  void Show(Time now, Time end) {
    const auto wall = Clock::now();
    const bool last = now >= end;
    if (!last && wall - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = wall;
    const double elapsed = std::chrono::duration<double>(wall - start_).count();
    const double rate = elapsed > 0.0 ? now.Seconds() / elapsed : 0.0;
    const double left = rate > 0.0 ? (end - now).Seconds() / rate : 0.0;
    fmt::print(stderr, "\r{:6.1f} of {:.1f} s, {:.2f} x real time, {:.0f} s left \x1b[K",
               now.Seconds(), end.Seconds(), rate, left);
    if (last) fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
  }

 private:
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace

std::function<void(Time, Time)> ProgressOnTerminal() {
  if (::isatty(STDERR_FILENO) == 0) return [](Time, Time) {};
  return
      [progress = std::make_shared<Progress>()](Time now, Time end) { progress->Show(now, end); };
}

}  // namespace drydock::cli
