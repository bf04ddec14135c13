#include "netting_screen.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

void WholeCells::prepare(double density) {
  constexpr std::size_t most = NettingProperties::most;
  const std::size_t cells = multiplicity.size();
  properties_.resize((cells + most - 1) / most);
  twines_.resize(has_twines() ? properties_.size() : 0);
  for (std::size_t k = 0; k < most * properties_.size(); ++k) {
    const std::size_t e = std::min(k, cells - 1), place = k % most;
    const CellShape shape = cell_shape(&twine[8 * e]);
    NettingProperties& to = properties_[k / most];
    to.overlap[place] = overlap[e];
    to.multiplicity[place] = multiplicity[e];
    for (int c = 0; c < 4; ++c) to.share[c][place] = shape.share[c];
    describe(e, place, density, shape, to, has_twines() ? &twines_[k / most] : nullptr);
  }
}

void WholeCells::read_corners(std::size_t e, std::size_t place, const Field& field,
                              bool by_velocity, NettingCorners& to, NettingStrip& strip) const {
  const bool uniform = !field.water->varies_with_height();
  const double* current = field.water->current[0].data();
  for (int k = 0; k < 4; ++k) {
    const int corner = node[4 * e + static_cast<std::size_t>(k)];
    const double* x = field.position + 3 * static_cast<std::ptrdiff_t>(corner);
    const double* v = field.velocity + 3 * static_cast<std::ptrdiff_t>(corner);
    double own = field.wake ? field.wake[corner] : 1.0;
    Vector u, slope;
    if (!uniform) own = field.relative_velocity(corner, height[e], u, slope);
    for (int c = 0; c < 3; ++c) {
      to.position[k][c][place] = x[c];
      to.flow[k][c][place] = uniform ? own * (current[c] - v[c]) : u[c];
    }
    if (!by_velocity) continue;
    const double share = strip.share[k][place];
    strip.own[k][place] = share * own;
    for (int c = 0; c < 3; ++c) strip.slope[k][c][place] = uniform ? 0.0 : share * slope[c];
  }
}

template <class Visit>
void WholeCells::in_strips(const Field& field, bool by_velocity, Visit visit) const {
  constexpr int most = NettingProperties::most;
  NettingStrip strip;
  NettingStrip::Twines twines;
  NettingCorners corners;
  std::fill_n(twines.own, most, 1.0);
  if (has_twines()) strip.twines = &twines;
  strip.density = field.water->density;
  strip.viscosity = field.water->viscosity;
  strip.drag_multiplier = multipliers.drag;
  strip.lift_multiplier = multipliers.lift;
  for (int k = 0; k < 3; ++k) strip.range[k] = range_of(static_cast<NettingScreenLaw>(k));
  for (int first = 0; first < count(); first += most) {
    const std::size_t block = static_cast<std::size_t>(first / most);
    static_cast<NettingProperties&>(strip) = properties_[block];
    if (has_twines()) {
      static_cast<TwineProperties&>(twines) = twines_[block];
      set_laws(static_cast<std::size_t>(first), twines);
    }
    strip.count = std::min(count() - first, most);
    for (int place = 0; place < (strip.count + 7) / 8 * 8; ++place) {
      const std::size_t e = static_cast<std::size_t>(std::min(first + place, count() - 1));
      read_corners(e, static_cast<std::size_t>(place), field, by_velocity, corners, strip);
    }
    line_kernels().set_screen_flow(strip, corners);
    visit(first, strip);
  }
}

std::vector<double> WholeCells::element_forces(const Field& field) const {
  std::vector<double> out(3 * multiplicity.size());
  in_strips(field, false, [&](int first, NettingStrip& strip) {
    line_kernels().set_screen_forces(strip);
    for (int place = 0; place < strip.count; ++place) {
      for (int c = 0; c < 3; ++c) at(out.data(), first + place)[c] = strip.force[c][place];
    }
  });
  return out;
}

void WholeCells::add_force(const Field& field, double* out) const {
  in_strips(field, false, [&](int first, NettingStrip& strip) {
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
  const bool by_velocity = request.damping != 0.0 || field.water->varies_with_height();
  in_strips(field, by_velocity, [&](int first, NettingStrip& strip) {
    line_kernels().add_screen_blocks(strip, request.stiffness, request.damping, by_velocity, first,
                                     sink);
  });
}

void WholeCells::add_drag_scale(const Field& field, double, double* scale) const {
  in_strips(field, false, [&](int first, NettingStrip& s) {
    for (int place = 0; place < s.count; ++place) {
      const double speed = std::hypot(s.u[0][place], s.u[1][place], s.u[2][place]);
      // Drag coefficient of about 1.2 on the twine area, as for twines across the flow.
      const double whole = 0.6 * s.density * s.twine_area[place] * speed;
      const int* corner = &node[4 * static_cast<std::size_t>(first + place)];
      for (int k = 0; k < 4; ++k) scale[corner[k]] += s.share[k][place] * whole;
    }
  });
}

void NettingScreens::describe(std::size_t e, std::size_t place, double, const CellShape&,
                              NettingProperties& to, TwineProperties*) const {
  to.law[place] = static_cast<double>(law[e]);
  to.twine_area[place] = twine_area[e];
  to.diameter[place] = diameter[e];
}

}  // namespace codend
