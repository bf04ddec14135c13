#include "measure_errors.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace codend {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Orders of convergence considered; netting converges with 0.5 to 2.
constexpr double orders[] = {0.75, 1, 1.5};
// Scatter as a fraction of the drift, on the same mesh.
constexpr double scatter_share = 0.25;
// Meshes with a smaller ratio of node numbers carry too little information.
constexpr double least_ratio = 1.5;
// Meshes with fewer nodes are used only if there are no others: their netting has only a few meshes
// across a panel.
constexpr double fair_nodes = 400;
// Minimum number of measures to estimate the usual relative error of a class; smaller classes use
// the value of all measures.
constexpr std::size_t least_class = 3;
// Relative error of positions and lengths compared with openings.
constexpr double place_share = 0.1;
// Minimum error as a fraction of a measure, for meshes of netting with `floor_nodes` nodes. In 2 of
// 6 random gears measures changed by 1 to 2 % above 4,000 nodes, and hardly below. The minimum is
// proportional to element length.
constexpr double error_floor = 2e-3, floor_nodes = 1500;
// Larger minimum for `slack_netting`: this fraction of its value plus this fraction of a row of
// elements, which applies even if no netting is slack.
constexpr double slack_floor = 0.1;
// Minimum relative error of a measure, and relative difference regarded as zero.
constexpr double least_share = 1e-5, no_share = 1e-9;

// Meshes of netting with fewer than `enough_nodes` nodes share the errors of all coarse meshes and
// show only a fifth of the actual error. The extra mesh has `extra_ratio` times as many nodes.
// Above `most_made_finer` nodes it is coarser instead, which takes less time; above `most_compared`
// there is none.
constexpr double enough_nodes = 1200, extra_ratio = 2.6, most_made_finer = 2500,
                 most_compared = 1e5;

// Standard error of measures due to time steps, from the accuracy of positions. Positions: 1.5
// times the accuracy (within three times on tested gears); an area has two lengths, a volume three.
// Forces: 2.5 % at 0.01 m, proportional to its square root. For a net that sinks slack, 90 % of the
// forces have errors below 4 % (0.01 m) and 9 % (0.3 m). For a net with lines paid out the values
// are 0.03 % and 0.15 %.
constexpr double step_places = 1.5, step_forces = 0.25;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Usual relative error of each measure's class: median of the relative errors.
std::vector<double> usual_shares(const std::vector<double>& shares,
                                 const std::vector<MeasureClass>& classes) {
  std::vector<double> every;
  std::map<MeasureClass, std::vector<double>> by_class;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!std::isfinite(shares[k]) || shares[k] <= no_share) continue;
    every.push_back(shares[k]);
    by_class[classes[k]].push_back(shares[k]);
  }
  const double of_all = median(every);
  std::vector<double> out;
  for (const MeasureClass one : classes) {
    const std::vector<double>& mine = by_class[one];
    const double usual = mine.size() >= least_class   ? median(mine)
                         : one == MeasureClass::place ? place_share * of_all
                                                      : of_all;
    out.push_back(std::max(usual, least_share));
  }
  return out;
}

// Root mean square errors by a fit to all meshes. differences: measures on each other mesh minus
// measures on the present one, whose node number is last in `nodes`. size: |measures|.
std::vector<double> fitted_errors(const Eigen::MatrixXd& differences,
                                  const std::vector<double>& size, const std::vector<double>& nodes,
                                  const std::vector<MeasureClass>& classes) {
  const Eigen::Index others = differences.cols(), count = others + 1;
  const double freedom = static_cast<double>(others);
  Eigen::VectorXd length(count);
  for (Eigen::Index k = 0; k < count; ++k) length[k] = std::sqrt(nodes.back() / nodes[k]);
  std::vector<double> most(size.size(), -std::numeric_limits<double>::infinity());
  std::vector<double> total(size.size(), 0.0), weighed(size.size(), 0.0);
  for (const double order : orders) {
    const Eigen::VectorXd drift = length.array().pow(order);
    Eigen::MatrixXd covariance = drift * drift.transpose();
    covariance.diagonal() += (scatter_share * length).cwiseAbs2();
    const Eigen::MatrixXd weight = covariance.inverse();
    const Eigen::VectorXd sums = weight.rowwise().sum();
    const double sum = sums.sum();
    // Projects out the constant common to all meshes.
    const Eigen::MatrixXd rest = weight - sums * sums.transpose() / sum;
    const double spread = std::log(covariance.determinant()) + std::log(sum);
    std::vector<double> squares, shares;
    for (std::size_t k = 0; k < size.size(); ++k) {
      const Eigen::VectorXd d = differences.row(static_cast<Eigen::Index>(k));
      squares.push_back(std::max(d.dot(rest.topLeftCorner(others, others) * d), 0.0));
      shares.push_back(std::sqrt(squares[k] / freedom) / size[k]);
    }
    const std::vector<double> usual = usual_shares(shares, classes);
    for (std::size_t k = 0; k < size.size(); ++k) {
      const double own = usual[k] * size[k];
      const double variance = (own * own + squares[k]) / (1 + freedom);
      const double off = differences.row(static_cast<Eigen::Index>(k)).dot(sums.head(others)) / sum;
      const double likelihood =
          -(1 + freedom) / 2 * std::log(variance + std::numeric_limits<double>::min()) - spread / 2;
      // Relative to the maximum so far, to avoid overflow.
      const double larger = std::max(most[k], likelihood);
      const double before = std::exp(most[k] - larger), now = std::exp(likelihood - larger);
      total[k] = before * total[k] + now;
      weighed[k] = before * weighed[k] + now * (off * off + variance / sum);
      most[k] = larger;
    }
  }
  std::vector<double> out;
  for (std::size_t k = 0; k < size.size(); ++k) out.push_back(std::sqrt(weighed[k] / total[k]));
  return out;
}

// Returns the other meshes that are suitable for comparison with `nodes` nodes.
std::vector<MeasuredMesh> fair(std::vector<MeasuredMesh> all, double nodes) {
  const auto drop = [&](auto which) {
    all.erase(std::remove_if(all.begin(), all.end(), which), all.end());
  };
  drop([&](const MeasuredMesh& one) { return !differ_enough(nodes, one.nodes); });
  const auto is_fair = [](const MeasuredMesh& one) { return one.nodes >= fair_nodes; };
  if (std::any_of(all.begin(), all.end(), is_fair)) {
    drop([&](const MeasuredMesh& one) { return !is_fair(one); });
  }
  return all;
}

// Fits measures together if they are available on the same meshes.
std::vector<double> mesh_errors(const std::vector<MeasureNature>& natures, const MeasuredMesh& here,
                                const std::vector<MeasuredMesh>& others) {
  std::vector<double> out(here.measures.size(), unknown);
  if (others.empty()) return out;
  std::map<std::vector<bool>, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!std::isfinite(here.measures[k])) continue;
    std::vector<bool> known;
    for (const MeasuredMesh& one : others) known.push_back(std::isfinite(one.measures[k]));
    groups[known].push_back(k);
  }
  for (const auto& [known, which] : groups) {
    std::vector<const MeasuredMesh*> use;
    std::vector<double> nodes, size;
    for (std::size_t l = 0; l < others.size(); ++l) {
      if (!known[l]) continue;
      use.push_back(&others[l]);
      nodes.push_back(others[l].nodes);
    }
    nodes.push_back(here.nodes);
    std::vector<MeasureClass> classes;
    Eigen::MatrixXd differences(which.size(), use.size());
    for (std::size_t k = 0; k < which.size(); ++k) {
      const double value = here.measures[which[k]];
      size.push_back(std::abs(value));
      classes.push_back(natures[which[k]].of);
      for (std::size_t l = 0; l < use.size(); ++l) {
        differences(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) =
            use[l]->measures[which[k]] - value;
      }
    }
    // A measure missing on all other meshes has an error equal to its size.
    const std::vector<double> found =
        use.empty() ? size : fitted_errors(differences, size, nodes, classes);
    for (std::size_t k = 0; k < which.size(); ++k) out[which[k]] = found[k];
  }
  return out;
}

// Minimum error of a measure on meshes of netting.
double floor_of(const MeasureNature& of, MeasureKind kind, double size, double nodes) {
  const double at_size = std::sqrt(floor_nodes / nodes);
  if (kind == MeasureKind::slack_netting) {
    return slack_floor * (at_size * size + 1 / std::sqrt(nodes));
  }
  return of.of == MeasureClass::place ? 0.0 : error_floor * at_size * size;
}

// Scale of the equilibrium error of measures that vanish: the largest force for forces, the largest
// length for lengths, and its powers for areas and volumes. largest: by quantity.
double left_by_balance(MeasureQuantity of, std::map<MeasureQuantity, double>& largest) {
  const double length = largest[MeasureQuantity::length];
  switch (of) {
    case MeasureQuantity::length:
      return length;
    case MeasureQuantity::area:
      return length * length;
    case MeasureQuantity::volume:
      return length * length * length;
    case MeasureQuantity::force:
    case MeasureQuantity::twine_force:
      return largest[of];
    default:
      return 0.0;
  }
}

double left_by_steps(MeasureQuantity of, double size, double accuracy) {
  const double place = step_places * accuracy;
  switch (of) {
    case MeasureQuantity::length:
      return place;
    case MeasureQuantity::area:
      return 2 * place * std::sqrt(size);
    case MeasureQuantity::volume:
      return 3 * place * std::pow(size, 2.0 / 3);
    case MeasureQuantity::force:
    case MeasureQuantity::twine_force:
    case MeasureQuantity::power:
      return step_forces * std::sqrt(accuracy) * size;
    default:
      return 0.0;
  }
}

}  // namespace

std::vector<double> measure_errors(const std::vector<MeasureKind>& kinds, const MeasuredMesh& here,
                                   std::vector<MeasuredMesh> others, double tolerance,
                                   double step_accuracy) {
  const auto check = [&](const MeasuredMesh& one) {
    if (one.measures.size() == kinds.size()) return;
    throw InputError("measures", "measures must have one value per kind and mesh");
  };
  check(here);
  for (const MeasuredMesh& one : others) check(one);
  std::vector<MeasureNature> natures;
  for (const MeasureKind kind : kinds) natures.push_back(nature_of(kind));
  std::vector<double> out = mesh_errors(natures, here, fair(std::move(others), here.nodes));
  std::map<MeasureQuantity, double> largest;
  bool netting = false;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (std::isnan(here.measures[k])) continue;
    double& most = largest[natures[k].in];
    most = std::max(most, std::abs(here.measures[k]));
    netting = netting || kinds[k] == MeasureKind::slack_netting;
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const double size = std::abs(here.measures[k]);
    const double parts[] = {out[k],
                            netting ? floor_of(natures[k], kinds[k], size, here.nodes) : 0.0,
                            tolerance * left_by_balance(natures[k].in, largest),
                            left_by_steps(natures[k].in, size, step_accuracy)};
    double squares = 0.0;
    for (const double part : parts) squares += part * part;
    out[k] = std::sqrt(squares);
  }
  return out;
}

bool differ_enough(double nodes, double others) {
  return std::max(nodes / others, others / nodes) >= least_ratio;
}

std::vector<double> extra_nodes(double nodes, std::vector<double> levels, bool netting) {
  const double enough = netting ? std::min(enough_nodes, nodes) : 0.0;
  for (const double level : levels) {
    if (differ_enough(nodes, level) && level >= enough) return {};
  }
  if (nodes > most_compared) return {};
  const double finer = nodes * extra_ratio, coarser = nodes / extra_ratio;
  if (nodes <= most_made_finer) return {finer, finer * 1.5, finer * 0.7, coarser, coarser * 0.7};
  return {coarser, coarser * 0.7, finer, finer * 1.5, finer * 0.7};
}

}  // namespace codend
