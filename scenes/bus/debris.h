// Things that lie around a sunken bus. Each is made at the origin, standing or lying on z = 0.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/mesh/mesh.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::bus {

/// Meshes with their materials.
using Object = std::vector<std::pair<std::string, Mesh>>;

Object MakeBarrel(RandomStream& random);
Object MakeTyre(RandomStream& random);
Object MakeLog(double length, double radius, RandomStream& random);
Object MakeStump(RandomStream& random);
/// A whole fallen tree along x, `length` long, its limbs up to half as high.
Object MakeTree(double length, RandomStream& random);
/// An old jetty pile, `height` tall above z = 0 (and half a metre below).
Object MakePile(double height, double radius, RandomStream& random);
Object MakeCrate(RandomStream& random);
Object MakePallet(RandomStream& random);
Object MakeBlock(RandomStream& random);
/// A concrete pipe, lying along x.
Object MakePipe(double length, double radius, RandomStream& random);
/// A rowing boat along x, 3.6 m long.
Object MakeBoat(RandomStream& random);
/// A clump of water plants up to `height` tall.
Object MakeWeeds(double height, int blades, RandomStream& random);
Object MakeBoulder(double size, int cells, RandomStream& random);

/// A dead tree that still stands, from before the valley was flooded; its limbs reach out 0.3
/// heights.
Object MakeDrownedTree(double height, RandomStream& random);
/// One span of a board fence along x, its post at the origin.
Object MakeFenceSpan(double length, RandomStream& random);
/// A piece of a jetty's deck: planks along y on beams along x, starting at the origin.
Object MakeDeck(double length, double width, RandomStream& random);
/// Bottles and cans, strewn over about a metre.
Object MakeLitter(RandomStream& random);

/// The whole object turned about z, tipped about its own x and y, and moved.
void PlaceObject(Object& object, const Eigen::Vector3d& position, double yaw, double tip_x = 0.0,
                 double tip_y = 0.0);

}  // namespace drydock::scenes::bus
