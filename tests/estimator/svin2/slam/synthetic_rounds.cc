#include "tests/estimator/svin2/slam/synthetic_rounds.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/vocabulary/train_vocabulary.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/synthetic_stereo.h"
#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"

namespace drydock::svin2::testing {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kStepSigma = 0.004, kTurnSigma = 0.0012;  // Of odometry, a keyframe [m, rad].
constexpr double kPixelSigma = 0.15;
constexpr int kLandmarks = 900;
constexpr int kChangedBits = 30;  // Of a descriptor from one view to another.

struct Landmark {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  Descriptor descriptor = {};
};

Eigen::Vector3d OnTheRing(double angle, RandomStream& random) {
  const double radius = random.Uniform(6.0, 7.5);
  const double height = random.Uniform(-1.2, 1.2);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

std::vector<Landmark> MakeRing(RandomStream& random) {
  std::vector<Landmark> ring(kLandmarks);
  for (Landmark& landmark : ring) {
    const double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
    landmark = {OnTheRing(angle, random), RandomDescriptor(random)};
  }
  return ring;
}

/// Somewhat elsewhere in the same view, so that looks stay as they are.
Eigen::Vector3d Shuffled(const Eigen::Vector3d& p_W, RandomStream& random) {
  const double angle = std::atan2(p_W.y(), p_W.x());
  return OnTheRing(angle + random.Uniform(-0.15, 0.15), random);
}

/// No round is quite like the other.
Pose OnTheWay(double round) {
  const double angle = 2.0 * std::numbers::pi * round;
  const double radius = 3.0 + 0.1 * std::floor(round), height = 0.1 * std::floor(round);
  return {FromYawPitchRoll(angle, 0.03, 0.0),
          {radius * std::cos(angle), radius * std::sin(angle), height}};
}

Matrix6d Diagonal(double sigma_m, double sigma_rad) {
  Matrix6d covariance = Matrix6d::Identity();
  covariance.topLeftCorner<3, 3>() *= sigma_m * sigma_m;
  covariance.bottomRightCorner<3, 3>() *= sigma_rad * sigma_rad;
  return covariance;
}

class Diver {
 public:
  explicit Diver(const RoundsConfig& config)
      : config_(config), random_(config.seed, "rounds"), ring_(MakeRing(random_)) {
    elsewhere_ = ring_;
    for (Landmark& landmark : elsewhere_) landmark.p_W = Shuffled(landmark.p_W, random_);
  }

  Rounds Swim() {
    const int count = config_.rounds * config_.per_round;
    rounds_.second_round = TimeOf(config_.per_round);
    for (int k = 0; k < count; ++k) Add(k);
    return std::move(rounds_);
  }

 private:
  static Time TimeOf(int k) { return Time{std::int64_t{k} * 2'000'000'000}; }

  void Add(int k) {
    const bool again = k >= config_.per_round;
    const double round = static_cast<double>(k) / config_.per_round;
    const int since = k - config_.per_round - config_.per_round / 4;
    const bool is_look_alike = since >= 0 && since < config_.look_alikes;
    const Pose T_WI = OnTheWay(round);

    Keyframe keyframe;
    keyframe.t = TimeOf(k);
    keyframe.is_glimpse = config_.with_glimpses && again && k % 2 == 1;
    keyframe.map_id = config_.lost_between && again ? 1 : 0;
    See(again && config_.is_shuffled ? elsewhere_ : ring_,
        is_look_alike ? OnTheWay(round + 0.25) : T_WI, keyframe);
    GoOn(T_WI, keyframe);
    rounds_.keyframes.push_back(std::move(keyframe));
    rounds_.truth.push_back(T_WI);
  }

  /// Ids rise with each view, as if nothing was tracked from one to the next.
  void See(const std::vector<Landmark>& landmarks, const Pose& T_WI, Keyframe& keyframe) {
    const auto noise = [this]() -> Eigen::Vector2d {
      const double u = random_.Gaussian();
      const double v = random_.Gaussian();
      return kPixelSigma * Eigen::Vector2d(u, v);
    };
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
      const Eigen::Vector3d p_I = T_WI.Inverse() * landmarks[k].p_W;
      if (p_I.x() < 0.5) continue;
      const auto left = rig_.camera(0).Project(rig_.T_IC(0).Inverse() * p_I);
      const auto right = rig_.camera(1).Project(rig_.T_IC(1).Inverse() * p_I);
      if (!left || !right || !rig_.camera(0).IsInside(*left) || !rig_.camera(1).IsInside(*right))
        continue;
      const LandmarkId first = config_.still_tracked ? 1 : 1 + views_ * kLandmarks;
      KeyframePoint point{.id = first + k, .sigma_px = kPixelSigma};
      point.left = *left + noise();
      point.right = *right + noise();
      point.descriptor = Disturbed(landmarks[k].descriptor, kChangedBits, random_);
      keyframe.points.push_back(point);
    }
    ++views_;
  }

  /// Where odometry has it, from the keyframe before.
  void GoOn(const Pose& T_WI, Keyframe& keyframe) {
    const bool begins = !has_keyframe_ || keyframe.map_id != before_.map_id;
    if (begins) {
      keyframe.T_WI =
          has_keyframe_ ? Pose(FromYawPitchRoll(1.0, 0.0, 0.0), {5, -3, 0.2}) * T_WI : T_WI;
      keyframe.covariance = Diagonal(1e-3, 1e-3);
    } else {
      Vector6d noise;
      for (int i = 0; i < 6; ++i) noise(i) = (i < 3 ? kStepSigma : kTurnSigma) * random_.Gaussian();
      const Pose step = (truth_before_.Inverse() * T_WI).BoxPlus(noise);
      keyframe.T_WI = before_.T_WI * step;
      keyframe.link = OdometryLink{step, Diagonal(kStepSigma, kTurnSigma)};
      keyframe.covariance = *before_.covariance + Diagonal(kStepSigma, kTurnSigma);
    }
    keyframe.index = keyframe.is_glimpse ? before_.index : (has_keyframe_ ? before_.index + 1 : 0);
    if (keyframe.is_glimpse) return;
    before_ = keyframe;
    truth_before_ = T_WI;
    has_keyframe_ = true;
  }

  RoundsConfig config_;
  RandomStream random_;
  StereoGeometry rig_ = StereoGeometry(SyntheticStereo());
  std::vector<Landmark> ring_, elsewhere_;
  Rounds rounds_;
  Keyframe before_;
  Pose truth_before_;
  bool has_keyframe_ = false;
  LandmarkId views_ = 0;
};

}  // namespace

Rounds MakeRounds(const RoundsConfig& config) { return Diver(config).Swim(); }

Vocabulary VocabularyOf(const Rounds& rounds) {
  std::vector<std::vector<Descriptor>> images;
  for (std::size_t k = 0; k < rounds.keyframes.size() && !rounds.IsRevisit(k); ++k) {
    std::vector<Descriptor>& image = images.emplace_back();
    for (const KeyframePoint& point : rounds.keyframes[k].points) image.push_back(point.descriptor);
  }
  VocabularyTraining training;
  training.branching = 8;
  training.levels = 3;
  return Vocabulary(TrainVocabulary(images, training));
}

}  // namespace drydock::svin2::testing
