// How bodies swing about an equilibrium: eigenvalues of the gear's small motions, with its true mass
// and damping.
//
// Small displacements y from rest follow M y'' + D y' + K y = 0, D and K the derivatives of the net
// forces. y = e^(l t) z with the real part of l the rate at which a motion grows (negative: dies) and
// the imaginary part its angular frequency: divergence where l is real and positive, flutter where it
// is complex and its real part positive.
//
// Bodies alone are asked for, so the gear is projected on how it answers to forces on them at a few
// real rates s: the columns of (K + s D + s^2 M)^-1 B and their derivatives by s, B the rigid motions
// of every body. The small problem has the same answer as the whole at these rates, and nearly so
// around them (rational interpolation: A. C. Antoulas, Approximation of Large-Scale Dynamical
// Systems, 2005, ch. 11). What of its eigenvalues is one of the whole gear's too, its residual says.
// Flow in the wake of netting is taken as it is.
#pragma once

#include <complex>
#include <vector>

#include "../model/assembly.hpp"

namespace codend {

struct BodyMode {
  std::complex<double> rate;  // l, 1/s; of a pair, the one with the positive imaginary part
  int node = -1;              // of a body, that moves most
  double residual = 0.0;      // of the whole gear's equations, over the sizes of their three terms
  std::vector<std::complex<double>> motion;  // z, 3 per free node; at most 1 long at any node
};

// Motions in which a body takes part, of rates up to 20/s in size, the fastest growing first; empty
// where no body is free.
// x: an equilibrium, 3 per node, m; v: how held nodes move in it, m/s. Leaves the assembly there.
std::vector<BodyMode> body_modes(Assembly& assembly, const double* x, const double* v);

}  // namespace codend
