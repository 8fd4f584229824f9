// Shapes with texture coordinates: sheets, boxes, tubes, turned parts, rocks, leaves.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes {

struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector2d uv;
};

/// A piece of a repeating texture: uv = offset + metres / period.
struct TileUv {
  double period = 1.0;  ///< size of one repetition [m]
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
};

/// A rectangle of an atlas.
struct UvRect {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Ones();
  /// The point at fractions s and t of the rectangle's sides.
  Eigen::Vector2d At(double s, double t) const {
    return {low.x() + s * (high.x() - low.x()), low.y() + t * (high.y() - low.y())};
  }
};

/// A smooth sheet of columns x rows cells. `at(s, t)` is asked on the grid s = i / columns,
/// t = j / rows; the outside is where ds x dt points.
Mesh GridSheet(int columns, int rows, const std::function<SurfacePoint(double s, double t)>& at);

/// An axis-aligned box around `center`. With bevel > 0 its four edges along `bevel_axis` (0, 1 or
/// 2) are cut by that much [m], which gives soft-looking cushions, planks and bars.
Mesh Box(const Eigen::Vector3d& center, const Eigen::Vector3d& size, const TileUv& uv,
         double bevel = 0.0, int bevel_axis = 0);

/// A tube along `path`; `radii` has one radius a path point. Closed ends if `caps`. The texture
/// meets itself round the tube: in whole repetitions, or mirrored on tubes thinner than that.
Mesh Tube(const std::vector<Eigen::Vector3d>& path, const std::vector<double>& radii, int segments,
          const TileUv& uv, bool caps = true);
Mesh Tube(const std::vector<Eigen::Vector3d>& path, double radius, int segments, const TileUv& uv);

/// Turns a profile of (radius, height) points about z, the outside to the right of the profile's
/// way up. u goes once (times `u_turns`) round, v along the profile from v_low to v_high.
Mesh Lathe(const std::vector<Eigen::Vector2d>& profile, int segments, double u_turns = 1.0,
           double v_low = 0.0, double v_high = 1.0);

/// Lengths along a polyline up to each of its points, as fractions of the whole.
std::vector<double> ArcFractions(const std::vector<Eigen::Vector3d>& line);

/// A flat disc with its outside towards +z, the picture `uv` fitted to its square.
Mesh Disc(double radius, int segments, const UvRect& uv);

/// A boulder: a cube of cells x cells faces blown up to a ball, squashed to `size` (full extents)
/// [m] and dented by noise. The same key gives the same rock.
Mesh Rock(const Eigen::Vector3d& size, int cells, double roughness, std::uint64_t key,
          const TileUv& uv);

/// A square tile of ground of cells x cells, its corner of least x and y at `corner`, `size` wide
/// [m]: `height` [m] and `uv` are asked at (x, y).
Mesh GroundTile(const Eigen::Vector2d& corner, double size, int cells,
                const std::function<double(const Eigen::Vector2d& p)>& height,
                const std::function<Eigen::Vector2d(const Eigen::Vector2d& p)>& uv);

/// Moves every corner by up to about `depth` [m], with bumps of `size` [m]: worn stone. A function
/// of the place and the key, so that what was closed stays closed.
void Wear(Mesh& mesh, double size, double depth, std::uint64_t key);

/// A blade, a leaf or a strip: `spine` with one half width a point, standing across `side`. Seen
/// from both sides. u across within the rectangle, v from the root (bottom) to the tip (top).
Mesh Ribbon(const std::vector<Eigen::Vector3d>& spine, const std::vector<double>& half_widths,
            const Eigen::Vector3d& side, const UvRect& uv);

}  // namespace drydock::scenes
