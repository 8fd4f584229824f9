#include "sensors_models/base/files.h"

#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files()
      : folder_(fs::path(testing::TempDir()) /
                (std::string("drydock_files_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }

  /// Everything in the test's folder, hidden files too.
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  fs::path folder_;
};

TEST_F(Files, WriteFileMakesParentsAndLeavesNothingElse) {
  WriteFileAtomically(folder_ / "a/b/c.txt", std::string("one\0two", 7));
  EXPECT_EQ(ReadFile(folder_ / "a/b/c.txt"), std::string("one\0two", 7));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "a/b"), fs::directory_iterator()), 1);
}

TEST_F(Files, WriteFileReplaces) {
  WriteFileAtomically(folder_ / "f", "a long first version");
  WriteFileAtomically(folder_ / "f", "second");
  EXPECT_EQ(ReadFile(folder_ / "f"), "second");
  EXPECT_THAT(Names(), testing::ElementsAre("f"));
}

TEST_F(Files, WriteFileThatFailsThrowsAndLeavesNothing) {
  fs::create_directories(folder_ / "taken/inside");
  EXPECT_THROW(WriteFileAtomically(folder_ / "taken", "x"), InputError);
  EXPECT_THAT(Names(), testing::ElementsAre("taken"));
  WriteFileAtomically(folder_ / "file", "x");
  EXPECT_THROW(WriteFileAtomically(folder_ / "file/below", "x"), InputError);
}

TEST_F(Files, ReadFileNamesWhatIsWrong) {
  EXPECT_THROW(ReadFile(folder_ / "missing"), InputError);
  EXPECT_THROW(ReadFile(folder_), InputError);
  EXPECT_THROW(ReadFile("/dev/zero"), InputError);  // Never ends.
  WriteFileAtomically(folder_ / "big", "12345");
  EXPECT_THROW(ReadFile(folder_ / "big", 4), InputError);
  EXPECT_EQ(ReadFile(folder_ / "big", 5), "12345");
}

TEST_F(Files, AbandonedDirectoryLeavesNothing) {
  {
    AtomicDirectory directory(folder_ / "result");
    WriteFileAtomically(directory.path() / "deep/file", "x");
    EXPECT_FALSE(fs::exists(folder_ / "result"));
  }
  EXPECT_THAT(Names(), testing::IsEmpty());
}

TEST_F(Files, CommittedDirectoryAppearsWhole) {
  AtomicDirectory directory(folder_ / "parent/result/");
  WriteFileAtomically(directory.path() / "file", "x");
  directory.Commit(AtomicDirectory::IfExists::kReplace);
  EXPECT_EQ(ReadFile(folder_ / "parent/result/file"), "x");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "parent"), fs::directory_iterator()), 1);
}

TEST_F(Files, ReplaceSwapsTheWholeFolder) {
  WriteFileAtomically(folder_ / "result/old", "old");
  {
    AtomicDirectory directory(folder_ / "result");
    WriteFileAtomically(directory.path() / "new", "new");
    directory.Commit(AtomicDirectory::IfExists::kReplace);
  }
  EXPECT_FALSE(fs::exists(folder_ / "result/old"));
  EXPECT_EQ(ReadFile(folder_ / "result/new"), "new");
  EXPECT_THAT(Names(), testing::ElementsAre("result"));
}

TEST_F(Files, KeepTheirsLeavesWhatIsThere) {
  WriteFileAtomically(folder_ / "result/theirs", "theirs");
  {
    AtomicDirectory directory(folder_ / "result");
    WriteFileAtomically(directory.path() / "ours", "ours");
    directory.Commit(AtomicDirectory::IfExists::kKeepTheirs);
  }
  EXPECT_EQ(ReadFile(folder_ / "result/theirs"), "theirs");
  EXPECT_FALSE(fs::exists(folder_ / "result/ours"));
  EXPECT_THAT(Names(), testing::ElementsAre("result"));
}

TEST_F(Files, DirectoryInPlaceOfAFileThrowsAtOnce) {
  WriteFileAtomically(folder_ / "result", "a file");
  EXPECT_THROW(AtomicDirectory{folder_ / "result"}, InputError);
  EXPECT_EQ(ReadFile(folder_ / "result"), "a file");
  EXPECT_THAT(Names(), testing::ElementsAre("result"));
}

TEST_F(Files, AbandonedDirectoryTakesTheParentsItMadeWithIt) {
  fs::create_directories(folder_ / "theirs");
  { const AtomicDirectory directory(folder_ / "theirs/a/b/result"); }
  EXPECT_TRUE(fs::is_empty(folder_ / "theirs"));
  {
    const AtomicDirectory directory(folder_ / "theirs/a/b/result");
    WriteFileAtomically(folder_ / "theirs/a/other", "x");
  }
  EXPECT_EQ(ReadFile(folder_ / "theirs/a/other"), "x");
  EXPECT_FALSE(fs::exists(folder_ / "theirs/a/b"));
}

TEST_F(Files, OnlyResultsMayBeReplaced) {
  EXPECT_NO_THROW(RequireReplaceable(folder_ / "missing", {"mark"}));
  EXPECT_NO_THROW(RequireReplaceable(folder_, {"mark"}));  // Empty.
  WriteFileAtomically(folder_ / "thesis.txt", "x");
  EXPECT_THROW(RequireReplaceable(folder_, {"mark", "other"}), InputError);
  WriteFileAtomically(folder_ / "mark", "x");
  EXPECT_NO_THROW(RequireReplaceable(folder_, {"other", "mark"}));
}

}  // namespace
}  // namespace drydock
