#include "first_shape.hpp"

#include <algorithm>
#include <cmath>

#include "sums.hpp"

namespace codend {

namespace {

Vector middle_of(const double* position, const std::array<int, 3>& nodes) {
  Vector out;
  for (int c = 0; c < 3; ++c) {
    long double sum = 0.0L;
    for (const int node : nodes) sum += at(position, node)[c];
    out[c] = static_cast<double>(sum / 3.0L);
  }
  return out;
}

std::array<int, 3> plate_nodes(const GearPlate& plate, const std::vector<int>& points) {
  return {points[plate.points[0]], points[plate.points[1]], points[plate.points[2]]};
}

double length_of(const Vector& x) {
  long double squares = 0.0L;
  for (int c = 0; c < 3; ++c) squares += x[c] * x[c];
  return std::sqrt(static_cast<double>(squares));
}

Division divide_coarsely(const Gear& gear) {
  const std::vector<char> linked(gear.panels.size(), 1), bars(gear.panels.size(), 0);
  const ChainTable chains = chain_table(gear);
  const EdgePieces pieces = edge_pieces(chains, edge_breaks(chains, linked), linked);
  std::vector<int> segments;
  for (const GearRope& rope : gear.ropes) {
    // An attachment at the middle of a pole must not start at its end, nor the middle of a ring.
    const int least = !rope.ring() ? 1 : rope.strut ? 8 : 2;
    segments.push_back(rope.strut ? std::max(least, rope.segments) : least);
  }
  return divide(gear, chains, pieces, std::vector<int>(pieces.edge.size(), 1), segments, bars);
}

Strings skeleton_strings(const Gear& gear, const Division& skeleton, double open) {
  Strings out;
  const auto add = [&](int first, int second, double rest, double strength) {
    if (first == second || !(rest > 0)) return;
    out.ends.insert(out.ends.end(), {first, second});
    out.rest.push_back(rest);
    out.tension.push_back(strength);
  };
  for (int r = 0; r < gear.rope_count; ++r) {
    const NodeRun& run = skeleton.ropes[r];
    for (std::size_t k = 0; k + 1 < run.node.size(); ++k) {
      add(run.node[k], run.node[k + 1], (run.at[k + 1] - run.at[k]) * gear.ropes[r].length, 1.0);
    }
  }
  const double depth_ratio = std::sqrt(1 - nominal_hanging_ratio * nominal_hanging_ratio);
  for (int p = 0; p < gear.panel_count; ++p) {
    const GearPanel& panel = gear.panels[p];
    const Grid& grid = skeleton.grids[p];
    const double* across = &skeleton.edges.fraction[skeleton.edges.before[4 * p]];
    const double* deep = &skeleton.edges.fraction[skeleton.edges.before[4 * p + 2]];
    const int columns = grid.columns, rows = skeleton.edges.count[4 * p + 2];
    const auto node = [&](int row, int column) { return grid.node[row * columns + column]; };
    for (int column = 0; column < columns; ++column) {
      for (int row = 0; row + 1 < rows; ++row) {
        add(node(row, column), node(row + 1, column),
            (deep[row + 1] - deep[row]) * panel.deep * panel.unit() *
                (panel.square() ? 1.0 : depth_ratio),
            1.0);
      }
    }
    for (int row = 0; row < rows; ++row) {
      const double meshes = panel.upper + deep[row] * (panel.lower - panel.upper);
      for (int column = 0; column + 1 < columns; ++column) {
        add(node(row, column), node(row, column + 1),
            (across[column + 1] - across[column]) * meshes * panel.unit() *
                (panel.square() ? 1.0 : open),
            0.02);
      }
    }
  }
  for (const GearPlate& plate : gear.plates) {
    const std::array<int, 3> nodes = plate_nodes(plate, skeleton.places);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      add(nodes[a], nodes[b], length_of(plate.attachment[b] - plate.attachment[a]), 1.0);
    }
  }
  return out;
}

// Adds weight, lift and an approximate drag (N) to the loads of the skeleton's nodes, part by part.
void add_skeleton_load(const Gear& gear, const Division& skeleton, double speed,
                       std::vector<double>& load) {
  const double density = gear.density;
  const double push = 0.5 * density * speed * std::abs(speed);
  // First sums each part's force per node, then adds parts.
  std::vector<Vector> sum(static_cast<std::size_t>(skeleton.nodes), Vector::Zero());
  std::vector<char> loaded(sum.size(), 0);
  std::vector<int> nodes;
  const auto add = [&](int node, const Vector& force) {
    if (!loaded[node]) nodes.push_back(node);
    sum[node] = loaded[node] ? Vector(sum[node] + force) : force;
    loaded[node] = 1;
  };
  const auto finish_part = [&] {
    for (const int node : nodes) {
      at(load.data(), node) += sum[node];
      loaded[node] = 0;
    }
    nodes.clear();
  };
  // Weight of a line, and drag of a cylinder at about 20 degrees to the flow.
  const auto line_load = [&](double length, double mass, double volume, double diameter) {
    return Vector(0.1 * push * diameter * length, 0.0,
                  -gravity * length * (mass - density * volume));
  };
  for (int r = 0; r < gear.rope_count; ++r) {
    const GearRope& rope = gear.ropes[r];
    const NodeRun& run = skeleton.ropes[r];
    for (std::size_t end = 0; end < 2; ++end) {
      for (std::size_t k = 0; k + 1 < run.node.size(); ++k) {
        const double half = (run.at[k + 1] - run.at[k]) * rope.length / 2;
        add(run.node[k + end],
            line_load(half, rope.mass_per_length, rope.volume_per_length, rope.diameter));
      }
    }
    finish_part();
  }
  for (int p = 0; p < gear.panel_count; ++p) {
    const GearPanel& panel = gear.panels[p];
    const std::vector<int>& grid = skeleton.grids[p].node;
    const double twine =
        panel.bar_count() * panel.cell_twine_with_knots() / static_cast<double>(grid.size());
    for (const int node : grid) {
      add(node, line_load(twine, panel.mass_per_length, panel.volume_per_length, panel.width()));
    }
    finish_part();
  }
  for (std::size_t k = 0; k < gear.pieces.size(); ++k) {
    const GearPiece& piece = gear.pieces[k];
    const NodeRun* run = piece_run(gear, skeleton, static_cast<int>(k));
    const std::vector<int> on = run ? run->node : std::vector<int>{skeleton.places[piece.at]};
    const double lift = push * piece.lift_area;
    const bool up = piece.lift_direction == LiftDirection::up;
    const Vector force(piece.number * (push * piece.drag_area), piece.number * (up ? 0.0 : lift),
                       piece.number * ((up ? lift : 0.0) + push * piece.upward_lift_area -
                                       gravity * (piece.mass - density * piece.volume)));
    for (const int node : on) add(node, force / static_cast<double>(on.size()));
    finish_part();
  }
  for (const GearPlate& plate : gear.plates) {
    const double lift = push * plate.area * 1.2 * plate.side;
    const Vector force(
        push * plate.area * 0.5, plate.level ? 0.0 : lift,
        (plate.level ? lift : 0.0) - gravity * (plate.mass - density * plate.volume));
    for (const int node : plate_nodes(plate, skeleton.places)) add(node, force / 3.0);
    finish_part();
  }
}

// Opens a stiff ring to a circle from its end to its middle, because strings lay it flat.
void open_ring(const GearRope& rope, const NodeRun& run, const std::vector<char>& held,
               std::vector<double>& position) {
  const Vector end = at(position.data(), run.node.front());
  const Vector middle = at(position.data(), run.node[run.node.size() / 2]);
  const double reach = length_of(middle - end);
  const Vector down = reach > 0 ? Vector((middle - end) / reach) : Vector(-Vector::UnitZ());
  Vector across = Vector::UnitY() - down[1] * down;
  if (length_of(across) < 0.5) across = Vector::UnitX() - down[0] * down;
  across /= length_of(across);
  for (std::size_t k = 1; k + 1 < run.node.size(); ++k) {
    if (held[run.node[k]]) continue;
    const double angle = 2 * pi * run.at[k];
    at(position.data(), run.node[k]) =
        end + rope.length / (2 * pi) * ((1 - std::cos(angle)) * down + std::sin(angle) * across);
  }
}

// Buoyant nodes, which a free surface prevents from rising.
std::vector<char> buoyant_nodes(const std::vector<double>& load) {
  std::vector<char> out;
  for (std::size_t k = 2; k < load.size(); k += 3) out.push_back(load[k] > 0.0);
  return out;
}

double height_above(const GearGround& ground, const Vector& x) {
  return ground.normal[0] * x[0] + ground.normal[1] * x[1] + ground.normal[2] * x[2] -
         ground.height;
}

// Supports of a gear that is shot along a rope: the rope is fixed.
Supports rope_supports(const Gear& gear, const Division& skeleton, int rope) {
  Supports out;
  out.held.assign(static_cast<std::size_t>(skeleton.nodes), 0);
  out.position.assign(3 * out.held.size(), 0.0);
  out.load = out.position;
  const NodeRun& run = skeleton.ropes[rope];
  for (std::size_t k = 0; k < run.node.size(); ++k) {
    out.held[run.node[k]] = 1;
    at(out.position.data(), run.node[k])[0] = run.at[k] * gear.ropes[rope].length;
  }
  return out;
}

}  // namespace

std::vector<double> first_shape(const Gear& gear, const PartMap& map, bool shot,
                                const LayOut& lay_out) {
  const Division skeleton = divide_coarsely(gear);
  Supports supports =
      shot ? rope_supports(gear, skeleton, gear.shot_along) : gear_supports(gear, skeleton);
  std::vector<double>& position = supports.position;
  for (int k = 0; k < gear.point_count; ++k) {
    const int node = skeleton.places[k];
    if (!gear.points[k].has_near || supports.held[node]) continue;
    supports.held[node] = 1;
    at(position.data(), node) = gear.points[k].near;
  }
  Strings strings = skeleton_strings(gear, skeleton, shot ? 1.0 : nominal_hanging_ratio);
  strings.held = supports.held;
  strings.load = supports.load;
  add_skeleton_load(gear, skeleton, shot ? 0.0 : gear.speed, strings.load);
  if (gear.free_surface) strings.buoyant = buoyant_nodes(strings.load);
  // A weightless gear at rest has no loads: add a small weight.
  double total = 1e-9;
  for (int k = 0; k < skeleton.nodes; ++k) {
    total = std::max(total, length_of(at(strings.load.data(), k)));
  }
  for (int k = 0; k < skeleton.nodes; ++k) {
    if (!supports.held[k]) strings.load[3 * static_cast<std::size_t>(k) + 2] -= 1e-3 * total;
  }
  for (double& tension : strings.tension) tension *= total;
  lay_out(strings, position.data());
  for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
    const GearRope& rope = gear.ropes[r];
    if (rope.ring() && rope.strut) open_ring(rope, skeleton.ropes[r], supports.held, position);
  }
  // No node may start above the surface.
  for (std::size_t k = 2; k < position.size() && gear.free_surface; k += 3) {
    position[k] = std::min(position[k], 0.0);
  }
  for (const GearPlate& plate : gear.plates) {
    const std::array<int, 3> nodes = plate_nodes(plate, skeleton.places);
    const Vector middle = middle_of(position.data(), nodes);
    for (int k = 0; k < 3; ++k) at(position.data(), nodes[k]) = plate.upright[k] + middle;
  }
  const std::vector<DrawnPanel> of_cells(gear.panels.size());
  return carry_positions(gear, map, part_map(gear, skeleton, skeleton.nodes, of_cells), position);
}

void lay_on_ground(const Gear& gear, const std::vector<int>& points,
                   std::vector<double>& position) {
  const GearGround& ground = gear.ground;
  const Vector aft = Vector::UnitX() - ground.normal[0] * ground.normal;
  const Vector way = ground.normal + aft / length_of(aft);
  for (std::size_t k = 0; k < position.size() / 3; ++k) {
    const auto x = at(position.data(), static_cast<int>(k));
    const double deep = std::min(height_above(ground, x), 0.0);
    at(position.data(), static_cast<int>(k)) = x - way * deep;
  }
  for (const GearPlate& plate : gear.plates) {
    if (plate.level) continue;
    const std::array<int, 3> nodes = plate_nodes(plate, points);
    Vector middle = middle_of(position.data(), nodes);
    const double lacking = plate.room - height_above(ground, middle);
    middle += std::max(lacking, 0.0) * ground.normal;
    for (int k = 0; k < 3; ++k) at(position.data(), nodes[k]) = plate.upright[k] + middle;
  }
}

}  // namespace codend
