#include "settled_gear.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace codend {

namespace {

// Nodes of the coarsest level, and between how many there is one.
constexpr double coarsest_nodes = 250;
constexpr double too_many_nodes = 4 * coarsest_nodes;
// Steps of a level from a crude start, at most, of the last and of those before.
constexpr int last_steps = 600, coarse_steps = 200;

// The gear with nothing said of how finely it is divided, its netting as cells. Poles keep their
// segments: divided otherwise they would kink.
Gear undivided(Gear gear) {
  for (GearRope& rope : gear.ropes) {
    if (!rope.strut) rope.segments = 0;
  }
  for (GearPanel& panel : gear.panels) {
    panel.columns = panel.rows = 0;
    panel.bars = false;
  }
  return gear;
}

SettledGear settle_level(const GearNumbers& numbers, const Gear& gear, double nodes,
                         const FromShape& from, int steps) {
  SettledGear out;
  Fineness fineness;
  fineness.nodes = nodes;
  out.gear = measured_gear(numbers, gear, fineness, from);
  Assembly assembly(out.gear.model);
  SettleControl control;
  control.start = from.given ? Start::near : Start::crude;
  control.part = line_parts(out.gear.lattice);
  control.tolerance = 1e-8;
  control.iterations = steps;
  out.position = out.gear.lattice.start;
  const std::vector<double> still(out.position.size(), 0.0);
  out.report = settle(assembly, control, still.data(), out.position.data());
  if (assembly.has_wake()) out.gear.model.wake = assembly.wake();
  return out;
}

}  // namespace

SettledGear settle_gear(const GearNumbers& numbers, double nodes) {
  const Gear& gear = numbers.gear;
  if (nodes >= too_many_nodes) throw InputError("nodes", "nodes must be below 1000");
  if (gear.shot_along >= 0) throw InputError("shot_along", "a gear that is let go is not settled");
  if (gear.has_bag && !(numbers.blocked > 0))
    throw InputError("blocked", "blocked must be positive");
  const NodeCounts count = count_nodes(gear, 1);
  const double fixed = count.divided ? std::accumulate(count.nodes.begin(), count.nodes.end(), 0.0)
                                     : std::numeric_limits<double>::infinity();
  FromShape from;
  if (!gear.panels.empty() && std::min(nodes, fixed) > 2 * coarsest_nodes) {
    const Gear free = undivided(gear);
    const SettledGear coarse = settle_level(numbers, free, coarsest_nodes, {}, coarse_steps);
    if (coarse.report.converged) {
      from.given = true;
      from.map = part_map(free, coarse.gear.lattice.division, coarse.gear.lattice.nodes,
                          coarse.gear.lattice.panels);
      from.position = all_points(coarse.gear.model, coarse.position);
    }
  }
  SettledGear out = settle_level(numbers, gear, nodes, from, last_steps);
  Assembly assembly(out.gear.model);
  out.measures = measures_at(numbers, gear, out.gear, assembly, out.position);
  return out;
}

}  // namespace codend
