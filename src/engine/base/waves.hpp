// Linear waves (Airy): a sum of regular waves of small steepness in water of constant depth.
//
// Notation: amplitude a, wave number k, frequency w, phase p, depth d, distance s along the wave.
//
//   q    = k s - w t + p
//   eta  = a cos q                                           elevation of the surface
//   u    = a w cosh(k (z' + d)) / sinh(k d) cos q            along the direction
//   v    = a w sinh(k (z' + d)) / sinh(k d) sin q            upwards
//   w^2  = g k tanh(k d)                                     dispersion
//
// (G. B. Airy, Tides and waves, 1845; DNV-RP-C205, 3.2.2). Accelerations are the time derivatives
// of u and v at a fixed point.
//
// Airy waves end at z = 0. They are stretched to the actual surface (J. D. Wheeler, Method for
// calculating forces produced by irregular waves, J. Petroleum Tech. 22, 1970). The height becomes
// z' = d (z - eta) / (d + eta), in deep water z - eta, and at most 0.
//
// The water is at rest at time 0. Amplitudes then rise by s^2 (3 - 2 s), with s = t / `rising`.
// Accelerations include the rate of this factor. Effects of second order in steepness (drift,
// sharper crests) and the change of wave length by a current are neglected.
#pragma once

#include <vector>

#include "geometry.hpp"

namespace codend {

// Standard value for loads at sea, m/s2; weights in a model use the same value.
constexpr double gravity = 9.81;

// Returns the wave number (1/m) of a frequency (rad/s, > 0) at a depth (m; may be infinite).
double wave_number(double frequency, double depth);

// Wave motion at a point, without the current.
struct WavePoint {
  double elevation = 0.0;                  // of the surface above the point, m
  double slope_x = 0.0, slope_y = 0.0;     // of the surface
  Vector velocity = Vector::Zero();        // m/s
  Vector velocity_slope = Vector::Zero();  // by height, 1/s
  Vector acceleration = Vector::Zero();    // m/s2
};

struct Waves {
  // Per wave: amplitude, m; frequency, rad/s; phase, rad; direction of travel, rad, 0 along x.
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

  // Must be called once after the fields are filled.
  void prepare();
  bool present() const { return !amplitude.empty(); }
  bool running() const { return present() && time > 0.0; }
  // Computes the present fraction of the full amplitude, and its rate (1/s).
  void risen(double& share, double& rate) const;
  // Returns the wave motion at a point (m, still water surface at z = 0) now.
  WavePoint at(const Vector& place) const;
  // Computes six responses to the wave elevation at a moving point, such as the motions of a hull.
  // Each is the sum of a (even cos q + odd sin q) over all waves. `place` (m) and `velocity` (m/s)
  // describe the point. `even` and `odd` have six numbers per wave. `value` and `rate` are the
  // responses and their time derivatives.
  void respond(const Vector& place, const Vector& velocity, const std::vector<double>& even,
               const std::vector<double>& odd, double value[6], double rate[6]) const;

 private:
  std::vector<double> number_, x_, y_;  // wave numbers (1/m); direction cosines along x and y
};

}  // namespace codend
