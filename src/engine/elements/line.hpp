// What bars and netting triangles share: one family of parallel lines whose vector is
// e = sum_k a_k x_k over N points and whose drag is shared over them by weights w_k.
#pragma once

#include "kind.hpp"

namespace codend {

template <int N>
struct Line {
  const int* nodes;
  double shape[N];         // a_k
  double share;            // w_k, equal for all points
  double rest;             // L0, m
  double multiplicity;     // lines in parallel
  const TwineMaterial* material;
  int index;               // among all lines of the model

  Vector vector(const double* x) const {
    Vector e = Vector::Zero();
    for (int k = 0; k < N; ++k) e += shape[k] * at(x, nodes[k]);
    return e;
  }

  // Tension of one line, and its change per strain.
  double tension(const Field& field, double length) const {
    return field.tension ? field.tension[index] : twine_tension(*material, length, rest);
  }
  double modulus(const Field& field, double length) const {
    if (field.modulus) return field.modulus[index];
    return length > rest ? material->axial_stiffness : 0.0;
  }

  void relative_velocity(const Field& field, Vector& u, Vector& slope) const {
    double z = 0.0;
    Vector v = Vector::Zero();
    for (int k = 0; k < N; ++k) {
      z += share * at(field.position, nodes[k]).z();
      v += share * at(field.velocity, nodes[k]);
    }
    field.water->velocity(z, u, slope);
    u -= v;
  }

  void add_force(const Field& field, double* force) const {
    const Vector e = vector(field.position);
    const double length = e.norm();
    const double t = tension(field, length);
    const Vector pull = t > 0.0 && length > 0.0 ? Vector(multiplicity * t / length * e) : Vector(Vector::Zero());
    Vector u, slope;
    relative_velocity(field, u, slope);
    const Vector drag =
        multiplicity * share *
        twine_drag(*material, *field.water, field.slack, e, rest, u, false).force;
    for (int k = 0; k < N; ++k) at(force, nodes[k]) += drag - shape[k] * pull;
  }

  void add_jacobian(const Field& field, const JacobianRequest& request, int element,
                    BlockSink& sink) const {
    const Vector e = vector(field.position);
    Vector u, slope;
    relative_velocity(field, u, slope);
    const double length = e.norm();
    const Matrix pull = (request.stiffness * multiplicity) *
                        line_stiffness(e, rest, tension(field, length), modulus(field, length));
    const TwineDrag drag =
        twine_drag(*material, *field.water, field.slack, e, rest, u, true);
    const Matrix turn = (request.stiffness * multiplicity * share) * drag.by_vector;
    // Water that changes with depth, seen by all points through the line's middle.
    Matrix everywhere =
        (request.damping * multiplicity * share * share) * drag.by_velocity;
    everywhere.col(2) -=
        (request.stiffness * multiplicity * share * share) * (drag.by_velocity * slope);
    for (int k = 0; k < N; ++k) {
      for (int l = 0; l < N; ++l) {
        sink.add(element, k, l,
                 (shape[k] * shape[l]) * pull - shape[l] * turn + everywhere);
      }
    }
  }

  void add_added_mass(const Field& field, double* mass) const {
    const Vector e = vector(field.position);
    const double length = e.norm();
    const double water =
        field.water->density * material->volume_per_length * rest * multiplicity * share;
    Matrix m = material->added_mass_normal * water * Matrix::Identity();
    if (length > 0.0) {
      const Vector t = e / length;
      m += (material->added_mass_tangential - material->added_mass_normal) * water *
           (t * t.transpose());
    }
    for (int k = 0; k < N; ++k) {
      Eigen::Map<Block>(mass + 9 * static_cast<std::ptrdiff_t>(nodes[k])) += m;
    }
  }

  void add_drag_scale(const Field& field, double* scale) const {
    Vector u, slope;
    relative_velocity(field, u, slope);
    const double speed = u.norm();
    const CylinderCoefficients k = cylinder_coefficients(material->law, speed, speed,
                                                         material->diameter,
                                                         field.water->viscosity);
    const double c = 0.5 * field.water->density * material->diameter * rest * multiplicity *
                     share * (k.a + k.c * speed);
    for (int n = 0; n < N; ++n) scale[nodes[n]] += c;
  }
};

}  // namespace codend
