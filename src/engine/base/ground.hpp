// The sea bed: a plane, level or sloping, that carries what lies on it and rubs against it.
//
// Contact is elastic, with pressure k per depth of penetration p over an area A, and sets in softly
// over a depth h so that its stiffness has no jump:
//
//   N = k A p^2 / (2 h) for 0 < p < h,  k A (p - h/2) beyond
//
// (k as in mooring programs: MoorDyn's bottom stiffness, 3e6 Pa/m by default.) Friction is
// Coulomb's, regularised against the velocity v_t along the ground:
//   F_t = -mu N v_t / sqrt(|v_t|^2 + e^2).
// A body at rest on the ground therefore feels none: what holds by friction alone creeps.
#pragma once

#include <cmath>

#include "geometry.hpp"

namespace codend {

struct Ground {
  bool present = false;
  Vector normal = Vector::UnitZ();   // unit vector out of the ground
  double height = 0.0;               // of the plane along its normal, m: normal . x = height
  Vector velocity = Vector::Zero();  // of the ground in the frame of the gear, along it, m/s
  double friction = 0.0;             // mu
  double stiffness = 3e6;            // k, Pa/m
  double onset = 0.02;               // h, m
  double slip = 0.02;                // e, m/s

  template <class Visit>
  void fields(Visit& visit) {
    visit("normal", normal);
    visit("height", height);
    visit("velocity", velocity);
    visit("friction", friction);
    visit("stiffness", stiffness);
  }

  // Normal force (N) at a penetration (m) over an area (m2), and its derivative.
  void press(double penetration, double area, double& force, double& slope) const {
    force = slope = 0.0;
    if (penetration <= 0.0) return;
    const double soft = penetration < onset ? penetration : onset;
    slope = stiffness * area * soft / onset;
    force = stiffness * area * (0.5 * soft * soft / onset + (penetration - soft));
  }

  // The inverse: penetration (m) that a normal force (N) needs over K = k A (N/m), and its
  // derivative.
  void give(double force, double k_area, double& penetration, double& slope) const {
    if (force >= 0.5 * k_area * onset) {
      penetration = force / k_area + 0.5 * onset;
      slope = 1.0 / k_area;
      return;
    }
    penetration = std::sqrt(2.0 * onset * force / k_area);
    slope = onset / (k_area * penetration);
  }

  // Force on a point that moves at v, per normal force, and its derivative by v.
  Vector per_press(const Vector& v, Matrix& by_velocity) const {
    const Matrix along = Matrix::Identity() - normal * normal.transpose();
    const Vector sliding = along * (v - velocity);
    const double speed = std::sqrt(sliding.squaredNorm() + slip * slip);
    by_velocity = (-friction / speed) * (along - sliding * sliding.transpose() / (speed * speed));
    return normal - (friction / speed) * sliding;
  }

  // Penetration (m) of a body of this clearance (m, from its point down to its underside) at x.
  double penetration(const Vector& x, double clearance) const {
    return height + clearance - normal.dot(x);
  }

  // Force (N) of the ground on a point, and its derivatives by position and velocity.
  void contact(const Vector& x, const Vector& v, double clearance, double area, Vector& force,
               Matrix& by_position, Matrix& by_velocity) const {
    double press_force, slope;
    press(penetration(x, clearance), area, press_force, slope);
    force.setZero();
    by_position.setZero();
    by_velocity.setZero();
    if (slope == 0.0) return;
    const Vector direction = per_press(v, by_velocity);
    force = press_force * direction;
    by_position = -slope * direction * normal.transpose();
    by_velocity *= press_force;
  }
};

}  // namespace codend
