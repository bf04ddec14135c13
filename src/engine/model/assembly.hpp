// Assembles the residual and the Jacobian of a model over its free nodes.
#pragma once

#include <optional>
#include <vector>

#include "../elements/lines.hpp"
#include "block_places.hpp"
#include "model.hpp"

namespace codend {

// Dual unknowns of a solver: tension (N) of one twine per line, then normal force (N) per ground
// contact. The moduli are their derivatives by strain (N) and by penetration (N/m).
struct DualTension {
  std::vector<double> tension, modulus;
};

// First-order changes of lines when nodes move.
struct LineChange {
  double rotation = 0.0;    // largest change of a line's vector, per rest length
  double plate_turn = 0.0;  // largest change of a plate's side, per side length
  double surfacing = 0.0;   // largest error of a linearised buoyancy at the surface, per buoyancy
  std::vector<double> strain;  // change of strain per line, of penetration (m) per contact
};

class Assembly {
 public:
  // The model must outlive the assembly. Loads, masses, pressure weights, the current, its rates
  // and the time of the waves may change; then call update(). Rest lengths and multiplicities of
  // bars may change; then call update_bar(). Everything else must stay constant.
  explicit Assembly(const Model& model);
  Assembly(const Assembly&) = delete;

  const Model& model() const { return model_; }
  // Free nodes in the order of the unknowns.
  const std::vector<int>& free_nodes() const { return free_.nodes(); }
  int unknowns() const { return static_cast<int>(free_nodes().size()); }
  const BlockPattern& pattern() const { return blocks().pattern; }

  void update() { flow_known_ = false; }
  // rest_rate: dL0/dt over L0, 1/s.
  void update_bar(int bar, double rest_rate) { lines_.update_bar(bar, rest_rate); }

  // Fixes free nodes (1 per fixed node) until the next call; an empty vector fixes none. The
  // residual of a fixed node is zero. A Newton step with a zero right side for it does not move it.
  // Elements with only fixed nodes are not updated meanwhile.
  void hold(const std::vector<char>& held);
  // Makes the next move_to() update all lines, including lines between fixed nodes.
  void renew_still() {
    lines_.renew_still();
    flow_known_ = false;
  }
  // True if hold() fixes this free node.
  bool held_back(int node) const {
    return !held_back_.empty() && held_back_[static_cast<std::size_t>(node)];
  }

  // Sets positions x (m) and velocities v (m/s), 3 per node in the frame of the gear, and updates
  // the forces. All functions below refer to this state.
  void move_to(const double* x, const double* v);

  bool has_wake() const { return wake_.present(); }
  // Updates the wake at the present positions (search and tolerance: see Wake); the next move_to()
  // uses it. Returns the largest change of a point's speed fraction. Derivatives treat the
  // fractions as constant, so the caller iterates until they converge.
  double renew_wake(bool search, double tolerance);
  // Fixes the set of wake sheets upstream of each point: at the present positions, or as in another
  // assembly with equal sheets (Wake::keep()).
  void keep_wake();
  void keep_wake_of(const Assembly& other);
  // Updates the wake of a moving gear after a time (s). The fractions relax towards a new search;
  // the time constant is the transit time through half of the wake sheets.
  void renew_wake_over(double time);
  const std::vector<double>& wake() const { return wake_.share(); }

  // Sets the sag of cell twines from a solver's tensions (Lines), until the next move_to(). Strains
  // and derivatives then belong to this sag.
  void sag_to(const DualTension& dual) { lines_.sag_to(dual.tension.data()); }
  // Adds the strain changes due to sag to `strain`, per line (Lines::distribute_sag()).
  void distribute_sag(const DualTension& dual, const double* mismatch, const double* change,
                      double* strain) const {
    lines_.distribute_sag(dual.tension.data(), dual.modulus.data(), mismatch, change, strain);
  }
  // Adds the tension changes due to sag to `sum` (N, per line).
  void add_sag_tensions(const DualTension& dual, const double* sag, double* sum) const {
    lines_.add_sag_tensions(dual.tension.data(), dual.modulus.data(), sag, sum);
  }
  // Adds the strain changes due to sag in equilibrium to `strain` (Lines::change_sag()).
  void change_sag(double* strain) const { lines_.change_sag(strain); }

  // Computes the net force (N, 3 per node); forces on tied points are distributed to their nodes.
  // dual: a solver's tensions; null selects the constitutive law.
  void residual(double* force, const DualTension* dual = nullptr);
  long long force_evaluations() const { return force_evaluations_; }

  // Computes the nodal forces of tensions alone (N, 3 per node).
  void pull_of(const DualTension& dual, double* force);

  // Computes the allowed residual (N) of every node. It is `share` times the sum of the tensions,
  // drags and loads on the node, plus a small fraction of the gear's largest tension. Rounding
  // errors of the positions, as forces, are added.
  void balance(double share, double* allowed);

  // Computes stiffness * (-dF/dx) + damping * (-dF/dv) over the free nodes, 9 per block.
  void jacobian(const JacobianRequest& request, double* values,
                const DualTension* dual = nullptr) const;

  // Adds one number per free node to the diagonal of its block.
  void add_diagonal(const double* numbers, double* values) const;

  // Computes mass and added mass (kg, 9 per node), without bodies, whose mass couples nodes.
  void mass(double* mass);
  // Computes mass times acceleration (N, 3 per node). mass: from mass(); the mass of bodies is
  // added. acceleration: m/s2, 3 per node.
  void inertia(const double* mass, const double* acceleration, double* force);
  // True if a node, or a point tied to it, belongs to a body.
  bool in_body(int node) const { return in_body_[static_cast<std::size_t>(node)]; }
  double heaviest_body() const;
  // Adds factor * (mass and mass of bodies), 9 per block. mass: from mass().
  void add_mass(const double* mass, double factor, double* values) const;

  // Returns the time (s) of free fall over the gear's radius at positions x, the largest distance of
  // a node from the mean of all nodes; 1 if all nodes coincide.
  double fall_time(const double* x) const;
  // Computes the damping per free node over a pseudo time step of `time` (s), N/m: drag damping
  // plus mass over `time`.
  void pseudo_damping(double time, double* damping);
  // Computes the drag (N) of every line, as if normal to the flow with a coefficient of 1.2. The
  // flow speed is taken at the line's first point.
  void drag_across(std::vector<double>& drag) const;

  // Returns the largest tension (N) of a bar (all lines) or sliding rope. In a model without bars
  // it is the largest tension of one twine, because a cell can represent a fraction of a twine.
  double largest_tension() const;

  // Returns the tension (N) of a bar, all lines together, plus ropes that slide along it.
  double bar_pull(int bar) const;
  // Returns the tension (N) at the free first point of a bar: the sum of the pull at its middle,
  // the drag of its first half, and a load (N). A slack bar returns its pull.
  double end_pull(int bar, const Vector& load) const;

  // Computes the strain of every line, then the penetration (m) of every contact.
  void strain(std::vector<double>& values) const;

  // Returns all points that can touch the ground (m): contacts, then shoes of plates.
  std::vector<Vector> ground_places() const;

  // Returns the changes of lines when nodes move by dx (m, 3 per node). Valid until the next call.
  const LineChange& line_change(const double* dx);

  // State of all lines, and of all points with tied points. Valid until the next move_to().
  const LineArrays& lines() const { return lines_.arrays(); }
  Field field() const {
    return {position_.data(),
            velocity_.data(),
            &model_.water,
            has_wake() ? wake().data() : nullptr,
            &model_.ground,
            &model_.bars,
            model_.water.waves.running() ? waves_.data() : nullptr,
            still_.empty() ? nullptr : still_.data()};
  }

 private:
  // Returns the mean flow relative to the wake sheets, at their mean height, m/s.
  Vector flow_past_wake_sheets() const;
  void gather_added_mass();
  void add_push_of_water();
  const BlockLayout& blocks() const;
  // Adds tensions and normal forces to force_, and copies the nodal sum (N) to `force`.
  void add_pull(const double* tension, const double* normal_force, double* force);
  void spread(const double* nodes, std::vector<double>& points) const;
  void hand_on(double* values, int width) const;
  const Model& model_;
  const std::vector<const ElementKind*> kinds_;
  const FreePoints free_;
  Lines lines_;
  Wake wake_;
  // Order: bars, cells, hexagonal triangles, contacts, then one per kind. Built on first use,
  // because force computations do not need it.
  mutable std::optional<BlockLayout> blocks_;
  bool flow_known_ = false;
  long long force_evaluations_ = 0;
  std::vector<char> held_back_;
  std::vector<char> still_;  // per point: 1 if fixed by hold(), or tied only to such nodes
  LineChange change_;
  std::vector<WavePoint> waves_;  // per point; empty without waves
  bool has_bodies_ = false;
  std::vector<char> in_body_;  // per node
  // Per point. load_ includes the forces of all kinds of elements.
  std::vector<double> position_, velocity_, load_, force_, no_tension_, moved_, masses_, scale_;
};

}  // namespace codend
