#pragma once

#include <functional>
#include <vector>

#include "../base/block_pattern.hpp"

namespace codend {

// A tree of separators. Its vertices are numbered so that each comes after its descendants, and a
// node of the mesh touches only nodes of its own vertex, of that vertex's descendants or ancestors.
struct SeparatorTree {
  std::vector<int> parent;      // per vertex, -1 at a root; a disconnected mesh has several roots
  std::vector<int> first_node;  // vertices + 1: t owns node[first_node[t] .. first_node[t + 1])
  std::vector<int> node;        // every node of the mesh once
};

// Nested dissection (George 1973) of the graph of a pattern, compressed first. Each part is cut
// where few nodes touch the cut and the sides are about equal: across one coordinate, or across the
// distance along the graph from one of its ends. The separator is then a least one near that cut.
//
// pattern: valid (see check_pattern); coordinates: 3n doubles, x y z of each node. They only guide
// the cuts: nodes may coincide, and the order stays usable when all of them do.
// pause: called before every cut of a large part; may throw.
// Returns the same tree for the same input, ties being broken by node number.
SeparatorTree nested_dissection(const BlockPattern& pattern, const double* coordinates,
                                const std::function<void()>& pause = {});

// Throws std::invalid_argument, naming the row, if `pattern` breaks its own description.
void check_pattern(const BlockPattern& pattern);

}  // namespace codend
