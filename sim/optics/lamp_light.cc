#include "sim/optics/lamp_light.h"

#include <algorithm>

namespace drydock::sim {
namespace {

std::vector<LampInCamera> SeenFrom(const std::vector<LampConfig>& lamps, const Pose& T_IC) {
  std::vector<LampInCamera> seen;
  seen.reserve(lamps.size());
  for (const LampConfig& lamp : lamps) seen.push_back(SeenFrom(lamp, T_IC));
  return seen;
}

std::vector<ShiningDisc> DiscsOf(const std::vector<LampConfig>& lamps,
                                 const std::vector<LampInCamera>& seen) {
  std::vector<ShiningDisc> discs;
  discs.reserve(lamps.size());
  for (std::size_t i = 0; i < lamps.size(); ++i)
    discs.push_back({seen[i].position_C, seen[i].axis_C, 0.5 * lamps[i].size_m});
  return discs;
}

rows::Lamp ForRows(const LampInCamera& lamp) {
  rows::Lamp out{};
  for (int i = 0; i < 3; ++i) {
    out.position_C[i] = static_cast<float>(lamp.position_C[i]);
    out.axis_C[i] = static_cast<float>(lamp.axis_C[i]);
  }
  out.sharpness = static_cast<float>(lamp.sharpness);
  out.nearest = static_cast<float>(LampInCamera::kNearest * LampInCamera::kNearest);
  return out;
}

}  // namespace

LampLight::LampLight(const std::vector<LampConfig>& lamps, const Pose& T_IC,
                     const WaterConfig& water, const Pinhole& pinhole, const RayScene* rays)
    : lamps_(SeenFrom(lamps, T_IC)),
      attenuation_(BeamAttenuation(water)),
      veil_(water, pinhole, lamps_) {
  if (rays != nullptr) shadows_.emplace(*rays, pinhole, DiscsOf(lamps, lamps_));
  const auto width = static_cast<std::size_t>(pinhole.width);
  for (auto& axis : normal_) axis.resize(width);
  share_.resize(width);
  way_.resize(width);
  open_.assign(width, 1.F);
}

void LampLight::Look(const cv::Mat& depth, const Pose& T_WC) {
  if (shadows_) shadows_->Look(depth, T_WC);
}

void LampLight::AddRow(const rows::RowView& view, const Row& row, const Eigen::Array3f& weights,
                       const std::array<float*, 3>& direct, const std::array<float*, 3>& veil) {
  const auto* depth = row.depth.ptr<float>(row.v);
  const rows::NormalRow normal{normal_[0].data(), normal_[1].data(), normal_[2].data()};
  rows::Normals(view, row.depth.ptr<float>(std::max(row.v - 1, 0)), depth,
                row.depth.ptr<float>(std::min(row.v + 1, row.depth.rows - 1)), normal);
  for (std::size_t i = 0; i < lamps_.size(); ++i) {
    rows::LampOnSurfaces(view, ForRows(lamps_[i]), depth, row.range, normal, share_.data(),
                         way_.data());
    const float* lit = shadows_ ? shadows_->Row(i, row.v, depth) : open_.data();
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto c = static_cast<Eigen::Index>(channel);
      rows::AddLampLight(view.width, static_cast<float>(lamps_[i].intensity[c]) * weights[c],
                         static_cast<float>(attenuation_[c]), row.albedo[channel].data(), lit,
                         share_.data(), way_.data(), direct[channel]);
    }
  }
  if (veil[0] == veil[1]) {
    veil_.AddRow(row.v, row.range, weights, veil[0]);
    return;
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Eigen::Array3f alone = Eigen::Array3f::Zero();
    alone[static_cast<Eigen::Index>(channel)] = weights[static_cast<Eigen::Index>(channel)];
    veil_.AddRow(row.v, row.range, alone, veil[channel]);
  }
}

Eigen::Array3d LampLight::IlluminanceAt(const Eigen::Vector3d& p_C) const {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (const LampInCamera& lamp : lamps_) sum += lamp.IlluminanceAt(p_C, attenuation_);
  return sum;
}

}  // namespace drydock::sim
