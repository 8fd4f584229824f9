#include "scenarios/report/trajectory_plot.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/report/canvas.h"

namespace drydock::report {
namespace {

Trajectory Circle(double radius) {
  Trajectory trajectory;
  for (int i = 0; i <= 200; ++i) {
    const double a = 0.0314 * i;
    trajectory.push_back({Time::FromSeconds(0.1 * i),
                          Pose(Eigen::Quaterniond::Identity(),
                               {radius * std::cos(a), radius * std::sin(a), -3.0 + 0.01 * i})});
  }
  return trajectory;
}

/// How many pixels have nearly this colour.
int Count(const cv::Mat& image, const Color& color) {
  int count = 0;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const auto& pixel = image.at<cv::Vec3b>(y, x);
      double distance = 0.0;
      for (int c = 0; c < 3; ++c) distance += std::abs(pixel[c] - color[c]);
      if (distance < 12.0) ++count;
    }
  }
  return count;
}

TEST(DrawTrajectories, ShowsTruthAndEveryEstimate) {
  const cv::Mat image =
      DrawTrajectories("dive", Circle(4.0), {{"one", Circle(4.2)}, {"two", Circle(3.8)}});
  EXPECT_EQ(image.type(), CV_8UC3);
  EXPECT_EQ(image.cols, 1200);
  EXPECT_GT(Count(image, PaletteColor(0)), 500);
  EXPECT_GT(Count(image, PaletteColor(1)), 500);
  EXPECT_LT(Count(image, PaletteColor(2)), 20);
}

TEST(DrawTrajectories, WithoutEstimateThereIsNoErrorPanel) {
  EXPECT_LT(DrawTrajectories("dive", Circle(4.0), {}).rows,
            DrawTrajectories("dive", Circle(4.0), {{"one", Circle(4.2)}}).rows);
}

TEST(DrawTrajectories, IsTheSamePictureEveryTime) {
  const auto draw = [] {
    return EncodePng(DrawTrajectories("dive", Circle(4.0), {{"one", Circle(4.2)}}));
  };
  EXPECT_EQ(draw(), draw());
}

TEST(DrawTrajectories, CopesWithNothingOnePointAndLongNames) {
  EXPECT_GT(DrawTrajectories("", {}, {}).rows, 0);
  EXPECT_GT(DrawTrajectories("no truth", {}, {{"estimate", Circle(1.0)}}).rows, 0);
  EXPECT_GT(DrawTrajectories("no estimate", Circle(1.0), {{"estimate", {}}}).rows, 0);
  EXPECT_GT(DrawTrajectories("point", {Circle(1.0).front()}, {{"p", {Circle(1.0).front()}}}).rows,
            0);
  const std::string long_name(500, 'w');
  std::vector<NamedTrajectory> many(12, {long_name, Circle(2.0)});
  EXPECT_EQ(DrawTrajectories(long_name, Circle(1.0), many).cols, 1200);
}

TEST(WritePng, WritesAPictureThatReadsBack) {
  const auto path = std::filesystem::path(testing::TempDir()) / "drydock_plot/plot.png";
  const cv::Mat image = DrawTrajectories("dive", Circle(4.0), {});
  WritePng(path, image);
  EXPECT_EQ(cv::norm(cv::imread(path.string(), cv::IMREAD_UNCHANGED), image), 0.0);
  std::filesystem::remove_all(path.parent_path());
}

}  // namespace
}  // namespace drydock::report
