// How finely a gear is divided: elements on every piece of edge and every rope, and the grouping of
// meshes in panels of bars, all from one element length h.
#pragma once

#include <vector>

#include "edges.hpp"

namespace codend {

// More than any lattice has.
constexpr int most_nodes = 2000000;

// A count as a whole number, at least one.
int at_least_one(double count);

// Meshes per equivalent mesh of every panel were it of bars, and segments per equivalent bar.
struct Grouping {
  std::vector<double> lambda;
  std::vector<int> segments;

  template <class Visit>
  void fields(Visit& visit) {
    visit("lambda", lambda);
    visit("segments", segments);
  }
};

// Elements of every piece of an edge and of every rope with nodes of its own.
struct Counts {
  std::vector<int> pieces, ropes;
  Grouping grouping;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("pieces", pieces);
    visit.list("ropes", ropes);
    visit.group("grouping", grouping);
  }
};

class Resolution {
 public:
  Resolution(const Gear& gear, const EdgePieces& pieces);

  // Element length (m) at which the gear has about `nodes` nodes, a sixth more or less, and its counts
  // are nearly whole.
  double element_length(double nodes) const;
  // The greatest element length with at most so many nodes.
  double counted_length(double nodes) const;
  Counts counts(double h) const;
  // About how many nodes a division at h has: of every panel, then of every rope.
  std::vector<double> node_counts(double h) const;
  // Whether the gear itself says how every panel and rope is divided.
  bool is_divided() const;
  // How far whole numbers of cells are from what h needs: the root mean square of the logarithm of
  // their ratio over all edges, by the netting along them. Panels of few rows turn from cells wider
  // than deep to deeper than wide where a count goes up, which moves a net's mouth by a percent; so
  // lattices are chosen where counts are nearly whole.
  double rounding(double h) const;

 private:
  Grouping grouping(double h) const;
  std::vector<int> piece_counts(double h, const Grouping* grouping) const;
  std::vector<int> rope_counts(double h) const;
  std::vector<double> wanted_counts(double h) const;
  double count_nodes(double h) const;
  template <class Value>
  std::vector<Value> largest_of_joined(const std::vector<Value>& x) const;

  const Gear& gear_;
  const EdgePieces& pieces_;
  std::vector<double> width_, depth_;            // m, of panels
  std::vector<double> reach_, weight_, twines_;  // of pieces: m, m2, twines that end there
  std::vector<double> asked_;                    // elements that the plan gives a piece; 0: none
  bool any_bars_ = false;
};

}  // namespace codend
