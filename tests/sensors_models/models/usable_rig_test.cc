#include "sensors_models/models/usable_rig.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

CameraIntrinsics Camera(double k1) {
  CameraIntrinsics camera{200, 200, 100.0, 100.0, 99.5, 99.5, {}};
  camera.distortion[0] = k1;
  return camera;
}

// x (1 + k x^2) with k < 0 rises up to x^2 = -1 / (3 k), where it is 2/3 of that x. The corners are
// 0.995 sqrt(2) = 1.407 from the centre: they have an inverse if that is below 2/3 sqrt(-1 / (3
// k)), that is for k > -0.0748.
TEST(UsableRig, FindsWhereTheDistortionFolds) {
  EXPECT_NO_THROW(RequireUsable(Camera(0.0), "here"));
  EXPECT_NO_THROW(RequireUsable(Camera(-0.073), "here"));
  const std::string error = InputErrorOf([&] { RequireUsable(Camera(-0.077), "here"); });
  EXPECT_THAT(error, ::testing::StartsWith("here: the distortion folds over"));
  EXPECT_THAT(error, ::testing::HasSubstr("pixel (0, 0)"));
}

CameraIntrinsics Fisheye(double k1) {
  CameraIntrinsics camera = Camera(k1);
  camera.lens = LensModel::kEquidistant;
  return camera;
}

// t (1 + k t^2) with k < 0 rises up to t = sqrt(-1 / (3 k)), to 2/3 of that. With twice the focal
// length the corners are at 0.7036: k > -0.2993.
TEST(UsableRig, FindsWhereAFisheyeFolds) {
  CameraIntrinsics camera = Fisheye(-0.295);
  camera.fx = camera.fy = 200.0;
  EXPECT_NO_THROW(RequireUsable(camera, "here"));
  camera.distortion[0] = -0.304;
  const std::string error = InputErrorOf([&] { RequireUsable(camera, "here"); });
  EXPECT_THAT(error, ::testing::StartsWith("here: the distortion folds over"));
}

// Of a full fisheye the border looks back: that is no fold. But something must look ahead.
TEST(UsableRig, AFisheyesBorderMayLookBack) {
  CameraIntrinsics camera = Fisheye(0.0);
  camera.fx = camera.fy = 50.0;  // 114 degrees to the sides.
  EXPECT_NO_THROW(RequireUsable(camera, "here"));
  camera.cx = 199.0;  // The middle of the image looks 114 degrees aside.
  const std::string error = InputErrorOf([&] { RequireUsable(camera, "here"); });
  EXPECT_THAT(error, ::testing::HasSubstr("here: the middle of the image looks"));
}

TEST(UsableRig, NamesTheLensThatFolds) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  const auto left = text.find("radtan:");
  text.replace(left, text.find('\n', left) - left, "equidistant: [-1.5, 0, 0, 0]");
  const auto file = std::filesystem::path(::testing::TempDir()) / "drydock_usable_fisheye.yaml";
  WriteFileAtomically(file, text);
  const std::string error = InputErrorOf([&] { LoadUsableRig(file); });
  EXPECT_THAT(error, ::testing::HasSubstr("stereo.cameras.0.equidistant: the distortion"));
  std::filesystem::remove(file);
}

TEST(UsableRig, NamesFileAndLine) {
  EXPECT_NO_THROW(LoadUsableRig(FindRig("svin2_v3")));
  std::string text = ReadFile(FindRig("svin2_v3"));
  const auto right = text.rfind("radtan:");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(right), '\n');
  text.replace(right, text.find('\n', right) - right, "radtan: [-1.5, 0, 0, 0]");
  const auto file = std::filesystem::path(::testing::TempDir()) / "drydock_usable_rig.yaml";
  WriteFileAtomically(file, text);
  const std::string error = InputErrorOf([&] { LoadUsableRig(file); });
  EXPECT_THAT(error, ::testing::HasSubstr(
                         fmt::format("drydock_usable_rig.yaml:{}: stereo.cameras.1.radtan", line)));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace drydock
