// Waves on the water: a sum of regular ones of small steepness (Airy), in water of one depth.
//
// With a the amplitude, k the wave number, w the frequency, p the phase, d the depth and s the way
// along the direction of the wave,
//   q    = k s - w t + p
//   eta  = a cos q                                           elevation of the surface
//   u    = a w cosh(k (z' + d)) / sinh(k d) cos q            along the direction
//   v    = a w sinh(k (z' + d)) / sinh(k d) sin q            upwards
//   w^2  = g k tanh(k d)                                     dispersion
// (G. B. Airy, Tides and waves, 1845; DNV-RP-C205, 3.2.2). Accelerations are the rates of u and v at a
// fixed place. Airy's waves end at z = 0; they are stretched to the surface that they make (J. D.
// Wheeler, Method for calculating forces produced by irregular waves, J. Petroleum Tech. 22, 1970):
//   z' = d (z - eta) / (d + eta), in deep water z - eta,
// and no higher than 0. At time 0 the water is still; within `rising` the waves grow to their height,
// by s^2 (3 - 2 s) of the share s of that time, and the accelerations with them.
//
// Left out: what is of second order in steepness (drift, sharper crests), and that a current changes
// the length of waves.
#pragma once

#include <vector>

#include "geometry.hpp"

namespace codend {

// Standard value for loads at sea, m/s2; the same as that of the weights in a model.
constexpr double gravity = 9.81;

// Wave number (1/m) of a frequency (1/s, above 0) in water of a depth (m; infinite for deep water).
double wave_number(double frequency, double depth);

// What waves do at a place, beside the current.
struct WavePoint {
  double elevation = 0.0;                  // of the surface above the place, m
  double slope_x = 0.0, slope_y = 0.0;     // of the surface
  Vector velocity = Vector::Zero();        // m/s
  Vector velocity_slope = Vector::Zero();  // by height, 1/s
  Vector acceleration = Vector::Zero();    // m/s2
};

struct Waves {
  // Per wave: half of its height, m; 1/s; rad; direction in which it runs, rad, 0 along x.
  std::vector<double> amplitude, frequency, phase, toward;
  double depth = 0.0;   // m; 0: deep
  double rising = 1.0;  // s, above 0
  double time = 0.0;    // s

  template <class Visit>
  void fields(Visit& visit) {
    visit("amplitude", amplitude);
    visit("frequency", frequency);
    visit("phase", phase);
    visit("toward", toward);
    visit("depth", depth);
    visit("rising", rising);
    visit("time", time);
  }

  // Call once after filling.
  void prepare();
  bool present() const { return !amplitude.empty(); }
  // Whether the water moves now.
  bool running() const { return present() && time > 0.0; }
  // The share of their height to which they have risen, and its rate, 1/s.
  void risen(double& share, double& rate) const;
  // At a place (m, the still water's surface at z = 0) now.
  WavePoint at(const Vector& place) const;
  // What answers to the elevation at a place (m) that moves (m/s), such as a hull: six sums over all
  // waves of a (even cos q + odd sin q), and their rates. even, odd: six numbers per wave.
  void respond(const Vector& place, const Vector& velocity, const std::vector<double>& even,
               const std::vector<double>& odd, double value[6], double rate[6]) const;

 private:
  std::vector<double> number_, x_, y_;  // wave numbers (1/m), and along x and y
};

}  // namespace codend
