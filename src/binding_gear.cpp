// R interface: discretisation of gears.
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

// Returns a discretisation, see mesh_list(). `model`: input of its model. `blocked`: meshes of its
// catch behind the front. `nodes`: approximate number. `counts`: of another discretisation of the
// gear, or NULL. `map`: of the discretisation of `position` (3 x points) for interpolation, or
// NULL. `alike`: both have the same mesh.
[[cpp11::register]] list engine_mesh(list numbers, list model, double blocked, double nodes,
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
    codend::MeasuredGear found =
        codend::unprepared_gear(gear, codend::read_fields<codend::GearModel>(ListSource(model)),
                                codend::build_mesh(gear, fineness, from, lay_out_strings), blocked);
    codend::MeasureFrame frame = codend::measure_frame(gear, found.mesh);
    return mesh_list(std::move(found), std::move(frame));
  });
}

// Returns list(nodes, divided): the number of nodes of every panel, then of every rope; TRUE if the
// gear prescribes its mesh.
[[cpp11::register]] list engine_node_counts(list numbers, double nodes) {
  return guarded([&]() -> list {
    codend::NodeCounts found = codend::count_nodes(read_gear(numbers), nodes);
    return ListWriter::written(found);
  });
}
