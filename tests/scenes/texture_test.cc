#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "scenes/texture/canvas.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/noise_field.h"
#include "scenes/texture/stamps.h"
#include "scenes/texture/weathering.h"
#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock::scenes {
namespace {

using drydock::testing::InputErrorOf;

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(NoiseField, IsAboutStandardNormal) {
  for (const double gain : {0.5, 0.8}) {
    const cv::Mat1f field = NoiseField({1024, 1024}, {32, 4, gain, 1.0, false}, 3);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(field, mean, deviation);
    EXPECT_NEAR(mean[0], 0.0, 0.1);
    EXPECT_NEAR(deviation[0], 1.0, 0.12);
  }
}

TEST(NoiseField, IsTheSameAtAnyNumberOfThreads) {
  const NoiseShape shape{40, 3, 0.6, 2.0, false};
  const cv::Mat1f parallel = NoiseField({300, 200}, shape, 9);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const cv::Mat1f serial = NoiseField({300, 200}, shape, 9);
  cv::setNumThreads(threads);
  EXPECT_TRUE(SameBytes(parallel, serial));
  EXPECT_FALSE(SameBytes(parallel, NoiseField({300, 200}, shape, 10)));
}

TEST(NoiseField, WrapsWithoutASeam) {
  const cv::Mat1f field = NoiseField({256, 256}, {64, 16, 0.6, 1.0, true}, 4);
  double inside = 0.0;
  double across = 0.0;
  for (int i = 0; i < 256; ++i) {
    inside = std::max<double>(inside, std::abs(field(i, 100) - field(i, 101)));
    across = std::max<double>(across, std::abs(field(i, 255) - field(i, 0)));
    across = std::max<double>(across, std::abs(field(255, i) - field(0, i)));
  }
  EXPECT_LT(across, 2.0 * inside);
}

TEST(NoiseField, CoverageIsTheFractionAskedFor) {
  const cv::Mat1f field = NoiseField({1024, 1024}, {24, 3, 0.6, 1.0, false}, 8);
  for (const double fraction : {0.05, 0.2, 0.5}) {
    const cv::Mat1b mask = Coverage(field, fraction, 0.02);
    EXPECT_NEAR(cv::mean(mask)[0] / 255.0, fraction, 0.03);
  }
}

TEST(Canvas, BlendReachesTheColour) {
  Canvas canvas(0.1, 0.1, 200, Rgb(10, 20, 30));
  const cv::Mat1b everywhere(canvas.size(), std::uint8_t{255});
  canvas.Blend(everywhere, Rgb(200, 100, 50));
  EXPECT_EQ(canvas.image()(5, 5), Rgb(200, 100, 50));
  canvas.Blend(canvas.Mask(), Rgb(0, 0, 0));
  EXPECT_EQ(canvas.image()(5, 5), Rgb(200, 100, 50));
}

TEST(Canvas, TextLeavesItsMarkWhereItShould) {
  Canvas canvas(1.0, 0.5, 200, Rgb(255, 255, 255));
  DrawText(canvas, "BUS", 0.5, 0.25, 0.2, 0.2, Rgb(0, 0, 0));
  const cv::Rect middle(50, 30, 100, 40);
  EXPECT_LT(cv::mean(canvas.image()(middle))[0], 200.0);
  EXPECT_EQ(cv::mean(canvas.image().rowRange(0, 10))[0], 255.0);
}

/// Mean absolute gradient of an image shrunk by `factor`: the contrast that is left at that scale.
double ContrastAt(const cv::Mat3b& image, int factor) {
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_RGB2GRAY);
  cv::Mat1b small;
  cv::resize(grey, small, {grey.cols / factor, grey.rows / factor}, 0, 0, cv::INTER_AREA);
  cv::Mat1f x;
  cv::Mat1f y;
  cv::Sobel(small, x, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(small, y, CV_32F, 0, 1, 3, 0.125);
  return cv::mean(cv::abs(x) + cv::abs(y))[0];
}

TEST(Weathering, HasContrastAtEveryScale) {
  Canvas canvas(2.0, 1.0, 500, Rgb(206, 153, 42));
  Age(canvas, Weathering(), cv::Mat1b(), NoiseKeys(1, "test"));
  for (const int factor : {1, 2, 4, 8, 16, 32}) {  // 2 mm ... 64 mm a pixel
    EXPECT_GT(ContrastAt(canvas.image(), factor), 2.5) << "at 1/" << factor;
  }
}

TEST(Weathering, IsDeterministic) {
  const auto paint = [](std::uint64_t seed) {
    Canvas canvas(0.5, 0.5, 400, Rgb(206, 153, 42));
    Age(canvas, Weathering(), cv::Mat1b(), NoiseKeys(seed, "test"));
    return canvas.image();
  };
  EXPECT_TRUE(SameBytes(paint(1), paint(1)));
  EXPECT_FALSE(SameBytes(paint(1), paint(2)));
}

TEST(WritePng, ErrorNamesTheFile) {
  const std::string error = InputErrorOf([&] { WritePng(cv::Mat3b(2, 2), "/nowhere/at/all.png"); });
  EXPECT_NE(error.find("all.png"), std::string::npos);
}

// What sticks out at one side comes in at the other, and looks the same there.
TEST(Strew, ThingsWrapRound) {
  Canvas canvas(1.0, 1.0, 100, Rgb(0, 0, 0), true);
  RandomStream random(3, "test");
  Strew(canvas, 200, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    const auto tone = static_cast<std::uint8_t>(100.0 + 155.0 * look.Uniform());
    FillRectangle(c, {x - 0.03, y - 0.03}, {x + 0.03 * size, y + 0.03}, Rgb(tone, tone, tone));
  });
  // Of squares 3 cm wide many lie across the rim; their halves have the same tone.
  int across = 0;
  int same = 0;
  for (int i = 0; i < 100; ++i) {
    const Rgb left = canvas.image()(i, 0);
    if (left[0] == 0) continue;
    ++across;
    same += canvas.image()(i, 99) == left ? 1 : 0;
  }
  EXPECT_GT(across, 10);
  EXPECT_GT(same, 0.6 * across);
}

TEST(PaintStone, IsOfItsColors) {
  const NoiseKeys keys(4, "stone");
  Canvas pale(0.6, 0.6, 200, Rgb(0, 0, 0));
  Canvas dark(0.6, 0.6, 200, Rgb(0, 0, 0));
  PaintStone(pale, keys);
  const Rgb black(10, 12, 14);
  PaintStone(dark, keys, {black, black, black, black, black, black});
  EXPECT_GT(cv::mean(pale.image())[0], 90.0);
  EXPECT_TRUE(SameBytes(dark.image(), cv::Mat3b(dark.size(), black)));
}

}  // namespace
}  // namespace drydock::scenes
