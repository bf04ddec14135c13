// Definitions of the front kernels. Each front_kernels*.cpp includes this file once for double and
// once for float, inside an unnamed namespace. The namespace defines `Real`, `lanes` (numbers per
// register) and `across` (nodes per tile: 1, or 2 with 32 registers).
//
// This file must not use std:: or templates of other headers. The linker could otherwise use an
// AVX2 instance on a processor without AVX2.

using Pack = Real __attribute__((vector_size(sizeof(Real) * lanes)));
// Unaligned access. A `using` declaration would be aligned in clang.
typedef Real LoosePack
    __attribute__((vector_size(sizeof(Real) * lanes), aligned(alignof(Real)), may_alias));

// A tile of 3 registers by the 3 columns of one or two nodes keeps 9 or 18 sums in registers.
constexpr int tile_rows = 3 * lanes;
// Columns of L per block: a strip of tile_rows x depth fits into the first-level cache.
constexpr int depth = 96;
// Target columns per block: their rows of U fit into the second-level cache.
constexpr int breadth = 192;

inline Pack load(const Real* p) { return *reinterpret_cast<const LoosePack*>(p); }
inline void store(Real* p, Pack x) { *reinterpret_cast<LoosePack*>(p) = x; }

// A matrix with elements (i, j) = data[i * row + j * column], so that transposition costs nothing.
struct View {
  const Real* data;
  int64_t row;
  int64_t column;
  const Real* at(int64_t i, int64_t j) const { return data + i * row + j * column; }
};

// One register of rows in each of the 3 columns of a tile.
struct Row {
  Pack x0, x1, x2;

  void clear() { x0 = x1 = x2 = Pack{}; }
  void load_from(const Real* c, int64_t step) {
    x0 = load(c);
    x1 = load(c + step);
    x2 = load(c + 2 * step);
  }
  void store_to(Real* c, int64_t step) const {
    store(c, x0);
    store(c + step, x1);
    store(c + 2 * step, x2);
  }
  void subtract(Pack a, Real b0, Real b1, Real b2) {
    x0 -= a * b0;
    x1 -= a * b1;
    x2 -= a * b2;
  }
};

// Computes c -= a * b over `count` columns of a, or c = -a * b if `fresh`. c has registers x lanes
// rows and 3 columns per node. `beside` is b of a second node, if any. Unrolled by hand, so that
// the sums stay in registers at -O2, which does not unroll loops.
template <int registers, int nodes, bool fresh>
inline void update_tile(int count, const Real* a, int64_t a_step, const View& b, const View& beside,
                        Real* c, int64_t c_step) {
  Row first, second, third, other_first, other_second, other_third;
  Real* const other = c + 3 * c_step;
  if constexpr (fresh) {
    first.clear();
    second.clear();
    third.clear();
    other_first.clear();
    other_second.clear();
    other_third.clear();
  } else {
    first.load_from(c, c_step);
    if constexpr (registers > 1) second.load_from(c + lanes, c_step);
    if constexpr (registers > 2) third.load_from(c + 2 * lanes, c_step);
    if constexpr (nodes > 1) {
      other_first.load_from(other, c_step);
      if constexpr (registers > 1) other_second.load_from(other + lanes, c_step);
      if constexpr (registers > 2) other_third.load_from(other + 2 * lanes, c_step);
    }
  }
  const Real *b0 = b.data, *b1 = b0 + b.column, *b2 = b1 + b.column;
  const Real *d0 = beside.data, *d1 = d0 + beside.column, *d2 = d1 + beside.column;
  for (int p = 0; p < count; ++p) {
    first.subtract(load(a), *b0, *b1, *b2);
    if constexpr (registers > 1) second.subtract(load(a + lanes), *b0, *b1, *b2);
    if constexpr (registers > 2) third.subtract(load(a + 2 * lanes), *b0, *b1, *b2);
    if constexpr (nodes > 1) {
      other_first.subtract(load(a), *d0, *d1, *d2);
      if constexpr (registers > 1) other_second.subtract(load(a + lanes), *d0, *d1, *d2);
      if constexpr (registers > 2) other_third.subtract(load(a + 2 * lanes), *d0, *d1, *d2);
      d0 += beside.row;
      d1 += beside.row;
      d2 += beside.row;
    }
    a += a_step;
    b0 += b.row;
    b1 += b.row;
    b2 += b.row;
  }
  first.store_to(c, c_step);
  if constexpr (registers > 1) second.store_to(c + lanes, c_step);
  if constexpr (registers > 2) third.store_to(c + 2 * lanes, c_step);
  if constexpr (nodes > 1) {
    other_first.store_to(other, c_step);
    if constexpr (registers > 1) other_second.store_to(other + lanes, c_step);
    if constexpr (registers > 2) other_third.store_to(other + 2 * lanes, c_step);
  }
}

// Version for `rows` <= tile_rows, a multiple of lanes.
template <int nodes, bool fresh = false>
inline void update_tile(int rows, int count, const Real* a, int64_t a_step, const View& b,
                        const View& beside, Real* c, int64_t c_step) {
  if (rows == tile_rows)
    update_tile<3, nodes, fresh>(count, a, a_step, b, beside, c, c_step);
  else if (rows == 2 * lanes)
    update_tile<2, nodes, fresh>(count, a, a_step, b, beside, c, c_step);
  else
    update_tile<1, nodes, fresh>(count, a, a_step, b, beside, c, c_step);
}

// Copy of padded<Real>() for these kernels only.
inline int padded_rows(int boundary) {
  constexpr int unit = 64 / sizeof(Real);
  return (boundary + unit - 1) / unit * unit;
}

inline int round_up(int rows) { return (rows + lanes - 1) / lanes * lanes; }

// Copies count x columns of b, with the 3 columns of a tile adjacent, row by row.
inline void pack_triples(const View& b, int count, int columns, Real* packed) {
  for (int j = 0; j < columns; j += 3)
    for (int p = 0; p < count; ++p, packed += 3) {
      packed[0] = *b.at(p, j);
      packed[1] = *b.at(p, j + 1);
      packed[2] = *b.at(p, j + 2);
    }
}

// Copies `rows` <= tile_rows rows of a into columns of tile_rows, padded with zeros to full
// registers. The loops over single rows avoid calls of memcpy, which would take longer than the
// copy.
inline void pack_strip(const Real* a, int64_t a_step, int rows, int columns, Real* strip) {
  if (rows == tile_rows) {
    for (int p = 0; p < columns; ++p, a += a_step, strip += tile_rows) {
      store(strip, load(a));
      store(strip + lanes, load(a + lanes));
      store(strip + 2 * lanes, load(a + 2 * lanes));
    }
    return;
  }
  for (int p = 0; p < columns; ++p, a += a_step, strip += tile_rows) {
    int i = 0;
    for (; i + lanes <= rows; i += lanes) store(strip + i, load(a + i));
    for (int l = 0; i < rows && l < lanes; ++l) strip[i + l] = i + l < rows ? a[i + l] : 0;
  }
}

inline void unpack_strip(const Real* strip, int rows, int columns, Real* a, int64_t a_step) {
  if (rows == tile_rows) {
    for (int p = 0; p < columns; ++p, a += a_step, strip += tile_rows) {
      store(a, load(strip));
      store(a + lanes, load(strip + lanes));
      store(a + 2 * lanes, load(strip + 2 * lanes));
    }
    return;
  }
  for (int p = 0; p < columns; ++p, a += a_step, strip += tile_rows) {
    int i = 0;
    for (; i + lanes <= rows; i += lanes) store(a + i, load(strip + i));
    for (int l = 0; i < rows && l < lanes; ++l)
      if (i + l < rows) a[i + l] = strip[i + l];
  }
}

// Computes c (rows x columns) -= a (rows x count) * b (count x columns). If `fresh`, c = -a * b,
// and rows must be a multiple of lanes. columns is a multiple of 3.
template <bool fresh = false>
void subtract_product(int rows, int columns, int count, const Real* a, int64_t a_step, View b,
                      Real* c, int64_t c_step) {
  alignas(64) Real strip[tile_rows * depth];
  alignas(64) Real corner[tile_rows * 3];
  alignas(64) Real triples[depth * breadth];
  // Rows of b on separate pages miss the caches, most of all at a power of two. The copy is
  // worthwhile if several strips read it.
  const bool packed = b.row >= 1024 && rows >= 12 * tile_rows;
  for (int p = 0; p < count; p += depth) {
    const int deep = count - p < depth ? count - p : depth;
    for (int j0 = 0; j0 < columns; j0 += breadth) {
      const int j1 = columns - j0 < breadth ? columns : j0 + breadth;
      if (packed) pack_triples({b.at(p, j0), b.row, b.column}, deep, j1 - j0, triples);
      for (int i = 0; i < rows; i += tile_rows) {
        const int high = rows - i < tile_rows ? rows - i : tile_rows, padded = round_up(high);
        const Real* left = a + i + p * a_step;
        int64_t left_step = a_step;
        if (high < padded || j1 - j0 > 12) {
          pack_strip(left, left_step, high, deep, strip);
          left = strip;
          left_step = tile_rows;
        }
        const auto right = [&](int j) {
          return packed ? View{triples + (j - j0) * deep, 3, 1} : View{b.at(p, j), b.row, b.column};
        };
        int j = j0;
        if (across > 1 && high == padded)
          for (; j + 6 <= j1; j += 6) {
            Real* target = c + i + j * c_step;
            const View b0 = right(j), b1 = right(j + 3);
            if (fresh && p == 0)
              update_tile<across, true>(high, deep, left, left_step, b0, b1, target, c_step);
            else
              update_tile<across>(high, deep, left, left_step, b0, b1, target, c_step);
          }
        for (; j < j1; j += 3) {
          Real* target = c + i + j * c_step;
          const View b0 = right(j);
          if (fresh && p == 0) {
            update_tile<1, true>(high, deep, left, left_step, b0, b0, target, c_step);
          } else if (high == padded) {
            update_tile<1>(high, deep, left, left_step, b0, b0, target, c_step);
          } else {
            pack_strip(target, c_step, high, 3, corner);
            update_tile<1>(padded, deep, left, left_step, b0, b0, corner, tile_rows);
            unpack_strip(corner, high, 3, target, c_step);
          }
        }
      }
    }
  }
}

// Minimum multiplications for a second thread.
constexpr double worth_sharing = 1e6;

// Divides the columns of a product into two halves.
template <bool fresh>
struct SharedProduct {
  int rows, columns, count;
  const Real* a;
  int64_t a_step;
  View b;
  Real* c;
  int64_t c_step;

  static void part(void* self, int half) {
    const SharedProduct& product = *static_cast<const SharedProduct*>(self);
    const int middle = product.columns / 6 * 3;
    const int first = half == 0 ? 0 : middle, last = half == 0 ? middle : product.columns;
    subtract_product<fresh>(product.rows, last - first, product.count, product.a, product.a_step,
                            {product.b.at(0, first), product.b.row, product.b.column},
                            product.c + first * product.c_step, product.c_step);
  }
};

// subtract_product() with two threads, if available and worthwhile. The result is identical,
// because columns are independent of each other.
template <bool fresh = false>
void subtract_product(const Sharing* sharing, int rows, int columns, int count, const Real* a,
                      int64_t a_step, View b, Real* c, int64_t c_step) {
  if (sharing && 1.0 * rows * columns * count > worth_sharing) {
    SharedProduct<fresh> product{rows, columns, count, a, a_step, b, c, c_step};
    sharing->run(sharing->threads, &SharedProduct<fresh>::part, &product);
  } else {
    subtract_product<fresh>(rows, columns, count, a, a_step, b, c, c_step);
  }
}

// Computes x = x * inverse(u) for one strip of `rows` <= tile_rows, a multiple of lanes.
// `reciprocal` are the reciprocals of u's diagonal, null for a unit diagonal.
inline void solve_strip(int rows, int columns, Real* x, View u, const Real* reciprocal) {
  for (int j = 0; j < columns; j += 3) {
    Real* target = x + j * tile_rows;
    const View before{u.at(0, j), u.row, u.column};
    update_tile<1>(rows, j, x, tile_rows, before, before, target, tile_rows);
    const Real u01 = *u.at(j, j + 1), u02 = *u.at(j, j + 2), u12 = *u.at(j + 1, j + 2);
    const Real r0 = reciprocal ? reciprocal[j] : 1;
    const Real r1 = reciprocal ? reciprocal[j + 1] : 1;
    const Real r2 = reciprocal ? reciprocal[j + 2] : 1;
    for (int i = 0; i < rows; i += lanes) {
      const Pack x0 = load(target + i) * r0;
      const Pack x1 = (load(target + i + tile_rows) - x0 * u01) * r1;
      store(target + i, x0);
      store(target + i + tile_rows, x1);
      store(target + i + 2 * tile_rows,
            (load(target + i + 2 * tile_rows) - x0 * u02 - x1 * u12) * r2);
    }
  }
}

// Computes x (rows x columns) = x * inverse(u), u upper triangular. reciprocal: see solve_strip().
void solve_right(int rows, int columns, Real* x, int64_t x_step, View u, const Real* reciprocal) {
  alignas(64) Real strip[tile_rows * depth];
  for (int j = 0; j < columns; j += depth) {
    const int wide = columns - j < depth ? columns - j : depth;
    Real* block = x + j * x_step;
    if (j > 0)
      subtract_product(rows, wide, j, x, x_step, {u.at(0, j), u.row, u.column}, block, x_step);
    const View corner{u.at(j, j), u.row, u.column};
    for (int i = 0; i < rows; i += tile_rows) {
      const int high = rows - i < tile_rows ? rows - i : tile_rows;
      pack_strip(block + i, x_step, high, wide, strip);
      solve_strip(round_up(high), wide, strip, corner, reciprocal ? reciprocal + j : nullptr);
      unpack_strip(strip, high, wide, block + i, x_step);
    }
  }
}

// Computes b (size x columns) = inverse(l) * b, l unit lower triangular. columns is a multiple of
// 3.
void solve_left(int size, int columns, const Real* l, int64_t l_step, Real* b, int64_t b_step) {
  if (size > 12) {
    const int half = size / 6 * 3;
    solve_left(half, columns, l, l_step, b, b_step);
    subtract_product(size - half, columns, half, l + half, l_step, {b, 1, b_step}, b + half,
                     b_step);
    solve_left(size - half, columns, l + half + half * l_step, l_step, b + half, b_step);
    return;
  }
  for (int j = 0; j < columns; j += 3, b += 3 * b_step)
    for (int p = 0; p < size; ++p) {
      const Real b0 = b[p], b1 = b[p + b_step], b2 = b[p + 2 * b_step];
      for (int i = p + 1; i < size; ++i) {
        const Real factor = l[i + p * l_step];
        b[i] -= factor * b0;
        b[i + b_step] -= factor * b1;
        b[i + 2 * b_step] -= factor * b2;
      }
    }
}

// Divides the columns of solve_left() into two halves.
struct SharedSolve {
  int size, columns;
  const Real* l;
  int64_t l_step;
  Real* b;
  int64_t b_step;

  static void part(void* self, int half) {
    const SharedSolve& s = *static_cast<const SharedSolve*>(self);
    const int middle = s.columns / 6 * 3;
    const int first = half == 0 ? 0 : middle, last = half == 0 ? middle : s.columns;
    solve_left(s.size, last - first, s.l, s.l_step, s.b + first * s.b_step, s.b_step);
  }
};

inline void swap(Real& a, Real& b) {
  const Real held = a;
  a = b;
  b = held;
}

inline void swap(int size, Real* x, Real* y) {
  for (int i = 0; i < size; ++i) swap(x[i], y[i]);
}

// y -= factor * x
inline void subtract_scaled(int size, Real factor, const Real* x, Real* y) {
  int i = 0;
  for (; i + lanes <= size; i += lanes) store(y + i, load(y + i) - load(x + i) * factor);
  for (; i < size; ++i) y[i] -= x[i] * factor;
}

inline bool has_finite_reciprocal(Real x) {
  const Real r = 1 / x;
  return r - r == 0;
}

// LU of a (rows x columns, rows >= columns) with partial pivoting. exchange counts from a's row 0.
bool factorise_columns(const Sharing* sharing, bool definite, int rows, int columns, Real* a,
                       int64_t step, int* exchange, Real* reciprocal) {
  if (columns > 12) {
    const int half = columns / 6 * 3, rest = columns - half;
    Real* right = a + half * step;
    if (!factorise_columns(sharing, definite, rows, half, a, step, exchange, reciprocal))
      return false;
    for (int j = 0; j < rest; ++j)
      for (int p = 0; p < half; ++p) swap(right[p + j * step], right[exchange[p] + j * step]);
    if (sharing && 0.5 * half * half * rest > worth_sharing) {
      SharedSolve solve{half, rest, a, step, right, step};
      sharing->run(sharing->threads, &SharedSolve::part, &solve);
    } else {
      solve_left(half, rest, a, step, right, step);
    }
    subtract_product(sharing, rows - half, rest, half, a + half, step, {right, 1, step},
                     right + half, step);
    if (!factorise_columns(sharing, definite, rows - half, rest, right + half, step,
                           exchange + half, reciprocal + half))
      return false;
    for (int p = half; p < columns; ++p) exchange[p] += half;
    for (int j = 0; j < half; ++j)
      for (int p = half; p < columns; ++p) swap(a[p + j * step], a[exchange[p] + j * step]);
    return true;
  }
  for (int p = 0; p < columns; ++p) {
    Real* column = a + p * step;
    int largest = p;
    Real size = column[p] < 0 ? -column[p] : column[p];
    for (int i = p + 1; i < rows && !definite; ++i) {
      const Real other = column[i] < 0 ? -column[i] : column[i];
      if (other > size) {
        size = other;
        largest = i;
      }
    }
    exchange[p] = largest;
    if (!has_finite_reciprocal(column[largest]) || (definite && !(column[p] > 0))) return false;
    if (largest != p)
      for (int j = 0; j < columns; ++j) swap(a[p + j * step], a[largest + j * step]);
    reciprocal[p] = 1 / column[p];
    for (int i = p + 1; i < rows; ++i) column[i] *= reciprocal[p];
    for (int j = p + 1; j < columns; ++j) {
      Real* other = a + j * step;
      subtract_scaled(rows - p - 1, other[p], column + p + 1, other + p + 1);
    }
  }
  return true;
}

// Computes the rows of U in A12 (half 0) or the columns of L in A21 (half 1).
void solve_outside(void* data, int half) {
  const Front<Real>& front = *static_cast<const Front<Real>*>(data);
  const int k = front.pivots, rows = padded_rows(front.boundary);
  const int64_t step = k + rows;
  if (half == 0)
    solve_right(rows, k, front.upper, rows, {front.lower, step, 1}, nullptr);
  else
    solve_right(rows, k, front.lower + k, step, {front.lower, 1, step}, front.reciprocal);
}

bool factorise(const Front<Real>& front, const Sharing* sharing) {
  const int k = front.pivots, b = front.boundary, rows = padded_rows(b);
  const int64_t step = k + rows;
  if (!factorise_columns(sharing, front.definite, k, k, front.lower, step, front.exchange,
                         front.reciprocal))
    return false;
  if (b == 0) return true;
  for (int p = 0; p < k; ++p)
    if (front.exchange[p] != p)
      swap(rows, front.upper + static_cast<int64_t>(p) * rows,
           front.upper + static_cast<int64_t>(front.exchange[p]) * rows);
  Front<Real> outside = front;
  if (sharing && 1.0 * k * k * rows > worth_sharing) {
    sharing->run(sharing->threads, solve_outside, &outside);
  } else {
    solve_outside(&outside, 0);
    solve_outside(&outside, 1);
  }
  const Real* lower = front.lower + k;
  const View upper{front.upper, rows, 1};
  if (front.fresh)
    subtract_product<true>(sharing, rows, b, k, lower, step, upper, front.update, rows);
  else
    subtract_product<false>(sharing, rows, b, k, lower, step, upper, front.update, rows);
  return true;
}

// y += x, both rows x columns
inline void add(int rows, int columns, const Real* x, int64_t x_step, Real* y, int64_t y_step) {
  for (int j = 0; j < columns; ++j, x += x_step, y += y_step) {
    int i = 0;
    for (; i + lanes <= rows; i += lanes) store(y + i, load(y + i) + load(x + i));
    for (; i < rows; ++i) y[i] += x[i];
  }
}

void extend_add(const Real* child, int boundary, const Run* run, const Run* run_end,
                const Front<Real>& parent) {
  const int k = parent.pivots;
  const int64_t child_step = padded_rows(boundary), step = padded_rows(parent.boundary);
  for (const Run* across = run; across != run_end; ++across)
    for (const Run* down = run; down != run_end; ++down) {
      const Real* from = child + 3 * (down->from + across->from * child_step);
      const int rows = 3 * down->length, columns = 3 * across->length;
      const int64_t to_row = 3 * down->to, to_column = 3 * across->to;
      if (to_column < k) {
        add(rows, columns, from, child_step, parent.lower + to_row + to_column * (k + step),
            k + step);
      } else if (to_row >= k) {
        add(rows, columns, from, child_step, parent.update + (to_row - k) + (to_column - k) * step,
            step);
      } else {
        Real* to = parent.upper + (to_column - k) + to_row * step;
        for (int i = 0; i < rows; i += 3)
          for (int j = 0; j < columns; ++j) {
            const Real* three = from + i + j * child_step;
            Real* target = to + j + i * step;
            target[0] += three[0];
            target[step] += three[1];
            target[2 * step] += three[2];
          }
      }
    }
}

// y -= a * x over three columns of a
inline void subtract_columns(int size, const Real* a, int64_t a_step, Real x0, Real x1, Real x2,
                             Real* y) {
  const Real *first = a, *second = a + a_step, *third = second + a_step;
  int i = 0;
  for (; i + lanes <= size; i += lanes)
    store(y + i, load(y + i) - load(first + i) * x0 - load(second + i) * x1 - load(third + i) * x2);
  for (; i < size; ++i) y[i] = y[i] - first[i] * x0 - second[i] * x1 - third[i] * x2;
}

void forward(int pivots, int boundary, const Real* lower, const int* exchange, Real* x) {
  const int64_t step = pivots + padded_rows(boundary);
  for (int p = 0; p < pivots; ++p) swap(x[p], x[exchange[p]]);
  for (int p = 0; p < pivots; p += 3) {
    const Real* l = lower + p + p * step;
    x[p + 1] -= l[1] * x[p];
    x[p + 2] = x[p + 2] - l[2] * x[p] - l[2 + step] * x[p + 1];
    subtract_columns(pivots + boundary - p - 3, l + 3, step, x[p], x[p + 1], x[p + 2], x + p + 3);
  }
}

// Uses as many sums as 32 bytes contain, for any register length. Results are then identical on all
// processors with fused multiplication and addition.
inline Real sum_of_products(int size, const Real* a, const Real* x) {
  constexpr int sums = 32 / sizeof(Real);
  using Sums = Real __attribute__((vector_size(32)));
  typedef Real LooseSums __attribute__((vector_size(32), aligned(alignof(Real)), may_alias));
  Sums sum = {};
  int i = 0;
  for (; i + sums <= size; i += sums)
    sum += *reinterpret_cast<const LooseSums*>(a + i) * *reinterpret_cast<const LooseSums*>(x + i);
  Real total = 0;
  for (int l = 0; l < sums; ++l) total += sum[l];
  for (; i < size; ++i) total += a[i] * x[i];
  return total;
}

void backward(int pivots, int boundary, const Real* lower, const Real* upper,
              const Real* reciprocal, Real* x) {
  const int64_t rows = padded_rows(boundary), step = pivots + rows;
  for (int p = 0; p < pivots; ++p) x[p] -= sum_of_products(boundary, upper + p * rows, x + pivots);
  for (int p = pivots - 3; p >= 0; p -= 3) {
    const Real* u = lower + p + p * step;
    const Real* r = reciprocal + p;
    x[p + 2] *= r[2];
    x[p + 1] = (x[p + 1] - u[1 + 2 * step] * x[p + 2]) * r[1];
    x[p] = (x[p] - u[step] * x[p + 1] - u[2 * step] * x[p + 2]) * r[0];
    subtract_columns(p, lower + p * step, step, x[p], x[p + 1], x[p + 2], x);
  }
}

void forward_transposed(int pivots, int boundary, const Real* lower, const Real* upper,
                        const Real* reciprocal, Real* x) {
  const int64_t rows = padded_rows(boundary), step = pivots + rows;
  for (int p = 0; p < pivots; ++p)
    x[p] = (x[p] - sum_of_products(p, lower + p * step, x)) * reciprocal[p];
  for (int p = 0; p < pivots; p += 3)
    subtract_columns(boundary, upper + p * rows, rows, x[p], x[p + 1], x[p + 2], x + pivots);
}

void backward_transposed(int pivots, int boundary, const Real* lower, const int* exchange,
                         Real* x) {
  const int64_t step = pivots + padded_rows(boundary);
  for (int p = pivots - 1; p >= 0; --p)
    x[p] -= sum_of_products(pivots + boundary - p - 1, lower + p + 1 + p * step, x + p + 1);
  for (int p = pivots - 1; p >= 0; --p) swap(x[p], x[exchange[p]]);
}

constexpr FrontKernels<Real> kernels{factorise, extend_add,         forward,
                                     backward,  forward_transposed, backward_transposed};
