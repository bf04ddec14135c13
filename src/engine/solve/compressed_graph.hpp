// A graph without its nodes of one or two neighbours: bar middles and the nodes along a rope.
#pragma once

#include <vector>

#include "../base/block_pattern.hpp"
#include "ordering.hpp"

namespace codend {

// What is left when, round by round, nodes of at most two neighbours are eliminated that do not
// touch one another; the two neighbours then touch. That is how a nested dissection would end
// there, so it costs no fill.
struct CompressedGraph {
  struct Eliminated {
    int node;
    int neighbours[2];  // of the pattern, at the time; the second is -1 where there was one
  };
  std::vector<int> node;               // of the pattern
  std::vector<int> weight;             // with their share of what was eliminated
  std::vector<int> first;              // nodes + 1, into neighbour
  std::vector<int> neighbour;          // places in node
  std::vector<Eliminated> eliminated;  // in turn
};

CompressedGraph compress(const BlockPattern& pattern);

// tree: of the compressed graph, whose nodes are places in graph.node. Returns the tree of the
// pattern, in which each eliminated node is a vertex of its own.
SeparatorTree expand(const CompressedGraph& graph, const SeparatorTree& tree);

}  // namespace codend
