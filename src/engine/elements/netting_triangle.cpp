#include "netting_triangle.hpp"

#include <cmath>

namespace codend {

Line<3> NettingTriangles::family(int triangle, int across) const {
  const std::size_t e = static_cast<std::size_t>(triangle);
  const double* c = &twine[6 * e];
  const double d = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]);
  const double s = (across == 1 ? 1.0 : -1.0) / d;
  auto coordinate = [&](int k) { return c[2 * k + across]; };
  return {&node[3 * e],
          {s * (coordinate(1) - coordinate(2)), s * (coordinate(2) - coordinate(0)),
           s * (coordinate(0) - coordinate(1))},
          1.0 / 3.0,
          rest[e],
          0.5 * std::abs(d) * multiplicity[e],
          &(*materials)[material[e]],
          first_line + 2 * triangle + (1 - across)};
}

void NettingTriangles::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    u_line(e).add_force(field, force);
    v_line(e).add_force(field, force);
  }
}

void NettingTriangles::add_jacobian(const Field& field, const JacobianRequest& request,
                                    BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    u_line(e).add_jacobian(field, request, e, sink);
    v_line(e).add_jacobian(field, request, e, sink);
  }
}

void NettingTriangles::add_added_mass(const Field& field, double* mass) const {
  for (int e = 0; e < count(); ++e) {
    u_line(e).add_added_mass(field, mass);
    v_line(e).add_added_mass(field, mass);
  }
}

void NettingTriangles::add_drag_scale(const Field& field, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    u_line(e).add_drag_scale(field, scale);
    v_line(e).add_drag_scale(field, scale);
  }
}

}  // namespace codend
