// Mesh size of a gear: elements per edge piece and per rope, and grouping of meshes in panels of
// bars. All follow from one element length h.
#pragma once

#include <vector>

#include "edges.hpp"

namespace codend {

// Upper limit of all counts.
constexpr int most_nodes = 2000000;

// Rounds a count to a whole number, at least one.
int at_least_one(double count);

// Meshes per equivalent mesh of every panel (computed also for panels of cells), and segments per
// equivalent bar.
struct Grouping {
  std::vector<double> lambda;
  std::vector<int> segments;

  template <class Visit>
  void fields(Visit& visit) {
    visit("lambda", lambda);
    visit("segments", segments);
  }
};

// Elements of every edge piece, and of every rope with its own nodes.
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

  // Returns the element length (m) at which the gear has about `nodes` nodes, within a sixth, and
  // its counts are nearly whole numbers.
  double element_length(double nodes) const;
  // Returns the smallest element length (m) with at most `nodes` nodes.
  double counted_length(double nodes) const;
  Counts counts(double h) const;
  // Approximate number of nodes at h of every panel, then of every rope.
  std::vector<double> node_counts(double h) const;
  // True if the gear defines the mesh of every panel and rope.
  bool is_divided() const;
  // Deviation of whole cell counts from the counts required by h: root mean square of the logarithm
  // of their ratio over all edges, weighted by the netting along them. In panels of few rows cells
  // change from wide to deep if a count increases by one, which changes the net opening by a
  // percent. element_length() therefore prefers nearly whole counts.
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
  std::vector<double> reach_, weight_, twines_;  // of pieces: m, m2, number of twine ends
  std::vector<double> asked_;                    // elements of a piece by the plan; 0: automatic
  bool any_bars_ = false;
};

}  // namespace codend
