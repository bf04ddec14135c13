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
// In a march it sticks instead: a spring holds it to an anchor, where it last stuck, and slips where
// that would take more than Coulomb's force, drawing the anchor along (P. A. Cundall and O. D. L.
// Strack, A discrete numerical model for granular assemblies, Geotechnique 29, 1979):
//   F_t = -mu N w / max(1, |w|),  w = (d + t v_t) / g,
// d the way along the ground from the anchor, g the slip distance, what friction gives before it slips
// (after a reversal it builds up over 2 g), t a short time that damps what sticks. Of a line that rubs
// differently along and across itself, F_t's two parts have their own mu: what slips lies on an ellipse.
#pragma once

#include <cmath>

#include "geometry.hpp"

namespace codend {

// Coefficients of friction along a direction and across it; of no direction, one for all.
struct Rubbing {
  double along = 0.0, across = 0.0;
  Vector way = Vector::Zero();
};

struct Ground {
  bool present = false;
  Vector normal = Vector::UnitZ();   // unit vector out of the ground
  double height = 0.0;               // of the plane along its normal, m: normal . x = height
  Vector velocity = Vector::Zero();  // of the ground in the frame of the gear, along it, m/s
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
    visit("slip_distance", slip_distance);
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

  Rubbing rubbing() const { return {friction, friction, Vector::Zero()}; }

  // How far a body on an anchor is on its way to slipping (w), 1 where it slips; at x - anchor (m), v.
  Vector stretch(const Vector& from_anchor, const Vector& v) const {
    const Vector w = (from_anchor + stick_lag * (v - velocity)) / slip_distance;
    return w - normal.dot(w) * normal;
  }

  // Where a body sticks after a step that ends at x, v: at its anchor, which it draws along where it
  // slips; at x itself where it does not touch.
  Vector draw(const Vector& anchor, const Vector& x, const Vector& v, bool touches) const {
    if (!touches) return x;
    const Vector w = stretch(x - anchor, v);
    const double size = w.norm();
    return size > 1.0 ? Vector(x - slip_distance / size * w) : anchor;
  }

  // Force on a point that moves at v, per normal force, and its derivatives by position and v.
  // from_anchor: x - anchor (m) of one that may stick; null for one that slides.
  Vector per_press(const Vector& v, const Rubbing& rub, const Vector* from_anchor,
                   Matrix& by_position, Matrix& by_velocity) const {
    const Matrix along = Matrix::Identity() - normal * normal.transpose();
    Vector e;
    if (from_anchor) {
      const Vector w = stretch(*from_anchor, v);
      const double size = w.norm();
      Matrix slope = along;
      e = w;
      if (size > 1.0) {
        e = w / size;
        slope = (along - e * e.transpose()) / size;
      }
      by_position = slope / slip_distance;
      by_velocity = slope * (stick_lag / slip_distance);
    } else {
      const Vector sliding = along * (v - velocity);
      const double speed = std::sqrt(sliding.squaredNorm() + slip * slip);
      e = sliding / speed;
      by_position.setZero();
      by_velocity = (along - e * e.transpose()) / speed;
    }
    Matrix share = -rub.across * Matrix::Identity();
    const Vector way = along * rub.way;
    const double length = way.norm();
    if (length > 0.0) {
      share -= (rub.along - rub.across) / (length * length) * way * way.transpose();
    }
    by_position = share * by_position;
    by_velocity = share * by_velocity;
    return normal + share * e;
  }

  // Penetration (m) of a body of this clearance (m, from its point down to its underside) at x.
  double penetration(const Vector& x, double clearance) const {
    return height + clearance - normal.dot(x);
  }

  // Force (N) of the ground on a point with its underside there, and its derivatives by position and
  // velocity. anchor: where it sticks (m), null for one that slides.
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
    const Vector direction = per_press(v, rub, anchor ? &away : nullptr, by_position, by_velocity);
    force = press_force * direction;
    by_position = Matrix(press_force * by_position - slope * direction * normal.transpose());
    by_velocity *= press_force;
  }
};

}  // namespace codend
