// Meshes of gears: the engine holds them, R has handles to them.
#include "binding_list.h"
#include "binding_model.h"

using namespace binding;

namespace {

codend::Model& model_of_handle(SEXP mesh) {
  if (TYPEOF(mesh) != EXTPTRSXP) throw codend::InputError("mesh", "mesh must be a mesh");
  auto* held = static_cast<codend::Model*>(R_ExternalPtrAddr(mesh));
  if (!held) throw codend::InputError("mesh", "mesh is of another process");
  return *held;
}

// Writes one field of a struct.
class OneField {
 public:
  explicit OneField(const std::string& name) : name_(name) {}
  template <class Value>
  void operator()(const char* name, Value& value, codend::Shape shape = {}) {
    if (name_ == name) writer_(name, value, shape);
  }
  template <class... Rest>
  void group(const char* name, Rest&&... rest) {
    if (name_ == name) writer_.group(name, rest...);
  }
  template <class... Rest>
  void optional(const char* name, Rest&&... rest) {
    if (name_ == name) writer_.optional(name, rest...);
  }
  template <class... Rest>
  void columns(const char* name, Rest&&... rest) {
    if (name_ == name) writer_.columns(name, rest...);
  }
  template <class... Rest>
  void items(const char* name, Rest&&... rest) {
    if (name_ == name) writer_.items(name, rest...);
  }
  void count(codend::Among, std::size_t) {}
  list found() const { return writer_.all(); }

 private:
  const std::string& name_;
  ListWriter writer_;
};

}  // namespace

namespace binding {

sexp mesh_handle(codend::Model&& model) {
  external_pointer<codend::Model> handle(new codend::Model(std::move(model)));
  sexp out(static_cast<SEXP>(handle));
  out.attr("class") = "codend_mesh";
  return out;
}

codend::Model read_model(SEXP mesh) {
  codend::Model model = model_of_handle(mesh);
  model.prepare();
  return model;
}

}  // namespace binding

// A mesh from all of its fields, see codend::Model.
[[cpp11::register]] SEXP engine_mesh(list fields) {
  return guarded([&]() -> SEXP {
    return mesh_handle(codend::read_fields<codend::Model>(ListSource(fields)));
  });
}

// All fields of a mesh.
[[cpp11::register]] list engine_mesh_fields(SEXP mesh) {
  return guarded([&]() -> list { return ListWriter::written(model_of_handle(mesh)); });
}

// A field of a mesh, or NULL where it has none of the name.
[[cpp11::register]] SEXP engine_mesh_field(SEXP mesh, std::string name) {
  return guarded([&]() -> SEXP {
    OneField field(name);
    model_of_handle(mesh).fields(field);
    const list found = field.found();
    return found.size() ? found[0] : R_NilValue;
  });
}
