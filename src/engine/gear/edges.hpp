// Edges of panels as a lattice divides them: chains of edges, breaks that seams carry from panel to
// panel, and the pieces between breaks, in classes that share one count of elements.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "gear.hpp"

namespace codend {

// Shares of an edge that are nearer than this are one.
constexpr double break_tolerance = 1e-7;

inline int opposite_edge(int edge) { return edge ^ 1; }

// All chains of a gear as one table, a row per link, the rows of a chain one after the other. First
// come those of seams that join edges, then of laced ropes, of pieces spread along edges, and of seams
// gathered in a place.
struct ChainTable {
  // Per row: its edge; the shares of that between which it runs, from > to where reversed; the shares
  // of the chain's stretched length there.
  std::vector<int> edge;
  std::vector<double> from, to, start, end;
  std::vector<int> first, rows;               // per chain: its first row and how many
  std::vector<int> seam_first, seam_count;    // per joining seam: its first chain and how many
  std::vector<int> laced, run;                // per rope, per piece: its chain, or -1
  std::vector<std::pair<int, int>> gathered;  // chain and the place that it is gathered in
  struct Held {
    int seam, chain;
    std::array<int, 2> points;
  };
  std::vector<Held> held;  // seams on the line between two points
  struct Mark {
    int edge;
    double share;
  };
  std::vector<Mark> marks;  // places at a share of a laced rope's length, on its edges

  int chains() const { return static_cast<int>(first.size()); }
  bool whole(int row) const;
  bool reversed(int row) const { return from[row] > to[row]; }
  double low(int row) const { return from[row] < to[row] ? from[row] : to[row]; }
  double high(int row) const { return from[row] < to[row] ? to[row] : from[row]; }
};
ChainTable chain_table(const Gear& gear);

// Stretched length (m) of an edge: the shortest way along its twines. Across i and down j meshes that
// is 2 max(i, j) bars in diamond netting and, i and j counting bars, i + j bars in square; hexagonal
// meshes are shorter across their straight bars.
double edge_length(const GearPanel& panel, int side);

// Things numbered 0, 1, ... along every edge (nodes, pieces) that lie in a row of the table: the first
// in the row's direction, 1 or -1, and how many.
struct Covered {
  std::vector<int> begin, way, number;
};
struct Thing {
  int row, k;  // of the table, along the edge
};
// inside(row, k): whether thing k of the row's edge lies in it; asked where it is not the whole edge.
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
// The things along a chain.
std::vector<Thing> along_chain(const ChainTable& chains, const Covered& covered, int chain);

// Breaks (shares, growing) of every edge, carried through seams and across panels until nothing
// changes. linked: panels whose opposite edges must be divided alike.
using Breaks = std::vector<std::vector<double>>;
Breaks edge_breaks(const ChainTable& chains, const std::vector<char>& linked);

// Pieces of all edges between their breaks, edge after edge.
struct EdgePieces {
  std::vector<int> edge;
  std::vector<double> from, to;
  std::vector<int> joined;           // pieces of one number have one count
  std::vector<int> first, count_of;  // per edge: pieces before its own, and of its own
  int count() const { return static_cast<int>(edge.size()); }
};
EdgePieces edge_pieces(const ChainTable& chains, const Breaks& breaks,
                       const std::vector<char>& linked);

// Numbers that are made the same: each group is known by its smallest.
class Joined {
 public:
  explicit Joined(int count);
  void join(int a, int b);
  int operator()(int a);

 private:
  std::vector<int> label_;
};

}  // namespace codend
