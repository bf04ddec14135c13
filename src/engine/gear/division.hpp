// Nodes of a discretisation. Points, ropes and panels have separate numbers; seams, laced ropes and
// locations join them.
#pragma once

#include <string>
#include <vector>

#include "edges.hpp"

namespace codend {

// Nodes along a rope, a seam or a run of pieces, and their fractions of its length.
struct NodeRun {
  std::vector<int> node;
  std::vector<double> at;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::nodes});
    visit("at", at);
  }
};

// Nodes along all edges of panels, edge after edge, and their fractions of the edge.
struct EdgeNodes {
  std::vector<double> fraction;
  std::vector<int> edge_node;
  std::vector<int> count, before;  // per edge: number of nodes, and of preceding nodes

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("fraction", fraction);
    visit.list("edge_node", edge_node, {1, Among::nodes});
    visit.list("count", count);
    visit.list("before", before);
  }
  // Returns the index of the node of `edge` that begins the interval containing x.
  int cell_of(double x, int edge) const;
};

// Nodes of a panel of cells, row by row; empty for a panel of bars.
struct Grid {
  int columns = 0;
  std::vector<int> node;

  template <class Visit>
  void fields(Visit& visit) {
    visit("columns", columns);
    visit.list("node", node, {1, Among::nodes});
  }
};

struct Division {
  int nodes = 0;
  EdgeNodes edges;
  std::vector<Grid> grids;
  std::vector<NodeRun> ropes, runs;  // runs: of pieces along edges, else empty
  struct Held : NodeRun {
    int seam = 0;
    std::array<int, 2> points = {0, 0};

    template <class Visit>
    void fields(Visit& visit) {
      NodeRun::fields(visit);
      visit("seam", seam);
      visit("points", points, {1, Among::places});
    }
  };
  std::vector<Held> held_edges;  // of seams fixed on a line
  std::vector<int> places;       // node of every location (gear.hpp); points come first

  template <class Visit>
  void fields(Visit& visit) {
    visit("nodes", nodes);
    visit.count(Among::nodes, static_cast<std::size_t>(nodes));
    visit.group("edges", edges);
    visit.items("grids", grids);
    visit.items("ropes", ropes);
    visit.items("runs", runs);
    visit.items("held_edges", held_edges);
    visit.list("places", places, {1, Among::nodes});
  }
};

// Creates the nodes. piece_counts: elements per edge piece; rope_counts: elements per rope with its
// own nodes; bars: true for panels of bars.
Division divide(const Gear& gear, const ChainTable& chains, const EdgePieces& pieces,
                const std::vector<int>& piece_counts, const std::vector<int>& rope_counts,
                const std::vector<char>& bars);

}  // namespace codend
