// Wakes of netting upstream: the remaining fraction of speed, and the points in the wake.
#include <doctest/doctest.h>

#include <cmath>

#include "model/wake.hpp"

namespace {

using namespace codend;

// Adds a square sheet of side 2 m across x at this x, as two triangles. twine: total m2; overlap:
// of its crossings.
void add_sheet(double x, double twine, WakeSheets& sheets, std::vector<double>& position,
               double overlap = 0.0) {
  const int first = static_cast<int>(position.size() / 3);
  for (const double y : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) position.insert(position.end(), {x, y, z});
  }
  for (const int k : {0, 1, 3, 0, 3, 2}) sheets.node.push_back(first + k);
  for (int k = 0; k < 2; ++k) {
    sheets.twine_area.push_back(0.5 * twine);
    sheets.overlap.push_back(overlap);
    sheets.law.push_back(WakeLaw::loland);
  }
}

}  // namespace

TEST_CASE("wake reduces speed to a fraction that is 1 without twine") {
  for (const WakeLaw law : {WakeLaw::none, WakeLaw::loland, WakeLaw::cheng}) {
    CHECK(speed_reduction(law, 0.4, 0.0) == 1.0);
    CHECK(speed_reduction(law, 0.0, 1.0) == 1.0);
    for (double solidity = 0.0; solidity <= 2.0; solidity += 0.1) {
      for (double cosine = 0.0; cosine <= 1.0; cosine += 0.05) {
        const double r = speed_reduction(law, solidity, cosine);
        CHECK(r >= 0.0);
        CHECK(r <= 1.0);
      }
    }
  }
}

TEST_CASE("wake solidity counts crossings once, as screen drag does") {
  // squares of twine d over bars a, d/a = 0.2: Sn = 2 d/a - (d/a)^2
  WakeSheets sheets;
  std::vector<double> x;
  add_sheet(0.0, 4.0 * 0.4, sheets, x, 0.25);
  x.insert(x.end(), {1.0, 0.2, 0.3});
  Wake wake(sheets, 5);
  wake.renew(x.data(), {1.0, 0.0, 0.0}, true, 1e-5);
  CHECK(wake.share()[4] ==
        doctest::Approx(speed_reduction(WakeLaw::loland, 0.4 - 0.04, 1.0)).epsilon(1e-12));
}

TEST_CASE("wake contains only points behind a sheet") {
  WakeSheets sheets;
  std::vector<double> x;
  add_sheet(0.0, 0.8, sheets, x);  // Sn 0.2
  add_sheet(5.0, 0.8, sheets, x);
  const double places[][3] = {{-1, 0, 0}, {1, 0.2, 0.3}, {6, -0.3, 0.1}, {6, 1.5, 0}, {6, 0, -1.2}};
  for (const auto& place : places) x.insert(x.end(), place, place + 3);
  const double r = speed_reduction(WakeLaw::loland, 0.2, 1.0);
  const int points = static_cast<int>(x.size() / 3);
  for (const double speed : {0.1, 3.0}) {
    Wake wake(sheets, points);
    CHECK(wake.renew(x.data(), {speed, 0.0, 0.0}, true, 1e-5) > 0.1);
    const std::vector<double>& share = wake.share();
    for (int k = 0; k < 4; ++k) {
      CHECK(share[k] == 1.0);
      CHECK(share[4 + k] == doctest::Approx(r));
    }
    CHECK(share[8] == 1.0);
    CHECK(share[9] == doctest::Approx(r));
    CHECK(share[10] == doctest::Approx(r * r));
    CHECK(share[11] == 1.0);
    CHECK(share[12] == 1.0);
    // Again on the same shape: nothing changes.
    CHECK(wake.renew(x.data(), {speed, 0.0, 0.0}, false, 1e-5) == 0.0);
  }
  // With reversed flow the other sheet is in the wake.
  Wake wake(sheets, points);
  wake.renew(x.data(), {-1.0, 0.0, 0.0}, true, 1e-5);
  CHECK(wake.share()[0] == doctest::Approx(r));
  CHECK(wake.share()[4] == 1.0);
}

TEST_CASE("wake with fixed sheets follows only their changes") {
  WakeSheets sheets;
  std::vector<double> x;
  add_sheet(0.0, 0.8, sheets, x);  // Sn 0.2
  x.insert(x.end(), {1.0, 0.2, 0.3});
  const Vector flow(1.0, 0.0, 0.0);
  Wake wake(sheets, 5), other(sheets, 5);
  // not searched before: it differs from the value of its sheets
  wake.set_share({1.0, 1.0, 1.0, 1.0, 0.9});
  wake.keep(x.data(), flow);
  CHECK(wake.renew(x.data(), flow, true, 0.0) == doctest::Approx(0.0));
  CHECK(wake.share()[4] == 0.9);
  // the sheet becomes a tenth wider, hence less solid, and the point leaves its wake
  std::vector<double> moved = x;
  for (int k = 0; k < 4; ++k) moved[3 * k + 1] *= 1.1;
  moved[13] = 5.0;
  const double change =
      speed_reduction(WakeLaw::loland, 0.2 / 1.1, 1.0) - speed_reduction(WakeLaw::loland, 0.2, 1.0);
  other.keep_to(wake);
  for (Wake* one : {&wake, &other}) {
    one->renew(moved.data(), flow, true, 0.0);
    CHECK(one->share()[4] == doctest::Approx(0.9 + change).epsilon(1e-12));
  }
}
