#include "joined_mass.hpp"

#include <algorithm>

namespace codend {

JoinedMass::JoinedMass(const Assembly& assembly) : assembly_(assembly) {
  const FreePoints free(assembly.model());
  std::vector<ElementPoints> elements;
  for (const ElementKind* kind : assembly.model().kinds()) {
    if (!kind->has_bodies()) continue;
    bodies_.push_back(kind);
    elements.push_back({kind->nodes_per_element(), kind->nodes()});
  }
  pattern_ = pattern_of(free, elements);
  for (const ElementPoints& kind : elements) places_.emplace_back(free, pattern_, kind);
  values_.resize(9 * pattern_.column.size());
  joins_.assign(static_cast<std::size_t>(pattern_.n), 0);
  for (int first = 0; first < pattern_.n; ++first) {
    const auto row = static_cast<std::size_t>(first);
    if (joins_[row] || !assembly.in_body(assembly.free_nodes()[row])) continue;
    Group group;
    group.unknown = {first};
    joins_[row] = 1;
    for (std::size_t k = 0; k < group.unknown.size(); ++k) {
      const auto from = static_cast<std::size_t>(group.unknown[k]);
      for (std::int64_t b = pattern_.row_start[from]; b < pattern_.row_start[from + 1]; ++b) {
        const int other = pattern_.column[static_cast<std::size_t>(b)];
        if (joins_[static_cast<std::size_t>(other)]) continue;
        joins_[static_cast<std::size_t>(other)] = 1;
        group.unknown.push_back(other);
      }
    }
    std::sort(group.unknown.begin(), group.unknown.end());
    groups_.push_back(group);
  }
}

void JoinedMass::update(const double* mass) {
  if (groups_.empty()) return;
  std::fill(values_.begin(), values_.end(), 0.0);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    bodies_[k]->add_body_mass(assembly_.field(), 1.0, places_[k].into(values_.data()));
  }
  for (Group& group : groups_) {
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(group.unknown.size());
    group.mass.setZero(size, size);
    for (Eigen::Index i = 0; i < size / 3; ++i) {
      const int row = group.unknown[static_cast<std::size_t>(i)];
      const std::ptrdiff_t node = assembly_.free_nodes()[static_cast<std::size_t>(row)];
      group.mass.block<3, 3>(3 * i, 3 * i) = Eigen::Map<const Block>(mass + 9 * node);
      for (Eigen::Index j = 0; j < size / 3; ++j) {
        const std::int64_t b =
            find_block(pattern_, row, group.unknown[static_cast<std::size_t>(j)]);
        if (b < 0) continue;
        group.mass.block<3, 3>(3 * i, 3 * j) +=
            Eigen::Map<const Block>(&values_[9 * static_cast<std::size_t>(b)]);
      }
    }
    group.factors.emplace(group.mass);
    group.has_mass = group.factors->info() == Eigen::Success;
  }
}

void JoinedMass::solve(const double* force, double* acceleration) const {
  for (const Group& group : groups_) {
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(group.unknown.size());
    auto node = [&](Eigen::Index i) {
      return assembly_
          .free_nodes()[static_cast<std::size_t>(group.unknown[static_cast<std::size_t>(i)])];
    };
    Eigen::VectorXd values(size);
    for (Eigen::Index i = 0; i < size / 3; ++i) values.segment<3>(3 * i) = at(force, node(i));
    group.factors->solveInPlace(values);
    for (Eigen::Index i = 0; i < size / 3; ++i) {
      at(acceleration, node(i)) = values.segment<3>(3 * i);
    }
  }
}

}  // namespace codend
