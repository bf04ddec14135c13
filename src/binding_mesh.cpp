// R interface: models of gears, stored in the engine; R has handles to them.
#include "binding_list.h"
#include "binding_model.h"

using namespace binding;

namespace {

// Passes only the fields of a struct with the given names to a visitor.
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

sexp model_handle(HeldModel&& model) {
  const external_pointer<HeldModel> handle(new HeldModel(std::move(model)));
  sexp out(static_cast<SEXP>(handle));
  out.attr("class") = "codend_model";
  return out;
}

HeldModel& held_model(SEXP handle) {
  if (TYPEOF(handle) != EXTPTRSXP)
    throw codend::InputError("model", "model must be a model of the engine");
  auto* held = static_cast<HeldModel*>(R_ExternalPtrAddr(handle));
  if (!held) throw codend::InputError("model", "model is from another process");
  return *held;
}

codend::Model read_model(SEXP handle) {
  codend::Model model = held_model(handle).model;
  model.prepare();
  return model;
}

list mesh_list(codend::MeasuredGear&& gear, codend::MeasureFrame&& frame) {
  writable::list out(ListWriter::written(gear.mesh));
  out.push_back("model"_nm =
                    model_handle({std::move(gear.model), std::move(frame), std::move(gear.bag)}));
  return out;
}

}  // namespace binding

// Creates a model from all of its fields, see codend::Model.
[[cpp11::register]] SEXP engine_model(list fields) {
  return guarded([&]() -> SEXP {
    HeldModel held;
    held.model = codend::read_fields<codend::Model>(ListSource(fields));
    return model_handle(std::move(held));
  });
}

// Returns a copy of a model with some fields replaced; a group of fields must be complete.
[[cpp11::register]] SEXP engine_changed_model(SEXP handle, list fields) {
  return guarded([&]() -> SEXP {
    HeldModel held = held_model(handle);
    const ListSource from(fields);
    const std::vector<std::string> names = from.names();
    codend::FieldReader<ListSource>::Counts counts{};
    codend::FieldReader<ListSource> reader(from, "", counts);
    NamedFields given(names, reader);
    held.model.fields(given);
    reader.finish();
    return model_handle(std::move(held));
  });
}

// Returns a copy of a model with the front of its catch `blocked` meshes from the end of the bag.
[[cpp11::register]] SEXP engine_filled_model(SEXP handle, double blocked) {
  return guarded([&]() -> SEXP {
    HeldModel held = held_model(handle);
    held.bag.blocked = blocked;
    codend::press(held.bag, held.model);
    return model_handle(std::move(held));
  });
}

// Returns all fields of a model.
[[cpp11::register]] list engine_model_fields(SEXP handle) {
  return guarded([&]() -> list { return ListWriter::written(held_model(handle).model); });
}

// Returns a field of a model, or its `frame` (codend::MeasureFrame) or `bag` (codend::FilledBag);
// NULL if there is no such field.
[[cpp11::register]] SEXP engine_model_field(SEXP handle, std::string name) {
  return guarded([&]() -> SEXP {
    HeldModel& held = held_model(handle);
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
