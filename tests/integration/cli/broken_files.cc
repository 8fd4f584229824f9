#include "tests/integration/cli/broken_files.h"

#include <gmock/gmock.h>

#include "sensors_models/base/files.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;

/// The program's own limit is none: what takes longer hangs.
constexpr int kLimitSeconds = 60;

std::string WithFolder(std::string text, const fs::path& folder) {
  for (auto at = text.find('@'); at != std::string::npos; at = text.find('@', at + 1))
    text.replace(at, 1, folder.string() + "/");
  return text;
}

}  // namespace

How Edit(const std::string& from, const std::string& to) {
  return [=](const fs::path& path) {
    std::string text = ReadFile(path);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << path << " has no " << from;
    WriteFileAtomically(path, text.replace(at, from.size(), to));
  };
}

How Whole(const std::string& content) {
  return [=](const fs::path& path) { WriteFileAtomically(path, content); };
}

How Append(const std::string& content) {
  return [=](const fs::path& path) { WriteFileAtomically(path, ReadFile(path) + content); };
}

How Remove() {
  return [](const fs::path& path) { ASSERT_GT(fs::remove_all(path), 0U) << path; };
}

How Folder() {
  return [](const fs::path& path) {
    fs::remove(path);
    fs::create_directory(path);
  };
}

How CutOff(std::size_t bytes) {
  return [=](const fs::path& path) {
    const std::string text = ReadFile(path);
    ASSERT_GT(text.size(), bytes) << path;
    WriteFileAtomically(path, text.substr(0, text.size() - bytes));
  };
}

How Utf16() {
  return [](const fs::path& path) {
    std::string wide = "\xff\xfe";
    for (const char c : ReadFile(path)) wide += {c, '\0'};
    WriteFileAtomically(path, wide);
  };
}

void BrokenFilesTest::ExpectRefusal(const Broken& row) const {
  if (!row.file.empty()) row.how(inputs() / row.file);
  if (HasFatalFailure()) return;
  std::vector<std::string> arguments;
  arguments.reserve(row.command.size());
  for (const std::string& argument : row.command)
    arguments.push_back(WithFolder(argument, inputs()));
  const TemporaryFolder work;
  const Outcome outcome = RunDrydock(work.path(), arguments, kLimitSeconds);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  for (const std::string& message : row.says)
    EXPECT_THAT(outcome.err, ::testing::HasSubstr(WithFolder(message, inputs())));
  EXPECT_LT(outcome.err.size(), 2000U) << "a message is to be read";
  EXPECT_TRUE(fs::is_empty(work.path())) << *fs::directory_iterator(work.path());
}

}  // namespace drydock::testing
