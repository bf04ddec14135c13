// Panels that are a bag: which triangles of their cells, or of the sheets between their bars, what
// gathers inside may lie against.
//
// A ring of n straight cells encloses less than the circle of its girth: its area is less by
// n tan(pi / n) / pi. Pressure and volume count with the circle's.
#pragma once

#include <vector>

#include "lattice.hpp"

namespace codend {

// The lattice's start says which way is out.
BagTriangles bag_triangles(const Gear& gear, const Lattice& lattice);

// The start with the netting of the bag as one that hangs open at the nominal ratio and closes over its
// last third: from a slender cone a solver may pull its twines through each other.
void round_bag(const Gear& gear, const std::vector<char>& held, const BagTriangles& bag,
               std::vector<double>& start);

}  // namespace codend
