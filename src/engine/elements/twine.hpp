// A straight line of twine or rope between two ends, each a weighted sum of nodes.
//
// One element represents `multiplicity` equal lines in parallel. Let e = sum_k a_k x_k be the
// vector along the line, L = |e|, L0 its unstretched length and s = L/L0 - 1 the strain.
//
// - Tension: T = max(0, EA s + c ds/dt). Without damping c it is the gradient of W(L) = EA (L -
//   L0)^2 / (2 L0). Damping cannot make a line push. A load table replaces EA s by linear
//   interpolation between its rows. It starts from 0 at strain 0 and extrapolates the last segment.
// - Drag: force on a cylinder of diameter d and length L0 (elements/cylinder_drag_model.hpp) at the
//   relative velocity U = sum_k w_k (u_k - v_k), distributed to the nodes by w_k.
//
// A slack line (L < L0) is curved, so that its drag depends less on direction. The fraction L/L0 is
// computed as for a straight line. The remainder is the mean of the same drag model over all
// directions, (3 pi/16) C_n + (1/4) C_t + C_f. At L = L0 both agree, and drag remains smooth in x
// as L -> 0. Many lines are computed together: elements/line_kernels.hpp.
#pragma once

#include <vector>

#include "../base/fields.hpp"
#include "../base/water.hpp"
#include "cylinder_drag_model.hpp"

namespace codend {

struct TwineMaterial {
  double axial_stiffness = 0.0;  // EA, N; with a load table its initial stiffness
  // Load table (N by strain), both increasing and above 0; empty: EA only.
  std::vector<double> strains, loads;
  // Damping c over L0, N s/m. A line with damping ratio z has z sqrt(EA m), m its mass per length.
  // With half a line's mass at each end, z = 1 then damps its stretching critically.
  double damping = 0.0;
  double diameter = 0.0;           // m
  double volume_per_length = 0.0;  // m2
  double added_mass_normal = 1.0;  // relative to the displaced mass of water
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

// Load tables of some materials: one row per entry, the rows of each material in order.
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

// Tension (N) at a strain, before the lower bound, its derivative, and its integral over strain.
struct TwinePull {
  double tension, modulus, energy;
};
TwinePull twine_pull(const TwineMaterial& material, double strain);

// Inverse of twine_pull(): strain at a tension (N, >= 0), and its derivative (1/N).
void twine_stretch(const TwineMaterial& material, double tension, double& strain, double& slope);

// Stiffness (N/m) of slack netting against twist: the tension that netting_cell.hpp describes, over
// the bar length.
double twist_stiffness(const TwineMaterial& material, const Water& water);

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
