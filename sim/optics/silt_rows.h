// The inner loops of silt clouds; see optics_rows.h for their rules.
#pragma once

namespace drydock::sim::rows {

/// A Gaussian blob of silt as one camera has it.
struct BlobInCamera {
  float centre_C[3];  ///< [m]
  float scale;        ///< 1 / (sqrt(2) sigma) [1/m]
  float half_depth;   ///< Half of the optical depth through the middle, from side to side.
};

/// The rays of pixels with (u - cx) / focal in `columns`, in a row with (v - cy) / focal = y: the
/// cosine of each one's angle to the axis, and the range of what it meets at `depth` along the axis
/// [m], 10 km at most.
void Rays(int width, const float* columns, float y, const float* depth, float* cosine,
          float* range);

/// Adds the optical depth of the part of a blob that lies in front of what each pixel sees. It is
/// off by 4e-6 of what lies on the ray in all.
void AddDepth(int width, const BlobInCamera& blob, const float* columns, float y,
              const float* cosine, const float* range, float* tau);

/// Makes optical depths opacities, 1 - exp(-tau).
void MakeOpacity(int width, float* tau);

/// radiance += opacity (source - share radiance), for one of `channels` interleaved ones.
void AddCloud(int width, int channels, const float* opacity, const float* source,
              const float* share, float* radiance);

}  // namespace drydock::sim::rows
