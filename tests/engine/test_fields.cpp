// What is read of a model by name, and what is refused.
#include <doctest/doctest.h>

#include <map>

#include "base/between.hpp"
#include "base/field_table.hpp"
#include "base/read_fields.hpp"
#include "gear/gear.hpp"
#include "model/evaluate.hpp"

namespace {

using namespace codend;

// Named arrays and groups; places count from 1.
struct Group {
  static constexpr int first_place = 1;
  std::map<std::string, std::vector<double>> arrays;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<std::string, Group> groups;
  std::map<std::string, std::vector<Group>> lists;

  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& entry : arrays) out.push_back(entry.first);
    for (const auto& entry : texts) out.push_back(entry.first);
    for (const auto& entry : groups) out.push_back(entry.first);
    for (const auto& entry : lists) out.push_back(entry.first);
    return out;
  }
  std::vector<double> numbers(const char* name) const {
    if (!arrays.count(name)) throw std::invalid_argument("must be numbers");
    return arrays.at(name);
  }
  std::vector<int> whole_numbers(const char* name) const {
    const std::vector<double> values = numbers(name);
    return std::vector<int>(values.begin(), values.end());
  }
  std::vector<std::string> words(const char* name) const { return texts.at(name); }
  Group group(const char* name) const { return groups.at(name); }
  std::vector<Group> items(const char* name) const { return lists.at(name); }
};

// All fields of a model with nothing in it, as the table has them.
Group empty_model() {
  Group model;
  model.lists["plates"] = {};
  model.lists["sliding"] = {};
  for (const FieldRow& row : field_table<Model>()) {
    Group* group = &model;
    std::string rest = row.kind;
    const std::string first = rest.substr(0, rest.find('.'));
    if (first == "plates" || first == "sliding") continue;
    // groups that a model may go without
    if (first == "ground" || first == "multipliers") continue;
    while (!rest.empty()) {
      const std::size_t dot = rest.find('.');
      group = &group->groups[rest.substr(0, dot)];
      rest = dot == std::string::npos ? "" : rest.substr(dot + 1);
    }
    if (row.type == "name") {
      group->texts[row.name] = {};
    } else {
      group->arrays[row.name] = {};
    }
  }
  model.arrays["nodes"] = {0.0};
  model.texts["slack_twine"] = {"curved"};
  Group& water = model.groups["water"];
  water.arrays = {{"density", {1025.0}}, {"viscosity", {1e-6}}, {"free_surface", {0.0}},
                  {"depth", {0.0}},      {"x", {0.8}},          {"y", {0.1}}};
  for (const char* field : {"depth", "rising", "time"}) {
    water.groups["waves"].arrays[field] = {0.0};
  }
  model.groups["pressure"].arrays["drag_coefficient"] = {1.4};
  return model;
}

// A bar of 2 m between a held node and a free one.
Group one_bar() {
  Group model = empty_model();
  model.arrays["nodes"] = {2.0};
  model.arrays["held"] = {1.0, 0.0};
  model.arrays["load"] = {0.0, 0.0, 0.0, 0.0, 0.0, -3.0};
  model.arrays["mass"] = {0.5, 0.5};
  Group& material = model.groups["materials"];
  for (auto& column : material.arrays) column.second = {0.0};
  material.arrays["axial_stiffness"] = {1e4};
  material.texts["law"] = {"takagi"};
  model.groups["bars"].arrays = {{"node", {1.0, 2.0}},
                                 {"rest", {2.0}},
                                 {"multiplicity", {1.0}},
                                 {"height", {0.1}},
                                 {"material", {1.0}}};
  return model;
}

// What reading says of a group, and of which field; "" of one that is read.
std::string complaint(const Group& group, std::string* field = nullptr) {
  try {
    read_fields<Model>(group);
  } catch (const InputError& error) {
    if (field) *field = error.field();
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a model is read by the names of its fields") {
  const Model model = read_fields<Model>(one_bar());
  CHECK(model.nodes == 2);
  CHECK(model.held == std::vector<char>{1, 0});
  CHECK(model.water.current[0] == Vector(0.8, 0.1, 0.0));
  CHECK(!model.ground.present);
  CHECK(model.bars.node == std::vector<int>{0, 1});
  CHECK(model.bars.rest == std::vector<double>{2.0});
  CHECK(model.materials.at(0).axial_stiffness == 1e4);
  CHECK(model.materials.at(0).law.kind == CylinderLawKind::takagi);
  CHECK(!model.materials.at(0).strut);
}

TEST_CASE("every field that is missing, too short or too long is named") {
  for (const char* name : {"node", "rest", "multiplicity", "height", "material"}) {
    CAPTURE(name);
    Group model = one_bar();
    std::string field;
    model.groups["bars"].arrays.erase(name);
    CHECK(complaint(model, &field) == "bars." + std::string(name) + " is missing");
    CHECK(field == "bars." + std::string(name));
    model = one_bar();
    model.groups["bars"].arrays[name].push_back(1.0);
    CHECK(complaint(model).find("bars." + std::string(name) + " has ") == 0);
  }
  Group model = one_bar();
  model.groups["bars"].arrays["rest"] = {2.0, 2.0};
  CHECK(complaint(model) == "bars.rest has 2 values, must have 1 (1 per element)");
  model = one_bar();
  model.arrays["load"].pop_back();
  CHECK(complaint(model) == "load has 5 values, must have 6 (3 per point)");
  model = one_bar();
  model.groups["bars"].arrays["breadth"] = {1.0};
  CHECK(complaint(model) == "bars.breadth is not a field of the model");
}

TEST_CASE("places that do not exist and numbers that are none are named") {
  // the last is the least that an int holds, which is R's missing value too
  for (const double place : {0.0, 3.0, -7.0, -2147483648.0}) {
    Group model = one_bar();
    model.groups["bars"].arrays["node"][1] = place;
    CHECK(complaint(model) == "bars.node[2] is " + std::to_string(static_cast<int>(place)) +
                                  ", must be from 1 to 2 (points)");
  }
  Group model = one_bar();
  model.groups["bars"].arrays["material"] = {2.0};
  CHECK(complaint(model) == "bars.material[1] is 2, must be from 1 to 1 (materials)");
  model = one_bar();
  model.groups["bars"].arrays["rest"] = {std::nan("")};
  CHECK(complaint(model) == "bars.rest[1] must be a finite number");
}

TEST_CASE("laws go by name, and an unknown one is none") {
  Group model = one_bar();
  model.groups["materials"].texts["law"] = {"hoerner"};
  CHECK(complaint(model) ==
        "materials.law is \"hoerner\", must be constant, takagi, choo_casarella or cifuentes_kim");
  model = one_bar();
  model.texts["slack_twine"] = {"loose"};
  CHECK(complaint(model) == "slack_twine is \"loose\", must be curved or straight");
}

TEST_CASE("copies of a model are whole") {
  Model copy;
  {
    Model model = read_fields<Model>(one_bar());
    model.prepare();
    copy = model;
    model.materials[0].axial_stiffness = 0.0;
    model.ground.present = true;
  }
  Assembly assembly(copy);
  const double x[6] = {0.0, 0.0, 0.0, 0.0, 0.0, -2.2}, v[6] = {};
  const Evaluation found = evaluate(assembly, x, v);
  // 1e4 N at a strain of 0.1; the strain is a difference of numbers of the size of 1.
  CHECK(found.bar_tension[0] == doctest::Approx(1e3).epsilon(1e-14));
}

TEST_CASE("every reported force is of a kind of the model, with three numbers per element") {
  const Model model = read_fields<Model>(one_bar());
  const std::vector<FieldRow> fields = field_table<Model>();
  for (const ReportedForce& force : reported_forces()) {
    CAPTURE(force.name);
    CHECK(std::any_of(fields.begin(), fields.end(),
                      [&](const FieldRow& row) { return row.kind == force.kind; }));
  }
  Model ready = model;
  ready.prepare();
  Assembly assembly(ready);
  const double x[6] = {0.0, 0.0, 0.0, 0.0, 0.0, -2.2}, v[6] = {};
  const Evaluation found = evaluate(assembly, x, v);
  CHECK(found.forces.size() == reported_forces().size());
  CHECK(found.reported("bar_drag").size() == 3);
  CHECK(found.reported("sphere_drag").empty());
}

TEST_CASE("numbers between two gears lie on their line, and all else must be the same") {
  Gear first, second;
  first.density = 1000.0;
  second.density = 1020.0;
  first.ropes.resize(1);
  first.ropes[0].shares = {0.25, 0.5};
  first.ropes[0].length = 8.0;
  second.ropes = first.ropes;
  second.ropes[0].shares[1] = 0.75;
  const std::optional<Gear> found = between(first, second, -0.5);
  REQUIRE(found.has_value());
  CHECK(found->density == 990.0);
  CHECK(found->ropes[0].shares == std::vector<double>{0.25, 0.375});
  CHECK(found->ropes[0].length == 8.0);
  second.ropes[0].segments = 3;
  CHECK_FALSE(between(first, second, -0.5).has_value());
  second.ropes = first.ropes;
  second.has_bag = true;
  CHECK_FALSE(between(first, second, -0.5).has_value());
}
