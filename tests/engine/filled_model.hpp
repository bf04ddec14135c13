// A model of bars in air that tests fill by hand.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "motion/motion.hpp"

namespace codend {

struct FilledModel {
  Model model;
  std::vector<double> x;  // m, 3 per node

  FilledModel() { model.water.density = 0.0; }

  int node(const Vector& place, bool held = false) {
    x.insert(x.end(), place.data(), place.data() + 3);
    model.held.push_back(held ? 1 : 0);
    model.load.insert(model.load.end(), 3, 0.0);
    model.mass.push_back(0.0);
    return model.nodes++;
  }
  int material(double axial_stiffness) {
    TwineMaterial m;
    m.axial_stiffness = axial_stiffness;
    model.materials.push_back(m);
    return static_cast<int>(model.materials.size()) - 1;
  }
  int bar(int a, int b, double rest, int material) {
    model.bars.node.push_back(a);
    model.bars.node.push_back(b);
    model.bars.rest.push_back(rest);
    model.bars.multiplicity.push_back(1.0);
    model.bars.material.push_back(material);
    return model.bars.count() - 1;
  }
  Motion at_rest() const {
    Motion out;
    out.x = Eigen::Map<const Values>(x.data(), static_cast<Eigen::Index>(x.size()));
    out.v = Values::Zero(out.x.size());
    return out;
  }
};

}  // namespace codend
