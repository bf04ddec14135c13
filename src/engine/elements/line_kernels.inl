// Bodies of the line kernels: not a header of its own. Each line_kernels*.cpp includes it once,
// inside an unnamed namespace that defines `lanes`, the doubles in one register of its processor,
// and root() after it. Nothing here may use std:: or a function of another header: the linker could
// then hand a copy compiled for AVX2 to a processor without it.

using Pack = double __attribute__((vector_size(8 * lanes)));
using LoosePack = double __attribute__((vector_size(8 * lanes), aligned(8), may_alias));

inline Pack root(Pack x);

inline Pack load(const double* p) { return *reinterpret_cast<const LoosePack*>(p); }
inline void store(double* p, Pack x) { *reinterpret_cast<LoosePack*>(p) = x; }

// Of an array that ends after `left` numbers; what is beyond reads as zero.
inline Pack load_before_end(const double* p, std::int64_t left) {
  if (left >= lanes) return load(p);
  Pack x = {};
  for (int l = 0; l < left; ++l) x[l] = p[l];
  return x;
}

inline Pack size(Pack x) { return x < 0.0 ? -x : x; }
inline Pack inverse_or_zero(Pack x) { return x > 0.0 ? 1.0 / x : Pack{}; }

// One vector per lane.
struct Triple {
  Pack x, y, z;
};
inline Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(Pack k, Triple a) { return {k * a.x, k * a.y, k * a.z}; }
inline Pack dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple load(const double* const p[3], std::int64_t i) {
  return {load(p[0] + i), load(p[1] + i), load(p[2] + i)};
}

// One matrix per lane, by rows.
struct Tensor {
  Triple x, y, z;
};
inline Tensor operator+(const Tensor& a, const Tensor& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Tensor operator-(const Tensor& a, const Tensor& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Tensor operator*(Pack k, const Tensor& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Tensor outer(Triple a, Triple b) { return {a.x * b, a.y * b, a.z * b}; }
// k I + a
inline Tensor add_diagonal(Pack k, Tensor a) {
  a.x.x += k;
  a.y.y += k;
  a.z.z += k;
  return a;
}
inline void store(double* p, const Tensor& a) {
  store(p, a.x.x);
  store(p + lanes, a.x.y);
  store(p + 2 * lanes, a.x.z);
  store(p + 3 * lanes, a.y.x);
  store(p + 4 * lanes, a.y.y);
  store(p + 5 * lanes, a.y.z);
  store(p + 6 * lanes, a.z.x);
  store(p + 7 * lanes, a.z.y);
  store(p + 8 * lanes, a.z.z);
}

// Drag of straight lines over their weight, by_u U + by_t t with t the unit vector along them, and
// the coefficients of cylinder_law.hpp in it.
struct StraightDrag {
  Triple u, t, across;         // across: U_n
  Pack speed, along, q_n;      // along: U.t
  Pack a, a_n, b, b_n, b_t, c;
  Pack by_u, by_t;
};

inline StraightDrag straight_drag(const LineArrays& lines, std::int64_t i, Triple e,
                                  Pack inverse_length) {
  StraightDrag s;
  s.u = load(lines.u, i);
  s.speed = load(lines.speed + i);
  s.t = inverse_length * e;
  s.along = dot(s.u, s.t);
  s.across = s.u - s.along * s.t;
  s.q_n = root(dot(s.across, s.across));
  const Pack q_t = size(s.along);
  s.a_n = load(lines.normal + i);
  s.a = s.a_n * s.q_n;
  s.b_t = load(lines.tangential + i);
  s.b = s.b_t * q_t;
  s.b_n = Pack{};
  s.c = load(lines.skin + i);
  if (lines.speed_law) {
    for (int l = 0; l < lanes; ++l) {
      if (!lines.speed_law[i + l]) continue;
      double k[5];
      speed_coefficients(*lines.speed_law[i + l], s.q_n[l], q_t[l], lines.viscosity, k);
      s.a[l] = k[0];
      s.a_n[l] = k[1];
      s.b[l] = k[2];
      s.b_n[l] = k[3];
      s.b_t[l] = k[4];
    }
  }
  s.by_u = s.a + s.c * s.speed;
  s.by_t = (s.b - s.a) * s.along;
  return s;
}

// The share of a line's drag that is taken as straight.
inline Pack straight_share(const LineArrays& lines, Pack strain) {
  const Pack one = Pack{} + 1.0;
  return lines.curved ? (strain < 0.0 ? one + strain : one) : one;
}

void evaluate(const LineArrays& lines, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; i += lanes) {
    const Triple e = load(lines.e, i);
    const Pack inverse_rest = load(lines.inverse_rest + i);
    const Pack length = root(dot(e, e));
    // Below 1e-12 L0 a line has no direction; it pulls with T e/L0.
    const Pack inverse_length = length * inverse_rest > 1e-12 ? 1.0 / length : inverse_rest;
    const Pack strain = length * inverse_rest - 1.0;
    store(lines.inverse_length + i, inverse_length);
    store(lines.strain + i, strain);
    store(lines.tension + i, strain > 0.0 ? load(lines.stiffness + i) * strain : Pack{});

    const StraightDrag s = straight_drag(lines, i, e, inverse_length);
    const Pack share = straight_share(lines, strain);
    const Pack weight = share * load(lines.drag_weight + i);
    const Pack by_u = weight * s.by_u + (1.0 - share) * load(lines.loose + i);
    const Triple drag = by_u * s.u + (weight * s.by_t) * s.t;
    store(lines.drag[0] + i, drag.x);
    store(lines.drag[1] + i, drag.y);
    store(lines.drag[2] + i, drag.z);
  }
}

double change(const LineArrays& lines, std::int64_t begin, std::int64_t end,
              const double* const change[3], double* strain) {
  Pack largest = {};
  for (std::int64_t i = begin; i < end; i += lanes) {
    const Triple d = load(change, i - begin);
    const Pack inverse_rest = load(lines.inverse_rest + i);
    const Pack turning = inverse_rest * inverse_rest * dot(d, d);
    const Pack longer =
        load(lines.inverse_length + i) * inverse_rest * dot(load(lines.e, i), d);
    if (end - i >= lanes) {
      largest = turning > largest ? turning : largest;
      store(strain + (i - begin), longer);
      continue;
    }
    for (int l = 0; l < end - i; ++l) {
      largest[l] = turning[l] > largest[l] ? turning[l] : largest[l];
      strain[i - begin + l] = longer[l];
    }
  }
  double most = 0.0;
  for (int l = 0; l < lanes; ++l) most = largest[l] > most ? largest[l] : most;
  return most;
}

// With F_k = drag - a_k pull at point k, e = sum_k a_k x_k, a point's share of U and drag: the
// block of points (k, l) is a_k a_l pull - a_l turn + everywhere.
struct LineSlopes {
  Tensor pull;        // d pull/de
  Tensor turn;        // d drag/de
  Tensor everywhere;  // from the water's velocity, the same at all points
};

template <bool with_everywhere>
inline LineSlopes line_slopes(const LineArrays& lines, const LineRequest& request, std::int64_t i,
                              double point_share) {
  const Triple e = load(lines.e, i);
  const Pack inverse_length = load(lines.inverse_length + i);
  const Pack inverse_rest = load(lines.inverse_rest + i);
  const Pack strain = load(lines.strain + i);
  const StraightDrag s = straight_drag(lines, i, e, inverse_length);
  LineSlopes out;

  const Pack many = request.stiffness * load(lines.multiplicity + i);
  const std::int64_t left = request.lines - i;
  const Pack tension = load_before_end(request.tension + i, left);
  const Pack modulus = request.modulus ? load_before_end(request.modulus + i, left)
                                       : (strain > 0.0 ? load(lines.stiffness + i) : Pack{});
  const Pack across = many * tension * inverse_length;
  out.pull = add_diagonal(across, outer((many * modulus * inverse_rest - across) * s.t, s.t));

  // q_n falls by along/q_n, and U_t grows, where the axis turns towards the flow.
  const Pack weight = load(lines.drag_weight + i);
  const Pack share = straight_share(lines, strain);
  const Pack inverse_q_n = inverse_or_zero(s.q_n);
  const Pack fall = s.along * inverse_q_n;
  const Pack u_slope = -s.a_n * fall;
  const Pack t_slope =
      (s.b - s.a) + s.along * fall * (s.a_n - s.b_n) + s.b_t * size(s.along);
  const Pack turning = request.stiffness * share * weight * inverse_length;
  const Pack aside = turning * s.by_t;
  Triple along_t = (-aside) * s.t;
  if (lines.curved) {
    const Pack slack = strain < 0.0 ? request.stiffness * inverse_rest : Pack{};
    along_t = along_t + (slack * (weight * s.by_u - load(lines.loose + i))) * s.u +
              (slack * weight * s.by_t) * s.t;
  }
  out.turn = add_diagonal(aside, outer(along_t, s.t) +
                                     outer(turning * (u_slope * s.u + t_slope * s.t), s.across));

  if (with_everywhere) {
    const Pack straight = share * weight, curled = 1.0 - share;
    const Pack inverse_speed = inverse_or_zero(s.speed);
    const Pack by_identity = straight * s.by_u + curled * load(lines.loose + i);
    const Pack by_flow =
        inverse_speed * (straight * s.c + curled * load(lines.loose_slope + i));
    const Pack by_axis = straight * (s.b + s.b_t * size(s.along) - s.a);
    const Triple by_across =
        (straight * inverse_q_n) * (s.a_n * s.across + (s.b_n * s.along) * s.t);
    const Tensor by_velocity =
        add_diagonal(by_identity, outer(by_flow * s.u, s.u) + outer(by_axis * s.t, s.t) +
                                      outer(by_across, s.across));
    const Pack none = {};
    out.everywhere = (none + request.damping * point_share) * by_velocity;
    if (lines.slope[0]) {
      const Triple slope =
          (none - request.stiffness * point_share) * load(lines.slope, i);
      out.everywhere.x.z += dot(by_velocity.x, slope);
      out.everywhere.y.z += dot(by_velocity.y, slope);
      out.everywhere.z.z += dot(by_velocity.z, slope);
    }
  }
  return out;
}

// Adds lane `lane` of a block stored by store(), times k.
inline void add_block(double* values, const double* block, int lane, double k) {
  for (int c = 0; c < 9; ++c) values[c] += k * block[c * lanes + lane];
}

inline void add_block(const BlockSink& sink, std::int64_t slot, const double* block, int lane,
                      double k) {
  if (slot >= 0) {
    add_block(sink.values + 9 * slot, block, lane, k);
  } else if (slot <= -2) {
    for (std::int64_t j = sink.list_start[-2 - slot]; j < sink.list_start[-1 - slot]; ++j)
      add_block(sink.values + 9 * sink.list_block[j], block, lane, k * sink.list_weight[j]);
  }
}

template <bool with_everywhere>
void add_bars(const LineArrays& lines, const LineRequest& request, std::int64_t bars,
              const BlockSink& sink) {
  // a = (-1, 1): without `everywhere` the second column is minus the first.
  alignas(64) double block[4][9 * lanes];
  for (std::int64_t i = 0; i < bars; i += lanes) {
    const LineSlopes s = line_slopes<with_everywhere>(lines, request, i, 0.5);
    const Tensor first = s.pull + s.turn, second = s.pull - s.turn;
    const Pack none = {};
    if (with_everywhere) {
      store(block[0], s.everywhere + first);
      store(block[1], s.everywhere - first);
      store(block[2], s.everywhere - second);
      store(block[3], s.everywhere + second);
    } else {
      store(block[0], first);
      store(block[1], (none - 1.0) * first);
      store(block[2], (none - 1.0) * second);
      store(block[3], second);
    }
    const int here = bars - i < lanes ? static_cast<int>(bars - i) : lanes;
    for (int l = 0; l < here; ++l) {
      const std::int64_t* slot = sink.slot + 4 * (i + l);
      for (int k = 0; k < 4; ++k) add_block(sink, slot[k], block[k], l, 1.0);
    }
  }
}

void add_bar_blocks(const LineArrays& lines, const LineRequest& request, std::int64_t bars,
                    const BlockSink& sink) {
  if (request.damping != 0.0 || lines.slope[0])
    add_bars<true>(lines, request, bars, sink);
  else
    add_bars<false>(lines, request, bars, sink);
}

template <bool with_everywhere>
void add_triangles(const LineArrays& lines, const LineRequest& request, std::int64_t first,
                   std::int64_t triangles, const double* const shape[6], const BlockSink& sink) {
  alignas(64) double block[9][9 * lanes];
  for (std::int64_t i = 0; i < triangles; i += lanes) {
    const LineSlopes u = line_slopes<with_everywhere>(lines, request, first + i, 1.0 / 3.0);
    const LineSlopes v =
        line_slopes<with_everywhere>(lines, request, first + triangles + i, 1.0 / 3.0);
    for (int k = 0; k < 3; ++k) {
      const Tensor along_u = load(shape[k] + i) * u.pull - u.turn;
      const Tensor along_v = load(shape[3 + k] + i) * v.pull - v.turn;
      for (int l = 0; l < 3; ++l) {
        Tensor sum = load(shape[l] + i) * along_u + load(shape[3 + l] + i) * along_v;
        if (with_everywhere) sum = sum + u.everywhere + v.everywhere;
        store(block[3 * k + l], sum);
      }
    }
    const int here = triangles - i < lanes ? static_cast<int>(triangles - i) : lanes;
    for (int l = 0; l < here; ++l) {
      const std::int64_t* slot = sink.slot + 9 * (i + l);
      for (int k = 0; k < 9; ++k) add_block(sink, slot[k], block[k], l, 1.0);
    }
  }
}

void add_triangle_blocks(const LineArrays& lines, const LineRequest& request, std::int64_t first,
                         std::int64_t triangles, const double* const shape[6],
                         const BlockSink& sink) {
  if (request.damping != 0.0 || lines.slope[0])
    add_triangles<true>(lines, request, first, triangles, shape, sink);
  else
    add_triangles<false>(lines, request, first, triangles, shape, sink);
}

constexpr LineKernels kernels{evaluate, change, add_bar_blocks, add_triangle_blocks};
