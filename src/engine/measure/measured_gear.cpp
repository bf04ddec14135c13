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
    const BagTriangles& bag = out.lattice.bag;
    out.bag = {static_cast<int>(out.lattice.mass.size()),
               bag.node,
               bag.depth,
               bag.across,
               bag.real,
               bag.weight,
               numbers.blocked};
    out.model.pressure.node = bag.node;
    out.model.pressure.weight = pressure_weights(out.bag);
  }
  return out;
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
