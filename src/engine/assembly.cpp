#include "assembly.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace codend {
namespace {

// A point as weighted unknowns: itself, or the free ones among the two nodes that it is tied to.
struct Share {
  int unknown;
  double weight;
};

void shares_of(const Model& model, const std::vector<int>& unknown, int point,
               std::vector<Share>& out) {
  out.clear();
  if (point < model.nodes) {
    if (unknown[point] >= 0) out.push_back({unknown[point], 1.0});
    return;
  }
  const Tie& tie = model.ties[point - model.nodes];
  if (unknown[tie.first] >= 0) out.push_back({unknown[tie.first], 1.0 - tie.share});
  if (unknown[tie.second] >= 0) out.push_back({unknown[tie.second], tie.share});
}

}  // namespace

// Sends the blocks of one kind to their places. A slot >= 0 is a block; -1 goes nowhere (a held
// node); -2 - k is the k-th list of weighted blocks (a tied point).
class Assembly::Sink : public BlockSink {
 public:
  Sink(const Model& model, const std::vector<int>& unknown, const BlockPattern& pattern,
       const ElementKind& kind)
      : width_(kind.nodes_per_element()) {
    const std::vector<int>& nodes = kind.nodes();
    const std::size_t elements = nodes.size() / width_;
    slots_.reserve(elements * width_ * width_);
    std::vector<Share> rows, columns;
    for (std::size_t e = 0; e < elements; ++e) {
      for (int a = 0; a < width_; ++a) {
        shares_of(model, unknown, nodes[e * width_ + a], rows);
        for (int b = 0; b < width_; ++b) {
          shares_of(model, unknown, nodes[e * width_ + b], columns);
          if (rows.empty() || columns.empty()) {
            slots_.push_back(-1);
          } else if (rows.size() == 1 && columns.size() == 1 && rows[0].weight == 1.0 &&
                     columns[0].weight == 1.0) {
            slots_.push_back(static_cast<int>(
                find_block(pattern, rows[0].unknown, columns[0].unknown)));
          } else {
            slots_.push_back(-2 - static_cast<int>(list_start_.size()));
            list_start_.push_back(weighted_.size());
            for (const Share& r : rows) {
              for (const Share& c : columns) {
                weighted_.push_back({static_cast<int>(find_block(pattern, r.unknown, c.unknown)),
                                     r.weight * c.weight});
              }
            }
          }
        }
      }
    }
    list_start_.push_back(weighted_.size());
  }

  void into(double* values) { values_ = values; }

  void add(int element, int a, int b, const Matrix& block) override {
    const int slot = slots_[(static_cast<std::size_t>(element) * width_ + a) * width_ + b];
    if (slot >= 0) {
      place(slot) += block;
    } else if (slot <= -2) {
      const std::size_t list = static_cast<std::size_t>(-2 - slot);
      for (std::size_t k = list_start_[list]; k < list_start_[list + 1]; ++k) {
        place(weighted_[k].unknown) += weighted_[k].weight * block;
      }
    }
  }

 private:
  Eigen::Map<Block> place(int slot) {
    return Eigen::Map<Block>(values_ + 9 * static_cast<std::ptrdiff_t>(slot));
  }

  int width_;
  std::vector<int> slots_;
  std::vector<std::size_t> list_start_;
  std::vector<Share> weighted_;  // `unknown` is a block here
  double* values_ = nullptr;
};

Assembly::Assembly(const Model& model)
    : model_(model),
      unknown_(model.nodes, -1),
      position_(3 * model.points()),
      velocity_(3 * model.points()),
      force_(3 * model.points()),
      change_(3 * model.points()),
      masses_(9 * static_cast<std::size_t>(model.points())),
      scale_(model.points()) {
  for (int n = 0; n < model.nodes; ++n) {
    if (model.held[n]) continue;
    unknown_[n] = static_cast<int>(free_.size());
    free_.push_back(n);
  }
  const int n = unknowns();
  std::vector<std::vector<int>> neighbours(n);
  std::vector<Share> rows, columns;
  for (const ElementKind* kind : model.kinds()) {
    const int width = kind->nodes_per_element();
    const std::vector<int>& nodes = kind->nodes();
    for (std::size_t e = 0; e + width <= nodes.size(); e += width) {
      for (int a = 0; a < width; ++a) {
        shares_of(model, unknown_, nodes[e + a], rows);
        for (int b = 0; b < width; ++b) {
          shares_of(model, unknown_, nodes[e + b], columns);
          for (const Share& r : rows) {
            for (const Share& c : columns) neighbours[r.unknown].push_back(c.unknown);
          }
        }
      }
    }
  }
  pattern_ = block_pattern(std::move(neighbours));
  for (int i = 0; i < n; ++i) diagonal_.push_back(find_block(pattern_, i, i));
  for (const ElementKind* kind : model.kinds()) {
    sinks_.push_back(std::make_unique<Sink>(model, unknown_, pattern_, *kind));
  }
}

Assembly::~Assembly() = default;

void Assembly::spread(const double* nodes, std::vector<double>& points) const {
  std::copy(nodes, nodes + 3 * static_cast<std::ptrdiff_t>(model_.nodes), points.begin());
  for (std::size_t t = 0; t < model_.ties.size(); ++t) {
    const Tie& tie = model_.ties[t];
    at(points.data(), model_.nodes + static_cast<int>(t)) =
        (1.0 - tie.share) * at(nodes, tie.first) + tie.share * at(nodes, tie.second);
  }
}

void Assembly::hand_on(double* values, int width) const {
  for (std::size_t t = 0; t < model_.ties.size(); ++t) {
    const Tie& tie = model_.ties[t];
    const double* from = values + width * (model_.nodes + static_cast<std::ptrdiff_t>(t));
    double* first = values + width * static_cast<std::ptrdiff_t>(tie.first);
    double* second = values + width * static_cast<std::ptrdiff_t>(tie.second);
    for (int k = 0; k < width; ++k) {
      first[k] += (1.0 - tie.share) * from[k];
      second[k] += tie.share * from[k];
    }
  }
}

Field Assembly::field(const double* x, const double* v) {
  spread(x, position_);
  spread(v, velocity_);
  return {position_.data(), velocity_.data(), &model_.water, model_.slack};
}

void Assembly::residual(const double* x, const double* v, double* force,
                        const CarriedTension* carried) {
  Field where = field(x, v);
  if (carried) where.tension = carried->tension.data();
  std::copy(model_.load.begin(), model_.load.end(), force_.begin());
  for (const ElementKind* kind : model_.kinds()) kind->add_force(where, force_.data());
  hand_on(force_.data(), 3);
  std::copy(force_.begin(), force_.begin() + 3 * static_cast<std::ptrdiff_t>(model_.nodes), force);
}

void Assembly::jacobian(const double* x, const double* v, const JacobianRequest& request,
                        double* values, const CarriedTension* carried) {
  Field where = field(x, v);
  if (carried) {
    where.tension = carried->tension.data();
    where.modulus = carried->modulus.data();
  }
  std::fill(values, values + 9 * pattern_.column.size(), 0.0);
  const std::vector<const ElementKind*> kinds = model_.kinds();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    sinks_[k]->into(values);
    kinds[k]->add_jacobian(where, request, *sinks_[k]);
  }
}

void Assembly::add_diagonal(const double* numbers, double* values) const {
  for (int i = 0; i < unknowns(); ++i) {
    double* block = values + 9 * diagonal_[i];
    for (int k = 0; k < 3; ++k) block[4 * k] += numbers[i];
  }
}

void Assembly::mass(const double* x, const double* v, double* mass) {
  const Field where = field(x, v);
  std::fill(masses_.begin(), masses_.end(), 0.0);
  for (int p = 0; p < model_.points(); ++p) {
    for (int k = 0; k < 3; ++k) masses_[9 * static_cast<std::size_t>(p) + 4 * k] = model_.mass[p];
  }
  for (const ElementKind* kind : model_.kinds()) kind->add_added_mass(where, masses_.data());
  hand_on(masses_.data(), 9);
  std::copy(masses_.begin(), masses_.begin() + 9 * static_cast<std::ptrdiff_t>(model_.nodes), mass);
}

void Assembly::pseudo_damping(const double* x, const double* v, double* damping) {
  const Field where = field(x, v);
  for (int p = 0; p < model_.points(); ++p) scale_[p] = model_.mass[p];
  for (const ElementKind* kind : model_.kinds()) kind->add_drag_scale(where, scale_.data());
  hand_on(scale_.data(), 1);
  for (int i = 0; i < unknowns(); ++i) damping[i] = scale_[free_[i]];
}

double Assembly::largest_rotation(const double* dx) {
  spread(dx, change_);
  double largest = 0.0;
  model_.each_line([&](const auto& line) {
    largest = std::max(largest, line.vector(change_.data()).norm() / line.rest);
  });
  return largest;
}

double Assembly::largest_tension(const double* x) {
  spread(x, position_);
  double largest = 0.0;
  for (int b = 0; b < model_.bars.count(); ++b) {
    const Line<2> line = model_.bars.line(b);
    const double length = line.vector(position_.data()).norm();
    largest = std::max(largest,
                       line.multiplicity * twine_tension(*line.material, length, line.rest));
  }
  if (model_.bars.count() > 0) return largest;
  for (int e = 0; e < model_.triangles.count(); ++e) {
    for (const Line<3>& line : {model_.triangles.u_line(e), model_.triangles.v_line(e)}) {
      const double length = line.vector(position_.data()).norm();
      largest = std::max(largest, twine_tension(*line.material, length, line.rest));
    }
  }
  return largest;
}

void Assembly::strain(const double* x, std::vector<double>& values) {
  spread(x, position_);
  values.resize(model_.lines());
  model_.each_line([&](const auto& line) {
    values[line.index] = line.vector(position_.data()).norm() / line.rest - 1.0;
  });
}

void Assembly::strain_change(const double* x, const double* dx, std::vector<double>& values) {
  spread(x, position_);
  spread(dx, change_);
  values.resize(model_.lines());
  model_.each_line([&](const auto& line) {
    const Vector e = line.vector(position_.data());
    const double length = e.norm();
    values[line.index] =
        length > 0.0 ? e.dot(line.vector(change_.data())) / (length * line.rest) : 0.0;
  });
}

}  // namespace codend
