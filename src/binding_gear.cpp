// Lattices of gears for R.
#include "binding_list.h"
#include "binding_model.h"
#include "engine/solve/layout.hpp"

using namespace binding;

namespace {

codend::Gear read_gear(const list& numbers) {
  codend::Gear gear = codend::read_fields<codend::Gear>(ListSource(numbers));
  gear.check();
  return gear;
}

void lay_out_strings(const codend::Strings& strings, double* x) {
  codend::lay_out(
      {strings.held, strings.ends, strings.rest, strings.tension, strings.load, strings.buoyant}, x,
      [] {
        check_user_interrupt();
        return true;
      });
}

}  // namespace

// model: the numbers of its model; blocked: meshes of its catch behind the front; counts: of another
// lattice of the gear, or NULL; map: of the lattice that `position` (3 x points) is
// carried over from, or NULL; alike: whether that one is divided alike.
[[cpp11::register]] list engine_lattice(list numbers, list model, double blocked, double nodes,
                                        SEXP counts, SEXP map, doubles position, bool alike) {
  return guarded([&]() -> list {
    const codend::Gear gear = read_gear(numbers);
    codend::Counts known;
    codend::Fineness fineness;
    fineness.nodes = nodes;
    if (!Rf_isNull(counts)) {
      known = codend::read_fields<codend::Counts>(ListSource(counts));
      fineness.counts = &known;
    }
    codend::FromShape from;
    from.given = position.size() > 0;
    from.alike = alike;
    from.position = binding::numbers(position);
    if (!Rf_isNull(map)) from.map = codend::read_fields<codend::PartMap>(ListSource(map));
    codend::MeasuredGear found = codend::unprepared_gear(
        gear, codend::read_fields<codend::GearModel>(ListSource(model)),
        codend::build_lattice(gear, fineness, from, lay_out_strings), blocked);
    codend::MeasureFrame frame = codend::measure_frame(gear, found.lattice);
    return mesh_list(std::move(found), std::move(frame));
  });
}

// How many nodes a gear would have: list(nodes = of every panel, then of every rope, divided = whether
// it says itself how it is divided).
[[cpp11::register]] list engine_node_counts(list numbers, double nodes) {
  return guarded([&]() -> list {
    codend::NodeCounts found = codend::count_nodes(read_gear(numbers), nodes);
    return ListWriter::written(found);
  });
}
