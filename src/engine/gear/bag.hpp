// Panels that form a bag. Triangles of their cells, or of the sheets between their bars, can be in
// contact with its contents.
//
// A ring of n straight cells encloses a smaller area than a circle of the same girth, by the factor
// pi / (n tan(pi / n)). Pressure and volume use the area of the circle.
#pragma once

#include <vector>

#include "mesh.hpp"

namespace codend {

// Returns the triangles of the bag's panels. The initial shape of `mesh` determines outward
// normals.
BagTriangles bag_triangles(const Gear& gear, const Mesh& mesh);

// Moves the bag's netting in `start` (m, 3 per node) to a bag that hangs open at the nominal ratio
// and closes over its last third. From a slender cone a solver could pull twines through each
// other. held: fixed nodes, per node.
void round_bag(const Gear& gear, const std::vector<char>& held, const BagTriangles& bag,
               std::vector<double>& start);

}  // namespace codend
