// Reads models by field name from a text of arrays, and checks error messages.
#include <doctest/doctest.h>

#include <map>
#include <string>

#include "base/between.hpp"
#include "codend.hpp"
#include "gear/gear.hpp"
#include "model/evaluate.hpp"

namespace {

using namespace codend;

// Lines of a text by array name: type, number of values, values.
using Lines = std::map<std::string, std::string>;

// A weight of 100 N on a rope of 2 m and 5000 N, in vacuum; all other arrays are empty.
Lines weight_on_rope() {
  Lines lines = {{"nodes", "whole 1 2"},
                 {"held", "mark 2 1 0"},
                 {"load", "number 6 0 0 0 0 0 -100"},
                 {"mass", "number 2 0 10"},
                 {"wake", "number 0"},
                 {"slack_twine", "name 1 curved"},
                 {"ties.first", "whole 0"},
                 {"ties.second", "whole 0"},
                 {"ties.share", "number 0"},
                 {"water.density", "number 1 0"},
                 {"water.viscosity", "number 1 1e-6"},
                 {"water.free_surface", "mark 1 0"},
                 {"water.speed", "number 1 1"},
                 {"water.depth", "number 1 0"},
                 {"water.x", "number 1 0.8"},
                 {"water.y", "number 1 0.1"},
                 {"materials.axial_stiffness", "number 1 5000"},
                 {"plates", "list 0"},
                 {"sliding", "list 0"}};
  for (const FieldRow& row : field_table<Model>()) {
    // optional groups of a model, and the fields above
    if (row.kind.empty() || row.kind == "ties" || row.kind == "water" || row.kind == "ground" ||
        row.kind == "plates" || row.kind == "plates.polar" || row.kind == "sliding") {
      continue;
    }
    std::string values = " 0";
    if (row.kind == "materials") {
      values = row.name == "law" ? " 1 takagi" : row.name == "diameter" ? " 1 0.01" : " 1 0";
    } else if (row.kind == "bars") {
      values = row.name == "node" ? " 2 1 2" : row.name == "rest" ? " 1 2" : " 1 1";
    } else if (row.per == "group") {
      values = row.type == "name" ? "" : " 1 0";
    }
    lines.insert({row.kind + "." + row.name, row.type + values});
  }
  return lines;
}

Model read(const Lines& lines) {
  std::string text;
  for (const auto& [name, values] : lines) text += name + " " + values + "\n";
  return read_fields<Model>(TextSource(text));
}

// Returns the error message of reading, and its field; "" if reading succeeds.
template <class Read>
std::string said_by(Read read, std::string* field = nullptr) {
  try {
    read();
  } catch (const InputError& error) {
    if (field) *field = error.field();
    return error.what();
  }
  return "";
}

// Returns the error message for the weight on its rope with some lines changed; an empty line is
// removed.
std::string complaint(const Lines& changes, std::string* field = nullptr) {
  Lines lines = weight_on_rope();
  for (const auto& [name, values] : changes) {
    if (values.empty()) {
      lines.erase(name);
    } else {
      lines[name] = values;
    }
  }
  return said_by([&] { read(lines); }, field);
}

std::string complaint_of(const std::string& text) {
  return said_by([&] { read_fields<Model>(TextSource(text)); });
}

}  // namespace

TEST_CASE("reading assigns the fields of a model by name") {
  const Model model = read(weight_on_rope());
  CHECK(model.nodes == 2);
  CHECK(model.held == std::vector<char>{1, 0});
  CHECK(model.water.current[0] == Vector(0.8, 0.1, 0.0));
  CHECK(!model.ground.present);
  CHECK(model.bars.node == std::vector<int>{0, 1});
  CHECK(model.bars.rest == std::vector<double>{2.0});
  CHECK(model.materials.at(0).axial_stiffness == 5000);
  CHECK(model.materials.at(0).law.kind == CylinderLawKind::takagi);
  CHECK(!model.materials.at(0).strut);
}

TEST_CASE("reading names each missing, too short or too long field") {
  for (const std::string name : {"node", "rest", "multiplicity", "height", "material"}) {
    CAPTURE(name);
    const std::string whole = "bars." + name;
    std::string field;
    CHECK(complaint({{whole, ""}}, &field) == whole + " is missing");
    CHECK(field == whole);
    const bool places = name == "node" || name == "material";
    CHECK(complaint({{whole, places ? "whole 3 1 2 1" : "number 3 1 1 1"}}).find(whole + " has ") ==
          0);
  }
  CHECK(complaint({{"bars.rest", "number 2 2 2"}}) ==
        "bars.rest has 2 values, must have 1 (1 per element)");
  CHECK(complaint({{"load", "number 5 0 0 0 0 0"}}) ==
        "load has 5 values, must have 6 (3 per point)");
  CHECK(complaint({{"bars.breadth", "number 1 1"}}) == "bars.breadth is not a field of the model");
  CHECK(complaint({{"mass", "name 2 0 10"}}) == "mass must be numbers");
  CHECK(complaint({{"plates", "list 1000000000"}}) == "plates has 0 groups, must have 1000000000");
}

TEST_CASE("reading names invalid indices and numbers that are not finite") {
  // the last is the smallest int, which is also R's missing value
  for (const std::string place : {"0", "3", "-7", "-2147483648"}) {
    CHECK(complaint({{"bars.node", "whole 2 1 " + place}}) ==
          "bars.node[2] is " + place + ", must be from 1 to 2 (points)");
  }
  CHECK(complaint({{"bars.material", "whole 1 2"}}) ==
        "bars.material[1] is 2, must be from 1 to 1 (materials)");
  CHECK(complaint({{"bars.rest", "number 1 nan"}}) == "bars.rest[1] must be a finite number");
}

TEST_CASE("reading accepts drag models by name and rejects unknown ones") {
  CHECK(complaint({{"materials.law", "name 1 hoerner"}}) ==
        "materials.law is \"hoerner\", must be constant, takagi, choo_casarella or cifuentes_kim");
  CHECK(complaint({{"slack_twine", "name 1 loose"}}) ==
        "slack_twine is \"loose\", must be curved or straight");
}

TEST_CASE("copying a model gives an independent model") {
  Model copy;
  {
    Model model = read(weight_on_rope());
    model.prepare();
    copy = model;
    model.materials[0].axial_stiffness = 0.0;
    model.ground.present = true;
  }
  Assembly assembly(copy);
  const double x[6] = {0.0, 0.0, 0.0, 0.0, 0.0, -2.2}, v[6] = {};
  const Evaluation found = evaluate(assembly, x, v);
  // 5000 N at a strain of 0.1; the strain is a difference of numbers of the size of 1.
  CHECK(found.bar_tension[0] == doctest::Approx(500.0).epsilon(1e-14));
}

TEST_CASE("each reported force belongs to an element kind, with three numbers each") {
  const Model model = read(weight_on_rope());
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

TEST_CASE("reading rejects a malformed text and gives the line") {
  CHECK(complaint_of("nodes whole 1 2\nnodes whole 1 2") == "line 2: nodes is given twice");
  CHECK(complaint_of("nodes whole 1") == "line 1: nodes has 0 values, must have 1");
  CHECK(complaint_of("nodes whole -1") == "line 1: nodes needs its number of values, 0 or more");
  CHECK(complaint_of("nodes whole 99999999999") ==
        "line 1: nodes needs its number of values, 0 or more");
  CHECK(complaint_of("nodes whole 1 2.5") == "line 1: nodes[1] is \"2.5\", must be a whole number");
  CHECK(complaint_of("\n\nnodes integer 1 2") ==
        "line 3: nodes has the type \"integer\", must have number, whole, mark, name or list");
  CHECK(complaint_of("a..b number 0") == "line 1: \"a..b\" must be the name of an array");
  CHECK(complaint_of("") == "nodes is missing");
}

TEST_CASE("interpolation between two gears is linear and rejects other differences") {
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
