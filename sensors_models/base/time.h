// Integer time. Nothing in Drydock accumulates floating-point seconds: an instant is a count of
// nanoseconds, and the k-th sample of a sensor is computed from k, not from the sample before it.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace drydock {

inline constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

/// A span of time [ns], may be negative.
struct Duration {
  std::int64_t ns = 0;

  constexpr double Seconds() const { return static_cast<double>(ns) / 1e9; }
  /// The nearest whole number of nanoseconds.
  static Duration FromSeconds(double seconds) { return {std::llround(seconds * 1e9)}; }

  constexpr auto operator<=>(const Duration&) const = default;
};

/// An instant [ns], counted from the start of the run (simulation) or from the Unix epoch
/// (recordings).
struct Time {
  std::int64_t ns = 0;

  constexpr double Seconds() const { return static_cast<double>(ns) / 1e9; }
  static Time FromSeconds(double seconds) { return {std::llround(seconds * 1e9)}; }

  constexpr auto operator<=>(const Time&) const = default;
};

constexpr Duration operator-(Time a, Time b) { return {a.ns - b.ns}; }
constexpr Time operator+(Time t, Duration d) { return {t.ns + d.ns}; }
constexpr Time operator-(Time t, Duration d) { return {t.ns - d.ns}; }
constexpr Duration operator+(Duration a, Duration b) { return {a.ns + b.ns}; }
constexpr Duration operator-(Duration a, Duration b) { return {a.ns - b.ns}; }

/// When the k-th sample of a sensor at `rate_hz` is due, counted from `start`: floor(k * 1e9 /
/// rate). Exact for integer rates; `k` >= 0, `rate_hz` > 0.
constexpr Time SampleTime(Time start, std::int64_t k, double rate_hz) {
  const auto whole_rate = static_cast<std::int64_t>(rate_hz);
  if (static_cast<double>(whole_rate) == rate_hz) {
    const std::int64_t seconds = k / whole_rate;
    const std::int64_t rest = k % whole_rate;
    return {start.ns + seconds * kNanosecondsPerSecond + rest * kNanosecondsPerSecond / whole_rate};
  }
  return {start.ns + static_cast<std::int64_t>(static_cast<double>(k) / rate_hz * 1e9)};
}

}  // namespace drydock
