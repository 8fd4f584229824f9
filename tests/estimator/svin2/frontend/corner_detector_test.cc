#include "estimator/svin2/frontend/corner_detector.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

constexpr double kSquare = 40.0;

// A chequer board whose inner corners lie at offset + 40 px * (1, 1), (2, 1), ..., softened by the
// lens over about a pixel.
cv::Mat Chequer(const Eigen::Vector2d& offset, double noise) {
  return Draw(
      400, 320,
      [&offset](const Eigen::Vector2d& p) {
        const Eigen::Vector2d at = (p - offset) * std::numbers::pi / kSquare;
        return 128.0 +
               60.0 * std::tanh(12.0 * std::sin(at.x())) * std::tanh(12.0 * std::sin(at.y()));
      },
      noise);
}

// Distance to the nearest corner of the board.
double ChequerError(const Eigen::Vector2d& pixel, const Eigen::Vector2d& offset) {
  const Eigen::Vector2d at = (pixel - offset) / kSquare;
  return (at - Eigen::Vector2d(std::round(at.x()), std::round(at.y()))).norm() * kSquare;
}

// The board's own corners only, not the noise between them.
CornerDetector::Config StrongOnly() {
  CornerDetector::Config config;
  config.min_quality = 0.2;
  return config;
}

TEST(CornerDetector, FindsChequerCornersToATenthOfAPixel) {
  for (const Eigen::Vector2d& offset : {Eigen::Vector2d(0.3, 0.7), Eigen::Vector2d(10.5, 5.1)}) {
    const auto corners = CornerDetector(StrongOnly()).Detect(Chequer(offset, 1.0));
    // 400 / 40 by 320 / 40, less a row and a column at the border.
    EXPECT_GE(corners.size(), 63U);
    double squares = 0.0;
    for (const Corner& corner : corners) {
      const double error = ChequerError(corner.pixel, offset);
      squares += error * error;
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(corners.size())), 0.1);
  }
}

TEST(CornerDetector, FindsBlobsToATenthOfAPixel) {
  const Eigen::Vector2d offset(20.35, 19.8);
  // Gaussian blobs of 2.5 px every 40 px.
  const cv::Mat image = Draw(
      320, 240,
      [&offset](const Eigen::Vector2d& p) {
        const Eigen::Vector2d at = (p - offset) / kSquare;
        const Eigen::Vector2d nearest(std::round(at.x()), std::round(at.y()));
        const double distance2 = (at - nearest).squaredNorm() * kSquare * kSquare;
        return 60.0 + 150.0 * std::exp(-0.5 * distance2 / (2.5 * 2.5));
      },
      1.0);
  const auto corners = CornerDetector(StrongOnly()).Detect(image);
  EXPECT_EQ(corners.size(), 48U);  // 8 by 6.
  double squares = 0.0;
  for (const Corner& corner : corners) {
    const double error = ChequerError(corner.pixel, offset);
    squares += error * error;
  }
  EXPECT_LT(std::sqrt(squares / corners.size()), 0.1);
}

TEST(CornerDetector, SpreadsCornersWithinTheBudget) {
  const Texture texture(5);
  const cv::Mat image =
      Draw(640, 480, [&](const Eigen::Vector2d& p) { return 128.0 + 30.0 * texture(p); });
  CornerDetector::Config config;
  config.radius_px = 25.0;
  config.max_corners = 150;
  config.min_score = 1e-4;
  config.refine_radius_px = 0;
  const auto corners = CornerDetector(config).Detect(image);
  EXPECT_EQ(corners.size(), 150U);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i > 0) {
      EXPECT_LE(corners[i].score, corners[i - 1].score);
    }
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GE((corners[i].pixel - corners[j].pixel).norm(), 25.0);
    }
  }
}

TEST(CornerDetector, KeepsAwayFromOccupiedPlacesMasksAndBorders) {
  const Eigen::Vector2d offset(0.0, 0.0);
  const cv::Mat image = Chequer(offset, 0.0);
  const std::vector<Eigen::Vector2d> occupied = {{80.0, 80.0}, {200.0, 160.0}, {-50.0, 900.0}};
  cv::Mat mask(image.size(), CV_8UC1, cv::Scalar(255));
  mask(cv::Rect(250, 0, 150, 320)) = 0;
  const auto all = CornerDetector({}).Detect(image);
  const auto corners = CornerDetector({}).Detect(image, occupied, mask);
  ASSERT_FALSE(corners.empty());
  EXPECT_LT(corners.size(), all.size());
  for (const Corner& corner : corners) {
    for (const auto& taken : occupied) EXPECT_GT((corner.pixel - taken).norm(), 18.0);
    EXPECT_LT(corner.pixel.x(), 252.0);
    EXPECT_GT(corner.pixel.minCoeff(), 10.0);
  }
  // The occupied count towards the budget.
  CornerDetector::Config config;
  config.max_corners = 5;
  EXPECT_EQ(CornerDetector(config).Detect(image, occupied).size(), 2U);
  config.max_corners = 3;
  EXPECT_TRUE(CornerDetector(config).Detect(image, occupied).empty());
}

TEST(CornerDetector, FindsNothingInNoiseOrInTinyImages) {
  const cv::Mat noise = Draw(
      320, 240, [](const Eigen::Vector2d&) { return 100.0; }, 0.5);
  EXPECT_TRUE(CornerDetector({}).Detect(noise).empty());
  EXPECT_TRUE(CornerDetector({}).Detect(cv::Mat(8, 8, CV_8UC1, cv::Scalar(3))).empty());
}

TEST(CornerDetector, IsDeterministic) {
  const cv::Mat image = Chequer({0.0, 0.0}, 0.0);  // Many equal scores.
  const auto first = CornerDetector({}).Detect(image);
  const auto second = CornerDetector({}).Detect(image);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].pixel, second[i].pixel);
}

TEST(CornerDetector, RefusesBadConfigurations) {
  CornerDetector::Config config;
  config.window_sigma_px = 0.0;
  EXPECT_THROW(CornerDetector{config}, InputError);
  config = {};
  config.border_px = 0;
  EXPECT_THROW(CornerDetector{config}, InputError);
  config = {};
  config.max_corners = 0;
  EXPECT_THROW(CornerDetector{config}, InputError);
}

}  // namespace
}  // namespace drydock::svin2
