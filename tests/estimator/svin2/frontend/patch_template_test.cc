#include "estimator/svin2/frontend/patch_template.h"

#include <Eigen/LU>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

const Eigen::Vector2d kPixel(80.3, 70.6);

// The texture about kPixel, deformed, with that point at `to`.
cv::Mat Deformed(const Eigen::Matrix2d& warp, const Eigen::Vector2d& to, double contrast = 1.0) {
  const Texture texture(5);
  const Eigen::Matrix2d back = warp.inverse();
  return Draw(160, 140, [&](const Eigen::Vector2d& p) {
    return 120.0 + contrast * 30.0 * texture(kPixel + back * (p - to));
  });
}

TEST(PatchTemplate, FindsShiftDeformationAndLikeness) {
  Eigen::Matrix2d warp;
  warp << 1.12, -0.08, 0.10, 0.93;
  const Eigen::Vector2d to(83.1, 69.2);
  const auto patch = PatchTemplate::Make(Deformed(Eigen::Matrix2d::Identity(), kPixel), kPixel, 10);
  ASSERT_TRUE(patch.has_value());
  const auto found = patch->Align(Deformed(warp, to, 0.7), to + Eigen::Vector2d(1.2, -0.8),
                                  Eigen::Matrix2d::Identity(), true);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT((found->pixel - to).norm(), 0.05);
  EXPECT_LT((found->warp - warp).norm(), 0.02);
  EXPECT_GT(found->correlation, 0.995);
  EXPECT_LE(found->correlation, 1.0 + 1e-6);
}

TEST(PatchTemplate, KeepsTheWarpWhereItOnlyShifts) {
  Eigen::Matrix2d warp;
  warp << 1.2, 0.0, 0.0, 1.2;
  const Eigen::Vector2d to(80.0, 71.0);
  const auto patch = PatchTemplate::Make(Deformed(Eigen::Matrix2d::Identity(), kPixel), kPixel, 10);
  const auto found = patch->Align(Deformed(warp, to), to + Eigen::Vector2d(0.5, 0.5), warp, false);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->warp, warp);
  EXPECT_LT((found->pixel - to).norm(), 0.05);
}

TEST(PatchTemplate, NeedsTextureAndRoom) {
  const cv::Mat blank(140, 160, CV_8UC1, cv::Scalar(90));
  EXPECT_FALSE(PatchTemplate::Make(blank, kPixel, 8).has_value());
  // An edge can slide along itself.
  const cv::Mat edge =
      Draw(160, 140, [](const Eigen::Vector2d& p) { return p.x() < 80.0 ? 50.0 : 200.0; });
  EXPECT_FALSE(PatchTemplate::Make(edge, {80.0, 70.0}, 8).has_value());
  const cv::Mat image = Deformed(Eigen::Matrix2d::Identity(), kPixel);
  EXPECT_FALSE(PatchTemplate::Make(image, {8.5, 70.0}, 8).has_value());
  const auto patch = PatchTemplate::Make(image, kPixel, 8);
  ASSERT_TRUE(patch.has_value());
  const Eigen::Matrix2d same = Eigen::Matrix2d::Identity();
  EXPECT_FALSE(patch->Align(image, {7.0, 70.0}, same, true).has_value());
  EXPECT_FALSE(patch->Align(image, {std::nan(""), 70.0}, same, true).has_value());
  EXPECT_FALSE(patch->Align(blank, kPixel, same, true).has_value());
}

}  // namespace
}  // namespace drydock::svin2
