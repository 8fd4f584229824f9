#include "estimator/svin2/vocabulary/vocabulary_file.h"

#include <filesystem>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"
#include "tests/support/input_error.h"
#include "tests/support/temporary_folder.h"

namespace drydock::svin2 {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::SmallVocabulary;
using ::testing::StartsWith;

void ExpectRefused(const std::string& content, const std::string& why) {
  const std::string error = InputErrorOf([&] { ParseVocabulary(content, "a.vocabulary"); });
  EXPECT_THAT(error, AllOf(StartsWith("a.vocabulary: "), HasSubstr(why)));
}

const VocabularyTree& SmallTree() {
  static const VocabularyTree kTree = SmallVocabulary().tree();
  return kTree;
}

TEST(VocabularyFile, RoundTripIsExact) {
  const drydock::testing::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "deep" / "small.vocabulary";
  Vocabulary(SmallTree()).Save(path);
  EXPECT_EQ(Vocabulary::Load(path).tree(), SmallTree());
  EXPECT_EQ(ReadFile(path), FormatVocabulary(SmallTree()));
  // Nothing else is left beside it.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
}

TEST(VocabularyFile, IsSmallerThanItsTree) {
  const std::size_t plain = SmallTree().centres.size() * sizeof(Descriptor);
  EXPECT_LT(FormatVocabulary(SmallTree()).size(), plain);
}

TEST(VocabularyFile, NamesTheFileThatIsNotThere) {
  const std::string error = InputErrorOf([&] { Vocabulary::Load("/nowhere/a.vocabulary"); });
  EXPECT_EQ(error, "/nowhere/a.vocabulary: no such file");
}

TEST(VocabularyFile, RefusesOtherFiles) {
  ExpectRefused("", "is empty");
  ExpectRefused("%YAML:1.0\nvocabulary:\n   k: 10\n", "is no vocabulary of Drydock");
  ExpectRefused("DryVocaX", "is no vocabulary of Drydock");
  std::string other = FormatVocabulary(SmallTree());
  other[8] = 2;
  ExpectRefused(other, "is of version 2; this program reads version 1");
}

TEST(VocabularyFile, RefusesEveryTruncation) {
  const std::string content = FormatVocabulary(SmallTree());
  for (std::size_t size = 1; size < content.size(); size += size < 64 ? 1 : 97) {
    ExpectRefused(content.substr(0, size), "is cut short");
  }
  ExpectRefused(content + "x", "1 bytes follow its end");
}

// Whatever bit flips, in the header or behind it.
TEST(VocabularyFile, RefusesEveryDamagedByte) {
  const std::string content = FormatVocabulary(SmallTree());
  for (std::size_t i = 0; i < content.size(); i += i < 128 ? 1 : 31) {
    for (const int bit : {0, 3, 7}) {
      std::string damaged = content;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      ExpectRefused(damaged, "");
    }
  }
  std::string damaged = content;
  damaged[content.size() / 2] ^= 0x10;
  ExpectRefused(damaged, "is damaged");
  damaged = content;
  damaged[20] ^= 0x10;
  ExpectRefused(damaged, "its checksum is wrong");
  damaged = content;
  damaged[19] = 0x7f;
  ExpectRefused(damaged, "cannot unpack to");
}

std::string U32(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  return bytes;
}

// A file that is whole, around a tree that is none.
TEST(VocabularyFile, RefusesTreesThatAreNone) {
  const std::string centre(sizeof(Descriptor), 'c');
  const std::string weight("\0\0\x80\x3f", 4);  // 1.0
  const std::string two = std::string("\2\0\0", 3) + centre + centre + weight + weight;
  EXPECT_NO_THROW(ParseVocabulary(PackVocabulary(U32(2) + U32(1) + U32(3) + two), "good"));
  const auto refused = [](const std::string& tree, const std::string& why) {
    ExpectRefused(PackVocabulary(tree), why);
  };
  refused("", "ends too early");
  refused(U32(2) + U32(1), "ends too early");
  refused(U32(2) + U32(1) + U32(4'000'000'000) + two, "cannot have 4000000000 nodes");
  refused(U32(2) + U32(1) + U32(0) + two, "cannot have 0 nodes");
  refused(U32(2) + U32(1) + U32(3) + two.substr(0, 3), "ends too early");
  refused(U32(2) + U32(1) + U32(3) + two.substr(0, two.size() - 1), "ends too early");
  refused(U32(2) + U32(1) + U32(3) + two + "x", "1 bytes follow the tree");
  refused(U32(2) + U32(1) + U32(4) + two, "of 4 nodes hang together");
  refused(U32(0xffffffff) + U32(1) + U32(3) + two, "branching factor");
  refused(U32(2) + U32(0xffffffff) + U32(3) + two, "number of levels");
  refused(U32(2) + U32(1) + U32(3) + two.substr(0, two.size() - 1) + "\xbf", "weight is -1");
}

}  // namespace
}  // namespace drydock::svin2
