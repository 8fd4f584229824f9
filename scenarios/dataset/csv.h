// Comma-separated values as EuRoC has them: numbers and file names, no quotes, '#' begins a
// comment.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/dataset/parse.h"
#include "sensors_models/base/time.h"

namespace drydock::dataset {

/// Goes through the rows of a table and reads their fields strictly: every error is an InputError
/// "file:line: …" that names the column, the value and what is allowed. Blanks around a field,
/// empty lines, lines that begin with '#' and CRLF are tolerated.
class CsvReader {
 public:
  /// A row has `columns.size()` fields or, where `required` > 0, at least `required` of them.
  /// `text` must outlive the reader.
  CsvReader(std::string_view text, std::string file, std::vector<std::string> columns,
            std::size_t required = 0);

  /// Moves to the next row, or tells that there is none.
  bool Next();

  /// How many fields the row has.
  std::size_t size() const { return fields_.size(); }
  /// A number within ±kLargest.
  double Real(std::size_t column) const;
  std::int64_t Integer(std::size_t column) const;
  /// A time in whole nanoseconds from 0 to kLastSecond.
  Time Stamp(std::size_t column) const;
  /// The same, later than the one that this was called for last.
  Time IncreasingStamp(std::size_t column);
  /// Text that is not empty.
  std::string_view Text(std::size_t column) const;
  /// The name of a file beside others: not empty, no folders.
  std::string_view FileName(std::size_t column) const;

  /// "file:line" of the row.
  std::string Place() const;
  [[noreturn]] void Fail(std::size_t column, std::string_view allowed) const;

 private:
  std::string file_;
  LineReader lines_;
  std::vector<std::string> columns_;
  std::size_t required_;
  std::vector<std::string_view> fields_;
  Time last_{-1};
};

}  // namespace drydock::dataset
