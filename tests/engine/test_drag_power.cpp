// Forces of the water on bodies: they dissipate energy, and remain finite at every state where a
// direction is undefined.
#include <doctest/doctest.h>

#include <cmath>

#include "filled_model.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

struct Power {
  double total, size;
};

// Power of all forces on the nodes and the sum of the absolute terms. The twist stiffness of
// netting is excluded because it is elastic.
Power power(Specimen& s) {
  Assembly assembly(s.model);
  std::vector<double> force(s.x.size());
  assembly.move_to(s.x.data(), s.v.data());
  assembly.residual(force.data());
  Power out{0.0, 0.0};
  for (std::size_t k = 0; k < force.size(); ++k) {
    out.total += force[k] * s.v[k];
    out.size += std::abs(force[k] * s.v[k]);
  }
  s.model.each_line([&](const auto& line) {
    out.total -= line.held_power(assembly.lines(), assembly.field().velocity);
  });
  return out;
}

// No tension, so that only water forces act.
Ingredients still_water() {
  Ingredients wanted;
  wanted.axial_stiffness = 0.0;
  wanted.current = 0.0;
  return wanted;
}

bool all_finite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

// Returns true if forces, derivatives and masses of a model at a state are finite.
bool is_finite(Specimen& s) {
  Assembly assembly(s.model);
  std::vector<double> force(s.x.size()), values(9 * assembly.pattern().column.size()),
      mass(3 * s.x.size());
  assembly.move_to(s.x.data(), s.v.data());
  assembly.residual(force.data());
  assembly.jacobian({1.0, 1.0}, values.data());
  assembly.mass(mass.data());
  return all_finite(force) && all_finite(values) && all_finite(mass);
}

template <class Check>
void each_law(Check check) {
  for (const CylinderLaw& law : cylinder_laws()) {
    for (const SlackDrag slack : {SlackDrag::curved, SlackDrag::straight}) {
      CAPTURE(static_cast<int>(law.kind));
      CAPTURE(static_cast<int>(slack));
      check(law, slack);
    }
  }
}

}  // namespace

TEST_CASE("drag in still water dissipates energy of every line") {
  Random random(20260421);
  each_law([&](const CylinderLaw& law, SlackDrag slack) {
    // One line each, so that errors of two lines cannot cancel; Re from 1e-2 to 2e6.
    for (const double diameter : {1e-8, 1e-5, 1e-4, 1e-3, 0.03, 0.3, 2.0}) {
      for (int repeat = 0; repeat < 10; ++repeat) {
        Ingredients wanted = still_water();
        wanted.law = law;
        wanted.slack = slack;
        wanted.diameter = diameter;
        wanted.bars = repeat % 3 == 0;
        wanted.cells = repeat % 3 == 1;
        wanted.hexagons = repeat % 3 == 2;
        Specimen s(random, wanted);
        CAPTURE(diameter);
        CHECK(power(s).total < 0.0);
      }
    }
  });
}

TEST_CASE("drag in still water dissipates energy of bodies, knots, screens, blended netting") {
  Random random(20260422);
  for (int Ingredients::*kind :
       {&Ingredients::bodies, &Ingredients::knots, &Ingredients::screens, &Ingredients::blended}) {
    for (const NettingScreenLaw law : {NettingScreenLaw::loland, NettingScreenLaw::aarsnes,
                                       NettingScreenLaw::kristiansen_faltinsen}) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        Ingredients wanted = still_water();
        wanted.*kind = 1;
        wanted.screen_law = law;
        Specimen s(random, wanted);
        CHECK(power(s).total < 0.0);
      }
    }
  }
}

TEST_CASE("plates in still water lose energy at every angle of attack") {
  Random random(20260425);
  for (int repeat = 0; repeat < 50; ++repeat) {
    Ingredients wanted = still_water();
    wanted.plates = 1;
    Specimen s(random, wanted);
    s.model.ground.present = false;
    LiftingPlate& plate = s.model.plates.plate[0];
    plate.weight = plate.buoyancy = plate.mass = plate.added_mass = 0.0;
    plate.second_moment.setZero();
    s.model.prepare();
    CHECK(power(s).total < 0.0);
  }
}

TEST_CASE("friction dissipates energy and the ground pushes only outwards") {
  Random random(20260426);
  for (int repeat = 0; repeat < 50; ++repeat) {
    Ingredients wanted = still_water();
    wanted.contacts = 12;
    Specimen s(random, wanted);
    const Ground& ground = s.model.ground;
    // Along the ground, where the elastic part does no work.
    for (int n = 0; n < s.model.nodes; ++n) {
      at(s.v.data(), n) -= ground.normal.dot(at(s.v.data(), n)) * ground.normal;
      at(s.v.data(), n) += ground.velocity;
    }
    Assembly assembly(s.model);
    std::vector<double> force(s.x.size());
    assembly.move_to(s.x.data(), s.v.data());
    assembly.residual(force.data());
    double lost = 0.0;
    for (int n = 0; n < s.model.nodes; ++n) {
      lost += at(force.data(), n).dot(at(s.v.data(), n) - ground.velocity);
      CHECK(at(force.data(), n).dot(ground.normal) >= -1e-12);
    }
    CHECK(lost < 0.0);
  }
}

TEST_CASE("lift in still water does no work") {
  Random random(20260423);
  for (int repeat = 0; repeat < 20; ++repeat) {
    Ingredients wanted = still_water();
    wanted.lifts_up = repeat % 2;
    wanted.lifts_sideways = 1 - repeat % 2;
    Specimen s(random, wanted);
    const Power p = power(s);
    CHECK(std::abs(p.total) <= 1e-14 * p.size);  // a dozen operations of 1.1e-16 each
  }
}

TEST_CASE("forces, derivatives and masses remain finite at undefined directions") {
  struct Extreme {
    const char* name;
    double current;                      // m/s
    void (*move)(double* x, double* v);  // moves one node
  };
  // 1e-50: the cube of the speed is still a nonzero number.
  const Extreme extremes[] = {
      {"no flow", 0.0, [](double*, double* v) { v[0] = v[1] = v[2] = 0.0; }},
      {"flow along all lines", 0.0,
       [](double* x, double* v) {
         x[1] = x[2] = v[1] = v[2] = 0.0;
         v[0] = 1.0;
       }},
      {"flow straight up", 0.0,
       [](double*, double* v) {
         v[0] = v[1] = 0.0;
         v[2] = -1.0;
       }},
      {"all points in one place", 1.0, [](double* x, double*) { x[0] = x[1] = x[2] = 0.5; }},
      {"very fast", 1.0, [](double*, double* v) { v[0] *= 1e6; }},
      {"very slow", 0.0,
       [](double*, double* v) {
         for (int k = 0; k < 3; ++k) v[k] *= 1e-50;
       }},
  };
  Random random(20260424);
  for (const Extreme& extreme : extremes) {
    CAPTURE(extreme.name);
    each_law([&](const CylinderLaw& law, SlackDrag slack) {
      Ingredients wanted;
      wanted.bars = 10;
      wanted.cells = 6;
      wanted.hexagons = wanted.pressed = wanted.screens = wanted.blended = 3;
      wanted.openings = wanted.bends = wanted.twists = 3;
      wanted.bodies = wanted.knots = wanted.lifts_up = wanted.lifts_sideways = 4;
      wanted.plates = wanted.contacts = wanted.volumes = 4;
      wanted.free_surface = true;
      wanted.law = law;
      wanted.slack = slack;
      wanted.current = extreme.current;
      Specimen s(random, wanted);
      for (int n = 0; n < s.model.nodes; ++n) extreme.move(&s.x[3 * n], &s.v[3 * n]);
      CHECK(is_finite(s));
    });
  }
}

// With the velocity of the wall itself, the pressure that moves a wall outward would grow with its
// motion, without limit.
TEST_CASE("catch pressure depends on the motion of the whole bag, not of its walls") {
  Random random(20261130);
  Ingredients wanted;
  wanted.pressed = 2;
  Specimen s(random, wanted);
  InnerPressure& pressure = s.model.pressure;
  pressure.node = {0, 1, 2, 3, 4, 5};
  pressure.weight.assign(6, 1.0 / 3.0);
  s.model.prepare();
  Assembly assembly(s.model);
  const auto forces = [&](const Vector& first, const Vector& second) {
    for (int n = 0; n < 6; ++n) at(s.v.data(), n) = n < 3 ? first : second;
    assembly.move_to(s.x.data(), s.v.data());
    return Vector(
        pressure.element_force(0, assembly.field(), pressure.mean_velocity(assembly.field())));
  };
  const Vector none = Vector::Zero(), fast(3.0, -20.0, 7.0);
  const Vector at_rest = forces(none, none);
  CHECK((forces(fast, -fast) - at_rest).norm() < 1e-12 * at_rest.norm());
  CHECK((forces(fast, fast) - at_rest).norm() > at_rest.norm());
}

TEST_CASE("drag is continuous where a line becomes slack or loses its length") {
  TwineMaterial material;
  material.diameter = 0.002;
  const Vector u(0.4, -0.3, 1.0), axis = Vector(1.0, 2.0, -0.5).normalized();
  for (const CylinderLaw& law : cylinder_laws()) {
    material.law = law;
    auto drag = [&](double length) { return line_drag(material, length * axis, u); };
    const double size = drag(1.0).norm();
    CHECK((drag(1.0 + 1e-9) - drag(1.0 - 1e-9)).norm() < 1e-8 * size);
    CHECK((drag(1e-9) - drag(0.0)).norm() < 1e-8 * size);
    // A line of zero length has no axis: drag acts along the flow.
    CHECK(drag(0.0).cross(u).norm() < 1e-12 * size);
  }
}

TEST_CASE("added mass is continuous at slack and isotropic at zero length") {
  TwineMaterial material;
  material.diameter = 0.02;
  material.volume_per_length = 3e-4;
  material.added_mass_normal = 1.0;
  material.added_mass_tangential = 0.1;
  FilledModel line;
  Model& model = line.model;
  model.water = Water();
  model.materials = {material};
  const int from = line.node(Vector::Zero()), to = line.node(Vector::Zero());
  line.bar(from, to, 2.0, 0);
  model.prepare();
  // Each end has half of the water that the line displaces.
  const double water = 0.5 * 2.0 * material.volume_per_length * model.water.density;
  auto mass = [&](const Vector& along, double length) -> Block {
    Assembly assembly(model);
    std::vector<double> x(6, 0.0), v(6, 0.0), out(18);
    at(x.data(), 1) = length * along;
    assembly.move_to(x.data(), v.data());
    assembly.mass(out.data());
    return Eigen::Map<const Block>(out.data());
  };
  const Vector axis = Vector(1.0, 2.0, -0.5).normalized(),
               other = Vector(0.0, 1.0, 3.0).normalized();
  const Matrix straight = water * (Matrix::Identity() - 0.9 * axis * axis.transpose());
  CHECK((mass(axis, 2.0) - straight).norm() < 1e-12 * water);
  CHECK((mass(axis, 2.0 - 1e-9) - straight).norm() < 1e-8 * water);
  // Directions are uniformly distributed: the mean of cos^2 over the sphere is 1/3.
  CHECK((mass(axis, 1e-9) - water * 0.7 * Matrix::Identity()).norm() < 1e-8 * water);
  CHECK((mass(axis, 1e-9) - mass(other, 1e-9)).norm() < 1e-8 * water);
  // The trace of the mass does not depend on the shape.
  for (const double length : {0.0, 0.5, 1.5, 2.0}) {
    CHECK(mass(axis, length).trace() == doctest::Approx(2.1 * water).epsilon(1e-12));
  }
}
