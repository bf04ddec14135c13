// R interface: schedules and their values at given times.
#include "binding_schedule.h"

#include "binding_model.h"
#include "engine/motion/check_schedule.hpp"
#include "engine/motion/scheduled_conditions.hpp"

using namespace binding;

namespace {

// Reads structs of a schedule (motion/schedule.hpp) from an R list with the same names.
// check_schedule() checks the values.
class ScheduleReader {
 public:
  explicit ScheduleReader(const list& from) : from_(from) {}

  void operator()(const char* name, double& to) { to = number(from_, name); }
  void operator()(const char* name, bool& to) { to = as_cpp<bool>(from_[name]); }
  void operator()(const char* name, std::vector<double>& to) { to = numbers(from_, name); }
  void operator()(const char* name, std::vector<codend::Vector>& to) {
    const std::vector<double> flat = numbers(from_, name);
    for (std::size_t k = 0; 3 * k + 2 < flat.size(); ++k) {
      to.emplace_back(flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]);
    }
  }
  void operator()(const char* name, codend::Vector& to) {
    const std::vector<double> flat = numbers(from_, name);
    if (flat.size() != 3) throw codend::InputError(name, std::string(name) + " must be 3 numbers");
    to = codend::Vector(flat[0], flat[1], flat[2]);
  }
  // R counts from 1; 0 means none.
  void place(const char* name, int& to) { to = binding::place(from_, name); }
  void place(const char* name, std::vector<int>& to) { to = places(from_, name); }

  template <class Struct>
  void group(const char* name, Struct& to) {
    read(list(from_[name]), to);
  }
  template <class Struct>
  void optional(const char* name, Struct& to, bool& given) {
    given = !Rf_isNull(from_[name]);
    if (given) group(name, to);
  }
  template <class Struct>
  void optional(const char* name, Struct& to) {
    bool given;
    optional(name, to, given);
  }
  template <class Struct>
  void items(const char* name, std::vector<Struct>& to) {
    for (const list item : list(from_[name])) read(item, to.emplace_back());
  }

  template <class Struct>
  static void read(const list& from, Struct& to) {
    ScheduleReader reader(from);
    to.fields(reader);
  }

 private:
  const list& from_;
};

}  // namespace

codend::Schedule binding::read_schedule(const list& from) {
  codend::Schedule schedule;
  ScheduleReader::read(from, schedule);
  return schedule;
}

writable::list binding::schedule_done(const codend::Schedule& schedule) {
  writable::doubles length, since, speed, target_speed, broken_at;
  writable::integers broken;
  writable::logicals near_limit;
  for (const codend::GrowingGroup& group : schedule.growing) {
    length.push_back(group.control.length);
    since.push_back(group.control.since);
    speed.push_back(group.control.speed);
    target_speed.push_back(group.control.target_speed);
    near_limit.push_back(group.control.near_limit ? TRUE : FALSE);
  }
  for (const codend::Rupture& rope : schedule.ruptures) {
    broken.push_back(rope.broken + 1);
    broken_at.push_back(rope.broken_at);
  }
  return writable::list({"length"_nm = length, "since"_nm = since, "speed"_nm = speed,
                         "target_speed"_nm = target_speed, "near_limit"_nm = near_limit,
                         "broken"_nm = broken, "broken_at"_nm = broken_at,
                         "anchor"_nm = as_doubles(schedule.sticking.anchor)});
}

// Returns values of a curve at times (s). At a jump: the value after it if `after`, else before it.
[[cpp11::register]] doubles engine_curve_at(list curve, doubles time, bool after) {
  return guarded([&]() -> doubles {
    codend::Curve read;
    ScheduleReader::read(curve, read);
    codend::check_curve(read, "curve");
    const codend::Side side = after ? codend::Side::after : codend::Side::before;
    writable::doubles out(time.size());
    for (R_xlen_t k = 0; k < time.size(); ++k) out[k] = read.at(time[k], side);
    return out;
  });
}

// Returns the values of a schedule at times (s), after jumps, as columns by time. The motion of the
// fixed nodes has an origin (m) and a velocity (m/s), 3 each, and a heading (rad). Further columns
// are the factors of the growing groups, and the current along x and y by depth (m/s). `length`:
// line paid out by the winches at these times, m, by group.
[[cpp11::register]] list engine_schedule_at(list schedule, doubles time, doubles length) {
  return guarded([&]() -> list {
    codend::Schedule read = read_schedule(schedule);
    codend::check_schedule(read);
    if (length.size() != time.size() * static_cast<R_xlen_t>(read.growing.size())) {
      throw codend::InputError("length", "length must have one value per time and growing group");
    }
    writable::doubles origin, velocity, heading, factor, x, y;
    R_xlen_t next = 0;
    for (const double t : time) {
      for (codend::GrowingGroup& group : read.growing) {
        group.control.length = length[next++];
        group.control.since = t;
      }
      const codend::ScheduledValues values = codend::values_at(read, t, codend::Side::after);
      for (int k = 0; k < 3; ++k) {
        origin.push_back(values.origin[k]);
        velocity.push_back(values.velocity[k]);
      }
      heading.push_back(values.heading);
      for (const double one : values.factor) factor.push_back(one);
      for (const codend::Vector& current : values.current) {
        x.push_back(current.x());
        y.push_back(current.y());
      }
    }
    return writable::list({"origin"_nm = origin, "velocity"_nm = velocity, "heading"_nm = heading,
                           "factor"_nm = factor, "current_x"_nm = x, "current_y"_nm = y});
  });
}

// Returns the arrays of a model that a schedule changes, at a time (s), after its jumps.
[[cpp11::register]] list engine_scheduled(SEXP handle, list schedule, double time) {
  return guarded([&]() -> list {
    codend::Model model = read_model(handle);
    codend::Assembly assembly(model);
    codend::Motion motion;
    motion.time = time;
    motion.x = motion.v = codend::Values::Zero(3 * model.nodes);
    codend::ScheduledConditions conditions(model, assembly, read_schedule(schedule), motion);
    conditions.to_time(time, codend::Side::after, motion);
    return writable::list({"mass"_nm = as_doubles(model.mass), "load"_nm = as_doubles(model.load),
                           "rest"_nm = as_doubles(model.bars.rest),
                           "multiplicity"_nm = as_doubles(model.bars.multiplicity),
                           "drag_area"_nm = as_doubles(model.spheres.drag_area),
                           "added_mass"_nm = as_doubles(model.spheres.added_mass),
                           "buoyancy"_nm = as_doubles(model.volumes.buoyancy)});
  });
}
