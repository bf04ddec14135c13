// A straight line of twine or rope between two ends that are weighted sums of nodes.
//
// One element stands for `multiplicity` equal lines in parallel. With e = sum_k a_k x_k the vector
// along the line, L = |e|, L0 its unstretched length:
//   tension  T = max(0, EA s + c ds/dt), s = L/L0 - 1 the strain: without damping c the gradient
//            of W(L) = EA (L - L0)^2 / (2 L0). The damper acts within the max: no line pushes.
//            Where loads are given by strain instead of EA they are straight between the rows of
//            their table, from nothing at strain 0, and go on as they end;
//   drag     of a cylinder of diameter d and length L0 (elements/cylinder_law.hpp) at the relative
//            velocity U = sum_k w_k (u_k - v_k), shared over the nodes by w_k.
// A slack line (L < L0) hangs in a curve, so its drag loses its direction: a share L/L0 of it is
// taken straight, and the rest as the mean of the same law over all directions,
// (3 pi/16) C_n + (1/4) C_t + C_f. At L = L0 both agree, and drag stays smooth in x as L -> 0.
// Lines are computed many at a time: elements/line_kernels.hpp.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "cylinder_law.hpp"

namespace codend {

struct TwineMaterial {
  double axial_stiffness = 0.0;  // EA, N; of a table of loads the stiffness of its beginning
  // Loads (N) by strain, both growing and above 0; empty: EA alone.
  std::vector<double> strains, loads;
  // Damping c over L0, N s/m: a damping ratio z of one line makes z sqrt(EA m), m its mass per
  // length. With half a line's mass at each end z = 1 then damps its own stretching critically.
  double damping = 0.0;
  double diameter = 0.0;           // m
  double volume_per_length = 0.0;  // m2
  double added_mass_normal = 1.0;  // on the displaced mass of water
  double added_mass_tangential = 0.0;
  CylinderLaw law;
  bool strut = false;  // also pushes: T = EA (L/L0 - 1) of either sign

  template <class Visit>
  void fields(Visit& visit) {
    visit("axial_stiffness", axial_stiffness);
    visit("damping", damping);
    visit("diameter", diameter);
    visit("volume_per_length", volume_per_length);
    visit("added_mass_normal", added_mass_normal);
    visit("added_mass_tangential", added_mass_tangential);
    visit("law", law.kind);
    visit("normal", law.normal);
    visit("tangential", law.tangential);
    visit("skin", law.skin);
    visit("solidity", law.solidity);
    visit("tangential_share", law.tangential_share);
    visit("strut", strut);
  }
};

enum class SlackDrag { curved, straight };
constexpr std::array<const char*, 2> names_of(SlackDrag) { return {"curved", "straight"}; }

// Loads by strain of some of a model's materials: a row each, those of one material in order.
struct LoadTable {
  std::vector<int> material;
  std::vector<double> strain, load;  // N

  template <class Visit>
  void fields(Visit& visit) {
    visit("material", material, {1, Among::materials});
    visit("strain", strain);
    visit("load", load);
  }
  bool present() const { return !material.empty(); }
};

// Tension (N) at a strain before it is clipped, its derivative, and its integral over the strain.
struct TwinePull {
  double tension, modulus, energy;
};
TwinePull twine_pull(const TwineMaterial& material, double strain);

// The inverse: strain at a tension (N, not negative), and its derivative.
void twine_stretch(const TwineMaterial& material, double tension, double& strain, double& slope);

// Tension of one line, N.
inline double twine_tension(const TwineMaterial& m, double length, double rest) {
  return length > rest || m.strut ? twine_pull(m, length / rest - 1.0).tension : 0.0;
}

// Strain energy of one line, J.
inline double twine_energy(const TwineMaterial& m, double length, double rest) {
  if (length <= rest && !m.strut) return 0.0;
  return rest * twine_pull(m, length / rest - 1.0).energy;
}

}  // namespace codend
