#include "parts.hpp"

#include <algorithm>
#include <cmath>

namespace codend {

void add_ropes(Collection& to, const Gear& gear, const Division& division) {
  for (int r = 0; r < gear.rope_count; ++r) {
    const GearRope& rope = gear.ropes[r];
    const NodeRun& run = division.ropes[r];
    for (std::size_t k = 0; k + 1 < run.node.size(); ++k) {
      const double rest = (run.at[k + 1] - run.at[k]) * rope.length;
      const int first = run.node[k], second = run.node[k + 1];
      // A rope laced to an edge gathered in one point has no length between its nodes.
      if (first == second || !(rest > 0.0)) continue;
      const double height = surface_height(rope.diameter, rest), half = rest / 2;
      to.add_bar(first, second, rest, 1.0, height, r, r);
      for (const int node : {first, second}) {
        to.masses.push_back({node, half * rope.mass_per_length, half * rope.volume_per_length,
                             rope.diameter, height, half * rope.diameter});
      }
    }
  }
}

void add_weights(const Gear& gear, const Division& division, std::vector<double>& load) {
  for (int r = 0; r < gear.rope_count; ++r) {
    const GearRope& rope = gear.ropes[r];
    if (rope.weight_factor == 1.0) continue;
    const NodeRun& run = division.ropes[r];
    const double per_metre = (rope.weight_factor - 1) * gravity *
                             (rope.mass_per_length - gear.density * rope.volume_per_length);
    for (std::size_t k = 0; k + 1 < run.node.size(); ++k) {
      if (run.node[k] == run.node[k + 1]) continue;
      const double half = (run.at[k + 1] - run.at[k]) * rope.length / 2;
      for (const int node : {run.node[k], run.node[k + 1]}) load[3 * node + 2] -= half * per_metre;
    }
  }
}

const NodeRun* piece_run(const Gear& gear, const Division& division, int piece) {
  const GearPiece& of = gear.pieces[piece];
  if (of.rope >= 0) return &division.ropes[of.rope];
  return of.along.empty() ? nullptr : &division.runs[piece];
}

namespace {

// Distributes a piece to nodes: returns nodes and the number of bodies on each.
void spread(const GearPiece& piece, const NodeRun& run, std::vector<int>& node,
            std::vector<double>& number) {
  const std::size_t n = run.node.size();
  std::vector<double> share(n, 0.0);
  if (piece.end_to_end) {
    // One body at each end of the interval; a body between two nodes is distributed to both.
    const int count = static_cast<int>(std::ceil(piece.number));
    for (int k = 0; k < count; ++k) {
      double at = piece.share[0];
      if (k > 0) at += k * ((piece.share[1] - piece.share[0]) / (count - 1));
      if (k > 0 && k == count - 1) at = piece.share[1];
      const std::size_t past = std::upper_bound(run.at.begin(), run.at.end(), at) - run.at.begin();
      const std::size_t cell = std::min(std::max<std::size_t>(past, 1), n - 1) - 1;
      const double second = (at - run.at[cell]) / std::max(run.at[cell + 1] - run.at[cell], 1e-300);
      share[cell] += 1 - second;
      share[cell + 1] += second;
    }
    for (std::size_t k = 0; k < n; ++k) {
      // Removes rounding errors of bodies exactly at the next node.
      if (!(share[k] > 1e-9)) continue;
      node.push_back(run.node[k]);
      number.push_back(share[k]);
    }
    return;
  }
  // Each node takes the interval to the midpoints to its neighbours, clipped to the piece's
  // interval.
  for (std::size_t k = 0; k < n; ++k) {
    const double begin = k == 0 ? 0.0 : (run.at[k] + run.at[k - 1]) / 2;
    const double end = k + 1 == n ? 1.0 : (run.at[k + 1] + run.at[k]) / 2;
    const double from = std::max(begin, piece.share[0]), until = std::min(end, piece.share[1]);
    if (!(until > from)) continue;
    node.push_back(run.node[k]);
    number.push_back(piece.number * ((until - from) / (piece.share[1] - piece.share[0])));
  }
}

}  // namespace

void add_pieces(Collection& to, const Gear& gear, const Division& division) {
  for (std::size_t k = 0; k < gear.pieces.size(); ++k) {
    const GearPiece& piece = gear.pieces[k];
    const int part = gear.rope_count + gear.panel_count + static_cast<int>(k);
    std::vector<int> node;
    std::vector<double> number;
    if (const NodeRun* run = piece_run(gear, division, static_cast<int>(k))) {
      spread(piece, *run, node, number);
    } else {
      node.push_back(division.places[piece.at]);
      number.push_back(piece.number);
    }
    for (std::size_t m = 0; m < node.size(); ++m) {
      const double n = number[m];
      to.masses.push_back({node[m], n * piece.mass, n * piece.volume, piece.height, piece.height,
                           n * (piece.height * piece.height)});
      to.add_sphere(node[m], n * piece.drag_area, piece.smooth_diameter, piece.smooth_diameter > 0,
                    gear.density > 0 ? n * piece.added_mass / gear.density : 0.0, piece.height,
                    part);
    }
    for (std::size_t m = 0; m < node.size() && piece.lift_area != 0; ++m) {
      to.add_lift(node[m], number[m] * piece.lift_area, piece.lift_direction, piece.height, part);
    }
    for (std::size_t m = 0; m < node.size() && piece.upward_lift_area != 0; ++m) {
      to.add_lift(node[m], number[m] * piece.upward_lift_area, LiftDirection::up, piece.height,
                  part);
    }
  }
}

void add_plates(Collection& to, const Gear& gear, const Division& division) {
  for (std::size_t k = 0; k < gear.plates.size(); ++k) {
    const GearPlate& plate = gear.plates[k];
    const int part = gear.rope_count + gear.panel_count + static_cast<int>(gear.pieces.size() + k);
    const int material = gear.rope_count + gear.panel_count + static_cast<int>(k);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      long double squares = 0.0L;
      for (int c = 0; c < 3; ++c) {
        const double d = plate.attachment[b][c] - plate.attachment[a][c];
        squares += d * d;
      }
      const double length = std::sqrt(static_cast<double>(squares));
      to.add_bar(division.places[plate.points[a]], division.places[plate.points[b]], length, 1.0,
                 length, material, part);
    }
  }
}

Supports gear_supports(const Gear& gear, const Division& division) {
  Supports out;
  const std::size_t n = static_cast<std::size_t>(division.nodes);
  out.held.assign(n, 0);
  out.position.assign(3 * n, 0.0);
  out.load.assign(3 * n, 0.0);
  for (int k = 0; k < gear.point_count; ++k) {
    const GearPoint& point = gear.points[k];
    const int node = division.places[k];
    at(out.load.data(), node) += point.load;
    if (!point.held) continue;
    out.held[node] = 1;
    at(out.position.data(), node) = point.position;
  }
  for (const Division::Held& edge : division.held_edges) {
    const Vector first = gear.points[edge.points[0]].position;
    const Vector way = gear.points[edge.points[1]].position - first;
    for (std::size_t k = 1; k + 1 < edge.node.size(); ++k) {
      out.held[edge.node[k]] = 1;
      at(out.position.data(), edge.node[k]) = first + way * edge.at[k];
    }
  }
  return out;
}

Bends rope_bends(const Gear& gear, const Division& division) {
  Bends out;
  for (int r = 0; r < gear.rope_count; ++r) {
    const GearRope& rope = gear.ropes[r];
    if (!(rope.bending_stiffness > 0)) continue;
    std::vector<int> node = division.ropes[r].node;
    const std::vector<double>& at = division.ropes[r].at;
    std::vector<double> rest;
    for (std::size_t k = 0; k + 1 < at.size(); ++k)
      rest.push_back((at[k + 1] - at[k]) * rope.length);
    if (node.front() == node.back()) {
      node.push_back(node[1]);
      rest.push_back(rest[0]);
    }
    for (std::size_t k = 0; k + 1 < rest.size(); ++k) {
      out.node.insert(out.node.end(), {node[k], node[k + 1], node[k + 2]});
      out.couple.push_back(2 * rope.bending_stiffness / (rest[k] + rest[k + 1]));
      out.length.push_back((rest[k] + rest[k + 1]) / 2);
    }
  }
  return out;
}

LineFriction line_friction(const Gear& gear, const Division& division) {
  LineFriction out;
  std::vector<char> known(static_cast<std::size_t>(division.nodes), 0);
  for (int r = 0; r < gear.rope_count; ++r) {
    if (gear.ropes[r].friction.empty()) continue;
    const std::vector<int>& node = division.ropes[r].node;
    for (std::size_t k = 0; k < node.size(); ++k) {
      if (known[node[k]]) continue;
      known[node[k]] = 1;
      out.node.push_back(node[k]);
      out.between.push_back(node[k == 0 ? 0 : k - 1]);
      out.between.push_back(node[k + 1 == node.size() ? k : k + 1]);
      out.along.push_back(gear.ropes[r].friction[0]);
      out.across.push_back(gear.ropes[r].friction[1]);
    }
  }
  return out;
}

GroundContacts ground_contacts(const std::vector<Mass>& masses, int points) {
  std::vector<double> area(static_cast<std::size_t>(points), 0.0), height = area;
  for (const Mass& mass : masses) {
    if (!(mass.area > 0)) continue;
    area[mass.node] += mass.area;
    height[mass.node] = std::max(height[mass.node], mass.height);
  }
  GroundContacts out;
  for (int p = 0; p < points; ++p) {
    if (!(area[p] > 0)) continue;
    out.node.push_back(p);
    out.area.push_back(area[p]);
    out.clearance.push_back(height[p] / 2);
  }
  return out;
}

ImmersedVolumes immersed_volumes(const std::vector<Mass>& masses, int points, double density) {
  // Relative tolerance: heights closer than this are equal.
  constexpr double same_height = 1e-11;
  ImmersedVolumes out;
  std::vector<int> newest(static_cast<std::size_t>(points), -1), before;
  for (const Mass& mass : masses) {
    if (!(mass.volume > 0 && mass.surface > 0)) continue;
    int group = newest[mass.node];
    while (group >= 0 && std::abs(out.height[group] - mass.surface) > same_height * mass.surface)
      group = before[group];
    if (group < 0) {
      group = static_cast<int>(out.node.size());
      before.push_back(newest[mass.node]);
      newest[mass.node] = group;
      out.node.push_back(mass.node);
      out.height.push_back(mass.surface);
      out.buoyancy.push_back(0.0);
    }
    out.buoyancy[group] += mass.volume;
  }
  for (double& buoyancy : out.buoyancy) buoyancy *= gravity * density;
  return out;
}

}  // namespace codend
