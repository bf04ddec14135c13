// Random models and states, for tests that compare two parts of the engine.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "base/pi.hpp"
#include "model/assembly.hpp"
#include "model/changing_model.hpp"
#include "model/evaluate.hpp"

namespace codend {

// Returns the same numbers with every compiler, unlike std::uniform_real_distribution.
class Random {
 public:
  explicit Random(std::uint64_t seed) : source_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(source_() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(source_() % static_cast<std::uint64_t>(n)); }
  // Each component within +-size.
  Vector vector(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

 private:
  std::mt19937_64 source_;
};

struct Ingredients {
  int bars = 0, cells = 0, bodies = 0, knots = 0, smooth_spheres = 0;
  int lifts_up = 0, lifts_sideways = 0;
  int hexagons = 0, pressed = 0, screens = 0, blended = 0, openings = 0, bends = 0;
  int twists = 0;
  int plates = 0, contacts = 0, volumes = 0;
  int sliding = 0;  // ropes that slide through four points
  CylinderLaw law;
  SlackDrag slack = SlackDrag::curved;
  double diameter = 0.002;       // m, of lines
  double axial_stiffness = 1.0;  // N
  double damping = 0.0;          // c over L0, N s/m
  bool paid_out = false;         // bars with a pay-out speed each (check_derivatives())
  double density = 1025.0;       // kg/m3, of the water
  double current = 1.0;          // m/s, maximum of each component
  NettingScreenLaw screen_law = NettingScreenLaw::loland;
  bool layered = false;  // a current that varies with depth
  bool free_surface = false;
  bool waves = false;   // so long that the flow hardly changes along x and y
  bool wake = false;    // a flow slowed by netting, differently at every point
  bool struts = false;  // every other bar carries compression
  // Elastic friction displacement (m) before slip; 0: no sticking friction.
  double slip_distance = 0.0;
  bool multiplied = false;  // force components with multipliers
};

// Twelve nodes (two fixed) and four tied points in a box of 2 m, moving at random, with elements
// between random points. Lines are taut or slack by 3 % or more, so that a small difference does
// not cross their kink.
class Specimen {
 public:
  Specimen(Random& random, const Ingredients& wanted) {
    model.nodes = 12;
    model.held.assign(model.nodes, 0);
    model.held[3] = model.held[8] = 1;
    model.ties = {{0, 1, 0.3}, {3, 4, 0.6}, {8, 3, 0.5}, {5, 9, 0.125}};
    model.slack = wanted.slack;
    model.water.density = wanted.density;
    model.water.current = {horizontal(random, wanted.current)};
    if (wanted.layered) {
      model.water.depth = {0.4, 0.9, 1.7};
      for (int k = 0; k < 2; ++k) model.water.current.push_back(horizontal(random, wanted.current));
    }
    model.load.assign(3 * static_cast<std::size_t>(model.points()), 0.0);
    model.mass.assign(model.points(), 0.0);
    for (int n = 0; n < model.nodes; ++n) {
      const Vector place = random.vector(1.0) - Vector::UnitZ();
      const Vector speed = random.vector(0.7);
      x.insert(x.end(), place.data(), place.data() + 3);
      v.insert(v.end(), speed.data(), speed.data() + 3);
    }
    TwineMaterial material;
    material.axial_stiffness = wanted.axial_stiffness;
    material.damping = wanted.damping;
    material.diameter = wanted.diameter;
    material.volume_per_length = 0.785 * wanted.diameter * wanted.diameter;
    material.added_mass_tangential = 0.15;
    material.law = wanted.law;
    model.materials = {material, material, material};
    model.materials[1].strut = true;
    model.materials[2].axial_stiffness = 0.0;
    model.water.free_surface = wanted.free_surface;
    if (wanted.waves) {
      Waves& waves = model.water.waves;
      waves.amplitude = {0.3, 0.1};
      waves.frequency = {0.02, 0.03};
      waves.phase = {random.between(0.0, 6.0), random.between(0.0, 6.0)};
      waves.toward = {random.between(0.0, 6.0), random.between(0.0, 6.0)};
      waves.time = 100.0;
    }
    ground();
    fill(random, wanted);
    fill_netting(random, wanted);
    if (wanted.wake) {
      model.wake_sheets.node = {0, 1, 2};
      model.wake_sheets.twine_area = {0.1};
      model.wake_sheets.overlap = {0.25};
      model.wake_sheets.law = {WakeLaw::loland};
      for (int p = 0; p < model.points(); ++p) model.wake.push_back(random.between(0.3, 1.0));
    }
    if (wanted.multiplied) {
      model.multipliers = {std::vector<double>(model.materials.size(), 1.3), 0.8, 1.2, 0.7};
    }
    model.prepare();
    stretch(random);
    if (wanted.slip_distance > 0.0) stick(random, wanted.slip_distance);
  }
  Specimen(const Specimen&) = delete;

  Model model;
  std::vector<double> x, v;

 private:
  static Vector horizontal(Random& random, double size) {
    return {random.between(-size, size), random.between(-size, size), 0.0};
  }

  void points(Random& random, int count, std::vector<int>& out) {
    const std::size_t first = out.size();
    while (out.size() < first + static_cast<std::size_t>(count)) {
      const int point = random.below(model.points());
      if (std::find(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), point) ==
          out.end()) {
        out.push_back(point);
      }
    }
  }

  // Adds friction anchors up to half a metre away.
  void stick(Random& random, double give) {
    model.ground.slip_distance = give;
    Assembly assembly(model);
    assembly.move_to(x.data(), v.data());
    std::vector<Vector> anchor = assembly.ground_places();
    for (Vector& place : anchor) place += random.vector(0.5);
    ChangingModel(model, assembly).set_anchors(anchor);
  }

  // Soft ground, so that its forces are as large as drag; inclined.
  void ground() {
    Ground bed;
    bed.present = true;
    bed.normal = Vector(0.1, -0.2, 1.0).normalized();
    bed.height = -0.9;
    bed.velocity = 0.6 * (Vector::UnitX() - bed.normal.x() * bed.normal);
    bed.friction = 0.5;
    bed.stiffness = 300.0;
    bed.onset = 0.3;
    bed.slip = 0.2;
    model.ground = bed;
  }

  LiftingPlate lifting_plate(Random& random) {
    LiftingPlate board;
    board.attachment[0] = Vector(0.3, random.between(-0.3, -0.1), 0.1);
    board.attachment[1] = Vector(0.9, 0.1, random.between(0.3, 0.5));
    board.attachment[2] = Vector(1.0, 0.0, -0.4);
    board.side = random.below(2) ? 1.0 : -1.0;
    board.chord = 1.0;
    board.span = 1.6;
    board.area = 0.1;
    board.height = 1.6;
    board.level = random.below(2) == 1;
    board.pressure_centre = 0.4;
    board.pressure_wanders = random.below(2) == 1;
    board.weight = 20.0;
    board.buoyancy = 15.0;
    board.gravity_centre = {0.5, 0.1, -0.2};
    board.buoyancy_centre = {0.5, 0.0, 0.1};
    board.mass = 3.0;
    board.second_moment = {0.25, 0.01, 0.6};
    board.added_mass = 0.3;
    board.added_radius_chord = 0.2;
    board.added_radius_span = 0.4;
    board.normal_slope = 2.1;
    board.yaw_damping = 0.15;
    board.roll_damping = 0.08;
    board.shoe_area = 0.05;
    board.polar.angle = {-pi, -1.5, -0.3, 0.2, 0.8, 1.6, pi};
    board.polar.lift = {0.0, -0.5, -0.2, 0.9, 1.5, 0.1, 0.0};
    board.polar.drag = {0.2, 1.2, 0.3, 0.2, 0.8, 1.3, 0.2};
    board.polar.lift_slope = {-0.4, 0.0, 1.0, 1.2, 0.0, -1.0, -0.4};
    board.polar.drag_slope = {0.0, 0.0, -0.3, 0.5, 0.6, 0.0, 0.0};
    return board;
  }

  void fill(Random& random, const Ingredients& wanted) {
    for (int b = 0; b < wanted.bars; ++b) {
      points(random, 2, model.bars.node);
      model.bars.multiplicity.push_back(random.between(0.5, 4.0));
    }
    model.bars.rest.assign(wanted.bars, 1.0);
    model.bars.height.assign(wanted.bars, 1.5);
    for (int b = 0; b < wanted.bars; ++b) {
      model.bars.material.push_back(wanted.struts && b % 2 ? 1 : 0);
    }
    for (int r = 0; r < wanted.sliding; ++r) {
      std::vector<int> chain;
      points(random, 4, chain);
      SlidingRope rope;
      rope.axial_stiffness = wanted.axial_stiffness;
      rope.bend = 0.3;
      for (int k = 0; k < 3; ++k) {
        rope.bar.push_back(model.bars.count());
        model.bars.node.push_back(chain[static_cast<std::size_t>(k)]);
        model.bars.node.push_back(chain[static_cast<std::size_t>(k) + 1]);
        model.bars.rest.push_back(1.0);
        model.bars.height.push_back(1.5);
        model.bars.multiplicity.push_back(1.0);
        model.bars.material.push_back(2);
      }
      model.sliding.push_back(rope);
    }
    for (int e = 0; e < wanted.cells; ++e) {
      cell(random, model.cells.node, model.cells.twine);
      model.cells.multiplicity.push_back(random.below(2) ? 1.0 : 0.5);
    }
    model.cells.rest.assign(wanted.cells, 1.0);
    model.cells.material.assign(wanted.cells, 0);
    model.cells.height.assign(wanted.cells, 1.5);
    for (int s = 0; s < wanted.bodies + wanted.knots + wanted.smooth_spheres; ++s) {
      const bool smooth = s >= wanted.bodies + wanted.knots;
      points(random, 1, model.spheres.node);
      model.spheres.drag_area.push_back(random.between(0.01, 0.1));
      // smooth spheres, from Stokes flow to beyond the drag crisis
      model.spheres.diameter.push_back(s < wanted.bodies ? 0.0
                                       : smooth          ? std::pow(10.0, random.between(-5.0, 0.0))
                                                         : random.between(1e-5, 1e-2));
      model.spheres.smooth.push_back(smooth ? 1 : 0);
      model.spheres.added_mass.push_back(random.between(0.0, 0.01));
      model.spheres.height.push_back(random.between(0.5, 2.0));
    }
    for (int s = 0; s < wanted.lifts_up + wanted.lifts_sideways; ++s) {
      points(random, 1, model.lifts.node);
      model.lifts.lift_area.push_back(random.between(-0.1, 0.1));
      model.lifts.direction.push_back(s < wanted.lifts_up ? LiftDirection::up
                                                          : LiftDirection::sideways);
      model.lifts.height.push_back(random.between(0.5, 2.0));
    }
    for (int s = 0; s < wanted.plates; ++s) {
      std::vector<int> node;
      points(random, 3, node);
      model.plates.plate.push_back(lifting_plate(random));
      std::copy(node.begin(), node.end(), model.plates.plate.back().node.begin());
    }
    for (int s = 0; s < wanted.contacts; ++s) {
      points(random, 1, model.contacts.node);
      model.contacts.area.push_back(random.between(0.01, 0.1));
      model.contacts.clearance.push_back(random.between(0.0, 0.3));
    }
    for (int s = 0; s < wanted.volumes; ++s) {
      points(random, 1, model.volumes.node);
      model.volumes.buoyancy.push_back(random.between(1.0, 20.0));
      model.volumes.height.push_back(random.between(1.5, 4.0));
    }
  }

  // Twine coordinates of a triangle of about 3 bars.
  static void corners(Random& random, std::vector<double>& twine) {
    const double turn = random.between(0.0, 6.28);
    for (const double angle : {turn, turn + 1.6, turn + 3.9}) {
      twine.push_back(3.0 * std::cos(angle));
      twine.push_back(3.0 * std::sin(angle));
    }
  }

  // Corners of a cell of about 3 bars and their twine coordinates; every fourth has three corners.
  void cell(Random& random, std::vector<int>& node, std::vector<double>& twine) {
    points(random, 4, node);
    const bool pointed = random.below(4) == 0;
    if (pointed) node.back() = node[node.size() - 2];
    const double turn = random.between(0.0, 6.28), lean = random.between(-0.3, 0.3);
    for (const double angle : {turn, turn + 1.6 + lean, turn + 3.1, turn + (pointed ? 3.1 : 4.6)}) {
      twine.push_back(3.0 * std::cos(angle));
      twine.push_back(3.0 * std::sin(angle));
    }
  }

  void fill_netting(Random& random, const Ingredients& wanted) {
    for (int e = 0; e < wanted.hexagons; ++e) {
      points(random, 4, model.hexagons.node);
      corners(random, model.hexagons.twine);
      model.hexagons.multiplicity.push_back(random.below(2) ? 1.0 : 0.5);
    }
    model.hexagons.straight.assign(wanted.hexagons, 1.0);
    model.hexagons.oblique.assign(wanted.hexagons, 1.0);
    model.hexagons.material.assign(wanted.hexagons, 0);
    model.hexagons.height.assign(wanted.hexagons, 1.5);
    for (int e = 0; e < wanted.pressed; ++e) {
      points(random, 3, model.pressure.node);
      for (int k = 0; k < 3; ++k) model.pressure.weight.push_back(random.between(-0.33, 0.33));
      model.pressure.height.push_back(0.1);
    }
    for (int e = 0; e < wanted.screens; ++e) {
      cell(random, model.screens.node, model.screens.twine);
      // solidities from about 0.01 to beyond the range of the drag models
      model.screens.twine_area.push_back(random.between(0.01, 0.5));
      model.screens.overlap.push_back(random.below(2) ? 0.25 : 0.0);
      model.screens.diameter.push_back(wanted.diameter);
      model.screens.height.push_back(1.5);
      model.screens.multiplicity.push_back(random.below(2) ? 1.0 : 0.5);
      model.screens.law.push_back(wanted.screen_law);
    }
    for (int e = 0; e < wanted.blended; ++e) {
      cell(random, model.blended.node, model.blended.twine);
      // some bars taut, some slack
      model.blended.rest.push_back(random.between(0.05, 0.6));
      model.blended.multiplicity.push_back(random.below(2) ? 1.0 : 0.5);
      model.blended.overlap.push_back(random.below(2) ? 0.25 : 0.0);
    }
    model.blended.material.assign(wanted.blended, 0);
    model.blended.height.assign(wanted.blended, 1.5);
    model.blended.materials = model.materials;
    model.blended.slack = wanted.slack;
    for (int e = 0; e < wanted.openings; ++e) {
      cell(random, model.openings.node, model.openings.twine);
      model.openings.couple.push_back(random.between(0.1, 2.0));
      model.openings.angle.push_back(random.between(0.0, 3.1));
      model.openings.multiplicity.push_back(random.below(2) ? 1.0 : 0.5);
    }
    for (int e = 0; e < wanted.twists; ++e) {
      points(random, 4, model.twists.node);
      model.twists.weight.push_back(random.between(0.1, 2.0));
      model.twists.material.push_back(0);
    }
    for (int e = 0; e < wanted.bends; ++e) {
      points(random, 3, model.bends.node);
      model.bends.couple.push_back(random.between(0.1, 2.0));
      model.bends.length.push_back(random.between(0.5, 2.0));
    }
  }

  void stretch(Random& random) {
    Assembly assembly(model);
    std::vector<double> strain;
    assembly.move_to(x.data(), v.data());
    assembly.strain(strain);  // of lines with rest length 1: length - 1
    auto clear = [&](std::initializer_list<double> lengths) {
      const double low = *std::min_element(lengths.begin(), lengths.end());
      const double high = *std::max_element(lengths.begin(), lengths.end());
      for (;;) {
        const double rest = random.between(0.7 * low, 2.0 * high);
        bool ok = true;
        for (const double length : lengths) ok = ok && std::abs(length / rest - 1.0) > 0.03;
        if (ok) return rest;
      }
    };
    for (int b = 0; b < model.bars.count(); ++b) model.bars.rest[b] = clear({1.0 + strain[b]});
    // Three of four ropes are taut by about 10 %.
    for (std::size_t r = 0; r < model.sliding.size(); ++r) {
      const SlidingRope& rope = model.sliding[r];
      double length = 0.0;
      for (const int b : rope.bar) length += std::hypot(1.0 + strain[b], rope.bend);
      const double rest = length * (r % 4 == 3 ? 1.1 : random.between(0.85, 0.95));
      for (const int b : rope.bar) model.bars.rest[b] = rest / 3.0;
    }
    for (int e = 0; e < model.cells.count(); ++e) {
      const std::size_t k = static_cast<std::size_t>(model.bars.count() + e);
      const std::size_t cells = static_cast<std::size_t>(model.cells.count());
      model.cells.rest[e] = clear({1.0 + strain[k], 1.0 + strain[k + cells]});
    }
    const std::size_t first = static_cast<std::size_t>(model.hexagons.first_line);
    const std::size_t hexagons = static_cast<std::size_t>(model.hexagons.count());
    for (std::size_t e = 0; e < hexagons; ++e) {
      model.hexagons.straight[e] = clear({1.0 + strain[first + e]});
      model.hexagons.oblique[e] =
          clear({1.0 + strain[first + hexagons + e], 1.0 + strain[first + 2 * hexagons + e]});
    }
  }
};

// Drag (N) of one line of vector e (m) and rest length 1 m in water with the relative velocity u
// (m/s).
inline Vector line_drag(const TwineMaterial& material, const Vector& e, const Vector& u) {
  Model model;
  model.nodes = 2;
  model.held = {1, 1};
  model.load.assign(6, 0.0);
  model.mass.assign(2, 0.0);
  model.water.current = {u};
  model.materials = {material};
  model.bars.node = {0, 1};
  model.bars.rest = model.bars.multiplicity = {1.0};
  model.bars.material = {0};
  model.prepare();
  Assembly assembly(model);
  const double x[6] = {0.0, 0.0, 0.0, e.x(), e.y(), e.z()}, v[6] = {};
  const Evaluation found = evaluate(assembly, x, v);
  return at(found.reported("bar_drag").data(), 0);
}

// The four drag models of cylinders, with different coefficients.
inline std::vector<CylinderLaw> cylinder_laws() {
  return {{CylinderLawKind::constant, 1.2, 0.1, 0.02, 0.0},
          {CylinderLawKind::takagi, 0.0, 0.0, 0.0, 0.0},
          {CylinderLawKind::choo_casarella, 0.0, 0.0, 0.0, 0.0},
          {CylinderLawKind::cifuentes_kim, 0.0, 0.0, 0.0, 0.15}};
}

}  // namespace codend
