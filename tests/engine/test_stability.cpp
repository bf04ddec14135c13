// Growing motions of plates, compared with the eigenvalues of the whole dense matrix.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "differences.hpp"
#include "random_model.hpp"
#include "solve/stability.hpp"

using namespace codend;

TEST_CASE("growing plate motion is an eigenvector and no clear one is missed") {
  Random random(20260501);
  int found = 0, expected = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    Ingredients wanted;
    wanted.bars = 25;
    wanted.plates = 2;
    wanted.struts = true;
    wanted.axial_stiffness = 200.0;
    Specimen s(random, wanted);
    s.model.ground.present = false;
    s.model.prepare();
    Assembly assembly(s.model);
    assembly.move_to(s.x.data(), s.v.data());
    const BlockPattern& pattern = assembly.pattern();
    const std::size_t n = static_cast<std::size_t>(pattern.n);
    std::vector<double> values(9 * pattern.column.size()), damping(n), places;
    const double fall_time = assembly.fall_time(s.x.data());
    assembly.jacobian({1.0, 0.0}, values.data());
    assembly.pseudo_damping(fall_time, damping.data());
    Dense rates = -dense(assembly, values);
    for (int row = 0; row < 3 * pattern.n; ++row) {
      rates.row(row) /= damping[static_cast<std::size_t>(row / 3)];
    }
    const Eigen::VectorXcd all = rates.eigenvalues();
    // The fastest growing real rate, and its separation from the others.
    double fastest = -1e300, next = -1e300;
    bool real = false;
    for (int i = 0; i < all.size(); ++i) {
      if (all[i].real() > fastest) {
        next = fastest;
        fastest = all[i].real();
        real = std::abs(all[i].imag()) < 1e-9;
      } else {
        next = std::max(next, all[i].real());
      }
    }
    for (const int node : assembly.free_nodes()) {
      for (int c = 0; c < 3; ++c) places.push_back(s.x[3 * static_cast<std::size_t>(node) + c]);
    }
    BlockLU lu(Precision::single_precision);
    lu.analyse(pattern, places.data());
    const GrowingMotion growing = growing_motion(assembly, fall_time, lu);
    if (growing.found) {
      ++found;
      const Eigen::Map<const Eigen::VectorXd> motion(growing.motion.data(), 3 * pattern.n);
      // Its direction is accurate to 0.005, its rate to that times how nearly eigenvectors
      // coincide.
      CHECK((rates * motion - growing.rate * motion).norm() <
            0.1 * (1.0 + growing.rate) * motion.norm());
      double nearest = 1e300;
      for (int i = 0; i < all.size(); ++i) {
        nearest = std::min(nearest, std::abs(all[i] - growing.rate));
      }
      CHECK(nearest < 0.05 * growing.rate);
    } else {
      // Rates that steps of 0.1 to 10 s can separate from the next ones.
      const bool clear = real && fastest > 0.02 && fastest < 5.0 && next < 0.5 * fastest;
      CHECK_FALSE(clear);
    }
    expected += fastest > 0.02;
    if (fastest <= 0.0) CHECK_FALSE(growing.found);
  }
  CHECK(found > 0);
  CHECK(found < 60);
  CHECK(expected >= found);
}

TEST_CASE("stability check tries only unstable kinds with the smallest unstable size") {
  Random random(7);
  Ingredients wanted;
  wanted.bars = 25;
  Specimen without(random, wanted);
  without.model.prepare();
  Assembly none(without.model);
  none.move_to(without.x.data(), without.v.data());
  CHECK(unstable_size(none) == 0.0);
  wanted.plates = 2;
  Specimen with(random, wanted);
  with.model.plates.plate[0].chord = 3.0;
  with.model.plates.plate[1].chord = 2.0;
  with.model.prepare();
  Assembly two(with.model);
  two.move_to(with.x.data(), with.v.data());
  CHECK(unstable_size(two) == 2.0);
}

TEST_CASE("stability check tries netting under pressure unless settled before") {
  Random random(11);
  Ingredients wanted;
  wanted.bars = 25;
  Specimen bag(random, wanted);
  // pressure on one triangle with sides of 3, 4 and 5 m, in the current of the model
  bag.model.pressure.node = {0, 1, 2};
  bag.model.pressure.weight.assign(3, 1.0 / 3.0);
  bag.model.pressure.height = {0.1};
  at(bag.x.data(), 0) = Vector(0.0, 0.0, -50.0);
  at(bag.x.data(), 1) = Vector(0.0, 3.0, -50.0);
  at(bag.x.data(), 2) = Vector(0.0, 0.0, -46.0);
  bag.model.prepare();
  Assembly assembly(bag.model);
  assembly.move_to(bag.x.data(), bag.v.data());
  CHECK(unstable_size(assembly) == doctest::Approx(4.0));
  CHECK(unstable_size(assembly, false) == 0.0);
}
