#include "netting_screen.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

void WholeCells::prepare() {
  shape_.clear();
  for (int e = 0; e < count(); ++e) {
    shape_.push_back(cell_shape(&twine[8 * static_cast<std::size_t>(e)]));
  }
}

void WholeCells::set_flow(std::size_t e, int place, const Field& field, NettingStrip& s) const {
  const CellShape& shape = shape_[e];
  const int* corner = &node[4 * e];
  const double* x[4];
  for (int k = 0; k < 4; ++k) x[k] = field.position + 3 * static_cast<std::ptrdiff_t>(corner[k]);
  for (int c = 0; c < 3; ++c) {
    s.across[0][c][place] = 0.5 * (x[2][c] - x[0][c]);
    s.across[1][c][place] = 0.5 * (x[3][c] - x[1][c]);
    s.u[c][place] = 0.0;
  }
  if (s.twines) {
    for (int f = 0; f < 2; ++f) {
      for (int c = 0; c < 3; ++c) {
        double along = 0.0;
        for (int k = 1; k < 4; ++k) along += shape.along[f][k] * (x[k][c] - x[0][c]);
        s.twines->e[f][c][place] = along;
      }
    }
  }
  const bool uniform = !field.water->varies_with_height();
  for (int k = 0; k < 4; ++k) {
    Vector u, slope = Vector::Zero();
    double own = field.wake ? field.wake[corner[k]] : 1.0;
    if (uniform) {
      u = own * (field.water->current[0] - at(field.velocity, corner[k]));
    } else {
      own = field.relative_velocity(corner[k], height[e], u, slope);
    }
    s.share[k][place] = shape.share[k];
    for (int c = 0; c < 3; ++c) s.u[c][place] += shape.share[k] * u[c];
    if (!s.with_slopes) continue;
    s.own[k][place] = shape.share[k] * own;
    for (int c = 0; c < 3; ++c) s.slope[k][c][place] = shape.share[k] * slope[c];
  }
}

template <class Visit>
void WholeCells::in_strips(int begin, int end, const Field& field, bool with_slopes,
                           Visit visit) const {
  if (begin == end) return;
  NettingStrip strip;
  strip.with_slopes = with_slopes;
  NettingStrip::Twines twines;
  if (has_twines()) strip.twines = &twines;
  strip.density = field.water->density;
  strip.viscosity = field.water->viscosity;
  strip.drag_multiplier = multipliers.drag;
  strip.lift_multiplier = multipliers.lift;
  for (int k = 0; k < 3; ++k) strip.range[k] = range_of(static_cast<NettingScreenLaw>(k));
  for (int first = begin; first < end; first += NettingStrip::most) {
    strip.count = std::min(end - first, NettingStrip::most);
    twines.by_speed = false;
    for (int place = 0; place < (strip.count + 7) / 8 * 8; ++place) {
      const std::size_t e = static_cast<std::size_t>(std::min(first + place, end - 1));
      strip.overlap[place] = overlap[e];
      strip.multiplicity[place] = multiplicity[e];
      set_flow(e, place, field, strip);
      set_twine(e, place, strip);
    }
    visit(first, strip);
  }
}

Vector WholeCells::element_force(int e, const Field& field) const {
  Vector out;
  in_strips(e, e + 1, field, false, [&](int, NettingStrip& strip) {
    line_kernels().set_screen_forces(strip);
    for (int c = 0; c < 3; ++c) out[c] = strip.force[c][0];
  });
  return out;
}

void WholeCells::add_force(const Field& field, double* out) const {
  in_strips(0, count(), field, false, [&](int first, NettingStrip& strip) {
    line_kernels().set_screen_forces(strip);
    for (int place = 0; place < strip.count; ++place) {
      const int* corner = &node[4 * static_cast<std::size_t>(first + place)];
      for (int k = 0; k < 4; ++k) {
        double* force = out + 3 * static_cast<std::ptrdiff_t>(corner[k]);
        for (int c = 0; c < 3; ++c) force[c] += strip.share[k][place] * strip.force[c][place];
      }
    }
  });
}

void WholeCells::add_jacobian(const Field& field, const JacobianRequest& request,
                              const BlockSink& sink) const {
  in_strips(0, count(), field, true, [&](int first, NettingStrip& strip) {
    line_kernels().add_screen_blocks(strip, request.stiffness, request.damping, first, sink);
  });
}

void WholeCells::add_drag_scale(const Field& field, double, double* scale) const {
  in_strips(0, count(), field, false, [&](int first, NettingStrip& s) {
    for (int place = 0; place < s.count; ++place) {
      const double speed = std::hypot(s.u[0][place], s.u[1][place], s.u[2][place]);
      // Drag coefficient of about 1.2 on the twine area, as for twines across the flow.
      const double whole = 0.6 * s.density * s.twine_area[place] * speed;
      const int* corner = &node[4 * static_cast<std::size_t>(first + place)];
      for (int k = 0; k < 4; ++k) scale[corner[k]] += s.share[k][place] * whole;
    }
  });
}

void NettingScreens::set_twine(std::size_t e, int place, NettingStrip& strip) const {
  strip.law[place] = static_cast<double>(law[e]);
  strip.twine_area[place] = twine_area[e];
  strip.diameter[place] = diameter[e];
}

}  // namespace codend
