// Nodes that swing: of a node that hangs by little a Newton step may turn the lines by more than a linear
// step can tell, where it hardly turns any other. Such nodes are settled by themselves, with all others
// held (nonlinear elimination: P. J. Lanzkron, D. J. Rose and J. T. Wilkes, An analysis of approximate
// nonlinear elimination, SIAM J. Sci. Comput. 17, 1996). As their net forces are then nil the next step
// is Newton's for the others, with these always in balance.
#pragma once

#include <utility>
#include <vector>

#include "../model/assembly.hpp"
#include "settle_control.hpp"

namespace codend {

class LocalBalance {
 public:
  // The model must outlive this.
  explicit LocalBalance(const Model& model);

  // Whether any node may be settled so.
  bool possible() const { return possible_; }

  // Into `found`: nodes that swing as nodes move by dx (m, 3 per node), free ones with nothing but bars,
  // knots and volumes. tension: the most of one twine of every bar before and after, N; load: all forces
  // on every node but tensions, N, 3 each. None where they are more than the control allows.
  void swinging(const double* dx, const std::vector<double>& tension, const double* load,
                const SwingControl& control, std::vector<int>& found) const;

  // Gives these nodes the mean of what the other ends of their bars have of dx.
  void carry(const std::vector<int>& nodes, double* dx) const;

  // Moves these nodes to their balance with all others at x (m, 3 per node), at velocities v; where it
  // is not found they stay.
  void settle(const std::vector<int>& nodes, const double* v, double* x) const;

  // visit(bar, its present strain) for all bars of these nodes, those between two of them twice.
  template <class Visit>
  void each_bar(const std::vector<int>& nodes, const double* x, Visit visit) const {
    for (const int node : nodes) {
      for (const int bar : bars_of(node)) {
        const std::size_t b = static_cast<std::size_t>(bar);
        const double length = change(b, x).norm();
        visit(b, length / model_.bars.rest[b] - 1.0);
      }
    }
  }

 private:
  struct Range {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };
  // Elements at one point each, by their nodes.
  class ByNode {
   public:
    void add(const std::vector<int>& nodes);
    template <class Visit>
    void each(int node, Visit visit) const;

   private:
    std::vector<std::pair<int, int>> element_;
  };

  Range bars_of(int node) const;
  int other_end(int bar, int node) const;
  // Of values of points (3 each), of which those of nodes are given.
  Vector value(int point, const double* values) const;
  Vector change(std::size_t bar, const double* values) const;
  Vector carried(int node, const double* dx) const;
  bool swings(int node, const double* dx, double turn) const;
  bool hangs(int node, const std::vector<double>& tension, const double* load, double most) const;
  void settle_group(const std::vector<int>& nodes, const double* v, double* x) const;

  const Model& model_;
  std::vector<char> alone_;  // per node: whether it may be settled so
  bool possible_;
  std::vector<int> first_, bar_;  // bars of every node
  ByNode spheres_, volumes_;
};

}  // namespace codend
