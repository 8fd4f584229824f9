// What the stones say, and where each inscription is in the atlas that they all share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/mesh/shapes.h"

namespace drydock::scenes::cemetery {

enum class Ornament { kNone, kCross, kStar, kWreath, kAnchor, kRays, kLeaf };

/// Invented names and dates, one or two lines below.
struct Inscription {
  std::string first_name;
  std::string surname;
  std::string dates;
  std::string epitaph;
  Ornament ornament = Ornament::kNone;
};

// The atlas: the upper rows are of pale stone, the lower ones of dark stone.
inline constexpr int kAtlasColumns = 8;
inline constexpr int kAtlasRows = 5;
inline constexpr int kPaleRows = 3;
inline constexpr int kInscriptions = kAtlasColumns * kAtlasRows;
inline constexpr double kCellWidth = 0.56;   ///< [m]
inline constexpr double kCellHeight = 0.70;  ///< [m]
/// The share of a cell's height above its lines of text, which has the ornament.
inline constexpr double kOrnamentShare = 0.36;

inline bool IsPale(int inscription) { return inscription < kPaleRows * kAtlasColumns; }

/// A whole cell, or its lines of text alone.
inline UvRect InscriptionCell(int inscription, bool text_only = false) {
  constexpr double kInset = 0.004;  // Nothing of the neighbours, also in coarse mipmap levels.
  const Eigen::Vector2d size(1.0 / kAtlasColumns, 1.0 / kAtlasRows);
  const int column = inscription % kAtlasColumns;
  const int row = inscription / kAtlasColumns;
  const Eigen::Vector2d low(column * size.x() + kInset,
                            (row + (text_only ? kOrnamentShare : 0.0)) * size.y() + kInset);
  return {low, {(column + 1) * size.x() - kInset, (row + 1) * size.y() - kInset}};
}

/// One for each cell of the atlas; no name comes twice.
std::vector<Inscription> Inscriptions(std::uint64_t seed);

}  // namespace drydock::scenes::cemetery
