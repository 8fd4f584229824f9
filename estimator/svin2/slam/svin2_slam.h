// SVIn2 with everything: odometry, and loops that take its drift away.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/odometry/svin2.h"
#include "estimator/svin2/slam/loop_closer.h"
#include "sensors_models/base/worker.h"

namespace drydock::svin2 {

/// The estimator of the paper. Odometry() is smooth; Corrected() lays it on the pose graph, and
/// Latest().T_GW says how far it has drifted.
class Svin2Slam final : public Estimator {
 public:
  /// InputError if the vocabulary that comes with Drydock cannot be read.
  Svin2Slam(const Rig& rig, const Svin2Config& odometry, const LoopCloserConfig& loops);

  void Start(const std::optional<NavState>& known) override { odometry_->Start(known); }
  void Add(const Measurement& measurement) override;
  void Finish() override;

  std::optional<NavEstimate> Latest() const override;
  const Trajectory& Odometry() const override { return odometry_->Odometry(); }
  Trajectory Corrected() const override;
  std::vector<LoopClosure> Loops() const override { return loops_.Loops(); }
  EstimatedMap Map() const override;
  std::vector<EstimatorEvent> TakeEvents() override;
  EstimatorTimings Timings() const override;

 private:
  void CloseLoops();

  std::unique_ptr<Svin2> odometry_;
  Worker worker_;  // Before what it works for.
  LoopCloser loops_;
};

/// SVIn2 with `options` over its defaults: those of the odometry, and `loops`. InputError with
/// file, line and key.
std::unique_ptr<Estimator> MakeSvin2Slam(const Rig& rig, const YamlNode& options);

}  // namespace drydock::svin2
