// The one file that knows both R and the engine: a lattice (an R list) in, numbers out.
#include <algorithm>
#include <cpp11.hpp>
#include <ctime>
#include <memory>
#include <string>

#include "engine/model/assembly.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/march/explicit_step.hpp"
#include "engine/march/march.hpp"
#include "engine/march/newton_step.hpp"
#include "engine/march/schedule.hpp"
#include "engine/march/substitution.hpp"
#include "engine/solve/layout.hpp"
#include "engine/solve/settle.hpp"
#include "engine/model/wake.hpp"

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

doubles as_doubles(const std::vector<double>& values) {
  writable::doubles out(static_cast<R_xlen_t>(values.size()));
  std::copy(values.begin(), values.end(), REAL(out));
  return out;
}

double number(const list& from, const char* name) { return as_cpp<double>(from[name]); }

std::vector<codend::TwineMaterial> read_materials(const list& materials) {
  const std::vector<double> stiffness = numbers(materials, "axial_stiffness"),
                            diameter = numbers(materials, "diameter"),
                            volume = numbers(materials, "volume_per_length"),
                            added_normal = numbers(materials, "added_mass_normal"),
                            added_tangential = numbers(materials, "added_mass_tangential"),
                            normal = numbers(materials, "normal"),
                            tangential = numbers(materials, "tangential"),
                            skin = numbers(materials, "skin"),
                            tangential_share = numbers(materials, "tangential_share"),
                            damping = numbers(materials, "damping"),
                            solidity = numbers(materials, "solidity");
  const std::vector<int> law = whole_numbers(materials, "law"),
                         strut = whole_numbers(materials, "strut");
  std::vector<codend::TwineMaterial> out;
  for (std::size_t m = 0; m < stiffness.size(); ++m) {
    codend::TwineMaterial material;
    material.axial_stiffness = stiffness[m];
    material.damping = damping[m];
    material.diameter = diameter[m];
    material.volume_per_length = volume[m];
    material.added_mass_normal = added_normal[m];
    material.added_mass_tangential = added_tangential[m];
    material.law = {static_cast<codend::CylinderLawKind>(law[m]), normal[m], tangential[m],
                    skin[m], solidity[m], tangential_share[m]};
    material.strut = strut[m] != 0;
    out.push_back(material);
  }
  return out;
}

// Triangles with straight bars are hexagonal.
void read_triangles(const list& from, codend::Model& model) {
  const std::vector<int> node = places(from, "node"), inner = places(from, "inner"),
                         material = places(from, "material");
  const std::vector<double> twine = numbers(from, "twine"), rest = numbers(from, "rest"),
                            straight = numbers(from, "straight"),
                            multiplicity = numbers(from, "multiplicity"),
                            height = numbers(from, "height");
  auto copy = [](const auto& values, std::size_t width, std::size_t element, auto& to) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(width * element);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
  };
  for (std::size_t e = 0; e < rest.size(); ++e) {
    if (straight[e] > 0.0) {
      codend::HexagonalTriangles& to = model.hexagons;
      copy(node, 3, e, to.node);
      to.node.push_back(inner[e]);
      copy(twine, 6, e, to.twine);
      to.straight.push_back(straight[e]);
      to.oblique.push_back(rest[e]);
      to.multiplicity.push_back(multiplicity[e]);
      to.material.push_back(material[e]);
      to.height.push_back(height[e]);
    } else {
      codend::NettingTriangles& to = model.triangles;
      copy(node, 3, e, to.node);
      copy(twine, 6, e, to.twine);
      to.rest.push_back(rest[e]);
      to.multiplicity.push_back(multiplicity[e]);
      to.material.push_back(material[e]);
      to.height.push_back(height[e]);
    }
  }
}

// Values of plain triangles (`width` each) and those of hexagonal ones, in the order of the
// lattice.
doubles in_order(const doubles& straight, std::size_t width, const double* plain,
                 const double* hexagonal) {
  std::vector<double> out;
  out.reserve(width * static_cast<std::size_t>(straight.size()));
  for (const double bar : straight) {
    const double*& from = bar > 0.0 ? hexagonal : plain;
    out.insert(out.end(), from, from + width);
    from += width;
  }
  return as_doubles(out);
}

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
    board.height = number(one, "height");
    board.level = as_cpp<bool>(one["level"]);
    board.area = number(one, "area");
    board.pressure_centre = number(one, "pressure_centre");
    board.pressure_wanders = as_cpp<bool>(one["pressure_wanders"]);
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

// A list of ropes that slide, each a list of its bars and its stiffness.
void read_sliding(const list& from, std::vector<codend::SlidingRope>& ropes) {
  for (const SEXP item : from) {
    const list one(item);
    codend::SlidingRope rope;
    rope.bar = places(one, "bar");
    rope.axial_stiffness = number(one, "axial_stiffness");
    ropes.push_back(rope);
  }
}

// Of every triangle the length of its straight bars, 0 of a plain one.
doubles straight_bars(const list& lattice) {
  const list triangles(lattice["triangles"]);
  return doubles(triangles["straight"]);
}

// One family of lines: of plain triangles, and the part of all three of hexagonal ones.
doubles family_in_order(const doubles& straight, const std::vector<double>& plain,
                        const std::vector<double>& hexagonal, std::size_t which) {
  return in_order(straight, 1, plain.data(), hexagonal.data() + which * (hexagonal.size() / 3));
}

// Of the straight bars of hexagonal triangles.
doubles straight_tension(const codend::Evaluation& e) {
  const auto first = e.hexagon_tension.begin();
  return as_doubles({first, first + static_cast<std::ptrdiff_t>(e.hexagon_tension.size() / 3)});
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

  model.materials = read_materials(lattice["materials"]);

  const list bars(lattice["bars"]);
  model.bars.node = places(bars, "node");
  model.bars.rest = numbers(bars, "rest");
  model.bars.multiplicity = numbers(bars, "multiplicity");
  model.bars.material = places(bars, "material");
  model.bars.height = numbers(bars, "height");

  read_triangles(lattice["triangles"], model);

  const list spheres(lattice["spheres"]);
  model.spheres.node = places(spheres, "node");
  model.spheres.drag_area = numbers(spheres, "drag_area");
  model.spheres.diameter = numbers(spheres, "diameter");
  for (const int smooth : whole_numbers(spheres, "smooth")) {
    model.spheres.smooth.push_back(smooth ? 1 : 0);
  }
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
  read_sliding(lattice["sliding"], model.sliding);
  if (!Rf_isNull(lattice["ground"])) {
    model.contacts.ground = model.boards.ground = read_ground(lattice["ground"]);
  }

  const list pressure(lattice["pressure"]);
  model.pressure.node = places(pressure, "node");
  model.pressure.weight = numbers(pressure, "weight");
  model.pressure.drag_coefficient = number(pressure, "drag_coefficient");

  const list drag_screens(lattice["drag_screens"]);
  model.drag_screens.node = places(drag_screens, "node");
  model.drag_screens.twine_area = numbers(drag_screens, "twine_area");
  model.drag_screens.diameter = numbers(drag_screens, "diameter");
  model.drag_screens.height = numbers(drag_screens, "height");
  model.drag_screens.multiplicity = numbers(drag_screens, "multiplicity");
  model.drag_screens.law = whole_numbers(drag_screens, "law");

  const list blended(lattice["blended"]);
  model.blended.node = places(blended, "node");
  model.blended.twine = numbers(blended, "twine");
  model.blended.rest = numbers(blended, "rest");
  model.blended.height = numbers(blended, "height");
  model.blended.multiplicity = numbers(blended, "multiplicity");
  model.blended.material = places(blended, "material");
  model.blended.materials = read_materials(blended["materials"]);
  model.blended.slack = model.slack;

  const list openings(lattice["openings"]);
  model.openings.node = places(openings, "node");
  model.openings.twine = numbers(openings, "twine");
  model.openings.couple = numbers(openings, "couple");
  model.openings.angle = numbers(openings, "angle");
  model.openings.multiplicity = numbers(openings, "multiplicity");

  const list bends(lattice["bends"]);
  model.bends.node = places(bends, "node");
  model.bends.couple = numbers(bends, "couple");
  return model;
}

codend::Values values(const list& from, const char* name) {
  const doubles given(from[name]);
  return Eigen::Map<const codend::Values>(REAL(given), given.size());
}

codend::Motion read_motion(const list& from) {
  return {number(from, "time"), values(from, "position"), values(from, "velocity"),
          values(from, "acceleration")};
}

doubles as_doubles(const codend::Values& values) {
  return writable::doubles(values.data(), values.data() + values.size());
}

writable::list as_list(const codend::Motion& motion) {
  return writable::list({"time"_nm = motion.time, "position"_nm = as_doubles(motion.x),
                         "velocity"_nm = as_doubles(motion.v),
                         "acceleration"_nm = as_doubles(motion.a)});
}

codend::Curve read_curve(const list& from) {
  return {numbers(from, "time"), numbers(from, "begin"), numbers(from, "end"),
          numbers(from, "begin_rate"), numbers(from, "end_rate")};
}

codend::Winch read_winch(const list& from) {
  codend::Winch winch;
  winch.wanted = read_curve(list(from["wanted"]));
  winch.steered = as_cpp<bool>(from["steered"]);
  winch.speed_wanted = number(from, "speed_wanted");
  winch.speed_limit = number(from, "speed_limit");
  winch.tension_limit = number(from, "tension_limit");
  winch.near_limit = as_cpp<bool>(from["near_limit"]);
  winch.stiffness = number(from, "stiffness");
  winch.bar = as_cpp<int>(from["bar"]) - 1;
  winch.full_length = number(from, "full_length");
  winch.least_length = number(from, "least_length");
  winch.most_length = number(from, "most_length");
  winch.length = number(from, "length");
  winch.since = number(from, "since");
  winch.speed = number(from, "speed");
  return winch;
}

codend::Plan read_plan(const list& from) {
  codend::Plan plan;
  const list track(from["track"]);
  plan.track.node = places(track, "node");
  const std::vector<double> place = numbers(track, "place");
  for (std::size_t k = 0; k < plan.track.node.size(); ++k) {
    plan.track.place.emplace_back(place[3 * k], place[3 * k + 1], place[3 * k + 2]);
  }
  plan.track.x = read_curve(list(track["x"]));
  plan.track.y = read_curve(list(track["y"]));
  plan.track.heave = read_curve(list(track["heave"]));
  plan.track.course = read_curve(list(track["course"]));
  const list shooting(from["shooting"]);
  plan.shooting.node = places(shooting, "node");
  plan.shooting.time = numbers(shooting, "time");
  for (const list part : list(from["parts"])) {
    codend::GrowingPart p;
    p.has_winch = !Rf_isNull(part["winch"]);
    if (p.has_winch) p.winch = read_winch(list(part["winch"]));
    p.factor = read_curve(list(part["factor"]));
    p.bars = places(part, "bars");
    p.rest = numbers(part, "rest");
    p.points = places(part, "points");
    p.mass = numbers(part, "mass");
    p.load = numbers(part, "load");
    p.spheres = places(part, "spheres");
    p.drag_area = numbers(part, "drag_area");
    p.added_mass = numbers(part, "added_mass");
    p.volumes = places(part, "volumes");
    p.buoyancy = numbers(part, "buoyancy");
    plan.parts.push_back(p);
  }
  for (const list curve : list(from["current_x"])) plan.current_x.push_back(read_curve(curve));
  for (const list curve : list(from["current_y"])) plan.current_y.push_back(read_curve(curve));
  for (const list parting : list(from["partings"])) {
    codend::Parting p;
    p.bars = places(parting, "bars");
    p.at = as_cpp<int>(parting["at"]) - 1;
    p.time = number(parting, "time");
    p.strength = number(parting, "strength");
    p.parted = as_cpp<int>(parting["parted"]) - 1;
    p.parted_at = number(parting, "parted_at");
    plan.partings.push_back(p);
  }
  return plan;
}

// What winches and ropes have done so far.
writable::list plan_state(const codend::Plan& plan) {
  writable::doubles length, since, speed, wanted, parted_at;
  writable::integers parted;
  writable::logicals near_limit;
  for (const codend::GrowingPart& part : plan.parts) {
    length.push_back(part.winch.length);
    since.push_back(part.winch.since);
    speed.push_back(part.winch.speed);
    wanted.push_back(part.winch.speed_wanted);
    near_limit.push_back(part.winch.near_limit ? TRUE : FALSE);
  }
  for (const codend::Parting& parting : plan.partings) {
    parted.push_back(parting.parted + 1);
    parted_at.push_back(parting.parted_at);
  }
  return writable::list({"length"_nm = length, "since"_nm = since, "speed"_nm = speed,
                         "speed_wanted"_nm = wanted, "near_limit"_nm = near_limit,
                         "parted"_nm = parted, "parted_at"_nm = parted_at});
}

std::unique_ptr<codend::Stepper> read_scheme(const list& control, codend::Assembly& assembly,
                                             const codend::Motion& start) {
  using codend::NewtonScheme;
  const std::string name = as_cpp<std::string>(control["scheme"]);
  const double tolerance = number(control, "tolerance");
  auto newton = [&](NewtonScheme scheme) {
    return std::make_unique<codend::NewtonStep>(assembly, scheme, tolerance);
  };
  if (name == "bdf2") return newton(NewtonScheme::bdf2);
  if (name == "trapezoid") return newton(NewtonScheme::trapezoid);
  if (name == "backward_euler") return newton(NewtonScheme::backward_euler);
  if (name == "substitution") {
    constexpr int most_substitutions = 200;
    return std::make_unique<codend::SubstitutionStep>(assembly, tolerance, most_substitutions,
                                                      start);
  }
  if (name == "symplectic_euler") {
    return std::make_unique<codend::SymplecticEulerStep>(assembly, start);
  }
  return std::make_unique<codend::RungeKuttaStep>(assembly, start);
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
      "upsets"_nm = report.upsets,
      "upset_at_last"_nm = report.upset_at_last,
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
  const doubles straight = straight_bars(lattice);
  const std::vector<double> none(straight.size(), 0.0);
  auto family = [&](const std::vector<double>& plain, const std::vector<double>& hexagonal,
                    std::size_t which) {
    return family_in_order(straight, plain, hexagonal, which);
  };
  return writable::list({
      "force"_nm = as_doubles(e.force),
      "mass"_nm = as_doubles(e.mass),
      "bar_tension"_nm = as_doubles(e.bar_tension),
      "bar_length"_nm = as_doubles(e.bar_length),
      "u_tension"_nm = family(e.u_tension, e.hexagon_tension, 1),
      "v_tension"_nm = family(e.v_tension, e.hexagon_tension, 2),
      "straight_tension"_nm = family(none, e.hexagon_tension, 0),
      "u_length"_nm = family(e.u_length, e.hexagon_length, 1),
      "v_length"_nm = family(e.v_length, e.hexagon_length, 2),
      "straight_length"_nm = family(none, e.hexagon_length, 0),
      "bar_drag"_nm = as_doubles(e.bar_drag),
      "triangle_drag"_nm =
          in_order(straight, 3, e.triangle_drag.data(), e.hexagon_drag.data()),
      "sphere_drag"_nm = as_doubles(e.sphere_drag),
      "lift_force"_nm = as_doubles(e.lift_force),
      "catch_force"_nm = as_doubles(e.catch_force),
      "screen_force"_nm = as_doubles(e.screen_force),
      "blended_force"_nm = as_doubles(e.blended_force),
      "contact_force"_nm = as_doubles(e.contact_force),
      "volume_force"_nm = as_doubles(e.volume_force),
      "boards"_nm = board_table(e.boards),
  });
}

// Speed behind a sheet of netting as a share of that before it, by a wake law.
[[cpp11::register]]
doubles engine_speed_reduction(int law, doubles solidity, doubles cosine) {
  writable::doubles out;
  for (R_xlen_t k = 0; k < solidity.size(); ++k) {
    out.push_back(codend::speed_reduction(static_cast<codend::WakeLaw>(law), solidity[k],
                                          cosine[k]));
  }
  return out;
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

// Marches from `past` through the stops of list(time, kept, broken, steered, filled): times (s,
// growing) and at which of them a frame is kept, the motion breaks, winches are steered or the catch's
// front is moved. keep(frame) gets the motion and tensions, and all that is needed to go on from
// there; steer(frame) answers with the speed wanted of every growing part; refill(frame) with weight,
// node and mass of the catch; watch(time, steps) is called after steps, at most some ten
// times a second.
[[cpp11::register]]
list engine_tow(list lattice, list plan, list past, list control, list stops, function keep,
                function steer, function refill, function watch) {
  codend::Model model = read_model(lattice);
  model.connect();
  codend::Assembly assembly(model);
  codend::Past from;
  from.now = read_motion(list(past["now"]));
  from.before = read_motion(list(past["before"]));
  from.steps = as_cpp<int>(past["steps"]);
  from.caution = as_cpp<int>(past["caution"]);
  codend::Schedule schedule(model, assembly, read_plan(plan), from.now);
  schedule.to_time(from.now.time, codend::Side::after, from.now);
  const std::unique_ptr<codend::Stepper> scheme = read_scheme(control, assembly, from.now);

  codend::MarchControl how;
  how.accuracy = number(control, "accuracy");
  how.step = number(past, "step");
  how.least_step = number(control, "least_step");
  how.most_step = number(control, "most_step");
  std::clock_t shown = std::clock();
  long long steps = 0;
  how.watch = [&](const codend::Motion& now) {
    check_user_interrupt();
    ++steps;
    if (std::clock() - shown > CLOCKS_PER_SEC / 10) {
      shown = std::clock();
      watch(now.time, static_cast<double>(steps));
    }
    return true;
  };
  codend::March march(assembly, *scheme, schedule, how, from);
  auto report = [&] {
    const codend::MarchReport& r = march.report();
    const char* const ends[] = {"reached", "stopped", "stuck"};
    return writable::list({
        "end"_nm = ends[static_cast<int>(r.end)], "steps"_nm = static_cast<double>(r.steps),
        "repeated"_nm = static_cast<double>(r.repeated),
        "not_found"_nm = static_cast<double>(r.not_found),
        "iterations"_nm = static_cast<double>(r.iterations),
        "shortest_step"_nm = r.shortest_step, "longest_step"_nm = r.longest_step,
        "worst_node"_nm = r.worst_node + 1, "time"_nm = march.now().time});
  };
  const doubles straight = straight_bars(lattice);
  auto frame = [&] {
    const codend::Motion& now = march.now();
    const codend::Evaluation e = codend::evaluate(assembly, now.x.data(), now.v.data());
    return writable::list({
        "now"_nm = as_list(now), "before"_nm = as_list(march.past().before),
        "steps"_nm = march.past().steps, "caution"_nm = march.past().caution,
        "step"_nm = march.step(), "done"_nm = plan_state(schedule.plan()),
        "bar_tension"_nm = as_doubles(e.bar_tension),
        "u_tension"_nm = family_in_order(straight, e.u_tension, e.hexagon_tension, 1),
        "v_tension"_nm = family_in_order(straight, e.v_tension, e.hexagon_tension, 2),
        "straight_tension"_nm = straight_tension(e),
        "wake"_nm = as_doubles(assembly.shades() ? assembly.wake() : std::vector<double>()),
        "report"_nm = report()});
  };
  const doubles times(stops["time"]);
  const logicals kept(stops["kept"]), broken(stops["broken"]), steered(stops["steered"]),
      filled(stops["filled"]);
  for (R_xlen_t k = 0; k < times.size(); ++k) {
    if (march.to(times[k]) != codend::MarchReport::End::reached) break;
    if (steered[k] == TRUE) {
      const doubles speed(steer(frame()));
      std::vector<codend::GrowingPart>& parts = schedule.plan().parts;
      for (std::size_t p = 0; p < parts.size(); ++p) {
        parts[p].winch.speed_wanted = speed[static_cast<R_xlen_t>(p)];
      }
    }
    if (filled[k] == TRUE) {
      const list moved(refill(frame()));
      model.pressure.weight = numbers(moved, "weight");
      const std::vector<int> node = places(moved, "node");
      const std::vector<double> mass = numbers(moved, "mass");
      for (std::size_t p = 0; p < node.size(); ++p) model.mass[node[p]] = mass[p];
    }
    if (broken[k] == TRUE) march.begin_anew();
    if (kept[k] == TRUE) keep(frame());
  }
  return report();
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
