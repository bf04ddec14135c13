#pragma once

#include "assembly_tree.hpp"

namespace codend {

// Rows that a block of `boundary` rows takes in store: whole registers, whichever kernels run.
template <class Real>
constexpr int padded(int boundary) {
  constexpr int lanes = 64 / sizeof(Real);
  return (boundary + lanes - 1) / lanes * lanes;
}

// A dense front [A11 A12; A21 A22], of which A11 is fully summed and eliminated here. Sizes are in
// scalars and multiples of 3. Blocks are column-major, a column of `boundary` rows being followed
// by zeros up to padded<Real>(boundary).
template <class Real>
struct Front {
  int pivots;        // rows of A11
  int boundary;      // rows of A22
  Real* lower;       // [A11; A21], a column takes pivots + padded<Real>(boundary)
  Real* upper;       // A12 transposed, so that all long loops run down columns
  Real* update;      // A22
  Real* reciprocal;  // pivots: reciprocals of U's diagonal
  int* exchange;     // pivots: row that each row of A11 was swapped with in turn
  bool fresh;        // A22 is zero and `update` not set yet
  bool definite;     // rows are not exchanged, and every pivot is to be positive
};

// Two threads for one front: run(threads, job, data) returns when job(data, 0) and job(data, 1) have.
struct Sharing {
  void (*run)(void* threads, void (*job)(void* data, int half), void* data);
  void* threads;
};

// The inner loops in double or float, compiled once per set of processor instructions.
template <class Real>
struct FrontKernels {
  // Replaces A11 by its LU factors with partial pivoting among its own rows, A21 and A12 by the
  // remaining columns of L and rows of U, and A22 by its Schur complement. Returns false at a pivot
  // whose reciprocal is not finite, or that is not positive where that is asked. sharing: null for one thread; the bytes are equal either way.
  bool (*factorise)(const Front<Real>& front, const Sharing* sharing);
  // Adds a child's update matrix of `boundary` rows into its parent's front.
  void (*extend_add)(const Real* child, int boundary, const Run* run, const Run* run_end,
                     const Front<Real>& parent);
  // Forward substitution with the factors that factorise() left. `x` holds the front's pivots, then
  // its boundary; that part is reduced.
  void (*forward)(int pivots, int boundary, const Real* lower, const int* exchange, Real* x);
  // Back substitution. `x` holds the pivots, to be solved for, then the boundary, already solved.
  void (*backward)(int pivots, int boundary, const Real* lower, const Real* upper,
                   const Real* reciprocal, Real* x);
  // The same two for the transposed matrix: forward with U transposed, back with L transposed.
  void (*forward_transposed)(int pivots, int boundary, const Real* lower, const Real* upper,
                             const Real* reciprocal, Real* x);
  void (*backward_transposed)(int pivots, int boundary, const Real* lower, const int* exchange,
                              Real* x);
};

// The kernels of one set of processor instructions.
struct FrontKernelSet {
  const FrontKernels<double>& in_double;
  const FrontKernels<float>& in_single;
};

// For any processor. No templates here and below: one made in a file that is compiled for AVX could
// be taken by the linker for all files.
const FrontKernelSet& portable_front_kernels();

// For x86-64 with AVX2 and FMA; null where the compiler or the running processor lacks them.
const FrontKernelSet* avx2_front_kernels();

// The same with AVX-512 (F, DQ, VL), of which every sum is that of AVX2.
const FrontKernelSet* avx512_front_kernels();

// The fastest that the running processor can execute, for Real of float or double. The choice is
// fixed for a machine; one without AVX2 and FMA, which rounds between multiplying and adding, may
// differ from the others in the last bits of a solution.
template <class Real>
const FrontKernels<Real>& front_kernels();
template <>
const FrontKernels<double>& front_kernels<double>();
template <>
const FrontKernels<float>& front_kernels<float>();

}  // namespace codend
