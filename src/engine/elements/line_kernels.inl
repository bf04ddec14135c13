// Bodies of the line kernels: not a header of its own. Each line_kernels*.cpp includes it once,
// inside an unnamed namespace that defines `lanes`, the doubles in one register of its processor,
// and after it root() and store_across(). Nothing here may use std:: or an inline function of
// another header: the linker could then hand a copy compiled for AVX2 to a processor without it.

using Pack = double __attribute__((vector_size(8 * lanes)));
using LoosePack = double __attribute__((vector_size(8 * lanes), aligned(8), may_alias));

inline Pack root(Pack x);
// out[step * l ..] = {a[l], b[l], c[l], d[l]}
inline void store_across(Pack a, Pack b, Pack c, Pack d, double* out, int step);

// Packs passed through memory would cost more than the arithmetic.
#define INLINE inline __attribute__((always_inline))

INLINE Pack load(const double* p) { return *reinterpret_cast<const LoosePack*>(p); }
INLINE void store(double* p, Pack x) { *reinterpret_cast<LoosePack*>(p) = x; }

// Of an array that ends after `left` numbers; what is beyond reads as zero.
INLINE Pack load_before_end(const double* p, std::int64_t left) {
  if (left >= lanes) return load(p);
  Pack x = {};
  for (int l = 0; l < left; ++l) x[l] = p[l];
  return x;
}

INLINE Pack size(Pack x) { return x < 0.0 ? -x : x; }
INLINE Pack inverse_or_zero(Pack x) { return x > 0.0 ? 1.0 / x : Pack{}; }

// One vector per lane.
struct Triple {
  Pack x, y, z;
};
INLINE Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
INLINE Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
INLINE Triple operator*(Pack k, Triple a) { return {k * a.x, k * a.y, k * a.z}; }
INLINE Pack dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE Triple load(const double* const p[3], std::int64_t i) {
  return {load(p[0] + i), load(p[1] + i), load(p[2] + i)};
}

// One matrix per lane, by rows.
struct Tensor {
  Triple x, y, z;
};
INLINE Tensor operator+(const Tensor& a, const Tensor& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
INLINE Tensor operator-(const Tensor& a, const Tensor& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
INLINE Tensor operator*(Pack k, const Tensor& a) { return {k * a.x, k * a.y, k * a.z}; }
INLINE Tensor outer(Triple a, Triple b) { return {a.x * b, a.y * b, a.z * b}; }
// k I + a
INLINE Tensor add_diagonal(Pack k, Tensor a) {
  a.x.x += k;
  a.y.y += k;
  a.z.z += k;
  return a;
}

// Numbers from one block to the next among those of all lanes: whole registers.
constexpr int block_step = 12;

// The matrix of lane l at p[block_step * l ..], row-major.
INLINE void store(double* p, const Tensor& a) {
  store_across(a.x.x, a.x.y, a.x.z, a.y.x, p, block_step);
  store_across(a.y.y, a.y.z, a.z.x, a.z.y, p + 4, block_step);
  double last[lanes];
  store(last, a.z.z);
  for (int l = 0; l < lanes; ++l) p[block_step * l + 8] = last[l];
}

// As CylinderCoefficients.
struct Coefficients {
  Pack a, a_n, b, b_n, b_t, c;
};

INLINE Coefficients coefficients(const LineArrays& lines, std::int64_t i, Pack q_n, Pack q_t) {
  Coefficients k;
  k.a_n = load(lines.normal + i);
  k.a = k.a_n * q_n;
  k.b_t = load(lines.tangential + i);
  k.b = k.b_t * q_t;
  k.b_n = Pack{};
  k.c = load(lines.skin + i);
  if (lines.speed_law) {
    // By way of memory, so that registers hold the packs where no line has such a law.
    double q[2][lanes], out[5][lanes];
    store(q[0], q_n);
    store(q[1], q_t);
    store(out[0], k.a);
    store(out[1], k.a_n);
    store(out[2], k.b);
    store(out[3], k.b_n);
    store(out[4], k.b_t);
    for (int l = 0; l < lanes; ++l) {
      if (!lines.speed_law[i + l]) continue;
      double found[5];
      speed_coefficients(*lines.speed_law[i + l], q[0][l], q[1][l], lines.viscosity, found);
      for (int c = 0; c < 5; ++c) out[c][l] = found[c];
    }
    k.a = load(out[0]);
    k.a_n = load(out[1]);
    k.b = load(out[2]);
    k.b_n = load(out[3]);
    k.b_t = load(out[4]);
  }
  return k;
}

void flow(const LineArrays& lines, std::int64_t begin, std::int64_t end) {
  // Means over all directions of a line: of sin^3 of its angle to the flow, and of |cos|^3.
  constexpr double mean_normal = 3.0 * 3.14159265358979323846 / 16.0, mean_tangential = 0.25;
  for (std::int64_t i = begin; i < end; i += lanes) {
    const Triple u = load(lines.u, i);
    const Pack speed = root(dot(u, u));
    const Coefficients k = coefficients(lines, i, speed, speed);
    const Pack weight = load(lines.drag_weight + i);
    store(lines.speed + i, speed);
    store(lines.loose + i, weight * (mean_normal * k.a + mean_tangential * k.b + k.c * speed));
    store(lines.loose_slope + i,
          weight * (mean_normal * k.a_n + mean_tangential * (k.b_n + k.b_t) + k.c));
    store(lines.drag_scale + i, weight * (k.a + k.c * speed));
  }
}

// Drag of straight lines over their weight, by_u U + by_t t with t the unit vector along them.
struct StraightDrag {
  Triple u, t, across;     // across: U_n
  Pack speed, along, q_n;  // along: U.t
  Coefficients k;
  Pack by_u, by_t;
};

INLINE StraightDrag straight_drag(const LineArrays& lines, std::int64_t i, Triple e,
                                  Pack inverse_length) {
  StraightDrag s;
  s.u = load(lines.u, i);
  s.speed = load(lines.speed + i);
  s.t = inverse_length * e;
  s.along = dot(s.u, s.t);
  s.across = s.u - s.along * s.t;
  s.q_n = root(dot(s.across, s.across));
  s.k = coefficients(lines, i, s.q_n, size(s.along));
  s.by_u = s.k.a + s.k.c * s.speed;
  s.by_t = (s.k.b - s.k.a) * s.along;
  return s;
}

// The share of a line's drag that is taken as straight.
INLINE Pack straight_share(const LineArrays& lines, Pack strain) {
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
    const Pack least = load(lines.least_tension + i);
    if (lines.load_law) {
      for (int l = 0; l < lanes; ++l) {
        if (!lines.load_law[i + l] || !(lines.multiplicity[i + l] > 0.0)) continue;
        double found[2];
        load_coefficients(*lines.load_law[i + l], strain[l], found);
        lines.offset[i + l] = found[0];
        lines.stiffness[i + l] = found[1];
      }
    }
    Pack tension = load(lines.stiffness + i) * strain;
    if (lines.load_law) tension = tension + load(lines.offset + i);
    if (lines.damping) {
      const Pack rate = inverse_length * inverse_rest * dot(e, load(lines.e_rate, i)) -
                        (strain + 1.0) * load(lines.rest_rate + i);
      tension = tension + load(lines.damping + i) * rate;
    }
    store(lines.tension + i, tension > least ? tension : least);

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
    const Pack longer = load(lines.inverse_length + i) * inverse_rest * dot(load(lines.e, i), d);
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
INLINE LineSlopes line_slopes(const LineArrays& lines, const LineRequest& request, std::int64_t i,
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
  const Pack stiffness = load(lines.stiffness + i), least = load(lines.least_tension + i);
  Pack modulus, taut;
  Triple sideways = {};  // change of the damper's pull when the line turns
  if (request.modulus) {
    modulus = load_before_end(request.modulus + i, left);
    taut = modulus > 0.0 ? Pack{} + 1.0 : Pack{};
  } else {
    const bool by_tension = lines.damping || lines.load_law;
    taut =
        (by_tension ? load(lines.tension + i) : stiffness * strain) > least ? Pack{} + 1.0 : Pack{};
    modulus = taut * stiffness;
  }
  if (lines.damping) {
    const Pack damping = taut * load(lines.damping + i);
    const Pack by_rate = damping * load(lines.multiplicity + i) * inverse_rest;
    const Triple e_rate = load(lines.e_rate, i);
    modulus = modulus - damping * load(lines.rest_rate + i);
    sideways = (request.stiffness * by_rate * inverse_length) * (e_rate - dot(e_rate, s.t) * s.t) +
               (request.damping * by_rate) * s.t;
  }
  const Pack across = many * tension * inverse_length;
  out.pull = add_diagonal(across, outer((many * modulus * inverse_rest - across) * s.t, s.t));
  if (lines.damping) out.pull = out.pull + outer(s.t, sideways);

  // q_n falls by along/q_n, and U_t grows, where the axis turns towards the flow.
  const Pack weight = load(lines.drag_weight + i);
  const Pack share = straight_share(lines, strain);
  const Pack inverse_q_n = inverse_or_zero(s.q_n);
  const Pack fall = s.along * inverse_q_n;
  const Pack u_slope = -s.k.a_n * fall;
  const Pack t_slope =
      (s.k.b - s.k.a) + s.along * fall * (s.k.a_n - s.k.b_n) + s.k.b_t * size(s.along);
  const Pack turning = request.stiffness * share * weight * inverse_length;
  const Pack aside = turning * s.by_t;
  Triple along_t = (-aside) * s.t;
  if (lines.curved) {
    const Pack slack = strain < 0.0 ? request.stiffness * inverse_rest : Pack{};
    along_t = along_t + (slack * (weight * s.by_u - load(lines.loose + i))) * s.u +
              (slack * weight * s.by_t) * s.t;
  }
  out.turn = add_diagonal(
      aside, outer(along_t, s.t) + outer(turning * (u_slope * s.u + t_slope * s.t), s.across));

  if (with_everywhere) {
    const Pack straight = share * weight, curled = 1.0 - share;
    const Pack inverse_speed = inverse_or_zero(s.speed);
    const Pack by_identity = straight * s.by_u + curled * load(lines.loose + i);
    const Pack by_flow = inverse_speed * (straight * s.k.c + curled * load(lines.loose_slope + i));
    const Pack by_axis = straight * (s.k.b + s.k.b_t * size(s.along) - s.k.a);
    const Triple by_across =
        (straight * inverse_q_n) * (s.k.a_n * s.across + (s.k.b_n * s.along) * s.t);
    const Tensor by_velocity =
        add_diagonal(by_identity, outer(by_flow * s.u, s.u) + outer(by_axis * s.t, s.t) +
                                      outer(by_across, s.across));
    const Pack none = {};
    out.everywhere = (request.damping * point_share * load(lines.own + i)) * by_velocity;
    if (lines.slope[0]) {
      const Triple slope = (none - request.stiffness * point_share) * load(lines.slope, i);
      out.everywhere.x.z += dot(by_velocity.x, slope);
      out.everywhere.y.z += dot(by_velocity.y, slope);
      out.everywhere.z.z += dot(by_velocity.z, slope);
    }
  }
  return out;
}

// values += k * block, 9 each
INLINE void add_scaled(double* values, double k, const double* block) {
  store(values, load(values) + k * load(block));
  if (lanes == 2) store(values + 2, load(values + 2) + k * load(block + 2));
  store(values + 4, load(values + 4) + k * load(block + 4));
  if (lanes == 2) store(values + 6, load(values + 6) + k * load(block + 6));
  values[8] += k * block[8];
}

INLINE void add_block(const BlockSink& sink, std::int64_t slot, const double* block) {
  if (slot >= 0) {
    add_scaled(sink.values + 9 * slot, 1.0, block);
  } else if (slot <= -2) {
    for (std::int64_t j = sink.list_start[-2 - slot]; j < sink.list_start[-1 - slot]; ++j)
      add_scaled(sink.values + 9 * sink.list_block[j], sink.list_weight[j], block);
  }
}

template <bool with_everywhere>
void add_bars(const LineArrays& lines, const LineRequest& request, std::int64_t bars,
              const BlockSink& sink) {
  // a = (-1, 1): without `everywhere` the second column is minus the first.
  alignas(64) double block[4][block_step * lanes];
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
      for (int k = 0; k < 4; ++k) add_block(sink, slot[k], block[k] + block_step * l);
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
  alignas(64) double block[9][block_step * lanes];
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
      for (int k = 0; k < 9; ++k) add_block(sink, slot[k], block[k] + block_step * l);
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

template <bool with_everywhere>
void put_slopes(const LineArrays& lines, const LineRequest& request, std::int64_t begin,
                std::int64_t end, double* out) {
  alignas(64) double block[3][block_step * lanes];
  const Pack none = {};
  const Triple row = {none, none, none};
  store(block[2], Tensor{row, row, row});
  for (std::int64_t i = begin; i < end; i += lanes) {
    const LineSlopes s = line_slopes<with_everywhere>(lines, request, i, 1.0);
    store(block[0], s.pull);
    store(block[1], s.turn);
    if (with_everywhere) store(block[2], s.everywhere);
    const int here = end - i < lanes ? static_cast<int>(end - i) : lanes;
    for (int l = 0; l < here; ++l) {
      for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 9; ++c) *out++ = block[k][block_step * l + c];
      }
    }
  }
}

void slopes(const LineArrays& lines, const LineRequest& request, std::int64_t begin,
            std::int64_t end, double* out) {
  if (request.damping != 0.0 || lines.slope[0])
    put_slopes<true>(lines, request, begin, end, out);
  else
    put_slopes<false>(lines, request, begin, end, out);
}

#undef INLINE

constexpr LineKernels kernels{flow, evaluate, change, add_bar_blocks, add_triangle_blocks, slopes};
