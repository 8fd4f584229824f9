#include "sim/world/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sim/world/mujoco_errors.h"
#include "tests/support/input_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using drydock::testing::InputErrorOf;

TEST(World, NamesTheBodyOfAGeom) {
  const testing::TemporaryFolder folder;
  const World world(
      testing::WriteScene(folder.path(), testing::BoxElement("rock", {1, 0, 0}, {0.1, 0.1, 0.1}) +
                                             "<geom type=\"plane\" size=\"1 1 1\"/>"));
  EXPECT_EQ(world.BodyOfGeom(0), "world");
  EXPECT_EQ(world.BodyOfGeom(1), "rock");
}

TEST(World, BrokenFilesAreNamed) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(World(folder.path() / "none.xml"), InputError);
  WriteFileAtomically(folder.path() / "bad.xml",
                      "<mujoco><worldbody><geom type=\"mesh\"/></worldbody></mujoco>");
  const std::string error = InputErrorOf([&] { const World world(folder.path() / "bad.xml"); });
  EXPECT_THAT(error, ::testing::HasSubstr("bad.xml"));
}

TEST(MujocoErrors, BecomeExceptions) {
  InstallMujocoErrorHandlers();
  EXPECT_THROW(mju_error("as if %d things had gone wrong", 3), std::runtime_error);
}

}  // namespace
}  // namespace drydock::sim
