// Bodies of the line kernels, not a standalone header. Each line_kernels*.cpp includes this file
// once inside an unnamed namespace, which must define `lanes`, the doubles per register, before it.
// The file must define root() and store_across() after it. Do not use std:: or inline functions of
// other headers here: the linker could give a processor without AVX2 a copy compiled for AVX2.

using Pack = double __attribute__((vector_size(8 * lanes)));
using Mask = decltype(Pack{} < Pack{});
// Unaligned pack. With `using`, clang would assume alignment.
typedef double LoosePack __attribute__((vector_size(8 * lanes), aligned(8), may_alias));

inline Pack root(Pack x);
// out[step * l ..] = {a[l], b[l], c[l], d[l]}
inline void store_across(Pack a, Pack b, Pack c, Pack d, double* out, int step);

// Passing packs through memory would cost more than the arithmetic.
#define INLINE inline __attribute__((always_inline))

INLINE Pack load(const double* p) { return *reinterpret_cast<const LoosePack*>(p); }
INLINE void store(double* p, Pack x) { *reinterpret_cast<LoosePack*>(p) = x; }

// Calls for the last lanes of an array keep the machine code small.
#define CALLED __attribute__((noinline))
CALLED void load_part(const double* p, std::int64_t left, double* out) {
  for (int l = 0; l < lanes; ++l) out[l] = l < left ? p[l] : 0.0;
}
CALLED void store_part(double* p, std::int64_t left, const double* from) {
  for (int l = 0; l < left; ++l) p[l] = from[l];
}
#undef CALLED

// Loads from an array that ends after `left` numbers, with zeros beyond.
INLINE Pack load_before_end(const double* p, std::int64_t left) {
  if (left >= lanes) return load(p);
  double part[lanes];
  load_part(p, left, part);
  return load(part);
}

// Stores into an array that ends after `left` numbers.
INLINE void store_before_end(double* p, std::int64_t left, Pack x) {
  if (left >= lanes) return store(p, x);
  double part[lanes];
  store(part, x);
  store_part(p, left, part);
}

INLINE Pack size(Pack x) { return x < 0.0 ? -x : x; }
INLINE bool any(Mask mask) {
  auto found = mask[0];
  for (int l = 1; l < lanes; ++l) found |= mask[l];
  return found != 0;
}
INLINE Pack inverse_or_zero(Pack x) { return x > 0.0 ? 1.0 / x : Pack{}; }

// One vector per lane.
struct Triple {
  Pack x, y, z;
};
INLINE Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
INLINE Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
INLINE Triple operator*(Pack k, Triple a) { return {k * a.x, k * a.y, k * a.z}; }
INLINE Pack dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE Triple cross(Triple a, Triple b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
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

// Distance of the blocks of successive lanes in memory, a multiple of the register size.
constexpr int block_step = 12;

// Stores the matrix of lane l at p[block_step * l ..], row-major.
INLINE void store(double* p, const Tensor& a) {
  store_across(a.x.x, a.x.y, a.x.z, a.y.x, p, block_step);
  store_across(a.y.y, a.y.z, a.z.x, a.z.y, p + 4, block_step);
  double last[lanes];
  store(last, a.z.z);
  for (int l = 0; l < lanes; ++l) p[block_step * l + 8] = last[l];
}

// See CylinderCoefficients.
struct Coefficients {
  Pack a, a_n, b, b_n, b_t, c;
};

#include "cylinder_drag_model.inl"

INLINE Coefficients coefficients(const LineArrays& lines, std::int64_t i, Pack q_n, Pack q_t) {
  Coefficients k;
  k.a_n = load(lines.normal + i);
  k.a = k.a_n * q_n;
  k.b_t = load(lines.tangential + i);
  k.b = k.b_t * q_t;
  k.b_n = Pack{};
  k.c = load(lines.skin + i);
  if (lines.speed_law) use_speed_laws(lines.speed_law + i, lines.viscosity, q_n, q_t, k);
  return k;
}

void flow(const LineArrays& lines, std::int64_t begin, std::int64_t end) {
  // Means over all directions of a line: of |sin|^3 of its angle to the flow, and of |cos|^3.
  constexpr double mean_normal = 3.0 * pi / 16.0, mean_tangential = 0.25;
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

// Drag of straight lines over their weight, by_u U + by_t t, with t the unit vector along them.
struct StraightDrag {
  Triple u, t, across;     // across: U_n
  Pack speed, along, q_n;  // along: U.t
  Coefficients k;
  Pack by_u, by_t;
};

INLINE StraightDrag straight_drag(const LineArrays& lines, std::int64_t i, Triple e,
                                  Pack inverse_span) {
  StraightDrag s;
  s.u = load(lines.u, i);
  s.speed = load(lines.speed + i);
  s.t = inverse_span * e;
  s.along = dot(s.u, s.t);
  s.across = s.u - s.along * s.t;
  s.q_n = root(dot(s.across, s.across));
  s.k = coefficients(lines, i, s.q_n, size(s.along));
  s.by_u = s.k.a + s.k.c * s.speed;
  s.by_t = (s.k.b - s.k.a) * s.along;
  return s;
}

// |e|/L0 - 1.
INLINE Pack span_strain(Triple e, Pack inverse_span, Pack inverse_rest) {
  return dot(e, e) * inverse_span * inverse_rest - 1.0;
}

// Fraction of a line's drag computed as for a straight line; strain: see span_strain().
INLINE Pack straight_share(const LineArrays& lines, Pack strain) {
  const Pack one = Pack{} + 1.0;
  return lines.curved ? (strain < 0.0 ? one + strain : one) : one;
}

INLINE Triple line_drag(const LineArrays& lines, std::int64_t i, Triple e, Pack inverse_span,
                        Pack inverse_rest) {
  const StraightDrag s = straight_drag(lines, i, e, inverse_span);
  const Pack share = straight_share(lines, span_strain(e, inverse_span, inverse_rest));
  const Pack weight = share * load(lines.drag_weight + i);
  const Pack by_u = weight * s.by_u + (1.0 - share) * load(lines.loose + i);
  return by_u * s.u + (weight * s.by_t) * s.t;
}

// A line shorter than 1e-12 L0 has no direction; its pull is T e/L0.
INLINE Pack inverse_length(Pack length, Pack inverse_rest) {
  return length * inverse_rest > 1e-12 ? 1.0 / length : inverse_rest;
}

// Tension of the constitutive law, before the lower bound: offset + stiffness * strain.
struct Law {
  Pack offset, stiffness;
};

INLINE Law law_at(const LineArrays& lines, std::int64_t i, Pack strain) {
  Law law = {Pack{}, load(lines.stiffness + i)};
  if (lines.load_law) {
    for (int l = 0; l < lanes; ++l) {
      if (!lines.load_law[i + l] || !(lines.multiplicity[i + l] > 0.0)) continue;
      double found[2];
      load_coefficients(*lines.load_law[i + l], strain[l], found);
      law.offset[l] = found[0];
      law.stiffness[l] = found[1];
    }
  }
  return law;
}

void evaluate(const LineArrays& lines, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; i += lanes) {
    const Triple e = load(lines.e, i);
    const Pack inverse_rest = load(lines.inverse_rest + i);
    const Pack span = root(dot(e, e));
    const Pack inverse_span = inverse_length(span, inverse_rest);
    store(lines.inverse_span + i, inverse_span);
    Pack length = span, inverse = inverse_span;
    if (lines.twist_weight) {
      const Triple q = load(lines.twist, i);
      const Pack twisted = load(lines.twist_weight + i) * dot(q, q);
      const Pack whole = root(dot(e, e) + twisted);
      length = twisted > 0.0 ? whole : span;
      inverse = twisted > 0.0 ? inverse_length(whole, inverse_rest) : inverse_span;
      store(lines.inverse_length + i, inverse);
    }
    const Pack strain = length * inverse_rest - 1.0;
    store(lines.strain + i, strain);
    const Pack least = load(lines.least_tension + i);
    const Law law = law_at(lines, i, strain);
    if (lines.load_law) {
      store(lines.offset + i, law.offset);
      store(lines.stiffness + i, law.stiffness);
    }
    Pack tension = law.stiffness * strain;
    if (lines.load_law) tension = tension + law.offset;
    if (lines.damping) {
      Pack stretching = dot(e, load(lines.e_rate, i));
      if (lines.twist_weight) {
        stretching = stretching + load(lines.twist_weight + i) *
                                      dot(load(lines.twist, i), load(lines.twist_rate, i));
      }
      const Pack rate =
          inverse * inverse_rest * stretching - (strain + 1.0) * load(lines.rest_rate + i);
      tension = tension + load(lines.damping + i) * rate;
    }
    store(lines.tension + i, tension > least ? tension : least);

    const Triple drag = line_drag(lines, i, e, inverse_span, inverse_rest);
    store(lines.drag[0] + i, drag.x);
    store(lines.drag[1] + i, drag.y);
    store(lines.drag[2] + i, drag.z);
  }
}

double change(const LineArrays& lines, std::int64_t begin, std::int64_t end,
              const double* const change[3], const double* const* twist, double* strain) {
  Pack largest = {};
  for (std::int64_t i = begin; i < end; i += lanes) {
    const Triple d = load(change, i - begin);
    const Pack inverse_rest = load(lines.inverse_rest + i);
    Pack squares = dot(d, d), stretching = dot(load(lines.e, i), d);
    if (twist) {
      const Pack weight = load(lines.twist_weight + i);
      const Triple q = load(twist, i - begin);
      squares = squares + weight * dot(q, q);
      stretching = stretching + weight * dot(load(lines.twist, i), q);
    }
    const Pack turning = inverse_rest * inverse_rest * squares;
    const Pack longer = load(lines.inverse_length + i) * inverse_rest * stretching;
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

// Stiffness of the pull of lines: tension T over length, and modulus over rest length.
struct LineStiffness {
  Pack tension, modulus;  // M T/L and M EA/L0 times the requested stiffness
  Pack by_rate;           // M c/L0 of a taut line
};

INLINE LineStiffness line_stiffness(const LineArrays& lines, const LineRequest& request,
                                    std::int64_t i) {
  const Pack inverse_rest = load(lines.inverse_rest + i);
  const Pack many = request.stiffness * load(lines.multiplicity + i);
  const std::int64_t left = request.lines - i;
  const Pack stiffness = load(lines.stiffness + i), least = load(lines.least_tension + i);
  Pack modulus, taut;
  if (request.modulus) {
    modulus = load_before_end(request.modulus + i, left);
    taut = modulus > 0.0 ? Pack{} + 1.0 : Pack{};
  } else {
    const bool by_tension = lines.damping || lines.load_law;
    const Pack tension = by_tension ? load(lines.tension + i) : stiffness * load(lines.strain + i);
    taut = tension > least ? Pack{} + 1.0 : Pack{};
    modulus = taut * stiffness;
  }
  LineStiffness out;
  out.by_rate = Pack{};
  if (lines.damping) {
    const Pack damping = taut * load(lines.damping + i);
    out.by_rate = damping * load(lines.multiplicity + i) * inverse_rest;
    modulus = modulus - damping * load(lines.rest_rate + i);
  }
  out.tension = many * load_before_end(request.tension + i, left) * load(lines.inverse_length + i);
  out.modulus = many * modulus * inverse_rest;
  return out;
}

// Drag and its derivatives, for one point's fraction of drag and of U.
struct DragSlopes {
  Triple drag;
  Tensor turn;        // d drag/de
  Tensor everywhere;  // by the water's velocity, identical at all points
};

template <bool with_everywhere>
INLINE DragSlopes drag_slopes(const LineArrays& lines, const LineRequest& request, std::int64_t i,
                              double point_share) {
  const Triple e = load(lines.e, i);
  const Pack inverse_span = load(lines.inverse_span + i);
  const Pack inverse_rest = load(lines.inverse_rest + i);
  const Pack strain = span_strain(e, inverse_span, inverse_rest);
  const StraightDrag s = straight_drag(lines, i, e, inverse_span);
  DragSlopes out;
  // If the axis turns towards the flow, q_n decreases by along/q_n and U_t increases.
  const Pack weight = load(lines.drag_weight + i);
  const Pack share = straight_share(lines, strain);
  const Pack inverse_q_n = inverse_or_zero(s.q_n);
  const Pack fall = s.along * inverse_q_n;
  const Pack u_slope = -s.k.a_n * fall;
  const Pack t_slope =
      (s.k.b - s.k.a) + s.along * fall * (s.k.a_n - s.k.b_n) + s.k.b_t * size(s.along);
  const Pack turning = request.stiffness * share * weight * inverse_span;
  const Pack aside = turning * s.by_t;
  Triple along_t = (-aside) * s.t;
  if (lines.curved) {
    const Pack slack = strain < 0.0 ? request.stiffness * inverse_rest : Pack{};
    along_t = along_t + (slack * (weight * s.by_u - load(lines.loose + i))) * s.u +
              (slack * weight * s.by_t) * s.t;
  }
  out.turn = add_diagonal(
      aside, outer(along_t, s.t) + outer(turning * (u_slope * s.u + t_slope * s.t), s.across));

  const Pack straight = share * weight, curled = 1.0 - share;
  const Pack by_identity = straight * s.by_u + curled * load(lines.loose + i);
  out.drag = by_identity * s.u + (straight * s.by_t) * s.t;
  if (with_everywhere) {
    const Pack inverse_speed = inverse_or_zero(s.speed);
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

// Derivatives for lines without a twist. With F_k = drag - a_k pull at point k, e = sum_k a_k x_k
// and one point's fraction of U and drag, the block of points (k, l) is a_k a_l pull - a_l turn +
// everywhere.
struct LineSlopes {
  Tensor pull;  // d pull/de
  Tensor turn, everywhere;
};

template <bool with_everywhere>
INLINE LineSlopes line_slopes(const LineArrays& lines, const LineRequest& request, std::int64_t i,
                              double point_share) {
  const LineStiffness k = line_stiffness(lines, request, i);
  const DragSlopes drag = drag_slopes<with_everywhere>(lines, request, i, point_share);
  LineSlopes out;
  out.turn = drag.turn;
  if (with_everywhere) out.everywhere = drag.everywhere;
  const Pack inverse_length = load(lines.inverse_length + i);
  const Triple t = inverse_length * load(lines.e, i);
  out.pull = add_diagonal(k.tension, outer((k.modulus - k.tension) * t, t));
  if (lines.damping) {
    const Triple e_rate = load(lines.e_rate, i);
    out.pull = out.pull + outer(t, (request.stiffness * k.by_rate * inverse_length) *
                                           (e_rate - dot(e_rate, t) * t) +
                                       (request.damping * k.by_rate) * t);
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

INLINE void add_block(const BlockSink& sink, std::int64_t slot, double share, const double* block) {
  if (slot >= 0) {
    add_scaled(sink.values + 9 * slot, share, block);
  } else if (slot <= -2) {
    for (std::int64_t j = sink.list_start[-2 - slot]; j < sink.list_start[-1 - slot]; ++j)
      add_scaled(sink.values + 9 * sink.list_block[j], share * sink.list_weight[j], block);
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
      for (int k = 0; k < 4; ++k) add_block(sink, slot[k], 1.0, block[k] + block_step * l);
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

void add_cell_forces(const LineArrays& lines, const CellArrays& cells, const int* node,
                     std::int64_t begin, std::int64_t end, const double* tension, double* force) {
  alignas(64) double corner[4][4 * lanes];
  for (std::int64_t i = begin; i < end; i += lanes) {
    const std::int64_t u = cells.first + i, v = u + cells.count, left = cells.count - i;
    auto pull = [&](std::int64_t line) {
      return load(lines.multiplicity + line) * load_before_end(tension + line, left) *
             load(lines.inverse_length + line);
    };
    const Pack pull_u = pull(u), pull_v = pull(v);
    const Pack held = pull_u * load(lines.twist_weight + u) +
                      pull_v * load(lines.twist_weight + v) + load(lines.twist_stiffness + u) +
                      load(lines.twist_stiffness + v);
    const Pack amplitude = load(cells.amplitude + i);
    const Pack damped =
        (1.0 / 9.0) * amplitude * amplitude * (load(lines.loose + u) + load(lines.loose + v));
    const Triple drag = load(lines.drag, u) + load(lines.drag, v);
    const Triple along_u = pull_u * load(lines.e, u), along_v = pull_v * load(lines.e, v);
    const Triple twisted = held * load(lines.twist, u) + damped * load(lines.twist_rate, u);
    for (int k = 0; k < 4; ++k) {
      const Triple f = load(cells.share[k] + i) * drag - load(cells.along[0][k] + i) * along_u -
                       load(cells.along[1][k] + i) * along_v - load(cells.twist[k] + i) * twisted;
      store_across(f.x, f.y, f.z, Pack{}, corner[k], 4);
    }
    const int here = end - i < lanes ? static_cast<int>(end - i) : lanes;
    for (int l = 0; l < here; ++l) {
      for (int k = 0; k < 4; ++k) {
        double* to = force + 3 * static_cast<std::int64_t>(node[4 * (i + l) + k]);
        for (int c = 0; c < 3; ++c) to[c] += corner[k][4 * l + c];
      }
    }
  }
}

// One family of a cell. With G_k = (a_k e + kappa g_k q)/L, the derivative of length by the
// position of point k, the pull at k is M T G_k. The block of points (k, l) is
//   M [(EA/L0 - T/L) G_k G_l^T + T/L (a_k a_l + kappa g_k g_l) I]
struct CellFamily {
  LineStiffness k;
  DragSlopes drag;
  Triple pull[4];    // G_k
  Triple answer[4];  // derivative of tension by the position of point k
  Pack weight;       // kappa
  // With l and A of sag.inl, A by the constitutive law without dampers: sag is A l and
  // sag_stiffness A l^2. As sag increases, the pull at point k decreases by by_pull G_k + by_twist
  // g_k q.
  Pack sag, by_pull, by_twist, sag_stiffness;
};

INLINE void cell_bow(const LineArrays& lines, const LineRequest& request, std::int64_t i, Pack rate,
                     CellFamily& out) {
  const Pack slope = load(lines.sag_derivative + i);
  const Pack by_law = (out.k.modulus - out.k.tension) * slope;
  out.sag = out.by_pull = by_law;
  out.by_twist = Pack{};
  if (lines.damping && !request.modulus) {
    const Pack many = request.stiffness * load(lines.multiplicity + i);
    const Pack inverse_length = load(lines.inverse_length + i);
    const Pack stiffness = load(lines.stiffness + i);
    Pack tension = stiffness * load(lines.strain + i);
    if (lines.load_law) tension = tension + load(lines.offset + i);
    const Pack pull = many * inverse_length * (tension > 0.0 ? tension : Pack{});
    const Pack modulus = tension > 0.0 ? many * stiffness * load(lines.inverse_rest + i) : Pack{};
    out.sag = (modulus - pull) * slope;
    const Triple q = load(lines.twist, i);
    const Pack by_square = 2.0 * slope * inverse_or_zero(dot(q, q));  // dkappa/ds over L
    out.by_pull = by_law + request.stiffness * out.k.by_rate *
                               (by_square * dot(q, load(lines.twist_rate, i)) -
                                slope * inverse_length * rate);
    out.by_twist = (out.k.tension - pull) * by_square / inverse_length;
  }
  out.sag_stiffness = out.sag * slope;
}

template <bool with_everywhere>
INLINE void cell_family(const LineArrays& lines, const LineRequest& request, std::int64_t i,
                        std::int64_t cell, const CellArrays& shape, int which, CellFamily& out) {
  out.k = line_stiffness(lines, request, i);
  out.drag = drag_slopes<with_everywhere>(lines, request, i, 1.0);
  out.weight = load(lines.twist_weight + i);
  const Pack inverse_length = load(lines.inverse_length + i);
  const Triple e = inverse_length * load(lines.e, i);
  const Triple q = (inverse_length * out.weight) * load(lines.twist, i);
  Triple e_rate = {}, q_rate = {};
  Pack rate = {};
  if (lines.damping) {
    e_rate = load(lines.e_rate, i);
    q_rate = load(lines.twist_rate, i);
    rate = dot(e, e_rate) + dot(q, q_rate);
    q_rate = out.weight * q_rate;
  }
  cell_bow(lines, request, i, rate, out);
  for (int k = 0; k < 4; ++k) {
    const Pack a = load(shape.along[which][k] + cell), g = load(shape.twist[k] + cell);
    out.pull[k] = a * e + g * q;
    out.answer[k] = (out.k.modulus - out.k.tension) * out.pull[k];
    if (!lines.damping) continue;
    const Triple turned = a * e_rate + g * q_rate - rate * out.pull[k];
    out.answer[k] = out.answer[k] + (request.stiffness * out.k.by_rate * inverse_length) * turned +
                    (request.damping * out.k.by_rate) * out.pull[k];
  }
}

template <bool with_everywhere>
void add_cells(const LineArrays& lines, const LineRequest& request, const CellArrays& shape,
               std::int64_t begin, std::int64_t end, const BlockSink& sink) {
  alignas(64) double block[16][block_step * lanes];
  for (std::int64_t i = begin; i < end; i += lanes) {
    const std::int64_t at_u = shape.first + i, at_v = at_u + shape.count;
    CellFamily u, v;
    cell_family<with_everywhere>(lines, request, at_u, i, shape, 0, u);
    cell_family<with_everywhere>(lines, request, at_v, i, shape, 1, v);
    // Static condensation of the sag parameter (sag.inl).
    const Pack give = inverse_or_zero(u.sag_stiffness + v.sag_stiffness +
                                      request.stiffness * load(lines.multiplicity + at_u) *
                                          load(lines.sag_stiffness + at_u));
    const Triple q = load(lines.twist, at_u);
    Triple lost[4], moved[4];
    for (int k = 0; k < 4; ++k) {
      const Pack g = load(shape.twist[k] + i);
      lost[k] = give * (u.by_pull * u.pull[k] + v.by_pull * v.pull[k] +
                        (g * (u.by_twist + v.by_twist)) * q);
      moved[k] = u.sag * u.pull[k] + v.sag * v.pull[k];
    }
    const Pack twisted = u.k.tension * u.weight + v.k.tension * v.weight +
                         request.stiffness * (load(lines.twist_stiffness + at_u) +
                                              load(lines.twist_stiffness + at_v));
    // Drag of the twist's own motion: c and its derivative by U.
    Tensor everywhere = {};
    Pack damped = {};
    Triple damped_u = {};
    if (with_everywhere) {
      everywhere = u.drag.everywhere + v.drag.everywhere;
      const Pack amplitude = load(shape.amplitude + i);
      const Pack ninth = (1.0 / 9.0) * amplitude * amplitude;
      damped = request.damping * ninth * (load(lines.loose + at_u) + load(lines.loose + at_v));
      const Pack slope = load(lines.loose_slope + at_u) + load(lines.loose_slope + at_v);
      const Triple way = inverse_or_zero(load(lines.speed + at_u)) * load(lines.u, at_u);
      damped_u = (Pack{} - request.damping) * load(lines.own + at_u) * ninth * slope * way;
      if (lines.slope[0]) {
        damped_u.z += request.stiffness * ninth * slope * dot(way, load(lines.slope, at_u));
      }
    }
    for (int k = 0; k < 4; ++k) {
      const Pack a_k = load(shape.along[0][k] + i), b_k = load(shape.along[1][k] + i);
      const Pack g_k = load(shape.twist[k] + i), s_k = load(shape.share[k] + i);
      for (int l = 0; l < 4; ++l) {
        const Pack a_l = load(shape.along[0][l] + i), b_l = load(shape.along[1][l] + i);
        const Pack g_l = load(shape.twist[l] + i);
        Tensor sum = outer(u.pull[k], u.answer[l]) + outer(v.pull[k], v.answer[l]) -
                     outer(lost[k], moved[l]) - s_k * (a_l * u.drag.turn + b_l * v.drag.turn);
        Pack same = u.k.tension * a_k * a_l + v.k.tension * b_k * b_l + twisted * g_k * g_l;
        if (with_everywhere) {
          const Pack s_l = load(shape.share[l] + i);
          same = same + damped * g_k * g_l;
          sum = sum + s_k * s_l * everywhere +
                outer((g_k * s_l) * load(lines.twist_rate, at_u), damped_u);
        }
        store(block[4 * k + l], add_diagonal(same, sum));
      }
    }
    const int here = end - i < lanes ? static_cast<int>(end - i) : lanes;
    for (int l = 0; l < here; ++l) {
      const std::int64_t* slot = sink.slot + 16 * (i + l);
      for (int k = 0; k < 16; ++k) add_block(sink, slot[k], 1.0, block[k] + block_step * l);
    }
  }
}

void add_cell_blocks(const LineArrays& lines, const LineRequest& request, const CellArrays& cells,
                     std::int64_t begin, std::int64_t end, const BlockSink& sink) {
  if (request.damping != 0.0 || lines.slope[0])
    add_cells<true>(lines, request, cells, begin, end, sink);
  else
    add_cells<false>(lines, request, cells, begin, end, sink);
}

void slopes(const LineArrays& lines, const LineRequest& request, std::int64_t begin,
            std::int64_t end, double* out) {
  alignas(64) double block[3][block_step * lanes];
  for (std::int64_t i = begin; i < end; i += lanes) {
    const LineSlopes s = line_slopes<true>(lines, request, i, 1.0);
    store(block[0], s.pull);
    store(block[1], s.turn);
    store(block[2], s.everywhere);
    const int here = end - i < lanes ? static_cast<int>(end - i) : lanes;
    for (int l = 0; l < here; ++l) {
      for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 9; ++c) *out++ = block[k][block_step * l + c];
      }
    }
  }
}

#include "netting_screen.inl"
#include "sag.inl"

#undef INLINE

constexpr LineKernels kernels{flow,
                              evaluate,
                              change,
                              add_bar_blocks,
                              add_cell_forces,
                              add_cell_blocks,
                              slopes,
                              set_sag,
                              lead_sag,
                              change_sag,
                              add_sag_strains,
                              set_screen_flow,
                              set_screen_forces,
                              add_screen_blocks};
