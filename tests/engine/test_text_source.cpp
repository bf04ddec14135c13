// Models read from a text, and what is said of wrong ones.
#include <doctest/doctest.h>

#include <string>

#include "codend.hpp"

using namespace codend;

namespace {

// A weight of 100 N on a rope of 2 m and 5000 N, in vacuum.
const std::string weight_on_rope = R"(
# all groups of a model, most of them empty
nodes whole 1 2   held mark 2 1 0
load number 6 0 0 0  0 0 -100
mass number 2 0 10   wake number 0   slack_twine name 1 curved
ties.first whole 0 ties.second whole 0 ties.share number 0
water.density number 1 0  water.viscosity number 1 1e-6  water.free_surface mark 1 0
water.depth number 1 0  water.x number 1 0  water.y number 1 0
materials.axial_stiffness number 1 5000
)";

// The rest of it from the table of fields: empty arrays, and one bar.
std::string whole_model() {
  std::string text = weight_on_rope;
  for (const FieldRow& row : field_table<Model>()) {
    if (row.kind.empty() || row.kind == "ties" || row.kind == "water" || row.kind == "ground" ||
        row.kind == "plates" || row.kind == "plates.polar" || row.kind == "sliding" ||
        (row.kind == "materials" && row.name == "axial_stiffness")) {
      continue;
    }
    const std::string type = row.type;
    std::string values = " 0";
    if (row.kind == "materials") {
      values = row.name == "law" ? " 1 constant" : row.name == "diameter" ? " 1 0.01" : " 1 0";
    } else if (row.kind == "bars") {
      values = row.name == "node" ? " 2 1 2" : row.name == "rest" ? " 1 2" : " 1 1";
    } else if (row.per == "group") {
      values = row.type == "name" ? "" : " 1 0";
    }
    text += row.kind + "." + row.name + " " + type + values + "\n";
  }
  return text + "plates list 0 sliding list 0\n";
}

std::string complaint(const std::string& text) {
  try {
    read_fields<Model>(TextSource(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE(place != std::string::npos);
  return text.replace(place, from.size(), to);
}

}  // namespace

TEST_CASE("what is wrong in a text is said with its field or its line") {
  const std::string text = whole_model();
  CHECK(complaint(text) == "");
  CHECK(complaint(replaced(text, "bars.node whole 2 1 2", "bars.node whole 2 1 3")) ==
        "bars.node[2] is 3, must be from 1 to 2 (points)");
  CHECK(complaint(replaced(text, "mass number 2 0 10", "mass number 2 0 nan")) ==
        "mass[2] must be a finite number");
  CHECK(complaint(replaced(text, "mass number 2 0 10", "mass number 1 10")) ==
        "mass has 1 values, must have 2 (1 per point)");
  CHECK(complaint(replaced(text, "mass number 2", "mass name 2")) == "mass must be numbers");
  CHECK(complaint(replaced(text, "slack_twine name 1 curved", "slack_twine name 1 slack"))
            .find("slack_twine is \"slack\", must be ") == 0);
  CHECK(complaint(replaced(text, "plates list 0", "plates list 1000000000")) ==
        "plates has 0 groups, must have 1000000000");
  CHECK(complaint(text + "colour name 1 red") == "colour is not a field of the model");
}

TEST_CASE("a text that is not of arrays is refused with its line") {
  CHECK(complaint("nodes whole 1 2\nnodes whole 1 2") == "line 2: nodes stands twice");
  CHECK(complaint("nodes whole 1") == "line 1: nodes has 0 values, must have 1");
  CHECK(complaint("nodes whole -1") == "line 1: nodes must say how many values it has, 0 or more");
  CHECK(complaint("nodes whole 99999999999") ==
        "line 1: nodes must say how many values it has, 0 or more");
  CHECK(complaint("nodes whole 1 2.5") == "line 1: nodes[1] is \"2.5\", must be a whole number");
  CHECK(complaint("\n\nnodes integer 1 2") ==
        "line 3: nodes has the type \"integer\", must have number, whole, mark, name or list");
  CHECK(complaint("a..b number 0") == "line 1: a name of an array must stand here, not \"a..b\"");
  CHECK(complaint("") == "nodes is missing");
}
