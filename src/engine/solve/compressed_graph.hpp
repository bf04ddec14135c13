// Graph without nodes of one or two neighbours, such as midpoints of bars and nodes along a rope.
#pragma once

#include <vector>

#include "../base/block_pattern.hpp"
#include "ordering.hpp"

namespace codend {

// Result of repeated elimination of nodes with at most two neighbours. Each round eliminates nodes
// that are not adjacent; the two neighbours of an eliminated node become adjacent. Nested
// dissection would eliminate these nodes in the same way, so the compression adds no fill.
struct CompressedGraph {
  struct Eliminated {
    int node;
    int neighbours[2];  // in the pattern, at that time; the second is -1 for a single neighbour
  };
  std::vector<int> node;               // of the pattern
  std::vector<int> weight;             // with parts of the eliminated nodes' weights
  std::vector<int> first;              // nodes + 1, into neighbour
  std::vector<int> neighbour;          // indices into node
  std::vector<Eliminated> eliminated;  // in order of elimination
};

CompressedGraph compress(const BlockPattern& pattern);

// Returns the tree of the pattern, in which each eliminated node is a separate vertex. tree: of the
// compressed graph; its nodes are indices into graph.node.
SeparatorTree expand(const CompressedGraph& graph, const SeparatorTree& tree);

}  // namespace codend
