// Dual numbers a + b e with e^2 = 0. The part b is the exact derivative of the result by a change
// of the input. Source: forward differentiation (Griewank and Walther, Evaluating Derivatives,
// 2008, ch. 3). Comparisons use a: at a kink the derivative belongs to the computed side.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace codend {

struct Dual {
  double value = 0.0, change = 0.0;
  Dual() = default;
  Dual(double constant) : value(constant) {}
  Dual(double of, double by) : value(of), change(by) {}
};

inline Dual operator-(Dual a) { return {-a.value, -a.change}; }
inline Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.change + b.change}; }
inline Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.change - b.change}; }
inline Dual operator*(Dual a, Dual b) {
  return {a.value * b.value, a.change * b.value + a.value * b.change};
}
inline Dual operator/(Dual a, Dual b) {
  return {a.value / b.value, (a.change - a.value / b.value * b.change) / b.value};
}
inline Dual& operator+=(Dual& a, Dual b) { return a = a + b; }
inline Dual& operator-=(Dual& a, Dual b) { return a = a - b; }
inline bool operator<(Dual a, Dual b) { return a.value < b.value; }
inline bool operator>(Dual a, Dual b) { return a.value > b.value; }
inline Dual sqrt(Dual a) {
  const double root = std::sqrt(a.value);
  return {root, a.change == 0.0 ? 0.0 : a.change / (2 * root)};
}
inline Dual abs(Dual a) { return a.value < 0 ? -a : a; }
inline Dual exp(Dual a) { return {std::exp(a.value), std::exp(a.value) * a.change}; }
inline Dual log(Dual a) { return {std::log(a.value), a.change / a.value}; }
inline Dual acos(Dual a) {
  const double slope = a.value * a.value < 1 ? -1 / std::sqrt(1 - a.value * a.value) : 0.0;
  return {std::acos(a.value), slope * a.change};
}
inline Dual atan2(Dual y, Dual x) {
  const double square = x.value * x.value + y.value * y.value;
  return {std::atan2(y.value, x.value),
          square == 0.0 ? 0.0 : (x.value * y.change - y.value * x.change) / square};
}

inline double value_of(double a) { return a; }
inline double value_of(Dual a) { return a.value; }

// Three numbers of one type, such as a position.
template <class T>
struct Three {
  T x{}, y{}, z{};
  T& operator[](int k) { return k == 0 ? x : k == 1 ? y : z; }
};

template <class T>
Three<T> operator+(const Three<T>& a, const Three<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Three<T> operator-(const Three<T>& a, const Three<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T, class Factor>
Three<T> operator*(const Three<T>& a, const Factor& by) {
  return {a.x * by, a.y * by, a.z * by};
}
template <class T>
T dot(const Three<T>& a, const Three<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Three<T> cross(const Three<T>& a, const Three<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T triple_product(const Three<T>& a, const Three<T>& b, const Three<T>& c) {
  return dot(a, cross(b, c));
}
template <class T>
T length_of(const Three<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class T>
Three<T> three(const std::vector<T>& values, int k) {
  const T* at = values.data() + 3 * static_cast<std::size_t>(k);
  return {at[0], at[1], at[2]};
}

}  // namespace codend
