#include "scenarios/dataset/parse.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace drydock::dataset {
namespace {

template <typename Number>
std::optional<Number> ParseNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// A decimal number: 0.DIGITS * 10^point, with its sign.
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t point = 0;
};

std::optional<Decimal> ParseDecimal(std::string_view text) {
  if (!ParseReal(text)) return std::nullopt;  // From here on the form is known to be right.
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const auto exponent_at = std::min(text.find_first_of("eE"), text.size());
  bool behind_point = false;
  for (const char c : text.substr(0, exponent_at)) {
    if (!IsDigit(c)) {
      behind_point = true;
      continue;
    }
    decimal.digits += c;
    if (!behind_point) ++decimal.point;
  }
  if (exponent_at < text.size()) {
    const auto exponent = ParseInteger(text.substr(exponent_at + 1));
    if (!exponent) return std::nullopt;
    constexpr std::int64_t kFar = 100'000;  // Beyond every double's exponent.
    decimal.point += std::clamp(*exponent, -kFar, kFar);
  }
  const auto zeros = std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size());
  decimal.digits.erase(0, zeros);
  decimal.point -= static_cast<std::int64_t>(zeros);
  return decimal;
}

}  // namespace

std::optional<double> ParseReal(std::string_view text) {
  const auto value = ParseNumber<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  return ParseNumber<std::int64_t>(text);
}

std::optional<Time> ParseSeconds(std::string_view text) {
  constexpr std::int64_t kMaxDigits = 19;
  const auto decimal = ParseDecimal(text);
  if (!decimal) return std::nullopt;
  if (decimal->digits.empty()) return Time{0};
  const std::int64_t whole =
      decimal->point + 9;  // How many digits stand before a nanosecond's end.
  if (whole > kMaxDigits) return std::nullopt;
  if (whole < 0) return Time{0};
  const auto digit = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    return at < decimal->digits.size() ? decimal->digits[at] - '0' : 0;
  };
  std::uint64_t ns = 0;
  for (std::int64_t i = 0; i < whole; ++i) ns = 10 * ns + static_cast<std::uint64_t>(digit(i));
  if (digit(whole) >= 5) ++ns;
  constexpr auto kMaxNanoseconds =
      static_cast<std::uint64_t>(kLastSecond) * static_cast<std::uint64_t>(kNanosecondsPerSecond);
  if (ns > kMaxNanoseconds) return std::nullopt;
  const auto magnitude = static_cast<std::int64_t>(ns);
  return Time{decimal->negative ? -magnitude : magnitude};
}

std::string FormatSeconds(Time t) {
  const auto parts = std::lldiv(t.ns, kNanosecondsPerSecond);
  return fmt::format("{}{}.{:09}", t.ns < 0 ? "-" : "", std::llabs(parts.quot),
                     std::llabs(parts.rem));
}

std::optional<std::string_view> LineReader::Next() {
  if (rest_.empty()) return std::nullopt;
  const auto end = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++number_;
  return line;
}

std::string_view Trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kMax = 40;
  std::string out = "'";
  for (const char c : text.substr(0, kMax)) out += c >= 0x20 && c < 0x7f ? c : '?';
  return out + (text.size() > kMax ? "…'" : "'");
}

}  // namespace drydock::dataset
