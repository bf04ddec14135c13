// settle() compared with analytical solutions of statics, and its result if there is no
// equilibrium.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "filled_model.hpp"
#include "random_model.hpp"
#include "solve/settle.hpp"

namespace {

using namespace codend;

// Massless lines, loaded at their nodes.
struct Structure : FilledModel {
  SettleReport report;

  void pull(int node, const Vector& force) { at(model.load.data(), node) += force; }
  const SettleReport& settle(const SettleControl& control = {}) {
    model.prepare();
    Assembly assembly(model);
    const std::vector<double> v(x.size(), 0.0);
    report = codend::settle(assembly, control, v.data(), x.data());
    return report;
  }
  // Net force on a node; at a fixed node, minus the support force.
  Vector force(int node) {
    Assembly assembly(model);
    const std::vector<double> v(x.size(), 0.0);
    std::vector<double> f(x.size());
    assembly.move_to(x.data(), v.data());
    assembly.residual(f.data());
    return at(f.data(), node);
  }
  double tension(int bar) const {
    const Line<2> line = model.bars.line(bar);
    return twine_tension(model.material(line), line.length(x.data()), line.rest);
  }
};

bool is_finite(const Structure& s) {
  for (const double value : s.x) {
    if (!std::isfinite(value)) return false;
  }
  return std::isfinite(s.report.residual) && std::isfinite(s.report.worst_force);
}

// A rope ladder: columns hang from a fixed row and carry loads, and the rungs are too long to carry
// any.
Structure ladder(Random& random, double disorder) {
  Structure s;
  const int columns = 4, rows = 5;
  const int material = s.material(2e4);
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Vector place(c, 0.0, -r);
      const int n = s.node(r == 0 ? place : Vector(place + random.vector(disorder)), r == 0);
      if (r > 0) {
        s.pull(n, {0.0, 0.0, -10.0 * (c + 1)});
        s.bar(n - columns, n, 1.0, material);
        if (c > 0) s.bar(n - 1, n, 1.2, material);
      }
    }
  }
  return s;
}

}  // namespace

TEST_CASE("two-bar truss settles to the analytical sag") {
  // Half span and bars 1 m, EA 1e4 N: sag h from P = 2 EA (L - L0)/L0 h/L, solved to 8 digits.
  const double table[][2] = {{1.0, 0.046440897}, {100.0, 0.21796281}};
  for (const auto& row : table) {
    CAPTURE(row[0]);
    Structure s;
    const int left = s.node({-1.0, 0.0, 0.0}, true), right = s.node({1.0, 0.0, 0.0}, true);
    const int middle = s.node({0.1, 0.2, 0.05});
    const int material = s.material(1e4);
    s.bar(left, middle, 1.0, material);
    s.bar(middle, right, 1.0, material);
    s.pull(middle, {0.0, 0.0, -row[0]});
    REQUIRE(s.settle().converged);
    // Printed digits; a residual of 1e-8 of the tension moves the sag by less.
    CHECK(-at(s.x.data(), middle).z() == doctest::Approx(row[1]).epsilon(2e-8));
    CHECK(std::abs(at(s.x.data(), middle).x()) < 1e-8);
    CHECK(std::abs(at(s.x.data(), middle).y()) < 1e-6);  // across, only tension / length resists
  }
}

TEST_CASE("net with slack lines settles to straight columns") {
  Random random(20260441);
  for (const double disorder : {0.1, 1.0, 5.0}) {
    CAPTURE(disorder);
    Structure s = ladder(random, disorder);
    REQUIRE(s.settle().converged);
    int bar = 0;
    for (int r = 1; r <= 5; ++r) {
      for (int c = 0; c < 4; ++c) {
        // Every column hangs straight and each of its bars carries the loads below.
        const double load = 10.0 * (c + 1);
        double depth = 0.0;
        for (int above = 1; above <= r; ++above) {
          depth += 1.0 + load * (6 - above) / 2e4;
        }
        const Vector place = at(s.x.data(), 4 * r + c);
        // A net force of 1e-8 of 200 N compared with tensions of 10 N, five bars deep.
        CHECK((place - Vector(c, 0.0, -depth)).norm() < 5e-6);
        CHECK(s.tension(bar++) == doctest::Approx(load * (6 - r)).epsilon(1e-6));
        if (c > 0) CHECK(s.tension(bar++) == 0.0);
      }
    }
  }
}

TEST_CASE("settled model has every node's residual below the tolerance") {
  Random random(20260442);
  Structure s = ladder(random, 0.3);
  SettleControl control;
  control.tolerance = 1e-10;
  const SettleReport& report = s.settle(control);
  REQUIRE(report.converged);
  CHECK(report.largest_tension == doctest::Approx(200.0).epsilon(1e-8));
  CHECK(report.residual <= 1e-10);
  double worst = 0.0;
  for (int n = 4; n < s.model.nodes; ++n) worst = std::max(worst, s.force(n).norm());
  CHECK(report.worst_force == worst);
  CHECK(report.residual == doctest::Approx(worst / report.largest_tension).epsilon(1e-12));
}

TEST_CASE("part with small forces settles by its own scale") {
  // 200 kN pull at a warp. Three links with 1 mN each hang from its end, less than 1e-8 of the
  // warp's tension at every node. On the scale of the warp they would remain in their initial
  // layout.
  auto chain = [](const std::vector<int>& part) {
    Structure s;
    const int held = s.node({0.0, 0.0, 0.0}, true), end = s.node({100.0, 0.0, 0.0});
    const int stiff = s.material(1e8), soft = s.material(10.0);
    s.pull(end, {2e5, 0.0, 0.0});
    s.bar(held, end, 100.0, stiff);
    int above = end;
    for (int k = 1; k <= 3; ++k) {
      const int link = s.node({100.2 + 0.4 * k, 0.0, -0.9 * k});
      s.pull(link, {0.0, 0.0, -1e-3});
      s.bar(above, link, 1.0, soft);
      above = link;
    }
    SettleControl control;
    control.part = part;
    s.settle(control);
    return s;
  };
  const Structure one = chain({}), each = chain({0, 1, 1, 1});
  REQUIRE(one.report.converged);
  REQUIRE(each.report.converged);
  // Below the warp's end, by the links' lengths under their loads.
  const Vector end = at(each.x.data(), 1), last = at(each.x.data(), 4);
  const double down = 3.0 + (3.0 + 2.0 + 1.0) * 1e-3 / 10.0;
  // A net force of 1e-6 of 3 mN turns a link that carries 1 mN by 3e-6.
  CHECK((last - end - Vector(0.0, 0.0, -down)).norm() < 3 * 3e-6);
  CHECK(each.report.parts.residual <= 1e-6);
  // Allowed by the whole gear's largest tension.
  CHECK(one.report.residual <= 1e-8);
}

TEST_CASE("report names the part with the largest relative residual") {
  Random random(20260446);
  Structure s = ladder(random, 0.3);
  SettleControl control;
  const int bars = s.model.bars.count();
  for (int b = 0; b < bars; ++b) control.part.push_back(b % 3);
  control.iterations = 2;
  const SettleReport& report = s.settle(control);
  REQUIRE_FALSE(report.converged);
  // Reference: in vacuum the largest force of a part is its largest tension.
  double own[3] = {0.0, 0.0, 0.0};
  for (int b = 0; b < bars; ++b) own[b % 3] = std::max(own[b % 3], s.tension(b));
  std::vector<double> scale(static_cast<std::size_t>(s.model.nodes), 0.0);
  for (int b = 0; b < bars; ++b) {
    for (const int end : {0, 1}) {
      double& of_node = scale[static_cast<std::size_t>(s.model.bars.line(b).nodes[end])];
      of_node = std::max(of_node, own[b % 3]);
    }
  }
  double worst = 0.0;
  for (int n = 4; n < s.model.nodes; ++n) {
    worst = std::max(worst, s.force(n).norm() / scale[static_cast<std::size_t>(n)]);
  }
  CHECK(report.parts.residual == doctest::Approx(worst).epsilon(1e-12));
  REQUIRE(report.parts.part >= 0);
  CHECK(own[report.parts.part] == scale[static_cast<std::size_t>(report.parts.node)]);
}

TEST_CASE("compressed pole of hinged bars buckles at the mechanism's load") {
  // Two bars of 1 m between ends at distance d. Four strings of length b, stretched to c, hold the
  // joint between them.
  const double push = 1e5, string = 1e3, c = 0.5, b = 0.4;
  // For a small lateral displacement the bars drive it by 2 push (1 - d / 2) / (d / 2). The
  // transverse pair of strings resists by twice its tension over c, the axial pair by twice its
  // stiffness over b.
  const double held_by = string * (c / b - 1.0) / c + string / b;
  const double greatest = 1.0 / (1.0 + held_by / push);  // d / 2 at buckling
  auto settled = [&](double half) {
    Structure s;
    const int bars = s.material(push), strings = s.material(string);
    s.model.materials[static_cast<std::size_t>(bars)].strut = true;
    const int left = s.node({-half, 0.0, 0.0}, true), right = s.node({half, 0.0, 0.0}, true),
              joint = s.node({0.0, 0.0, 0.0});
    s.model.mass[static_cast<std::size_t>(joint)] = 1.0;
    s.bar(left, joint, 1.0, bars);
    s.bar(joint, right, 1.0, bars);
    for (const Vector& side :
         {Vector(0, c, 0), Vector(0, -c, 0), Vector(0, 0, c), Vector(0, 0, -c)})
      s.bar(joint, s.node(side, true), b, strings);
    s.settle();
    return s;
  };
  const Structure straight = settled(greatest + 1e-4);
  REQUIRE(straight.report.converged);
  CHECK(straight.report.perturbations == 0);
  CHECK_FALSE(straight.report.unstable);
  CHECK(at(straight.x.data(), 2).norm() < 1e-9);
  const Structure bent = settled(greatest - 1e-3);
  REQUIRE(bent.report.converged);
  CHECK(bent.report.perturbations > 0);
  CHECK_FALSE(bent.report.unstable);
  // Reference: minimum of energy over the positions of the joint.
  auto energy = [&](double y, double z, double half) {
    auto stored = [](double stiffness, double length, double rest, bool pushes) {
      const double strain = length / rest - 1.0;
      return strain > 0.0 || pushes ? 0.5 * stiffness * rest * strain * strain : 0.0;
    };
    return 2.0 * stored(push, std::sqrt(half * half + y * y + z * z), 1.0, true) +
           stored(string, std::hypot(c - y, z), b, false) +
           stored(string, std::hypot(c + y, z), b, false) +
           stored(string, std::hypot(c - z, y), b, false) +
           stored(string, std::hypot(c + z, y), b, false);
  };
  const Vector aside = at(bent.x.data(), 2);
  CHECK(std::abs(aside.x()) < 1e-9);
  CHECK(aside.norm() > 0.01);
  const double here = energy(aside.y(), aside.z(), greatest - 1e-3);
  CHECK(here < energy(0.0, 0.0, greatest - 1e-3));
  for (int k = 0; k < 8; ++k) {
    const double turn = k * pi / 4;
    CHECK(here <= energy(aside.y() + 1e-4 * std::cos(turn), aside.z() + 1e-4 * std::sin(turn),
                         greatest - 1e-3));
  }
}

TEST_CASE("settle() reports a solve that does not converge") {
  Random random(20260443);
  Structure s = ladder(random, 1.0);
  SettleControl control;
  control.iterations = 2;
  int seen = 0;
  control.watch = [&](const SettleProgress& progress) {
    CHECK(progress.iteration == seen++);
    return true;
  };
  const SettleReport& report = s.settle(control);
  CHECK_FALSE(report.converged);
  CHECK(report.iterations == 2);
  CHECK(report.factorisations == 2);
  CHECK(report.residual > control.tolerance);
  CHECK(report.worst_node >= 4);
  CHECK(seen == 3);
  CHECK(is_finite(s));
}

TEST_CASE("watch function stops the solve") {
  Random random(20260444);
  Structure s = ladder(random, 1.0);
  SettleControl control;
  control.watch = [](const SettleProgress& progress) { return progress.iteration < 4; };
  CHECK_FALSE(s.settle(control).converged);
  CHECK(s.report.iterations == 4);
}

TEST_CASE("model without free nodes counts as settled") {
  Structure s;
  const int a = s.node({0.0, 0.0, 0.0}, true), b = s.node({1.0, 0.0, 0.0}, true);
  s.bar(a, b, 0.9, s.material(1e4));
  CHECK(s.settle().converged);
  CHECK(s.x == std::vector<double>{0.0, 0.0, 0.0, 1.0, 0.0, 0.0});
}

TEST_CASE("floating node ends the solve unconverged with finite positions") {
  for (const double mass : {0.0, 2.0}) {  // without mass the matrix is singular
    CAPTURE(mass);
    Random random(20260446);
    Structure s = ladder(random, 0.1);
    const int stray = s.node({3.0, 2.0, 1.0});
    s.pull(stray, {0.0, 0.0, -20.0});
    s.model.mass[stray] = mass;
    CHECK_FALSE(s.settle().converged);
    CHECK(is_finite(s));
  }
}
