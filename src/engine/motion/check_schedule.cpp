#include "check_schedule.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../base/error.hpp"

namespace codend {
namespace {

using Numbers = std::vector<double>;

[[noreturn]] void fail(const std::string& field, const std::string& what) {
  throw InputError(field, field + " " + what);
}

std::string item(const std::string& field, std::size_t k) {
  return field + "[" + std::to_string(k + 1) + "]";
}

void check_finite(const Numbers& values, const std::string& field) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) fail(item(field, k), "must be a finite number");
  }
}

void check_count(std::size_t count, std::size_t wanted, const std::string& field) {
  if (count == wanted) return;
  fail(field, "has " + std::to_string(count) + " values, must have " + std::to_string(wanted));
}

void check_numbers(const Numbers& values, std::size_t wanted, const std::string& field) {
  check_count(values.size(), wanted, field);
  check_finite(values, field);
}

void check_at_least(double value, double least, const std::string& field) {
  if (value >= least) return;
  fail(field, "must be " + std::to_string(least) + " or more");
}

}  // namespace

void check_curve(const Curve& curve, const std::string& field) {
  const std::size_t pieces = curve.begin.size();
  if (pieces == 0) fail(field, "must have a piece");
  check_numbers(curve.time, pieces + 1, field + ".time");
  for (std::size_t k = 0; k < pieces; ++k) {
    if (!(curve.time[k] < curve.time[k + 1])) fail(field + ".time", "must increase");
  }
  check_finite(curve.begin, field + ".begin");
  check_numbers(curve.end, pieces, field + ".end");
  check_numbers(curve.begin_rate, pieces, field + ".begin_rate");
  check_numbers(curve.end_rate, pieces, field + ".end_rate");
}

namespace {

void check_motion(const PrescribedMotion& motion, const std::string& field) {
  check_count(motion.place.size(), motion.node.size(), field + ".place");
  for (std::size_t k = 0; k < motion.place.size(); ++k) {
    if (!motion.place[k].allFinite()) fail(item(field + ".place", k), "must be finite numbers");
  }
  if (motion.node.empty() && motion.x.time.empty()) return;
  check_curve(motion.x, field + ".x");
  check_curve(motion.y, field + ".y");
  check_curve(motion.z, field + ".z");
  check_curve(motion.heading, field + ".heading");
  const Swing& swing = motion.swing;
  if (!swing.centre.allFinite()) fail(field + ".swing.centre", "must be finite numbers");
  if (!swing.by_time.empty()) check_count(swing.by_time.size(), 6, field + ".swing.by_time");
  for (std::size_t k = 0; k < swing.by_time.size(); ++k) {
    check_curve(swing.by_time[k], item(field + ".swing.by_time", k));
  }
  check_finite(swing.even, field + ".swing.even");
  check_numbers(swing.odd, swing.even.size(), field + ".swing.odd");
}

void check_control(const LengthControl& control, const std::string& field) {
  check_curve(control.target, field + ".target");
  const std::pair<const char*, double> finite[] = {{"target_speed", control.target_speed},
                                                   {"stiffness", control.stiffness},
                                                   {"full_length", control.full_length},
                                                   {"least_length", control.least_length},
                                                   {"length", control.length},
                                                   {"since", control.since},
                                                   {"speed", control.speed}};
  for (const auto& [name, value] : finite) {
    if (!std::isfinite(value)) fail(field + "." + name, "must be a finite number");
  }
  check_at_least(control.speed_limit, 0.0, field + ".speed_limit");
  check_at_least(control.tension_limit, 0.0, field + ".tension_limit");
  check_at_least(control.stiffness, 0.0, field + ".stiffness");
  check_at_least(control.most_length, control.least_length, field + ".most_length");
  if (!(control.full_length > 0.0)) fail(field + ".full_length", "must be above 0");
  if (!(control.length > 0.0)) fail(field + ".length", "must be above 0");
}

void check_group(const GrowingGroup& group, const std::string& field) {
  if (group.controlled) {
    check_control(group.control, field + ".control");
  } else {
    check_curve(group.factor, field + ".factor");
  }
  check_numbers(group.rest, group.bars.size(), field + ".rest");
  check_numbers(group.mass, group.points.size(), field + ".mass");
  check_numbers(group.load, group.points.size(), field + ".load");
  check_numbers(group.drag_area, group.spheres.size(), field + ".drag_area");
  check_numbers(group.added_mass, group.spheres.size(), field + ".added_mass");
  check_numbers(group.buoyancy, group.volumes.size(), field + ".buoyancy");
}

void check_place(int place, int count, const std::string& field, const char* among) {
  if (place >= 0 && place < count) return;
  fail(field, "must be one of the " + std::to_string(count) + " " + among + " of the model");
}

void check_places(const std::vector<int>& places, int count, const std::string& field,
                  const char* among) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    check_place(places[k], count, item(field, k), among);
  }
}

}  // namespace

void check_schedule(const Schedule& schedule) {
  check_motion(schedule.motion, "schedule.motion");
  const Release& release = schedule.release;
  check_count(release.time.size(), release.node.size(), "schedule.release.time");
  for (std::size_t k = 0; k < release.time.size(); ++k) {
    if (std::isnan(release.time[k])) fail(item("schedule.release.time", k), "must be a number");
  }
  for (std::size_t k = 0; k < schedule.growing.size(); ++k) {
    check_group(schedule.growing[k], item("schedule.growing", k));
  }
  check_count(schedule.current_y.size(), schedule.current_x.size(), "schedule.current_y");
  for (std::size_t k = 0; k < schedule.current_x.size(); ++k) {
    check_curve(schedule.current_x[k], item("schedule.current_x", k));
    check_curve(schedule.current_y[k], item("schedule.current_y", k));
  }
  for (std::size_t k = 0; k < schedule.ruptures.size(); ++k) {
    const Rupture& rope = schedule.ruptures[k];
    const std::string field = item("schedule.ruptures", k);
    if (std::isnan(rope.time)) fail(field + ".time", "must be a number");
    if (std::isnan(rope.strength)) fail(field + ".strength", "must be a number");
    check_finite({rope.broken_at}, field + ".broken_at");
  }
}

void check_schedule(const Schedule& schedule, const Model& model) {
  check_schedule(schedule);
  check_places(schedule.motion.node, model.nodes, "schedule.motion.node", "nodes");
  check_places(schedule.release.node, model.nodes, "schedule.release.node", "nodes");
  for (std::size_t k = 0; k < schedule.growing.size(); ++k) {
    const GrowingGroup& group = schedule.growing[k];
    const std::string field = item("schedule.growing", k);
    check_places(group.bars, model.bars.count(), field + ".bars", "bars");
    check_places(group.points, model.points(), field + ".points", "points");
    check_places(group.spheres, static_cast<int>(model.spheres.node.size()), field + ".spheres",
                 "spheres");
    check_places(group.volumes, static_cast<int>(model.volumes.buoyancy.size()), field + ".volumes",
                 "volumes");
    if (group.controlled) {
      check_place(group.control.bar, model.bars.count(), field + ".control.bar", "bars");
    }
  }
  if (!schedule.sticking.anchor.empty()) {
    // Old files contain no anchors for the shoes of plates.
    const std::size_t contacts = 3 * model.contacts.node.size(),
                      shoes = 6 * model.plates.plate.size();
    const bool alone = schedule.sticking.anchor.size() == contacts;
    check_numbers(schedule.sticking.anchor, alone ? contacts : contacts + shoes,
                  "schedule.sticking.anchor");
  }
  if (!schedule.motion.swing.even.empty()) {
    check_count(schedule.motion.swing.even.size(), 6 * model.water.waves.amplitude.size(),
                "schedule.motion.swing.even");
  }
  if (!schedule.current_x.empty()) {
    check_count(schedule.current_x.size(), model.water.current.size(), "schedule.current_x");
  }
  for (std::size_t k = 0; k < schedule.ruptures.size(); ++k) {
    const Rupture& rope = schedule.ruptures[k];
    const std::string field = item("schedule.ruptures", k);
    check_places(rope.bars, model.bars.count(), field + ".bars", "bars");
    check_place(rope.at, model.bars.count(), field + ".at", "bars");
    if (rope.broken != -1) {
      check_place(rope.broken, model.bars.count(), field + ".broken", "bars");
    }
  }
}

}  // namespace codend
