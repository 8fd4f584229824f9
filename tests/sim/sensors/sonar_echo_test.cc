// The echo of simple shapes, against what the geometry of the cone says.
#include "sim/sensors/sonar_echo.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/models/sonar_model.h"
#include "tests/sim/sensors/sonar_support.h"

namespace drydock::sim {
namespace {

TEST(EchoEnergy, FollowsLambertAndAbsorption) {
  SonarSheet sheet = PlainEchoSheet();
  EXPECT_DOUBLE_EQ(EchoEnergy(sheet, 3.0, 1.0), 1.0);
  // cos^2 from each unit of area, of which there is 1/cos as much.
  EXPECT_NEAR(EchoEnergy(sheet, 3.0, 0.5), 0.5, 1e-12);
  sheet.incidence_exponent = 3.0;
  EXPECT_NEAR(EchoEnergy(sheet, 3.0, 0.5), 0.25, 1e-12);
  // There and back 2 x 3 m at 1.3 - 0.3 dB/m: 6 dB.
  sheet.absorption_db_m = 1.3;
  sheet.gain_absorption_db_m = 0.3;
  EXPECT_NEAR(EchoEnergy(sheet, 3.0, 1.0), std::pow(10.0, -0.6), 1e-12);
}

TEST(ReceiverNoiseEnergy, GrowsWithTheGain) {
  SonarSheet sheet = PlainEchoSheet();
  sheet.noise_floor = 0.1;
  EXPECT_NEAR(ReceiverNoiseEnergy(sheet, 6.0), 0.01, 1e-12);
  EXPECT_NEAR(ReceiverNoiseEnergy(sheet, 3.0), 0.0025, 1e-12);
  sheet.gain_absorption_db_m = 0.5;  // 2 x 3 m at 0.5 dB/m less: 3 dB.
  EXPECT_NEAR(ReceiverNoiseEnergy(sheet, 3.0), 0.0025 * std::pow(10.0, -0.3), 1e-12);
}

/// The profile of a single ray of full weight.
EchoProfile OneRay(const SonarSheet& sheet, float range, double range_error = 0.0) {
  return MakeEchoProfile(sheet, {{range, 1.0F, 0}}, Eigen::VectorXd::Ones(1), range_error);
}

TEST(EchoProfile, AnEchoLiesInItsBin) {
  const EchoProfile profile = OneRay(PlainEchoSheet(), 2.01F);
  EXPECT_EQ(profile.energies[85], 1.0);  // 2.000 to 2.0235 m.
  EXPECT_NEAR(profile.ranges[85], 2.01, 1e-6);
  EXPECT_NEAR(profile.ranges[84], 84.5 * kBinLength, 1e-12) << "empty: the middle";
  EXPECT_EQ(Sum(profile.energies), 1.0);
  EXPECT_EQ(OneRay(PlainEchoSheet(), 2.01F, 0.02).energies[86], 1.0);
}

// 100 us at 1480 m/s are 74 mm there and back: a triangle over 2.01 +- 0.074 m. The bin from 2 m to
// 2.0235 m lies between -0.1351 and +0.1828 of the half width; below them are (1 - 0.1351)^2 / 2
// and 1 - (1 - 0.1828)^2 / 2 of the triangle, so 0.2921 of it is in the bin.
TEST(EchoProfile, ThePulseSpreadsIt) {
  SonarSheet sheet = PlainEchoSheet();
  sheet.pulse_length_s = 1e-4;
  const EchoProfile profile = OneRay(sheet, 2.01F);
  EXPECT_NEAR(profile.energies[85], 0.2921, 1e-3);
  EXPECT_NEAR(Sum(profile.energies), 1.0, 1e-12);
  EXPECT_GT(profile.energies[82], 0.0);  // 1.929 to 1.953 m: the pulse begins at 1.936 m.
  EXPECT_EQ(profile.energies[81], 0.0);
  EXPECT_GT(profile.energies[88], 0.0);  // 2.071 to 2.094 m: it ends at 2.084 m.
  EXPECT_EQ(profile.energies[89], 0.0);
}

TEST(EchoProfile, NothingIsHeardOutsideTheReach) {
  // Bin 4 runs from 0.094 to 0.118 m, bin 5 to 0.141 m with its middle at 0.129 m.
  EXPECT_EQ(Sum(OneRay(PlainEchoSheet(), 0.11F).energies), 0.0);
  EXPECT_EQ(Sum(OneRay(PlainEchoSheet(), 0.13F).energies), 1.0);
  EXPECT_EQ(Sum(OneRay(PlainEchoSheet(), 5.99F, 0.02).energies), 0.0);
  EXPECT_EQ(Sum(OneRay(PlainEchoSheet(), 0.13F, -0.2).energies), 0.0);
}

TEST(SonarShapes, PlaneMetSquarely) {
  const SonarBench bench(WallAt(2.01));
  const SonarPing exact = bench.Ping(PlainEchoSheet(), Unrounded());
  // The cone's rim is at 2.01 / cos(1.4 deg) = 2.0106 m: all of it in one bin.
  EXPECT_NEAR(exact.range, 2.0101, 2e-4);
  EXPECT_NEAR(exact.intensity, 1.0, 1e-3);
  const SonarPing ping = bench.Ping(PlainEchoSheet());
  EXPECT_NEAR(ping.range, 2.01, 0.5 * kBinLength);
  EXPECT_DOUBLE_EQ(ping.range, SonarBinCentre(PlainEchoSheet(), 85));
  EXPECT_EQ(ping.first_range, ping.range);
  EXPECT_EQ(ping.intensity, 1.0);
  EXPECT_TRUE(ping.profile.empty());
}

// On a plane at an incidence of phi, the range grows by r tan(phi) a radian across the axis: the
// pattern's Gaussian becomes one over ranges, of standard deviation r tan(phi) s, and ends at
// r tan(phi) w on both sides. Its energy is cos(phi).
class ObliquePlane : public ::testing::TestWithParam<double> {};

TEST_P(ObliquePlane, SpreadsTheConeOverTheBins) {
  const double phi = GetParam() * std::numbers::pi / 180.0;
  const double range = 3.0;
  const SonarBench bench(WallAt(range * std::cos(phi)));
  const SonarPing ping = bench.Ping(PlainEchoSheet(), Unrounded(), phi);

  const double sigma = range * std::tan(phi) * BeamSigma();
  const double reach = range * std::tan(phi) * PlainEchoSheet().beam_width_rad;
  const std::vector<double> energies = Energies(ping);
  EXPECT_NEAR(Sum(energies), std::cos(phi), 0.02);
  double strongest = 0.0;
  for (std::size_t bin = 0; bin < energies.size(); ++bin) {
    const double low = static_cast<double>(bin) * kBinLength - range, high = low + kBinLength;
    const double share = NormalBelow(high / sigma) - NormalBelow(low / sigma);
    EXPECT_NEAR(energies[bin], std::cos(phi) * share, 0.02) << bin;
    strongest = std::max(strongest, share);
    // Second order in the angle moves the far rim outwards by 5.2 % of the reach at 60 degrees.
    if (low > 1.06 * reach || high < -reach) {
      EXPECT_EQ(energies[bin], 0.0) << bin;
    }
  }
  EXPECT_NEAR(ping.intensity, std::sqrt(std::cos(phi) * strongest), 0.02);
  EXPECT_NEAR(ping.range, range, kBinLength);
  EXPECT_LT(ping.first_range, range);
  EXPECT_GT(ping.first_range, range - reach - 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Degrees, ObliquePlane, ::testing::Values(30.0, 45.0, 60.0));

// Without the footprint it is the axis alone.
TEST(SonarShapes, WithoutFootprintAPlaneIsAPoint) {
  const double phi = std::numbers::pi / 3.0;
  const SonarBench bench(WallAt(1.0));
  SonarEffects effects = Unrounded();
  effects.footprint = false;
  const SonarPing ping = bench.Ping(PlainEchoSheet(), effects, phi);
  EXPECT_NEAR(ping.range, 2.0, 1e-5);
  EXPECT_NEAR(ping.intensity, std::sqrt(0.5), 1e-5);
  EXPECT_EQ(ping.first_range, ping.range);
  EXPECT_EQ(std::count(ping.profile.begin(), ping.profile.end(), 0), 254);
}

// A ball of radius R at the distance D, with the beam on its centre: a ray at the angle t meets it
// at D cos t - sqrt(R^2 - D^2 sin^2 t), with the sine of incidence D sin t / R. The energy is the
// integral of cos(incidence) over the pattern, exp(-t^2 / 2 s^2) / s^2 t dt.
TEST(SonarShapes, Ball) {
  constexpr double kRadius = 0.1, kDistance = 2.0;
  const SonarBench bench(testing::MeshElement("ball", {kDistance, 0.0, 0.0}),
                         testing::BallMesh("ball", kRadius));
  const SonarPing ping = bench.Ping(PlainEchoSheet(), Unrounded());
  std::vector<double> expected(255, 0.0);
  const double s2 = BeamSigma() * BeamSigma(), width = PlainEchoSheet().beam_width_rad;
  const double step = width / 10'000.0;
  for (double t = 0.5 * step; t < width; t += step) {
    const double sine = kDistance * std::sin(t) / kRadius;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double range = kDistance * std::cos(t) - kRadius * cosine;
    // The pattern is cut off at w, where 1 - 2^-8 of it are cast.
    expected[static_cast<std::size_t>(range / kBinLength)] +=
        cosine * std::exp(-0.5 * t * t / s2) / s2 * t * step / (1.0 - std::exp2(-8.0));
  }
  const std::vector<double> energies = Energies(ping);
  for (std::size_t bin = 0; bin < 255; ++bin) EXPECT_NEAR(energies[bin], expected[bin], 0.012);
  EXPECT_NEAR(ping.range, kDistance - kRadius, 0.5 * kBinLength);
  EXPECT_NEAR(ping.intensity, std::sqrt(*std::max_element(expected.begin(), expected.end())), 0.01);
}

// A ball much smaller than the beam gives what the beam's middle has: of the pattern
// exp(-t^2 / 2 s^2) / 2 pi s^2, over a solid angle of pi (R / D)^2, with a mean cosine of 2/3.
TEST(SonarShapes, SmallBallIsWeakerThanAWall) {
  constexpr double kRadius = 0.006, kDistance = 2.0;
  const SonarBench bench(testing::MeshElement("ball", {kDistance, 0.0, 0.0}),
                         testing::BallMesh("ball", kRadius));
  const double share = std::pow(kRadius / kDistance / BeamSigma(), 2) / 2.0 * 2.0 / 3.0;
  const SonarPing ping = bench.Ping(PlainEchoSheet(), Unrounded());
  EXPECT_NEAR(ping.intensity * ping.intensity, share, 0.2 * share);
}

// The axis passes the middle of an upright drum of radius R at half of R: incidence 30 degrees, at
// the range D - R cos(30). Across, the range spreads by r tan(30) s = 8.8 mm.
TEST(SonarShapes, DrumMetOffItsMiddle) {
  constexpr double kRadius = 0.5, kDistance = 2.5;
  const SonarBench bench(testing::MeshElement("drum", {kDistance, 0.5 * kRadius, 0.0}),
                         testing::DrumMesh("drum", kRadius, 1.0));
  const SonarPing ping = bench.Ping(PlainEchoSheet(), Unrounded());
  const double range = kDistance - kRadius * std::cos(std::numbers::pi / 6.0);
  const double sigma = range * std::tan(std::numbers::pi / 6.0) * BeamSigma();
  EXPECT_NEAR(Sum(Energies(ping)), std::cos(std::numbers::pi / 6.0), 0.01);
  EXPECT_NEAR(ping.range, range, sigma);
  const SonarPing rounded = bench.Ping(PlainEchoSheet());
  EXPECT_NEAR(rounded.range, range, kBinLength);
}

/// A near plate that holds the half space y > `edge` at x = 2.01, and a wall at x = 3.01.
std::string PlateBeforeWall(double edge) {
  return testing::BoxElement("plate", {2.02, edge + 1.0, 0.0}, {0.01, 1.0, 1.0}) + WallAt(3.01);
}

// The share of the beam on the plate is the tail of the pattern beyond its edge.
TEST(SonarShapes, AnEdgeGivesTwoEchoes) {
  for (const double sigmas : {-0.5, 0.0, 0.5, 1.0}) {
    const SonarBench bench(PlateBeforeWall(2.01 * BeamSigma() * sigmas));
    const SonarPing ping = bench.Ping(PlainEchoSheet(), Unrounded());
    const std::vector<double> energies = Energies(ping);
    const double on_plate = NormalBelow(-sigmas);
    EXPECT_NEAR(energies[85], on_plate, 0.015);         // 2.000 to 2.0235 m
    EXPECT_NEAR(energies[127], 1.0 - on_plate, 0.015);  // 2.988 to 3.012 m
    EXPECT_NEAR(Sum(energies), 1.0, 0.005);
  }
}

TEST(SonarShapes, FirstIsNotAlwaysStrongest) {
  // 31 % on the plate: the wall is stronger, the plate is nearer.
  const SonarBench less(PlateBeforeWall(2.01 * BeamSigma() * 0.5));
  const SonarPing ping = less.Ping(PlainEchoSheet());
  EXPECT_NEAR(ping.range, 3.01, kBinLength);
  EXPECT_NEAR(ping.first_range, 2.01, 0.5 * kBinLength);
  EXPECT_NEAR(ping.intensity, std::sqrt(0.69), 0.01);
  // A floor above the plate's sqrt(0.31) leaves the wall alone.
  SonarSheet deaf = PlainEchoSheet();
  deaf.intensity_floor = 0.6;
  EXPECT_EQ(less.Ping(deaf).first_range, less.Ping(deaf).range);
  // 69 % on the plate.
  const SonarBench more(PlateBeforeWall(-2.01 * BeamSigma() * 0.5));
  EXPECT_NEAR(more.Ping(PlainEchoSheet()).range, 2.01, 0.5 * kBinLength);
  // Over the metre between them absorption takes 2.6 dB: 10^-0.26 of 69 % still beats 31 %, but not
  // of 60 % 40 %.
  SonarSheet absorbing = PlainEchoSheet();
  absorbing.absorption_db_m = 1.3;
  EXPECT_NEAR(less.Ping(absorbing).range, 3.01, kBinLength);
  const SonarBench most_on_wall(PlateBeforeWall(2.01 * BeamSigma() * 0.2533));
  EXPECT_NEAR(most_on_wall.Ping(PlainEchoSheet()).range, 3.01, kBinLength);
  EXPECT_NEAR(most_on_wall.Ping(absorbing).range, 2.01, 0.5 * kBinLength);
}

// Of two like walls 3 m apart, 2 x 3 m at 1.3 - 0.1 dB/m take 7.2 dB.
TEST(SonarShapes, AbsorptionBetweenTwoRanges) {
  SonarSheet sheet = PlainEchoSheet();
  sheet.absorption_db_m = 1.3;
  sheet.gain_absorption_db_m = 0.1;
  const double near = SonarBench(WallAt(1.515)).Ping(sheet, Unrounded()).intensity;
  const double far = SonarBench(WallAt(4.515)).Ping(sheet, Unrounded()).intensity;
  EXPECT_NEAR(far / near, std::pow(10.0, -7.2 / 20.0), 1e-3);
  SonarEffects clear = Unrounded();
  clear.absorption = false;
  EXPECT_NEAR(SonarBench(WallAt(4.515)).Ping(sheet, clear).intensity, 1.0, 1e-3);
}

TEST(SonarShapes, WhatIsOutOfReachGivesNothing) {
  const SonarBench far(WallAt(6.1));
  EXPECT_EQ(far.Ping(PlainEchoSheet()).range, 0.0);
  EXPECT_EQ(far.Ping(PlainEchoSheet()).intensity, 0.0);
  EXPECT_EQ(far.Ping(PlainEchoSheet()).first_range, 0.0);
  // A face nearer than the minimum is not heard, and hides what is behind it.
  const SonarBench near(WallAt(0.1) + testing::BoxElement("other", {3.0, 0, 0}, {0.1, 2.0, 2.0}));
  EXPECT_EQ(near.Ping(PlainEchoSheet()).range, 0.0);
}

}  // namespace
}  // namespace drydock::sim
