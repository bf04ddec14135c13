// Schedules for R: read, and asked what they say of a time.
#include "binding_schedule.hpp"

#include "binding_model.hpp"
#include "engine/march/check_schedule.hpp"
#include "engine/march/scheduled_conditions.hpp"

using namespace binding;

namespace {

codend::Curve read_curve(const list& from) {
  return {numbers(from, "time"), numbers(from, "begin"), numbers(from, "end"),
          numbers(from, "begin_rate"), numbers(from, "end_rate")};
}

codend::LengthControl read_winch(const list& from) {
  codend::LengthControl winch;
  winch.target = read_curve(list(from["wanted"]));
  winch.by_speed = as_cpp<bool>(from["steered"]);
  winch.target_speed = number(from, "speed_wanted");
  winch.speed_limit = number(from, "speed_limit");
  winch.tension_limit = number(from, "tension_limit");
  winch.near_limit = as_cpp<bool>(from["near_limit"]);
  winch.stiffness = number(from, "stiffness");
  winch.bar = place(from, "bar");
  winch.full_length = number(from, "full_length");
  winch.least_length = number(from, "least_length");
  winch.most_length = number(from, "most_length");
  winch.length = number(from, "length");
  winch.since = number(from, "since");
  winch.speed = number(from, "speed");
  return winch;
}

codend::PrescribedMotion read_track(const list& from) {
  codend::PrescribedMotion motion;
  motion.node = places(from, "node");
  const std::vector<double> place = numbers(from, "place");
  for (std::size_t k = 0; 3 * k + 2 < place.size(); ++k) {
    motion.place.emplace_back(place[3 * k], place[3 * k + 1], place[3 * k + 2]);
  }
  motion.x = read_curve(list(from["x"]));
  motion.y = read_curve(list(from["y"]));
  motion.z = read_curve(list(from["heave"]));
  motion.heading = read_curve(list(from["course"]));
  return motion;
}

codend::GrowingGroup read_group(const list& from) {
  codend::GrowingGroup group;
  group.controlled = !Rf_isNull(from["winch"]);
  if (group.controlled) group.control = read_winch(list(from["winch"]));
  group.factor = read_curve(list(from["factor"]));
  group.bars = places(from, "bars");
  group.rest = numbers(from, "rest");
  group.points = places(from, "points");
  group.mass = numbers(from, "mass");
  group.load = numbers(from, "load");
  group.spheres = places(from, "spheres");
  group.drag_area = numbers(from, "drag_area");
  group.added_mass = numbers(from, "added_mass");
  group.volumes = places(from, "volumes");
  group.buoyancy = numbers(from, "buoyancy");
  return group;
}

codend::Rupture read_rupture(const list& from) {
  codend::Rupture rupture;
  rupture.bars = places(from, "bars");
  rupture.at = place(from, "at");
  rupture.time = number(from, "time");
  rupture.strength = number(from, "strength");
  rupture.broken = place(from, "broken");
  rupture.broken_at = number(from, "broken_at");
  return rupture;
}

}  // namespace

codend::Schedule binding::read_schedule(const list& from) {
  codend::Schedule schedule;
  schedule.motion = read_track(list(from["track"]));
  const list shooting(from["shooting"]);
  schedule.release.node = places(shooting, "node");
  schedule.release.time = numbers(shooting, "time");
  for (const list group : list(from["growing"])) schedule.groups.push_back(read_group(group));
  for (const list curve : list(from["current_x"])) {
    schedule.current_x.push_back(read_curve(curve));
  }
  for (const list curve : list(from["current_y"])) {
    schedule.current_y.push_back(read_curve(curve));
  }
  for (const list one : list(from["ruptures"])) {
    schedule.ruptures.push_back(read_rupture(one));
  }
  return schedule;
}

writable::list binding::schedule_done(const codend::Schedule& schedule) {
  writable::doubles length, since, speed, wanted, broken_at;
  writable::integers broken;
  writable::logicals near_limit;
  for (const codend::GrowingGroup& group : schedule.groups) {
    length.push_back(group.control.length);
    since.push_back(group.control.since);
    speed.push_back(group.control.speed);
    wanted.push_back(group.control.target_speed);
    near_limit.push_back(group.control.near_limit ? TRUE : FALSE);
  }
  for (const codend::Rupture& rupture : schedule.ruptures) {
    broken.push_back(rupture.broken + 1);
    broken_at.push_back(rupture.broken_at);
  }
  return writable::list({"length"_nm = length, "since"_nm = since, "speed"_nm = speed,
                         "speed_wanted"_nm = wanted, "near_limit"_nm = near_limit,
                         "broken"_nm = broken, "broken_at"_nm = broken_at});
}

// Values of a curve at times (s); at a jump those before it, or after it.
[[cpp11::register]] doubles engine_curve_at(list curve, doubles time, bool after) {
  return guarded([&]() -> doubles {
    const codend::Curve read = read_curve(curve);
    codend::check_curve(read, "curve");
    const codend::Side side = after ? codend::Side::after : codend::Side::before;
    writable::doubles out(time.size());
    for (R_xlen_t k = 0; k < time.size(); ++k) out[k] = read.at(time[k], side);
    return out;
  });
}

// What a schedule says of times (s), after their jumps, in columns by time: origin and velocity (m,
// m/s, 3 each) of what moves the held nodes, its heading (rad), factors of the growing groups, and
// the current (m/s) along x and y by depth. length: what winches have out then, m, by group.
[[cpp11::register]] list engine_schedule_at(list schedule, doubles time, doubles length) {
  return guarded([&]() -> list {
    codend::Schedule read = read_schedule(schedule);
    codend::check_schedule(read);
    if (length.size() != time.size() * static_cast<R_xlen_t>(read.groups.size())) {
      throw codend::InputError("length", "one length per time and growing group is needed");
    }
    writable::doubles origin, velocity, heading, factor, x, y;
    R_xlen_t next = 0;
    for (const double t : time) {
      for (codend::GrowingGroup& group : read.groups) {
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

// A lattice's numbers that a schedule changes, as they are at a time (s), after its jumps.
[[cpp11::register]] list engine_scheduled(list lattice, list schedule, double time) {
  return guarded([&]() -> list {
    codend::Model model = read_model(lattice);
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
