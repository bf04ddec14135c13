// Meshes of gears: the engine holds them, R has handles to them.
#include "binding_list.h"
#include "binding_model.h"

using namespace binding;

namespace {

// Shows a visitor those fields of a struct that have one of these names.
template <class Visit>
class NamedFields {
 public:
  NamedFields(const std::vector<std::string>& names, Visit& visit) : names_(names), visit_(visit) {}
  template <class Value>
  void operator()(const char* name, Value& value, codend::Shape shape = {}) {
    if (has(name)) visit_(name, value, shape);
  }
  template <class... Rest>
  void group(const char* name, Rest&&... rest) {
    if (has(name)) visit_.group(name, rest...);
  }
  template <class... Rest>
  void optional(const char* name, Rest&&... rest) {
    if (has(name)) visit_.optional(name, rest...);
  }
  template <class... Rest>
  void columns(const char* name, Rest&&... rest) {
    if (has(name)) visit_.columns(name, rest...);
  }
  template <class... Rest>
  void items(const char* name, Rest&&... rest) {
    if (has(name)) visit_.items(name, rest...);
  }
  void count(codend::Among among, std::size_t n) { visit_.count(among, n); }

 private:
  bool has(const char* name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }
  const std::vector<std::string>& names_;
  Visit& visit_;
};

}  // namespace

namespace binding {

sexp mesh_handle(HeldMesh&& mesh) {
  const external_pointer<HeldMesh> handle(new HeldMesh(std::move(mesh)));
  sexp out(static_cast<SEXP>(handle));
  out.attr("class") = "codend_mesh";
  return out;
}

HeldMesh& held_mesh(SEXP handle) {
  if (TYPEOF(handle) != EXTPTRSXP) throw codend::InputError("mesh", "mesh must be a mesh");
  auto* held = static_cast<HeldMesh*>(R_ExternalPtrAddr(handle));
  if (!held) throw codend::InputError("mesh", "mesh is of another process");
  return *held;
}

codend::Model read_model(SEXP handle) {
  codend::Model model = held_mesh(handle).model;
  model.prepare();
  return model;
}

list mesh_list(codend::MeasuredGear&& gear, codend::MeasureFrame&& frame) {
  writable::list out(ListWriter::written(gear.lattice));
  out.push_back("mesh"_nm =
                    mesh_handle({std::move(gear.model), std::move(frame), std::move(gear.bag)}));
  return out;
}

}  // namespace binding

// A mesh from all of its fields, see codend::Model.
[[cpp11::register]] SEXP engine_mesh(list fields) {
  return guarded([&]() -> SEXP {
    HeldMesh held;
    held.model = codend::read_fields<codend::Model>(ListSource(fields));
    return mesh_handle(std::move(held));
  });
}

// A mesh like another but for these fields; groups of them are whole.
[[cpp11::register]] SEXP engine_changed_mesh(SEXP mesh, list fields) {
  return guarded([&]() -> SEXP {
    HeldMesh held = held_mesh(mesh);
    const ListSource from(fields);
    const std::vector<std::string> names = from.names();
    codend::FieldReader<ListSource>::Counts counts{};
    codend::FieldReader<ListSource> reader(from, "", counts);
    NamedFields given(names, reader);
    held.model.fields(given);
    reader.finish();
    return mesh_handle(std::move(held));
  });
}

// A mesh whose catch has its front `blocked` meshes from the bag's end.
[[cpp11::register]] SEXP engine_filled_mesh(SEXP mesh, double blocked) {
  return guarded([&]() -> SEXP {
    HeldMesh held = held_mesh(mesh);
    held.bag.blocked = blocked;
    codend::press(held.bag, held.model);
    return mesh_handle(std::move(held));
  });
}

// All fields of a mesh.
[[cpp11::register]] list engine_mesh_fields(SEXP mesh) {
  return guarded([&]() -> list { return ListWriter::written(held_mesh(mesh).model); });
}

// A field of a mesh, or its `frame` (codend::MeasureFrame) or `bag` (codend::FilledBag); NULL where it has
// none of the name.
[[cpp11::register]] SEXP engine_mesh_field(SEXP mesh, std::string name) {
  return guarded([&]() -> SEXP {
    HeldMesh& held = held_mesh(mesh);
    if (name == "frame") return ListWriter::written(held.frame);
    if (name == "bag" && held.catch_bag()) return ListWriter::written(held.bag);
    const std::vector<std::string> names{name};
    ListWriter writer;
    NamedFields field(names, writer);
    held.model.fields(field);
    const list found = writer.all();
    return found.size() ? found[0] : R_NilValue;
  });
}
