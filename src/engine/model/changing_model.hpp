// All of a model that may change while it is solved or marched. Whoever changes it does so here, and
// the assembly over it is told; whoever solves it sees it const (Assembly::model()). What is not here
// stays as it was read: nodes, what they belong to, materials, laws, ground.
#pragma once

#include <utility>

#include "assembly.hpp"

namespace codend {

class ChangingModel {
 public:
  // assembly: over this model.
  ChangingModel(Model& model, Assembly& assembly) : model_(model), assembly_(assembly) {}

  const Model& now() const { return model_; }

  // m; rate: dL0/dt over L0, 1/s.
  void set_rest(int bar, double rest, double rate) {
    model_.bars.rest[bar] = rest;
    assembly_.update_bar(bar, rate);
  }
  // A bar that has broken carries nothing.
  void break_bar(int bar) {
    model_.bars.multiplicity[bar] = 0.0;
    assembly_.update_bar(bar, 0.0);
  }
  void set_mass(int point, double mass) { model_.mass[point] = mass; }  // kg
  // N, upwards: the weight less buoyancy of a point.
  void set_upward_load(int point, double load) {
    model_.load[3 * static_cast<std::size_t>(point) + 2] = load;
  }
  void set_sphere(int sphere, double drag_area, double added_mass) {  // m2, m3
    model_.spheres.drag_area[sphere] = drag_area;
    model_.spheres.added_mass[sphere] = added_mass;
  }
  void set_buoyancy(int volume, double buoyancy) {
    model_.volumes.buoyancy[volume] = buoyancy;
  }  // N
  // Weights of the triangles under a catch's pressure.
  void set_pressure_weight(const std::vector<double>& weight) { model_.pressure.weight = weight; }
  // m/s, at the k-th depth of the water's profile.
  void set_current(std::size_t k, const Vector& current) {
    model_.water.current[k] = current;
    assembly_.update();
  }
  // m/s2, by depth; empty: the current is steady.
  void set_current_rate(std::vector<Vector> rate) { model_.water.current_rate = std::move(rate); }
  // s, of the waves.
  void set_wave_time(double time) {
    model_.water.waves.time = time;
    assembly_.update();
  }
  // m, of all that may lie on the ground, as Assembly::ground_places(): it sticks there.
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
  // Where the assembly was last moved to.
  void draw_anchors() {
    model_.contacts.draw_anchors(assembly_.field());
    model_.plates.draw_anchors(assembly_.field());
  }

 private:
  Model& model_;
  Assembly& assembly_;
};

}  // namespace codend
