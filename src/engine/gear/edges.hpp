// Edges of panels: chains of edges, breaks that seams transfer between panels, and pieces between
// breaks. Joined pieces have one common number of elements.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "gear.hpp"

namespace codend {

// Fractions of an edge that differ by less than this are equal.
constexpr double break_tolerance = 1e-7;

inline int opposite_edge(int edge) { return edge ^ 1; }

// All chains of a gear as one table with a row per link; rows of a chain are consecutive. Order:
// seams that join edges, laced ropes, pieces along edges, seams gathered in one point.
struct ChainTable {
  // Per row: the edge, the fractions of the edge between which it runs (from > to if reversed), and
  // the corresponding fractions of the chain's stretched length.
  std::vector<int> edge;
  std::vector<double> from, to, start, end;
  std::vector<int> first, rows;               // per chain: first row, number of rows
  std::vector<int> seam_first, seam_count;    // per joining seam: first chain, number of chains
  std::vector<int> laced, run;                // per rope and per piece: chain, or -1
  std::vector<std::pair<int, int>> gathered;  // chain, and location in which it is gathered
  struct Held {
    int seam, chain;
    std::array<int, 2> points;
  };
  std::vector<Held> held;  // seams on the line between two points
  struct Mark {
    int edge;
    double share;
  };
  std::vector<Mark> marks;  // locations at a fraction of a laced rope, on its edges

  int chains() const { return static_cast<int>(first.size()); }
  bool whole(int row) const;
  bool reversed(int row) const { return from[row] > to[row]; }
  double low(int row) const { return from[row] < to[row] ? from[row] : to[row]; }
  double high(int row) const { return from[row] < to[row] ? to[row] : from[row]; }
};
ChainTable chain_table(const Gear& gear);

// Stretched length (m) of an edge, the shortest path along its twines. Across i and down j meshes
// it is 2 max(i, j) bars in diamond netting, and i + j bars in square netting, where i and j count
// bars. Hexagonal meshes are shorter across their straight bars.
double edge_length(const GearPanel& panel, int side);

// Items numbered 0, 1, ... along every edge (nodes or pieces) that lie in a row of the table: the
// first in the row's direction, the direction (1 or -1), and the number.
struct Covered {
  std::vector<int> begin, way, number;
};
struct Thing {
  int row, k;  // row of the table, index along the edge
};
// inside(row, k): true if item k of the row's edge lies in the row. Used only for partial edges.
template <class Inside>
Covered covered(const ChainTable& chains, const std::vector<int>& number_on_edge, Inside inside) {
  Covered out;
  for (std::size_t row = 0; row < chains.edge.size(); ++row) {
    const int r = static_cast<int>(row);
    int low = 0, number = number_on_edge[chains.edge[row]];
    if (!chains.whole(r)) {
      int found = 0;
      for (int k = 0; k < number; ++k) {
        if (inside(r, k) && found++ == 0) low = k;
      }
      number = found;
    }
    out.begin.push_back(low + (chains.reversed(r) ? number - 1 : 0));
    out.way.push_back(chains.reversed(r) ? -1 : 1);
    out.number.push_back(number);
  }
  return out;
}
// Returns the items along a chain.
std::vector<Thing> along_chain(const ChainTable& chains, const Covered& covered, int chain);

// Breaks (increasing fractions) of every edge, propagated through seams and across panels until
// nothing changes. linked: panels whose opposite edges must have the same pieces.
using Breaks = std::vector<std::vector<double>>;
Breaks edge_breaks(const ChainTable& chains, const std::vector<char>& linked);

// Pieces of all edges between their breaks, edge after edge.
struct EdgePieces {
  std::vector<int> edge;
  std::vector<double> from, to;
  std::vector<int> joined;           // class of pieces with one common number of elements
  std::vector<int> first, count_of;  // per edge: preceding pieces, own pieces
  int count() const { return static_cast<int>(edge.size()); }
};
EdgePieces edge_pieces(const ChainTable& chains, const Breaks& breaks,
                       const std::vector<char>& linked);

// Disjoint sets (union-find). The smallest member represents each set.
class Joined {
 public:
  explicit Joined(int count);
  void join(int a, int b);
  int operator()(int a);

 private:
  std::vector<int> label_;
};

}  // namespace codend
