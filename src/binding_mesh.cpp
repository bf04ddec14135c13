// Meshes of gears: the engine holds them, R has handles to them.
#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/measured_gear.hpp"

using namespace binding;

namespace {

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

// Reads the fields that a list has into a struct, and leaves the others as they are.
class GivenFields {
 public:
  explicit GivenFields(const ListSource& from) : names_(from.names()), reader_(from, "", counts_) {}
  template <class Value>
  void operator()(const char* name, Value& value, codend::Shape shape = {}) {
    if (!has(name)) return;
    if constexpr (std::is_enum_v<Value>) {
      reader_(name, value);
    } else {
      reader_(name, value, shape);
    }
  }
  template <class Struct>
  void group(const char* name, Struct& of) {
    if (!has(name)) return;
    // What the list leaves out of a group, such as waves, is not there.
    Struct read;
    reader_.group(name, read);
    of = read;
  }
  template <class Struct>
  void optional(const char* name, Struct& of, bool& given) {
    if (!has(name)) return;
    group(name, of);
    given = true;
  }
  template <class Struct>
  void optional(const char* name, Struct& of) {
    group(name, of);
  }
  template <class Struct>
  void columns(const char* name, std::vector<Struct>& of) {
    if (has(name)) reader_.columns(name, of);
  }
  template <class Struct>
  void items(const char* name, std::vector<Struct>& of) {
    if (has(name)) reader_.items(name, of);
  }
  void count(codend::Among among, std::size_t n) { reader_.count(among, n); }
  void finish() const { reader_.finish(); }

 private:
  bool has(const char* name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }
  std::vector<std::string> names_;
  codend::FieldReader<ListSource>::Counts counts_{};
  codend::FieldReader<ListSource> reader_;
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
    GivenFields given(from);
    held.model.fields(given);
    given.finish();
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
    OneField field(name);
    held.model.fields(field);
    const list found = field.found();
    return found.size() ? found[0] : R_NilValue;
  });
}
