// Residual and Jacobian of a model in its free nodes: what a solver sees.
#pragma once

#include <memory>
#include <vector>

#include "model.hpp"
#include "solve/block_lu.hpp"

namespace codend {

// Tension (N) and its change per strain (N) of one twine of every line.
struct CarriedTension {
  std::vector<double> tension, modulus;
};

class Assembly {
 public:
  // The model must outlive the assembly and not change.
  explicit Assembly(const Model& model);
  ~Assembly();

  const Model& model() const { return model_; }
  // Free nodes, in the order of the unknowns.
  const std::vector<int>& free_nodes() const { return free_; }
  int unknowns() const { return static_cast<int>(free_.size()); }
  const BlockPattern& pattern() const { return pattern_; }

  // Net force (N) on every node, tied points' forces handed on; 3 per node.
  // x (m), v (m/s): 3 per node, in the frame of the gear. carried: tensions that a solver carries.
  void residual(const double* x, const double* v, double* force,
                const CarriedTension* carried = nullptr);

  // stiffness * (-dF/dx) + damping * (-dF/dv) on the free nodes, 9 per block of the pattern.
  void jacobian(const double* x, const double* v, const JacobianRequest& request, double* values,
                const CarriedTension* carried = nullptr);

  // Adds a number per free node to the diagonal of its block.
  void add_diagonal(const double* numbers, double* values) const;

  // Mass and added mass, 9 per node (row-major), at x.
  void mass(const double* x, const double* v, double* mass);

  // Pseudo-time damping per free node, N s/m: drag at the present speed, or mass per second.
  void pseudo_damping(const double* x, const double* v, double* damping);

  // Positions and velocities of all points, tied ones included; valid until the next call.
  Field field(const double* x, const double* v);

  // Largest change of any line's vector over its rest length when nodes move by dx.
  double largest_rotation(const double* dx);

  // Largest tension (N) of a rope or an equivalent bar; of one twine where there are only triangles
  // (a triangle may hold a fraction of a twine, whose tension says little).
  double largest_tension(const double* x);

  // Strain of every line at x, and its first-order change when nodes move from x by dx.
  void strain(const double* x, std::vector<double>& values);
  void strain_change(const double* x, const double* dx, std::vector<double>& values);

 private:
  class Sink;
  void spread(const double* nodes, std::vector<double>& points) const;
  void hand_on(double* values, int width) const;
  const Model& model_;
  std::vector<int> free_;           // unknown -> node
  std::vector<int> unknown_;        // node -> unknown, or -1
  BlockPattern pattern_;
  std::vector<int64_t> diagonal_;   // place of every diagonal block in the pattern
  std::vector<std::unique_ptr<Sink>> sinks_;  // one per kind
  std::vector<double> position_, velocity_, force_, change_, masses_, scale_;
};

}  // namespace codend
