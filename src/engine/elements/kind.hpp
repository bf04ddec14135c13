// What every kind of element but lines offers to the assembly: its nodes, its forces and their
// derivatives. A new kind of element is a new class here and one line in Model::kinds().
#pragma once

#include <vector>

#include "../base/block_sink.hpp"
#include "../base/fields.hpp"
#include "../base/geometry.hpp"
#include "../base/ground.hpp"
#include "../base/immersion.hpp"
#include "../base/water.hpp"

namespace codend {

class Bars;

// Where all points are, how they move in the frame of the gear, and what they move in.
struct Field {
  const double* position;  // 3 per point, m
  const double* velocity;  // 3 per point, m/s
  const Water* water;
  // Speed of the flow past each point as a share of the free flow's, behind netting; null: 1.
  const double* wake = nullptr;
  const Ground* ground = nullptr;    // null or not present: none
  const Bars* bars = nullptr;        // of the model, for elements that are made of bars
  const WavePoint* waves = nullptr;  // per point; null where the water is calm
  const char* still = nullptr;       // per point: 1 where nobody asks for forces; null: none

  bool is_still(int point) const { return still && still[point]; }

  // Height of a point above the water's surface, m.
  double above_surface(int point) const {
    const double z = at(position, point).z();
    return waves ? z - waves[point].elevation : z;
  }
  // The share of a body at a point (height in m) that is in the water.
  double immersed_share(int point, double height) const {
    return water->free_surface ? immersion(above_surface(point), height).share : 1.0;
  }
  // Acceleration of the water at a point, m/s2.
  Vector acceleration(int point) const {
    const Vector current = water->acceleration(at(position, point).z());
    return waves ? Vector(current + waves[point].acceleration) : current;
  }
  // Velocity of the water relative to a body at a point (m/s), and how it changes with height (1/s).
  // Of a body (height in m) that is partly out of the water, reduced so that its square drags the
  // immersed share. Returns the share that is taken of the point's own velocity.
  double relative_velocity(int point, double height, Vector& u, Vector& slope) const {
    const double z = at(position, point).z();
    water->velocity(z, u, slope);
    u -= at(velocity, point);
    if (waves) {
      u += waves[point].velocity;
      slope += waves[point].velocity_slope;
    }
    double share = wake ? wake[point] : 1.0;
    slope *= share;
    if (water->free_surface) {
      const Immersion wet = immersion(above_surface(point), height);
      slope = wet.root * slope + share * wet.root_slope * u;
      share *= wet.root;
    }
    u *= share;
    return share;
  }
};

// Asks for stiffness * (-dF/dx) + damping * (-dF/dv).
struct JacobianRequest {
  double stiffness = 1.0;
  double damping = 0.0;
};

class ElementKind {
 public:
  virtual ~ElementKind() = default;
  virtual int nodes_per_element() const = 0;
  // Points of all elements, nodes_per_element() each.
  virtual const std::vector<int>& nodes() const = 0;
  // Adds every element's force (N) to its points.
  virtual void add_force(const Field& field, double* force) const = 0;
  virtual void add_jacobian(const Field& field, const JacobianRequest& request,
                            const BlockSink& sink) const = 0;
  // Adds added mass (kg, 9 per point, row-major) of what is in the water. The water's acceleration times
  // that pushes too, at every point (Assembly); what it does to displaced water (Froude and Krylov) is
  // add_force()'s, of the kinds that know their volume.
  virtual void add_added_mass(const Field& field, double* mass) const = 0;
  // Whether its elements are bodies: their mass joins their points, so that the acceleration of one
  // takes forces on all.
  virtual bool has_bodies() const { return false; }
  // Mass and added mass (kg) of the heaviest.
  virtual double heaviest_body(const Field&) const { return 0.0; }
  // Adds factor times the mass and added mass of every body (kg), a block per pair of its points.
  virtual void add_body_mass(const Field&, double, const BlockSink&) const {}
  // Adds that mass times accelerations (m/s2, 3 per point), N.
  virtual void add_body_inertia(const Field&, const double*, double*) const {}
  // Adds the drag's damping per point (N s/m) at the present speed: a scale for pseudo-time.
  virtual void add_drag_scale(const Field& field, double* scale) const = 0;
  // Whether its elements may stand in an unstable equilibrium, as a plate across the flow or a pole
  // in compression does, and so have to be tried: the size of the least of them, m, by which a
  // perturbation is scaled. 0: no.
  virtual double unstable_size(const Field&) const { return 0.0; }
  // Of these, the greatest stiffness (N/m) with which a point is driven from such an equilibrium;
  // 0: none but the water's.
  virtual double unstable_stiffness() const { return 0.0; }
};

}  // namespace codend
