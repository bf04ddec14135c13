// Time schemes compared with analytical solutions, and properties of the time integration.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "base/pi.hpp"
#include "integrated.hpp"
#include "motion/schemes.hpp"
#include "oscillator.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

// accuracy: m, of a step of an adaptive scheme; infinite for constant steps.
std::unique_ptr<Stepper> stepper(const Scheme& scheme, Assembly& assembly, const Motion& start,
                                 double accuracy = std::numeric_limits<double>::infinity()) {
  StepAccuracy held_to;
  held_to.position = accuracy;
  held_to.found = 1e-13;
  return scheme.make(assembly, held_to, start, start.x);
}

int order_of(const Scheme& scheme, const Model& model, const Motion& start) {
  Assembly assembly(model);
  return stepper(scheme, assembly, start)->order();
}

// Integrates with steps that start at `step` (s).
Motion integration(const Model& model, const Motion& start, const Scheme& scheme, double until,
                   double step, IntegrationReport* report = nullptr,
                   double accuracy = std::numeric_limits<double>::infinity()) {
  Assembly assembly(model);
  SteadyConditions conditions(model.held, start);
  const std::unique_ptr<Stepper> steps = stepper(scheme, assembly, start, accuracy);
  return integrated(assembly, *steps, conditions, start, until, step, std::isfinite(accuracy),
                    report);
}

// A line of equal bars along z, with z increasing with the node number and half a bar's mass at
// each end of a bar; in vacuum by default.
struct String : FilledModel {
  Motion start;
  String(int bars, double length, double axial_stiffness, double mass_per_length) {
    const double rest = length / bars;
    material(axial_stiffness);
    for (int n = 0; n <= bars; ++n) {
      node({0.0, 0.0, n * rest});
      model.mass.back() = (n % bars ? 1.0 : 0.5) * rest * mass_per_length;
      if (n > 0) bar(n - 1, n, rest, 0);
    }
    model.prepare();
    start = at_rest();
  }

  double energy(const Motion& motion) const {
    double sum = 0.0;
    for (int n = 0; n < model.nodes; ++n) {
      sum += 0.5 * model.mass[n] * at(motion.v.data(), n).squaredNorm() -
             at(model.load.data(), n).dot(at(motion.x.data(), n));
    }
    model.each_line([&](const auto& line) {
      sum += line.multiplicity *
             twine_energy(model.material(line), line.length(motion.x.data()), line.rest);
    });
    return sum;
  }
};

Vector momentum(const Model& model, const Motion& motion) {
  Vector sum = Vector::Zero();
  for (int n = 0; n < model.nodes; ++n) sum += model.mass[n] * at(motion.v.data(), n);
  return sum;
}

// Time between the first and the last zero crossing divided by the number of half periods.
template <class Sample>
double half_swing(double step, int steps, Sample sample) {
  double first = 0.0, last = 0.0, before = sample();
  int crossings = 0;
  for (int k = 1; k <= steps; ++k) {
    const double now = sample();
    if ((before > 0.0) != (now > 0.0)) {
      last = step * (k - 1 + before / (before - now));
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  return (last - first) / (crossings - 1);
}

}  // namespace

TEST_CASE("every scheme reaches its order of accuracy on a smooth motion") {
  const Oscillator o;
  for (const Scheme& scheme : schemes()) {
    CAPTURE(scheme.name);
    // After 1 s: 0.1 m cos(10 t).
    auto error = [&](double step) {
      const Motion end = integration(o.model, o.at_rest(), scheme, 1.0, step);
      return std::hypot(end.x[3] - 0.1 * std::cos(10.0), 0.1 * (end.v[3] + std::sin(10.0)));
    };
    // h w = 0.01 and 0.005: the next term of the error is smaller by about 1e-2.
    const double slope = std::log2(error(1e-3) / error(5e-4));
    CHECK(slope == doctest::Approx(order_of(scheme, o.model, o.at_rest())).epsilon(0.02));
  }
}

TEST_CASE("unknown scheme throws an error that lists the known schemes") {
  CHECK(scheme_named(schemes().front().name).name == std::string(schemes().front().name));
  CHECK_THROWS_WITH_AS(scheme_named("euler"), doctest::Contains(schemes().front().name),
                       std::invalid_argument);
}

TEST_CASE("hanging chain swings at its lowest frequency") {
  // w = j0/2 sqrt(g/L), j0 = 2.404826 the first zero of the Bessel function J0.
  const int bars = 40;
  const double length = 10.0;
  String chain(bars, length, 1e6, 1.0);
  chain.model.held.back() = 1;
  for (int n = 0; n < chain.model.nodes; ++n) {
    at(chain.model.load.data(), n).z() = -gravity * chain.model.mass[n];
  }
  Assembly assembly(chain.model);
  // Stretched by its weight; the initial velocity is nearly the mode J0(j0 sqrt(s/L)).
  double z = length;
  for (int n = bars; n >= 0; --n) {
    const double s = n * length / bars;
    at(chain.start.x.data(), n).z() = z;
    at(chain.start.x.data(), n).x() =
        0.01 * std::cyl_bessel_j(0.0, 2.404826 * std::sqrt(s / length));
    z -= length / bars * (1.0 + gravity * (s - 0.5 * length / bars) / 1e6);
  }
  SteadyConditions conditions(chain.model.held, chain.start);
  const std::unique_ptr<Stepper> scheme = stepper(scheme_named("tr_bdf2"), assembly, chain.start);
  IntegrationControl control;
  control.step = 0.02;
  Past past;
  past.now = chain.start;
  TimeIntegration integration(assembly, *scheme, conditions, control, past);
  int k = 0;
  const double period =
      2.0 * half_swing(control.step, 1000, [&] {
        REQUIRE(integration.to(++k * control.step) == IntegrationReport::End::reached);
        return integration.now().x[0];
      });
  const double exact = 2.0 * pi / (0.5 * 2.404826 * std::sqrt(gravity / length));
  // (w h)^2/12 = 5e-6 from the rule, 1/(4 bars)^2 = 4e-5 from the lumped chain; 1e-3 in total with
  // the linear zero crossing and small contributions of other modes.
  CHECK(period == doctest::Approx(exact).epsilon(1e-3));
}

TEST_CASE("sphere sinks from rest as tanh with every scheme") {
  // 0.3 m and 2000 kg/m3 in water of 1025 kg/m3, C_D 0.47, added mass 0.5.
  FilledModel sinker;
  Model& model = sinker.model;
  const double volume = pi / 6.0 * 0.027;
  sinker.node({0.0, 0.0, 0.0});
  model.water.density = 1025.0;
  model.load[2] = -9.81 * volume * (2000.0 - 1025.0);
  model.mass = {2000.0 * volume};
  model.spheres.node = {0};
  model.spheres.drag_area = {0.47 * pi / 4.0 * 0.09};
  model.spheres.diameter = {0.0};
  model.spheres.added_mass = {0.5 * volume};
  model.prepare();
  const Motion start = sinker.at_rest();
  for (const Scheme& scheme : schemes()) {
    CAPTURE(scheme.name);
    const Motion end = integration(model, start, scheme, 1.0, 1e-3);
    const bool first_order = order_of(scheme, model, start) == 1;
    // h/tau = 1.4e-3 of the speed gained, times a curvature of 1 or less.
    CHECK(-end.v[2] == doctest::Approx(2.8180971 * std::tanh(1.0 / 0.74026701))
                           .epsilon(first_order ? 1.5e-3 : 1e-6));
  }
}

TEST_CASE("free net in vacuum conserves momentum and energy") {
  // A ring of 12 taut bars with slack ones across, thrown and rotating.
  String net(12, 12.0, 500.0, 0.5);
  Random random(20260460);
  for (int n = 0; n < 13; ++n) {
    const double turn = 2.0 * pi * n / 13;
    at(net.start.x.data(), n) = Vector(2.4 * std::cos(turn), 2.4 * std::sin(turn), 0.0);
    at(net.start.v.data(), n) = Vector(1.0, -0.5, 0.3) +
                                0.8 * Vector(-std::sin(turn), std::cos(turn), 0.0) +
                                random.vector(0.05);
  }
  for (const int other : {3, 6, 9}) net.bar(0, other, 6.0, 0);
  net.model.prepare();
  const Vector before = momentum(net.model, net.start);
  const double energy = net.energy(net.start);
  // w h = 0.045 for the fastest oscillation of a bar. The explicit schemes and the substituted
  // trapezoid shift the energy by (w h)^2. TR-BDF2 damps the energy of such oscillations by
  // 0.0074 (w h)^4 a step, 1.5e-4 in total, and more where slack bars become taut.
  for (const Scheme& scheme : schemes()) {
    CAPTURE(scheme.name);
    const Motion end = integration(net.model, net.start, scheme, 5.0, 1e-3);
    // 5000 steps, each solved to 1e-13 m or rounding: p^2 M dx = 1e-7 kg m/s2 over 1 ms.
    CHECK((momentum(net.model, end) - before).norm() < 1e-7 * before.norm());
    const double drift = net.energy(end) / energy - 1.0;
    // Schemes with an error estimate use Newton's method, and damp.
    const bool damps = scheme.adaptive;
    const bool second_order = damps && order_of(scheme, net.model, net.start) == 2;
    if (damps) CHECK(drift < 0.0);
    if (second_order) CHECK(drift > -1e-3);
    if (!damps) CHECK(std::abs(drift) < 2e-3);
  }
}

TEST_CASE("adaptive steps keep their accuracy and grow at rest") {
  const Oscillator o;
  for (const Scheme& scheme : schemes()) {
    if (!scheme.adaptive) continue;
    CAPTURE(scheme.name);
    double last = 1.0;
    for (const double accuracy : {1e-4, 1e-6}) {
      IntegrationReport report;
      const Motion end = integration(o.model, o.at_rest(), scheme, 1.0, 1e-3, &report, accuracy);
      const double error = std::abs(end.x[3] - 0.1 * std::cos(10.0));
      // The errors of steps accumulate in an undamped oscillation: position, and velocity over w.
      CHECK(error < 2.0 * accuracy * static_cast<double>(report.steps));
      CHECK(error < last);
      last = error;
    }
  }
  Oscillator still;
  still.x[3] = 0.0;
  IntegrationReport report;
  const Motion end = integration(still.model, still.at_rest(), scheme_named("tr_bdf2"), 500.0, 1e-3,
                                 &report, 1e-3);
  CHECK(end.x[3] == 0.0);
  CHECK(report.longest_step == doctest::Approx(60.0));
  CHECK(report.steps < 40);
}

TEST_CASE("states within steps have the error of steps and do not change them") {
  const Oscillator o;
  double at_ends = 0.0, inside = 0.0, speed = 0.0;
  auto run = [&](bool record) {
    Assembly assembly(o.model);
    SteadyConditions conditions(o.model.held, o.at_rest());
    const Scheme& scheme = scheme_named("tr_bdf2");
    const std::unique_ptr<Stepper> steps = stepper(scheme, assembly, o.at_rest(), 1e-6),
                                   inner = stepper(scheme, assembly, o.at_rest(), 1e-6);
    IntegrationControl control;
    control.adaptive = true;
    control.step = 1e-3;
    Past past;
    past.now = o.at_rest();
    TimeIntegration integration(assembly, *steps, conditions, control, past);
    auto off = [](const Motion& m) { return std::abs(m.x[3] - 0.1 * std::cos(10.0 * m.time)); };
    control.passed = [&](const Past& step) {
      if (!record) return;
      at_ends = std::max(at_ends, off(step.now));
      for (const double share : {0.25, 0.5, 0.75}) {
        const Motion m = integration.at(step.before.time + share * step.last_step(), *inner);
        inside = std::max(inside, off(m));
        speed = std::max(speed, std::abs(m.v[3] + std::sin(10.0 * m.time)));
      }
    };
    REQUIRE(integration.to(1.0) == IntegrationReport::End::reached);
    return integration.now();
  };
  CHECK(run(true).x == run(false).x);
  CHECK(inside < 1.05 * at_ends);
  CHECK(speed < 1.5 * 10.0 * at_ends);  // velocities have w times the error of positions
}

TEST_CASE("relative accuracy limits the error of an oscillation in proportion") {
  // The allowed error per travelled distance is a tenth of the accuracy: 1 rad has it as phase.
  Oscillator o;
  double last = 1.0;
  for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
    Assembly assembly(o.model);
    SteadyConditions conditions(o.model.held, o.at_rest());
    StepAccuracy relative = relative_accuracy(accuracy, o.at_rest().x);
    const std::unique_ptr<Stepper> steps =
        scheme_named("tr_bdf2").make(assembly, relative, o.at_rest(), o.at_rest().x);
    const Motion end = integrated(assembly, *steps, conditions, o.at_rest(), 2.0, 1e-4, true);
    const double phase = std::atan2(-0.1 * end.v[3], end.x[3]);
    const double error = std::abs(std::remainder(phase - 20.0, 2.0 * pi)) / 20.0;
    // the fastest of three nodes moves at 2/3 of the speed relative to their mean
    CHECK(error < 0.1 * accuracy);
    CHECK(error < 0.2 * last);
    last = error;
  }
}

TEST_CASE("explicit scheme shortens an unstable step to the stable length") {
  const Oscillator o;
  for (const Scheme& scheme : schemes()) {
    if (scheme.adaptive) continue;
    CAPTURE(scheme.name);
    IntegrationReport report;
    const Motion end = integration(o.model, o.at_rest(), scheme, 20.0, 1.0, &report);
    CHECK(std::abs(end.x[3]) < 0.2);
    // w = 10 1/s exactly: below 2/w, or 2.78/w with RK4.
    CHECK(report.longest_step < (order_of(scheme, o.model, o.at_rest()) == 4 ? 0.278 : 0.2));
    CHECK(report.longest_step > 0.15);
  }
}

TEST_CASE("damper removes the energy of an oscillation at its rate") {
  // 1 kg on 100 N/m with c_physical = 2 z w m in total: x = 0.1 exp(-z w t) cos(w sqrt(1 - z^2) t)
  // ..
  Oscillator o;
  const double ratio = 0.05, rate = 10.0;
  // Two bars of 1 m: 2 c / L0^2 = 2 z w m, and the table contains c/L0.
  o.model.materials[0].damping = ratio * rate;
  o.model.prepare();
  const Motion end = integration(o.model, o.at_rest(), scheme_named("tr_bdf2"), 1.0, 1e-3);
  const double w = rate * std::sqrt(1.0 - ratio * ratio);
  const double exact = 0.1 * std::exp(-ratio * rate) *
                       (std::cos(w) + ratio / std::sqrt(1.0 - ratio * ratio) * std::sin(w));
  CHECK(end.x[3] == doctest::Approx(exact).epsilon(1e-3));  // (w h)^2/12 of w t = 10
}

TEST_CASE("curves are cubics between their ends and may jump") {
  // t^3 on [0, 2], then constantly 5.
  Curve curve{{0.0, 2.0, 3.0}, {0.0, 5.0}, {8.0, 5.0}, {0.0, 0.0}, {12.0, 0.0}};
  double value, rate;
  for (const double t : {0.1, 0.7, 1.9}) {
    curve.at(t, Side::before, value, rate);
    CHECK(value == doctest::Approx(t * t * t).epsilon(1e-14));
    CHECK(rate == doctest::Approx(3.0 * t * t).epsilon(1e-13));
  }
  CHECK(curve.at(2.0, Side::before) == 8.0);
  CHECK(curve.at(2.0, Side::after) == 5.0);
  CHECK(curve.at(-1.0) == 0.0);
  CHECK(curve.at(9.0) == 5.0);
}
