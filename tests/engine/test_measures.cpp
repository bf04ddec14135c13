// Measures of random gears: their derivatives equal differences, and known values of simple shapes.
#include <doctest/doctest.h>

#include <cmath>

#include "base/names.hpp"
#include "base/pi.hpp"
#include "hanging_panel.hpp"
#include "measure/measures.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

// A panel of random meshes on a line, a laced rope along its side, a free rope across it, and a
// plate.
Gear random_gear(Random& random) {
  const MeshOrientation orientations[] = {MeshOrientation::diamond, MeshOrientation::square,
                                          MeshOrientation::turned};
  Gear gear =
      hanging_panel(random.below(2) == 1, orientations[random.below(3)], NettingDrag::morison);
  GearPanel& panel = gear.panels[0];
  panel.upper = 20 + random.below(40);
  panel.lower = 10 + random.below(40);
  panel.lost_left = panel.lost_right = (panel.upper - panel.lower) / 2;
  panel.deep = 15 + random.below(20);
  panel.twine_diameter = random.between(0.001, 0.004);
  GearRope rope;
  rope.from = 2;  // the panel's upper left corner
  rope.to = 5;    // its lower right corner
  rope.length = random.between(4, 6);
  rope.diameter = 0.01;
  rope.mass_per_length = random.between(0.05, 0.2);
  rope.volume_per_length = 8e-5;
  gear.ropes.push_back(rope);
  gear.rope_count = 2;
  return gear;
}

// All measures of such a gear.
Questions all_of(const Gear& gear) {
  Questions out;
  out.speed = 1.5;
  out.nets = {{{0, 1}, {2, 5}}};
  out.has_propulsion = true;
  out.propulsion = {{0, 1, 3}, {9e4, 7e4, 1e4}, 3e5, {0.1, 1}, {7e-8, 6e-8}, 840, 0.5};
  for (std::size_t k = 0; k < names_of(MeasureKind{}).size(); ++k) {
    AskedMeasure one;
    one.kind = static_cast<MeasureKind>(k);
    one.places = {2, 5};
    one.ropes = {0, 1};
    one.panels = {0};
    one.parts = {0, 2, 3};
    one.plates = {0};
    one.angle = MeasureAngle::heel;
    one.of = 3.0;
    if (one.kind == MeasureKind::angle) one.angle = MeasureAngle::declination;
    one.at = MeasureAt::max;
    if (one.kind == MeasureKind::angle) one.at = MeasureAt::middle;
    out.measures.push_back(one);
    for (const MeasureAt at : {MeasureAt::start, MeasureAt::middle, MeasureAt::end}) {
      one.at = at;
      if (one.kind == MeasureKind::tension) out.measures.push_back(one);
    }
    one.angle = MeasureAngle::divergence;
    if (one.kind == MeasureKind::angle) out.measures.push_back(one);
  }
  REQUIRE(gear.places() > 5);
  return out;
}

// The parts of the mesh's model that measures use.
Model model_of(const Mesh& mesh, Random& random) {
  Model model;
  model.nodes = mesh.nodes;
  for (std::size_t k = 0; k < mesh.ties.share.size(); ++k) {
    model.ties.push_back({mesh.ties.first[k], mesh.ties.second[k], mesh.ties.share[k]});
  }
  model.bars = mesh.bars;
  model.water.depth = {0, 2};
  model.water.current = {Vector(1.5, 0.1, 0), Vector(1.2, -0.1, 0)};
  model.ground.present = true;
  model.ground.normal = random.vector(1).normalized();
  model.contacts.node = {0};
  return model;
}

FilledBag random_bag(const Mesh& mesh, Random& random) {
  FilledBag bag;
  for (std::size_t c = 0; c < mesh.cells.rest.size(); ++c) {
    bag.node.insert(bag.node.end(), &mesh.cells.node[4 * c], &mesh.cells.node[4 * c] + 3);
    for (int k = 0; k < 3; ++k) {
      bag.depth.push_back(mesh.cells.twine[8 * c + 2 * k] + 0.01 * random.below(9));
      bag.across.push_back(mesh.cells.twine[8 * c + 2 * k + 1]);
    }
    bag.real.push_back(random.between(0.5, 1));
    bag.weight.push_back(random.between(0.5, 1));
  }
  bag.blocked = 9.005;
  return bag;
}

// Numbers of a shape in sequence, and their count.
template <class T, class Visit>
void each(MeasuredShape<T>& shape, Visit visit) {
  for (std::vector<T>* all :
       {&shape.position, &shape.velocity, &shape.force, &shape.bar_tension, &shape.u_tension,
        &shape.v_tension, &shape.straight_tension, &shape.attack, &shape.heel, &shape.trim}) {
    for (T& one : *all) visit(one);
  }
  for (std::vector<T>& all : shape.forces) {
    for (T& one : all) visit(one);
  }
}

template <class T>
MeasuredShape<T> sized_shape(const Mesh& mesh, const MeasureFrame& frame) {
  MeasuredShape<T> out;
  const std::size_t nodes = 3 * static_cast<std::size_t>(mesh.nodes);
  out.position.resize(nodes);
  out.velocity.resize(nodes);
  out.force.resize(nodes);
  out.bar_tension.resize(mesh.bars.rest.size());
  out.u_tension.resize(mesh.cells.rest.size());
  out.v_tension = out.straight_tension = out.u_tension;
  out.attack.resize(1);
  out.heel = out.trim = out.attack;
  for (const ReportedForce& force : reported_forces()) {
    const std::string kind = force.kind;
    const std::size_t count = kind == "bars"       ? frame.part.bars.size()
                              : kind == "cells"    ? frame.part.cells.size()
                              : kind == "spheres"  ? frame.part.spheres.size()
                              : kind == "contacts" ? 1
                                                   : 0;
    out.forces.emplace_back(3 * count);
  }
  return out;
}

// Returns one measure of nodes at x, each a position, and of ropes along them with one bar each.
double drawn(const std::vector<double>& x, const std::vector<std::vector<int>>& ropes,
             const AskedMeasure& asked, const Vector& current = Vector::Zero()) {
  MeasureFrame frame;
  Model model;
  model.water.current = {current};
  model.nodes = frame.nodes = frame.points = static_cast<int>(x.size() / 3);
  for (int k = 0; k < frame.nodes; ++k) frame.places.push_back(k);
  frame.next_places = frame.places;
  frame.next_weights.assign(frame.places.size(), 0.0);
  for (std::size_t r = 0; r < ropes.size(); ++r) {
    frame.ropes.push_back({ropes[r]});
    frame.part.bars.push_back(static_cast<int>(r));
    model.bars.node.insert(model.bars.node.end(), {ropes[r].front(), ropes[r].back()});
    model.bars.rest.push_back(1);
  }
  MeasuredShape<double> shape;
  shape.position = x;
  Questions questions;
  questions.measures = {asked};
  return measure(frame, model, questions, nullptr, shape)[0];
}

}  // namespace

TEST_CASE("measures of random gears change by their derivatives") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const Gear gear = random_gear(random);
    const Mesh mesh = mesh_of(gear, 150);
    const MeasureFrame frame = measure_frame(gear, mesh);
    const Model model = model_of(mesh, random);
    const Questions questions = all_of(gear);
    const FilledBag bag = random_bag(mesh, random);

    MeasuredShape<double> shape = sized_shape<double>(mesh, frame);
    std::vector<double> value, change;
    each(shape, [&](double& one) { one = random.between(0.5, 2); });
    for (std::size_t k = 0; k < shape.position.size(); ++k) {
      shape.position[k] = mesh.start[k] + random.between(-0.05, 0.05);
    }
    each(shape, [&](double& one) {
      value.push_back(one);
      change.push_back(random.between(-1, 1));
    });
    MeasuredShape<Dual> moving = sized_shape<Dual>(mesh, frame);
    std::size_t next = 0;
    each(moving, [&](Dual& one) {
      one = {value[next], change[next]};
      ++next;
    });
    const std::vector<Dual> found = measure(frame, model, questions, &bag, moving);

    // Central differences: error of a third derivative times h^2, and rounding over h.
    constexpr double h = 1e-6;
    std::vector<double> side[2];
    for (const int way : {0, 1}) {
      next = 0;
      each(shape, [&](double& one) {
        one = value[next] + (way == 1 ? h : -h) * change[next];
        ++next;
      });
      side[way] = measure(frame, model, questions, &bag, shape);
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      CAPTURE(seed);
      CAPTURE(name_of(questions.measures[k].kind));
      // no cells, or no bag of cells
      if (mesh.cells.rest.empty() && !std::isfinite(found[k].value)) continue;
      REQUIRE(std::isfinite(found[k].value));
      CHECK((side[0][k] + side[1][k]) / 2 == doctest::Approx(found[k].value).epsilon(1e-7));
      const double slope = (side[1][k] - side[0][k]) / (2 * h);
      // the derivative omits parts of the twine's shadow that move from cell to cell
      if (questions.measures[k].kind == MeasureKind::mouth_blockage) continue;
      const double size = std::abs(slope) + std::abs(found[k].value);
      CHECK(std::abs(found[k].change - slope) <= 2e-5 * size);
    }
  }
}

TEST_CASE("spread, height, length and depth are differences of coordinates") {
  const std::vector<double> x = {0, 7, 0, -10, 14, -12, -50, -62, -5, 0, 8, -5};
  const auto of = [&](MeasureKind kind, std::vector<int> places) {
    AskedMeasure asked;
    asked.kind = kind;
    asked.places = std::move(places);
    return drawn(x, {}, asked);
  };
  CHECK(of(MeasureKind::spread, {0, 1}) == doctest::Approx(std::hypot(10, 7)));
  CHECK(of(MeasureKind::spread, {0, 1, 3, 2}) ==
        doctest::Approx((std::hypot(10, 7) + std::hypot(50, 70)) / 2));
  CHECK(of(MeasureKind::height, {0, 1}) == doctest::Approx(12));
  CHECK(of(MeasureKind::height, {1, 0}) == doctest::Approx(-12));
  CHECK(of(MeasureKind::length, {0, 1}) == doctest::Approx(std::sqrt(100 + 49 + 144)));
  CHECK(of(MeasureKind::depth, {1, 2}) == doctest::Approx(8.5));
}

TEST_CASE("mouth area equals the polygon of ropes in any order") {
  // A house: a square of 4 m with a roof of 2 m, 16 + 4 m2, inclined aft and forward, and on
  // another course. A straight line closes the gap.
  const double y[] = {0, 4, 4, 2, 0}, z[] = {0, 0, 4, 6, 4};
  for (const double course : {0.0, 0.3, 1.5707963267948966}) {
    std::vector<double> x;
    for (int k = 0; k < 5; ++k) {
      const double ahead = 0.4 * z[k];
      x.insert(x.end(), {std::cos(course) * ahead - std::sin(course) * y[k],
                         std::sin(course) * ahead + std::cos(course) * y[k], z[k]});
    }
    AskedMeasure area;
    area.kind = MeasureKind::area;
    const std::vector<std::vector<int>> ropes = {{0, 1}, {2, 1}, {2, 3, 4}, {4, 0}};
    for (const std::vector<int>& order :
         {std::vector<int>{0, 1, 2, 3}, {2, 0, 3, 1}, {3, 2, 1, 0}}) {
      area.ropes = order;
      CHECK(drawn(x, ropes, area) == doctest::Approx(20));
    }
    area.ropes = {0, 2};
    CHECK(drawn(x, ropes, area) == doctest::Approx(20));
    area.ropes = {0};
    CHECK(drawn(x, ropes, area) == doctest::Approx(0));
  }
}

TEST_CASE("declination is the angle below horizontal and divergence that from the flow") {
  const auto degrees = [&](double dx, double dy, double dz, MeasureAngle angle,
                           const Vector& current = Vector::Zero()) {
    AskedMeasure asked;
    asked.kind = MeasureKind::angle;
    asked.ropes = {0};
    asked.at = MeasureAt::start;
    asked.angle = angle;
    return drawn({1, 1, -1, 1 + dx, 1 + dy, -1 + dz}, {{0, 1}}, asked, current) * 180 / pi;
  };
  CHECK(degrees(1, 0, -1, MeasureAngle::declination) == doctest::Approx(45));
  CHECK(degrees(3, 4, -5, MeasureAngle::declination) == doctest::Approx(45));
  CHECK(degrees(1, 0, 1, MeasureAngle::declination) == doctest::Approx(-45));
  CHECK(degrees(std::sqrt(3), 1, -9, MeasureAngle::divergence) == doctest::Approx(30));
  CHECK(degrees(std::sqrt(3), -1, -9, MeasureAngle::divergence) == doctest::Approx(30));
  // The same in a current along y.
  CHECK(degrees(1, std::sqrt(3), -9, MeasureAngle::divergence, Vector(0, 0.5, 0)) ==
        doctest::Approx(30));
}

TEST_CASE("twine shadow counts overlapping bars across the flow once") {
  // Twine of 2 mm; squares of 50 mm, diamonds 30 mm wide and 90 mm deep.
  for (const bool bars : {false, true}) {
    for (const MeshOrientation orientation : {MeshOrientation::square, MeshOrientation::diamond}) {
      const bool square = orientation == MeshOrientation::square;
      const double across = square ? 0.05 : 0.03, down = square ? 0.05 : 0.09;
      const double bar = std::hypot(across, down) / 2;
      const double shown = square ? 0.002 / 0.05 : 0.002 * 2 * bar / (across * down);
      const double through = (1 - shown) * (1 - shown);
      Gear gear = hanging_panel(bars, orientation, NettingDrag::morison);
      gear.panels[0].lower = gear.panels[0].upper;
      const double area = gear.panels[0].upper * gear.panels[0].deep * across * down;
      for (const int layers : {1, 2}) {
        if (layers == 2) gear.panels.push_back(gear.panels[0]);
        gear.panel_count = layers;
        const Mesh mesh = mesh_of(gear, 300);
        const MeasureFrame frame = measure_frame(gear, mesh);
        std::vector<double> x(3 * mesh.mass.size(), 0.0);
        const PartMap map = part_map(gear, mesh.division, mesh.nodes, mesh.panels);
        for (const PanelPlace& place : panel_places(gear, map)) {
          const GearPanel& panel = gear.panels[place.panel];
          at(x.data(), place.node) =
              Vector(0, place.s * panel.upper * across, -place.t * panel.deep * down);
        }
        for (std::size_t k = 0; k < mesh.ties.share.size(); ++k) {
          const double share = mesh.ties.share[k];
          at(x.data(), mesh.nodes + static_cast<int>(k)) =
              (1 - share) * at(x.data(), mesh.ties.first[k]) +
              share * at(x.data(), mesh.ties.second[k]);
        }
        const auto found = mesh_places(frame.meshes, x);
        CHECK(found[0].opening == doctest::Approx(across).epsilon(1e-9));
        // bars are spaced unevenly, so grid cells contain more or fewer
        const double hidden = twine_shadow(frame.meshes, found, {0, 1, 0}, {0, 0, 1}) / area;
        CHECK(hidden == doctest::Approx(1 - std::pow(through, layers)).epsilon(0.05));
        // along the flow only the edge of the netting is visible
        CHECK(twine_shadow(frame.meshes, found, {1, 0, 0}, {0, 0, 1}) < 1e-3 * area);
      }
    }
  }
}

TEST_CASE("bag surface and pressure weights match a triangle and its half") {
  FilledBag bag;
  bag.node = {0, 1, 2};
  bag.depth = {0, 0, 2};
  bag.across = {0, 1, 0};
  bag.real = bag.weight = {1};
  const std::vector<double> x = {0, 0, 0, 3, 0, 0, 0, 4, 0};
  bag.blocked = 2;
  CHECK(bag_surface(bag, x) == doctest::Approx(6.0));
  for (const double weight : pressure_weights(bag)) CHECK(weight == doctest::Approx(1.0 / 3));
  // three quarters of the triangle are behind half the depth
  bag.blocked = 1;
  CHECK(bag_surface(bag, x) == doctest::Approx(4.5));
}
