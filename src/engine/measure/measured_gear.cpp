#include "measured_gear.hpp"

#include "../solve/layout.hpp"

namespace codend {

MeasuredGear measured_gear(const GearNumbers& numbers, const Gear& gear, const Fineness& fineness,
                           const FromShape& from, const std::function<void()>& pause) {
  MeasuredGear out;
  out.lattice = build_lattice(gear, fineness, from, [&](const Strings& strings, double* x) {
    lay_out(
        {strings.held, strings.ends, strings.rest, strings.tension, strings.load, strings.buoyant},
        x, [&] {
          if (pause) pause();
          return true;
        });
  });
  out.model = model_of(gear, out.lattice, numbers.model);
  if (gear.has_bag) {
    out.bag = filled_bag(out.lattice, numbers.blocked);
    press(out.bag, out.model);
  }
  out.model.prepare();
  return out;
}

FilledBag filled_bag(const Lattice& lattice, double blocked) {
  const BagTriangles& bag = lattice.bag;
  return {static_cast<int>(lattice.mass.size()),
          bag.node,
          bag.depth,
          bag.across,
          bag.real,
          bag.weight,
          blocked};
}

void press(const FilledBag& bag, Model& model) {
  model.pressure.node = bag.node;
  model.pressure.weight = pressure_weights(bag);
}

std::vector<double> measures_at(const GearNumbers& numbers, const Gear& gear,
                                const MeasuredGear& of, Assembly& assembly,
                                const std::vector<double>& x) {
  const std::vector<double> still(x.size(), 0.0);
  const Evaluation found = evaluate(assembly, x.data(), still.data());
  return measure(measure_frame(gear, of.lattice), of.model, numbers.questions,
                 gear.has_bag ? &of.bag : nullptr, measured_shape(found, x, still));
}

}  // namespace codend
