// The engine's model from a lattice, its forces at a place, and its laws, for R.
#include "binding_model.hpp"

using namespace binding;

namespace {

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

}  // namespace

codend::Model binding::read_model(const list& lattice) {
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

namespace {

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

