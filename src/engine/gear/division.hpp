// Nodes of a lattice: points, ropes and panels number their own, and seams, laced ropes and places make
// them the same.
#pragma once

#include <string>
#include <vector>

#include "edges.hpp"

namespace codend {

// Nodes along a rope, a seam or a run of pieces, and their shares of its length.
struct NodeRun {
  std::vector<int> node;
  std::vector<double> at;

  template <class Visit>
  void fields(Visit& visit) {
    visit("node", node, {1, Among::nodes});
    visit("at", at);
  }
};

// Nodes along every edge of panels, edge after edge, and their shares of it.
struct EdgeNodes {
  std::vector<double> fraction;
  std::vector<int> edge_node;
  std::vector<int> count, before;  // per edge: nodes of its own, and before them

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("fraction", fraction);
    visit.list("edge_node", edge_node, {1, Among::nodes});
    visit.list("count", count);
    visit.list("before", before);
  }
  // Which of all nodes on edges begins the stretch between two nodes of its edge that x lies in.
  int cell_of(double x, int edge) const;
};

// The nodes of a panel of cells, row by row; empty: it is of bars.
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
  std::vector<NodeRun> ropes, runs;  // runs: of every piece spread along edges, else empty
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
  std::vector<Held> held_edges;  // of seams held on a line
  std::vector<int> places;       // node of every place (gear.hpp); points come first

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

// piece_counts: elements of every piece of an edge; rope_counts: of every rope with nodes of its own;
// bars: which panels are of bars.
Division divide(const Gear& gear, const ChainTable& chains, const EdgePieces& pieces,
                const std::vector<int>& piece_counts, const std::vector<int>& rope_counts,
                const std::vector<char>& bars);

}  // namespace codend
