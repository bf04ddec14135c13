#include "local_balance.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "settle.hpp"

namespace codend {
namespace {

// Sweeps in which what is carried passes along a row of nodes.
constexpr int sweeps = 10;
// Of settling a few nodes: steps, and net forces left over the largest tension among them. What is left
// is the next step's.
constexpr int most_steps = 60;
constexpr double tolerance = 1e-7;

}  // namespace

void LocalBalance::ByNode::add(const std::vector<int>& nodes) {
  for (std::size_t e = 0; e < nodes.size(); ++e) {
    element_.emplace_back(nodes[e], static_cast<int>(e));
  }
  std::sort(element_.begin(), element_.end());
}

template <class Visit>
void LocalBalance::ByNode::each(int node, Visit visit) const {
  auto next = std::lower_bound(element_.begin(), element_.end(), std::make_pair(node, 0));
  for (; next != element_.end() && next->first == node; ++next) {
    visit(static_cast<std::size_t>(next->second));
  }
}

LocalBalance::LocalBalance(const Model& model)
    : model_(model),
      alone_(static_cast<std::size_t>(model.nodes), 1),
      first_(static_cast<std::size_t>(model.nodes) + 1, 0) {
  const auto rule_out = [&](int point) {
    if (point < model.nodes) {
      alone_[static_cast<std::size_t>(point)] = 0;
      return;
    }
    const Tie& tie = model.ties[static_cast<std::size_t>(point - model.nodes)];
    alone_[static_cast<std::size_t>(tie.first)] = 0;
    alone_[static_cast<std::size_t>(tie.second)] = 0;
  };
  const std::vector<int>& ends = model.bars.node;
  for (const int end : ends) {
    if (end < model.nodes) ++first_[static_cast<std::size_t>(end) + 1];
  }
  for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
  bar_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (ends[k] >= model.nodes) continue;
    bar_[static_cast<std::size_t>(next[static_cast<std::size_t>(ends[k])]++)] =
        static_cast<int>(k / 2);
  }
  spheres_.add(model.spheres.node);
  volumes_.add(model.volumes.node);

  for (int n = 0; n < model.nodes; ++n) {
    // behind netting that slows the water a node depends on others far off
    const bool nothing = bars_of(n).first == bars_of(n).last;
    if (model.held[static_cast<std::size_t>(n)] || nothing || model.wake_sheets.count() > 0) {
      rule_out(n);
    }
  }
  for (int b = 0; b < model.bars.count(); ++b) {
    if (!model.material(model.bars.line(b)).strut) continue;
    for (int end = 0; end < 2; ++end)
      rule_out(ends[2 * static_cast<std::size_t>(b) + static_cast<std::size_t>(end)]);
  }
  for (std::size_t t = 0; t < model.ties.size(); ++t) {
    rule_out(model.nodes + static_cast<int>(t));
  }
  for (const std::vector<int>* nodes :
       {&model.cells.node, &model.hexagons.node, &model.contacts.node}) {
    for (const int point : *nodes) rule_out(point);
  }
  for (const ElementKind* kind : model.kinds()) {
    if (kind == &model.spheres || kind == &model.volumes) continue;
    for (const int point : kind->nodes()) rule_out(point);
  }
  possible_ = std::find(alone_.begin(), alone_.end(), 1) != alone_.end();
}

LocalBalance::Range LocalBalance::bars_of(int node) const {
  const std::size_t n = static_cast<std::size_t>(node);
  return {bar_.data() + first_[n], bar_.data() + first_[n + 1]};
}

int LocalBalance::other_end(int bar, int node) const {
  const int* ends = model_.bars.line(bar).nodes;
  return ends[0] == node ? ends[1] : ends[0];
}

Vector LocalBalance::value(int point, const double* values) const {
  if (point < model_.nodes) return at(values, point);
  const Tie& tie = model_.ties[static_cast<std::size_t>(point - model_.nodes)];
  return (1.0 - tie.share) * at(values, tie.first) + tie.share * at(values, tie.second);
}

Vector LocalBalance::change(std::size_t bar, const double* values) const {
  return value(model_.bars.node[2 * bar + 1], values) - value(model_.bars.node[2 * bar], values);
}

Vector LocalBalance::carried(int node, const double* dx) const {
  Vector sum = Vector::Zero();
  for (const int bar : bars_of(node)) sum += value(other_end(bar, node), dx);
  return sum / static_cast<double>(bars_of(node).last - bars_of(node).first);
}

// Whether a bar of it turns by more than that, by its own motion and not with all around it.
bool LocalBalance::swings(int node, const double* dx, double turn) const {
  const double own = (at(dx, node) - carried(node, dx)).norm();
  for (const int bar : bars_of(node)) {
    const double limit = turn * model_.bars.rest[static_cast<std::size_t>(bar)];
    if (own > 0.5 * limit && change(static_cast<std::size_t>(bar), dx).norm() > limit) return true;
  }
  return false;
}

// Whether no bar of it has a tension of more than so many times its load: between two that have, it has
// its place by them, however it turns.
bool LocalBalance::hangs(int node, const std::vector<double>& tension, const double* load,
                         double most) const {
  const double limit = most * at(load, node).norm();
  for (const int bar : bars_of(node)) {
    const std::size_t b = static_cast<std::size_t>(bar);
    if (model_.bars.multiplicity[b] * tension[b] > limit) return false;
  }
  return true;
}

void LocalBalance::swinging(const double* dx, const std::vector<double>& tension,
                            const double* load, const SwingControl& control,
                            std::vector<int>& found) const {
  const std::size_t most =
      control.least_nodes +
      static_cast<std::size_t>(control.most_nodes * static_cast<double>(model_.nodes));
  found.clear();
  for (int n = 0; n < model_.nodes && found.size() <= most; ++n) {
    if (alone_[static_cast<std::size_t>(n)] && swings(n, dx, control.turn) &&
        hangs(n, tension, load, control.tension)) {
      found.push_back(n);
    }
  }
  if (found.size() > most) found.clear();
}

void LocalBalance::carry(const std::vector<int>& nodes, double* dx) const {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const int node : nodes) at(dx, node) = carried(node, dx);
  }
}

// Nodes that share a bar are settled together.
void LocalBalance::settle(const std::vector<int>& nodes, const double* v, double* x) const {
  std::set<int> left(nodes.begin(), nodes.end());
  while (!left.empty()) {
    std::vector<int> group{*left.begin()};
    left.erase(left.begin());
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (const int bar : bars_of(group[k])) {
        const int other = other_end(bar, group[k]);
        if (left.erase(other)) group.push_back(other);
      }
    }
    settle_group(group, v, x);
  }
}

void LocalBalance::settle_group(const std::vector<int>& nodes, const double* v, double* x) const {
  Model part;
  part.water = model_.water;
  part.slack = model_.slack;
  part.materials = model_.materials;
  std::vector<double> where, how;
  std::map<int, int> known;  // point -> node of the part
  const auto node_of = [&](int point) {
    const auto [place, is_new] = known.emplace(point, part.nodes);
    if (!is_new) return place->second;
    const std::size_t p = static_cast<std::size_t>(point);
    const Vector position = value(point, x), velocity = value(point, v);
    where.insert(where.end(), position.data(), position.data() + 3);
    how.insert(how.end(), velocity.data(), velocity.data() + 3);
    part.held.push_back(part.held.size() >= nodes.size());
    part.load.insert(part.load.end(), &model_.load[3 * p], &model_.load[3 * p] + 3);
    part.mass.push_back(model_.mass[p]);
    return part.nodes++;
  };
  for (const int node : nodes) node_of(node);
  std::set<int> bars;
  for (const int node : nodes) bars.insert(bars_of(node).begin(), bars_of(node).end());
  for (const int bar : bars) {
    const std::size_t b = static_cast<std::size_t>(bar);
    for (std::size_t end = 0; end < 2; ++end) {
      part.bars.node.push_back(node_of(model_.bars.node[2 * b + end]));
    }
    part.bars.rest.push_back(model_.bars.rest[b]);
    part.bars.multiplicity.push_back(model_.bars.multiplicity[b]);
    part.bars.material.push_back(model_.bars.material[b]);
    if (!model_.bars.height.empty()) part.bars.height.push_back(model_.bars.height[b]);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int here = static_cast<int>(k);
    spheres_.each(nodes[k], [&](std::size_t e) {
      part.spheres.node.push_back(here);
      part.spheres.drag_area.push_back(model_.spheres.drag_area[e]);
      part.spheres.diameter.push_back(model_.spheres.diameter[e]);
      part.spheres.smooth.push_back(model_.spheres.smooth[e]);
      part.spheres.height.push_back(model_.spheres.height[e]);
    });
    volumes_.each(nodes[k], [&](std::size_t e) {
      part.volumes.node.push_back(here);
      part.volumes.buoyancy.push_back(model_.volumes.buoyancy[e]);
      part.volumes.height.push_back(model_.volumes.height[e]);
    });
  }
  part.spheres.added_mass.resize(part.spheres.node.size(), 0.0);  // nothing accelerates
  part.prepare();

  Assembly assembly(part);
  SettleControl control;
  control.start = Start::near;
  control.iterations = most_steps;
  control.tolerance = tolerance;
  control.timed = false;
  control.swing.turn = std::numeric_limits<double>::infinity();  // no balance within a balance
  if (!codend::settle(assembly, control, how.data(), where.data()).converged) return;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    at(x, nodes[k]) = at(where.data(), static_cast<int>(k));
  }
}

}  // namespace codend
