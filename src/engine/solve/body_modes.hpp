// Small oscillations of bodies about an equilibrium, with the gear's true mass and damping.
//
// Small displacements y satisfy M y'' + D y' + K y = 0, with D and K the derivatives of the net
// forces. In y = e^(l t) z, the real part of l is the growth rate, and the imaginary part is the
// angular frequency. Divergence has a real positive l, flutter a complex l with positive real part.
//
// Only modes of bodies are required, so the gear is projected on its response to forces on bodies
// at a few real rates s. The basis consists of the columns of (K + s D + s^2 M)^-1 B and their
// derivatives by s. B are the rigid motions of every body. The small problem gives the exact
// response at these rates, and nearly so around them (rational interpolation: A. C. Antoulas,
// Approximation of Large-Scale Dynamical Systems, 2005, ch. 11). The residual decides which
// eigenvalues belong to the whole gear.
//
// Real rates do not resolve the oscillations of boards on a large net. The projection is therefore
// extended for the least damped unresolved modes, by the response at their complex rates (dominant
// poles: J. Rommes and N. Martins, IEEE Trans. Power Syst. 21, 2006). Wakes are constant.
#pragma once

#include <complex>
#include <vector>

#include "../model/assembly.hpp"

namespace codend {

struct BodyMode {
  std::complex<double> rate;  // l, 1/s; for a conjugate pair, with positive imaginary part
  int node = -1;              // node of a body with the largest displacement
  bool certain = false;   // true if the residual is small; growing modes are returned in any case
  double residual = 0.0;  // residual of the full equations, over the norms of their three terms
  std::vector<std::complex<double>> motion;  // z, 3 per free node; largest nodal displacement 1
};

// Returns modes with moving bodies and |l| up to 10/s, the fastest growing first; empty without a
// free body. Some modes above half of the critical damping may be missing. x: an equilibrium, m, 3
// per node; v: velocities of fixed nodes, m/s. Leaves the assembly at this state.
std::vector<BodyMode> body_modes(Assembly& assembly, const double* x, const double* v);

}  // namespace codend
