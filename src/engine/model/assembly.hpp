// Residual and Jacobian of a model in its free nodes: what a solver sees.
#pragma once

#include <optional>
#include <vector>

#include "../elements/lines.hpp"
#include "block_places.hpp"
#include "model.hpp"

namespace codend {

// The dual unknowns of a solver: tension (N) and its change per strain (N) of one twine of every line; then normal force (N) and its
// change per penetration (N/m) of every contact with the ground.
struct DualTension {
  std::vector<double> tension, modulus;
};

// How lines change, to first order, when nodes move.
struct LineChange {
  double rotation = 0.0;    // largest change of any line's vector over its rest length
  double plate_turn = 0.0;  // and of any plate's sides
  double surfacing = 0.0;   // share of a body's buoyancy by which its slope at the surface misleads
  std::vector<double> strain;  // change of strain, per line; of penetration (m), per contact
};

class Assembly {
 public:
  // The model must outlive the assembly. Loads, masses, weights of pressure, the
  // current, its rates and the waves' time may change, rest lengths and multiplicities of bars too:
  // update() and update_bar() tell of it. Nothing else may.
  explicit Assembly(const Model& model);
  Assembly(const Assembly&) = delete;

  const Model& model() const { return model_; }
  // Free nodes, in the order of the unknowns.
  const std::vector<int>& free_nodes() const { return free_.nodes(); }
  int unknowns() const { return static_cast<int>(free_nodes().size()); }
  const BlockPattern& pattern() const { return blocks().pattern; }

  void update() { flow_known_ = false; }
  // rest_rate: dL0/dt over L0, 1/s.
  void update_bar(int bar, double rest_rate) { lines_.update_bar(bar, rest_rate); }

  // Free nodes that stay where they are, 1 each, until this is called again: no net force shows on
  // them and they do not move in a step of Newton's method whose right side is zero for them. Empty:
  // none. What acts on such nodes alone is not computed anew while they stay.
  void hold(const std::vector<char>& held);
  // The next move_to() computes all there is to be known of lines, for readers.
  void renew_still() {
    lines_.renew_still();
    flow_known_ = false;
  }
  // Whether a free node is held so.
  bool held_back(int node) const {
    return !held_back_.empty() && held_back_[static_cast<std::size_t>(node)];
  }

  // Takes positions x (m) and velocities v (m/s), 3 per node in the frame of the gear, and computes
  // what all the following share, which speak of them.
  void move_to(const double* x, const double* v);

  // Whether netting slows the water behind it.
  bool has_wake() const { return wake_.present(); }
  // Renews the wake at the gear's last positions, to be used from the next move_to() on (search and
  // tolerance: see Wake). Returns the largest change of any point's share of the free flow's speed.
  // Derivatives take the shares as given: the caller repeats until they no longer change.
  double renew_wake(bool search, double tolerance);
  // Keeps the wake to the sheets upstream of the gear's last positions, or to those and from where
  // another assembly of like sheets does (Wake::keep()).
  void keep_wake();
  void keep_wake_of(const Assembly& other);
  // Renews it while the gear moves: over a time (s) the shares go towards those of a new search as
  // fast as water takes to pass half of the wake sheets.
  void renew_wake_over(double time);
  const std::vector<double>& wake() const { return wake_.share(); }

  // Bows of cells' twines by the tensions of a solver (Lines), until the next move_to(): strains and
  // derivatives are then those that the solver needs.
  void bow_to(const DualTension& dual) { lines_.bow_to(dual.tension.data()); }
  // Adds to `strain` (per line) what bows change of strains (Lines::share_bows()).
  void share_bows(const DualTension& dual, const double* mismatch, const double* change,
                  double* strain) const {
    lines_.share_bows(dual.tension.data(), dual.modulus.data(), mismatch, change, strain);
  }
  // Adds to `sum` (N, per line) what these make of tensions.
  void add_bow_tensions(const DualTension& dual, const double* bow, double* sum) const {
    lines_.add_bow_tensions(dual.tension.data(), dual.modulus.data(), bow, sum);
  }
  // Adds to changes of strain what bows add that follow the law (Lines::change_bows()).
  void change_bows(double* strain) const { lines_.change_bows(strain); }

  // Net force (N) on every node, tied points' forces handed on; 3 per node.
  // dual: tensions that are unknowns of a solver, instead of the law's.
  void residual(double* force, const DualTension* dual = nullptr);
  // Number of times that move_to() has computed the forces.
  long long force_evaluations() const { return force_evaluations_; }

  // The pull (N) of tensions alone on every node; 3 per node.
  void pull_of(const DualTension& dual, double* force);

  // Net force (N) that may be left on every node of a motion: `share` of the sizes of the pulls, drags
  // and loads on it, and of a little of the gear's largest tension, and no less than what rounding of
  // the positions makes.
  void balance(double share, double* allowed);

  // stiffness * (-dF/dx) + damping * (-dF/dv) on the free nodes, 9 per block of the pattern.
  void jacobian(const JacobianRequest& request, double* values,
                const DualTension* dual = nullptr) const;

  // Adds a number per free node to the diagonal of its block.
  void add_diagonal(const double* numbers, double* values) const;

  // Mass and added mass at nodes, 9 each (row-major): all but that of bodies, which joins nodes.
  void mass(double* mass);
  // Mass, the nodes' as mass() gives it and that of bodies, times accelerations (m/s2, 3 per node):
  // N, 3 per node.
  void inertia(const double* mass, const double* acceleration, double* force);
  // Whether a node, or a point tied to it, is of a body; mass and added mass (kg) of the heaviest body.
  bool in_body(int node) const { return in_body_[static_cast<std::size_t>(node)]; }
  double heaviest_body() const;
  // Adds factor times all mass to a matrix, 9 per block of the pattern; mass: as mass() gives it.
  void add_mass(const double* mass, double factor, double* values) const;

  // Pseudo-time damping per free node, N s/m: drag at the present speed, or mass per second.
  void pseudo_damping(double* damping);
  // Of every line the drag (N) that one across the flow would have, with a coefficient of 1.2, by the flow
  // past its first point.
  void drag_across(std::vector<double>& drag) const;

  // Largest tension (N) of a rope or an equivalent bar; of one twine where there are only
  // cells (a cell may hold a fraction of a twine, whose tension says little).
  double largest_tension() const;

  // Tension of a bar, all its lines together, or of the rope that slides along it, N.
  double bar_pull(int bar) const;
  // At the bar's first point, where nothing else pulls: with the drag of its half there, and a load of
  // that half (N), beside the pull of its middle. A slack bar has none.
  double end_pull(int bar, const Vector& load) const;

  // Strain of every line, then penetration (m) of every contact.
  void strain(std::vector<double>& values) const;

  // Places of all that may lie on the ground: the points of contacts, then the shoes of plates; m.
  std::vector<Vector> ground_places() const;

  // How lines change when nodes move by dx (m, 3 per node); valid until the next call.
  const LineChange& line_change(const double* dx);

  // For readers: what is known of every line, and of all points, tied ones included; valid until
  // the next move_to().
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
  // The flow past the wake sheets, at their mean height, m/s.
  Vector flow_past_wake_sheets() const;
  // Adds the added mass of all elements to masses_.
  void gather_added_mass();
  // Adds what water that accelerates does to added mass to the loads.
  void add_push_of_water();
  const BlockLayout& blocks() const;
  // Adds the pull of tensions to what force_ has, and gives the sum, N.
  void add_pull(const double* tension, const double* normal_force, double* force);
  void spread(const double* nodes, std::vector<double>& points) const;
  void hand_on(double* values, int width) const;
  const Model& model_;
  const std::vector<const ElementKind*> kinds_;
  const FreePoints free_;
  Lines lines_;
  Wake wake_;
  // Of bars, of cells, of hexagonal triangles, of contacts, then one per kind. Made when a matrix is
  // first asked for: who only reads forces needs none.
  mutable std::optional<BlockLayout> blocks_;
  bool flow_known_ = false;
  long long force_evaluations_ = 0;
  std::vector<char> held_back_;
  std::vector<char> still_;  // per point: whether it is held back, or tied to such nodes alone
  LineChange change_;
  std::vector<WavePoint> waves_;  // per point, where the water moves in waves
  bool has_bodies_ = false;
  std::vector<char> in_body_;  // per node
  // Per point; load_: the model's and the forces of all kinds; masses_: none until they are asked for.
  std::vector<double> position_, velocity_, load_, force_, no_tension_, moved_, masses_, scale_;
};

}  // namespace codend
