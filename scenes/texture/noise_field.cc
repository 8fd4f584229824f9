#include "scenes/texture/noise_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/mesh/lattice_noise.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes {
namespace {

/// Standard deviation of one octave with gradients uniform in [-1, 1]^2, averaged over a cell.
constexpr double kOctaveSigma = 0.1777;

/// One octave: gradients on a lattice, and where each column falls in it.
struct Octave {
  double cell_y = 1.0;
  float amplitude = 1.0F;
  int columns = 1;  ///< of the lattice; it has rows of columns + 1 values
  int rows = 1;
  std::vector<float> gradient_x;
  std::vector<float> gradient_y;
  std::vector<int> column;    ///< of each pixel column
  std::vector<float> offset;  ///< of each pixel column within its cell
  std::vector<float> weight;  ///< faded offset
};

float Fade(float t) { return t * t * t * (t * (6.0F * t - 15.0F) + 10.0F); }

Octave MakeOctave(cv::Size size, double cell, const NoiseShape& shape, std::uint64_t key) {
  Octave o;
  double cell_x = cell;
  o.cell_y = cell * shape.stretch_y;
  o.columns = static_cast<int>(std::ceil(size.width / cell_x));
  o.rows = static_cast<int>(std::ceil(size.height / o.cell_y));
  if (shape.wrap) {
    o.columns = std::max(1, static_cast<int>(std::lround(size.width / cell_x)));
    o.rows = std::max(1, static_cast<int>(std::lround(size.height / o.cell_y)));
    cell_x = static_cast<double>(size.width) / o.columns;
    o.cell_y = static_cast<double>(size.height) / o.rows;
  }
  for (int j = 0; j <= o.rows; ++j) {
    for (int i = 0; i <= o.columns; ++i) {
      const int jj = shape.wrap ? j % o.rows : j;
      const int ii = shape.wrap ? i % o.columns : i;
      const std::uint64_t bits = HashLattice(ii, jj, 0, key);
      o.gradient_x.push_back(static_cast<float>(bits & 0xffff) / 32767.5F - 1.0F);
      o.gradient_y.push_back(static_cast<float>((bits >> 16) & 0xffff) / 32767.5F - 1.0F);
    }
  }
  for (int x = 0; x < size.width; ++x) {
    const double position = (x + 0.5) / cell_x;
    const int column = std::min(static_cast<int>(position), o.columns - 1);
    const auto offset = static_cast<float>(position - column);
    o.column.push_back(column);
    o.offset.push_back(offset);
    o.weight.push_back(Fade(offset));
  }
  return o;
}

/// Adds the octave's row y to `row`. Along a row the noise is, in each cell, a blend of two linear
/// functions: slope and value at the left corners and at the right ones.
void AddRow(const Octave& o, int y, int width, float* row, std::vector<float>& slope,
            std::vector<float>& value) {
  const double position = (y + 0.5) / o.cell_y;
  const int j = std::min(static_cast<int>(position), o.rows - 1);
  const auto dy = static_cast<float>(position - j);
  const float t = Fade(dy);
  const std::size_t upper = static_cast<std::size_t>(j) * (o.columns + 1);
  const std::size_t lower = upper + o.columns + 1;
  for (int i = 0; i <= o.columns; ++i) {
    const float sx = o.gradient_x[upper + i] * (1 - t) + o.gradient_x[lower + i] * t;
    const float vy =
        o.gradient_y[upper + i] * dy * (1 - t) + o.gradient_y[lower + i] * (dy - 1) * t;
    slope[i] = sx * o.amplitude;
    value[i] = vy * o.amplitude;
  }
  for (int x = 0; x < width; ++x) {
    const int i = o.column[x];
    const float dx = o.offset[x];
    const float left = value[i] + slope[i] * dx;
    const float right = value[i + 1] + slope[i + 1] * (dx - 1);
    row[x] += left + (right - left) * o.weight[x];
  }
}

}  // namespace

cv::Mat1f NoiseField(cv::Size size, const NoiseShape& shape, std::uint64_t key) {
  std::vector<Octave> octaves;
  double amplitude = 1.0;
  double variance = 0.0;
  for (double cell = shape.largest; cell >= shape.smallest || octaves.empty(); cell /= 2) {
    octaves.push_back(MakeOctave(size, cell, shape, key + octaves.size()));
    octaves.back().amplitude = static_cast<float>(amplitude);
    variance += amplitude * amplitude;
    amplitude *= shape.gain;
  }
  const auto scale = static_cast<float>(1.0 / (kOctaveSigma * std::sqrt(variance)));
  for (Octave& o : octaves) o.amplitude *= scale;
  cv::Mat1f field(size, 0.0F);
  cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& range) {
    std::vector<float> slope(size.width + 2);
    std::vector<float> value(size.width + 2);
    for (int y = range.start; y < range.end; ++y) {
      for (const Octave& o : octaves) {
        slope.resize(std::max<std::size_t>(slope.size(), o.columns + 1));
        value.resize(slope.size());
        AddRow(o, y, size.width, field[y], slope, value);
      }
    }
  });
  return field;
}

cv::Mat1b Coverage(const cv::Mat1f& field, double fraction, double softness) {
  const double threshold = InverseNormal(1.0 - std::clamp(fraction, 1e-6, 1.0 - 1e-6));
  return Ramp(field, threshold - softness / 2, threshold + softness / 2);
}

cv::Mat1b Ramp(const cv::Mat1f& field, double low, double high) {
  cv::Mat1b mask(field.size());
  const auto offset = static_cast<float>(low);
  const auto gain = static_cast<float>(255.0 / std::max(high - low, 1e-6));
  cv::parallel_for_(cv::Range(0, field.rows), [&](const cv::Range& range) {
    for (int y = range.start; y < range.end; ++y) {
      const float* in = field[y];
      std::uint8_t* out = mask[y];
      for (int x = 0; x < field.cols; ++x) {
        out[x] = static_cast<std::uint8_t>(std::clamp((in[x] - offset) * gain, 0.0F, 255.0F));
      }
    }
  });
  return mask;
}

cv::Mat1b ZeroLines(const cv::Mat1f& field, double width) {
  const cv::Mat1f distance = cv::abs(field);
  return 255 - Ramp(distance, 0.5 * width, width);
}

void AddMask(cv::Mat1f& field, const cv::Mat1b& mask, double weight) {
  const auto gain = static_cast<float>(weight / 255.0);
  for (int y = 0; y < field.rows; ++y) {
    for (int x = 0; x < field.cols; ++x) field(y, x) += gain * static_cast<float>(mask(y, x));
  }
}

}  // namespace drydock::scenes
