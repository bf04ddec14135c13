// Sticking and slipping friction, compared with Coulomb's law on a slope.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "filled_model.hpp"
#include "integrated.hpp"
#include "motion/newton_step.hpp"
#include "motion/scheduled_conditions.hpp"
#include "plate_struts.hpp"

using namespace codend;

namespace {

// Returns the motion at a time (s), with an error of 0.1 mm per step.
Motion slid(Model& model, Motion start, double until) {
  model.prepare();
  Assembly assembly(model);
  Schedule schedule;
  schedule.sticking.present = true;
  ScheduledConditions conditions(model, assembly, schedule, start);
  conditions.to_time(0.0, Side::after, start);
  NewtonStep stepper(assembly, {1e-4, 1e9, 1e-9}, start.x);
  return integrated(assembly, stepper, conditions, start, until, 1e-3, true);
}

// 10 kg on 0.01 m2 in vacuum, at the penetration of its weight, on a slope (rad) that falls towards
// +x.
struct Body {
  Model model;
  Motion start;
  explicit Body(double slope) {
    model.nodes = 3;
    model.held = {0, 1, 1};
    model.water.density = 0.0;
    model.mass = {10.0, 0.0, 0.0};
    model.load.assign(9, 0.0);
    model.load[2] = -10.0 * gravity;
    model.ground.present = true;
    model.ground.normal = Vector(std::sin(slope), 0.0, std::cos(slope));
    model.ground.friction = 0.5;
    model.contacts.node = {0};
    model.contacts.area = {0.01};
    model.contacts.clearance = {0.0};
    double deep, change;
    model.ground.give(10.0 * gravity * std::cos(slope), 0.01 * model.ground.stiffness, deep,
                      change);
    start.x = start.v = Values::Zero(9);
    at(start.x.data(), 0) = -deep * model.ground.normal;
    at(start.x.data(), 2) = Vector(1.0, 1.0, 0.0);
  }
  Body(const Body&) = delete;

  Motion integration(double until) { return slid(model, start, until); }
  double moved(const Motion& motion) const {
    return (at(motion.x.data(), 0) - at(start.x.data(), 0)).norm();
  }
};

}  // namespace

TEST_CASE("body on a slope stays if friction suffices") {
  Body body(0.35);  // tan 0.365 < 0.5
  const Motion soon = body.integration(5.0);
  Body other(0.35);
  const Motion late = other.integration(500.0);
  // It moves by the elastic displacement in proportion to the used friction.
  const double give = 0.01 * std::tan(0.35) / 0.5;
  CHECK(body.moved(soon) == doctest::Approx(give).epsilon(0.01));
  CHECK(other.moved(late) == doctest::Approx(give).epsilon(1e-3));
}

TEST_CASE("body on a steep slope slides by Coulomb's law") {
  Body body(0.6);  // tan 0.684 > 0.5
  const Motion end = body.integration(2.0);
  const double pull = gravity * (std::sin(0.6) - 0.5 * std::cos(0.6));
  // It starts after an elastic displacement of 0.01 m.
  CHECK(body.moved(end) == doctest::Approx(0.5 * pull * 4.0).epsilon(0.05));
  CHECK(at(end.v.data(), 0).norm() == doctest::Approx(2.0 * pull).epsilon(0.03));
}

TEST_CASE("thrown body stops when friction has used its energy") {
  Body body(0.0);
  at(body.start.v.data(), 0) = Vector(2.0, 0.0, 0.0);
  const Motion end = body.integration(20.0);
  // v^2 / (2 mu g), and back by at most the elastic displacement.
  CHECK(body.moved(end) == doctest::Approx(4.0 / (2.0 * 0.5 * gravity)).epsilon(0.03));
  CHECK(at(end.v.data(), 0).norm() < 1e-6);
}

TEST_CASE("friction after a reversal builds up over twice the slip distance") {
  Ground ground;
  ground.friction = 1.0;
  ground.slip_distance = 0.004;
  const Rubbing rub = ground.rubbing();
  Vector anchor = Vector::Zero();
  double work = 0.0;
  const double step = 1e-5;
  // 0.1 m forward and 0.05 m back, too slowly for damping
  for (int k = 1; k <= 15000; ++k) {
    const Vector x((k <= 10000 ? k : 20000 - k) * step, 0.0, 0.0);
    const Vector away = x - anchor;
    const Vector force = ground.per_press(Vector::Zero(), rub, &away);
    if (k > 10000) work += force.x() * step;
    anchor = ground.draw(anchor, x, Vector::Zero(), true);
  }
  // a fraction 2 g / s less than the whole, to within a step
  CHECK(work == doctest::Approx(0.05 * (1.0 - 2.0 * 0.004 / 0.05)).epsilon(1e-3));
}

TEST_CASE("line contact uses separate friction along and across the line") {
  // Between nodes in the direction (1, 1): sliding along x has a reaction from both.
  Body body(0.0);
  body.model.contacts.lines.node = {0};
  body.model.contacts.lines.between = {1, 2};
  body.model.contacts.lines.along = {0.2};
  body.model.contacts.lines.across = {0.8};
  at(body.start.v.data(), 0) = Vector(20.0, 0.0, 0.0);
  body.model.prepare();
  Assembly assembly(body.model);
  assembly.move_to(body.start.x.data(), body.start.v.data());
  std::vector<double> force(9);
  assembly.residual(force.data());
  const double press = 10.0 * gravity;
  CHECK(force[0] == doctest::Approx(-press * 0.5 * (0.2 + 0.8)).epsilon(1e-5));
  CHECK(force[1] == doctest::Approx(press * 0.5 * (0.8 - 0.2)).epsilon(1e-5));
}

// A board of 1000 N on two shoes, in vacuum, whose lift keeps it upright; pulled at its shoes.
struct Board {
  Model model;
  Motion start;
  explicit Board(const Vector& pull) {
    model.nodes = 3;
    model.held = {0, 0, 0};
    model.water.density = 0.0;
    model.mass.assign(3, 0.0);
    model.load.assign(9, 0.0);
    for (int k = 0; k < 2; ++k) at(model.load.data(), k) = 0.5 * pull;
    LiftingPlate board;
    board.node = {0, 1, 2};
    board.attachment = {Vector(0.0, 0.0, -0.5), Vector(2.0, 0.0, -0.5), Vector(1.0, 0.0, 0.5)};
    board.chord = 2.0;
    board.span = board.height = 1.0;
    board.area = 2.0;
    board.weight = 1200.0;
    board.buoyancy = 200.0;
    board.gravity_centre = {1.0, 0.0, -0.5};
    board.buoyancy_centre = {1.0, 0.0, 0.5};
    board.mass = 100.0;
    board.second_moment = {5.0, 35.0, 35.0};
    board.shoe_area = 0.05;
    board.polar.angle = {-4.0, 4.0};
    board.polar.lift = board.polar.drag = board.polar.lift_slope =
        board.polar.drag_slope = {0.0, 0.0};
    model.plates.plate = {board};
    join_by_struts(model, board.attachment);
    model.ground.present = true;
    model.ground.friction = 0.5;
    double deep, change;
    model.ground.give(500.0, 0.05 * model.ground.stiffness, deep, change);
    start.x = start.v = Values::Zero(9);
    for (int k = 0; k < 3; ++k) {
      const Vector up(0.0, 0.0, 0.5 - deep);
      at(start.x.data(), k) = board.attachment[static_cast<std::size_t>(k)] + up;
    }
  }
  Board(const Board&) = delete;

  // Displacement of the middle of its shoes.
  Vector moves(double until) {
    const Motion end = slid(model, start, until);
    return 0.5 * (at(end.x.data(), 0) + at(end.x.data(), 1) - at(start.x.data(), 0) -
                  at(start.x.data(), 1));
  }
};

TEST_CASE("board stays in place if friction suffices") {
  const double pull = 400.0;  // of 500
  const Vector soon = Board({pull, 0.0, 0.0}).moves(5.0);
  const Vector late = Board({pull, 0.0, 0.0}).moves(500.0);
  const double give = 0.01 * pull / 500.0;  // as for the body above
  CHECK(soon.x() == doctest::Approx(give).epsilon(0.01));
  CHECK(late.x() == doctest::Approx(give).epsilon(1e-3));
}

TEST_CASE("board contact uses separate friction along and across its chord") {
  auto own = [](const Vector& pull) {
    Board board(pull);
    board.model.plates.plate[0].own_friction = true;
    board.model.plates.plate[0].friction_along = 0.2;
    board.model.plates.plate[0].friction_across = 0.8;
    return board.moves(2.0);
  };
  // 1000 N on 100 kg; it starts after an elastic displacement of 0.01 m.
  CHECK(own({400.0, 0.0, 0.0}).x() == doctest::Approx(0.5 * 2.0 * 4.0).epsilon(0.05));
  CHECK(own({0.0, 400.0, 0.0}).y() == doctest::Approx(0.01 * 400.0 / 800.0).epsilon(0.02));
}

TEST_CASE("body between springs slides, reverses and sticks as in short explicit steps") {
  // 10 kg with k = 500 N/m, released 0.4 m from the middle. Friction takes 2 mu N / k = 0.2 m from
  // each swing.
  const double weight = 10.0 * gravity, stiffness = 500.0;
  FilledModel block;
  Model& model = block.model;
  block.material(0.5 * stiffness);
  model.ground.present = true;
  model.ground.friction = 0.5;
  double deep, change;
  model.ground.give(weight, 0.01 * model.ground.stiffness, deep, change);
  for (const double place : {-1.5, 0.4, 1.5}) block.node({place, 0.0, -deep}, place != 0.4);
  model.mass[1] = 10.0;
  model.load[5] = -weight;
  for (const int one : {0, 1}) block.bar(one, one + 1, 1.0, 0);
  model.contacts.node = {1};
  model.contacts.area = {0.01};
  model.contacts.clearance = {0.0};
  model.prepare();
  Motion start = block.at_rest();
  Assembly assembly(model);
  Schedule schedule;
  schedule.sticking.present = true;
  ScheduledConditions conditions(model, assembly, schedule, start);
  const Past past = started(conditions, start);
  NewtonStep stepper(assembly, relative_accuracy(1e-3, past.now.x), past.now.x);
  const IntegrationControl control = adaptive_from(1e-4);
  TimeIntegration integration(assembly, stepper, conditions, control, past);
  // Symplectic Euler with the same law in one dimension, in steps of 10 us.
  const Ground& ground = model.ground;
  double x = 0.4, v = 0.0, anchor = 0.4, worst = 0.0;
  const double step = 1e-5;
  for (int k = 1; k <= 200000; ++k) {
    const double w = (x - anchor + ground.stick_lag * v) / ground.slip_distance;
    const double rub = -ground.friction * weight * w / std::max(1.0, std::abs(w));
    v += step * (rub - stiffness * x) / 10.0;
    x += step * v;
    anchor = ground.draw(Vector(anchor, 0, 0), Vector(x, 0, 0), Vector(v, 0, 0), true).x();
    if (k % 5000 != 0) continue;
    REQUIRE(integration.to(k * step) == IntegrationReport::End::reached);
    worst = std::max(worst, std::abs(integration.now().x[3] - x));
  }
  CHECK(std::abs(v) < 1e-3);
  CHECK(std::abs(x) < 0.1);
  // 1 % of the movement of 0.6 m
  CHECK(worst < 0.006);
}
