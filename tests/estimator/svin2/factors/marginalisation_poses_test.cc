// Marginalisation of poses and landmarks: a stereo rig on its way past a few landmarks.
#include <memory>

#include <ceres/covariance.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <gtest/gtest.h>

#include "estimator/svin2/factors/marginalisation.h"
#include "estimator/svin2/factors/prior_factors.h"
#include "estimator/svin2/factors/reprojection_factor.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/factors/factor_check.h"
#include "tests/estimator/svin2/synthetic_stereo.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::Block;

constexpr std::size_t kPoses = 3, kLandmarks = 8;

CameraModel Camera() { return CameraModel(testing::SyntheticStereo().cameras[0]); }

Pose Extrinsics(std::size_t camera) { return testing::SyntheticStereo().T_IC[camera]; }

/// Blocks: the poses, then the landmarks. Every landmark is seen by both eyes from every pose.
struct Chain {
  std::vector<BlockValues> blocks;
  std::vector<std::unique_ptr<ceres::CostFunction>> factors;
  std::vector<MarginalTerm> terms;

  explicit Chain(bool with_prior) {
    RandomStream random(1, "chain");
    for (std::size_t k = 0; k < kPoses; ++k) {
      const auto step = static_cast<double>(k);
      blocks.push_back(Block(ToParameters(
          Pose(FromYawPitchRoll(0.1 * step, 0.05 * step, -0.03 * step), {0.3 * step, 0.1, 0.0}))));
    }
    for (std::size_t k = 0; k < kLandmarks; ++k) {
      const double x = random.Uniform(2.5, 5.0);
      const double y = random.Uniform(-0.8, 0.8);
      const double z = random.Uniform(-0.6, 0.6);
      blocks.push_back({x, y, z});
    }
    if (with_prior) {
      Vector6d sigmas;
      sigmas << 0.1, 0.1, 0.1, 0.02, 0.02, 0.02;
      Add(std::make_unique<PosePriorFactor>(FromParameters(blocks[0].data()),
                                            PoseWhitening(sigmas)),
          {0});
    }
    for (std::size_t pose = 0; pose < kPoses; ++pose)
      for (std::size_t landmark = 0; landmark < kLandmarks; ++landmark) See(random, pose, landmark);
  }

  void See(RandomStream& random, std::size_t pose, std::size_t landmark) {
    const Eigen::Map<const Vector3d> p_W(blocks[kPoses + landmark].data());
    for (const std::size_t camera : {0u, 1u}) {
      const Pose T_WC = FromParameters(blocks[pose].data()) * Extrinsics(camera);
      const double du = random.Gaussian();
      const double dv = random.Gaussian();
      const Vector2d pixel = *Camera().Project(T_WC.Inverse() * p_W) + 0.5 * Vector2d(du, dv);
      Add(std::make_unique<ReprojectionFactor>(Camera(), Extrinsics(camera), pixel, 0.5),
          {pose, kPoses + landmark});
    }
  }

  void Add(std::unique_ptr<ceres::CostFunction> factor, std::vector<std::size_t> of) {
    terms.push_back({factor.get(), nullptr, std::move(of)});
    factors.push_back(std::move(factor));
  }
};

/// The terms over the blocks as a Ceres problem, which owns neither.
std::unique_ptr<ceres::Problem> MakeProblem(std::vector<BlockValues>& blocks,
                                            const std::vector<MarginalTerm>& terms) {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  auto problem = std::make_unique<ceres::Problem>(options);
  for (const MarginalTerm& term : terms) {
    std::vector<double*> parameters;
    for (const std::size_t k : term.blocks) {
      parameters.push_back(blocks[k].data());
      if (!problem->HasParameterBlock(blocks[k].data())) {
        ceres::Manifold* manifold = blocks[k].size() == 7 ? new PoseManifold : nullptr;
        problem->AddParameterBlock(blocks[k].data(), static_cast<int>(blocks[k].size()), manifold);
      }
    }
    problem->AddResidualBlock(const_cast<ceres::CostFunction*>(term.cost), nullptr, parameters);
  }
  return problem;
}

void Solve(ceres::Problem& problem) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.function_tolerance = 0.0;
  options.parameter_tolerance = 1e-13;
  options.gradient_tolerance = 1e-12;
  options.max_num_iterations = 50;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

Eigen::MatrixXd PoseCovariance(ceres::Problem& problem, const BlockValues& pose) {
  ceres::Covariance covariance({});
  const std::vector<std::pair<const double*, const double*>> pairs = {{pose.data(), pose.data()}};
  if (!covariance.Compute(pairs, &problem)) return {};
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> block;
  covariance.GetCovarianceBlockInTangentSpace(pose.data(), pose.data(), block.data());
  return block;
}

/// What stays if the first pose and the first half of the landmarks go.
struct Reduced {
  std::vector<MarginalTerm> gone, staying;
  std::vector<std::size_t> kept;  ///< Of the blocks, those that the prior is about.
};

Reduced Split(const Chain& chain) {
  Reduced reduced;
  const auto goes = [](std::size_t k) {
    return k == 0 || (k >= kPoses && k < kPoses + kLandmarks / 2);
  };
  for (const MarginalTerm& term : chain.terms) {
    bool touches = false;
    for (const std::size_t k : term.blocks) touches = touches || goes(k);
    (touches ? reduced.gone : reduced.staying).push_back(term);
  }
  for (std::size_t k = 0; k < chain.blocks.size(); ++k)
    if (!goes(k)) reduced.kept.push_back(k);
  return reduced;
}

TEST(MarginalisationPoses, TheRestIsSolvedAsInTheBatch) {
  Chain chain(true);
  const auto batch = MakeProblem(chain.blocks, chain.terms);
  Solve(*batch);
  const std::vector<BlockValues> best = chain.blocks;
  const Eigen::MatrixXd batch_covariance = PoseCovariance(*batch, chain.blocks[2]);

  Reduced reduced = Split(chain);
  const LinearPriorFactor prior(Marginalise(best, reduced.gone, reduced.kept));
  reduced.staying.push_back({&prior, nullptr, reduced.kept});
  std::vector<BlockValues> blocks = best;
  Vector6d off;
  off << 0.02, -0.03, 0.01, 0.01, 0.02, -0.02;
  for (const std::size_t k : {1u, 2u})
    blocks[k] = Block(ToParameters(FromParameters(best[k].data()).BoxPlus(off)));
  const auto problem = MakeProblem(blocks, reduced.staying);
  Solve(*problem);

  for (const std::size_t k : {1u, 2u}) {
    const Pose expected = FromParameters(best[k].data());
    // Standard deviations are 0.1 m and 0.02 rad; the solver stops at 1e-7.
    EXPECT_LT(FromParameters(blocks[k].data()).BoxMinus(expected).norm(), 1e-6) << k;
  }
  const Eigen::MatrixXd covariance = PoseCovariance(*problem, blocks[2]);
  ASSERT_EQ(covariance.rows(), 6);
  ASSERT_EQ(batch_covariance.rows(), 6);
  EXPECT_LT((covariance - batch_covariance).norm(), 1e-6 * batch_covariance.norm());
}

TEST(MarginalisationPoses, ThePriorsSlopeBalancesTheTermsThatStay) {
  // At the batch's optimum the slopes of all terms add up to 0, and the prior stands for those that
  // are gone.
  Chain chain(true);
  Solve(*MakeProblem(chain.blocks, chain.terms));
  Reduced reduced = Split(chain);
  const LinearPriorFactor prior(Marginalise(chain.blocks, reduced.gone, reduced.kept));
  const auto steepest = [&chain](const std::vector<MarginalTerm>& terms) {
    std::vector<double> gradient;
    MakeProblem(chain.blocks, terms)->Evaluate({}, nullptr, nullptr, &gradient, nullptr);
    return Eigen::Map<const Eigen::VectorXd>(gradient.data(), static_cast<int>(gradient.size()))
        .cwiseAbs()
        .maxCoeff();
  };
  EXPECT_GT(steepest(reduced.staying), 10.0);
  reduced.staying.push_back({&prior, nullptr, reduced.kept});
  EXPECT_LT(steepest(reduced.staying), 1e-3);
}

TEST(MarginalisationPoses, TheGaugeGainsNoInformation) {
  // Cameras alone do not know where the world is: moving all that is kept by the same motion must
  // cost nothing, and six directions must be missing.
  const Chain chain(false);
  const Reduced reduced = Split(chain);
  const LinearPrior prior = Marginalise(chain.blocks, reduced.gone, reduced.kept);
  EXPECT_EQ(prior.jacobian.cols() - prior.jacobian.rows(), 6);
  for (int axis = 0; axis < 6; ++axis) {
    Eigen::VectorXd motion(prior.jacobian.cols());
    int row = 0;
    for (const std::size_t k : reduced.kept) {
      const Vector3d p(chain.blocks[k][0], chain.blocks[k][1], chain.blocks[k][2]);
      const Vector3d unit = Vector3d::Unit(axis % 3);
      motion.segment<3>(row) = axis < 3 ? unit : unit.cross(p);
      row += 3;
      if (chain.blocks[k].size() != 7) continue;
      motion.segment<3>(row) = axis < 3 ? Vector3d(0, 0, 0) : unit;
      row += 3;
    }
    EXPECT_LT((prior.jacobian * motion).norm(), 1e-6 * prior.jacobian.norm()) << axis;
  }
}

}  // namespace
}  // namespace drydock::svin2
