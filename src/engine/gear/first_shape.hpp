// A crude first shape, so that nobody gives coordinates.
//
// The gear is divided as coarsely as its seams allow. On that skeleton ropes and the lengthwise lines
// of panels are strings, the crosswise lines weak strings, pulled by weight, lift and a rough drag;
// string tensions are found that bring the lengths near their own (force densities, H.-J. Schek,
// Comput. Methods Appl. Mech. Eng. 3:115, 1974). The shape is then carried from the skeleton to the
// lattice.
#pragma once

#include <functional>
#include <vector>

#include "carry.hpp"
#include "parts.hpp"

namespace codend {

// A net of strings: see solve/layout.hpp, whose lay_out() is what a caller hands over to find its shape.
struct Strings {
  std::vector<char> held;
  std::vector<int> ends;
  std::vector<double> rest, tension, load;
  std::vector<char> buoyant;
};
// x: 3 per node (m); held nodes on entry, all on return.
using LayOut = std::function<void(const Strings&, double* x)>;

// Positions (m, 3 per node) of the nodes of `map`. shot: hung in water at rest from the rope that the
// gear is let go along, drawn out straight along x from 0, its netting as wide as it goes; every node's
// x then says when it is let go.
std::vector<double> first_shape(const Gear& gear, const PartMap& map, bool shot,
                                const LayOut& lay_out);

// Moves points out of the ground: what hangs below it is laid down along it, aft, so that lengths stay;
// plates that are not level stand upright with their foot above it.
void lay_on_ground(const Gear& gear, const std::vector<int>& points, std::vector<double>& position);

}  // namespace codend
