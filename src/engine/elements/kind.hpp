// Interface between the assembly and all kinds of elements except lines: nodes, forces and their
// derivatives. A new kind of element needs a new class here and one line in `Model::kinds()`.
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

// Positions and velocities of all points in the frame of the gear, and their surroundings.
struct Field {
  const double* position;  // 3 per point, m
  const double* velocity;  // 3 per point, m/s
  const Water* water;
  // Speed of the flow at each point as a fraction of the undisturbed speed, behind netting; null:
  // 1.
  const double* wake = nullptr;
  const Ground* ground = nullptr;    // null or not present: no ground
  const Bars* bars = nullptr;        // bars of the model, for elements made of bars
  const WavePoint* waves = nullptr;  // per point; null where the water is calm
  const char* still = nullptr;       // per point: 1 if its force is not needed; null: none

  bool is_still(int point) const { return still && still[point]; }

  // Height of a point above the water surface, m.
  double above_surface(int point) const {
    const double z = at(position, point).z();
    return waves ? z - waves[point].elevation : z;
  }
  // Fraction of a body at a point that is immersed. height: vertical size of the body, m.
  double immersed_share(int point, double height) const {
    return water->free_surface ? immersion(above_surface(point), height).share : 1.0;
  }
  // Acceleration of the water at a point, m/s2.
  Vector acceleration(int point) const {
    const Vector current = water->acceleration(at(position, point).z());
    return waves ? Vector(current + waves[point].acceleration) : current;
  }
  // Computes the velocity u of the water relative to a body at a point (m/s) and its derivative by
  // height, `slope` (1/s). For a body (height in m) partly out of the water, both are reduced so
  // that drag, which is proportional to |u|^2, scales with the immersed fraction. Returns the
  // factor -du/dv of the point's own velocity.
  double relative_velocity(int point, double height, Vector& u, Vector& slope) const {
    return relative_velocity(point, height, at(velocity, point), u, slope);
  }
  // The same for a body at this point that moves with the velocity `own` (m/s).
  double relative_velocity(int point, double height, const Vector& own, Vector& u,
                           Vector& slope) const {
    const double z = at(position, point).z();
    water->velocity(z, u, slope);
    u -= own;
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

// Requests stiffness * (-dF/dx) + damping * (-dF/dv).
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
  // Adds the added mass of the immersed parts (kg, 9 per point, row-major). Assembly multiplies it
  // by the water's acceleration to get one part of the force on each point. The other part, on the
  // displaced water (Froude-Krylov), is added by add_force() of the kinds that know their volume.
  virtual void add_added_mass(const Field&, double*) const {}
  // True if the elements are rigid bodies. Their mass couples their points, so that the
  // acceleration of one point depends on the forces on all.
  virtual bool has_bodies() const { return false; }
  // Mass plus added mass of the heaviest body, kg.
  virtual double heaviest_body(const Field&) const { return 0.0; }
  // Adds factor times the mass and added mass of every body (kg), one block per pair of its points.
  virtual void add_body_mass(const Field&, double, const BlockSink&) const {}
  // Adds the same mass times accelerations (m/s2, 3 per point), N.
  virtual void add_body_inertia(const Field&, const double*, double*) const {}
  // Adds the damping by drag at the present speed, and the mass of bodies over `time` (s), to each
  // point (N s/m): a scale for pseudo time.
  virtual void add_drag_scale(const Field&, double, double*) const {}
  // Size (m) of the smallest element that can be in unstable equilibrium, such as a plate across
  // the flow or a pole in compression. It scales the perturbation that tests stability. 0: none.
  virtual double unstable_size(const Field&) const { return 0.0; }
  // Largest stiffness (N/m) that drives a point away from this unstable equilibrium.
  // 0: only hydrodynamic forces do.
  virtual double unstable_stiffness() const { return 0.0; }
};

}  // namespace codend
