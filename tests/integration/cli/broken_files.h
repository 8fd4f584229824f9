// Files in which something is wrong, one a row, and what the program must say of each.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {

/// Breaks the file at a path.
using How = std::function<void(const std::filesystem::path&)>;

/// Replaces the first `from` by `to`.
How Edit(const std::string& from, const std::string& to);
/// Puts `content` in its place.
How Whole(const std::string& content);
How Append(const std::string& content);
How Remove();
/// Puts a folder of the same name in its place.
How Folder();
/// Cuts the last `bytes` off.
How CutOff(std::size_t bytes);
/// Writes the same text in UTF-16 with a byte order mark.
How Utf16();

/// One row of the table.
struct Broken {
  std::string name;
  /// Of the program; "@" stands for the folder of the inputs.
  std::vector<std::string> command;
  std::string file;  ///< What is broken, below the folder of the inputs; "" for nothing.
  How how;
  std::vector<std::string> says;  ///< Each must be on stderr; "@" as above.
};

inline void PrintTo(const Broken& row, std::ostream* out) { *out << row.name; }
/// A row on GoogleTest's lists.
inline std::string NameOf(const ::testing::TestParamInfo<Broken>& row) { return row.param.name; }

class BrokenFilesTest : public ::testing::TestWithParam<Broken> {
 protected:
  std::filesystem::path inputs() const { return inputs_.path(); }
  /// Breaks the row's file, runs its command in an empty folder, and expects exit code 2, the
  /// messages on stderr, nothing on stdout and nothing written.
  void ExpectRefusal(const Broken& row) const;

 private:
  const TemporaryFolder inputs_;
};

}  // namespace drydock::testing
