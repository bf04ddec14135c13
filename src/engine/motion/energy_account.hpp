// Energy balance of a motion.
//
// Notation for one step: velocities v, mass and added mass M, net forces F. The energies are:
//
//   kinetic    sum of (v0 + v1)/2 . (M0 + M1)/2 (v1 - v0) over the free nodes
//   elastic    change of the strain energy of lines and sliding ropes, and of compressed ground
//   potential  - sum of (load0 + load1)/2 . (x1 - x0)
//   supports   work at fixed nodes, from - F . v
//   lengths    work that changes the rest lengths of bars
//   water      work of drag, lift, friction and all forces not listed here
//   damping    work of the lines' dampers
//
// The kinetic term excludes changes of M. No force belongs to a change of added mass, and the term
// of rotating bodies is part of `water`. The work of a power P is h/2 (P0 + P1).
//
// The imbalance is the gain of kinetic, elastic and potential energy minus the work. Positive
// values are energy created by the scheme, negative values are numerical dissipation. Its order is
// the order of the scheme's error. `put_through` is half of the sum of the magnitudes of all seven.
// It grows without limit, so an imbalance is compared with what is exchanged in the same interval
// and with the energy present at its start: kinetic energy of the free nodes, and elastic energy.
#pragma once

#include <vector>

#include "../model/assembly.hpp"
#include "motion.hpp"

namespace codend {

// J, since the start of the integration.
struct EnergyTotals {
  double kinetic = 0.0, elastic = 0.0, potential = 0.0;
  double supports = 0.0, lengths = 0.0, water = 0.0, damping = 0.0;
  double put_through = 0.0;

  double imbalance() const {
    return kinetic + elastic + potential - (supports + lengths + water + damping);
  }
};

// Returns the totals at a fraction of the interval between two totals.
EnergyTotals between(const EnergyTotals& begin, const EnergyTotals& end, double share);

class EnergyAccount {
 public:
  explicit EnergyAccount(Assembly& assembly);

  // Sets the start of the next step. The assembly must have the conditions of this time.
  void begin(const Motion& now);
  // Returns the totals after a step to `next`, at the conditions of its end. Nothing is stored yet.
  EnergyTotals after(const Motion& next, const EnergyTotals& before);
  // Returns the energy present at the start of the step, J.
  double present() const;
  // Accepts the step: the next step starts at its end.
  void take() { std::swap(from_, to_); }

 private:
  struct Moment {
    double time = 0.0;
    double elastic = 0.0;                               // J
    double supports = 0.0, water = 0.0, damping = 0.0;  // W
    Values x, v;
    std::vector<double> mass;             // 9 per node, kg
    std::vector<double> place, velocity;  // 3 per point, m, m/s
    std::vector<double> load;             // 3 per point, N
    std::vector<double> rest;             // of bars, m
    std::vector<double> give;             // of bars, energy released per length paid out, N
  };
  void measure(const Motion& motion, Moment& moment);

  Assembly& assembly_;
  Moment from_, to_;
  // Gain of the kinetic energy of bodies over the step, J.
  double gained_by_bodies();
  std::vector<double> force_, other_;
};

}  // namespace codend
