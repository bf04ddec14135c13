#include "part_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace codend {

PartBalance::PartBalance(const Assembly& assembly, const std::vector<int>& part)
    : assembly_(assembly), part_(part) {}

void PartBalance::find_scales() {
  const Model& model = assembly_.model();
  const LineArrays& a = assembly_.lines();
  const Field field = assembly_.field();
  const std::size_t points = static_cast<std::size_t>(model.points());
  const int most = part_.empty() ? 0 : *std::max_element(part_.begin(), part_.end());
  part_scale_.assign(static_cast<std::size_t>(most) + 1, 0.0);
  auto scale_of = [&](int line) -> double& {
    return part_scale_[static_cast<std::size_t>(part_of(line))];
  };
  auto raise = [](double& scale, double force) { scale = std::max(scale, force); };

  double far = 0.0;
  for (int n = 0; n < model.nodes; ++n) {
    far = std::max(far, at(field.position, n).lpNorm<Eigen::Infinity>());
  }
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * far;
  rounding_.assign(points, 0.0);
  model.each_line([&](const auto& line) {
    const int k = line.index;
    const bool pulls = a.tension[k] != 0.0;
    double pull = 0.0;
    for (std::size_t i = 0; i < std::size(line.shape); ++i) {
      const double arm = line.pull_at(static_cast<int>(i));
      pull = std::max(pull, arm);
      if (!pulls) continue;
      rounding_[static_cast<std::size_t>(line.nodes[i])] +=
          rounding * arm * arm * a.multiplicity[k] * a.stiffness[k] * a.inverse_rest[k];
    }
    raise(scale_of(k), a.multiplicity[k] * pull * std::abs(a.tension[k]) +
                           Vector(a.drag[0][k], a.drag[1][k], a.drag[2][k]).norm());
  });
  for (const SlidingRope& rope : model.sliding) {
    const double tension = rope.tension(field);
    for (const int bar : rope.bar) raise(scale_of(bar), tension);
  }
  for (int e = 0; e < model.bends.count(); ++e) {
    const std::size_t k = static_cast<std::size_t>(e);
    const double stiffness =
        model.bends.couple[k] / (model.bends.length[k] * model.bends.length[k]);
    for (int i = 0; i < 3; ++i) {
      rounding_[static_cast<std::size_t>(model.bends.node[3 * k + i])] += rounding * stiffness;
    }
  }

  std::vector<double> load(part_scale_.size(), 0.0);
  model.each_line([&](const auto& line) {
    const std::size_t part = static_cast<std::size_t>(part_of(line.index));
    if (part_scale_[part] > 0.0) return;
    for (std::size_t i = 0; i < std::size(line.shape); ++i) {
      raise(load[part], at(model.load.data(), line.nodes[i]).norm());
    }
  });
  for (std::size_t p = 0; p < load.size(); ++p) raise(part_scale_[p], load[p]);
  node_part_.assign(points, -1);
  model.each_line([&](const auto& line) {
    for (std::size_t i = 0; i < std::size(line.shape); ++i) {
      hold(line.nodes[i], part_of(line.index));
    }
  });
  for (std::size_t t = 0; t < model.ties.size(); ++t) {
    const Tie& tie = model.ties[t];
    const std::size_t point = static_cast<std::size_t>(model.nodes) + t;
    for (const int node : {tie.first, tie.second}) {
      hold(node, node_part_[point]);
      rounding_[static_cast<std::size_t>(node)] += rounding_[point];
    }
  }
}

// Assigns a part to a point if the part's scale is the largest so far.
void PartBalance::hold(int point, int part) {
  int& now = node_part_[static_cast<std::size_t>(point)];
  if (part < 0 || !(part_scale_[static_cast<std::size_t>(part)] > 0.0)) return;
  if (now < 0 ||
      part_scale_[static_cast<std::size_t>(part)] > part_scale_[static_cast<std::size_t>(now)]) {
    now = part;
  }
}

PartResidual PartBalance::worst(const double* force, double otherwise) {
  find_scales();
  PartResidual out;
  for (const int node : assembly_.free_nodes()) {
    const std::size_t n = static_cast<std::size_t>(node);
    const int part = node_part_[n];
    const double scale = part < 0 ? otherwise : part_scale_[static_cast<std::size_t>(part)];
    const double net = at(force, node).norm(), rounding = rounding_[n] / scale;
    if (net > rounding_[n] && !(net / scale <= out.residual)) {
      out.residual = net / scale;
      out.part = part;
      out.node = node;
    }
    if (rounding > out.rounding) {
      out.rounding = rounding;
      out.rounding_part = part;
    }
  }
  return out;
}

}  // namespace codend
