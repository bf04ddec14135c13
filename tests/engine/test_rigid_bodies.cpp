// Plates as rigid bodies: free flight, pendulum and decay compared with analytical solutions;
// oscillations compared with eigenvalues of matrices by differences.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "differences.hpp"
#include "integrated.hpp"
#include "motion/energy_account.hpp"
#include "motion/explicit_step.hpp"
#include "motion/newton_step.hpp"
#include "plate_struts.hpp"
#include "random_model.hpp"
#include "solve/body_modes.hpp"

namespace {

using namespace codend;

// One plate of 2 m by 3 m on nodes 0, 1 and 2, without lift and drag; in vacuum by default.
struct Plate {
  Model model;
  Motion start;
  LiftingPlate& plate() { return model.plates.plate[0]; }
  const LiftingPlate& plate() const { return model.plates.plate[0]; }

  Plate(const Vector& first, const Vector& second, const Vector& third) {
    model.nodes = 3;
    model.held = {0, 0, 0};
    model.water.density = 0.0;
    model.load.assign(9, 0.0);
    model.mass.assign(3, 0.0);
    LiftingPlate one;
    one.node = {0, 1, 2};
    one.attachment = {first, second, third};
    one.chord = 2.0;
    one.span = 3.0;
    one.area = 6.0;
    one.height = 3.0;
    one.pressure_centre = 0.5;
    one.polar.angle = {-pi, pi};
    one.polar.lift = one.polar.drag = one.polar.lift_slope = one.polar.drag_slope = {0.0, 0.0};
    model.plates.plate = {one};
    join_by_struts(model, one.attachment);
    start.x = start.v = Values::Zero(9);
    for (int k = 0; k < 3; ++k) {
      codend::at(start.x.data(), k) = one.attachment[static_cast<std::size_t>(k)];
    }
  }
  Plate(const Plate&) = delete;

  // Rotates at a rate about a position.
  void turn(const Vector& rate, const Vector& about, const Vector& speed = Vector::Zero()) {
    for (int k = 0; k < 3; ++k) {
      codend::at(start.v.data(), k) =
          speed + rate.cross(Vector(codend::at(start.x.data(), k)) - about);
    }
  }
};

template <class Scheme>
Motion steps(const Model& model, const Motion& start, Scheme& scheme, Assembly& assembly,
             double until, double step) {
  SteadyConditions conditions(model.held, start);
  return integrated(assembly, scheme, conditions, start, until, step);
}

Motion runge_kutta(const Model& model, const Motion& start, double until, double step) {
  Assembly assembly(model);
  RungeKuttaStep scheme(assembly, start);
  return steps(model, start, scheme, assembly, until, step);
}

Matrix axes_of(const Values& x) {
  const Vector e1 = (at(x.data(), 1) - at(x.data(), 0)).normalized();
  Vector e2 = at(x.data(), 2) - at(x.data(), 0);
  e2 = (e2 - e2.dot(e1) * e1).normalized();
  Matrix axes;
  axes << e1, e2, e1.cross(e2);
  return axes;
}

// Attitude (axes in space) and rotation of a plate, computed from its points.
struct Attitude {
  Matrix turned;
  Vector rate, gravity_centre, speed;
};
Attitude attitude(const Plate& p, const Motion& motion) {
  Values local(9);
  for (int k = 0; k < 3; ++k)
    at(local.data(), k) = p.plate().attachment[static_cast<std::size_t>(k)];
  Attitude out;
  out.turned = axes_of(motion.x) * axes_of(local).transpose();
  // v_k - v_0 = w x (x_k - x_0), by least squares.
  Eigen::Matrix<double, 6, 3> arms;
  Eigen::Matrix<double, 6, 1> speeds;
  for (int k = 1; k < 3; ++k) {
    const Vector arm = at(motion.x.data(), k) - at(motion.x.data(), 0);
    arms.block<3, 3>(3 * (k - 1), 0) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(),
        -arm.x(), 0;
    speeds.segment<3>(3 * (k - 1)) = at(motion.v.data(), k) - at(motion.v.data(), 0);
  }
  out.rate = arms.colPivHouseholderQr().solve(speeds);
  const Vector arm = out.turned * (p.plate().gravity_centre - p.plate().attachment[0]);
  out.gravity_centre = at(motion.x.data(), 0) + arm;
  out.speed = at(motion.v.data(), 0) + out.rate.cross(arm);
  return out;
}

// Moments of inertia about the centre of gravity in the plate's axes.
Vector moments_of_inertia(const LiftingPlate& plate) {
  const Vector s = plate.second_moment;
  return {s.y() + s.z(), s.z() + s.x(), s.x() + s.y()};
}

}  // namespace

TEST_CASE("free plate in vacuum falls and rotates by Euler's equations") {
  Plate p({0.3, 0.4, 0.2}, {1.8, -0.1, 1.2}, {1.5, 0.2, -1.0});
  LiftingPlate& plate = p.plate();
  plate.mass = 40.0;
  plate.weight = 40.0 * 9.81;
  plate.gravity_centre = {1.1, 0.15, -0.3};
  // Equal moments about x and z: a top, whose axis y precesses about the angular momentum L at
  // L/I1.
  plate.second_moment = {30.0, 4.0, 30.0};
  p.model.prepare();
  const Vector rate(0.4, 1.9, 0.7), speed(0.3, -0.2, 0.5);
  p.turn(rate, plate.gravity_centre, speed);
  const Vector inertia = moments_of_inertia(plate);
  const Vector momentum = inertia.cwiseProduct(rate);
  const double energy = 0.5 * rate.dot(momentum) + 20.0 * speed.squaredNorm();
  const double until = 4.0;
  // Struts of 1e7 N under m r w^2 of about 200 N lengthen by 2e-5, and rotation slows by as much.
  // They start unstretched, and oscillate at about 100 /s and 2e-5 m: 2e-3 m/s.
  constexpr double speeds = 5e-3;
  auto check = [&](const Motion& end, double places) {
    const Attitude found = attitude(p, end);
    const Vector fallen =
        plate.gravity_centre + until * speed + Vector(0.0, 0.0, -0.5 * 9.81 * until * until);
    CHECK((found.gravity_centre - fallen).norm() < places);
    CHECK((found.speed - speed - Vector(0.0, 0.0, -9.81 * until)).norm() < speeds);
    const Vector kept = found.turned * inertia.cwiseProduct(found.turned.transpose() * found.rate);
    CHECK((kept - momentum).norm() < speeds * momentum.norm());
    const Vector axis =
        Eigen::AngleAxisd(until * momentum.norm() / inertia.x(), momentum.normalized()) *
        Vector::UnitY();
    CHECK((found.turned * Vector::UnitY() - axis).norm() < 10.0 * places);
    const double now = 0.5 * found.rate.dot(kept) + 20.0 * found.speed.squaredNorm() +
                       40.0 * 9.81 * (found.gravity_centre.z() - plate.gravity_centre.z());
    CHECK(std::abs(now - energy) < speeds * 40.0 * 9.81 * until);
  };
  check(runge_kutta(p.model, p.start, until, 4e-4), 1e-4);
  SUBCASE("and so with implicit steps, to their order") {
    Assembly assembly(p.model);
    StepAccuracy accuracy;
    accuracy.found = 1e-9;
    NewtonStep scheme(assembly, accuracy, p.start.x);
    // (w h)^2 of 2.1e-5 over 8 rad, and a first step of first order.
    check(steps(p.model, p.start, scheme, assembly, until, 2e-3), 1e-3);
  }
}

TEST_CASE("asymmetric top conserves angular momentum and energy") {
  Plate p({0.3, 0.4, 0.2}, {1.8, -0.1, 1.2}, {1.5, 0.2, -1.0});
  LiftingPlate& plate = p.plate();
  plate.mass = 40.0;
  plate.gravity_centre = {1.1, 0.15, -0.3};
  plate.second_moment = {12.0, 1.0, 31.0};
  p.model.prepare();
  // About the middle axis: it tumbles.
  const Vector rate(3.0, 0.01, 0.02);
  p.turn(rate, plate.gravity_centre);
  const Vector inertia = moments_of_inertia(plate), momentum = inertia.cwiseProduct(rate);
  // Euler's equations in the plate's rotating axes, by the classical Runge-Kutta method.
  Vector w = rate;
  Eigen::Quaterniond stand = Eigen::Quaterniond::Identity();
  const double h = 1e-3, until = 4.0;
  auto quicken = [&](const Vector& at) -> Vector {
    return -at.cross(inertia.cwiseProduct(at)).cwiseQuotient(inertia);
  };
  for (int k = 0; k < static_cast<int>(std::lround(until / h)); ++k) {
    const Vector a = quicken(w), b = quicken(w + 0.5 * h * a), c = quicken(w + 0.5 * h * b),
                 d = quicken(w + h * c);
    const Vector half = w + 0.5 * h * b;
    stand = stand * Eigen::Quaterniond(Eigen::AngleAxisd(h * half.norm(), half.normalized()));
    w += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  const Attitude found = attitude(p, runge_kutta(p.model, p.start, until, 4e-4));
  // It has left its initial axis.
  CHECK(std::abs(w.x()) < 2.5);
  // Struts are strained by 5e-5; their oscillation at about 100 /s changes the rate by up to 5e-3.
  // Initial errors grow by exp(1.8 t) at most, about 100-fold until it has tumbled.
  CHECK((found.turned.transpose() * found.rate - w).norm() < 2e-2 * rate.norm());
  CHECK((found.turned - stand.toRotationMatrix()).norm() < 5e-2);
  const Vector kept = found.turned * inertia.cwiseProduct(found.turned.transpose() * found.rate);
  CHECK((kept - momentum).norm() < 1e-2 * momentum.norm());
}

TEST_CASE("hung plate swings with its inertia and added mass") {
  for (const bool in_water : {false, true}) {
    CAPTURE(in_water);
    Plate p({0.0, 0.0, 1.5}, {2.0, 0.0, 1.5}, {1.0, 0.0, -1.5});
    LiftingPlate& plate = p.plate();
    p.model.held = {1, 1, 0};
    plate.mass = 200.0;
    plate.second_moment = {200.0 / 3.0, 0.5, 150.0};
    plate.gravity_centre = plate.buoyancy_centre = {1.0, 0.0, 0.0};
    plate.weight = 200.0 * 9.81;
    double load = plate.weight, inertia = 150.5 + 200.0 * 1.5 * 1.5;
    if (in_water) {
      p.model.water.density = 1025.0;
      plate.buoyancy = 250.0;
      plate.added_mass = 2.0;
      plate.added_radius_span = 0.7;
      load -= 250.0;
      inertia += 1025.0 * 2.0 * (1.5 * 1.5 + 0.7 * 0.7);
    }
    p.model.prepare();
    const double angle = 0.01, period = 2.0 * pi * std::sqrt(inertia / (load * 1.5));
    at(p.start.x.data(), 2) = Vector(1.0, 3.0 * std::sin(angle), 1.5 - 3.0 * std::cos(angle));
    // angle^2/16 of the period is 6e-6; struts of 1e7 N under 2 kN lengthen by 2e-4.
    const Motion quarter = runge_kutta(p.model, p.start, 0.25 * period, 1e-3);
    CHECK(std::abs(quarter.x[7]) < 2e-3 * 3.0 * angle);
    const Motion whole = runge_kutta(p.model, p.start, period, 1e-3);
    CHECK(whole.x[7] == doctest::Approx(3.0 * std::sin(angle)).epsilon(2e-3));
  }
}

TEST_CASE("rotation about span or chord decays at its damping rate") {
  for (const bool yaws : {true, false}) {
    CAPTURE(yaws);
    // Fixed on an axis through the middle of the plate.
    const Vector first = yaws ? Vector(1.0, 0.0, 1.0) : Vector(0.0, 0.0, 0.0);
    const Vector second = yaws ? Vector(1.0, 0.0, -1.0) : Vector(2.0, 0.0, 0.0);
    const Vector third = yaws ? Vector(2.0, 0.0, 0.0) : Vector(1.0, 0.0, 1.5);
    Plate p(first, second, third);
    LiftingPlate& plate = p.plate();
    p.model.held = {1, 1, 0};
    p.model.water.density = 1025.0;
    p.model.water.current = {Vector(1.5, 0.0, 0.0)};
    plate.mass = 200.0;
    plate.second_moment = {70.0, 0.5, 150.0};
    plate.gravity_centre = {1.0, 0.0, 0.0};
    plate.normal_slope = 2.0;  // the centre of pressure is the middle, so it has no effect
    plate.yaw_damping = 0.15;
    plate.roll_damping = 0.08;
    plate.added_mass = 2.0;
    plate.added_radius_chord = 0.4;
    plate.added_radius_span = 0.7;
    p.model.prepare();
    const double inertia = yaws ? 70.5 + 1025.0 * 2.0 * 0.16 : 150.5 + 1025.0 * 2.0 * 0.49;
    const double size = yaws ? 0.15 * 2.0 * 2.0 : 0.08 * 3.0 * 3.0;
    const double decay = 0.5 * 1025.0 * 1.5 * 6.0 * size / inertia;
    const Vector rate = 0.1 * (yaws ? Vector::UnitZ() : Vector::UnitX());
    p.turn(rate, {1.0, 0.0, 0.0});
    const double until = 1.0 / decay;
    const Motion end = runge_kutta(p.model, p.start, until, 5e-4);
    const Attitude found = attitude(p, end);
    // The fixed points do not rotate, so the third point defines the rate; struts as above.
    const double arm = yaws ? 1.0 : 1.5;
    CHECK(at(end.v.data(), 2).norm() / arm == doctest::Approx(0.1 * std::exp(-1.0)).epsilon(1e-3));
    CHECK(found.turned.determinant() == doctest::Approx(1.0));
  }
}

TEST_CASE("energy balance closes for a plate that swings in a stream") {
  Plate p({0.0, 0.0, 1.5}, {2.0, 0.0, 1.5}, {1.0, 0.3, -1.5});
  LiftingPlate& plate = p.plate();
  p.model.held = {1, 1, 0};
  p.model.water.density = 1025.0;
  p.model.water.current = {Vector(0.8, 0.5, 0.0)};
  plate.mass = 200.0;
  plate.weight = 2000.0;
  plate.second_moment = {70.0, 0.5, 150.0};
  plate.gravity_centre = {1.0, 0.0, 0.0};
  plate.added_mass = 2.0;
  plate.added_radius_span = 0.7;
  plate.roll_damping = 0.08;
  plate.polar.drag = {0.5, 0.5};
  p.model.prepare();
  auto imbalance = [&](double step) {
    Assembly assembly(p.model);
    StepAccuracy accuracy;
    accuracy.found = 1e-9;
    NewtonStep scheme(assembly, accuracy, p.start.x);
    EnergyAccount account(assembly);
    EnergyTotals totals;
    SteadyConditions conditions(p.model.held, p.start);
    Past past;
    past.now = p.start;
    scheme.begin(past.now);
    Motion next = past.now;
    account.begin(past.now);
    for (int k = 0; k < static_cast<int>(std::lround(3.0 / step)); ++k) {
      REQUIRE(scheme.step(past, step, conditions, next).found);
      totals = account.after(next, totals);
      account.take();
      past.before = past.now;
      past.now = next;
      ++past.steps;
    }
    CHECK(totals.put_through > 50.0);
    return std::abs(totals.imbalance()) / totals.put_through;
  };
  // Second order in steps of a hundredth of a period, except for a first-order first step.
  CHECK(imbalance(0.01) < 1e-3);
  CHECK(imbalance(0.005) < 1e-3);
}

namespace {

Eigen::MatrixXd dense_mass(Assembly& assembly, Specimen& s) {
  const std::vector<int>& free = assembly.free_nodes();
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd out(size, size);
  std::vector<double> lumped(3 * s.x.size()), unit(s.x.size(), 0.0), force(s.x.size());
  assembly.move_to(s.x.data(), s.v.data());
  assembly.mass(lumped.data());
  auto place = [&](Eigen::Index i) {
    return static_cast<std::size_t>(3 * free[static_cast<std::size_t>(i / 3)] + i % 3);
  };
  for (Eigen::Index j = 0; j < size; ++j) {
    unit[place(j)] = 1.0;
    assembly.inertia(lumped.data(), unit.data(), force.data());
    unit[place(j)] = 0.0;
    for (Eigen::Index i = 0; i < size; ++i) out(i, j) = force[place(i)];
  }
  return out;
}

}  // namespace

TEST_CASE("body modes are eigenvalues and include every growing body eigenvalue") {
  Random random(20260901);
  int oscillating = 0, growing = 0, compared = 0;
  for (int repeat = 0; repeat < 10; ++repeat) {
    CAPTURE(repeat);
    Ingredients wanted;
    wanted.bars = 25;
    wanted.bodies = 6;
    wanted.plates = 2;
    wanted.struts = true;
    wanted.axial_stiffness = 50.0;
    Specimen s(random, wanted);
    s.model.ground.present = false;
    std::fill(s.v.begin(), s.v.end(), 0.0);
    for (double& mass : s.model.mass) mass = random.between(1.0, 5.0);
    for (LiftingPlate& plate : s.model.plates.plate) {
      plate.pressure_wanders = false;
      plate.area = 1.6;
    }
    s.model.prepare();
    Assembly assembly(s.model);
    auto force = [&](std::vector<double>& out) {
      assembly.move_to(s.x.data(), s.v.data());
      assembly.residual(out.data());
    };
    const Dense stiffness = by_differences(assembly, s.x, force),
                damping = by_differences(assembly, s.v, force), mass = dense_mass(assembly, s);
    CHECK((mass - mass.transpose()).norm() < 1e-12 * mass.norm());
    const Eigen::Index n = mass.rows();
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n).setIdentity();
    companion.bottomLeftCorner(n, n) = -mass.llt().solve(stiffness);
    companion.bottomRightCorner(n, n) = -mass.llt().solve(damping);
    const Eigen::EigenSolver<Eigen::MatrixXd> found(companion);
    std::vector<std::complex<double>> all, of_bodies;
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
      all.push_back(found.eigenvalues()[k]);
      double most = 0.0, most_of_bodies = 0.0;
      for (int i = 0; i < assembly.unknowns(); ++i) {
        const double way = found.eigenvectors().col(k).segment<3>(3 * i).norm();
        most = std::max(most, way);
        if (assembly.in_body(assembly.free_nodes()[i]))
          most_of_bodies = std::max(most_of_bodies, way);
      }
      if (most_of_bodies > 0.3 * most) of_bodies.push_back(all.back());
    }
    const std::vector<BodyMode> modes = body_modes(assembly, s.x.data(), s.v.data());
    for (const BodyMode& mode : modes) {
      double nearest = 1e300;
      for (const std::complex<double>& value : all) {
        nearest = std::min(nearest, std::abs(value - mode.rate));
      }
      // A residual of 0.02, scaled by how nearly eigenvectors coincide.
      CHECK(nearest < 0.1 * std::abs(mode.rate) + 1e-3);
      oscillating += mode.rate.imag() > 0.0;
      growing += mode.rate.real() > 0.0 && mode.rate.imag() > 0.0;
      ++compared;
    }
    // Growing rates in the range of the projection.
    for (const std::complex<double>& value : of_bodies) {
      if (value.real() < 0.01 || value.imag() < 0.0 || std::abs(value) > 10.0) continue;
      double nearest = 1e300;
      for (const BodyMode& mode : modes) nearest = std::min(nearest, std::abs(value - mode.rate));
      CHECK(nearest < 0.1 * std::abs(value));
    }
  }
  CHECK(compared > 20);
  CHECK(oscillating > 10);
  MESSAGE(compared, " modes, ", oscillating, " oscillate, ", growing, " flutter");
}
