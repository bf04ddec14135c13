#include "bar.hpp"

namespace codend {

void Bars::add_force(const Field& field, double* force) const {
  for (int b = 0; b < count(); ++b) line(b).add_force(field, force);
}

void Bars::add_jacobian(const Field& field, const JacobianRequest& request,
                        BlockSink& sink) const {
  for (int b = 0; b < count(); ++b) line(b).add_jacobian(field, request, b, sink);
}

void Bars::add_added_mass(const Field& field, double* mass) const {
  for (int b = 0; b < count(); ++b) line(b).add_added_mass(field, mass);
}

void Bars::add_drag_scale(const Field& field, double* scale) const {
  for (int b = 0; b < count(); ++b) line(b).add_drag_scale(field, scale);
}

}  // namespace codend
