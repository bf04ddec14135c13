// Grouped meshes: lambda twines of a flat panel in both directions as one equivalent bar, lambda
// lines in parallel and lambda bars long, keep what the panel does in the water.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

constexpr double bar = 0.03;  // m
constexpr double strain = 0.01;

// Sixteen meshes by sixteen in the plane of `across` and `down`.
struct Panel {
  Model model;
  std::vector<double> x;

  int add(const Vector& place) {
    x.insert(x.end(), place.data(), place.data() + 3);
    return model.nodes++;
  }
  void join(int a, int b, double rest, double lines) {
    model.bars.node.push_back(a);
    model.bars.node.push_back(b);
    model.bars.rest.push_back(rest);
    model.bars.multiplicity.push_back(lines);
    model.bars.material.push_back(0);
  }
  void knot(int node, double number) {
    model.spheres.node.push_back(node);
    model.spheres.drag_area.push_back(0.785 * 0.004 * 0.004 * number);
    model.spheres.diameter.push_back(0.004);
    model.spheres.added_mass.push_back(1e-8 * number);
  }
};

// diamond: nodes where i + j is even, bars along the diagonals; square: bars along i and j, those
// on the panel's edges shared with its neighbours, so half of them.
void build(Panel& panel, bool diamond, int lambda, const Vector& across, const Vector& down) {
  const int cells = (diamond ? 32 : 16) / lambda;
  const int width = cells + 1;
  const double step = lambda * (1.0 + strain) * bar;
  std::vector<int> node(static_cast<std::size_t>(width) * width, -1);
  auto at_cell = [&](int i, int j) -> int& {
    return node[static_cast<std::size_t>(j * width + i)];
  };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      if (diamond && (i + j) % 2 == 1) continue;
      at_cell(i, j) = panel.add(step * (i * across + j * down));
      const double edge = (i == 0 || i == cells ? 0.5 : 1.0) * (j == 0 || j == cells ? 0.5 : 1.0);
      panel.knot(at_cell(i, j), edge * lambda * lambda);
    }
  }
  const double rest = lambda * bar;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      if (diamond) {
        if (i == cells || j == cells) continue;
        const bool falling = (i + j) % 2 == 0;
        panel.join(falling ? at_cell(i, j) : at_cell(i + 1, j),
                   falling ? at_cell(i + 1, j + 1) : at_cell(i, j + 1), rest, lambda);
      } else {
        const double row = j == 0 || j == cells ? 0.5 : 1.0;
        const double column = i == 0 || i == cells ? 0.5 : 1.0;
        if (i < cells) panel.join(at_cell(i, j), at_cell(i + 1, j), rest, row * lambda);
        if (j < cells) panel.join(at_cell(i, j), at_cell(i, j + 1), rest, column * lambda);
      }
    }
  }
}

struct Totals {
  Vector force = Vector::Zero();
  Matrix added_mass = Matrix::Zero();
  double twine = 0.0;   // m; weight is in proportion
  double energy = 0.0;  // J
};

Totals totals(Panel& panel, const CylinderLaw& law, const Vector& current) {
  Model& m = panel.model;
  TwineMaterial material;
  material.axial_stiffness = 2e3;
  material.diameter = 0.0017;
  material.volume_per_length = 2e-6;
  material.law = law;
  m.materials = {material};
  m.water.current = {current};
  m.held.assign(m.nodes, 0);
  m.load.assign(panel.x.size(), 0.0);
  m.mass.assign(m.nodes, 0.0);
  m.prepare();
  Assembly assembly(m);
  const std::vector<double> v(panel.x.size(), 0.0);
  std::vector<double> force(panel.x.size()), mass(3 * panel.x.size());
  assembly.move_to(panel.x.data(), v.data());
  assembly.residual(force.data());
  assembly.mass(mass.data());
  Totals out;
  for (int n = 0; n < m.nodes; ++n) {
    out.force += at(force.data(), n);
    out.added_mass += Eigen::Map<const Block>(&mass[9 * static_cast<std::size_t>(n)]);
  }
  for (int b = 0; b < m.bars.count(); ++b) {
    const Line<2> line = m.bars.line(b);
    out.twine += line.multiplicity * line.rest;
    out.energy +=
        line.multiplicity * twine_energy(material, line.length(panel.x.data()), line.rest);
  }
  return out;
}

void check_grouping(bool diamond) {
  Random random(20260431);
  for (const CylinderLaw& law : cylinder_laws()) {
    CAPTURE(static_cast<int>(law.kind));
    const Vector current(random.between(0.3, 1.0), random.between(-0.5, 0.5), 0.0);
    Vector across = random.vector(1.0).normalized();
    Vector down = random.vector(1.0).cross(across).normalized();
    if (diamond) {  // hanging ratio 0.4: bars of length 1 span 0.4 across and the rest down
      across *= 0.4;
      down *= std::sqrt(1.0 - 0.16);
    }
    Totals single;
    for (const int lambda : {1, 2, 4}) {
      CAPTURE(lambda);
      Panel panel;
      build(panel, diamond, lambda, across, down);
      const Totals found = totals(panel, law, current);
      if (lambda == 1) {
        single = found;
        // Two families of 16 x 16 bars, or of half of 32 x 32.
        CHECK(found.twine == doctest::Approx((diamond ? 1024 : 512) * bar).epsilon(1e-12));
        CHECK(found.force.norm() > 1.0);
        continue;
      }
      // Sums of up to 1000 terms; tensions cancel in the force, and strains of 0.01 come from
      // coordinates of 1 m with 1e-16 / (0.01 x 0.03).
      CHECK((found.force - single.force).norm() < 1e-10 * single.force.norm());
      CHECK((found.added_mass - single.added_mass).norm() < 1e-12 * single.added_mass.norm());
      CHECK(found.twine == doctest::Approx(single.twine).epsilon(1e-12));
      CHECK(found.energy == doctest::Approx(single.energy).epsilon(1e-10));
    }
  }
}

}  // namespace

TEST_CASE("grouped square netting keeps drag, mass, twine and stiffness") { check_grouping(false); }

TEST_CASE("grouped diamond netting keeps drag, mass, twine and stiffness") { check_grouping(true); }
