#pragma once

#include "assembly_tree.hpp"

namespace codend {

// Returns the stored rows of a block of `boundary` rows: whole registers, for every set of kernels.
template <class Real>
constexpr int padded(int boundary) {
  constexpr int lanes = 64 / sizeof(Real);
  return (boundary + lanes - 1) / lanes * lanes;
}

// A dense front [A11 A12; A21 A22]; A11 is fully summed and eliminated here. Sizes are in scalars
// and multiples of 3. Blocks are column-major, with columns padded by zeros to padded<Real>().
template <class Real>
struct Front {
  int pivots;        // rows of A11
  int boundary;      // rows of A22
  Real* lower;       // [A11; A21], column length pivots + padded<Real>(boundary)
  Real* upper;       // A12 transposed, so that all long loops run down columns
  Real* update;      // A22
  Real* reciprocal;  // pivots: reciprocals of U's diagonal
  int* exchange;     // pivots: row that each row of A11 was exchanged with, in order
  bool fresh;        // A22 is zero and `update` not yet initialised
  bool definite;     // no row exchanges; every pivot must be positive
};

// Two threads for one front. run(threads, job, data) returns after job(data, 0) and job(data, 1).
struct Sharing {
  void (*run)(void* threads, void (*job)(void* data, int half), void* data);
  void* threads;
};

// Inner loops in double or float, compiled once per instruction set.
template <class Real>
struct FrontKernels {
  // Replaces A11 by its LU factors, with partial pivoting among its rows. Replaces A21 and A12 by
  // the remaining columns of L and rows of U, and A22 by its Schur complement. Returns false if a
  // pivot has no finite reciprocal, or is not positive in a definite front. sharing: null for one
  // thread; the result is identical with two.
  bool (*factorise)(const Front<Real>& front, const Sharing* sharing);
  // Adds a child's update matrix of `boundary` rows to its parent's front.
  void (*extend_add)(const Real* child, int boundary, const Run* run, const Run* run_end,
                     const Front<Real>& parent);
  // Forward substitution. x: pivots of the front, then its boundary, which is reduced.
  void (*forward)(int pivots, int boundary, const Real* lower, const int* exchange, Real* x);
  // Back substitution. x: pivots (unknown), then boundary (already solved).
  void (*backward)(int pivots, int boundary, const Real* lower, const Real* upper,
                   const Real* reciprocal, Real* x);
  // Transposed matrix: forward substitution with U transposed, back substitution with L transposed.
  void (*forward_transposed)(int pivots, int boundary, const Real* lower, const Real* upper,
                             const Real* reciprocal, Real* x);
  void (*backward_transposed)(int pivots, int boundary, const Real* lower, const int* exchange,
                              Real* x);
};

struct FrontKernelSet {
  const FrontKernels<double>& in_double;
  const FrontKernels<float>& in_single;
};

// For any processor. Not a template: the linker could use an AVX instance in all files.
const FrontKernelSet& portable_front_kernels();

// For x86-64 with AVX2 and FMA; null without support by the compiler or the processor.
const FrontKernelSet* avx2_front_kernels();

// For AVX-512 (F, DQ, VL). All sums equal the sums with AVX2.
const FrontKernelSet* avx512_front_kernels();

// Returns the fastest kernels of the processor, for Real of float or double. The choice is fixed
// for a machine. A processor without AVX2 and FMA rounds between multiplication and addition, so
// the last bits of a solution may differ from other machines.
template <class Real>
const FrontKernels<Real>& front_kernels();
template <>
const FrontKernels<double>& front_kernels<double>();
template <>
const FrontKernels<float>& front_kernels<float>();

}  // namespace codend
