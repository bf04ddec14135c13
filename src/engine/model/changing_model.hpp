// Write access to all model data that may change during a solution or time integration. Each change
// also updates the assembly. Solvers have only read access (Assembly::model()). All other data are
// constant: nodes, topology, materials, drag models and ground.
#pragma once

#include <utility>

#include "assembly.hpp"

namespace codend {

class ChangingModel {
 public:
  // assembly: built on this model.
  ChangingModel(Model& model, Assembly& assembly) : model_(model), assembly_(assembly) {}

  const Model& now() const { return model_; }

  // rest: m; rate: dL0/dt over L0, 1/s.
  void set_rest(int bar, double rest, double rate) {
    model_.bars.rest[bar] = rest;
    assembly_.update_bar(bar, rate);
  }
  // Removes the force of a broken bar.
  void break_bar(int bar) {
    model_.bars.multiplicity[bar] = 0.0;
    assembly_.update_bar(bar, 0.0);
  }
  void set_mass(int point, double mass) { model_.mass[point] = mass; }  // kg
  // load: weight less buoyancy, positive upwards, N.
  void set_upward_load(int point, double load) {
    model_.load[3 * static_cast<std::size_t>(point) + 2] = load;
  }
  void set_sphere(int sphere, double drag_area, double added_mass) {  // m2, m3
    model_.spheres.drag_area[sphere] = drag_area;
    model_.spheres.added_mass[sphere] = added_mass;
  }
  void set_buoyancy(int volume, double buoyancy) {
    model_.volumes.buoyancy[volume] = buoyancy;  // N
  }
  // weight: per triangle under catch pressure.
  void set_pressure_weight(const std::vector<double>& weight) { model_.pressure.weight = weight; }
  // current: m/s, at the k-th depth of the profile.
  void set_current(std::size_t k, const Vector& current) {
    model_.water.current[k] = current;
    assembly_.update();
  }
  // rate: m/s2, per depth; empty for a steady current.
  void set_current_rate(std::vector<Vector> rate) { model_.water.current_rate = std::move(rate); }
  // time: s.
  void set_wave_time(double time) {
    model_.water.waves.time = time;
    assembly_.update();
  }
  // anchor: m, in the order of Assembly::ground_places(). Static friction acts from these points.
  void set_anchors(const std::vector<Vector>& anchor) {
    const auto shoes = anchor.begin() + model_.contacts.count();
    model_.contacts.anchor.assign(anchor.begin(), shoes);
    model_.plates.anchor.assign(shoes, anchor.end());
  }
  std::vector<Vector> anchors() const {
    std::vector<Vector> out = model_.contacts.anchor;
    out.insert(out.end(), model_.plates.anchor.begin(), model_.plates.anchor.end());
    return out;
  }
  // Updates all anchors at the present state of the assembly.
  void draw_anchors() {
    model_.contacts.draw_anchors(assembly_.field());
    model_.plates.draw_anchors(assembly_.field());
  }

 private:
  Model& model_;
  Assembly& assembly_;
};

}  // namespace codend
