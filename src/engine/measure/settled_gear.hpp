// A gear settled from its numbers: coarsely first, from a crude layout of its own, each shape carried to
// the next finer lattice as its start. A gear that is let go along a rope hangs slack nearly everywhere:
// only coarsely divided does it settle from a crude layout, whatever it is settled with in the end. Where a
// catch is given by its volume the front moves by rows of meshes until the netting behind it encloses that.
#pragma once

#include <optional>

#include "../gear/carry_strains.hpp"
#include "../solve/settle.hpp"
#include "measure_errors.hpp"
#include "measured_gear.hpp"

namespace codend {

// A shape that a gear begins from: of itself or of one with the same parts, on any lattice.
struct BegunShape {
  std::vector<double> position;  // m, 3 per point, tied ones last
  std::vector<double> strain;    // of every line (Model::lines()); empty: not known
  PartMap map;
  LineMap lines;
  // How it was divided: for so many nodes, into these counts, which panels are of bars; and whether its
  // panels have the meshes of the gear's. As many nodes of the same panels are divided as here.
  double nodes = 0.0;
  Counts counts;
  std::vector<char> bars;
  bool same_meshes = true;
  // What slows the water there, and by how much every point's is; empty: nothing.
  WakeSheets wake_sheets;
  std::vector<double> wake;
  double blocked = 0.0;  // meshes of its bag behind the front; 0: it has none
  // Whether it is a balance, not of a gear in motion, and by how much the gear's drag is larger.
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
  double nodes = 1500;               // about how many, where the gear leaves that open
  const BegunShape* from = nullptr;  // null: a crude layout
  // Through coarser levels; else the gear itself from `from`.
  bool through_levels = true;
  double tolerance = 1e-8;  // largest net force over the largest tension
  int iterations = 300;     // steps of a level at most
  // Called with every lattice before it is settled; what it throws ends the settling.
  std::function<void(const Lattice&)> built;
  std::function<bool(const SettleProgress&)> watch;  // and
  std::function<void()> pause;                       // as in SettleControl
};

// A coarser lattice that was settled on the way.
struct SettledLevel {
  int nodes = 0;
  std::vector<double> measures;  // of the questions, SI
  SettleReport report;
  double seconds_lattice = 0.0;  // CPU
};

struct SettledGear {
  MeasuredGear gear;
  std::vector<double> position;      // m, 3 per node
  std::vector<double> strain;        // of every line
  std::vector<double> measures;      // of the questions, SI; none where there is no balance
  std::vector<SettledLevel> levels;  // from coarse to fine
  SettleReport report;               // steps of all fronts of a catch
  double seconds_lattice = 0.0;      // CPU
  // Where netting holds less than the catch, how much it holds when full (m3), and there is no balance.
  double full_bag = 0.0;
};

// Throws InputError where the numbers make no sense.
SettledGear settle_gear(const GearNumbers& numbers, const GearSettling& how);

// One more lattice of a gear that is settled with so many nodes, with nothing said of how finely it is
// divided, where those of the levels' nodes say too little of its errors (extra_nodes()); none where they do
// or where none settles. from: its settled shape; how: as it was settled. asked: nodes that it was asked
// for.
std::optional<SettledGear> extra_lattice(const GearNumbers& numbers, const GearSettling& how,
                                         const BegunShape& from, double nodes,
                                         const std::vector<double>& levels, double& asked);

// Standard errors that its lattice leaves in a settled gear's measures, SI, by its levels and, where these
// say too little, one more lattice that is settled here. how: as it was settled.
std::vector<double> errors_of(const GearNumbers& numbers, const GearSettling& how,
                              const SettledGear& found);

// Nodes of the levels below so many of a gear with netting, rising. Where the coarsest would be the only
// one and far off a second stands between: from the coarsest alone errors are told two to ten times too
// large, or, of what hardly changes by chance, too small.
std::vector<double> coarse_levels(double nodes);

}  // namespace codend
