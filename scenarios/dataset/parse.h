// Numbers from text, exactly, and lines with their places.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sensors_models/base/time.h"

namespace drydock::dataset {

/// Times lie within ±4.6e9 s (the year 2115), so that the span between any two fits into 64 bits of
/// nanoseconds.
inline constexpr std::int64_t kLastSecond = 4'600'000'000;
/// Lengths, rates and accelerations are below this in magnitude: what is larger is a mistake, and
/// its square might be infinite.
inline constexpr double kLargest = 1e9;
inline constexpr std::string_view kWithinLargest = "a number from -1e9 to 1e9";

/// The whole text as a finite number; a leading '+' is allowed.
std::optional<double> ParseReal(std::string_view text);

/// The whole text as a whole number.
std::optional<std::int64_t> ParseInteger(std::string_view text);

/// Decimal seconds ("1600000000.1036668", "1.6e9") as the nearest nanosecond, without rounding to a
/// double on the way. Nothing for what is not a number or beyond kLastSecond.
std::optional<Time> ParseSeconds(std::string_view text);

/// The exact decimal seconds of a time, with nine digits behind the point.
std::string FormatSeconds(Time t);

/// Goes through a text line by line: CRLF and LF end a line; neither is part of it.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line, or nothing at the end.
  std::optional<std::string_view> Next();
  /// The number of the line that Next() gave last, from 1.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// The text without blanks (space, tab) at its ends.
std::string_view Trim(std::string_view text);

/// For messages: at most 40 bytes, bytes that are not printable ASCII replaced by '?'.
std::string Quoted(std::string_view text);

}  // namespace drydock::dataset
