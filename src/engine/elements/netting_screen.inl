// Screen and blended drag of netting cells (netting_screen.hpp, blended_netting.hpp).
// line_kernels.inl includes this file.
//
// Screen drag models: drag and lift of a plane piece of netting by the angle theta between its
// normal and the flow. Coefficients refer to 1/2 rho A |U|^2 with A the whole area. Sn is the
// solidity, the projected area of twine and knots over A.
//
//   loland: G. Loland, Current Forces on and Flow through Fish Farms, NTH Trondheim 1991.
//     C_D = 0.04 + (-0.04 + 0.33 Sn + 6.54 Sn^2 - 4.88 Sn^3) cos th.
//     C_L = (-0.05 Sn + 2.3 Sn^2 - 1.76 Sn^3) sin 2th.
//   aarsnes: J. V. Aarsnes, H. Rudi & G. Loland, Current forces on cage, net deflection, 1990.
//     C_D = 0.04 + (-0.04 + Sn - 1.24 Sn^2 + 13.7 Sn^3) cos th.
//     C_L = (0.57 Sn - 3.54 Sn^2 + 10.1 Sn^3) sin 2th.
//   kristiansen_faltinsen: T. Kristiansen & O. M. Faltinsen, J. Fluids Struct. 34, 2012.
//     C_c: drag of a circular cylinder at Re = U d / (nu (1 - Sn)), a polynomial in log10 Re.
//     C_D0 = C_c Sn (2 - Sn) / (2 (1 - Sn)^2),  C_D = C_D0 (0.9 cos th + 0.1 cos 3th).
//     C_N45 = C_c Sn / (2 (1 - Sn)^2),  C_T45 = pi C_N45 / (8 + C_N45).
//     C_L45 = (C_D0 / 2 - C_T45) / sqrt 2,  C_L = C_L45 (sin 2th + 0.1 sin 4th).
//
// Arguments are clamped to the range of the model (base/drag_models.hpp), because the formulas fail
// outside. The first two models give C_D >= 0.04 even without twine. Below their smallest solidity
// their coefficients are therefore proportional to Sn.

// A factor of a drag model and its derivatives by solidity and Reynolds number.
struct Factor {
  Pack value, by_solidity, by_reynolds;
};
INLINE Factor operator*(Factor x, Factor y) {
  return {x.value * y.value, x.by_solidity * y.value + x.value * y.by_solidity,
          x.by_reynolds * y.value + x.value * y.by_reynolds};
}
INLINE Factor operator+(Factor x, Factor y) {
  return {x.value + y.value, x.by_solidity + y.by_solidity, x.by_reynolds + y.by_reynolds};
}
INLINE Factor operator*(double k, Factor x) {
  return {k * x.value, k * x.by_solidity, k * x.by_reynolds};
}
INLINE Factor number(double value) { return {Pack{} + value, Pack{}, Pack{}}; }
INLINE Factor inverse(Factor x) {
  const Pack y = 1.0 / x.value, slope = -y * y;
  return {y, slope * x.by_solidity, slope * x.by_reynolds};
}
INLINE Factor choose(Mask first, Factor x, Factor y) {
  return {first ? x.value : y.value, first ? x.by_solidity : y.by_solidity,
          first ? x.by_reynolds : y.by_reynolds};
}
// Cubic polynomials without a constant in the solidity.
INLINE Factor cubic(Factor s, double a, double b, double c) {
  return s * (number(a) + s * (number(b) + c * s));
}

// C_D = base + drag (c + drag_cube c^3) and C_L / sin theta = lift (c + lift_cube c^3), c = cos
// theta.
struct ScreenLaw {
  Factor base, drag, lift;
  Pack drag_cube, lift_cube;
};

INLINE ScreenLaw kristiansen_faltinsen(const LawRange& range, Pack solidity, Pack reynolds) {
  const Pack one = Pack{} + 1.0;
  const Mask dense = solidity > range.most_solidity;
  const Factor s{dense ? Pack{} + range.most_solidity : solidity, dense ? Pack{} : one, Pack{}};
  const Factor open = inverse(number(1.0) + -1.0 * s);
  Factor re = Factor{reynolds, Pack{}, one} * open;
  re = choose(re.value < range.least_reynolds, number(range.least_reynolds), re);
  re = choose(re.value > range.most_reynolds, number(range.most_reynolds), re);
  // Drag coefficient of a circular cylinder as a polynomial in log10 Re.
  constexpr double c[] = {-78.46675, 254.73873, -327.8864, 223.64577,
                          -87.92234, 20.00769,  -2.44894,  0.12479};
  constexpr double to_decimal = 0.4342944819032518;
  const Pack x = to_decimal * logarithm(re.value);
  Pack sum = Pack{} + c[7], slope = {};
  for (int k = 6; k >= 0; --k) {
    slope = slope * x + sum;
    sum = sum * x + c[k];
  }
  const Pack by_re = slope * to_decimal / re.value;
  const Factor cylinder{sum, by_re * re.by_solidity, by_re * re.by_reynolds};
  const Factor normal45 = 0.5 * cylinder * s * open * open;
  const Factor drag0 = normal45 * (number(2.0) + -1.0 * s);
  const Factor tangential45 = pi * normal45 * inverse(number(8.0) + normal45);
  const Factor lift45 = 0.7071067811865476 * (0.5 * drag0 + -1.0 * tangential45);
  // cos 3th = 4 c^3 - 3 c, sin 2th/sin th = 2 c, sin 4th/sin th = 4 c (2 c^2 - 1)
  return {number(0.0), 0.6 * drag0, 1.6 * lift45, Pack{} + 0.4 / 0.6, Pack{} + 0.5};
}

// The drag models of Loland and of Aarsnes.
INLINE ScreenLaw polynomial_law(const LawRange& of_loland, const LawRange& of_aarsnes, Mask loland,
                                Pack solidity) {
  const Pack one = Pack{} + 1.0;
  const Pack least = loland ? of_loland.least_solidity * one : of_aarsnes.least_solidity * one;
  const Pack most = loland ? of_loland.most_solidity * one : of_aarsnes.most_solidity * one;
  const Mask sparse = solidity<least, dense = solidity> most;
  const Factor s{sparse ? least : dense ? most : solidity, sparse | dense ? Pack{} : one, Pack{}};
  // The coefficients are proportional to lower solidities.
  const Factor share{sparse ? solidity / least : one, sparse ? 1.0 / least : Pack{}, Pack{}};
  const Factor drag =
      number(-0.04) + choose(loland, cubic(s, 0.33, 6.54, -4.88), cubic(s, 1.0, -1.24, 13.7));
  const Factor lift = choose(loland, cubic(s, -0.05, 2.3, -1.76), cubic(s, 0.57, -3.54, 10.1));
  return {0.04 * share, share * drag, 2.0 * (share * lift), Pack{}, Pack{}};
}

INLINE ScreenLaw screen_law(const LawRange* range, Pack law, Pack solidity, Pack reynolds) {
  constexpr int loland = static_cast<int>(NettingScreenLaw::loland);
  constexpr int aarsnes = static_cast<int>(NettingScreenLaw::aarsnes);
  constexpr int kristiansen = static_cast<int>(NettingScreenLaw::kristiansen_faltinsen);
  const Mask by_reynolds = law == static_cast<double>(kristiansen);
  ScreenLaw out = {};
  if (any(by_reynolds)) out = kristiansen_faltinsen(range[kristiansen], solidity, reynolds);
  if (any(~by_reynolds)) {
    const ScreenLaw other =
        polynomial_law(range[loland], range[aarsnes], law == static_cast<double>(loland), solidity);
    out = {choose(by_reynolds, out.base, other.base), choose(by_reynolds, out.drag, other.drag),
           choose(by_reynolds, out.lift, other.lift), by_reynolds ? out.drag_cube : Pack{},
           by_reynolds ? out.lift_cube : Pack{}};
  }
  return out;
}

// Area vector S and flow U at cells.
struct CellFlow {
  Triple across[2], s, u;  // half diagonals 0 to 2 and 1 to 3
  Pack area, speed, inverse_area, inverse_speed, sign, cosine;
  Pack twine;  // twine area over the cell's area
  // Derivatives of the cosine.
  Triple cosine_by_area, cosine_by_velocity;
};

INLINE CellFlow cell_flow(const NettingStrip& cells, int i) {
  CellFlow f;
  for (int d = 0; d < 2; ++d) {
    f.across[d] = {load(cells.across[d][0] + i), load(cells.across[d][1] + i),
                   load(cells.across[d][2] + i)};
  }
  f.s = (Pack{} + 2.0) * cross(f.across[0], f.across[1]);
  f.u = {load(cells.u[0] + i), load(cells.u[1] + i), load(cells.u[2] + i)};
  f.area = root(dot(f.s, f.s));
  f.speed = root(dot(f.u, f.u));
  f.inverse_area = inverse_or_zero(f.area);
  f.inverse_speed = inverse_or_zero(f.speed);
  const Pack one = Pack{} + 1.0, along = dot(f.s, f.u);
  f.sign = along < 0.0 ? -one : one;
  const Pack cosine = size(along) * f.inverse_area * f.inverse_speed;
  f.cosine = cosine > 1.0 ? one : cosine;
  const Pack both = f.sign * f.inverse_area * f.inverse_speed;
  f.cosine_by_area = both * f.u - (f.cosine * f.inverse_area * f.inverse_area) * f.s;
  f.cosine_by_velocity = both * f.s - (f.cosine * f.inverse_speed * f.inverse_speed) * f.u;
  f.twine = load(cells.twine_area + i) * f.inverse_area / load(cells.multiplicity + i);
  return f;
}

// Force (N) on whole cells, with its derivatives by S and U.
struct CellForce {
  Triple value;
  Tensor by_area, by_velocity;
};

template <bool with_slopes, bool by_velocity>
INLINE CellForce screen_force(const NettingStrip& cells, int i, const CellFlow& f) {
  // Solidity (base/solidity.hpp).
  const Pack overlap = load(cells.overlap + i);
  const Mask closed = 2.0 * overlap * f.twine > 1.0;
  const Pack solidity = closed ? 0.25 / overlap : f.twine * (1.0 - overlap * f.twine);
  const Pack by_closing = closed ? Pack{} : f.twine * (1.0 - 2.0 * overlap * f.twine);
  const Pack re_per_speed = load(cells.diameter + i) * (1.0 / cells.viscosity);
  const ScreenLaw law =
      screen_law(cells.range, load(cells.law + i), solidity, re_per_speed * f.speed);
  const Pack square = f.cosine * f.cosine;
  const Pack drag_of = f.cosine * (1.0 + law.drag_cube * square);
  const Pack lift_of = f.cosine * (1.0 + law.lift_cube * square);
  const double drags = cells.drag_multiplier, lifts = cells.lift_multiplier;
  const Pack drag = drags * (law.base.value + law.drag.value * drag_of);
  // F = c (P A |U| U + G |U|^2 sign S) with G = C_L / sin th, P = C_D - G cos th.
  const Pack g = lifts * law.lift.value * lift_of, p = drag - g * f.cosine;
  const Pack c = 0.5 * cells.density * load(cells.multiplicity + i);
  const Pack c_speed = c * f.speed, normal = c_speed * f.speed * f.sign;
  CellForce out;
  out.value = (c_speed * p * f.area) * f.u + (normal * g) * f.s;
  if (!with_slopes) return out;
  const Triple n = f.inverse_area * f.s, way = f.inverse_speed * f.u;
  const Pack drag_by_cosine = drags * law.drag.value * (1.0 + 3.0 * law.drag_cube * square);
  const Pack g_by_cosine = lifts * law.lift.value * (1.0 + 3.0 * law.lift_cube * square);
  const Pack closing = by_closing * f.inverse_area;
  const Pack drag_by_area =
      drags * (law.base.by_solidity + law.drag.by_solidity * drag_of) * closing;
  const Triple g_by_area =
      g_by_cosine * f.cosine_by_area - (lifts * law.lift.by_solidity * lift_of * closing) * n;
  const Triple p_by_area =
      (drag_by_cosine - g) * f.cosine_by_area - drag_by_area * n - f.cosine * g_by_area;
  out.by_area = add_diagonal(normal * g, outer(c_speed * f.u, f.area * p_by_area + p * n) +
                                             outer(normal * f.s, g_by_area));
  if (!by_velocity) return out;
  const Pack drag_by_speed =
      drags * (law.base.by_reynolds + law.drag.by_reynolds * drag_of) * re_per_speed;
  const Triple g_by_velocity = g_by_cosine * f.cosine_by_velocity +
                               (lifts * law.lift.by_reynolds * lift_of * re_per_speed) * way;
  const Triple p_by_velocity =
      (drag_by_cosine - g) * f.cosine_by_velocity + drag_by_speed * way - f.cosine * g_by_velocity;
  out.by_velocity =
      add_diagonal(c_speed * p * f.area,
                   outer((c * f.area) * f.u, f.speed * p_by_velocity + p * way) +
                       outer(f.s, normal * g_by_velocity + (2.0 * c_speed * g * f.sign) * way));
  return out;
}

// One family of twines of the cells as lines. Needs the strip's `twines`.
INLINE LineArrays twine_lines(NettingStrip& cells, int family) {
  NettingStrip::Twines& t = *cells.twines;
  LineArrays lines{};
  lines.inverse_rest = t.inverse_rest;
  lines.drag_weight = t.drag_weight;
  lines.normal = t.normal;
  lines.tangential = t.tangential;
  lines.skin = t.skin;
  lines.speed_law = t.by_speed ? t.speed_law : nullptr;
  lines.viscosity = cells.viscosity;
  lines.curved = t.curved;
  lines.speed = t.speed;
  lines.loose = t.loose;
  lines.loose_slope = t.loose_slope;
  lines.drag_scale = t.drag_scale;
  lines.inverse_span = t.inverse_span[family];
  lines.own = t.own;
  for (int c = 0; c < 3; ++c) {
    lines.u[c] = cells.u[c];
    lines.e[c] = t.e[family][c];
  }
  return lines;
}

// Adds the twines' drag to `out`, the force of cells as screens. Sets the derivatives `turn` by the
// bar vectors.
template <bool with_slopes, bool by_velocity>
INLINE void blend(const LineArrays* lines, int i, const CellFlow& f, CellForce& out, Tensor* turn) {
  // Cosines of 60 and 80 degrees.
  constexpr double first_cosine = 0.5, last_cosine = 0.17364817766693034;
  constexpr double screen_solidity = 0.05, open_solidity = 0.35, closed_solidity = 1.0;
  const Slope lies = rise(f.cosine, first_cosine, last_cosine);
  const Slope shields = rise(f.twine, 0.0, screen_solidity);
  const Slope closes = rise(f.twine, open_solidity, closed_solidity);
  const Pack screens = shields.value * (1.0 - closes.value);
  const Mask flows = (f.area > 0.0) & (f.speed > 0.0);
  const Pack w = flows ? lies.value * screens : Pack{}, rest = 1.0 - w;
  Triple sum = {};
  Tensor everywhere = {};
  for (int family = 0; family < 2; ++family) {
    const Triple e = load(lines[family].e, i);
    const Pack inverse_rest = load(lines[family].inverse_rest + i);
    const Pack inverse_span = inverse_length(root(dot(e, e)), inverse_rest);
    if (!with_slopes) {
      sum = sum + line_drag(lines[family], i, e, inverse_span, inverse_rest);
      continue;
    }
    store(lines[family].inverse_span + i, inverse_span);
    const DragSlopes slopes =
        drag_slopes<by_velocity>(lines[family], {1.0, 1.0, nullptr, nullptr, 0}, i, 1.0);
    sum = sum + slopes.drag;
    turn[family] = rest * slopes.turn;
    if (by_velocity) everywhere = everywhere + slopes.everywhere;
  }
  if (with_slopes) {
    const Pack by_solidity = shields.slope * (1.0 - closes.value) - shields.value * closes.slope;
    const Pack by_cosine = flows ? screens * lies.slope : Pack{};
    const Pack by_size = flows ? lies.value * by_solidity * f.twine * f.inverse_area : Pack{};
    const Triple change = out.value - sum;
    out.by_area = w * out.by_area +
                  outer(change, by_cosine * f.cosine_by_area - (by_size * f.inverse_area) * f.s);
    if (by_velocity) {
      out.by_velocity =
          w * out.by_velocity + outer(change, by_cosine * f.cosine_by_velocity) + rest * everywhere;
    }
  }
  out.value = rest * sum + w * out.value;
}

void set_screen_flow(NettingStrip& cells, const NettingCorners& corners) {
  for (int i = 0; i < cells.count; i += lanes) {
    for (int c = 0; c < 3; ++c) {
      Pack x[4], u = {};
      for (int k = 0; k < 4; ++k) {
        x[k] = load(corners.position[k][c] + i);
        u = u + load(cells.share[k] + i) * load(corners.flow[k][c] + i);
      }
      store(cells.u[c] + i, u);
      for (int d = 0; d < 2; ++d) store(cells.across[d][c] + i, 0.5 * (x[d + 2] - x[d]));
      for (int f = 0; f < 2 && cells.twines; ++f) {
        Pack e = {};
        for (int k = 1; k < 4; ++k) e = e + load(cells.twines->along[f][k] + i) * (x[k] - x[0]);
        store(cells.twines->e[f][c] + i, e);
      }
    }
  }
}

void set_screen_forces(NettingStrip& cells) {
  LineArrays lines[2];
  if (cells.twines) {
    for (int family = 0; family < 2; ++family) lines[family] = twine_lines(cells, family);
    flow(lines[0], 0, cells.count);
  }
  for (int i = 0; i < cells.count; i += lanes) {
    const CellFlow f = cell_flow(cells, i);
    CellForce force = screen_force<false, false>(cells, i, f);
    if (cells.twines) blend<false, false>(lines, i, f, force, nullptr);
    store(cells.force[0] + i, force.value.x);
    store(cells.force[1] + i, force.value.y);
    store(cells.force[2] + i, force.value.z);
  }
}

template <bool by_velocity>
void add_screens(NettingStrip& cells, double stiffness, double damping, std::int64_t first,
                 const BlockSink& sink) {
  alignas(64) double block[4][block_step * lanes];
  LineArrays lines[2];
  if (cells.twines) {
    for (int family = 0; family < 2; ++family) lines[family] = twine_lines(cells, family);
    flow(lines[0], 0, cells.count);
  }
  for (int i = 0; i < cells.count; i += lanes) {
    const CellFlow f = cell_flow(cells, i);
    CellForce force = screen_force<true, by_velocity>(cells, i, f);
    Tensor turn[2] = {};
    if (cells.twines) blend<true, by_velocity>(lines, i, f, force, turn);
    const Pack minus = Pack{} - stiffness;
    for (int l = 0; l < 4; ++l) {
      // dS = dx_l x (half diagonal), with the sign of the corner.
      const Triple side = (l == 0 || l == 3 ? -minus : minus) * f.across[(l + 1) % 2];
      Tensor by = {cross(side, force.by_area.x), cross(side, force.by_area.y),
                   cross(side, force.by_area.z)};
      if (cells.twines) {
        for (int family = 0; family < 2; ++family)
          by = by + (minus * load(cells.twines->along[family][l] + i)) * turn[family];
      }
      if (by_velocity) {
        by = by + (damping * load(cells.own[l] + i)) * force.by_velocity;
        const Triple slope = {load(cells.slope[l][0] + i), load(cells.slope[l][1] + i),
                              load(cells.slope[l][2] + i)};
        by.x.z += minus * dot(force.by_velocity.x, slope);
        by.y.z += minus * dot(force.by_velocity.y, slope);
        by.z.z += minus * dot(force.by_velocity.z, slope);
      }
      store(block[l], by);
    }
    const int here = cells.count - i < lanes ? cells.count - i : lanes;
    for (int lane = 0; lane < here; ++lane) {
      const std::int64_t* slot = sink.slot + 16 * (first + i + lane);
      for (int k = 0; k < 4; ++k) {
        const double share = cells.share[k][i + lane];
        for (int l = 0; l < 4; ++l)
          add_block(sink, slot[4 * k + l], share, block[l] + block_step * lane);
      }
    }
  }
}

void add_screen_blocks(NettingStrip& cells, double stiffness, double damping, bool by_velocity,
                       std::int64_t first, const BlockSink& sink) {
  if (by_velocity)
    add_screens<true>(cells, stiffness, damping, first, sink);
  else
    add_screens<false>(cells, stiffness, damping, first, sink);
}
