// Cards seen through renderer and water: what the laws say of light must come out of the pixels.
#include <cmath>

#include <gtest/gtest.h>

#include "sim/optics/underwater_optics.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

constexpr double kVisibility = 12.0;
const Pinhole kPinhole{400, 300, 400.0, 199.5, 149.5};

/// A grey and a black card, side by side, 1 cm thick, that face a camera at the origin at each of
/// these ranges, each pair in a direction of its own.
const std::vector<double> kRanges = {1.0, 2.0, 4.0, 8.0, kVisibility};

Eigen::Quaterniond Direction(std::size_t pair) {
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(static_cast<double>(pair) * 1.2, Eigen::Vector3d::UnitZ()));
}

std::string Cards() {
  std::string elements;
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double half = 0.12 * kRanges[i];
      const Eigen::Vector3d at =
          Direction(i) * Eigen::Vector3d(kRanges[i] + 0.005, side * half, 0.0);
      const double grey = side < 0 ? 0.5 : 0.0;
      elements += "<geom type='box' pos='" + std::to_string(at.x()) + " " + std::to_string(at.y()) +
                  " 0' euler='0 0 " + std::to_string(static_cast<double>(i) * 1.2 * 180.0 / M_PI) +
                  "' size='0.005 " + std::to_string(half) + " " + std::to_string(half) +
                  "' rgba='" + std::to_string(grey) + " " + std::to_string(grey) + " " +
                  std::to_string(grey) + " 1'/>";
    }
  }
  return elements;
}

class GreyCard : public ::testing::Test {
 protected:
  struct Seen {
    cv::Vec3f grey, black, water;
  };
  Seen Look(std::size_t pair) {
    const Pose T_WC(Direction(pair) * Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0, 0, 0});
    RawImage raw;
    renderer_.Render(T_WC, kPinhole, raw);
    cv::Mat radiance;
    optics_.Apply(raw, T_WC, ImageChannels::kColor, radiance);
    // Right of the middle lies -y, the grey card. Rows are level.
    return {radiance.at<cv::Vec3f>(150, 224), radiance.at<cv::Vec3f>(150, 175),
            radiance.at<cv::Vec3f>(150, 380)};
  }
  /// Length of the way to what Look compares, against the card's distance.
  static double Slant() { return std::hypot(1.0, 24.5 / kPinhole.focal); }

  testing::TemporaryFolder folder_;
  World world_{testing::WriteScene(folder_.path(), Cards())};
  Renderer renderer_{world_, RendererBackend::kAuto, kPinhole.width, kPinhole.height};
  WaterConfig water_ = [] {
    WaterConfig water;
    water.visibility_m = kVisibility;
    return water;
  }();
  UnderwaterOptics optics_{water_, kPinhole, nullptr};
};

// Grey minus black cancels the veil. The cards get the same light, less what their different
// bearing to the sun makes of it: so each pair is compared with itself in clear water.
TEST_F(GreyCard, FollowsBeerLambert) {
  WaterConfig clear = water_;
  clear.visibility_m = 0.0;
  clear.surface_z_m = 0.0;
  water_.surface_z_m = 0.0;
  optics_ = UnderwaterOptics(water_, kPinhole, nullptr);
  std::vector<cv::Vec3f> through_water;
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    const Seen seen = Look(i);
    through_water.push_back(seen.grey - seen.black);
  }
  optics_ = UnderwaterOptics(clear, kPinhole, nullptr);
  for (std::size_t i = 0; i < 4; ++i) {
    const Seen seen = Look(i);
    const cv::Vec3f bare = seen.grey - seen.black;
    for (int channel = 0; channel < 3; ++channel) {
      const double c = BeamAttenuation(water_)[channel];
      const double expected = std::exp(-c * kRanges[i] * Slant());
      EXPECT_NEAR(through_water[i][channel] / bare[channel] / expected, 1.0, 0.02)
          << kRanges[i] << " m, channel " << channel;
    }
  }
}

// The visibility that a diver would measure: where black against water has 2 % of contrast left.
TEST_F(GreyCard, MeasuredVisibilityIsWhatWasAskedFor) {
  std::vector<double> contrast;
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    const Seen seen = Look(i);
    contrast.push_back((seen.water[1] - seen.black[1]) / seen.water[1]);
  }
  EXPECT_NEAR(contrast.back(), 0.02, 0.004);
  // From the decay between 2 m and 8 m.
  const double c = std::log(contrast[1] / contrast[3]) / ((kRanges[3] - kRanges[1]) * Slant());
  EXPECT_NEAR(-std::log(0.02) / c / kVisibility, 1.0, 0.05);
}

}  // namespace
}  // namespace drydock::sim
