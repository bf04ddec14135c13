// The one file that knows both R and the engine: a lattice (an R list) in, numbers out.
#include <algorithm>
#include <cpp11.hpp>
#include <string>

#include "engine/assembly.hpp"
#include "engine/evaluate.hpp"
#include "engine/solve/layout.hpp"
#include "engine/solve/settle.hpp"
#include "engine/solve/substitution.hpp"

using namespace cpp11;
namespace writable = cpp11::writable;

namespace {

std::vector<double> numbers(const doubles& values) {
  const double* first = REAL(values);
  return std::vector<double>(first, first + values.size());
}

std::vector<double> numbers(const list& from, const char* name) {
  return numbers(doubles(from[name]));
}

std::vector<int> whole_numbers(const integers& values) {
  const int* first = INTEGER(values);
  return std::vector<int>(first, first + values.size());
}

std::vector<int> whole_numbers(const list& from, const char* name) {
  return whole_numbers(integers(from[name]));
}

// R counts from 1.
std::vector<int> places(const integers& values) {
  std::vector<int> out = whole_numbers(values);
  for (int& place : out) --place;
  return out;
}

std::vector<int> places(const list& from, const char* name) { return places(integers(from[name])); }

std::vector<char> marks(const logicals& values) {
  std::vector<char> out(values.size());
  const int* from = LOGICAL(values);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = from[k] == TRUE ? 1 : 0;
  return out;
}

double number(const list& from, const char* name) { return as_cpp<double>(from[name]); }

codend::Vector vector_of(const list& from, const char* name) {
  const doubles values(from[name]);
  return {values[0], values[1], values[2]};
}

codend::Ground read_ground(const list& from) {
  codend::Ground ground;
  ground.present = true;
  ground.normal = vector_of(from, "normal");
  ground.height = number(from, "height");
  ground.velocity = vector_of(from, "velocity");
  ground.friction = number(from, "friction");
  ground.stiffness = number(from, "stiffness");
  return ground;
}

// A list of boards, each a list of its numbers.
void read_boards(const list& from, codend::OtterBoards& boards) {
  for (const SEXP item : from) {
    const list one(item);
    for (const int node : places(one, "node")) boards.node.push_back(node);
    const doubles attachment(one["attachment"]);
    codend::OtterBoard board;
    for (int k = 0; k < 3; ++k) {
      board.attachment[k] = {attachment[3 * k], attachment[3 * k + 1], attachment[3 * k + 2]};
    }
    board.side = number(one, "side");
    board.chord = number(one, "chord");
    board.span = number(one, "span");
    board.area = number(one, "area");
    board.pressure_centre = number(one, "pressure_centre");
    board.weight = number(one, "weight");
    board.buoyancy = number(one, "buoyancy");
    board.gravity_centre = vector_of(one, "gravity_centre");
    board.buoyancy_centre = vector_of(one, "buoyancy_centre");
    board.added_mass = number(one, "added_mass");
    board.shoe_area = number(one, "shoe_area");
    const list polar(one["polar"]);
    board.polar.angle = numbers(polar, "angle");
    board.polar.lift = numbers(polar, "lift");
    board.polar.drag = numbers(polar, "drag");
    board.polar.lift_slope = numbers(polar, "lift_slope");
    board.polar.drag_slope = numbers(polar, "drag_slope");
    boards.board.push_back(board);
  }
}

// Copies every array once. The caller connects the model where it comes to lie.
codend::Model read_model(const list& lattice) {
  codend::Model model;
  model.nodes = as_cpp<int>(lattice["nodes"]);
  model.held = marks(logicals(lattice["held"]));

  const list ties(lattice["ties"]);
  const std::vector<int> first = places(ties, "first"), second = places(ties, "second");
  const std::vector<double> share = numbers(ties, "share");
  model.ties.reserve(share.size());
  for (std::size_t t = 0; t < share.size(); ++t) {
    model.ties.push_back({first[t], second[t], share[t]});
  }

  const list water(lattice["water"]);
  model.water.density = number(water, "density");
  model.water.viscosity = number(water, "viscosity");
  model.water.depth = numbers(water, "depth");
  const std::vector<double> x = numbers(water, "x"), y = numbers(water, "y");
  model.water.free_surface = as_cpp<bool>(water["free_surface"]);
  model.water.current.clear();
  for (std::size_t k = 0; k < x.size(); ++k) model.water.current.emplace_back(x[k], y[k], 0.0);
  model.slack = as_cpp<std::string>(lattice["slack_twine"]) == "straight"
                    ? codend::SlackDrag::straight
                    : codend::SlackDrag::curved;

  model.load = numbers(lattice, "load");
  model.mass = numbers(lattice, "mass");

  const list materials(lattice["materials"]);
  const std::vector<double> stiffness = numbers(materials, "axial_stiffness"),
                            diameter = numbers(materials, "diameter"),
                            volume = numbers(materials, "volume_per_length"),
                            added_normal = numbers(materials, "added_mass_normal"),
                            added_tangential = numbers(materials, "added_mass_tangential"),
                            normal = numbers(materials, "normal"),
                            tangential = numbers(materials, "tangential"),
                            skin = numbers(materials, "skin"),
                            solidity = numbers(materials, "solidity");
  const std::vector<int> law = whole_numbers(materials, "law"),
                         strut = whole_numbers(materials, "strut");
  for (std::size_t m = 0; m < stiffness.size(); ++m) {
    codend::TwineMaterial material;
    material.axial_stiffness = stiffness[m];
    material.diameter = diameter[m];
    material.volume_per_length = volume[m];
    material.added_mass_normal = added_normal[m];
    material.added_mass_tangential = added_tangential[m];
    material.law = {static_cast<codend::CylinderLawKind>(law[m]), normal[m], tangential[m],
                    skin[m], solidity[m]};
    material.strut = strut[m] != 0;
    model.materials.push_back(material);
  }

  const list bars(lattice["bars"]);
  model.bars.node = places(bars, "node");
  model.bars.rest = numbers(bars, "rest");
  model.bars.multiplicity = numbers(bars, "multiplicity");
  model.bars.material = places(bars, "material");

  const list triangles(lattice["triangles"]);
  model.triangles.node = places(triangles, "node");
  model.triangles.twine = numbers(triangles, "twine");
  model.triangles.rest = numbers(triangles, "rest");
  model.triangles.multiplicity = numbers(triangles, "multiplicity");
  model.triangles.material = places(triangles, "material");

  const list spheres(lattice["spheres"]);
  model.spheres.node = places(spheres, "node");
  model.spheres.drag_area = numbers(spheres, "drag_area");
  model.spheres.diameter = numbers(spheres, "diameter");
  model.spheres.added_mass = numbers(spheres, "added_mass");
  model.spheres.height = numbers(spheres, "height");

  const list lifts(lattice["lifts"]);
  model.lifts.node = places(lifts, "node");
  model.lifts.lift_area = numbers(lifts, "lift_area");
  model.lifts.direction = whole_numbers(lifts, "direction");
  model.lifts.height = numbers(lifts, "height");

  const list contacts(lattice["contacts"]);
  model.contacts.node = places(contacts, "node");
  model.contacts.area = numbers(contacts, "area");
  model.contacts.clearance = numbers(contacts, "clearance");
  const list volumes(lattice["volumes"]);
  model.volumes.node = places(volumes, "node");
  model.volumes.buoyancy = numbers(volumes, "buoyancy");
  model.volumes.height = numbers(volumes, "height");
  const list screens(lattice["screens"]);
  model.screens.node = places(screens, "node");
  model.screens.twine_area = numbers(screens, "twine_area");
  model.screens.law = whole_numbers(screens, "law");
  model.wake = numbers(lattice, "wake");
  read_boards(lattice["boards"], model.boards);
  if (!Rf_isNull(lattice["ground"])) {
    model.contacts.ground = model.boards.ground = read_ground(lattice["ground"]);
  }
  return model;
}

doubles as_doubles(const std::vector<double>& values) {
  writable::doubles out(static_cast<R_xlen_t>(values.size()));
  std::copy(values.begin(), values.end(), REAL(out));
  return out;
}

// Columns by board: angles (rad), lift and drag (N), forces (N, 3 each).
list board_table(const std::vector<codend::BoardAttitude>& boards) {
  writable::doubles attack, heel, trim, lift, drag, force, ground_force, lost_buoyancy;
  for (const codend::BoardAttitude& board : boards) {
    attack.push_back(board.attack);
    heel.push_back(board.heel);
    trim.push_back(board.trim);
    lift.push_back(board.lift);
    drag.push_back(board.drag);
    lost_buoyancy.push_back(board.lost_buoyancy);
    for (int k = 0; k < 3; ++k) {
      force.push_back(board.force[k]);
      ground_force.push_back(board.ground_force[k]);
    }
  }
  return writable::list({"attack"_nm = attack, "heel"_nm = heel, "trim"_nm = trim,
                         "lift"_nm = lift, "drag"_nm = drag, "force"_nm = force,
                         "ground_force"_nm = ground_force,
                         "lost_buoyancy"_nm = lost_buoyancy});
}

}  // namespace

[[cpp11::register]]
list engine_settle(list lattice, doubles start, bool near, doubles strain, double tolerance,
                   int iterations, function watch) {
  codend::Model model = read_model(lattice);
  model.connect();
  codend::Assembly assembly(model);
  std::vector<double> x = numbers(start);
  const std::vector<double> v(x.size(), 0.0);

  codend::SettleControl control;
  control.near = near;
  control.strain.assign(strain.begin(), strain.end());
  if (near && !control.strain.empty() &&
      control.strain.size() != static_cast<std::size_t>(model.lines())) {
    stop("one strain per line is needed");
  }
  control.tolerance = tolerance;
  control.iterations = iterations;
  control.watch = [&](const codend::SettleProgress& progress) {
    check_user_interrupt();
    watch(progress.iteration, progress.residual);
    return true;
  };
  const codend::SettleReport report = codend::settle(assembly, control, v.data(), x.data());
  std::vector<double> line_strain;
  assembly.strain(line_strain);
  line_strain.resize(static_cast<std::size_t>(model.lines()));
  return writable::list({
      "position"_nm = as_doubles(x),
      "strain"_nm = as_doubles(line_strain),
      "converged"_nm = report.converged,
      "iterations"_nm = report.iterations,
      "factorisations"_nm = report.factorisations,
      "residual"_nm = report.residual,
      "largest_tension"_nm = report.largest_tension,
      "shadings"_nm = report.shadings,
      "shading_change"_nm = report.shading_change,
      "wake"_nm = as_doubles(assembly.shades() ? assembly.wake() : std::vector<double>()),
      "worst_node"_nm = report.worst_node + 1,
      "worst_force"_nm = report.worst_force,
      "seconds_forces"_nm = report.seconds_forces,
      "seconds_jacobian"_nm = report.seconds_jacobian,
      "seconds_linear"_nm = report.seconds_linear,
      "seconds_analysis"_nm = report.seconds_analysis,
  });
}

[[cpp11::register]]
list engine_evaluate(list lattice, doubles position, doubles velocity) {
  codend::Model model = read_model(lattice);
  model.connect();
  codend::Assembly assembly(model);
  const codend::Evaluation e =
      codend::evaluate(assembly, REAL(position), REAL(velocity));
  return writable::list({
      "force"_nm = as_doubles(e.force),
      "mass"_nm = as_doubles(e.mass),
      "bar_tension"_nm = as_doubles(e.bar_tension),
      "bar_length"_nm = as_doubles(e.bar_length),
      "u_tension"_nm = as_doubles(e.u_tension),
      "v_tension"_nm = as_doubles(e.v_tension),
      "u_length"_nm = as_doubles(e.u_length),
      "v_length"_nm = as_doubles(e.v_length),
      "bar_drag"_nm = as_doubles(e.bar_drag),
      "triangle_drag"_nm = as_doubles(e.triangle_drag),
      "sphere_drag"_nm = as_doubles(e.sphere_drag),
      "lift_force"_nm = as_doubles(e.lift_force),
      "contact_force"_nm = as_doubles(e.contact_force),
      "volume_force"_nm = as_doubles(e.volume_force),
      "boards"_nm = board_table(e.boards),
  });
}

[[cpp11::register]]
list engine_march(list lattice, doubles position, doubles velocity, double step, int steps,
                  double tolerance, int substitutions) {
  codend::Model model = read_model(lattice);
  model.connect();
  codend::Assembly assembly(model);
  std::vector<double> x = numbers(position), v = numbers(velocity);
  const codend::SubstitutionReport report = codend::march_by_substitution(
      assembly, step, steps, tolerance, substitutions, x.data(), v.data());
  return writable::list({
      "position"_nm = as_doubles(x),
      "velocity"_nm = as_doubles(v),
      "converged"_nm = report.converged,
      "steps"_nm = report.steps,
      "substitutions"_nm = static_cast<double>(report.substitutions),
  });
}

[[cpp11::register]]
doubles engine_lay_out(logicals held, doubles position, integers ends, doubles rest,
                       doubles tension, doubles load) {
  codend::StringNet net;
  net.held = marks(held);
  net.ends = places(ends);
  net.rest = numbers(rest);
  net.tension = numbers(tension);
  net.load = numbers(load);
  std::vector<double> x = numbers(position);
  codend::lay_out(net, x.data());
  return as_doubles(x);
}
