#include "bag.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "../base/pi.hpp"
#include "sums.hpp"

namespace codend {

namespace {

// Area of a circle divided by the area of a regular polygon of n sides with the same perimeter.
double circle_share(double n) {
  n = std::max(n, 3.0);
  return n * std::tan(pi / n) / pi;
}

// A cell or a sheet that can be in contact with the contents of the bag.
struct BagCell {
  int cell, panel;
  std::array<int, 4> node;
  std::array<double, 4> depth, across;
  double multiplicity, round, height;
};

BagCell bag_cell(const Gear& gear, int cell, int part, const int* node, const double* twine,
                 double multiplicity, double height) {
  BagCell out;
  out.cell = cell;
  out.panel = part - gear.rope_count;
  const GearPanel& panel = gear.panels[out.panel];
  const int way = panel.orientation == MeshOrientation::hexagonal_turned ? -1 : 1;
  long double depths = 0.0L;
  for (int k = 0; k < 4; ++k) {
    const double u = twine[2 * k], v = twine[2 * k + 1] * way;
    out.node[k] = node[k];
    out.depth[k] = gear.bag.deep - (panel.square() ? v : (u + v) / 2);
    out.across[k] = panel.square() ? u : (u - v) / 2;
    depths += out.depth[k];
  }
  // Number of meshes around the bag at the cell's depth.
  std::vector<double> upper, lower;
  for (const int p : gear.bag.panels) {
    upper.push_back(gear.panels[p].upper);
    lower.push_back(gear.panels[p].lower);
  }
  const double depth = static_cast<double>(depths / 4.0L);
  const double around =
      exact_sum(lower) + (exact_sum(upper) - exact_sum(lower)) * depth / gear.bag.deep;
  const auto ends = std::minmax_element(out.across.begin(), out.across.end());
  out.multiplicity = multiplicity;
  out.height = height;
  out.round = circle_share(around / (*ends.second - *ends.first));
  return out;
}

double triple_product(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Volume (m3) between each panel and the centre of all panels, by panel.
std::map<int, double> panel_volumes(const BagTriangles& bag, const std::vector<int>& panel,
                                    const Mesh& mesh) {
  const auto place = [&](int point) -> Vector {
    if (point < mesh.nodes) return at(mesh.start.data(), point);
    const std::size_t t = static_cast<std::size_t>(point - mesh.nodes);
    const TieList& ties = mesh.ties;
    return (1 - ties.share[t]) * at(mesh.start.data(), ties.first[t]) +
           ties.share[t] * at(mesh.start.data(), ties.second[t]);
  };
  long double sum[3] = {0.0L, 0.0L, 0.0L};
  for (const int node : bag.node) {
    const Vector x = place(node);
    for (int c = 0; c < 3; ++c) sum[c] += x[c];
  }
  Vector middle;
  for (int c = 0; c < 3; ++c) {
    middle[c] = static_cast<double>(sum[c] / static_cast<long double>(bag.node.size()));
  }
  std::map<int, double> out;
  for (std::size_t t = 0; t < panel.size(); ++t) {
    const int* node = &bag.node[3 * t];
    out[panel[t]] +=
        triple_product(place(node[0]) - middle, place(node[1]) - middle, place(node[2]) - middle) /
        6 * bag.weight[t];
  }
  return out;
}

}  // namespace

BagTriangles bag_triangles(const Gear& gear, const Mesh& mesh) {
  std::vector<BagCell> cells;
  const auto has = [&](int part) {
    const std::vector<int>& panels = gear.bag.panels;
    return std::find(panels.begin(), panels.end(), part - gear.rope_count) != panels.end();
  };
  for (std::size_t c = 0; c < mesh.cell_part.size(); ++c) {
    if (!has(mesh.cell_part[c])) continue;
    cells.push_back(bag_cell(gear, static_cast<int>(c), mesh.cell_part[c], &mesh.cells.node[4 * c],
                             &mesh.cells.twine[8 * c], mesh.cells.multiplicity[c],
                             mesh.cells.height[c]));
  }
  const Sheets& sheets = mesh.sheets;
  for (std::size_t c = 0; c < sheets.part.size(); ++c) {
    if (!has(sheets.part[c])) continue;
    cells.push_back(bag_cell(gear, -1, sheets.part[c], &sheets.node[4 * c], &sheets.twine[8 * c],
                             1.0, sheets.height[c]));
  }
  BagTriangles out;
  std::vector<int> panel;
  const auto add = [&](const BagCell& cell, const int* corner, double weight) {
    for (int k = 0; k < 3; ++k) {
      out.node.push_back(cell.node[corner[k]]);
      out.depth.push_back(cell.depth[corner[k]]);
      out.across.push_back(cell.across[corner[k]]);
    }
    out.cell.push_back(cell.cell);
    out.height.push_back(cell.height);
    out.real.push_back(cell.multiplicity * weight);
    out.weight.push_back(cell.multiplicity * cell.round * weight);
    panel.push_back(cell.panel);
  };
  // Quadrilateral cells give all four triangles of their corners, which overlap: weight 1/2 each.
  for (const BagCell& cell : cells) {
    if (cell.node[2] == cell.node[3]) add(cell, corner_triangles[0], 1.0);
  }
  for (const BagCell& cell : cells) {
    if (cell.node[2] == cell.node[3]) continue;
    for (const auto& corner : corner_triangles) add(cell, corner, 0.5);
  }
  // The initial shape encloses a volume, so that its sign gives the orientation of each panel.
  const std::map<int, double> volume = panel_volumes(out, panel, mesh);
  for (std::size_t t = 0; t < panel.size(); ++t) {
    const double outward = volume.at(panel[t]);
    if (outward == 0.0) out.encloses = false;
    if (outward < 0.0) out.weight[t] = -out.weight[t];
  }
  return out;
}

void round_bag(const Gear& gear, const std::vector<char>& held, const BagTriangles& bag,
               std::vector<double>& start) {
  // Rows of nodes by depth; tied points follow their nodes.
  std::map<double, std::vector<int>> rows;
  std::vector<char> known(start.size() / 3, 0);
  for (std::size_t k = 0; k < bag.node.size(); ++k) {
    const int node = bag.node[k];
    if (static_cast<std::size_t>(node) >= known.size() || known[node]) continue;
    known[node] = 1;
    rows[std::nearbyint(bag.depth[k] * 1e6)].push_back(node);
  }
  std::vector<double> girth;
  for (const int p : gear.bag.panels) girth.push_back(gear.panels[p].upper * gear.panels[p].unit());
  const double radius = nominal_hanging_ratio * exact_sum(girth) / (2 * pi);
  for (const auto& [depth, ring] : rows) {
    const double left = depth / 1e6 / gear.bag.deep;
    const double closing = std::max(0.0, 1 - 3 * left), share = std::min(1.0, 3 * (1 - left));
    const long double n = static_cast<long double>(ring.size());
    Vector middle;
    for (int c = 0; c < 3; ++c) {
      long double sum = 0.0L;
      for (const int node : ring) sum += at(start.data(), node)[c];
      middle[c] = static_cast<double>(sum / n);
    }
    std::vector<double> out;
    long double sum = 0.0L, rest = 0.0L;
    for (const int node : ring) {
      const Vector away = at(start.data(), node) - middle;
      long double squares = 0.0L;
      for (int c = 0; c < 3; ++c) squares += away[c] * away[c];
      out.push_back(std::sqrt(static_cast<double>(squares)));
      sum += out.back();
    }
    sum /= n;
    for (const double x : out) rest += x - sum;
    const double size = static_cast<double>(sum + rest / n);
    const double wanted = share * radius * std::sqrt(1 - closing * closing) + (1 - share) * size;
    if (size == 0.0 || wanted <= size) continue;
    for (const int node : ring) {
      if (held[node]) continue;
      const Vector away = at(start.data(), node) - middle;
      at(start.data(), node) = middle + away * (wanted / size);
    }
  }
}

}  // namespace codend
