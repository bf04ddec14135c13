#include "lines.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

constexpr int strip = 512;
// Cells are skipped in groups of this size, because kernels write whole registers.
constexpr int together = 8;

// Length of each column: an odd number of cache lines. Equal indices of different columns then map
// to different sets of the cache.
std::size_t column_length(int lines) {
  const std::size_t cache_lines = (static_cast<std::size_t>(lines) + 7) / 8 + 1;
  return 8 * (cache_lines | 1);
}

}  // namespace

Lines::Lines(const std::vector<TwineMaterial>& materials, const Bars& bars,
             const NettingCells& cells, const HexagonalTriangles& hexagons, const Water& water,
             SlackDrag slack, const LineKernels& kernels)
    : materials_(materials),
      bars_(bars),
      cells_(cells),
      hexagons_(hexagons),
      water_(water),
      count_(bars.count() + 2 * cells.count() + 3 * hexagons.count()),
      cell_arrays_(cells.arrays()),
      kernels_(kernels) {
  LineArrays& a = arrays_;
  const bool by_height = water.varies_with_height();
  std::vector<double**> columns{&a.inverse_rest,
                                &a.stiffness,
                                &a.least_tension,
                                &a.multiplicity,
                                &a.drag_weight,
                                &a.added_normal,
                                &a.added_tangential,
                                &a.normal,
                                &a.tangential,
                                &a.skin,
                                &a.u[0],
                                &a.u[1],
                                &a.u[2],
                                &a.own,
                                &a.speed,
                                &a.loose,
                                &a.loose_slope,
                                &a.drag_scale,
                                &a.e[0],
                                &a.e[1],
                                &a.e[2],
                                &a.inverse_span,
                                &a.strain,
                                &a.tension,
                                &a.drag[0],
                                &a.drag[1],
                                &a.drag[2]};
  if (by_height) columns.insert(columns.end(), {&a.slope[0], &a.slope[1], &a.slope[2]});
  if (water.free_surface) columns.push_back(&a.wet);
  bool damped = false;
  bool by_table = false;
  for (const TwineMaterial& m : materials) {
    damped = damped || m.damping > 0.0;
    by_table = by_table || !m.loads.empty();
  }
  if (by_table) columns.push_back(&a.offset);
  if (damped) columns.insert(columns.end(), {&a.damping, &a.rest_rate});
  if (damped || cells.count() > 0) {
    columns.insert(columns.end(), {&a.e_rate[0], &a.e_rate[1], &a.e_rate[2]});
  }
  if (cells.count() > 0) {
    columns.insert(columns.end(),
                   {&a.inverse_length, &a.twist_weight, &a.twist_stiffness, &a.held_pull,
                    &a.sag_derivative, &a.sag_stiffness, &a.twist[0], &a.twist[1], &a.twist[2],
                    &a.twist_rate[0], &a.twist_rate[1], &a.twist_rate[2]});
  }
  const std::size_t length = column_length(count_);
  numbers_.assign(columns.size() * length, 0.0);
  for (std::size_t k = 0; k < columns.size(); ++k) *columns[k] = numbers_.data() + k * length;
  if (!a.inverse_length) a.inverse_length = a.inverse_span;
  a.viscosity = water.viscosity;
  a.curved = slack == SlackDrag::curved;
  led_sag_.assign(static_cast<std::size_t>(cells.count()), 0.0);
  in_strips(cells.count(), [&](int begin, int end) { all_cells_.push_back({begin, end}); });
  moving_cells_ = all_cells_;
  for (int b = 0; b < bars.count(); ++b) describe(bars.line(b));
  for (int e = 0; e < cells.count(); ++e) {
    for (int which = 0; which < 2; ++which) describe(cells.line(e, which));
  }
  for (int e = 0; e < hexagons.count(); ++e) {
    for (int which = 0; which < 3; ++which) describe(hexagons.line(e, which));
  }
}

template <int N>
void Lines::describe(const Line<N>& line) {
  const TwineMaterial& m = materials_[static_cast<std::size_t>(line.material)];
  const std::size_t k = static_cast<std::size_t>(line.index);
  arrays_.inverse_rest[k] = 1.0 / line.rest;
  // With no lines in parallel the stiffness is 0.
  arrays_.stiffness[k] = line.multiplicity > 0.0 ? m.axial_stiffness : 0.0;
  arrays_.least_tension[k] = m.strut ? -1e300 : 0.0;
  arrays_.multiplicity[k] = line.multiplicity;
  const double length = line.rest * line.multiplicity * line.point_share;
  arrays_.drag_weight[k] = 0.5 * water_.density * m.diameter * length;
  const double water = water_.density * m.volume_per_length * length;
  arrays_.added_normal[k] = m.added_mass_normal * water;
  arrays_.added_tangential[k] = m.added_mass_tangential * water;
  if (arrays_.twist_weight) {
    arrays_.twist_weight[k] = line.twist_weight;
    arrays_.held_pull[k] = twist_stiffness(m, water_);
    arrays_.twist_stiffness[k] = arrays_.held_pull[k] * line.multiplicity * line.twist_weight;
  }
  if (arrays_.damping) {
    arrays_.damping[k] = line.multiplicity > 0.0 ? m.damping * line.rest : 0.0;
  }
  if (!m.loads.empty()) {
    load_law_.resize(column_length(count_));
    load_law_[k] = &m;
    arrays_.load_law = load_law_.data();
    arrays_.offset[k] = 0.0;
  }
  if (m.law.kind == CylinderLawKind::constant) {
    arrays_.normal[k] = m.law.normal * m.law.normal_share;
    arrays_.tangential[k] = m.law.tangential * m.law.tangential_share;
    arrays_.skin[k] = m.law.skin * m.law.tangential_share;
  } else {
    speed_law_.resize(column_length(count_));
    speed_law_[k] = &m;
    arrays_.speed_law = speed_law_.data();
  }
}

void Lines::set_still(const std::vector<char>& point) {
  const int cells = cells_.count();
  if (point.empty()) {
    still_.clear();
    moving_cells_ = all_cells_;
    renew_ = true;
    return;
  }
  const std::vector<char> before = still_;
  still_.assign(static_cast<std::size_t>(count_), 0);
  moving_cells_.clear();
  for (int begin = 0; begin < cells; begin += together) {
    const int end = std::min(begin + together, cells);
    const bool rests = std::all_of(cells_.node.begin() + 4 * begin, cells_.node.begin() + 4 * end,
                                   [&](int n) { return point[static_cast<std::size_t>(n)] != 0; });
    if (rests) {
      for (int e = begin; e < end; ++e) {
        const std::size_t u = static_cast<std::size_t>(bars_.count() + e);
        still_[u] = still_[u + static_cast<std::size_t>(cells)] = 1;
        // Lines that moved before need one update at the fixed positions.
        renew_ = renew_ || before.empty() || !before[u];
      }
    } else if (!moving_cells_.empty() && moving_cells_.back().end == begin &&
               end - moving_cells_.back().begin <= strip) {
      moving_cells_.back().end = end;
    } else {
      moving_cells_.push_back({begin, end});
    }
  }
}

void Lines::update_bar(int bar, double rest_rate) {
  describe(bars_.line(bar));
  if (arrays_.damping) arrays_.rest_rate[bar] = rest_rate;
}

void Lines::Meeting::add(const Field& field, int point, double share) {
  moving -= share * at(field.velocity, point);
  z += share * at(field.position, point).z();
  own += share * (field.wake ? field.wake[point] : 1.0);
  if (!field.waves) return;
  const WavePoint& waves = field.waves[point];
  moving += share * waves.velocity;
  slope += share * waves.velocity_slope;
  surface += share * waves.elevation;
}

void Lines::set_velocity(const Field& field, const int* node, const double* share, int points,
                         double height, std::initializer_list<int> lines) {
  Meeting meeting;
  for (int k = 0; k < points; ++k) meeting.add(field, node[k], share[k]);
  const int first = *lines.begin();
  set_velocity(static_cast<std::size_t>(first), meeting, height);
  for (const int line : lines) {
    arrays_.own[line] = arrays_.own[first];
    if (arrays_.wet) arrays_.wet[line] = arrays_.wet[first];
    for (int c = 0; c < 3; ++c) {
      arrays_.u[c][line] = arrays_.u[c][first];
      if (arrays_.slope[c]) arrays_.slope[c][line] = arrays_.slope[c][first];
    }
  }
}

void Lines::set_velocity(std::size_t line, const Meeting& meeting, double height) {
  Vector u, slope;
  water_.velocity(meeting.z, u, slope);
  u += meeting.moving;
  slope += meeting.slope;
  double own = meeting.own;
  slope *= own;
  if (water_.free_surface) {
    const Immersion wet = immersion(meeting.z - meeting.surface, height);
    slope = wet.root * slope + own * wet.root_slope * u;
    own *= wet.root;
    arrays_.wet[line] = wet.share;
  }
  u *= own;
  arrays_.own[line] = own;
  for (int c = 0; c < 3; ++c) arrays_.u[c][line] = u[c];
  if (arrays_.slope[0]) {
    for (int c = 0; c < 3; ++c) arrays_.slope[c][line] = slope[c];
  }
}

void Lines::set_flow(const Field& field) {
  constexpr double halves[2] = {0.5, 0.5};
  const bool surface = water_.free_surface;
  for (int b = 0; b < bars_.count(); ++b) {
    const std::size_t k = static_cast<std::size_t>(b);
    set_velocity(field, &bars_.node[2 * k], halves, 2, surface ? bars_.height[k] : 0.0, {b});
  }
  for (const CellRange& range : cells_to_move()) {
    for (int e = range.begin; e < range.end; ++e) {
      const std::size_t k = static_cast<std::size_t>(e);
      const double share[4] = {cells_.share[0][k], cells_.share[1][k], cells_.share[2][k],
                               cells_.share[3][k]};
      const int line = bars_.count() + e;
      set_velocity(field, &cells_.node[4 * k], share, 4, surface ? cells_.height[k] : 0.0,
                   {line, line + cells_.count()});
    }
  }
  for (int e = 0; e < hexagons_.count(); ++e) {
    const double height = surface ? hexagons_.height[static_cast<std::size_t>(e)] : 0.0;
    const int first = hexagons_.first_line + e, step = hexagons_.count();
    set_velocity(field, &hexagons_.node[4 * static_cast<std::size_t>(e)],
                 HexagonalTriangles::share.data(), 4, height,
                 {first, first + step, first + 2 * step});
  }
  kernels_.flow(arrays_, 0, bars_.count());
  for (const CellRange& range : cells_to_move()) {
    const int u = bars_.count() + range.begin, size = range.end - range.begin;
    kernels_.flow(arrays_, u, u + size);
    kernels_.flow(arrays_, u + cells_.count(), u + cells_.count() + size);
  }
  kernels_.flow(arrays_, hexagons_.first_line, count_);
  if (!arrays_.e_rate[0]) return;
  double* rate[3];
  double* v_rate[3];
  double* twist_rate[3];
  for (int c = 0; c < 3; ++c) rate[c] = arrays_.e_rate[c];
  bars_.vectors(field.velocity, 0, bars_.count(), rate);
  const std::ptrdiff_t cells = cells_.count();
  for (const CellRange& range : cells_to_move()) {
    const std::ptrdiff_t u = bars_.count() + range.begin;
    for (int c = 0; c < 3; ++c) {
      rate[c] = arrays_.e_rate[c] + u;
      v_rate[c] = rate[c] + cells;
      twist_rate[c] = arrays_.twist_rate[c] + u;
    }
    cells_.vectors(field.velocity, range.begin, range.end, rate, v_rate, twist_rate);
    for (int c = 0; c < 3; ++c) {
      std::copy_n(twist_rate[c], range.end - range.begin, twist_rate[c] + cells);
    }
  }
  for (int which = 0; which < 3; ++which) {
    const std::ptrdiff_t first = hexagons_.first_line + which * hexagons_.count();
    for (int c = 0; c < 3; ++c) rate[c] = arrays_.e_rate[c] + first;
    hexagons_.vectors(which, field.velocity, 0, hexagons_.count(), rate);
  }
}

template <class Visit>
void Lines::in_strips(int count, Visit visit) {
  for (int begin = 0; begin < count; begin += strip) visit(begin, std::min(begin + strip, count));
}

void Lines::move_to(const double* position) {
  const LineArrays& a = arrays_;
  in_strips(bars_.count(), [&](int begin, int end) {
    double* const e[3] = {a.e[0] + begin, a.e[1] + begin, a.e[2] + begin};
    bars_.vectors(position, begin, end, e);
    kernels_.evaluate(a, begin, end);
  });
  const int cells = cells_.count();
  for (const auto [begin, end] : cells_to_move()) {
    const std::ptrdiff_t u = bars_.count() + begin, v = u + cells, size = end - begin;
    double* const e_u[3] = {a.e[0] + u, a.e[1] + u, a.e[2] + u};
    double* const e_v[3] = {a.e[0] + v, a.e[1] + v, a.e[2] + v};
    double* const q[3] = {a.twist[0] + u, a.twist[1] + u, a.twist[2] + u};
    cells_.vectors(position, begin, end, e_u, e_v, q);
    for (double* twist : q) std::copy_n(twist, size, twist + cells);
    kernels_.set_sag(a, cell_arrays_, begin, end);
    kernels_.evaluate(a, u, u + size);
    kernels_.evaluate(a, v, v + size);
  }
  renew_ = false;
  for (int which = 0; which < 3; ++which) {
    in_strips(hexagons_.count(), [&](int begin, int end) {
      const std::ptrdiff_t i = hexagons_.first_line + which * hexagons_.count() + begin;
      double* const e[3] = {a.e[0] + i, a.e[1] + i, a.e[2] + i};
      hexagons_.vectors(which, position, begin, end, e);
      kernels_.evaluate(a, i, i + end - begin);
    });
  }
}

void Lines::sag_to(const double* tension) {
  for (const auto [begin, end] : moving_cells_) {
    kernels_.lead_sag(arrays_, cell_arrays_, begin, end, tension, led_sag_.data());
  }
}

void Lines::distribute_sag(const double* tension, const double* modulus, const double* mismatch,
                           const double* change, double* strain) const {
  for (const auto [begin, end] : moving_cells_) {
    kernels_.add_sag_strains(arrays_, cell_arrays_, begin, end,
                             {tension, modulus, mismatch, change}, strain);
  }
}

void Lines::add_sag_tensions(const double* tension, const double* modulus, const double* sag,
                             double* sum) const {
  for (int k = 0; k < count_; ++k) {
    if (sag[k] == 0.0) continue;
    sum[k] +=
        (modulus[k] - tension[k] * arrays_.inverse_length[k] / arrays_.inverse_rest[k]) * sag[k];
  }
}

void Lines::change_sag(double* strain) const {
  for (const auto [begin, end] : moving_cells_) {
    kernels_.change_sag(arrays_, cell_arrays_, begin, end, strain);
  }
}

void Lines::add_force(const double* tension, double* force) const {
  bars_.add_force(arrays_, tension, force);
  for (const CellRange& range : moving_cells_) {
    kernels_.add_cell_forces(arrays_, cell_arrays_, cells_.node.data(), range.begin, range.end,
                             tension, force);
  }
  hexagons_.add_force(arrays_, tension, force);
}

void Lines::add_jacobian(const JacobianRequest& request, const double* tension,
                         const double* modulus, const BlockSink& bars, const BlockSink& cells,
                         const BlockSink& hexagons) const {
  const LineRequest asked{request.stiffness, request.damping, tension, modulus, count_};
  kernels_.add_bar_blocks(arrays_, asked, bars_.count(), bars);
  for (const CellRange& range : moving_cells_) {
    kernels_.add_cell_blocks(arrays_, asked, cell_arrays_, range.begin, range.end, cells);
  }
  if (hexagons_.count() == 0) return;
  std::vector<double> slopes(27 * 3 * static_cast<std::size_t>(hexagons_.count()));
  kernels_.slopes(arrays_, asked, hexagons_.first_line, count_, slopes.data());
  hexagons_.add_jacobian(slopes.data(), hexagons);
}

void Lines::add_added_mass(double* mass) const {
  bars_.add_added_mass(arrays_, mass);
  cells_.add_added_mass(arrays_, mass);
  hexagons_.add_added_mass(arrays_, mass);
}

void Lines::add_drag_scale(double* scale) const {
  const double* c = arrays_.drag_scale;
  const std::size_t bars = static_cast<std::size_t>(bars_.count());
  for (std::size_t b = 0; b < bars; ++b) {
    for (int k = 0; k < 2; ++k) scale[bars_.node[2 * b + k]] += c[b];
  }
  for (int e = 0; e < cells_.count(); ++e) {
    const std::size_t cell = static_cast<std::size_t>(e);
    const int line = cells_.first_line + e;
    const double both = c[line] + c[line + cells_.count()];
    for (std::size_t k = 0; k < 4; ++k) {
      scale[cells_.node[4 * cell + k]] += cells_.share[k][cell] * both;
    }
  }
  for (int e = 0; e < hexagons_.count(); ++e) {
    double all = 0.0;
    for (int which = 0; which < 3; ++which) all += c[hexagons_.line(e, which).index];
    for (std::size_t k = 0; k < 4; ++k) {
      scale[hexagons_.node[4 * static_cast<std::size_t>(e) + k]] +=
          HexagonalTriangles::share[k] * all;
    }
  }
}

double Lines::change(const double* dx, double* strain) const {
  // Kernels read whole registers at the end of a strip.
  double u[3][strip + 7] = {}, v[3][strip + 7] = {}, q[3][strip + 7] = {};
  double* const change_u[3] = {u[0], u[1], u[2]};
  double* const change_v[3] = {v[0], v[1], v[2]};
  double* const change_q[3] = {q[0], q[1], q[2]};
  double largest = 0.0;
  in_strips(bars_.count(), [&](int begin, int end) {
    bars_.vectors(dx, begin, end, change_u);
    largest =
        std::max(largest, kernels_.change(arrays_, begin, end, change_u, nullptr, strain + begin));
  });
  const int cells = cells_.count();
  if (!still_.empty()) {
    std::fill(strain + bars_.count(), strain + bars_.count() + 2 * cells, 0.0);
  }
  for (const auto [begin, end] : moving_cells_) {
    const std::ptrdiff_t first = bars_.count() + begin, second = first + cells, size = end - begin;
    cells_.vectors(dx, begin, end, change_u, change_v, change_q);
    largest = std::max(
        largest, kernels_.change(arrays_, first, first + size, change_u, change_q, strain + first));
    largest = std::max(largest, kernels_.change(arrays_, second, second + size, change_v, change_q,
                                                strain + second));
  }
  for (int which = 0; which < 3; ++which) {
    in_strips(hexagons_.count(), [&](int begin, int end) {
      const std::ptrdiff_t first = hexagons_.first_line + which * hexagons_.count() + begin;
      hexagons_.vectors(which, dx, begin, end, change_u);
      largest = std::max(largest, kernels_.change(arrays_, first, first + end - begin, change_u,
                                                  nullptr, strain + first));
    });
  }
  return std::sqrt(largest);
}

}  // namespace codend
