#include "stability.hpp"

#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Pseudo time steps (s): a tenth to ten tell apart motions that grow at 20 /s to 0.002 /s, as those
// that water drives do. What stiffness drives grows faster: shorter ones, down to about its own.
constexpr double longest_step = 10.0, shortest_of_water = 0.1, shortest_of_all = 1e-9;
constexpr int least_iterations = 10, most_iterations = 100;
// An eigenvector is found when one more iteration leaves it in its direction but for this.
constexpr double tolerance = 0.005;
// Of the size of an eigenvalue above 1, to stand clear of slack twine, which nothing moves.
constexpr double clear_growth = 1.02;
// Slack netting that drifts carries other elements with it by less than this share of its own way.
constexpr double least_share = 0.1;
constexpr double solve_tolerance = 1e-6;
// Compression (of the length) that is more than rounding.
constexpr double least_compression = 1e-9;

// Where two bars that push meet, and nothing but other lines holds them in line: a pole that is
// divided and has no stiffness against bending.
struct PressedJoint {
  int node;
  double size;       // of the shorter bar, m
  double stiffness;  // with which it is driven aside, N/m
};

std::vector<PressedJoint> pressed_joints(const Assembly& assembly) {
  const Model& model = assembly.model();
  const LineArrays& a = assembly.lines();
  // Of every node how many bars that push meet there, bends and bodies as many more.
  std::vector<int> met(static_cast<std::size_t>(model.nodes), 0);
  std::vector<PressedJoint> joint(met.size(), {-1, 0.0, 0.0});
  bool any = false;
  for (int b = 0; b < model.bars.count(); ++b) {
    const Line<2> bar = model.bars.line(b);
    if (!model.material(bar).strut) continue;
    const bool pressed = a.strain[b] < -least_compression;
    const double driven = a.multiplicity[b] * std::abs(a.tension[b]) / bar.rest;
    for (const int node : {bar.nodes[0], bar.nodes[1]}) {
      if (node >= model.nodes) continue;
      const std::size_t n = static_cast<std::size_t>(node);
      met[n] += pressed ? 1 : 3;
      PressedJoint& at_node = joint[n];
      at_node.node = node;
      at_node.size = at_node.size > 0.0 ? std::min(at_node.size, bar.rest) : bar.rest;
      at_node.stiffness += driven;
      any = true;
    }
  }
  if (!any) return {};
  auto leave_out = [&](int node) {
    if (node < model.nodes) met[static_cast<std::size_t>(node)] = 0;
  };
  for (int e = 0; e < model.bends.count(); ++e) {
    leave_out(model.bends.node[3 * static_cast<std::size_t>(e) + 1]);
  }
  for (const int node : model.plates.nodes()) leave_out(node);
  std::vector<PressedJoint> out;
  for (const int node : assembly.free_nodes()) {
    const std::size_t n = static_cast<std::size_t>(node);
    if (met[n] == 2) out.push_back(joint[n]);
  }
  return out;
}

}  // namespace

double unstable_size(const Assembly& assembly) {
  double least = 0.0;
  for (const PressedJoint& joint : pressed_joints(assembly)) {
    least = least > 0.0 ? std::min(least, joint.size) : joint.size;
  }
  for (const ElementKind* kind : assembly.model().kinds()) {
    const double size = kind->unstable_size(assembly.field());
    if (size > 0.0) least = least > 0.0 ? std::min(least, size) : size;
  }
  return least;
}

GrowingMotion growing_motion(Assembly& assembly, BlockLU& lu) {
  const Model& model = assembly.model();
  const std::vector<int>& free = assembly.free_nodes();
  const std::size_t n = free.size();
  std::vector<int> place(static_cast<std::size_t>(model.nodes), -1);
  for (std::size_t i = 0; i < n; ++i)
    place[static_cast<std::size_t>(free[i])] = static_cast<int>(i);
  // A first motion that turns every element of three nodes about all its axes.
  std::vector<double> first(3 * n, 0.0);
  std::vector<int> tried;  // free nodes of elements that may be unstable
  auto turn_about = [&](int node, std::size_t k) {
    const int i = place[static_cast<std::size_t>(node)];
    tried.push_back(i);
    const double turn = static_cast<double>(k % 3);
    at(first.data(), i) = Vector(std::cos(1.0 + turn), std::sin(2.0 + 2.0 * turn),
                                 std::cos(3.0 - turn) + 0.1 * static_cast<double>(k / 3));
  };
  const std::vector<PressedJoint> joints = pressed_joints(assembly);
  for (std::size_t k = 0; k < joints.size(); ++k) turn_about(joints[k].node, k);
  for (const ElementKind* kind : model.kinds()) {
    if (kind->unstable_size(assembly.field()) <= 0.0) continue;
    for (std::size_t k = 0; k < kind->nodes().size(); ++k) {
      const int node = kind->nodes()[k];
      if (node >= model.nodes || place[static_cast<std::size_t>(node)] < 0) continue;
      turn_about(node, k);
    }
  }
  GrowingMotion out;
  if (tried.empty()) return out;

  std::vector<double> stiffness(9 * assembly.pattern().column.size()), values, damping(n),
      right(3 * n), y, next(3 * n);
  assembly.jacobian({1.0, 0.0}, stiffness.data());
  assembly.pseudo_damping(damping.data());
  double stiffest = 0.0;
  for (const PressedJoint& joint : joints) stiffest = std::max(stiffest, joint.stiffness);
  for (const ElementKind* kind : model.kinds()) {
    if (kind->unstable_size(assembly.field()) <= 0.0) continue;
    stiffest = std::max(stiffest, kind->unstable_stiffness());
  }
  double shortest = shortest_of_water;
  for (const int i : tried) {
    shortest = std::min(shortest, damping[static_cast<std::size_t>(i)] / stiffest);
  }
  shortest = std::max(shortest, shortest_of_all);
  for (double h = longest_step; h > 0.3 * shortest; h *= 0.1) {
    std::vector<double> per_step(damping);
    for (double& d : per_step) d /= h;
    values = stiffness;
    assembly.add_diagonal(per_step.data(), values.data());
    if (!lu.factorise(values.data())) continue;
    y = first;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double size = 0.0, along = 0.0, grown = 0.0;
      for (std::size_t k = 0; k < 3 * n; ++k) size += y[k] * y[k];
      if (!(size > 0.0)) break;
      for (double& value : y) value /= std::sqrt(size);
      for (std::size_t k = 0; k < 3 * n; ++k) right[k] = per_step[k / 3] * y[k];
      lu.solve_refined(assembly.pattern(), values.data(), right.data(), solve_tolerance,
                       next.data());
      for (std::size_t k = 0; k < 3 * n; ++k) {
        along += y[k] * next[k];
        grown += next[k] * next[k];
      }
      const double off = std::sqrt(std::max(0.0, grown - along * along) / grown);
      y = next;
      if (iteration < least_iterations || off > tolerance) continue;
      if (std::abs(along) > clear_growth) {
        double most = 0.0, most_tried = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          most = std::max(most, at(y.data(), static_cast<int>(i)).norm());
        }
        for (const int i : tried) most_tried = std::max(most_tried, at(y.data(), i).norm());
        const double rate = (1.0 - 1.0 / along) / h;
        if (most_tried > least_share * most && rate > out.rate) {
          out.found = true;
          out.rate = rate;
          out.motion = y;
          for (double& value : out.motion) value /= most_tried;
        }
      }
      break;
    }
  }
  return out;
}

}  // namespace codend
