// Assembly::hold() skips elements whose nodes are all fixed; compared with a full assembly.
#include <doctest/doctest.h>

#include <vector>

#include "random_model.hpp"

namespace {

using namespace codend;

constexpr int rows = 5, columns = 40;

// A sheet of square netting in a sheared current, five knots deep and forty long. Every knot has a
// float with volume and drag.
Model sheet() {
  Model model;
  model.nodes = rows * columns;
  model.held.assign(model.nodes, 0);
  model.mass.assign(model.nodes, 0.1);
  model.load.assign(3 * model.nodes, 0.5);
  TwineMaterial twine;
  twine.diameter = 0.002;
  twine.axial_stiffness = 100.0;
  twine.law.kind = CylinderLawKind::constant;
  twine.law.normal = 1.2;
  twine.law.tangential = 0.1;
  model.materials = {twine};
  model.water.depth = {0.0, 50.0};
  model.water.current = {{1.0, 0.2, 0.0}, {0.3, 0.0, 0.0}};
  model.water.free_surface = true;
  for (int i = 0; i + 1 < columns; ++i) {
    for (int j = 0; j + 1 < rows; ++j) {
      const int first = rows * i + j;
      for (const int n : {first, first + rows, first + rows + 1, first + 1}) {
        model.cells.node.push_back(n);
      }
      for (const double t : {0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0})
        model.cells.twine.push_back(t);
      model.cells.rest.push_back(0.1);
      model.cells.multiplicity.push_back(1.0);
      model.cells.material.push_back(0);
      model.cells.height.push_back(0.4);
    }
  }
  for (int n = 0; n < model.nodes; ++n) {
    model.spheres.node.push_back(n);
    model.spheres.drag_area.push_back(0.01);
    model.spheres.diameter.push_back(0.1);
    model.spheres.added_mass.push_back(0.001);
    model.spheres.height.push_back(0.1);
    model.volumes.node.push_back(n);
    model.volumes.buoyancy.push_back(2.0);
    model.volumes.height.push_back(0.1);
  }
  model.prepare();
  return model;
}

struct Found {
  std::vector<double> force, blocks, strain;
};

Found found(Assembly& assembly, const std::vector<double>& x, const std::vector<double>& v,
            const std::vector<double>& dx) {
  Found out;
  assembly.move_to(x.data(), v.data());
  out.force.resize(x.size());
  assembly.residual(out.force.data());
  out.blocks.resize(9 * assembly.pattern().column.size());
  assembly.jacobian({1.0, 3.0}, out.blocks.data());
  out.strain = assembly.line_change(dx.data()).strain;
  return out;
}

}  // namespace

TEST_CASE("hold() keeps forces and derivatives of free nodes unchanged") {
  Model model = sheet();
  Random random(20261122);
  const std::size_t size = 3 * static_cast<std::size_t>(model.nodes);
  std::vector<double> x(size), v(size, 0.0), dx(size, 0.0);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      at(x.data(), rows * i + j) = Vector(0.41 * i, 0.0, -0.4 * j) + random.vector(0.02);
    }
  }
  const std::vector<double> start = x;
  Assembly some(model);
  // Released from one end, fixed again as by a rejected step, and finally all released.
  for (const int released : {3, 10, 22, 9, 9, 31, columns}) {
    std::vector<char> held(static_cast<std::size_t>(model.nodes), 0);
    for (int n = 0; n < model.nodes; ++n) {
      held[static_cast<std::size_t>(n)] = n >= rows * released;
      const bool moves = n < rows * released;
      at(x.data(), n) = at(start.data(), n);
      if (moves) at(x.data(), n) += random.vector(0.02);
      at(v.data(), n) = moves ? random.vector(0.5) : Vector(Vector::Zero());
      at(dx.data(), n) = moves ? random.vector(0.01) : Vector(Vector::Zero());
    }
    // The current changes meanwhile.
    model.water.current[0] = random.vector(1.0);
    some.update();
    some.hold(held);
    Assembly all(model);
    for (int repeat = 0; repeat < 2; ++repeat) {
      const Found part = found(some, x, v, dx), whole = found(all, x, v, dx);
      for (int n = 0; n < model.nodes; ++n) {
        if (held[static_cast<std::size_t>(n)]) {
          CHECK(at(part.force.data(), n) == Vector(Vector::Zero()));
          continue;
        }
        CHECK(at(part.force.data(), n) == at(whole.force.data(), n));
        const BlockPattern& pattern = some.pattern();
        for (std::int64_t b = 9 * pattern.row_start[n]; b < 9 * pattern.row_start[n + 1]; ++b) {
          CHECK(part.blocks[static_cast<std::size_t>(b)] ==
                whole.blocks[static_cast<std::size_t>(b)]);
        }
      }
      CHECK(part.strain == whole.strain);
    }
    // The full evaluation includes every element.
    const Evaluation part = evaluate(some, x.data(), v.data()),
                     whole = evaluate(all, x.data(), v.data());
    CHECK(part.u_tension == whole.u_tension);
    for (std::size_t k = 0; k < whole.forces.size(); ++k) CHECK(part.forces[k] == whole.forces[k]);
  }
}
