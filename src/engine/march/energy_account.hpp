// Where the energy of a motion comes from and goes to.
//
// Over a step, with v the velocities, M mass and added mass, F the net forces:
//   kinetic    sum of (v0 + v1)/2 . (M0 + M1)/2 (v1 - v0) over the free nodes: the change of
//              1/2 v M v but for what M's own change makes of it: no force answers to that of added
//              mass, and that of bodies that turn is booked with the water's
//   elastic    change of the strain energy of lines and sliding ropes, and of pressed ground
//   potential  - sum of (load0 + load1)/2 . (x1 - x0)
//   supports   work of what holds and moves the held nodes: of - F . v
//   lengths    work of what changes the lengths of bars
//   water      work of drag, lift and friction: of all forces that are not named here
//   damping    work of the lines' dampers
// Work done by a power P is h/2 (P0 + P1). What kinetic, elastic and potential energy gain beyond the
// work is the imbalance: positive is energy that was made, negative what the scheme has removed. It is
// of the order of the scheme's error. Put through is half of the sum of the sizes of all seven.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "motion.hpp"

namespace codend {

// J, since the march began.
struct EnergyTotals {
  double kinetic = 0.0, elastic = 0.0, potential = 0.0;
  double supports = 0.0, lengths = 0.0, water = 0.0, damping = 0.0;
  double put_through = 0.0;

  double imbalance() const {
    return kinetic + elastic + potential - (supports + lengths + water + damping);
  }
};

class EnergyAccount {
 public:
  explicit EnergyAccount(Assembly& assembly);

  // Takes a motion in the assembly's conditions as where the next step begins.
  void begin(const Motion& now);
  // Totals after a step to `next`, in the conditions of its end; nothing is booked yet.
  EnergyTotals after(const Motion& next, const EnergyTotals& before);
  // The step was taken: the next one begins where it ended.
  void take() { std::swap(from_, to_); }

 private:
  struct Moment {
    double time = 0.0;
    double elastic = 0.0;                               // J
    double supports = 0.0, water = 0.0, damping = 0.0;  // W
    Values x, v;
    std::vector<double> mass;             // 9 per node, kg
    std::vector<double> place, velocity;  // 3 per point, m, m/s; where there are bodies
    std::vector<double> load;             // 3 per point, N
    std::vector<double> rest;             // of bars, m
    std::vector<double> give;  // of bars: what their energy loses per length that is paid out, N
  };
  void measure(const Motion& motion, Moment& moment);

  Assembly& assembly_;
  Moment from_, to_;
  // Kinetic energy that bodies gain over the step, as above, J.
  double gained_by_bodies();
  std::vector<double> force_, other_;
};

}  // namespace codend
