#include "scenarios/dataset/csv.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/base/check.h"

namespace drydock::dataset {

CsvReader::CsvReader(std::string_view text, std::string file, std::vector<std::string> columns,
                     std::size_t required)
    : file_(std::move(file)),
      lines_(text),
      columns_(std::move(columns)),
      required_(required > 0 ? required : columns_.size()) {}

bool CsvReader::Next() {
  while (const auto line = lines_.Next()) {
    std::string_view rest = Trim(*line);
    if (rest.empty() || rest.starts_with('#')) continue;
    fields_.clear();
    while (true) {
      const auto comma = rest.find(',');
      fields_.push_back(Trim(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    const bool fits = fields_.size() >= required_ && fields_.size() <= columns_.size();
    RequireInput(fits, "{}: {} fields, must be {}{}", Place(), fields_.size(),
                 required_ < columns_.size() ? fmt::format("from {} to ", required_) : "",
                 columns_.size());
    return true;
  }
  fields_.clear();
  return false;
}

double CsvReader::Real(std::size_t column) const {
  const auto value = ParseReal(fields_.at(column));
  if (!value || std::abs(*value) > kLargest) Fail(column, kWithinLargest);
  return *value;
}

std::int64_t CsvReader::Integer(std::size_t column) const {
  const auto value = ParseInteger(fields_.at(column));
  if (!value) Fail(column, "a whole number");
  return *value;
}

Time CsvReader::Stamp(std::size_t column) const {
  const auto value = ParseInteger(fields_.at(column));
  if (!value || *value < 0 || *value > kLastSecond * kNanosecondsPerSecond)
    Fail(column, fmt::format("a time in whole nanoseconds from 0 to {}e9", kLastSecond));
  return {*value};
}

Time CsvReader::IncreasingStamp(std::size_t column) {
  const Time t = Stamp(column);
  if (t <= last_) Fail(column, fmt::format("later than the {} before it", last_.ns));
  last_ = t;
  return t;
}

std::string_view CsvReader::Text(std::size_t column) const {
  if (fields_.at(column).empty()) Fail(column, "text");
  return fields_[column];
}

std::string_view CsvReader::FileName(std::size_t column) const {
  const std::string_view name = Text(column);
  const bool plain = name.find_first_of(std::string_view("/\\\0", 3)) == std::string_view::npos &&
                     name != "." && name != "..";
  if (!plain) Fail(column, "the name of a file without a folder");
  return name;
}

std::string CsvReader::Place() const { return fmt::format("{}:{}", file_, lines_.number()); }

void CsvReader::Fail(std::size_t column, std::string_view allowed) const {
  throw InputError(fmt::format("{}: {} is {}, must be {}", Place(), columns_.at(column),
                               Quoted(fields_.at(column)), allowed));
}

}  // namespace drydock::dataset
