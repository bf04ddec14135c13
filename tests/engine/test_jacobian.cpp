// Compares derivatives of every element kind with differences of its forces, through the assembly.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "differences.hpp"
#include "random_model.hpp"

namespace {

using namespace codend;

// Fourth-order differences, (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / 12h, at h = 2e-5 (m, m/s).
// Rounding: 1.5 x 2.2e-16 |F| / h = 1.7e-11 |F|, about ten times that where terms of F cancel.
// Truncation: h^4/30 f^(5), below 1e-10 of f' if F changes over 0.02 m or m/s or more. The smallest
// distances in these models have this size. 1e-8 covers both.
constexpr double tolerance = 1e-8;

// Largest error of any column, relative to the column's largest entry and the largest force per
// metre.
double error(const Dense& found, const Dense& expected, double force) {
  double worst = 0.0;
  for (int j = 0; j < found.cols(); ++j) {
    const double scale = expected.col(j).cwiseAbs().maxCoeff() + force;
    if (scale == 0.0) continue;
    worst = std::max(worst, (found.col(j) - expected.col(j)).cwiseAbs().maxCoeff() / scale);
  }
  return worst;
}

double largest(const std::vector<double>& values) {
  double out = 0.0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

// About 90 additions of 2.2e-16 each: of 16 blocks of 8 elements of four corners over 12 nodes.
constexpr double order_of_additions = 2e-14;

void check_derivatives(Random& random, const Ingredients& wanted, double within = tolerance,
                       double additions = order_of_additions) {
  Specimen s(random, wanted);
  Assembly assembly(s.model);
  for (int b = 0; wanted.paid_out && b < wanted.bars; ++b) {
    assembly.update_bar(b, random.between(-0.3, 0.3));
  }
  auto force = [&](std::vector<double>& out) {
    assembly.move_to(s.x.data(), s.v.data());
    assembly.residual(out.data());
  };
  std::vector<double> f(s.x.size()), values(9 * assembly.pattern().column.size());
  force(f);
  REQUIRE(largest(f) > 0.0);
  auto jacobian = [&](const JacobianRequest& request) {
    assembly.move_to(s.x.data(), s.v.data());
    assembly.jacobian(request, values.data());
    return dense(assembly, values);
  };

  const Dense stiffness = jacobian({1.0, 0.0});
  CHECK(error(stiffness, by_differences(assembly, s.x, force), largest(f)) < within);

  const Dense damping = jacobian({0.0, 1.0});
  CHECK(error(damping, by_differences(assembly, s.v, force), largest(f)) < within);

  // A request for both returns their sum.
  CHECK(error(jacobian({0.7, 2.5}), 0.7 * stiffness + 2.5 * damping, 0.0) < additions);
}

// Tensions and drag have the same size, so that errors in either are visible.
constexpr double stiffness_per_diameter = 500.0;

void check_lines(int bars, int cells, int hexagons) {
  Random random(20260401);
  for (const CylinderLaw& law : cylinder_laws()) {
    // Reynolds numbers of about 10, 100, 2000 and 3e5: every branch of the drag models.
    for (const double diameter : {1e-5, 1e-4, 2e-3, 0.3}) {
      for (const SlackDrag slack : {SlackDrag::curved, SlackDrag::straight}) {
        for (const bool layered : {false, true}) {
          CAPTURE(static_cast<int>(law.kind));
          CAPTURE(diameter);
          CAPTURE(static_cast<int>(slack));
          CAPTURE(layered);
          Ingredients wanted;
          wanted.bars = bars;
          wanted.cells = cells;
          wanted.hexagons = hexagons;
          wanted.law = law;
          wanted.diameter = diameter;
          wanted.axial_stiffness = stiffness_per_diameter * diameter;
          wanted.slack = slack;
          wanted.layered = layered;
          check_derivatives(random, wanted);
        }
      }
    }
  }
}

// Checks models whose ingredients `set` defines by the number of the model.
template <class Set>
void check_models(std::uint64_t seed, int models, Set set, double within = tolerance,
                  double additions = order_of_additions) {
  Random random(seed);
  for (int k = 0; k < models; ++k) {
    CAPTURE(k);
    Ingredients wanted;
    set(wanted, k);
    check_derivatives(random, wanted, within, additions);
  }
}

// Checks twelve elements of a kind, in a uniform and in a layered current.
void check_points(int Ingredients::*kind, Ingredients wanted = {},
                  double additions = order_of_additions) {
  wanted.*kind = 12;
  auto set = [&](Ingredients& i, int k) {
    i = wanted;
    i.layered = k >= 5;
  };
  check_models(20260402, 10, set, tolerance, additions);
}

}  // namespace

TEST_CASE("bars have derivatives equal to differences") { check_lines(20, 0, 0); }

TEST_CASE("netting cells have derivatives equal to differences") { check_lines(0, 10, 0); }

TEST_CASE("hexagonal triangles have derivatives equal to differences") { check_lines(0, 0, 8); }

// Speeds of 0.5 m/s and lines of 1 m: the damper changes the tension as much as the stretch does.
TEST_CASE("damped lines have derivatives equal to differences") {
  check_models(20260404, 10, [](Ingredients& i, int k) {
    i.bars = k % 2 ? 20 : 0;
    i.cells = k % 2 ? 0 : 10;
    i.hexagons = k % 2 ? 0 : 5;
    i.damping = 0.5;
    i.layered = k % 3 == 0;
    i.paid_out = k > 4;
  });
}

TEST_CASE("elements at points have derivatives equal to differences") {
  SUBCASE("bodies") { check_points(&Ingredients::bodies); }
  SUBCASE("knots") { check_points(&Ingredients::knots); }
  SUBCASE("smooth spheres") { check_points(&Ingredients::smooth_spheres); }
  SUBCASE("lifting surfaces, up") { check_points(&Ingredients::lifts_up); }
  SUBCASE("lifting surfaces, sideways") { check_points(&Ingredients::lifts_sideways); }
  SUBCASE("mesh openings") { check_points(&Ingredients::openings); }
  SUBCASE("contacts with the ground") { check_points(&Ingredients::contacts); }
  SUBCASE("twists of netting") { check_points(&Ingredients::twists); }
  // Between points tied to the same two nodes, nearly all of the bending stiffness cancels.
  SUBCASE("bends") { check_points(&Ingredients::bends, {}, 3.0 * order_of_additions); }
  SUBCASE("lifting plates on the ground") { check_points(&Ingredients::plates); }
}

// One triangle moves with the mean velocity, at which the matrix has all derivatives.
TEST_CASE("catch pressure has derivatives equal to differences") {
  check_models(20260405, 20, [](Ingredients& i, int k) {
    i.pressed = 1;
    i.layered = k >= 10;
  });
}

TEST_CASE("netting screens have derivatives equal to differences") {
  Random random(20260405);
  // Reynolds numbers below, in and beyond the range of Kristiansen and Faltinsen's polynomial.
  for (const double diameter : {1e-5, 1e-3, 0.1}) {
    for (int law = 0; law < 3; ++law) {
      for (const bool layered : {false, true}) {
        CAPTURE(diameter);
        CAPTURE(law);
        CAPTURE(layered);
        Ingredients wanted;
        wanted.screens = 8;
        wanted.diameter = diameter;
        wanted.screen_law = static_cast<NettingScreenLaw>(law);
        wanted.layered = layered;
        // Terms of 1e4 cancel to 1 in the polynomial of Kristiansen and Faltinsen: 1e4 times the
        // rounding above.
        check_derivatives(random, wanted, law == 2 ? 1.7e-7 : tolerance);
      }
    }
  }
}

TEST_CASE("sticking and slipping contacts have derivatives equal to differences") {
  auto check = [](int Ingredients::*kind) {
    Ingredients wanted;
    for (const double give : {0.01, 10.0}) {
      CAPTURE(give);
      wanted.slip_distance = give;
      check_points(kind, wanted);
    }
  };
  SUBCASE("contacts") { check(&Ingredients::contacts); }
  SUBCASE("shoes of plates") { check(&Ingredients::plates); }
}

TEST_CASE("elements at the surface have derivatives equal to differences") {
  Ingredients wanted;
  wanted.free_surface = true;
  SUBCASE("volumes") { check_points(&Ingredients::volumes, wanted); }
  SUBCASE("bodies") { check_points(&Ingredients::bodies, wanted); }
  SUBCASE("lifting surfaces") { check_points(&Ingredients::lifts_up, wanted); }
  SUBCASE("plates") { check_points(&Ingredients::plates, wanted); }
  SUBCASE("lines") {
    wanted.bars = wanted.cells = 12;
    wanted.diameter = 1.5;  // much drag
    wanted.axial_stiffness = 500.0;
    check_models(20260409, 5, [&](Ingredients& i, int k) {
      i = wanted;
      i.layered = k % 2;
    });
  }
}

TEST_CASE("blended netting has derivatives equal to differences") {
  // With this seed, no state is within four steps of a join of the formulas.
  Random random(20260408);
  for (const CylinderLaw& law : cylinder_laws()) {
    for (const SlackDrag slack : {SlackDrag::curved, SlackDrag::straight}) {
      for (const bool layered : {false, true}) {
        CAPTURE(static_cast<int>(law.kind));
        CAPTURE(static_cast<int>(slack));
        CAPTURE(layered);
        Ingredients wanted;
        wanted.blended = 8;
        wanted.law = law;
        wanted.slack = slack;
        wanted.layered = layered;
        check_derivatives(random, wanted, 1.7e-7);  // rounding of the polynomial, as above
      }
    }
  }
  // Twine so thin that it is hardly a screen.
  Ingredients thin;
  thin.blended = 8;
  thin.diameter = 0.0003;
  for (int repeat = 0; repeat < 5; ++repeat) check_derivatives(random, thin, 1.7e-7);
}

TEST_CASE("elements in a wake have derivatives equal to differences") {
  // With this seed, no element is within four steps of a join of the current's layers.
  check_models(20260411, 2, [](Ingredients& i, int k) {
    i.bars = i.cells = i.knots = i.bodies = i.lifts_up = 8;
    i.hexagons = i.screens = i.blended = 4;
    i.pressed = 1;
    i.wake = true;
    i.layered = i.free_surface = k == 1;
  });
}

TEST_CASE("struts have derivatives equal to differences") {
  check_models(20260408, 5, [](Ingredients& i, int) {
    i.bars = 12;
    i.struts = true;
  });
}

TEST_CASE("sliding ropes have derivatives equal to differences") {
  check_models(20260420, 5, [](Ingredients& i, int k) {
    i.sliding = 6;
    i.axial_stiffness = 1e3;
    i.layered = k % 2;
  });
}

TEST_CASE("solver-carried tensions have derivatives equal to differences") {
  Random random(20260403);
  for (int repeat = 0; repeat < 5; ++repeat) {
    Ingredients wanted;
    wanted.bars = 12;
    wanted.cells = 8;
    wanted.hexagons = 6;
    wanted.layered = true;
    Specimen s(random, wanted);
    Assembly assembly(s.model);
    DualTension dual;
    std::vector<double> start, strain;
    assembly.move_to(s.x.data(), s.v.data());
    assembly.strain(start);
    for (std::size_t k = 0; k < start.size(); ++k) {
      dual.tension.push_back(random.between(0.5, 2.0));
      dual.modulus.push_back(random.between(0.1, 5.0));
    }
    assembly.sag_to(dual);
    assembly.strain(start);
    // Dual tensions depend on strain by the modulus, and sag depends on tension: iterate until they
    // agree.
    auto force = [&](std::vector<double>& out) {
      DualTension moved = dual;
      assembly.move_to(s.x.data(), s.v.data());
      for (int round = 0; round < 300; ++round) {
        assembly.sag_to(moved);
        assembly.strain(strain);
        for (std::size_t k = 0; k < strain.size(); ++k) {
          moved.tension[k] +=
              0.5 * (dual.tension[k] + dual.modulus[k] * (strain[k] - start[k]) - moved.tension[k]);
        }
      }
      assembly.residual(out.data(), &moved);
    };
    std::vector<double> f(s.x.size()), values(9 * assembly.pattern().column.size());
    force(f);
    assembly.jacobian({1.0, 0.0}, values.data(), &dual);
    CHECK(error(dense(assembly, values), by_differences(assembly, s.x, force), largest(f)) <
          tolerance);
  }
}

TEST_CASE("elements in waves have derivatives equal to differences") {
  Random random(77);
  Ingredients wanted;
  wanted.bars = 8;
  wanted.cells = 3;
  wanted.hexagons = 2;
  wanted.bodies = 6;
  wanted.knots = 6;
  wanted.lifts_up = 3;
  wanted.volumes = 8;
  wanted.plates = 1;
  wanted.pressed = 1;
  wanted.screens = 2;
  wanted.free_surface = true;
  wanted.waves = true;
  // The matrix omits how the surface and the flow change along x and y: k a = 2e-5 of their change
  // with height. It also omits the immersed fraction of added mass, with a w^2 = 2e-4 m/s2.
  for (int k = 0; k < 5; ++k) check_derivatives(random, wanted, 2e-3);
}

TEST_CASE("strains change by their first-order derivative") {
  Random random(20260404);
  Ingredients wanted;
  wanted.bars = 12;
  wanted.cells = 8;
  wanted.hexagons = 6;
  Specimen s(random, wanted);
  Assembly assembly(s.model);
  std::vector<double> dx, up, down;
  for (std::size_t k = 0; k < s.x.size(); ++k) dx.push_back(random.between(-1.0, 1.0));
  assembly.move_to(s.x.data(), s.v.data());
  std::vector<double> change = assembly.line_change(dx.data()).strain;
  DualTension law;
  for (std::size_t k = 0; k < change.size(); ++k) {
    law.tension.push_back(assembly.lines().tension[k]);
    law.modulus.push_back(law.tension[k] > 0.0 ? assembly.lines().stiffness[k] : 0.0);
  }
  const std::vector<double> given = change;
  assembly.distribute_sag(law, nullptr, given.data(), change.data());
  // Second order at h = 1e-5: h^2/6 of the third derivative, 2e-11, and 2e-16/h = 2e-11.
  const double h = 1e-5;
  auto moved = [&](double share, std::vector<double>& out) {
    std::vector<double> y = s.x;
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += share * dx[k];
    assembly.move_to(y.data(), s.v.data());
    assembly.strain(out);
  };
  moved(h, up);
  moved(-h, down);
  for (std::size_t k = 0; k < change.size(); ++k) {
    CHECK((up[k] - down[k]) / (2.0 * h) == doctest::Approx(change[k]).epsilon(1e-8).scale(1.0));
  }
}

TEST_CASE("force multipliers have derivatives equal to differences") {
  // With this seed, no state is within four steps of a join of the formulas.
  Random random(20260412);
  for (const CylinderLaw& law : cylinder_laws()) {
    CAPTURE(static_cast<int>(law.kind));
    Ingredients wanted;
    wanted.bars = 6;
    wanted.cells = 4;
    wanted.screens = 4;
    wanted.blended = 4;
    wanted.law = law;
    wanted.multiplied = true;
    check_derivatives(random, wanted, 1.7e-7);  // rounding of the polynomial, as above
  }
}

// Drag forces are linear in every multiplier, and their components sum to the total.
TEST_CASE("force multipliers scale only their own forces") {
  // of normal drag, blended netting, a screen's drag and lift, and tangential drag
  auto forces = [](const std::array<double, 5>& of) {
    Random random(20260413);
    Ingredients wanted;
    wanted.bars = 6;
    wanted.screens = 4;
    wanted.blended = 4;
    wanted.axial_stiffness = 1e-15;
    wanted.law = cylinder_laws().back();
    wanted.law.tangential_share = of[4];
    Specimen s(random, wanted);
    s.model.multipliers.normal.assign(s.model.materials.size(), of[0]);
    s.model.multipliers.blended_normal = of[1];
    s.model.multipliers.screen_drag = of[2];
    s.model.multipliers.screen_lift = of[3];
    s.model.load.assign(s.model.load.size(), 0.0);
    s.model.prepare();
    Assembly assembly(s.model);
    std::vector<double> out(s.x.size());
    assembly.move_to(s.x.data(), s.v.data());
    assembly.residual(out.data());
    return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(out.data(), static_cast<int>(out.size())));
  };
  const Eigen::VectorXd one = forces({1, 1, 1, 1, 1}), two = forces({2, 2, 2, 2, 2});
  const double size = one.cwiseAbs().maxCoeff();
  REQUIRE(size > 0.0);
  // rounding of sums of some hundred terms; the pull of bars of 1e-15 N is far below it
  CHECK((two - 2.0 * one).cwiseAbs().maxCoeff() < 1e-12 * size);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(one.size());
  for (std::size_t k = 0; k < 5; ++k) {
    std::array<double, 5> m = {1, 1, 1, 1, 1};
    m[k] = 2.0;
    const Eigen::VectorXd component = forces(m) - one;
    if (k != 4) CHECK(component.cwiseAbs().maxCoeff() > 1e-6 * size);
    sum += component;
  }
  CHECK((sum - one).cwiseAbs().maxCoeff() < 1e-12 * size);
}
