#include "twine.hpp"

namespace codend {
namespace {

// See netting_cell.hpp.
constexpr double twist_speeds = 2.0, twist_diameters = 400.0;

}  // namespace

double twist_stiffness(const TwineMaterial& material, const Water& water) {
  const double speed = twist_speeds * water.speed;
  return 0.5 * water.density * material.diameter *
         (speed * speed + twist_diameters * gravity * material.diameter);
}

TwinePull twine_pull(const TwineMaterial& m, double strain) {
  if (m.strains.empty() || strain <= m.strains[0]) {
    return {m.axial_stiffness * strain, m.axial_stiffness,
            0.5 * m.axial_stiffness * strain * strain};
  }
  double energy = 0.5 * m.loads[0] * m.strains[0];
  for (std::size_t k = 1;; ++k) {
    const double from = m.strains[k - 1], load = m.loads[k - 1];
    const bool last = k + 1 >= m.strains.size();
    // A table of one row is linear: extrapolate with its first modulus.
    const double modulus =
        m.strains.size() == 1 ? m.axial_stiffness : (m.loads[k] - load) / (m.strains[k] - from);
    if (last || strain <= m.strains[k]) {
      const double more = strain - from;
      return {load + modulus * more, modulus, energy + more * (load + 0.5 * modulus * more)};
    }
    energy += 0.5 * (load + m.loads[k]) * (m.strains[k] - from);
  }
}

void twine_stretch(const TwineMaterial& m, double tension, double& strain, double& slope) {
  slope = 1.0 / m.axial_stiffness;
  strain = tension * slope;
  if (m.strains.size() < 2 || tension <= m.loads[0]) return;
  std::size_t k = 1;
  while (k + 1 < m.loads.size() && tension > m.loads[k]) ++k;
  slope = (m.strains[k] - m.strains[k - 1]) / (m.loads[k] - m.loads[k - 1]);
  strain = m.strains[k - 1] + slope * (tension - m.loads[k - 1]);
}

}  // namespace codend
