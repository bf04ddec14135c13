// Drag models of cylinders (cylinder_drag_model.hpp). line_kernels.inl includes this file.

using Bits = std::uint64_t __attribute__((vector_size(8 * lanes)));
constexpr double reciprocal[] = {0.0,        1.0,        1.0 / 2.0,  1.0 / 3.0,  1.0 / 4.0,
                                 1.0 / 5.0,  1.0 / 6.0,  1.0 / 7.0,  1.0 / 8.0,  1.0 / 9.0,
                                 1.0 / 10.0, 1.0 / 11.0, 1.0 / 12.0, 1.0 / 13.0, 1.0 / 14.0,
                                 1.0 / 15.0, 1.0 / 16.0, 1.0 / 17.0, 1.0 / 18.0, 1.0 / 19.0};
constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;

// Natural logarithm of normal numbers above 0, to the last bits.
INLINE Pack logarithm(Pack x) {
  // x = m 2^k with m from sqrt(1/2) to sqrt(2), and log m = 2 artanh((m - 1)/(m + 1)).
  constexpr std::uint64_t bias = 1024, root_of_half = 0x3fe6a09e667f3bcdu;
  const Bits k = (((Bits)x - root_of_half) + (bias << 52)) >> 52;
  const Pack exponent = (Pack)(k | 0x4330000000000000u) - (0x1p52 + bias);
  const Pack m = (Pack)((Bits)x - ((k - bias) << 52));
  const Pack f = (m - 1.0) / (m + 1.0), square = f * f;
  Pack sum = Pack{} + reciprocal[19];
  for (int n = 17; n > 0; n -= 2) sum = sum * square + reciprocal[n];
  return exponent * ln2_high + (exponent * ln2_low + 2.0 * f * sum);
}

// e^x for x < 700; below -700 e^-700.
INLINE Pack exponential(Pack x) {
  x = x < -700.0 ? Pack{} - 700.0 : x;
  constexpr double one_and_half = 0x1.8p52;
  const Pack shifted = x * 1.4426950408889634 + one_and_half, n = shifted - one_and_half;
  const Pack r = (x - n * ln2_high) - n * ln2_low;
  Pack sum = Pack{} + 1.0;
  for (int k = 13; k > 0; --k) sum = sum * (r * reciprocal[k]) + 1.0;
  return (Pack)((Bits)sum + ((Bits)shifted << 52));
}

// A value and its derivative by q_n.
struct Slope {
  Pack value, slope;
};
INLINE Slope constant(double value) { return {Pack{} + value, Pack{}}; }
INLINE Slope operator+(Slope x, Slope y) { return {x.value + y.value, x.slope + y.slope}; }
INLINE Slope operator*(double k, Slope x) { return {k * x.value, k * x.slope}; }
INLINE Slope operator*(Slope x, Slope y) {
  return {x.value * y.value, x.slope * y.value + x.value * y.slope};
}
INLINE Slope inverse(Slope x) { return {1.0 / x.value, -x.slope / (x.value * x.value)}; }
INLINE Slope exponential(Slope x) {
  const Pack e = exponential(x.value);
  return {e, e * x.slope};
}

// Rises from 0 at `first` to 1 at `last` as a cubic.
INLINE Slope rise(Pack x, double first, double last) {
  const Pack s = (x - first) / (last - first);
  const Pack bounded = s < 0.0 ? Pack{} : s > 1.0 ? Pack{} + 1.0 : s;
  return {bounded * bounded * (3.0 - 2.0 * bounded),
          6.0 * bounded * (1.0 - bounded) / (last - first)};
}

// Blends two branches of a published drag model within +-10 % of their switch, where their values
// differ. A jump in force would prevent an equilibrium near the switch. log_re: of the Reynolds
// number; log_at: of its value at the switch.
INLINE Slope join(Slope log_re, double log_at, Slope below, Slope above) {
  constexpr double half = 0.1;
  const Pack after = log_re.value - log_at;
  const Slope risen = rise(after, -half, half), w = {risen.value, risen.slope * log_re.slope};
  const Slope blend = (constant(1.0) + -1.0 * w) * below + w * above;
  return {after > -half ? after < half ? blend.value : above.value : below.value,
          after > -half ? after < half ? blend.slope : above.slope : below.slope};
}

INLINE Slope choo_casarella_normal(Slope re, Slope log_re) {
  // Reynolds numbers beyond which the next branch has no effect below, and the previous none above.
  constexpr double under = 0.9, over = 1.11;
  const Pack x = re.value;
  Slope out = constant(0.0);
  if (any(x < over)) {
    const Slope s = constant(2.0022258766798355) + -1.0 * log_re;  // log 8 - 0.077215665
    const Slope t = inverse(s);
    out = 8.0 * pi * inverse(s * re) * (constant(1.0) + -0.87 * (t * t));
  }
  if (any((x > under) & (x < 30.0 * over)))
    out = join(log_re, 0.0, out, constant(1.45) + 8.55 * exponential(-0.9 * log_re));
  if (any((x > 30.0 * under) & (x < 2.33e5 * over))) {
    const Pack power = 1.0 / root(x);
    const Slope middle{1.1 + 4.0 * power, -2.0 * power / x * re.slope};
    out = join(log_re, 3.4011973816621555, out, middle);
  }
  if (any(x > 2.33e5 * under)) {
    const Slope drop = -3.41e-6 * (re + constant(-5.78e5));
    const Slope high = 0.401 * (constant(1.0) + -1.0 * exponential((-1.0 / 5.99e5) * re));
    out = join(log_re, 12.358793732547838, out, drop);
    out = join(log_re, 13.106233995474446, out, high);
  }
  return out;
}

// Replaces a, b and their derivatives in lanes whose drag model depends on speed.
void use_speed_laws(const TwineMaterial* const* laws, double viscosity, Pack q_n, Pack q_t,
                    Coefficients& k) {
  bool none = true;
  for (int l = 0; l < lanes; ++l) none = none && !laws[l];
  if (none) return;
  double kinds[lanes], scales[lanes], squares[lanes], normals[lanes], tangentials[lanes];
  for (int l = 0; l < lanes; ++l) {
    kinds[l] = scales[l] = squares[l] = normals[l] = tangentials[l] = 1.0;
    if (!laws[l]) {
      kinds[l] = -1.0;
      continue;
    }
    const CylinderLaw& law = laws[l]->law;
    kinds[l] = static_cast<double>(law.kind);
    scales[l] = laws[l]->diameter / viscosity;
    squares[l] = law.solidity * law.solidity;
    normals[l] = law.normal_share;
    tangentials[l] = law.tangential_share;
  }
  const Pack kind = load(kinds), scale = load(scales), along = load(tangentials);
  const Pack across = load(normals);
  auto use = [&](Mask these, Slope normal, Slope b, Pack b_t) {
    k.a = these ? across * normal.value * q_n : k.a;
    k.a_n = these ? across * (normal.value + normal.slope * q_n) : k.a_n;
    k.b = these ? along * b.value : k.b;
    k.b_n = these ? along * b.slope : k.b_n;
    k.b_t = these ? along * b_t : k.b_t;
  };
  const Mask takagi = kind == static_cast<double>(CylinderLawKind::takagi);
  const Mask choo_casarella = kind == static_cast<double>(CylinderLawKind::choo_casarella);
  const Mask cifuentes_kim = kind == static_cast<double>(CylinderLawKind::cifuentes_kim);
  if (any(takagi | choo_casarella)) {
    // Reynolds number, smoothly bounded below at 0.01, because powers are not differentiable at
    // zero.
    constexpr double floor = 0.01;
    const Pack given = scale * q_n;
    const Pack bounded = root(given * given + floor * floor);
    const Slope re{bounded, given / bounded * scale};
    const Slope log_re{logarithm(bounded), re.slope / bounded};
    if (any(takagi)) {
      // The branches cross at Re = 117; the printed switch at Re = 200 would jump by 15 %.
      const Slope low = 5.011872336272722 * exponential(-0.3 * log_re);  // 10^0.7
      const Mask is_low = low.value > 1.2;
      const Slope normal{is_low ? low.value : Pack{} + 1.2, is_low ? low.slope : Pack{}};
      use(takagi, normal, {0.1 * q_t, Pack{}}, Pack{} + 0.1);
    }
    if (any(choo_casarella)) {
      // The source prints a force per length, pi mu U_t (0.55 Re^1/2 + 0.084 Re^2/3).
      const Pack half_power = root(bounded);
      const Slope b = Slope{0.55 * half_power, 0.275 / half_power * re.slope} +
                      0.084 * exponential((2.0 / 3.0) * log_re);
      use(choo_casarella, choo_casarella_normal(re, log_re), Slope{2.0 * pi / scale, Pack{}} * b,
          Pack{});
    }
  }
  if (any(cifuentes_kim)) {
    // The parabola becomes negative at Re Sn^2 = 219; it is constant above 100.
    const Pack rate = scale * load(squares), given = rate * q_n;
    const Mask held = given > 100.0;
    const Slope x{held ? Pack{} + 100.0 : given, held ? Pack{} : rate};
    use(cifuentes_kim, constant(1.4253) + 0.00068 * x + -3.2891e-5 * (x * x), constant(0.0),
        Pack{});
  }
}
