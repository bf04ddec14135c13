// Line kernels process many lines at a time: every register lane and every kernel set must agree.
#include <doctest/doctest.h>

#include <cmath>

#include "random_model.hpp"

namespace {

using namespace codend;

struct Found {
  std::vector<double> force, dual_force, stiffness, both, strain, change, damping, mass;
  double rotation = 0.0;
};

// Results that are sums over all lines, compared to the last bit.
constexpr std::vector<double> Found::*sums[] = {&Found::force, &Found::dual_force,
                                                &Found::stiffness, &Found::both, &Found::damping};

void append(std::vector<double>& to, const double* from, int count) {
  to.insert(to.end(), from, from + count);
}

// Computes all results of lines; sums over elements are added to `out`.
void add(const Model& model, const LineKernels& kernels, const FreePoints& free,
         const BlockPattern& pattern, const std::vector<double>& points,
         const std::vector<double>& speeds, const std::vector<double>& moved, Found& out) {
  Lines lines(model.materials, model.bars, model.cells, model.hexagons, model.water, model.slack,
              kernels);
  lines.set_flow({points.data(), speeds.data(), &model.water});
  lines.move_to(points.data());
  std::vector<double> tension, modulus;  // unique for each line
  for (int k = 0; k < lines.count(); ++k) {
    tension.push_back(2.0 + lines.arrays().strain[k]);
    modulus.push_back(5.0 + lines.arrays().strain[k]);
  }
  const BlockPlaces bars(free, pattern, {2, model.bars.node});
  const BlockPlaces cells(free, pattern, {4, model.cells.node});
  const BlockPlaces hexagons(free, pattern, {4, model.hexagons.node});
  auto jacobian = [&](const JacobianRequest& request, const double* moduli,
                      std::vector<double>& values) {
    values.resize(9 * pattern.column.size());
    lines.add_jacobian(request, tension.data(), moduli, bars.into(values.data()),
                       cells.into(values.data()), hexagons.into(values.data()));
  };
  out.force.resize(points.size());
  out.dual_force.resize(points.size());
  out.damping.resize(points.size() / 3);
  out.mass.resize(3 * points.size());
  lines.add_force(lines.arrays().tension, out.force.data());
  lines.add_force(tension.data(), out.dual_force.data());
  jacobian({1.0, 0.0}, nullptr, out.stiffness);
  jacobian({0.7, 1.3}, modulus.data(), out.both);
  lines.add_drag_scale(out.damping.data());
  lines.add_added_mass(out.mass.data());
  std::vector<double> change(static_cast<std::size_t>(lines.count()));
  out.rotation = std::max(out.rotation, lines.change(moved.data(), change.data()));
  append(out.strain, lines.arrays().strain, lines.count());
  append(out.change, change.data(), lines.count());
}

// One element of a model, or all if it is -1.
Model part(const Model& model, int bar, int cell, int hexagon) {
  Model out = model;
  auto keep = [](int element, int count, auto&... arrays) {
    auto cut = [&](auto& values) {
      const auto width = static_cast<std::ptrdiff_t>(values.size()) / count;
      const auto begin = values.begin() + width * element;
      values = {begin, begin + width};
    };
    (cut(arrays), ...);
  };
  auto& bars = out.bars;
  auto& cells = out.cells;
  auto& hexagons = out.hexagons;
  if (bar >= 0) {
    keep(bar, bars.count(), bars.node, bars.rest, bars.multiplicity, bars.material);
  } else if (cell >= 0) {
    keep(cell, cells.count(), cells.node, cells.twine, cells.rest, cells.multiplicity,
         cells.material);
  } else if (hexagon >= 0) {
    keep(hexagon, hexagons.count(), hexagons.node, hexagons.twine, hexagons.straight,
         hexagons.oblique, hexagons.multiplicity, hexagons.material);
  }
  const bool one = bar >= 0 || cell >= 0 || hexagon >= 0;
  if (one && bar < 0) bars = {};
  if (one && cell < 0) cells = {};
  if (one && hexagon < 0) hexagons = {};
  out.prepare();
  return out;
}

// Visits models with every number of lines that can remain in a register, for every drag model,
// some with lines of another model.
template <class Check>
void each_model(Check check) {
  Random random(20260451);
  for (const CylinderLaw& law : cylinder_laws()) {
    for (const bool layered : {false, true}) {
      for (int count = 1; count <= 9; ++count) {
        CAPTURE(static_cast<int>(law.kind));
        CAPTURE(layered);
        CAPTURE(count);
        Ingredients wanted;
        wanted.bars = count;
        wanted.cells = 9 - count;
        wanted.hexagons = count % 4;
        wanted.law = law;
        wanted.layered = layered;
        wanted.damping = count % 3 ? 0.0 : 0.3;
        wanted.slack = count % 2 ? SlackDrag::curved : SlackDrag::straight;
        Specimen s(random, wanted);
        s.model.materials.push_back(s.model.materials[0]);
        s.model.materials[1].law = {};
        s.model.bars.material[0] = 1;
        Assembly assembly(s.model);
        assembly.move_to(s.x.data(), s.v.data());
        const std::size_t size = 3 * static_cast<std::size_t>(s.model.points());
        const std::vector<double> points(assembly.field().position,
                                         assembly.field().position + size);
        const std::vector<double> speeds(assembly.field().velocity,
                                         assembly.field().velocity + size);
        std::vector<double> moved;
        for (std::size_t k = 0; k < size; ++k) moved.push_back(random.between(-1.0, 1.0));
        const FreePoints free(s.model);
        auto all = [&](const Model& model, const LineKernels& kernels, Found& out) {
          add(model, kernels, free, assembly.pattern(), points, speeds, moved, out);
        };
        check(s.model, all);
      }
    }
  }
}

void check_places(const LineKernels& kernels) {
  each_model([&](const Model& model, auto all) {
    Found together, alone;
    all(part(model, -1, -1, -1), kernels, together);
    for (int b = 0; b < model.bars.count(); ++b) all(part(model, b, -1, -1), kernels, alone);
    for (int e = 0; e < model.cells.count(); ++e) all(part(model, -1, e, -1), kernels, alone);
    for (int e = 0; e < model.hexagons.count(); ++e) all(part(model, -1, -1, e), kernels, alone);
    for (const auto sum : sums) CHECK(together.*sum == alone.*sum);
    CHECK(together.rotation == alone.rotation);
  });
}

// 1.1e-16 per operation, about a hundred operations, and ten times that where terms cancel.
void check_close(const std::vector<double>& a, const std::vector<double>& b,
                 double tolerance = 1e-13) {
  REQUIRE(a.size() == b.size());
  double scale = 0.0, worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    scale = std::max(scale, std::abs(a[k]));
    worst = std::max(worst, std::abs(a[k] - b[k]));
  }
  CHECK(worst <= tolerance * scale);
}

}  // namespace

TEST_CASE("line results are identical alone and among others") {
  SUBCASE("portable kernels") { check_places(portable_line_kernels()); }
  SUBCASE("AVX2 kernels") {
    if (avx2_line_kernels()) check_places(*avx2_line_kernels());
  }
}

TEST_CASE("screen forces of all instruction sets agree") {
  if (!avx2_line_kernels()) return;
  Random random(20261130);
  for (const CylinderLaw& law : cylinder_laws()) {
    NettingStrip strip;
    NettingStrip::Twines twines;
    TwineMaterial material;
    material.diameter = 0.002;
    material.law = law;
    strip.twines = &twines;
    strip.count = 11;
    strip.density = 1025.0;
    strip.viscosity = 1.19e-6;
    strip.drag_multiplier = strip.lift_multiplier = 1.0;
    twines.curved = twines.by_speed = true;
    for (int k = 0; k < 3; ++k) strip.range[k] = range_of(static_cast<NettingScreenLaw>(k));
    for (int k = 0; k < 16; ++k) {
      strip.law[k] = random.below(3);
      strip.twine_area[k] = random.between(0.01, 1.0);
      strip.overlap[k] = random.below(2) ? 0.25 : 0.0;
      strip.diameter[k] = material.diameter;
      strip.multiplicity[k] = 1.0;
      twines.inverse_rest[k] = random.between(0.5, 2.0);
      twines.drag_weight[k] = twines.own[k] = 1.0;
      twines.normal[k] = law.normal;
      twines.tangential[k] = law.tangential;
      twines.skin[k] = law.skin;
      twines.speed_law[k] = random.below(4) ? &material : nullptr;
      for (int c = 0; c < 3; ++c) {
        strip.u[c][k] = random.between(-1.0, 1.0);
        for (int f = 0; f < 2; ++f) {
          strip.across[f][c][k] = random.between(-1.0, 1.0);
          twines.e[f][c][k] = random.between(-1.0, 1.0);
        }
      }
    }
    NettingStrip portable = strip;
    portable_line_kernels().set_screen_forces(portable);
    avx2_line_kernels()->set_screen_forces(strip);
    for (int c = 0; c < 3; ++c) {
      // The polynomial of Kristiansen and Faltinsen loses four digits by cancellation.
      check_close({portable.force[c], portable.force[c] + strip.count},
                  {strip.force[c], strip.force[c] + strip.count}, 1e-11);
    }
  }
}

TEST_CASE("line kernels of all instruction sets agree") {
  if (!avx2_line_kernels()) return;
  each_model([&](const Model& model, auto all) {
    Found portable, wide;
    const Model whole = part(model, -1, -1, -1);
    all(whole, portable_line_kernels(), portable);
    all(whole, *avx2_line_kernels(), wide);
    for (const auto sum : sums) check_close(portable.*sum, wide.*sum);
    for (const auto each : {&Found::strain, &Found::change, &Found::mass}) {
      check_close(portable.*each, wide.*each);
    }
  });
}
