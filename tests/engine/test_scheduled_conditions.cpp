// Effects of schedules on models, compared with analytical solutions, and errors of invalid
// schedules.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "filled_model.hpp"
#include "integrated.hpp"
#include "motion/check_schedule.hpp"
#include "motion/explicit_step.hpp"
#include "motion/scheduled_conditions.hpp"

using namespace codend;

namespace {

// Linear from a value at 0 s to another at a time.
Curve ramp(double from, double to, double time) {
  const double rate = (to - from) / time;
  return {{0.0, time}, {from}, {to}, {rate}, {rate}};
}
Curve constant(double value) { return {{0.0, 1.0}, {value}, {value}, {0.0}, {0.0}}; }

// Two weights of 2 kg (nodes 1 and 2), one below the other on two bars of 1 m, fixed at node 0, in
// vacuum. A bar of 1e5 N and 1 m stretches by 4e-4 m under both.
struct Weights : FilledModel {
  Motion start;
  Weights() {
    const double first = -(1.0 + 4.0 * gravity / stiffness);
    material(stiffness);
    for (const double z : {0.0, first, first - (1.0 + 2.0 * gravity / stiffness)}) {
      const int one = node({0.0, 0.0, z}, z == 0.0);
      if (one == 0) continue;
      model.mass.back() = 2.0;
      model.load.back() = -2.0 * gravity;
      bar(one - 1, one, 1.0, 0);
    }
    model.prepare();
    start = at_rest();
  }
  static constexpr double stiffness = 1e5;

  Motion integration(const Schedule& schedule, double until) {
    Assembly assembly(model);
    ScheduledConditions conditions(model, assembly, schedule, start);
    conditions.to_time(0.0, Side::after, start);
    RungeKuttaStep stepper(assembly, start);
    return integrated(assembly, stepper, conditions, start, until, 1e-3);
  }
};

std::string complaint(const Schedule& schedule) {
  Weights weights;
  Assembly assembly(weights.model);
  try {
    ScheduledConditions(weights.model, assembly, schedule, weights.start);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("vessel motion combines course, waves and a prescribed record") {
  Weights weights;
  Waves& waves = weights.model.water.waves;
  waves.amplitude = {0.8};
  waves.frequency = {1.1};
  waves.phase = {0.4};
  waves.toward = {0.5};
  waves.rising = 6.0;
  waves.prepare();
  Schedule schedule;
  PrescribedMotion& body = schedule.motion;
  body.node = {0};
  body.place = {Vector(30.0, 4.0, 6.0)};
  body.x = ramp(0.0, -20.0, 10.0);
  body.y = constant(5.0);
  body.z = constant(0.0);
  body.heading = ramp(0.0, 1.5, 10.0);
  body.swing.centre = Vector(-10.0, 0.0, 2.0);
  body.swing.even = {0.3, 0.2, 0.5, 0.05, 0.04, 0.03};
  body.swing.odd = {-0.1, 0.4, 0.2, 0.02, -0.03, 0.01};
  for (int j = 0; j < 6; ++j) body.swing.by_time.push_back(ramp(0.0, 0.1 + 0.02 * j, 10.0));
  const double c = std::cos(1.2), s = std::sin(1.2);  // at 8 s
  Assembly assembly(weights.model);
  Motion motion = weights.start, sooner = motion, later = motion;
  for (const bool swings : {false, true}) {
    Schedule run = schedule;
    if (!swings) run.motion.swing = {};
    ScheduledConditions conditions(weights.model, assembly, run, weights.start);
    for (const double time : {4.0, 8.0}) {
      // Velocities are derivatives of positions: second order in 1e-4 s, at 1.1 rad/s and 40 m.
      conditions.to_time(time - 1e-4, Side::before, sooner);
      conditions.to_time(time + 1e-4, Side::before, later);
      conditions.to_time(time, Side::before, motion);
      const Values slope = (later.x - sooner.x) / 2e-4;
      CHECK((slope - motion.v).norm() < (swings ? 1e-7 : 1e-8));
    }
    if (swings) continue;
    const Vector turned(-16.0 + 30.0 * c + 4.0 * s, 5.0 - 30.0 * s + 4.0 * c, 6.0);
    CHECK((motion.x.head<3>() - turned).norm() < 1e-12);
  }
  // Rotated by its components in sequence, about the centre, at 8 s.
  const double q =
      wave_number(1.1, INFINITY) * (std::cos(0.5) * -16.0 + std::sin(0.5) * 5.0) - 1.1 * 8.0 + 0.4;
  double by[6];
  for (std::size_t j = 0; j < 6; ++j) {
    by[j] = 0.8 * (body.swing.even[j] * std::cos(q) + body.swing.odd[j] * std::sin(q)) +
            0.8 * (0.1 + 0.02 * static_cast<double>(j));
  }
  double x = 40.0, y = 4.0, z = 4.0;                    // aft, to starboard and above the centre
  auto turn = [](double& a, double& b, double angle) {  // from a towards b
    const double c = std::cos(angle), s = std::sin(angle), a0 = a;
    a = c * a0 - s * b;
    b = s * a0 + c * b;
  };
  turn(z, y, by[3]);  // starboard down: up turns to starboard
  turn(z, x, by[4]);  // sag up: up turns aft
  turn(y, x, by[5]);  // bow to starboard: starboard turns aft
  x += -10.0 - by[0];
  y += by[1];
  z += 2.0 + by[2];
  CHECK(motion.x[0] == doctest::Approx(-16.0 + x * c + y * s).epsilon(1e-12));
  CHECK(motion.x[1] == doctest::Approx(5.0 - x * s + y * c).epsilon(1e-12));
  CHECK(motion.x[2] == doctest::Approx(z).epsilon(1e-12));
}

TEST_CASE("energy balance closes for ground contact and paid-out rope") {
  // Relative energy error of a time integration with steps of 0.2 ms.
  const auto made = [](Model& model, Motion start, const Schedule& schedule, double until) {
    Assembly assembly(model);
    ScheduledConditions conditions(model, assembly, schedule, start);
    conditions.to_time(0.0, Side::after, start);
    RungeKuttaStep stepper(assembly, start);
    IntegrationControl control;
    control.account = true;
    control.step = 2e-4;
    Past past;
    past.now = start;
    TimeIntegration integration(assembly, stepper, conditions, control, past);
    REQUIRE(integration.to(until) == IntegrationReport::End::reached);
    CHECK(integration.energy().put_through > 1.0);
    return std::abs(integration.energy().imbalance()) / integration.energy().put_through;
  };
  // 10 kg fall on the ground, beyond its onset by then, where the ground stores a third of the
  // energy.
  FilledModel body;
  body.node({0.0, 0.0, 0.0});
  body.model.mass = {10.0};
  body.model.load = {0.0, 0.0, -10.0 * gravity};
  body.model.ground.present = true;
  body.model.contacts.node = {0};
  body.model.contacts.area = {0.003};
  body.model.contacts.clearance = {0.0};
  body.model.prepare();
  // (w h)^2 / 12 of 0.2 ms at 30 /s is 3e-6
  CHECK(made(body.model, body.at_rest(), {}, 0.1) < 1e-5);
  Weights weights;
  Schedule paid;
  paid.growing.resize(1);
  paid.growing[0].factor = ramp(1.0, 1.5, 1.0);
  paid.growing[0].bars = {0};
  paid.growing[0].rest = {1.0};
  // the bars oscillate at 300 /s with the winch's 0.5 m/s: 3e-4 of 1 J, compared with 40 J in total
  CHECK(made(weights.model, weights.start, paid, 1.0) < 1e-4);
}

TEST_CASE("group scales with its factor and returns to its initial values") {
  Weights weights;
  const Model before = weights.model;
  Schedule schedule;
  GrowingGroup group;
  group.factor = ramp(1.0, 3.0, 10.0);
  group.bars = {1};
  group.rest = {1.0};
  group.points = {1, 2};
  group.mass = {0.25, 0.75};
  group.load = {-2.0, -6.0};
  schedule.growing = {group};
  Assembly assembly(weights.model);
  ScheduledConditions conditions(weights.model, assembly, schedule, weights.start);
  Motion motion = weights.start;
  conditions.to_time(5.0, Side::before, motion);  // factor 2
  CHECK(weights.model.bars.rest[0] == 1.0);
  CHECK(weights.model.bars.rest[1] == doctest::Approx(2.0).epsilon(1e-14));
  CHECK(weights.model.mass[1] == doctest::Approx(2.25).epsilon(1e-14));
  CHECK(weights.model.mass[2] == doctest::Approx(2.75).epsilon(1e-14));
  CHECK(weights.model.load[8] == doctest::Approx(-2.0 * gravity - 6.0).epsilon(1e-14));
  conditions.to_time(0.0, Side::before, motion);
  CHECK(weights.model.bars.rest == before.bars.rest);
  CHECK(weights.model.mass == before.mass);
  CHECK(weights.model.load == before.load);
}

TEST_CASE("weight falls freely when its bar breaks") {
  for (const bool by_force : {false, true}) {
    CAPTURE(by_force);
    Weights weights;
    const double from = weights.start.x[8];
    Schedule schedule;
    Rupture rope;
    rope.bars = {1};
    rope.at = 1;
    if (by_force) {
      rope.strength = 0.9 * 2.0 * gravity;  // at once
    } else {
      rope.time = 0.5;
    }
    schedule.ruptures = {rope};
    const Motion end = weights.integration(schedule, 1.0);
    // Steps are 1 ms; an overloaded bar breaks after the first step.
    const double falls = by_force ? 1.0 - 1e-3 : 0.5;
    CHECK(end.x[8] - from == doctest::Approx(-0.5 * gravity * falls * falls).epsilon(1e-3));
    CHECK(end.v[8] == doctest::Approx(-gravity * falls).epsilon(1e-6));
    CHECK(weights.model.bars.multiplicity[1] == 0.0);
  }
}

TEST_CASE("node stays until its release and then falls") {
  Weights weights;
  weights.start.x[8] = weights.start.x[5];  // slack between the two, which fall next to each other
  weights.start.x[6] = 0.5;
  const Values from = weights.start.x;
  Schedule schedule;
  schedule.release.node = {2};
  schedule.release.time = {0.3};
  CHECK(weights.integration(schedule, 0.3).x.tail<3>() == from.tail<3>());
  Weights other;
  other.start.x = from;
  const Motion end = other.integration(schedule, 0.6);
  // It starts within the step of 1 ms that ends with its time: error 2 x 1 ms / 0.3 s of the
  // distance.
  CHECK(end.x[8] - from[8] == doctest::Approx(-0.5 * gravity * 0.09).epsilon(7e-3));
}

TEST_CASE("controlled length follows its target within the speed limit") {
  LengthControl control;
  control.target = constant(200.0);
  control.length = 100.0;
  control.speed_limit = 2.0;
  for (int k = 1; k <= 90; ++k) control.choose_speed(0.5 * k, 0.0);
  // Full speed until 10 m are left: 2 m/s from the first choice, 0.5 s after the start.
  CHECK(control.length == doctest::Approx(100.0 + 2.0 * 44.5).epsilon(1e-12));
  for (int k = 91; k <= 400; ++k) control.choose_speed(0.5 * k, 0.0);
  CHECK(control.length == doctest::Approx(200.0).epsilon(1e-6));  // 11 m exp(-155 s / 5 s)
  control.most_length = 201.0;
  control.by_speed = true;
  control.target_speed = 1.0;
  for (int k = 401; k <= 420; ++k) control.choose_speed(0.5 * k, 0.0);
  CHECK(control.speed == 0.0);
  CHECK(control.length == doctest::Approx(201.0).epsilon(0.5 / 201.0));  // within one choice
}

TEST_CASE("rope at its tension limit slips at the brake's speed") {
  LengthControl control;
  control.target = constant(100.0);
  control.length = 100.0;
  control.stiffness = 1e6;
  control.speed_limit = 2.0;
  control.tension_limit = 1e4;
  // T = T_l (1 + v/v_l / 10): 5 % over the limit is half of the speed limit. At a constant tension,
  // each choice reduces the error by a factor of h EA/L or less.
  for (int k = 1; k <= 4000; ++k) control.choose_speed(0.05 * k, 1.05e4);
  CHECK(control.near_limit);
  CHECK(control.longest_step() < 0.1);
  CHECK(control.speed == doctest::Approx(1.0).epsilon(1e-3));
  control.choose_speed(200.05, 3e4);
  for (int k = 1; k <= 4000; ++k) control.choose_speed(200.05 + 0.05 * k, 3e4);
  CHECK(control.speed == 2.0);
}

TEST_CASE("schedule that does not fit its model throws and names the field") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint(Schedule()) == "");

  Schedule moved;
  moved.motion.node = {7};
  moved.motion.place = {Vector::Zero()};
  moved.motion.x = moved.motion.y = moved.motion.z = moved.motion.heading = constant(0.0);
  CHECK(complaint(moved) == "schedule.motion.node[1] must be one of the 3 nodes of the model");
  moved.motion.node = {0, 1};
  CHECK(complaint(moved) == "schedule.motion.place has 1 values, must have 2");
  moved.motion.node = {0};
  moved.motion.heading.end = {none};
  CHECK(complaint(moved) == "schedule.motion.heading.end[1] must be a finite number");
  moved.motion.heading = {{1.0, 1.0}, {0.0}, {0.0}, {0.0}, {0.0}};
  CHECK(complaint(moved) == "schedule.motion.heading.time must increase");
  moved.motion.heading = Curve();
  CHECK(complaint(moved) == "schedule.motion.heading must have a piece");

  Schedule grown;
  grown.growing.resize(1);
  grown.growing[0].factor = constant(1.0);
  grown.growing[0].bars = {1, -1};
  CHECK(complaint(grown) == "schedule.growing[1].rest has 0 values, must have 2");
  grown.growing[0].rest = {1.0, 1.0};
  CHECK(complaint(grown) == "schedule.growing[1].bars[2] must be one of the 2 bars of the model");
  grown.growing[0].bars = {1, 0};
  CHECK(complaint(grown) == "");
  grown.growing[0].controlled = true;
  grown.growing[0].control.target = constant(1.0);
  grown.growing[0].control.length = none;
  CHECK(complaint(grown) == "schedule.growing[1].control.length must be a finite number");

  Schedule broken;
  broken.ruptures.resize(1);
  broken.ruptures[0].at = 2;
  CHECK(complaint(broken) == "schedule.ruptures[1].at must be one of the 2 bars of the model");
  broken.ruptures[0].at = 1;
  broken.ruptures[0].strength = none;
  CHECK(complaint(broken) == "schedule.ruptures[1].strength must be a number");

  Schedule current;
  current.current_x = current.current_y = {constant(1.0), constant(2.0)};
  CHECK(complaint(current) == "schedule.current_x has 2 values, must have 1");
}
