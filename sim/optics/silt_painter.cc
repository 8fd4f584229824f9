#include "sim/optics/silt_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sensors_models/base/random_stream.h"
#include "sim/optics/monochrome.h"
#include "sim/optics/optics_rows.h"

namespace drydock::sim {
namespace {

double HalfDepth(const SiltBlob& blob) {
  return blob.attenuation * blob.sigma * std::sqrt(std::numbers::pi / 2.0);
}

rows::BlobInCamera InCamera(const SiltBlob& blob, const Pose& T_CW) {
  const Eigen::Vector3f centre = (T_CW * blob.centre_W).cast<float>();
  return {{centre.x(), centre.y(), centre.z()},
          static_cast<float>(1.0 / (std::numbers::sqrt2 * blob.sigma)),
          static_cast<float>(HalfDepth(blob))};
}

/// The range along the ray (a unit vector) from in front of which half of the light comes that an
/// evenly lit blob sends back along it [m].
double HalfLightRange(const SiltBlob& blob, const Eigen::Vector3d& from_W,
                      const Eigen::Vector3d& ray_W) {
  const Eigen::Vector3d centre = blob.centre_W - from_W;
  const double closest = centre.dot(ray_W);
  const double across = (centre - closest * ray_W).norm() / blob.sigma;
  const double half = std::max(HalfDepth(blob) * std::exp(-0.5 * across * across), 1e-9);
  // tau(r) = half (erf((r - closest) / (sqrt(2) sigma)) + before)
  const double before = std::erf(closest / (std::numbers::sqrt2 * blob.sigma));
  const double tau = -std::log1p(0.5 * std::expm1(-half * (1.0 + before)));
  const double erf = std::clamp(tau / half - before, -0.999999, 0.999999);
  return std::max(0.0, closest + blob.sigma * InverseNormal(0.5 * (1.0 + erf)));
}

/// From the first to the last of `count` that `touches`, in whole cells of `raster`.
template <typename Touches>
std::pair<int, int> CellsThatTouch(int count, int raster, Touches touches) {
  int begin = 0, end = count;
  while (begin < end && !touches(begin)) ++begin;
  while (end > begin && !touches(end - 1)) --end;
  return {begin / raster, CellsIn(end, raster)};
}

}  // namespace

SiltPainter::SiltPainter(const Pinhole& pinhole, const Eigen::Array3f& beam_attenuation)
    : pinhole_(pinhole), beam_attenuation_(beam_attenuation) {
  for (int u = 0; u < pinhole.width; ++u)
    columns_.push_back(static_cast<float>((u - pinhole.cx) / pinhole.focal));
}

std::optional<SiltPainter::Window> SiltPainter::FindWindow(const rows::BlobInCamera& blob) const {
  const double ratio = 2.0 * static_cast<double>(blob.half_depth) / kLeast;
  if (ratio <= 1.0) return std::nullopt;
  // Farther from the middle than this no ray has kLeast.
  const double reach = std::sqrt(std::log(ratio)) / static_cast<double>(blob.scale);
  const Eigen::Vector3d centre = Eigen::Vector3f(blob.centre_C).cast<double>();
  if (centre.z() < -reach) return std::nullopt;
  // Distances from the planes through the camera and a row, or a column, of the image.
  const auto touches = [&](double slope, double along) {
    return std::abs(along - slope * centre.z()) <= reach * std::hypot(1.0, slope);
  };
  const auto [row_begin, row_end] = CellsThatTouch(pinhole_.height, kRaster, [&](int v) {
    return touches((v - pinhole_.cy) / pinhole_.focal, centre.y());
  });
  const auto [column_begin, column_end] = CellsThatTouch(pinhole_.width, kRaster, [&](int u) {
    return touches((u - pinhole_.cx) / pinhole_.focal, centre.x());
  });
  if (row_begin >= row_end || column_begin >= column_end) return std::nullopt;
  return Window{column_begin, column_end, row_begin, row_end};
}

std::vector<SiltPainter::Puff> SiltPainter::FindPuffs(const std::vector<SiltBlob>& puffs,
                                                      const Pose& T_CW) const {
  std::vector<Puff> found;
  for (const SiltBlob& puff : puffs) {
    const rows::BlobInCamera blob = InCamera(puff, T_CW);
    if (const auto window = FindWindow(blob)) found.push_back({blob, *window});
  }
  return found;
}

std::vector<SiltPainter::Plane> SiltPainter::LookAtRaster(const DrawnSilt& silt,
                                                          const Window& window,
                                                          const SiltView& view) const {
  const bool color = view.channels == ImageChannels::kColor;
  const cv::Size size(window.column_end - window.column_begin + 1,
                      window.row_end - window.row_begin + 1);
  std::vector<Plane> planes(color ? 3 : 1);
  for (Plane& plane : planes) {
    plane.source = cv::Mat(size, CV_32FC1, cv::Scalar(0.0));
    plane.share = cv::Mat(size, CV_32FC1, cv::Scalar(0.0));
  }
  const Eigen::Vector3d& from_W = view.T_WC.p();
  for (int row = 0; row < size.height; ++row) {
    const double y = ((window.row_begin + row) * kRaster - pinhole_.cy) / pinhole_.focal;
    for (int column = 0; column < size.width; ++column) {
      const double x = ((window.column_begin + column) * kRaster - pinhole_.cx) / pinhole_.focal;
      const Eigen::Vector3d ray_W = view.T_WC.q() * Eigen::Vector3d(x, y, 1.0).normalized();
      const double range = HalfLightRange(silt.whole, from_W, ray_W);
      const Eigen::Array3f share = (-beam_attenuation_ * static_cast<float>(range)).exp();
      const Eigen::Array3f source = share * silt.albedo * view.light(from_W + range * ray_W);
      for (int i = 0; i < 3; ++i) {
        Plane& plane = planes[color ? static_cast<std::size_t>(i) : 0];
        const float weight = color ? 1.F : kMonochromeWeights[static_cast<std::size_t>(i)];
        plane.source.at<float>(row, column) += weight * source[i];
        plane.share.at<float>(row, column) += weight * share[i];
      }
    }
  }
  return planes;
}

int SiltPainter::ColumnEnd(const Window& window) const {
  return std::min(window.column_end * kRaster, pinhole_.width);
}

void SiltPainter::FindOpacity(const std::vector<Puff>& puffs, const Window& window, int v,
                              const cv::Mat& depth, std::vector<float>& opacity) const {
  const int first = window.column_begin * kRaster, width = ColumnEnd(window) - first;
  const auto y = static_cast<float>((v - pinhole_.cy) / pinhole_.focal);
  std::vector<float> cosine(opacity.size()), range(opacity.size());
  rows::Rays(width, columns_.data() + first, y, depth.ptr<float>(v) + first, cosine.data(),
             range.data());
  std::fill(opacity.begin(), opacity.end(), 0.F);
  for (const Puff& puff : puffs) {
    if (v < puff.window.row_begin * kRaster || v >= puff.window.row_end * kRaster) continue;
    const int begin = puff.window.column_begin * kRaster, offset = begin - first;
    rows::AddDepth(ColumnEnd(puff.window) - begin, puff.blob, columns_.data() + begin, y,
                   cosine.data() + offset, range.data() + offset, opacity.data() + offset);
  }
  rows::MakeOpacity(width, opacity.data());
}

void SiltPainter::Draw(const DrawnSilt& silt, const SiltView& view, cv::Mat& radiance) const {
  const std::vector<Puff> puffs = FindPuffs(silt.puffs, view.T_WC.Inverse());
  if (puffs.empty()) return;
  Window window = puffs.front().window;
  for (const Puff& puff : puffs) {
    window.column_begin = std::min(window.column_begin, puff.window.column_begin);
    window.column_end = std::max(window.column_end, puff.window.column_end);
    window.row_begin = std::min(window.row_begin, puff.window.row_begin);
    window.row_end = std::max(window.row_end, puff.window.row_end);
  }
  const std::vector<Plane> planes = LookAtRaster(silt, window, view);
  const int channels = static_cast<int>(planes.size());
  const int first = window.column_begin * kRaster, width = ColumnEnd(window) - first;
  const int cells = window.column_end - window.column_begin;
  std::vector<float> opacity(static_cast<std::size_t>(width));
  std::vector<float> coarse(static_cast<std::size_t>(cells) + 1);
  std::vector<float> source(static_cast<std::size_t>(cells) * kRaster), share(source.size());
  const int row_end = std::min(window.row_end * kRaster, pinhole_.height);
  for (int v = window.row_begin * kRaster; v < row_end; ++v) {
    FindOpacity(puffs, window, v, view.depth, opacity);
    const auto spread = [&](const cv::Mat& raster, std::vector<float>& fine) {
      const int above = v / kRaster - window.row_begin;
      rows::Interpolate(cells + 1, raster.ptr<float>(above), raster.ptr<float>(above + 1),
                        static_cast<float>(v % kRaster) / kRaster, coarse.data());
      rows::Stretch(cells, kRaster, coarse.data(), fine.data());
    };
    for (int i = 0; i < channels; ++i) {
      spread(planes[static_cast<std::size_t>(i)].source, source);
      spread(planes[static_cast<std::size_t>(i)].share, share);
      rows::AddCloud(width, channels, opacity.data(), source.data(), share.data(),
                     radiance.ptr<float>(v) + first * channels + i);
    }
  }
}

}  // namespace drydock::sim
