#include "measured_gear.hpp"

#include "../solve/layout.hpp"

namespace codend {

MeasuredGear measured_gear(const GearNumbers& numbers, const Gear& gear, const Fineness& fineness,
                           const FromShape& from, const std::function<void()>& pause) {
  const auto lay_out_strings = [&](const Strings& strings, double* x) {
    lay_out(
        {strings.held, strings.ends, strings.rest, strings.tension, strings.load, strings.buoyant},
        x, [&] {
          if (pause) pause();
          return true;
        });
  };
  MeasuredGear out = unprepared_gear(
      gear, numbers.model, build_mesh(gear, fineness, from, lay_out_strings), numbers.blocked);
  out.model.prepare();
  return out;
}

MeasuredGear unprepared_gear(const Gear& gear, const GearModel& numbers, Mesh&& mesh,
                             double blocked) {
  MeasuredGear out;
  out.model = model_of(gear, mesh, numbers);
  if (gear.has_bag) {
    const BagTriangles& bag = mesh.bag;
    out.bag = {static_cast<int>(mesh.mass.size()),
               bag.node,
               bag.depth,
               bag.across,
               bag.real,
               bag.weight,
               bag.height,
               blocked};
    press(out.bag, out.model);
  }
  out.mesh = std::move(mesh);
  return out;
}

void press(const FilledBag& bag, Model& model) {
  model.pressure.node = bag.node;
  model.pressure.weight = pressure_weights(bag);
  model.pressure.height = bag.height;
}

std::vector<double> measures_at(const GearNumbers& numbers, const Gear& gear,
                                const MeasuredGear& of, Assembly& assembly,
                                const std::vector<double>& x) {
  const std::vector<double> still(x.size(), 0.0);
  const Evaluation found = evaluate(assembly, x.data(), still.data());
  return measure(measure_frame(gear, of.mesh), of.model, numbers.questions,
                 gear.has_bag ? &of.bag : nullptr, measured_shape(found, x, still));
}

}  // namespace codend
