// Solves for the equilibrium of a gear from its numbers. The solution starts on a coarse mesh from
// an approximate initial shape. Each shape is interpolated to the next finer mesh as its initial
// shape. A gear that is shot along a rope hangs almost entirely slack: it converges from an
// approximate shape only on a coarse mesh. If the catch is given by its volume, the front moves
// until the netting behind it encloses that volume.
//
// Without equilibrium, all levels are solved again on the gradual path (PathControl).
#pragma once

#include <optional>

#include "../gear/carry_strains.hpp"
#include "../solve/settle.hpp"
#include "measure_errors.hpp"
#include "measured_gear.hpp"

namespace codend {

// Initial shape of a gear: of itself or of a gear with the same parts, on any mesh.
struct InitialShape {
  std::vector<double> position;  // m, 3 per point, tied points last
  std::vector<double> strain;    // of every line (Model::lines()); empty: unknown
  PartMap map;
  LineMap lines;
  // Its mesh: requested nodes, counts, panels of bars. same_meshes: its panels have the netting
  // meshes of the gear. Equal nodes and panels then give an identical mesh.
  double nodes = 0.0;
  Counts counts;
  std::vector<char> bars;
  bool same_meshes = true;
  // Sheets that slow the water, and the speed fraction at every point; empty: none.
  WakeSheets wake_sheets;
  std::vector<double> wake;
  double blocked = 0.0;  // meshes of its bag behind the front; 0: no bag
  // settled: it is an equilibrium, not a state of motion. drag_growth: ratio of the gear's drag to
  // the drag at this shape.
  bool settled = false;
  double drag_growth = 1.0;

  template <class Visit>
  void fields(Visit& visit) {
    visit.list("position", position);
    visit.list("strain", strain);
    visit.group("map", map);
    visit.count(Among::points, position.size() / 3);
    visit.group("lines", lines);
    visit("nodes", nodes);
    visit.optional("counts", counts);
    visit.list("bars", bars);
    visit("same_meshes", same_meshes);
    visit.group("wake_sheets", wake_sheets);
    visit.list("wake", wake);
    visit("blocked", blocked);
    visit("settled", settled);
    visit("drag_growth", drag_growth);
  }
};

struct GearSettling {
  double nodes = 1500;                 // approximate number, unless the gear prescribes its mesh
  const InitialShape* from = nullptr;  // null: approximate initial shape
  // Solve on coarser mesh levels first; else solve the gear itself from `from`.
  bool through_levels = true;
  double tolerance = 1e-8;  // largest residual over the largest tension
  int iterations = 800;     // maximum iterations per level, on both paths
  // Called with every discretisation before it is solved; an exception from it ends the
  // computation.
  std::function<void(const Mesh&)> built;
  std::function<bool(const SettleProgress&)> watch;  // see SettleControl
  std::function<void()> pause;                       // see SettleControl
};

// A coarser mesh level that was solved on the way.
struct SettledLevel {
  int nodes = 0;
  std::vector<double> measures;  // of the questions, SI
  SettleReport report;
  double seconds_mesh = 0.0;  // CPU
};

struct SettledGear {
  MeasuredGear gear;
  std::vector<double> position;      // m, 3 per node
  std::vector<double> strain;        // of every line
  std::vector<double> measures;      // of the questions, SI; empty without equilibrium
  std::vector<SettledLevel> levels;  // from coarse to fine
  SettleReport report;               // iterations of all fronts of a catch
  double seconds_mesh = 0.0;         // CPU
  // If the bag cannot hold the catch: its volume when full, m3; there is no equilibrium then.
  double full_bag = 0.0;
};

// Throws InputError for inconsistent input.
SettledGear settle_gear(const GearNumbers& numbers, const GearSettling& how);

// Solves one more mesh of a gear solved with `nodes` nodes, without prescribed mesh sizes, if the
// node numbers in `levels` do not suffice for its errors (extra_nodes()). Empty if they do, or if
// none converges. from: its solved shape; how: the settings of its solution; `asked` returns the
// requested number of nodes.
std::optional<SettledGear> extra_mesh(const GearNumbers& numbers, const GearSettling& how,
                                      const InitialShape& from, double nodes,
                                      const std::vector<double>& levels, double& asked);

// Standard errors of a solved gear's measures due to its mesh, SI, from its mesh levels. If these
// do not suffice, one more mesh is solved here. how: the settings of its solution.
std::vector<double> errors_of(const GearNumbers& numbers, const GearSettling& how,
                              const SettledGear& found);

// Returns node numbers of the coarser mesh levels of a gear with netting, increasing. A second
// level is inserted if the coarsest would be the only one and far away. From the coarsest alone,
// errors are overestimated by factors of two to ten, or underestimated for measures that hardly
// change by chance.
std::vector<double> coarse_levels(double nodes);

}  // namespace codend
