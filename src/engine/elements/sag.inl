// Sag (curvature) of the twines within a netting cell, described by one parameter s per cell.
//
// Bilinear interpolation of positions bends the twines of a cell in proportion to its twist q.
// Twines of u and of v bend in opposite directions (cell_shape.hpp, where b is the part of kappa
// due to sag). However, knots within a cell can move: the family with the higher tension
// straightens and bends the other family more. With s from -1 to 1
//
//   L_u^2 = |e_u|^2 + (kappa_u - b_u) |q|^2 + b_u (1 - s)^2 |q|^2
//   L_v^2 = |e_v|^2 + (kappa_v - b_v) |q|^2 + b_v (1 + s)^2 |q|^2
//
// and s minimises the energy. With k = T/L plus the additional stiffness against twist,
//   s = (k_u b_u - k_v b_v)/(k_u b_u + k_v b_v).
// If k b is equal in both families, s is 0. If one family is slack, the other is straight. The
// stiffness of sag is therefore 4 k_u k_v/(k_u + k_v) instead of k_u + k_v. At the minimum s does
// no work, so that forces are the forces at fixed s (static condensation; E. L. Wilson, Int. J.
// Numer. Methods Eng. 8 (1974) 198-203).
//
// Derivatives: let l = dL/ds, m the modulus of a line, A = m/L0 - T/L, and D = sum A l^2 + |q|^2
// sum k b the stiffness of s. If lengths change by dL and tensions differ from the constitutive law
// by strains r,
//   ds = -sum l (m r + A dL)/D,  dT = m (r + (dL + l ds)/L0).
// The cell's stiffness decreases by z_k z_l^T/D with z_k = sum A l G_k (netting_cell.hpp).
//
// line_kernels.inl includes this file.

constexpr int most_sag_steps = 60;

// The two families of cells. Index f = 0: u, 1: v.
struct Sag {
  Pack weight[2], sag_weight[2];  // kappa and b
  Pack straight[2];               // |e|^2 + (kappa - b) |q|^2
  Pack sag[2];                    // b |q|^2
  Pack inverse_rest, held;        // held: additional stiffness against twist, N/m
  Pack length[2], inverse_length[2], tension[2], modulus[2];
};

INLINE Pack side(int f, Pack s) { return f == 0 ? 1.0 - s : 1.0 + s; }

// Cells whose sides lie along the twines have no sag.
INLINE bool can_sag(const CellArrays& cells, std::int64_t cell, Sag& c) {
  for (int f = 0; f < 2; ++f) c.sag_weight[f] = load(cells.sag_weight[f] + cell);
  return any(c.sag_weight[0] + c.sag_weight[1] > 0.0);
}

// Reads cells with can_sag().
INLINE void read_cells(const LineArrays& lines, const CellArrays& cells, std::int64_t cell,
                       Sag& c) {
  const std::int64_t line[2] = {cells.first + cell, cells.first + cells.count + cell};
  const Triple q = load(lines.twist, line[0]);
  const Pack square = dot(q, q);
  c.inverse_rest = load(lines.inverse_rest + line[0]);
  c.held = load(lines.held_pull + line[0]);
  for (int f = 0; f < 2; ++f) {
    const Triple e = load(lines.e, line[f]);
    c.weight[f] = load(cells.twist_weight[f] + cell);
    c.sag[f] = c.sag_weight[f] * square;
    c.straight[f] = dot(e, e) + (c.weight[f] - c.sag_weight[f]) * square;
  }
}

INLINE void set_lengths(Pack s, Sag& c) {
  for (int f = 0; f < 2; ++f) {
    c.length[f] = root(c.straight[f] + c.sag[f] * side(f, s) * side(f, s));
    c.inverse_length[f] = inverse_length(c.length[f], c.inverse_rest);
  }
}

// Sets lengths, tensions and moduli at sag parameter s from the constitutive law.
INLINE void follow_law(const LineArrays& lines, const CellArrays& cells, std::int64_t cell, Pack s,
                       Sag& c) {
  set_lengths(s, c);
  for (int f = 0; f < 2; ++f) {
    const std::int64_t i = cells.first + f * cells.count + cell;
    const Pack strain = c.length[f] * c.inverse_rest - 1.0;
    const Law law = law_at(lines, i, strain);
    const Pack tension = law.offset + law.stiffness * strain;
    c.tension[f] = tension > 0.0 ? tension : Pack{};
    c.modulus[f] = tension > 0.0 ? law.stiffness : Pack{};
  }
}

// Returns the s at which the tensions by the constitutive law are in equilibrium. Newton's method
// within bounds finds the root of an increasing function. Lanes stop independently.
Pack balance_by_law(const LineArrays& lines, const CellArrays& cells, std::int64_t cell, Sag& c) {
  constexpr double last_change = 1e-14;
  Pack s = {}, low = s - 1.0, high = s + 1.0;
  Mask open = low < high;
  for (int k = 0;; ++k) {
    follow_law(lines, cells, cell, s, c);
    if (k == most_sag_steps || !any(open)) return s;
    Pack out = {}, slope = {};
    for (int f = 0; f < 2; ++f) {
      const Pack pull = c.tension[f] * c.inverse_length[f];
      const Pack by_s = c.sag[f] * side(f, s);
      out = out + (f == 0 ? -1.0 : 1.0) * (pull + c.held) * by_s;
      const Pack length_by_s = by_s * c.inverse_length[f];
      slope = slope + (pull + c.held) * c.sag[f] +
              (c.modulus[f] * c.inverse_rest - pull) * length_by_s * length_by_s;
    }
    const Pack change = slope > 0.0 ? out / slope : Pack{};
    high = out > 0.0 ? s : high;
    low = out > 0.0 ? low : s;
    const Pack newton = s - change;
    const Mask converged = size(change) <= last_change;
    const Pack next =
        converged | ((newton >= low) & (newton <= high)) ? newton : 0.5 * (low + high);
    s = open ? next : s;
    open = open & ~converged;
  }
}

INLINE void store_sag(const LineArrays& lines, const CellArrays& cells, std::int64_t cell,
                      const Sag& c, Pack s) {
  const std::int64_t left = cells.count - cell;
  Pack stiffness = {};
  for (int f = 0; f < 2; ++f) {
    const std::int64_t i = cells.first + f * cells.count + cell;
    const Pack weight = c.weight[f] + c.sag_weight[f] * (side(f, s) * side(f, s) - 1.0);
    store_before_end(lines.twist_weight + i, left, weight);
    store_before_end(lines.twist_stiffness + i, left,
                     load(lines.held_pull + i) * load(lines.multiplicity + i) * weight);
    store_before_end(lines.sag_derivative + i, left,
                     (f == 0 ? -1.0 : 1.0) * c.sag[f] * side(f, s) * c.inverse_length[f]);
    stiffness = stiffness + (c.tension[f] * c.inverse_length[f] + c.held) * c.sag[f];
  }
  store_before_end(lines.sag_stiffness + cells.first + cell, left, stiffness);
}

void set_sag(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
             std::int64_t end) {
  for (std::int64_t i = begin; i < end; i += lanes) {
    Sag c;
    if (!can_sag(cells, i, c)) continue;
    read_cells(lines, cells, i, c);
    const Pack s = balance_by_law(lines, cells, i, c);
    store_sag(lines, cells, i, c, s);
  }
}

void lead_sag(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
              std::int64_t end, const double* tension, double* sag) {
  constexpr double last_change = 1e-15;
  for (std::int64_t i = begin; i < end; i += lanes) {
    Sag c;
    if (!can_sag(cells, i, c)) continue;
    read_cells(lines, cells, i, c);
    const std::int64_t left = cells.count - i;
    for (int f = 0; f < 2; ++f) {
      const Pack given = load_before_end(tension + cells.first + f * cells.count + i, left);
      c.tension[f] = given > 0.0 ? given : Pack{};
    }
    // Fixed-point iteration: lengths depend only weakly on s.
    Pack s = load_before_end(sag + i, left);
    Mask open = s == s;
    for (int k = 0; k < most_sag_steps && any(open); ++k) {
      set_lengths(s, c);
      const Pack u = (c.tension[0] * c.inverse_length[0] + c.held) * c.sag[0];
      const Pack v = (c.tension[1] * c.inverse_length[1] + c.held) * c.sag[1];
      const Pack balance = u + v > 0.0 ? (u - v) / (u + v) : Pack{};
      const Mask changes = size(balance - s) > last_change;
      s = open ? balance : s;
      open = open & changes;
    }
    set_lengths(s, c);
    store_sag(lines, cells, i, c, s);
    store_before_end(sag + i, left, s);
    for (int f = 0; f < 2; ++f) {
      const std::int64_t line = cells.first + f * cells.count + i;
      store_before_end(lines.inverse_length + line, left, c.inverse_length[f]);
      store_before_end(lines.strain + line, left, c.length[f] * c.inverse_rest - 1.0);
    }
  }
}

void change_sag(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                std::int64_t end, double* strain) {
  for (std::int64_t i = begin; i < end; i += lanes) {
    Sag c;
    if (!can_sag(cells, i, c)) continue;
    read_cells(lines, cells, i, c);
    const std::int64_t left = cells.count - i;
    Pack unbowed[2], change[2];  // strains + 1 after the change, at the previous s
    for (int f = 0; f < 2; ++f) {
      const std::int64_t line = cells.first + f * cells.count + i;
      const Pack now = 1.0 + load(lines.strain + line);
      change[f] = load_before_end(strain + line, left);
      const Pack then = now + change[f];
      unbowed[f] = then > 0.0 ? then : Pack{};
      const Pack straight =
          c.straight[f] + (unbowed[f] * unbowed[f] - now * now) / (c.inverse_rest * c.inverse_rest);
      c.straight[f] = straight > 0.0 ? straight : Pack{};
    }
    balance_by_law(lines, cells, i, c);
    for (int f = 0; f < 2; ++f) {
      store_before_end(strain + cells.first + f * cells.count + i, left,
                       change[f] + c.length[f] * c.inverse_rest - unbowed[f]);
    }
  }
}

void add_sag_strains(const LineArrays& lines, const CellArrays& cells, std::int64_t begin,
                     std::int64_t end, const SagRequest& request, double* strain) {
  for (std::int64_t i = begin; i < end; i += lanes) {
    const std::int64_t left = cells.count - i;
    Pack driven = {}, stiffness = load(lines.sag_stiffness + cells.first + i), by_s[2];
    for (int f = 0; f < 2; ++f) {
      const std::int64_t line = cells.first + f * cells.count + i;
      const Pack tension = load_before_end(request.tension + line, left);
      const Pack modulus = load_before_end(request.modulus + line, left);
      const Pack inverse_rest = load(lines.inverse_rest + line);
      const Pack slope = load(lines.sag_derivative + line);
      by_s[f] = slope * inverse_rest;
      const Pack own = modulus * inverse_rest -
                       (tension > 0.0 ? tension : Pack{}) * load(lines.inverse_length + line);
      stiffness = stiffness + own * slope * slope;
      if (request.mismatch)
        driven = driven + slope * modulus * load_before_end(request.mismatch + line, left);
      if (request.change) {
        driven = driven + slope * own * load_before_end(request.change + line, left) / inverse_rest;
      }
    }
    const Pack change = stiffness > 0.0 ? driven / stiffness : Pack{};
    for (int f = 0; f < 2; ++f) {
      double* const line = strain + cells.first + f * cells.count + i;
      store_before_end(line, left, load_before_end(line, left) - by_s[f] * change);
    }
  }
}
