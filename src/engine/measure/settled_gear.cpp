#include "settled_gear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "../gear/sums.hpp"
#include "../solve/stopwatch.hpp"

namespace codend {

namespace {

// Nodes of the coarsest mesh level, and ratio of nodes between levels.
constexpr double coarsest_nodes = 250, level_ratio = 7;

// Relative tolerance of the catch volume, and maximum number of fronts.
constexpr double catch_tolerance = 1e-6;
constexpr int most_fronts = 40;
// A front within this distance (logarithm of meshes) of a solved one starts from its shape.
constexpr double near_front = 0.2;

// The gear without prescribed mesh sizes. Poles keep their segments, because others would introduce
// kinks.
Gear undivided(Gear gear) {
  for (GearRope& rope : gear.ropes) {
    if (!rope.strut) rope.segments = 0;
  }
  for (GearPanel& panel : gear.panels) panel.columns = panel.rows = 0;
  return gear;
}

Gear of_cells(Gear gear) {
  for (GearPanel& panel : gear.panels) panel.bars = false;
  return gear;
}

std::vector<char> bars_of(const Gear& gear) {
  std::vector<char> out;
  for (const GearPanel& panel : gear.panels) out.push_back(panel.bars);
  return out;
}

// Identical sheets at the initial shape have the same wake.
bool same_sheets(const WakeSheets& a, const WakeSheets& b) {
  return a.node == b.node && a.twine_area == b.twine_area && a.overlap == b.overlap &&
         a.law == b.law;
}

struct Front {
  double front, off;  // logarithms of meshes; of volume over required volume
};

// The volume grows with a slowly varying power of the meshes behind the front. The next front is a
// secant step through the last two (at first: power 1), bounded by fronts with too small and too
// large volume.
double next_front(const Front& here, const std::optional<Front>& before,
                  const std::optional<Front>& low, const std::optional<Front>& high, double end) {
  double slope = 1.0;
  if (before) slope = (here.off - before->off) / (here.front - before->front);
  const double guess = here.front - here.off / slope;
  const double most = high ? high->front : std::min(here.front + 1, end);
  const double least = low ? low->front : here.front - 1;
  if (std::isfinite(guess) && guess > least && guess < most) return guess;
  return !low ? least : !high ? most : (least + most) / 2;
}

class LevelSettler {
 public:
  LevelSettler(const GearNumbers& numbers, const Gear& gear, const GearSettling& how, bool gradual,
               double nodes, const InitialShape* from)
      : numbers_(numbers), gear_(gear), how_(how), gradual_(gradual), from_(from) {
    {
      const Stopwatch watch(out_.seconds_mesh);
      build(nodes);
    }
    if (from_ && !from_->strain.empty()) {
      const PartMap map = part_map_of();
      strain_ = carry_strains(gear_, map, line_map(gear_, mesh()), from_->map, from_->lines,
                              from_->strain);
      for (double& strain : strain_) strain *= from_->drag_growth;
    }
  }

  SettledGear settled() {
    if (gear_.has_bag && numbers_.volume > 0) {
      find_front();
    } else {
      settle_once(nullptr);
    }
    out_.gear.model.wake = wake_;
    return std::move(out_);
  }

 private:
  const Mesh& mesh() const { return out_.gear.mesh; }
  PartMap part_map_of() const {
    return part_map(gear_, mesh().division, mesh().nodes, mesh().panels);
  }

  void build(double nodes) {
    Fineness fineness;
    fineness.nodes = nodes;
    FromShape shape;
    if (from_) {
      shape.given = true;
      shape.alike = from_->same_meshes && from_->nodes == nodes && from_->bars == bars_of(gear_);
      shape.position = from_->position;
      if (shape.alike) {
        fineness.counts = &from_->counts;
      } else {
        shape.map = from_->map;
      }
    }
    out_.gear = measured_gear(numbers_, gear_, fineness, shape, how_.pause);
    if (how_.built) how_.built(mesh());
    if (shape.alike && same_sheets(out_.gear.model.wake_sheets, from_->wake_sheets)) {
      out_.gear.model.wake = from_->wake;
    }
    start_ = !from_ ? Start::crude : Start::near;
    if (from_ && from_->settled && mesh().nodes == from_->map.nodes &&
        line_map(gear_, mesh()).alike(from_->lines)) {
      start_ = Start::settled;
    }
  }

  struct Shape {
    std::vector<double> position, strain;
  };

  // Solves from the initial shape, or from a solved shape of this gear.
  void settle_once(const Shape* shape) {
    Assembly assembly(out_.gear.model);
    SettleControl control;
    control.start = shape ? Start::settled : start_;
    control.strain = shape ? shape->strain : strain_;
    control.part = line_parts(mesh());
    control.tolerance = how_.tolerance;
    control.iterations = how_.iterations;
    control.watch = how_.watch;
    control.pause = how_.pause;
    out_.position = shape ? shape->position : mesh().start;
    const std::vector<double> still(out_.position.size(), 0.0);
    out_.report = settle(assembly, attempt(control, gradual_), still.data(), out_.position.data());
    assembly.strain(out_.strain);
    out_.strain.resize(static_cast<std::size_t>(out_.gear.model.lines()));
    wake_ = assembly.has_wake() ? assembly.wake() : std::vector<double>();
  }

  void set_front(double blocked) {
    out_.gear.bag.blocked = blocked;
    out_.gear.model.pressure.weight = pressure_weights(out_.gear.bag);
  }

  void find_front() {
    const double wanted = std::log(numbers_.volume), end = std::log(gear_.bag.deep);
    const bool known = from_ && from_->blocked > 0;
    double front = std::log(known ? from_->blocked : out_.gear.bag.blocked);
    std::optional<Front> low, high, before;
    Shape shape;
    SettleCost cost;
    for (int tried = 0; tried < most_fronts; ++tried) {
      set_front(std::exp(front));
      // Distant fronts start from the initial shape, because a distant solution misleads the
      // iteration. Near fronts start from the last solution: slack netting ahead of the front may
      // have several equilibria, and the volume must follow one equilibrium.
      const bool near = before && std::abs(front - before->front) < near_front;
      const Shape* const nothing = nullptr;
      for (const Shape* from : {near ? &std::as_const(shape) : nothing, nothing}) {
        settle_once(from);
        cost.add(out_.report);
        if (out_.report.converged || !from) break;
      }
      static_cast<SettleCost&>(out_.report) = cost;
      if (!out_.report.converged) return;
      const double volume = bag_volume(out_.gear.bag, all_points(out_.gear.model, out_.position));
      const double off =
          volume > 0 ? std::log(volume) - wanted : -std::numeric_limits<double>::infinity();
      if (std::abs(off) < catch_tolerance) return;
      if (off < 0 && front >= end) {
        out_.full_bag = volume;
        break;
      }
      const Front here{front, off};
      (off < 0 ? low : high) = here;
      front = next_front(here, before, low, high, end);
      before = here;
      shape = {out_.position, out_.strain};
    }
    out_.report.converged = false;
  }

  const GearNumbers& numbers_;
  const Gear& gear_;
  const GearSettling& how_;
  const bool gradual_;  // path (PathControl)
  const InitialShape* from_;
  Start start_ = Start::crude;
  std::vector<double> strain_, wake_;
  SettledGear out_;
};

// Returns a solved level as the initial shape of the next.
InitialShape shape_of(const SettledGear& found, const Gear& gear, double nodes) {
  const Mesh& mesh = found.gear.mesh;
  InitialShape out;
  out.position = all_points(found.gear.model, found.position);
  out.strain = found.strain;
  out.map = part_map(gear, mesh.division, mesh.nodes, mesh.panels);
  out.lines = line_map(gear, mesh);
  out.nodes = nodes;
  out.counts = mesh.counts;
  out.bars = bars_of(gear);
  out.wake_sheets = found.gear.model.wake_sheets;
  out.wake = found.gear.model.wake;
  if (gear.has_bag) out.blocked = found.gear.bag.blocked;
  return out;
}

std::vector<double> measures_of(const GearNumbers& numbers, const Gear& gear,
                                const SettledGear& found) {
  Assembly assembly(found.gear.model);
  return measures_at(numbers, gear, found.gear, assembly, found.position);
}

// Solves a gear through its levels, all on the direct or on the gradual path.
SettledGear settle_on_path(const GearNumbers& numbers, const GearSettling& how, bool gradual) {
  const Gear& gear = numbers.gear;
  const auto settle_level = [&](const Gear& of, double nodes, const InitialShape* from) {
    return LevelSettler(numbers, of, how, gradual, nodes, from).settled();
  };
  const InitialShape* from = how.from;
  std::vector<SettledLevel> levels;
  InitialShape shape;
  if (how.through_levels) {
    const Gear free = undivided(gear), cells = of_cells(free);
    const bool shot = gear.shot_along >= 0;
    if (shot) {
      const double nodes = std::min(how.nodes, coarsest_nodes);
      SettledGear first = settle_level(cells, nodes, from);
      if (!first.report.converged) return first;
      shape = shape_of(first, cells, nodes);
      // Strains on the coarsest mesh are useless.
      shape.strain.clear();
      from = &shape;
    }
    const NodeCounts count = count_nodes(gear, 1);
    const double nodes = count.divided ? std::min(how.nodes, exact_sum(count.nodes)) : how.nodes;
    std::vector<double> below;
    if (!gear.panels.empty()) {
      below = coarse_levels(nodes);
    } else if (shot || nodes > 2 * coarsest_nodes) {
      below.push_back(nodes / 4);
    }
    for (const double level : below) {
      const Gear& of = level == coarsest_nodes ? cells : free;
      const SettledGear found = settle_level(of, level, from);
      if (found.full_bag > 0) return found;
      if (!found.report.converged) continue;
      levels.push_back({found.gear.mesh.nodes, measures_of(numbers, of, found), found.report,
                        found.seconds_mesh});
      shape = shape_of(found, of, level);
      if (level <= coarsest_nodes) shape.strain.clear();
      from = &shape;
    }
  }
  SettledGear out = settle_level(gear, how.nodes, from);
  out.levels = std::move(levels);
  if (out.report.converged && !numbers.questions.measures.empty()) {
    out.measures = measures_of(numbers, gear, out);
  }
  return out;
}

}  // namespace

std::vector<double> coarse_levels(double nodes) {
  std::vector<double> out;
  for (double by = level_ratio; nodes / by > 2 * coarsest_nodes; by *= level_ratio) {
    out.insert(out.begin(), nodes / by);
  }
  if (out.empty() && nodes >= 4 * coarsest_nodes) out.push_back(std::sqrt(nodes * coarsest_nodes));
  if (nodes > 2 * coarsest_nodes) out.insert(out.begin(), coarsest_nodes);
  return out;
}

SettledGear settle_gear(const GearNumbers& numbers, const GearSettling& how) {
  const Gear& gear = numbers.gear;
  if (gear.has_bag && !(numbers.blocked > 0)) {
    throw InputError("blocked", "blocked must be positive");
  }
  if (how.from) {
    how.from->map.check(gear, how.from->position.size() / 3);
    how.from->lines.check(gear);
  }
  SettledGear direct = settle_on_path(numbers, how, false);
  if (direct.full_bag > 0 || !needs_gradual_path(direct.report, how.iterations)) return direct;
  SettledGear gradual = settle_on_path(numbers, how, true);
  gradual.report.add(direct.report);
  return gradual;
}

std::optional<SettledGear> extra_mesh(const GearNumbers& numbers, const GearSettling& how,
                                      const InitialShape& from, double nodes,
                                      const std::vector<double>& levels, double& asked) {
  const Gear free = undivided(numbers.gear);
  for (const double wanted : extra_nodes(nodes, levels, !free.panels.empty())) {
    asked = wanted;
    try {
      SettledGear found = LevelSettler(numbers, free, how, false, wanted, &from).settled();
      if (found.report.converged && differ_enough(nodes, found.gear.mesh.nodes)) return found;
    } catch (const InputError&) {
      // The next node number may give a valid mesh.
    }
  }
  return std::nullopt;
}

std::vector<double> errors_of(const GearNumbers& numbers, const GearSettling& how,
                              const SettledGear& found) {
  std::vector<double> levels;
  std::vector<MeasuredMesh> others;
  const auto add = [&](double nodes, std::vector<double> measures) {
    others.push_back({nodes, std::move(measures)});
  };
  for (const SettledLevel& level : found.levels) {
    levels.push_back(level.nodes);
    add(level.nodes, level.measures);
  }
  InitialShape shape = shape_of(found, numbers.gear, how.nodes);
  shape.settled = true;
  double asked = 0.0;
  const double nodes = found.gear.mesh.nodes;
  if (const auto extra = extra_mesh(numbers, how, shape, nodes, levels, asked)) {
    add(extra->gear.mesh.nodes, measures_of(numbers, undivided(numbers.gear), *extra));
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const auto& a, const auto& b) { return a.nodes < b.nodes; });
  std::vector<MeasureKind> kinds;
  for (const AskedMeasure& one : numbers.questions.measures) kinds.push_back(one.kind);
  return measure_errors(kinds, {nodes, found.measures}, std::move(others), how.tolerance);
}

}  // namespace codend
