#pragma once

#include <functional>
#include <vector>

#include "../base/block_pattern.hpp"

namespace codend {

// A tree of separators. Each vertex has a higher number than its descendants. A node of the mesh is
// adjacent only to nodes of its vertex, and of the vertex's descendants and ancestors.
struct SeparatorTree {
  std::vector<int> parent;      // per vertex, -1 at a root; a disconnected mesh has several roots
  std::vector<int> first_node;  // vertices + 1: t owns node[first_node[t] .. first_node[t + 1])
  std::vector<int> node;        // every node of the mesh once
};

// Nested dissection (George 1973) of the compressed graph of a pattern. Each part is cut where the
// separator is small and the sides are nearly equal: across one coordinate, or across the distance
// along the graph from one end. The separator is then minimised near this cut.
//
// `pattern` must be valid (see check_pattern()). `coordinates` are 3n numbers, x y z per node. They
// only guide the cuts, so nodes may coincide. `pause` is called before every cut of a large part
// and may throw. Equal input returns the same tree; ties are broken by node number.
SeparatorTree nested_dissection(const BlockPattern& pattern, const double* coordinates,
                                const std::function<void()>& pause = {});

// Throws std::invalid_argument with the row if a row is not sorted, symmetric and with diagonal.
void check_pattern(const BlockPattern& pattern);

}  // namespace codend
