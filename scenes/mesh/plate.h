// Upright plates of stone: an outline in x and z with a thickness along y; tombstones, steles.
#pragma once

#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes {

/// Corners (x, z) [m], counter-clockwise seen from -y.
using Outline = std::vector<Eigen::Vector2d>;

/// A slab from z = `foot` up to `shoulder`, with an arch over its whole width that rises by `rise`
/// more [m], of `arc` pieces.
Outline RoundTopOutline(double half_width, double foot, double shoulder, double rise, int arc);

/// The outline moved inwards by `distance` [m] along the bisectors of its corners.
Outline Inset(const Outline& outline, double distance);

/// What is left of a convex outline where (p - point) . normal <= 0: a corner broken off.
Outline Clip(const Outline& outline, const Eigen::Vector2d& point, const Eigen::Vector2d& normal);

/// A fan around `middle`, from which every corner must be in sight, at y: seen from -y if y is
/// negative, else from +y. `uv` has the picture's place of a point (x, z).
Mesh PlateFace(const Outline& outline, const Eigen::Vector2d& middle, double y,
               const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& uv);

/// What joins the faces of a plate from y = -thickness / 2 to thickness / 2. With bevel > 0 its
/// edges are cut by that much [m]; the faces' outline is then Inset(outline, bevel).
Mesh PlateRim(const Outline& outline, double thickness, const TileUv& uv, double bevel = 0.0);

}  // namespace drydock::scenes
