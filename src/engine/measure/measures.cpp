#include "measures.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace codend {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Fraction of the netting's twine with the highest tension.
constexpr double loaded_most = 0.1;

// Piecewise linear interpolation; constant beyond the ends.
template <class T>
T between(const std::vector<double>& at, const std::vector<double>& values, T x) {
  const double here = value_of(x);
  if (here <= at.front()) return T(values.front());
  if (here >= at.back()) return T(values.back());
  std::size_t k = 1;
  while (at[k] < here) ++k;
  return T(values[k - 1]) +
         T(values[k] - values[k - 1]) * ((x - T(at[k - 1])) / T(at[k] - at[k - 1]));
}

bool has(const std::vector<int>& all, int one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

// Integral of z n_z over a triangle: mean height times the horizontally projected area.
template <class T>
T upward_moment(const Three<T>& a, const Three<T>& b, const Three<T>& c) {
  const T area = ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / T(2.0);
  return area * (a.z + b.z + c.z) / T(3.0);
}

template <class T>
class Measuring {
 public:
  Measuring(const MeasureFrame& frame, const Model& model, const Questions& asked,
            const FilledBag* bag, const MeasuredShape<T>& shape)
      : frame_(frame),
        model_(model),
        asked_(asked),
        bag_(bag),
        shape_(shape),
        points_(all_points(model, shape.position)),
        flow_(flow_axis(model, asked)),
        across_{-flow_.y, flow_.x, 0.0} {
    drag_ = T(0.0);
    for (const int node : frame.supports) drag_ += along(three(shape.force, node), flow_);
  }

  T operator()(const AskedMeasure& of) {
    using std::abs;
    switch (of.kind) {
      case MeasureKind::spread:
        return mean_of_pairs(of.places, [](const Three<T>& d) {
          return length_of(Three<T>{d.x, d.y, T(0.0)});
        });
      case MeasureKind::height:
        return -first_pair(of).z;
      case MeasureKind::length:
        return length_of(first_pair(of));
      case MeasureKind::depth:
        return depth(of.places);
      case MeasureKind::sinking_speed:
        return -velocity(of.places[0]).z + T(0.0);
      case MeasureKind::clearance:
        return along(place(of.places[0]), normal()) - T(model_.ground.height);
      case MeasureKind::area:
        return size_of(mouth_area(of.ropes));
      case MeasureKind::enclosed_area:
        return area_from_above(of.ropes);
      case MeasureKind::ground_speed: {
        const Three<T> v = velocity(of.places[0]);
        return size_of({v.x - T(asked_.speed), v.y});
      }
      case MeasureKind::angle:
        return angle(of);
      case MeasureKind::attitude:
        return (of.angle == MeasureAngle::attack ? shape_.attack
                : of.angle == MeasureAngle::heel ? shape_.heel
                                                 : shape_.trim)[of.plates[0]];
      case MeasureKind::tension:
        return tension(of);
      case MeasureKind::drag:
        return force_on(of.parts, flow_);
      case MeasureKind::lift:
        return force_on(of.parts, {0.0, 0.0, 1.0});
      case MeasureKind::mesh_opening:
        return mean_of_meshes(of.panels, &MeshPlace<T>::opening);
      case MeasureKind::mesh_angle:
        return mean_of_meshes(of.panels, &MeshPlace<T>::angle);
      case MeasureKind::volume:
        return volume_within(of.panels);
      case MeasureKind::volume_fraction:
        return volume_within(of.panels) / T(of.of);
      case MeasureKind::enclosed_volume:
        return enclosed_volume(of.ropes[0]);
      default:
        return of_every_gear(of.kind);
    }
  }

 private:
  T of_every_gear(MeasureKind kind) {
    const bool towed = asked_.speed != 0;
    const bool pulled = towed && asked_.has_propulsion;
    switch (kind) {
      case MeasureKind::total_drag:
        return drag_;
      case MeasureKind::tow_power:
        return towed ? drag_ * T(asked_.speed) : T(none);
      case MeasureKind::filtered_volume:
        return filtered_volume();
      case MeasureKind::swept_area:
        return swept_area();
      case MeasureKind::mouth_blockage:
        if (frame_.panel_count == 0) return T(none);
        return twine_shadow(frame_.meshes, meshes(), across_, {0.0, 0.0, 1.0}) / mouth_areas();
      case MeasureKind::engine_power:
        return pulled ? power() : T(none);
      case MeasureKind::pull_used:
        return pulled ? pull_share() : T(none);
      case MeasureKind::fuel_rate:
        return fuel();
      case MeasureKind::fuel_per_swept_area:
        return fuel_per(swept_area());
      case MeasureKind::fuel_per_filtered_volume:
        return fuel_per(filtered_volume());
      case MeasureKind::fuel_per_catch:
        return fuel_per(T(asked_.propulsion.yield));
      case MeasureKind::catch_volume:
        return bag_ ? bag_volume(*bag_, points_) : T(none);
      case MeasureKind::catch_surface:
        return bag_ ? bag_surface(*bag_, points_) : T(none);
      case MeasureKind::catch_front:
        return T(bag_ ? bag_->blocked : none);
      case MeasureKind::largest_rope_tension:
        return largest_tension([&](int part) { return part < ropes(); });
      case MeasureKind::largest_panel_twine_tension:
        return largest_panel_tension();
      case MeasureKind::most_loaded_twine_tension:
        return most_loaded_tension();
      case MeasureKind::slack_netting:
        return slack();
      case MeasureKind::rope_on_ground:
        return model_.ground.present ? T(rope_on_ground()) : T(none);
      case MeasureKind::ground_load:
        return model_.ground.present ? along(ground_force(), normal()) : T(none);
      case MeasureKind::ground_friction:
        // A gear at rest in still water has no drag.
        if (!model_.ground.present || value_of(drag_) == 0.0) return T(none);
        return along(ground_force(), flow_) / drag_;
      case MeasureKind::least_depth:
      case MeasureKind::greatest_depth: {
        T depth = -shape_.position[2];
        for (std::size_t k = 2; k < shape_.position.size(); k += 3) {
          const T here = -shape_.position[k];
          if (kind == MeasureKind::least_depth ? here < depth : here > depth) depth = here;
        }
        // Avoids -0 for a node at the surface.
        return depth + T(0.0);
      }
      default:
        return T(none);
    }
  }

  static T along(const Three<T>& x, const Three<double>& axis) {
    return x.x * T(axis.x) + x.y * T(axis.y) + x.z * T(axis.z);
  }
  Three<double> normal() const {
    const Vector& n = model_.ground.normal;
    return {n.x(), n.y(), n.z()};
  }
  Three<T> at_place(const std::vector<T>& x, int number) const {
    const Three<T> at = three(x, frame_.places[number]);
    const double weight = frame_.next_weights[number];
    if (weight == 0) return at;
    return at + (three(x, frame_.next_places[number]) - at) * T(weight);
  }
  Three<T> place(int number) const { return at_place(shape_.position, number); }
  Three<T> velocity(int number) const { return at_place(shape_.velocity, number); }
  int ropes() const { return static_cast<int>(frame_.ropes.size()); }
  bool of_netting(int part) const { return part >= ropes() && part < ropes() + frame_.panel_count; }

  const std::vector<MeshPlace<T>>& meshes() {
    if (meshes_.empty()) meshes_ = mesh_places(frame_.meshes, points_);
    return meshes_;
  }

  // ---- positions ------------------------------------------------------------------------------

  Three<T> first_pair(const AskedMeasure& of) const {
    return place(of.places[1]) - place(of.places[0]);
  }
  template <class Of>
  T mean_of_pairs(const std::vector<int>& places, Of value) const {
    T sum{};
    for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
      sum += value(place(places[k + 1]) - place(places[k]));
    }
    return sum / T(static_cast<double>(places.size() / 2));
  }
  T depth(const std::vector<int>& places) const {
    T sum{};
    for (const int one : places) sum += place(one).z;
    return -(sum / T(static_cast<double>(places.size())));
  }

  // Nodes along ropes joined end to end. Each rope continues from the end of the previous one,
  // starting at its nearer end. Straight lines close gaps.
  std::vector<int> outline(const std::vector<int>& of) const {
    std::vector<std::vector<int>> left;
    for (const int rope : of) left.push_back(frame_.ropes[rope].node);
    const auto gap = [&](int a, int b) {
      const Three<T> d = three(shape_.position, a) - three(shape_.position, b);
      return value_of(dot(d, d));
    };
    const auto nearest = [&](int end) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::vector<int>& rope : left) {
        least = std::min({least, gap(end, rope.front()), gap(end, rope.back())});
      }
      return least;
    };
    std::vector<int> out = left.front();
    left.erase(left.begin());
    if (!left.empty() && nearest(out.front()) < nearest(out.back())) {
      std::reverse(out.begin(), out.end());
    }
    while (!left.empty()) {
      std::size_t next = 0;
      bool turned = false;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < left.size(); ++k) {
        for (const bool last : {false, true}) {
          const double here = gap(out.back(), last ? left[k].back() : left[k].front());
          if (here < least) {
            least = here;
            next = k;
            turned = last;
          }
        }
      }
      if (turned) std::reverse(left[next].begin(), left[next].end());
      out.insert(out.end(), left[next].begin(), left[next].end());
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
    }
    return out;
  }

  // Vector area of ropes: components along x and y, m2, signed.
  std::array<T, 2> mouth_area(const std::vector<int>& of) const {
    const std::vector<int> nodes = outline(of);
    T ahead{}, side{};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Three<T> p = three(shape_.position, nodes[k]);
      const Three<T> q = three(shape_.position, nodes[(k + 1) % nodes.size()]);
      ahead += p.y * q.z - q.y * p.z;
      side += p.z * q.x - q.z * p.x;
    }
    return {ahead / T(2.0), side / T(2.0)};
  }
  static T size_of(const std::array<T, 2>& level) {
    return length_of(Three<T>{level[0], level[1], T(0.0)});
  }

  // Area within ropes projected on the horizontal plane, m2.
  T area_from_above(const std::vector<int>& of) const {
    using std::abs;
    const std::vector<int> nodes = outline(of);
    T twice{};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Three<T> p = three(shape_.position, nodes[k]);
      const Three<T> q = three(shape_.position, nodes[(k + 1) % nodes.size()]);
      twice += p.x * q.y - q.x * p.y;
    }
    return abs(twice) / T(2.0);
  }

  // Sum of a quantity over the nets with known parts of a role; none without such a net.
  template <class Quantity>
  T sum_of_nets(std::vector<int> NetRoles::*role, Quantity quantity) const {
    T sum(none);
    for (const NetRoles& net : asked_.nets) {
      const std::vector<int>& of = net.*role;
      if (of.empty()) continue;
      const T own = quantity(of);
      sum = std::isnan(value_of(sum)) ? own : sum + own;
    }
    return sum;
  }
  T mouth_areas() const {
    return sum_of_nets(&NetRoles::mouth,
                       [&](const std::vector<int>& ropes) { return size_of(mouth_area(ropes)); });
  }

  // Horizontal volume flow (m3/s) through the mouths of a towed gear.
  T filtered_volume() const {
    if (asked_.speed == 0) return T(none);
    return sum_of_nets(&NetRoles::mouth,
                       [&](const std::vector<int>& ropes) { return filtered_by(ropes); });
  }
  // The same through the moving ropes around one mouth.
  T filtered_by(const std::vector<int>& ropes) const {
    using std::abs;
    const std::vector<int> nodes = outline(ropes);
    T z{};
    for (const int node : nodes) z += three(shape_.position, node).z;
    const T depth = -(z / T(static_cast<double>(nodes.size())));
    const Water& water = model_.water;
    std::vector<double> x, y;
    for (const Vector& current : water.current) {
      x.push_back(current.x());
      y.push_back(current.y());
    }
    T past_x = between(water.depth, x, depth), past_y = between(water.depth, y, depth);
    const std::set<int> own(nodes.begin(), nodes.end());
    const T share(1.0 / static_cast<double>(own.size()));
    for (const int node : own) {
      past_x -= three(shape_.velocity, node).x * share;
      past_y -= three(shape_.velocity, node).y * share;
    }
    const std::array<T, 2> area = mouth_area(ropes);
    return abs(area[0] * past_x + area[1] * past_y);
  }

  // Area per time (m2/s) swept by the nets of a towed gear.
  T swept_area() const {
    if (asked_.speed == 0) return T(none);
    return sum_of_nets(&NetRoles::wings,
                       [&](const std::vector<int>& places) { return swept_by(places); });
  }
  // Mean area per time (m2/s) swept by the lines between pairs of locations of one net.
  T swept_by(const std::vector<int>& places) const {
    using std::abs;
    T sum{};
    for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
      const Three<T> across = place(places[k + 1]) - place(places[k]);
      const Three<T> v = (velocity(places[k]) + velocity(places[k + 1])) * T(0.5);
      sum += abs(across.x * v.y - across.y * (v.x - T(asked_.speed)));
    }
    return sum / T(static_cast<double>(places.size() / 2));
  }

  // ---- propulsion -----------------------------------------------------------------------------

  T pull_share() const {
    const Propulsion& p = asked_.propulsion;
    double pull = between(p.speed, p.pull, asked_.speed);
    const std::size_t n = p.speed.size();
    if (asked_.speed > p.speed[n - 1]) {
      const double slope = (p.pull[n - 1] - p.pull[n - 2]) / (p.speed[n - 1] - p.speed[n - 2]);
      pull = std::max(0.0, p.pull[n - 1] + slope * (asked_.speed - p.speed[n - 1]));
    }
    return (value_of(drag_) > 0 ? drag_ : T(0.0)) / T(pull);
  }
  T power() const {
    using std::sqrt;
    const T share = pull_share();
    return T(asked_.propulsion.power) * share * sqrt(share);
  }
  T fuel() const {
    const Propulsion& p = asked_.propulsion;
    if (asked_.speed == 0 || !asked_.has_propulsion || p.consumption.empty()) return T(none);
    const T of = power();
    if (!std::isfinite(value_of(of))) return T(none);
    return of * between(p.load, p.consumption, of / T(p.power)) / T(p.fuel_density);
  }
  T fuel_per(T what) const { return value_of(what) == 0.0 ? T(none) : fuel() / what; }

  // ---- ropes ----------------------------------------------------------------------------------

  // Returns the bar of a rope at its start, middle or end.
  int bar_at(int rope, MeasureAt at) const {
    int first = -1, last = -1;
    double whole = 0.0;
    const std::vector<int>& part = frame_.part.bars;
    for (int b = 0; b < static_cast<int>(part.size()); ++b) {
      if (part[b] != rope) continue;
      if (first < 0) first = b;
      last = b;
      whole += model_.bars.rest[b];
    }
    if (at != MeasureAt::middle) return at == MeasureAt::start ? first : last;
    double reached = 0.0;
    for (int b = first; b < last; ++b) {
      if (part[b] != rope) continue;
      reached += model_.bars.rest[b];
      if (reached >= whole / 2) return b;
    }
    return last;
  }
  // Returns the mean angle of the ropes.
  T angle(const AskedMeasure& of) const {
    T sum(0.0);
    for (const int rope : of.ropes) sum += rope_angle(rope, of);
    return sum / T(static_cast<double>(of.ropes.size()));
  }
  T rope_angle(int rope, const AskedMeasure& of) const {
    using std::abs;
    using std::atan2;
    using std::sqrt;
    const std::size_t bar = static_cast<std::size_t>(bar_at(rope, of.at));
    const Three<T> d =
        three(points_, model_.bars.node[2 * bar + 1]) - three(points_, model_.bars.node[2 * bar]);
    if (of.angle == MeasureAngle::divergence) return atan2(abs(along(d, across_)), along(d, flow_));
    return atan2(-d.z, sqrt(d.x * d.x + d.y * d.y));
  }
  T tension(const AskedMeasure& of) const {
    const int rope = of.ropes[0];
    if (of.at == MeasureAt::max) return largest_tension([&](int part) { return part == rope; });
    const int bar = bar_at(rope, of.at);
    if (of.at == MeasureAt::middle) return shape_.bar_tension[bar];
    return end_tensions(frame_, model_, shape_, bar)[of.at == MeasureAt::start ? 0 : 1];
  }
  template <class Which>
  T largest_tension(Which which) const {
    T most(none);
    for (int b = 0; b < static_cast<int>(frame_.part.bars.size()); ++b) {
      if (!which(frame_.part.bars[b])) continue;
      for (const T& end : end_tensions(frame_, model_, shape_, b)) {
        if (!(value_of(end) <= value_of(most))) most = end;
      }
    }
    return most;
  }

  // ---- forces ---------------------------------------------------------------------------------

  T force_on(const std::vector<int>& parts, const Three<double>& axis) {
    if (forces_.empty()) forces_ = part_forces(frame_, shape_);
    T sum{};
    for (int part = 0; part < frame_.parts; ++part) {
      if (has(parts, part)) sum += along(three(forces_, part), axis);
    }
    return sum;
  }
  const std::vector<T>& reported(const char* name) const {
    const std::vector<ReportedForce>& all = reported_forces();
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (std::string(all[k].name) == name) return shape_.forces[k];
    }
    throw InputError(name, std::string("no reported force is called ") + name);
  }
  Three<T> ground_force() const {
    Three<T> total;
    const std::vector<ReportedForce>& all = reported_forces();
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].cause != Cause::ground) continue;
      for (std::size_t e = 0; 3 * e < shape_.forces[k].size(); ++e) {
        total = total + three(shape_.forces[k], static_cast<int>(e));
      }
    }
    return total;
  }
  // Length of ropes with nodes in contact with the ground (m), without poles.
  double rope_on_ground() const {
    const std::vector<T>& contact = reported("contact_force");
    std::vector<char> touches(points_.size() / 3, 0);
    for (std::size_t k = 0; k < contact.size(); ++k) {
      if (value_of(contact[k]) != 0.0) touches[model_.contacts.node[k / 3]] = 1;
    }
    double length = 0.0;
    for (std::size_t b = 0; b < frame_.part.bars.size(); ++b) {
      const int part = frame_.part.bars[b];
      if (part >= ropes() || frame_.ropes[part].strut) continue;
      length += model_.bars.rest[b] *
                (touches[model_.bars.node[2 * b]] + touches[model_.bars.node[2 * b + 1]]) / 2.0;
    }
    return length;
  }

  // ---- netting --------------------------------------------------------------------------------

  // Calls visit(tension of one line, length of all lines, part) for every line of netting.
  template <class Visit>
  void each_twine(Visit visit) const {
    for (std::size_t b = 0; b < frame_.part.bars.size(); ++b) {
      const int part = frame_.part.bars[b];
      if (of_netting(part)) {
        visit(shape_.bar_tension[b], model_.bars.multiplicity[b] * model_.bars.rest[b], part);
      }
    }
    const CellFrame& cells = frame_.cells;
    for (const std::vector<T>* tension : {&shape_.u_tension, &shape_.v_tension}) {
      for (std::size_t c = 0; c < cells.rest.size(); ++c) {
        visit((*tension)[c], cells.bars[c] * cells.rest[c], frame_.part.cells[c]);
      }
    }
    for (std::size_t c = 0; c < cells.rest.size(); ++c) {
      if (!(cells.straight[c] > 0)) continue;
      visit(shape_.straight_tension[c], cells.bars[c] * cells.straight[c], frame_.part.cells[c]);
    }
  }
  T largest_panel_tension() const {
    std::map<int, std::pair<T, double>> sums;
    each_twine([&](const T& tension, double length, int part) {
      sums[part].first += tension * T(length);
      sums[part].second += length;
    });
    T most(none);
    for (const auto& [part, sum] : sums) {
      const T mean = sum.first / T(sum.second);
      if (!(value_of(mean) <= value_of(most))) most = mean;
    }
    return most;
  }
  // Mean tension over the fraction of twine with the highest tension.
  T most_loaded_tension() const {
    std::vector<std::pair<T, double>> lines;
    double whole = 0.0;
    each_twine([&](const T& tension, double length, int) {
      lines.push_back({tension, length});
      whole += length;
    });
    if (lines.empty()) return T(none);
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    const double most = loaded_most * whole;
    double reached = 0.0;
    T sum{};
    for (const auto& [tension, length] : lines) {
      if (reached >= most) break;
      sum += tension * T(std::min(length, most - reached));
      reached += length;
    }
    return sum / T(most);
  }
  T slack() const {
    double loose = 0.0, whole = 0.0;
    each_twine([&](const T& tension, double length, int) {
      if (value_of(tension) == 0.0) loose += length;
      whole += length;
    });
    return T(whole > 0 ? loose / whole : none);
  }
  T mean_of_meshes(const std::vector<int>& panels, T MeshPlace<T>::*field) {
    T sum{};
    double all = 0.0;
    for (int k = 0; k < frame_.meshes.count(); ++k) {
      const double meshes_here = frame_.meshes.meshes[k];
      if (!has(panels, frame_.meshes.panel(k)) || !(meshes_here > 0)) continue;
      const T& value = meshes()[k].*field;
      if (std::isnan(value_of(value))) continue;
      sum += value * T(meshes_here);
      all += meshes_here;
    }
    return sum / T(all);
  }

  // ---- volumes --------------------------------------------------------------------------------

  // Two nodes on the rim of a lid, and the opening that it closes. Edges that are neither joined to
  // another panel of the set nor gathered bound the openings.
  struct Rim {
    int from, to, opening;
  };
  std::vector<Rim> rims(const std::vector<int>& panels) const {
    std::set<int> joined;
    for (const SeamFrame& seam : frame_.seams) {
      std::vector<int> mine;
      for (const int edge : seam.edge) {
        if (has(panels, edge / 4)) mine.push_back(edge);
      }
      if (mine.size() >= 2 || seam.gathered) joined.insert(mine.begin(), mine.end());
    }
    std::vector<int> group(static_cast<std::size_t>(frame_.nodes));
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](int node) {
      while (group[node] != node) node = group[node] = group[group[node]];
      return node;
    };
    std::vector<Rim> out;
    for (const int panel : panels) {
      for (int side = 0; side < 4; ++side) {
        const int edge = 4 * panel + side;
        if (joined.count(edge) != 0) continue;
        const int* node = &frame_.edges.edge_node[frame_.edges.before[edge]];
        for (int k = 0; k + 1 < frame_.edges.count[edge]; ++k) {
          // The facets of a lid and of the adjacent panel traverse the common edge in opposite
          // directions.
          const bool turned = side == 1 || side == 2;
          out.push_back({node[k + turned], node[k + !turned], 0});
          group[root(node[k])] = root(node[k + 1]);
        }
      }
    }
    for (Rim& rim : out) rim.opening = root(rim.from);
    return out;
  }

  // Triangles between positions on a panel's meshes, all with the same orientation.
  std::vector<std::array<int, 3>> panel_facets(int panel) const {
    std::vector<int> mine, row;
    std::vector<double> s;
    for (int k = 0; k < frame_.meshes.count(); ++k) {
      if (frame_.meshes.panel(k) != panel) continue;
      mine.push_back(k);
      row.push_back(frame_.meshes.row[k]);
      s.push_back(frame_.meshes.s[k]);
    }
    std::vector<std::array<int, 3>> out = row_facets(row, s);
    for (auto& facet : out) {
      for (int& place : facet) place = mine[place];
    }
    return out;
  }

  // Requires that all panels are seen from the same side, inside or outside, with the upper edge
  // up.
  T volume_within(const std::vector<int>& panels) const {
    using std::abs;
    const std::vector<Three<T>> places = frame_.meshes.places(points_);
    Three<T> middle;
    double count = 0.0;
    for (int k = 0; k < frame_.meshes.count(); ++k) {
      if (!has(panels, frame_.meshes.panel(k))) continue;
      middle = middle + places[k];
      ++count;
    }
    middle = middle * T(1 / count);
    T sum{};
    const auto add = [&](const Three<T>& a, const Three<T>& b, const Three<T>& c) {
      sum += triple_product(a - middle, b - middle, c - middle);
    };
    for (const int panel : panels) {
      for (const auto& facet : panel_facets(panel)) {
        add(places[facet[0]], places[facet[1]], places[facet[2]]);
      }
    }
    const std::vector<Rim> lids = rims(panels);
    std::map<int, std::pair<Three<T>, double>> centre;
    for (const Rim& rim : lids) {
      auto& of = centre[rim.opening];
      of.first = of.first + three(shape_.position, rim.from);
      of.second += 1;
    }
    for (const Rim& rim : lids) {
      const auto& [whole, rims_of] = centre[rim.opening];
      add(whole * T(1 / rims_of), three(shape_.position, rim.from), three(shape_.position, rim.to));
    }
    return abs(sum / T(6.0));
  }

  // Gauss's theorem: integral of z n_z over the netting and over a surface below it from the rope
  // to its centroid. The remaining boundary contributes nothing: the water surface (z = 0), and
  // vertical walls from there to the netting and between its ends.
  T enclosed_volume(int rope) const {
    using std::abs;
    std::vector<int> run = frame_.ropes[rope].node;
    run.erase(std::unique(run.begin(), run.end()), run.end());
    std::vector<int> place_in_run(points_.size() / 3, -1);
    for (std::size_t k = run.size(); k-- > 0;) place_in_run[run[k]] = static_cast<int>(k);
    if (frame_.meshes.count() == 0) return T(none);
    const std::vector<Three<T>> places = frame_.meshes.places(points_);
    T netting{};
    int way = 0;
    for (int panel = 0; panel < frame_.panel_count; ++panel) {
      for (const auto& facet : panel_facets(panel)) {
        netting += upward_moment(places[facet[0]], places[facet[1]], places[facet[2]]);
        // Positions on the upper and lower edge of a panel are nodes.
        int node[3];
        for (int k = 0; k < 3; ++k) node[k] = frame_.meshes.from[facet[k]];
        if (way == 0) way = way_along(node, place_in_run);
      }
    }
    Three<T> middle;
    for (const int node : run) middle = middle + three(points_, node);
    middle = middle * T(1.0 / static_cast<double>(run.size()));
    T under{};
    for (std::size_t k = 0; k < run.size(); ++k) {
      under +=
          upward_moment(three(points_, run[k]), three(points_, run[(k + 1) % run.size()]), middle);
    }
    // Orients both surfaces the same: the rope must traverse common edges against the netting's
    // triangles.
    return abs(netting + T(way > 0 ? -1.0 : 1.0) * under);
  }
  // Direction of a triangle with two neighbouring nodes of a run: 1 if it traverses them in the
  // direction of the run, -1 if against it. 0 for other triangles.
  static int way_along(const int* node, const std::vector<int>& place_in_run) {
    int inside = 0, way = 0;
    for (int k = 0; k < 3; ++k) {
      const int here = place_in_run[node[k]], next = place_in_run[node[(k + 1) % 3]];
      inside += here >= 0;
      if (here >= 0 && next >= 0 && std::abs(next - here) == 1) way = next - here;
    }
    return inside == 2 ? way : 0;
  }

  const MeasureFrame& frame_;
  const Model& model_;
  const Questions& asked_;
  const FilledBag* bag_;
  const MeasuredShape<T>& shape_;
  std::vector<T> points_;  // positions of nodes and tied points
  Three<double> flow_, across_;
  T drag_;
  std::vector<T> forces_;
  std::vector<MeshPlace<T>> meshes_;
};

// Parts of elements of a kind with reported hydrodynamic forces; null if the kind has no parts.
const std::vector<int>* parts_of(const ElementParts& part, const std::string& kind) {
  if (kind == "bars") return &part.bars;
  if (kind == "cells") return &part.cells;
  if (kind == "spheres") return &part.spheres;
  if (kind == "lifts") return &part.lifts;
  if (kind == "plates") return &part.plates;
  if (kind == "screens") return &part.screens;
  if (kind == "blended") return &part.blended;
  return nullptr;
}

}  // namespace

MeasuredShape<double> measured_shape(const Evaluation& found, const std::vector<double>& position,
                                     const std::vector<double>& velocity) {
  MeasuredShape<double> out;
  out.position = position;
  out.velocity = velocity;
  out.force = found.force;
  out.bar_tension = found.bar_tension;
  out.u_tension = found.u_tension;
  out.v_tension = found.v_tension;
  out.straight_tension = found.straight_tension;
  out.forces = found.forces;
  for (const PlateAttitude& plate : found.plates) {
    out.attack.push_back(plate.attack);
    out.heel.push_back(plate.heel);
    out.trim.push_back(plate.trim);
  }
  return out;
}

template <class T>
std::vector<T> all_points(const Model& model, const std::vector<T>& position) {
  std::vector<T> out = position;
  for (const Tie& tie : model.ties) {
    const Three<T> x =
        three(position, tie.first) * T(1 - tie.share) + three(position, tie.second) * T(tie.share);
    out.insert(out.end(), {x.x, x.y, x.z});
  }
  return out;
}

Three<double> flow_axis(const Model& model, const Questions& questions) {
  Three<double> out = {1.0, 0.0, 0.0};
  double fastest = 0.0;
  if (questions.speed != 0) return out;
  for (const Vector& current : model.water.current) {
    const double speed = std::sqrt(current.x() * current.x() + current.y() * current.y());
    if (speed <= fastest) continue;
    fastest = speed;
    out = {current.x() / speed, current.y() / speed, 0.0};
  }
  return out;
}

template <class T>
std::vector<T> part_forces(const MeasureFrame& frame, const MeasuredShape<T>& shape) {
  std::vector<T> out(3 * static_cast<std::size_t>(frame.parts));
  const std::vector<ReportedForce>& all = reported_forces();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].cause != Cause::flow) continue;
    const std::vector<int>* part = parts_of(frame.part, all[k].kind);
    for (std::size_t e = 0; e < shape.forces[k].size(); ++e) {
      // The contents of a bag are the last part.
      const int of = part ? (*part)[e / 3] : frame.parts - 1;
      out[3 * static_cast<std::size_t>(of) + e % 3] += shape.forces[k][e];
    }
  }
  return out;
}

template <class T>
std::array<T, 2> end_tensions(const MeasureFrame& frame, const Model& model,
                              const MeasuredShape<T>& shape, int bar) {
  const T tension = shape.bar_tension[bar];
  if (value_of(tension) <= 0.0) return {tension, tension};
  const int* node = &model.bars.node[2 * static_cast<std::size_t>(bar)];
  const Three<T> way = three(shape.position, node[1]) - three(shape.position, node[0]);
  const Three<T> pull = way * (tension / length_of(way));
  const RopeFrame& rope = frame.ropes[frame.part.bars[bar]];
  const double half = gravity * model.bars.rest[bar] / 2;
  Three<T> drag;
  const std::vector<ReportedForce>& all = reported_forces();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].cause == Cause::flow && std::string(all[k].kind) == "bars") {
      drag = drag + three(shape.forces[k], bar) * T(0.5);
    }
  }
  std::array<T, 2> out;
  for (int end = 0; end < 2; ++end) {
    double wet = 1.0;
    if (model.water.free_surface) {
      // A node exactly at the surface counts half as immersed.
      const double z = value_of(three(shape.position, node[end]).z);
      wet = z > 0 ? 0.0 : z < 0 ? 1.0 : 0.5;
    }
    Three<T> force = drag;
    force.z -=
        T(half * (rope.mass_per_length - wet * model.water.density * rope.volume_per_length));
    // The bar pulls its start node along its direction, and its end node in the opposite direction.
    out[end] = length_of(end == 0 ? pull + force : pull - force);
  }
  return out;
}

template <class T>
std::vector<T> measure(const MeasureFrame& frame, const Model& model, const Questions& questions,
                       const FilledBag* bag, const MeasuredShape<T>& shape) {
  Measuring<T> measuring(frame, model, questions, bag, shape);
  std::vector<T> out;
  for (const AskedMeasure& one : questions.measures) out.push_back(measuring(one));
  return out;
}

template std::vector<double> measure(const MeasureFrame&, const Model&, const Questions&,
                                     const FilledBag*, const MeasuredShape<double>&);
template std::vector<Dual> measure(const MeasureFrame&, const Model&, const Questions&,
                                   const FilledBag*, const MeasuredShape<Dual>&);
template std::vector<double> all_points(const Model&, const std::vector<double>&);
template std::vector<Dual> all_points(const Model&, const std::vector<Dual>&);
template std::vector<double> part_forces(const MeasureFrame&, const MeasuredShape<double>&);
template std::vector<Dual> part_forces(const MeasureFrame&, const MeasuredShape<Dual>&);
template std::array<double, 2> end_tensions(const MeasureFrame&, const Model&,
                                            const MeasuredShape<double>&, int);
template std::array<Dual, 2> end_tensions(const MeasureFrame&, const Model&,
                                          const MeasuredShape<Dual>&, int);

}  // namespace codend
