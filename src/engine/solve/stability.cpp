#include "stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace codend {
namespace {

// Pseudo time steps over the gear's fall time. The longest detects growth rates from 0.002 per fall
// time. Shorter steps, each by a factor of ten, detect faster growth, down to the time scale of the
// driving forces.
constexpr double longest_step = 10.0, shortest_step = 1e-9;
// Limit of the Krylov basis, and the number of vectors between convergence checks.
constexpr int most_motions = 40, more_motions = 4;
// A search at h detects rates up to this value over h. Rates above 2/h would be missed.
constexpr double searched_by_step = 1.5;
// Relative residual of a converged eigenvector.
constexpr double tolerance = 0.005;
// Minimum eigenvalue of a growing motion. Slack twine, which nothing moves, has 1.
constexpr double clear_growth = 1.02;

// Joint of two bars in compression that only other lines keep in line, such as in a pole of several
// bars without bending stiffness.
struct PressedJoint {
  int node;
  double size;       // of the shorter bar, m
  double stiffness;  // destabilising stiffness, N/m
};

std::vector<PressedJoint> pressed_joints(const Assembly& assembly) {
  const Model& model = assembly.model();
  const LineArrays& a = assembly.lines();
  // Number of compressed struts per node. Other struts, bends and plates exclude a node.
  std::vector<int> met(static_cast<std::size_t>(model.nodes), 0);
  std::vector<PressedJoint> joint(met.size(), {-1, 0.0, 0.0});
  bool any = false;
  for (int b = 0; b < model.bars.count(); ++b) {
    const Line<2> bar = model.bars.line(b);
    if (!model.material(bar).strut) continue;
    const bool pressed = a.strain[b] < 0.0;
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

// Netting under inner pressure. A pinched net that continues behind its own axis has outward
// pressure on both sides of the pinch, and can be in equilibrium.
struct Wall {
  std::vector<int> node;   // nodes of its triangles
  double size = 0.0;       // mean side of the triangles, m; 0: no wall
  double stiffness = 0.0;  // largest destabilising stiffness, N/m
};

Wall wall_of(const Assembly& assembly) {
  const InnerPressure& pressure = assembly.model().pressure;
  const Field field = assembly.field();
  const Vector mean = pressure.mean_velocity(field);
  Wall out;
  for (int e = 0; e < pressure.count(); ++e) {
    const double force = pressure.element_force(e, field, mean).norm();
    if (force == 0.0) continue;
    const int* node = &pressure.node[3 * static_cast<std::size_t>(e)];
    for (int k = 0; k < 3; ++k) {
      const double side =
          (at(field.position, node[k]) - at(field.position, node[(k + 1) % 3])).norm();
      out.size += side;
      if (side > 0.0) out.stiffness = std::max(out.stiffness, force / side);
      out.node.push_back(node[k]);
    }
  }
  if (!out.node.empty()) out.size /= static_cast<double>(out.node.size());
  return out;
}

// Eigenvalue of largest magnitude of a matrix that is given by its products (W. E. Arnoldi,
// Quarterly of Applied Mathematics 9, 1951), in the Krylov space of a first vector.
struct LargestEigenvalue {
  bool found = false;  // the eigenvalue is real and has converged
  double value = 0.0;
  Eigen::VectorXd vector;  // of length 1
};

// apply(from, to): 3n numbers each.
template <class Apply>
LargestEigenvalue largest_eigenvalue(const std::vector<double>& first, Apply apply) {
  LargestEigenvalue out;
  const Eigen::Index size = static_cast<Eigen::Index>(first.size());
  const int most = static_cast<int>(std::min<Eigen::Index>(most_motions, size));
  Eigen::MatrixXd basis(size, most + 1);
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  basis.col(0) = Eigen::Map<const Eigen::VectorXd>(first.data(), size).normalized();
  for (int m = 0; m < most; ++m) {
    auto next = basis.col(m + 1);
    apply(basis.col(m).data(), next.data());
    for (int twice = 0; twice < 2; ++twice) {  // once is inaccurate due to rounding
      const Eigen::VectorXd along = basis.leftCols(m + 1).transpose() * next;
      next.noalias() -= basis.leftCols(m + 1) * along;
      hessenberg.col(m).head(m + 1) += along;
    }
    const double left = next.norm();
    hessenberg(m + 1, m) = left;
    if (left > 0.0) next /= left;
    const int known = m + 1;
    if (known % more_motions != 0 && known != most && left > 0.0) continue;
    const Eigen::EigenSolver<Eigen::MatrixXd> small(hessenberg.topLeftCorner(known, known));
    if (small.info() != Eigen::Success) return out;
    Eigen::Index k;
    small.eigenvalues().cwiseAbs().maxCoeff(&k);
    const std::complex<double> value = small.eigenvalues()[k];
    const double off = left * std::abs(small.eigenvectors()(m, k));
    const bool none = std::abs(value) + off < clear_growth;
    if (none || off < tolerance * std::abs(value) || left == 0.0) {
      // Rounding makes equal real eigenvalues a complex pair.
      out.found = !none && std::abs(value.imag()) < tolerance * std::abs(value);
      out.value = value.real();
      if (out.found) {
        out.vector = basis.leftCols(known) * small.eigenvectors().col(k).real();
        out.vector.normalize();
      }
      return out;
    }
  }
  return out;
}

// True if no motion grows faster than a rate, by the symmetric part of K + rate D.
bool none_grows_faster(const Assembly& assembly, const std::vector<double>& stiffness,
                       const std::vector<double>& damping, double rate, BlockLU& lu,
                       std::vector<double>& values) {
  const std::vector<int64_t> mirror = mirror_entries(assembly.pattern());
  for (std::size_t e = 0; e < mirror.size(); ++e) {
    const double* block = &stiffness[9 * e];
    const double* mirrored = &stiffness[9 * static_cast<std::size_t>(mirror[e])];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        values[9 * e + 3 * i + j] = 0.5 * (block[3 * i + j] + mirrored[3 * j + i]);
      }
    }
  }
  std::vector<double> shift(damping);
  for (double& d : shift) d *= rate;
  assembly.add_diagonal(shift.data(), values.data());
  return lu.factorise_definite(values.data());
}

}  // namespace

double unstable_size(const Assembly& assembly, bool walls) {
  double least = walls ? wall_of(assembly).size : 0.0;
  for (const PressedJoint& joint : pressed_joints(assembly)) {
    least = least > 0.0 ? std::min(least, joint.size) : joint.size;
  }
  for (const ElementKind* kind : assembly.model().kinds()) {
    const double size = kind->unstable_size(assembly.field());
    if (size > 0.0) least = least > 0.0 ? std::min(least, size) : size;
  }
  return least;
}

GrowingMotion growing_motion(Assembly& assembly, double time, BlockLU& lu) {
  const Model& model = assembly.model();
  const std::vector<int>& free = assembly.free_nodes();
  const std::size_t n = free.size();
  std::vector<int> place(static_cast<std::size_t>(model.nodes), -1);
  for (std::size_t i = 0; i < n; ++i)
    place[static_cast<std::size_t>(free[i])] = static_cast<int>(i);
  // Initial motion that rotates every element of three nodes about all its axes.
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
  const Wall wall = wall_of(assembly);
  for (std::size_t k = 0; k < wall.node.size(); ++k) {
    const int node = wall.node[k];
    if (node < model.nodes && place[static_cast<std::size_t>(node)] >= 0) turn_about(node, k);
  }
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

  std::vector<double> stiffness(9 * assembly.pattern().column.size()), values(stiffness.size()),
      damping(n), right(3 * n);
  assembly.jacobian({1.0, 0.0}, stiffness.data());
  assembly.pseudo_damping(time, damping.data());
  double stiffest = wall.stiffness;
  for (const PressedJoint& joint : joints) stiffest = std::max(stiffest, joint.stiffness);
  for (const ElementKind* kind : model.kinds()) {
    if (kind->unstable_size(assembly.field()) <= 0.0) continue;
    stiffest = std::max(stiffest, kind->unstable_stiffness());
  }
  double shortest = longest_step;
  for (const int i : tried) {
    shortest = std::min(shortest, damping[static_cast<std::size_t>(i)] / stiffest);
  }
  shortest = std::max(shortest, shortest_step);
  double searched = (1.0 - 1.0 / clear_growth) / longest_step;  // covered rates
  for (double h = longest_step; h > 0.3 * shortest; searched = searched_by_step / h, h *= 0.1) {
    ++out.factorisations;
    if (none_grows_faster(assembly, stiffness, damping, searched, lu, values)) break;
    std::vector<double> per_step(damping);
    for (double& d : per_step) d /= h;
    values = stiffness;
    assembly.add_diagonal(per_step.data(), values.data());
    ++out.factorisations;
    if (!lu.factorise(values.data())) continue;
    const LargestEigenvalue largest = largest_eigenvalue(first, [&](const double* y, double* next) {
      for (std::size_t k = 0; k < 3 * n; ++k) right[k] = per_step[k / 3] * y[k];
      lu.solve_refined(assembly.pattern(), values.data(), right.data(), tolerance, next);
    });
    if (!largest.found || std::abs(largest.value) <= clear_growth) continue;
    const double* y = largest.vector.data();
    double most_tried = 0.0;
    for (const int i : tried) most_tried = std::max(most_tried, at(y, i).norm());
    const double rate = (1.0 - 1.0 / largest.value) / h;
    if (most_tried > 0.0 && rate > out.rate) {
      out.found = true;
      out.rate = rate;
      out.motion.assign(y, y + 3 * n);
      for (double& value : out.motion) value /= most_tried;
    }
  }
  return out;
}

}  // namespace codend
