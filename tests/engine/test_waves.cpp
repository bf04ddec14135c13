// Waves, and forces in accelerating water, compared with analytical solutions.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/pi.hpp"
#include "filled_model.hpp"
#include "integrated.hpp"
#include "model/evaluate.hpp"
#include "motion/explicit_step.hpp"
#include "motion/newton_step.hpp"
#include "motion/scheduled_conditions.hpp"

using namespace codend;

namespace {

Waves regular(double height, double period, double depth) {
  Waves waves;
  waves.amplitude = {0.5 * height};
  waves.frequency = {2.0 * pi / period};
  waves.phase = {0.3};
  waves.toward = {0.7};
  waves.depth = depth;
  waves.rising = 1e-3;
  waves.time = 4.0;
  waves.prepare();
  return waves;
}

// A sphere of 0.3 m with the density of the water, C_D 0.47, added mass 0.5, at a position.
void make_float(Model& model, double density = 1025.0) {
  const double volume = pi / 6.0 * 0.027;
  model.nodes = 1;
  model.held = {0};
  model.load = {0.0, 0.0, gravity * volume * (1025.0 - density)};
  model.mass = {density * volume};
  model.spheres.node = {0};
  model.spheres.drag_area = {0.47 * pi / 4.0 * 0.09};
  model.spheres.diameter = {0.0};
  model.spheres.added_mass = {0.5 * volume};
  model.volumes.node = {0};
  model.volumes.buoyancy = {1025.0 * gravity * volume};
  model.volumes.height = {0.3};
  model.spheres.height = {0.3};
}

Curve sine(double amplitude, double period, double until) {
  Curve out;
  const double w = 2.0 * pi / period, h = 0.05;
  for (int k = 0; k * h < until + h; ++k) {
    const double t = k * h;
    out.time.push_back(t);
    if (k == 0) continue;
    out.begin.push_back(amplitude * std::sin(w * (t - h)));
    out.end.push_back(amplitude * std::sin(w * t));
    out.begin_rate.push_back(amplitude * w * std::cos(w * (t - h)));
    out.end_rate.push_back(amplitude * w * std::cos(w * t));
  }
  return out;
}

struct Track {
  std::vector<double> x, z;
};

// Positions of the only node, every 0.05 s.
Track integrate_float(Model& model, const Schedule& schedule, Vector from, double until) {
  model.prepare();
  Motion start;
  start.x = start.v = Values::Zero(3);
  start.x = from;
  Assembly assembly(model);
  ScheduledConditions conditions(model, assembly, schedule, start);
  const Past past = started(conditions, start);
  NewtonStep stepper(assembly, {1e-5, 1e9, 1e-9}, past.now.x);
  const IntegrationControl control = adaptive_from(1e-4);
  TimeIntegration integration(assembly, stepper, conditions, control, past);
  Track out;
  for (double t = 0.0; t < until + 1e-6; t += 0.05) {
    REQUIRE(integration.to(t) == IntegrationReport::End::reached);
    out.x.push_back(integration.now().x[0]);
    out.z.push_back(integration.now().x[2]);
  }
  return out;
}

double range(const std::vector<double>& values) {
  const auto ends = std::minmax_element(values.begin(), values.end());
  return *ends.second - *ends.first;
}

}  // namespace

TEST_CASE("wave number satisfies the dispersion relation") {
  for (const double depth : {0.5, 3.0, 20.0, 300.0, 4000.0}) {
    for (const double period : {1.0, 4.0, 9.0, 16.0, 200.0}) {
      const double w = 2.0 * pi / period, k = wave_number(w, depth);
      CHECK(gravity * k * std::tanh(k * depth) == doctest::Approx(w * w).epsilon(1e-13));
    }
  }
  CHECK(wave_number(2.0 * pi / 10.0, INFINITY) == doctest::Approx(4.0 * pi * pi / 981.0));
  // Long waves travel at sqrt(g d): error (k d)^2 / 6.
  const double w = 2.0 * pi / 1000.0, k = wave_number(w, 10.0);
  CHECK(w / k == doctest::Approx(std::sqrt(10.0 * gravity)).epsilon(1e-4));
}

TEST_CASE("wave motion conserves volume, follows its surface and matches its rates") {
  for (const double depth : {0.0, 8.0}) {
    CAPTURE(depth);
    Waves waves = regular(0.6, 5.0, depth);
    waves.amplitude.push_back(0.2);
    waves.frequency.push_back(2.0 * pi / 3.0);
    waves.phase.push_back(2.0);
    waves.toward.push_back(-1.0);
    waves.rising = 6.0;  // includes the rates of the rise
    waves.prepare();
    const Vector place(3.0, -2.0, -1.5);
    const double h = 1e-4;
    auto moved = [&](int axis, double by) {
      Vector p = place;
      p[axis] += by;
      return waves.at(p);
    };
    const WavePoint here = waves.at(place);
    const Vector by_z = (moved(2, h).velocity - moved(2, -h).velocity) / (2.0 * h);
    CHECK((by_z - here.velocity_slope).norm() < 1e-7);
    CHECK((moved(0, h).elevation - moved(0, -h).elevation) / (2.0 * h) ==
          doctest::Approx(here.slope_x).epsilon(1e-6));
    CHECK((moved(1, h).elevation - moved(1, -h).elevation) / (2.0 * h) ==
          doctest::Approx(here.slope_y).epsilon(1e-6));
    // Without stretching, which follows a moving surface: in small waves.
    for (double& a : waves.amplitude) a *= 1e-6;
    const double divergence =
        (moved(0, h).velocity.x() - moved(0, -h).velocity.x() + moved(1, h).velocity.y() -
         moved(1, -h).velocity.y() + moved(2, h).velocity.z() - moved(2, -h).velocity.z()) /
        (2.0 * h);
    CHECK(std::abs(divergence) < 1e-5 * moved(2, h).velocity_slope.norm());
    const WavePoint small = waves.at(place);
    Waves before = waves, after = waves;
    before.time -= h;
    after.time += h;
    const Vector rate = (after.at(place).velocity - before.at(place).velocity) / (2.0 * h);
    CHECK((rate - small.acceleration).norm() < 1e-5 * rate.norm());
    const Vector surface(3.0, -2.0, 0.0);
    waves.rising = before.rising = after.rising = 1.0;  // fully risen
    const double rises = (after.at(surface).elevation - before.at(surface).elevation) / (2.0 * h);
    CHECK(waves.at(surface).velocity.z() == doctest::Approx(rises).epsilon(1e-5));
  }
}

TEST_CASE("waves stretch to their surface and end at the bottom") {
  const Waves waves = regular(2.0, 6.0, 12.0);
  const double k = wave_number(waves.frequency[0], 12.0), a = 1.0, w = waves.frequency[0];
  // The crest: cos q is 1, at time 4.
  const double s = (w * 4.0 - 0.3) / k;
  const Vector crest(s * std::cos(0.7), s * std::sin(0.7), 0.0);
  CHECK(waves.at(crest).elevation == doctest::Approx(a).epsilon(1e-12));
  const double at_surface = a * w / std::tanh(k * 12.0), at_bottom = a * w / std::sinh(k * 12.0);
  CHECK(waves.at(crest + Vector(0, 0, a)).velocity.norm() == doctest::Approx(at_surface));
  CHECK(waves.at(crest + Vector(0, 0, 3 * a)).velocity.norm() == doctest::Approx(at_surface));
  CHECK(waves.at(crest - Vector(0, 0, 12.0)).velocity.norm() == doctest::Approx(at_bottom));
  CHECK(waves.at(crest - Vector(0, 0, 12.0)).velocity.z() == doctest::Approx(0.0));
}

// Morison, O'Brien, Johnson and Schaaf (J. Petroleum Tech. 2, 1950), integrated from the bottom to
// the still water's surface, for a pile of diameter D in waves of amplitude a.
//
//   inertia  rho C_M pi D^2/4 a g tanh(k d) sin q
//   drag     1/2 rho C_D D (a w)^2 (sinh(2 k d) + 2 k d)/(4 k sinh^2(k d)) cos q |cos q|
TEST_CASE("wave force on a fixed pile equals Morison's formula") {
  const double depth = 10.0, diameter = 0.4, amplitude = 1e-3, period = 5.0;
  const int bars = 400;
  FilledModel filled;
  Model& model = filled.model;
  const std::vector<double>& x = filled.x;
  model.water = Water();
  filled.material(1e9);
  TwineMaterial& pile = model.materials[0];
  pile.diameter = diameter;
  pile.volume_per_length = pi / 4.0 * diameter * diameter;
  pile.added_mass_normal = 0.9;
  pile.added_mass_tangential = 0.0;
  pile.law.normal = 1.05;
  const double long_one = depth / bars;
  for (int k = 0; k <= bars; ++k) filled.node({0.0, 0.0, -long_one * k}, true);
  for (int k = 0; k < bars; ++k) {
    filled.bar(k, k + 1, long_one, 0);
    for (const int node : {k, k + 1}) {
      model.volumes.node.push_back(node);
      model.volumes.buoyancy.push_back(1025.0 * gravity * 0.5 * long_one * pile.volume_per_length);
      model.volumes.height.push_back(1.0);
    }
  }
  model.water.waves = regular(2.0 * amplitude, period, depth);
  model.water.waves.phase = {0.0};
  model.water.waves.toward = {0.0};
  model.prepare();
  const double w = 2.0 * pi / period, k = wave_number(w, depth), kd = k * depth;
  const std::vector<double> v(x.size(), 0.0);
  auto force_at = [&](double q) {
    model.water.waves.time = (2.0 * pi * 3.0 - q) / w;
    Assembly assembly(model);
    const std::vector<double> force = evaluate(assembly, x.data(), v.data()).force;
    Vector sum = Vector::Zero();
    for (int n = 0; n < model.nodes; ++n) sum += at(force.data(), n);
    return sum;
  };
  const double inertia =
      1025.0 * 1.9 * pile.volume_per_length * amplitude * gravity * std::tanh(kd);
  const double drag = 0.5 * 1025.0 * 1.05 * diameter * std::pow(amplitude * w, 2) *
                      (std::sinh(2.0 * kd) + 2.0 * kd) / (4.0 * k * std::pow(std::sinh(kd), 2));
  // Stretching: k a = 2e-4. Bars: (k L)^2 / 8 = 2e-6.
  CHECK(force_at(pi / 2.0).x() == doctest::Approx(inertia).epsilon(5e-4));
  CHECK(force_at(0.0).x() == doctest::Approx(drag).epsilon(5e-4));
  CHECK(force_at(pi).x() == doctest::Approx(-drag).epsilon(5e-4));
}

TEST_CASE("oscillating current carries bodies along, heavier ones less") {
  // A body at rest in water at rest that starts to oscillate with 1 m/s over 2 pi / 6 s. If it is
  // as heavy as water, it has no relative velocity. Without drag v = (rho V (1 + C_a) / (m + rho V
  // C_a)) u.
  for (const double density : {1025.0, 2050.0}) {
    Model model;
    make_float(model, density);
    if (density > 1025.0) model.spheres.drag_area = {0.0};
    model.load = {0.0, 0.0, 0.0};
    Schedule schedule;
    schedule.current_x = {sine(1.0, 6.0, 12.0)};
    schedule.current_y = {sine(0.0, 6.0, 12.0)};
    const Track track = integrate_float(model, schedule, {0.0, 0.0, -10.0}, 12.0);
    const double share = 1.5 / (density / 1025.0 + 0.5);
    // The steps' errors, 1e-5 m each, and a crest between the saved times, 6e-4 of the height.
    CHECK(range(track.x) == doctest::Approx(share * 2.0 * 6.0 / (2.0 * pi)).epsilon(2e-3));
  }
}

TEST_CASE("particle in waves moves on its orbit") {
  for (const double depth : {0.0, 10.0}) {
    CAPTURE(depth);
    Model model;
    make_float(model);
    const double period = 6.0, height = 0.2, z = -4.0, w = 2.0 * pi / period;
    model.water.waves = regular(height, period, depth);
    model.water.waves.toward = {0.0};
    const Track track = integrate_float(model, Schedule(), {0.0, 0.0, z}, 6.0);
    const double k = wave_number(w, depth > 0.0 ? depth : INFINITY), a = 0.5 * height;
    double across = a * std::exp(k * z), up = across;
    if (depth > 0.0) {
      across = a * std::cosh(k * (z + depth)) / std::sinh(k * depth);
      up = a * std::sinh(k * (z + depth)) / std::sinh(k * depth);
    }
    // Second order is neglected: k a = 0.011, and Stokes drift adds as much to the path along x.
    CHECK(range(track.x) == doctest::Approx(2.0 * across).epsilon(0.04));
    CHECK(range(track.z) == doctest::Approx(2.0 * up).epsilon(0.02));
  }
}
