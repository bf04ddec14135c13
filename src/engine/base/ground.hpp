// Contact and friction on the seabed, a horizontal or sloping plane.
//
// Contact is elastic with stiffness k (Pa/m) over an area A. It starts quadratically over a depth
// h, so its stiffness is continuous in the penetration p:
//
//   N = k A p^2 / (2 h) for 0 < p < h,  k A (p - h/2) beyond
//
// The default of k, 3e6 Pa/m, is MoorDyn's bottom stiffness.
// Sliding friction is Coulomb friction, regularised in the velocity v_t along the ground:
//
//   F_t = -mu N v_t / sqrt(|v_t|^2 + e^2).
//
// A body at rest on the ground feels no friction, so parts that only friction could fix creep.
//
// Time integration adds static friction. A spring connects the body to an anchor, its last point of
// sticking. The body slips and drags the anchor along when the spring force would exceed Coulomb's
// limit (P. A. Cundall and O. D. L. Strack, A discrete numerical model for granular assemblies,
// Geotechnique 29, 1979):
//
//   F_t = -mu N w / max(1, |w|),  w = (d + t v_t) / g.
//
// Here d is the displacement along the ground from the anchor, g the slip distance (elastic travel
// before slip), and t a short time that damps sticking. After a reversal, friction rebuilds over
// twice the slip distance.
// Lines have different mu along and across their direction, and an ellipse as slip limit.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry.hpp"

namespace codend {

// Friction coefficients along and across a direction; isotropic (`across`) if it is zero.
struct Rubbing {
  double along = 0.0, across = 0.0;
  Vector way = Vector::Zero();
};

struct Ground {
  bool present = false;
  Vector normal = Vector::UnitZ();   // unit vector out of the ground
  double height = 0.0;               // of the plane along its normal, m: normal . x = height
  Vector velocity = Vector::Zero();  // of the ground along itself, in the frame of the gear, m/s
  double friction = 0.0;             // mu
  double stiffness = 3e6;            // k, Pa/m
  double onset = 0.02;               // h, m
  double slip = 0.02;                // e, m/s
  double slip_distance = 0.01;       // g, m
  double stick_lag = 0.1;            // t, s

  template <class Visit>
  void fields(Visit& visit) {
    visit("normal", normal);
    visit("height", height);
    visit("velocity", velocity);
    visit("friction", friction);
    visit("stiffness", stiffness);
    visit("onset", onset);
    visit("slip", slip);
    visit("slip_distance", slip_distance);
    visit("stick_lag", stick_lag);
  }

  // Computes the normal force (N) at a penetration (m) over an area (m2), and its derivative (N/m).
  void press(double penetration, double area, double& force, double& slope) const {
    force = slope = 0.0;
    if (penetration <= 0.0) return;
    const double soft = penetration < onset ? penetration : onset;
    slope = stiffness * area * soft / onset;
    force = stiffness * area * (0.5 * soft * soft / onset + (penetration - soft));
  }

  // Computes the penetration (m) and its derivative (m/N) at a force (N), with K = k A (N/m).
  void give(double force, double k_area, double& penetration, double& slope) const {
    if (force >= 0.5 * k_area * onset) {
      penetration = force / k_area + 0.5 * onset;
      slope = 1.0 / k_area;
      return;
    }
    penetration = std::sqrt(2.0 * onset * force / k_area);
    slope = onset / (k_area * penetration);
  }

  Rubbing rubbing() const { return {friction, friction, Vector::Zero()}; }

  // Returns the part of x along the ground.
  Vector along(const Vector& x) const { return x - normal.dot(x) * normal; }

  // Returns w at x - anchor (m) and v (m/s). A body slips if w is longer than 1.
  Vector stretch(const Vector& from_anchor, const Vector& v) const {
    return along((from_anchor + stick_lag * (v - velocity)) / slip_distance);
  }

  // Returns the anchor (m) after a step to x, v: x without contact, dragged along by slip.
  Vector draw(const Vector& anchor, const Vector& x, const Vector& v, bool touches) const {
    if (!touches) return x;
    const Vector w = stretch(x - anchor, v);
    const double size = w.norm();
    return size > 1.0 ? Vector(x - slip_distance / size * w) : anchor;
  }

  // Returns the contact force on a point with velocity v per unit normal force. from_anchor: x -
  // anchor (m); null selects sliding friction. Sets the derivatives by position and velocity unless
  // they are null.
  Vector per_press(const Vector& v, const Rubbing& rub, const Vector* from_anchor,
                   Matrix* by_position = nullptr, Matrix* by_velocity = nullptr) const {
    const Vector w = from_anchor ? stretch(*from_anchor, v) : along(v - velocity);
    const double size =
        from_anchor ? std::max(1.0, w.norm()) : std::sqrt(w.squaredNorm() + slip * slip);
    const Vector e = w / size, way = along(rub.way);
    const double square = way.squaredNorm();
    const double anisotropy = square > 0.0 ? (rub.along - rub.across) / square : 0.0;
    if (by_velocity) {
      const double turning = !from_anchor || size > 1.0 ? 1.0 : 0.0;
      const Vector other = anisotropy * (way - (turning * way.dot(e)) * e);
      // Single numbers, because products of small matrices take ten times as long.
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
          const double flat = (i == k ? 1.0 : 0.0) - normal[i] * normal[k] - turning * e[i] * e[k];
          const double slope = -(rub.across * flat + way[i] * other[k]) / size;
          (*by_position)(i, k) = from_anchor ? slope / slip_distance : 0.0;
          (*by_velocity)(i, k) = from_anchor ? stick_lag / slip_distance * slope : slope;
        }
      }
    }
    return normal - rub.across * e - (anisotropy * way.dot(e)) * way;
  }

  // Returns the penetration (m) at x. clearance (m): distance from a point down to its underside.
  double penetration(const Vector& x, double clearance) const {
    return height + clearance - normal.dot(x);
  }

  // Computes the force of the ground (N) on a point with zero clearance, and its derivatives by
  // position and velocity. anchor (m): point of sticking; null selects sliding friction.
  void contact(const Vector& x, const Vector& v, double area, const Rubbing& rub,
               const Vector* anchor, Vector& force, Matrix& by_position,
               Matrix& by_velocity) const {
    double press_force, slope;
    press(penetration(x, 0.0), area, press_force, slope);
    force.setZero();
    by_position.setZero();
    by_velocity.setZero();
    if (slope == 0.0) return;
    const Vector away = anchor ? Vector(x - *anchor) : Vector::Zero();
    const Vector direction =
        per_press(v, rub, anchor ? &away : nullptr, &by_position, &by_velocity);
    force = press_force * direction;
    by_position = Matrix(press_force * by_position - slope * direction * normal.transpose());
    by_velocity *= press_force;
  }
};

}  // namespace codend
