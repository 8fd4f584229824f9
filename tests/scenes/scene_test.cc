#include "scenes/scene.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/support/input_error.h"

namespace drydock::scenes {
namespace {
namespace fs = std::filesystem;
using drydock::testing::InputErrorOf;
using ::testing::HasSubstr;

/// An empty folder of this test's own.
fs::path FreshFolder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  fs::path folder =
      fs::path(::testing::TempDir()) / (std::string("drydock_scene_test_") + info->name());
  fs::remove_all(folder);
  return folder;
}

std::vector<SceneEntry> CountingScene(int& calls) {
  return {{"pond", "a pond", 3, [&calls](std::uint64_t seed, const fs::path& directory) {
             ++calls;
             WriteFileAtomically(directory / "scene.xml", "seed " + std::to_string(seed));
           }}};
}

TEST(PrepareScene, GeneratesOnceASeed) {
  const fs::path cache = FreshFolder();
  int calls = 0;
  const auto scenes = CountingScene(calls);
  const fs::path first = PrepareScene(scenes, "pond", 5, cache);
  EXPECT_EQ(first, cache / "scenes" / "pond-v3-5" / "scene.xml");
  EXPECT_EQ(ReadFile(first), "seed 5");
  EXPECT_EQ(PrepareScene(scenes, "pond", 5, cache), first);
  EXPECT_EQ(calls, 1);
  EXPECT_NE(PrepareScene(scenes, "pond", 6, cache), first);
  EXPECT_EQ(calls, 2);
}

TEST(PrepareScene, UnknownNameTellsWhatThereIs) {
  int calls = 0;
  const std::string error =
      InputErrorOf([&] { PrepareScene(CountingScene(calls), "puddle", 1, FreshFolder()); });
  EXPECT_THAT(error, HasSubstr("puddle"));
  EXPECT_THAT(error, HasSubstr("pond"));
}

TEST(PrepareScene, InterruptedGenerationLeavesNothing) {
  const fs::path cache = FreshFolder();
  bool fail = true;
  const std::vector<SceneEntry> scenes = {
      {"pond", "a pond", 1, [&fail](std::uint64_t, const fs::path& directory) {
         WriteFileAtomically(directory / "half", "done");
         if (fail) throw std::runtime_error("interrupted");
         WriteFileAtomically(directory / "scene.xml", "whole");
       }}};
  EXPECT_THROW(PrepareScene(scenes, "pond", 1, cache), std::runtime_error);
  EXPECT_FALSE(fs::exists(cache / "scenes"));
  fail = false;
  EXPECT_EQ(ReadFile(PrepareScene(scenes, "pond", 1, cache)), "whole");
}

TEST(Scenes, HaveNamesAndSummaries) {
  EXPECT_FALSE(Scenes().empty());
  for (const SceneEntry& scene : Scenes()) {
    EXPECT_FALSE(scene.name.empty());
    EXPECT_FALSE(scene.summary.empty());
    EXPECT_GE(scene.version, 1);
    EXPECT_TRUE(scene.generate);
  }
}

}  // namespace
}  // namespace drydock::scenes
