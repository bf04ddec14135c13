// Approximate initial shape, so that the user does not need to provide coordinates.
//
// The gear is meshed as coarsely as its seams allow. On this skeleton ropes and the longitudinal
// lines of panels are strings, the transverse lines weak strings. Loads are weight, lift and an
// approximate drag. String tensions are computed that bring lengths near their rest lengths (force
// densities, H.-J. Schek, Comput. Methods Appl. Mech. Eng. 3:115, 1974). The shape is then
// interpolated to the final mesh.
#pragma once

#include <functional>
#include <vector>

#include "carry.hpp"
#include "parts.hpp"

namespace codend {

// A net of strings. The caller passes lay_out() of solve/layout.hpp to compute its shape.
struct Strings {
  std::vector<char> held;
  std::vector<int> ends;
  std::vector<double> rest, tension, load;
  std::vector<char> buoyant;
};
// x: 3 per node (m); fixed nodes on entry, all nodes on return.
using LayOut = std::function<void(const Strings&, double* x)>;

// Returns positions (m, 3 per node) of the nodes of `map`. shot: the gear hangs in still water from
// the rope along which it is shot. The rope is straight along x from 0, and the netting hangs at
// its full width. The x of a node then determines the time of its release.
std::vector<double> first_shape(const Gear& gear, const PartMap& map, bool shot,
                                const LayOut& lay_out);

// Moves points out of the ground. Points below it are moved up and aft along it, which preserves
// lengths. Plates that are not level are placed upright with their foot above the ground.
void lay_on_ground(const Gear& gear, const std::vector<int>& points, std::vector<double>& position);

}  // namespace codend
