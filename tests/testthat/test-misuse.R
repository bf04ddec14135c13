# Common wrong calls. Each call throws an error of codend at once, with the message stored in
# _snaps, before any shape is computed.

wrong_calls <- expression(
  # reading and changing plans
  read_gear(), read_gear(1), read_gear(NULL), read_gear(c("cage", "gillnet")), read_gear(NA),
  read_gear("midwater_trwl"), read_gear(midwater_trawl), read_gear(g), read_gear(""),
  update(g, towing.sped = "3 knot"), update(g, towing.speed = "3 knots/h"),
  update(g, towing.speed = "fast"), update(g, towing.speed = -1), update(g, towing.speed = NA),
  update(g, towing.speed = Inf), update(g, towing.speed = c(1, 2)), update(g, towing = 3),
  update(g, ropes.cable.length = "0 m"), update(g, ropes.cable.length = "300 kg"),
  update(g, ropes.cable.length = "-5 fathom"), update(g, ropes.warp.length = "300 m"),
  update(g, ropes.cable.breaking_load = "-2 kgf"), update(g, ropes.cable.material = "stel"),
  update(g, ropes.cable.length = TRUE), update(g, ropes.cable.length = list(1)),
  update(g, "3 knot"), update(g, 3), update(g, kind = "trawl"),
  update(g, pieces.sphere.mass = "1e400 kg"),
  update(g, pieces.sphere.at = "nowhere"), update(g, water.density = "1025 g"),
  update(g, ropes.cable.segments = 2.5), update(g, towing.speed. = 1),
  update(g, towing.speed = 1, towing.speed = 2), update(g, towing.speed = as.Date("2020-01-01")),
  write_gear(g), write_gear(1, "a.yaml"),
  write_gear(g, "no/such/folder/a.yaml"), write_gear(g, 1),
  new_plan(), new_plan("no_such_gear"), new_plan(3), new_plan("botom_trawl"),
  new_plan("bottom_trawl", hedline = "3 m"), new_plan("bottom_trawl", depth = "3 kg"),
  new_plan("bottom_trawl", mesh_size = "20 m"), new_plan("gillnet", wall.mesh_sise = "1 m"),
  new_plan("longline", baskets = "2.5"), new_plan("longline", branch_lines = 0),
  gear(), gear(1), gear("a", b = 3), gear("a", top = rope(length = 3)),
  gear("a", top = gear_point(position = c(0, 0))),
  gear("a", b = gear_point(position = c(0, 0, 0), held = "fixed"), b = gear_point()),
  gear("a", b = gear_point(position = c(0, 0, 0), held = "fixed", near = c(0, 0, 1))),
  gear("a", w = rope(through = list("a"), length = 1, diameter = 0.01, material = "PE")),
  gear("a", 5), gear("a", points = list(a = mean)), gear("a", towing = list(1)),
  gear("a", points = list(a = list(load = as.Date("2020-01-01") + 0:2, load = 1))),
  gear("a", towing = list(speed = NA)), gear("a", towing = list(speed = NA_character_)),
  gear("a", towing = list(speed = c(1, 2))), gear("a", towing = list(speed = 1i)),
  # fields of short forms
  change("beam_trawl", warp.length = "25 m"), change("beam_trawl", bridles.outer.length = "1.5 m"),
  change("beam_trawl", bridles.upper = "3 m"), change("beam_trawl", shoes.height = "0.1 m"),
  change("beam_trawl", shoes.mass = NULL), change("beam_trawl", ticklers.tickler_1.length = "3 m"),
  change("beam_trawl", beam.segments = 5), change("beam_trawl", beam.bending_stiffness = 0),
  change("beam_trawl", wings.upper = list(mesh_size = "100 mm")),
  change("beam_trawl", wings.lower.meshes.deep = 30), change("beam_trawl", seabed = NULL),
  change("cage", panels = 3), change("cage", shape = "square", panels = 18),
  change("cage", collar = list(held = TRUE, diameter = "1 m")),
  change("cage", collar = list(held = TRUE)), change("cage", moorings = NULL),
  change("cage",
    collar = list(diameter = "300 mm", mass_per_length = 50, axial_stiffness = "50 MN")),
  change("cage", moorings.length = "60 m"), change("cage", moorings.number = 20),
  change("cage", bottom = NULL), change("cage", wall.orientation = "hexagonal"),
  change("demersal_seine", laying = NULL), change("demersal_seine", laying.net = list("100 m")),
  change("demersal_seine", hauling = list()),
  change("demersal_seine", hauling = list(list(winch = "1 m/s"))),
  change("demersal_seine", hauling = list(list(rope_out = "2000 m", winch = "1 m/s"))),
  change("demersal_seine", hauling = list(list(rope_out = "300 m", winch = 0))),
  change("demersal_seine", hauling = list(list(time = "1 h", winch = "2 m/s"))),
  change("demersal_seine", warps.length = NULL),
  change("purse_seine", rings = NULL), change("purse_seine", rings.number = 0),
  change("purse_seine", rings.bridles = NULL), change("purse_seine", purse_wire.length = "0 m"),
  change("purse_seine", purse_wire = NULL), change("purse_seine", pursing.until = "500 m"),
  change("purse_seine", pursing.speed = "-1 m/s"), change("purse_seine", pursing.wait = "a while"),
  change("purse_seine", shooting.speed = NULL), change("purse_seine", shooting.arc = "400 deg"),
  change("purse_seine", panels = list()), change("purse_seine", panels.bunt.mesh_size = "-3 mm"),
  change("purse_seine", selvedges.upper.deep = 0),
  change("purse_seine", float_line.material = "silk"),
  change("purse_seine", floats.buoyancy = "50 N"),
  change("gillnet", length = "200 m"), change("gillnet", anchors.apart = "80 m"),
  change("gillnet", seabed = NULL), change("gillnet", wall.meshes.across = 0),
  change("stow_net", bridles.length = "3 m"),
  change("stow_net", upper_beam.bending_stiffness = 0),
  change("stow_net", mouth = list(width = 8)), change("dip_net", bridles.number = 3),
  change("dip_net", bridles.length = "1 m"), change("dip_net", shape = "square", panels = 10),
  change("dip_net", frame.bending_stiffness = 0), change("longline", floats.held = "all"),
  change("longline", floats = list(held = "ends")), change("longline", shortening_ratio = 1.1),
  change("longline", branch_lines.number = 2.5),
  change("longline", hooks = list(mass = "70 g", volume = "0.1 litre", depth = 3)),
  change("longline", baskets = 1e12), change("cage", panels = 1e9),
  # trawls
  change("poly_noreastern_trawl", warps = NULL), change("poly_noreastern_trawl", seabed = NULL),
  change("poly_noreastern_trawl", towing_points = list(spread = "20 m")),
  change("poly_noreastern_trawl", wings.side = NULL), change("poly_noreastern_trawl", panels = 2),
  change("poly_noreastern_trawl", wings.jib.deep = 20),
  change("poly_noreastern_trawl", wings.jib = NULL, bridles.middle = NULL),
  change("poly_noreastern_trawl", wings.lower.meshes.deep = 100),
  change("poly_noreastern_trawl", wings.upper.meshes.base = 300),
  change("poly_noreastern_trawl", wings.upper.flying = 160),
  change("poly_noreastern_trawl", headline.bosom = "50 m"),
  change("poly_noreastern_trawl", floats = list(number = 40, buoyancy = "3 kgf", spacing = "1 m")),
  change("small_midwater_trawl", side_lines = NULL), change("small_midwater_trawl", panels = 2),
  change("midwater_trawl", wings.meshes.base = 60), change("midwater_trawl", towing = NULL),
  change("midwater_trawl", cross_ropes = list(a = wire(length = "8 m", behind = "fronts"))),
  example_gear("midwater_pair_trawl") |> update(sweeps = wire(length = "20 m")),
  two_seam(net.upper.body_2.meshes.front = 85), two_seam(net.upper.square.meshes.front = 140),
  two_seam(net.upper.square.meshes.deep = 60), two_seam(net.upper.body_2.pair = TRUE),
  two_seam(net.lower.cover = two_seam()$plan$net$upper$codend),
  two_seam(net.side = list(a = two_seam()$plan$net$upper$body_1), panels = 2),
  two_seam(net.upper.wing_2.meshes = list(front = 36, rear = 84, deep = 60)),
  two_seam(net.upper.wing_2.meshes.rear = 79),
  two_seam(net.upper.wing_2.meshes = list(front = 51)),
  two_seam(net.upper.wing_2.cutting = list(left = "AB")),
  two_seam(headline = wire(
    sections = list(list(length = "12 m", hanging_ratio = 0.1), list(hanging_ratio = 0.5)))),
  two_seam(headline = wire(sections = list(list(length = "6 m", hanging_ratio = 0.5),
    list(hanging_ratio = 0.6), list(length = "6 m")))),
  two_seam(headline = wire(bosom = "5 m",
    sections = list(list(length = "6 m", hanging_ratio = 0.5), list(length = "12 m")))),
  two_seam(bridles.middle = list(wire(length = "25 m"), wire(length = "25.1 m")),
    side_lines = wire(sections = list(list(length = "2 m"), list(length = "2 m")))),
  two_seam(lifting_bag = list(mesh_size = "200 mm")), two_seam(bobbins = list(number = 10)),
  two_seam(round_straps = list(number = 3)), two_seam(gussets = list(meshes = 10)),
  two_seam(dropper_chains = "0.4 m"),
  grid(sections.ahead_of_grid.meshes.deep = 5, separators = NULL),
  grid(grids.nordmore.behind = "codend"), grid(grids.nordmore.behind = "body"),
  grid(grids.nordmore.height = "4 m"),
  # ropes, tows and vessels
  update(assembly(change("purse_seine")), ropes.purse_wire.through = list("rin")),
  update(assembly(change("purse_seine")), ropes.purse_wire.through = list("ring_1", "ring_1")),
  update(assembly(change("purse_seine")), shooting.rope = "chin"),
  change("purse_seine", shooting.speed = 0), update(g, measures.d = list(depth = "cable[1.5]")),
  update(g, ropes.cable.segments = 1e9), update(g, towing.speed = "1e3 knot"),
  update(g, netting = "triangles"), update(s, towing.speed = 2),
  update(g, water.waves = list(height = "5 m", period = "4 s")),
  update(g, tow = tow_schedule(heave = sin)),
  update(update(g, towing.speed = 2), ropes.cable.to = "nowhere"),
  update(g, ropes.cable.load_by_elongation = list(list(elongation = 0.1, load = 5))),
  update(g, ropes.cable = wire(from = "ship", to = "body", length = "9 m",
    load_by_elongation = list(list(elongation = 0.1, load = 5), list(elongation = 0.2, load = 3)))),
  update(g, vessel = list(power = "1 MW", pull = pull(speed = c(3, 1), pull = c(10, 5)))),
  update(g, vessel = list(power = "1 MW", pull = pull(speed = c(0, 1), pull = c(10, 15)))),
  update(g, tow = list(until = "10 kg")), update(g, tow = list(speed = list(list(time = 0)))),
  tow(two_seam(), tow_schedule(warp_out = 0.5), 1, nodes = 50),
  tow(two_seam(), tow_schedule(warp_out = list(middle = 60)), 1, nodes = 50),
  tow(settle(two_seam(), nodes = 50), tow_schedule(warp_out = 50), 1),
  tow(g, tow_schedule(speed = 1e3), 2), tow(g, list(speed = 2), 2),
  tow(g, tow_schedule(vessel_motion = list(response = data.frame(period = 6))), 2),
  tow(g, tow_schedule(vessel_motion = list(record = data.frame(time = 1:3))), 2),
  tow_schedule(control = 3), tow_schedule(winch = list(force = 1)),
  tow_schedule(control_every = "-2 s"), update(tow_schedule(speed = 1), sped = 1),
  c(tow_schedule(speed = 1), tow_schedule(speed = 2)), c(tow_schedule(speed = 1), 3),
  tow(change("demersal_seine", laying.net = list("1500 m", "0 m")), nodes = 150),
  # classes of values, and angles beyond a turn without a unit
  update(g, ropes.cable = list(length = span)), vary(g, towing.speed = day + 0:1),
  designs(data.frame(towing.speed = day + 0:1)), value_range(day, day + 1), normal_value(1, span),
  calibrate(g, data.frame(towing.speed = day + 0:3, Drag = 1:4), cd, Drag ~ total_drag),
  calibrate(g, data.frame(Drag = 1:3), list(ropes.cable.length = day + 0:1), Drag ~ total_drag),
  tow(g, until = span), tow(g, until = TRUE),
  tow(g, until = 2, schedule = tow_schedule(speed = data.frame(time = span, value = 1))),
  tow(g, until = 2, schedule = tow_schedule(speed = function(time) day)),
  update(g, towing.speed = factor("4 knot")), update(g, towing.speed = 4i),
  update(g, towing.speed = list(4)), update(g, towing.speed = TRUE),
  vary(g, towing.speed = factor("4 knot")), vary(g, towing.speed = 4i),
  vary(g, towing.speed = list(4)), tow_schedule(speed = factor("4 knot")), tow_schedule(speed = 4i),
  value_range(factor("4 knot"), 5), value_range(4i, 5), profile(speed = factor("4 knot")),
  profile(speed = 4i), profile(speed = TRUE), profile(speed = 1, toward = 270),
  current_profile(data.frame(depth = 0, speed = 1, toward = 0), course = 270),
  update(g, water.current = list(speed = 1, toward = 270)), turn(c(0, 90)), turn(c("0", "-6.3")),
  # settling
  settle(), settle(NULL), settle(1), settle("no_such_gear"), settle(towed_cable),
  settle(list(a = 1)),
  settle(s), settle(g, nodes = "many"), settle(g, nodes = 0), settle(g, nodes = -5),
  settle(g, nodes = NA), settle(g, nodes = c(1, 2)), settle(g, nodes = Inf), settle(g, from = g),
  settle(g, from = 3), settle(g, accuracy = "1 m"), settle(g, accuracy = 0),
  settle(g, accuracy = "high"), settle(g, netting = "fine"), settle(g, netting = -1),
  settle(g, from = other), settle(g, accuracy = -1),
  # contents of a state
  measures(), measures(g), measures("towed_cable"), measures(NULL), measures(s)["door_spread"],
  measures(s)["total_drag"], measures(s)[["total_drag"]], measures(s)$total_drag,
  measures(s)[c("total_drag_kN", "x")], s$total_drag, s$total_drag_kN,
  as.data.frame(s, what = "rope_tensions", parts = "warp"),
  as.data.frame(s, what = "rope_tensions", parts = 1), as.data.frame(s, what = "mesh_openings"),
  as.data.frame(s, what = "nodes", parts = "warp"),
  as.data.frame(s, "nodes"), in_units(measures(s), speed = "kN"),
  in_units(measures(s), weight = "kg"), in_units(measures(s), "knot"), in_units(1, force = "kN"),
  withr::with_options(list(codend.units = c(force = "kilo")), print(measures(s))),
  catalogue("hook"), catalogue(NA_character_), catalogue(3), catalogue(c("wire", "hook")),
  findings(), findings(1), findings("a"), tr$total_drag, as.data.frame(s, what = 1),
  # pictures and files
  view_3d(), view_3d(g), view_3d(s, file = "a.png"), view_3d(s, file = 1),
  view_3d(s, file = "a.htm"),
  view_3d(s, file = "no/a.html"),
  view_3d(s, colour = "red"), view_3d(s, colour = 1), plot(s, planes = "ab"),
  plot(s, planes = character()), plot(s, file = "a.doc"), plot(s, file = "png"),
  plot(s, file = "none/a.png"), plot(s, file = c("a.png", "b.png")), plot(s, width = 0),
  plot(s, height = NA_real_, file = "a.png"), plot(s, width = 10, height = 3, file = "a.png"),
  plot(tr, measures = "drag"), plot(tr, file = "c.txt"),
  plot(tr, width = 1, file = "c.png"), plot(g, file = "a.jpg"),
  plot(g, file = "none/a.png"), plot(g, page = "A9"), plot(g, file = "a.png", page = NA),
  report(), report(s), report(g, "a.html"),
  report(s, "a.pdf"),
  report(s, "no/such/a.html"), write_result(), write_result(s), write_result(g, "a.glb"),
  write_result(s, "a.obj"), write_result(s, "no/a.vtu"), write_result(s, "a.pvd"),
  write_result(s, "a.glb", colours = "rainbow"), write_result(tr, "a.json"),
  read_result(), read_result("none.nc"), read_result(1),
  # towing
  tow(), tow(g), tow(s), tow(g, until = -1), tow(g, until = "10 m"), tow(g, until = "soon"),
  tow(g, until = 10,
    schedule = tow_schedule(speed = "fast")), tow(g, until = 10, every = -1), tow(1, until = 10),
  tow(g, until = 2,
    schedule = tow_schedule(speed = function() 3)), tow(g, until = 1, scheme = "rk5"),
  tow(g, until = 1, schedule = tow_schedule(course = 1)),
  tow(g, until = 1, schedule = tow_schedule(speed = data.frame(time = c(1, 0), value = 1:2))),
  tow(g, until = 1,
    schedule = tow_schedule(breaking = list(list(rope = "warp", time = 1)))), tow(tr, until = 1),
  tow(g, until = "3000 h"), tow(g, until = 1e5, every = 1e-3),
  state_at(), state_at(tr), state_at(s, 1),
  state_at(tr, 1e6), state_at(tr, -1),
  state_at(tr, "a week"), state_at(tr, c(1, 2)),
  # studies
  sensitivities(), sensitivities(g), sensitivities(s, of = "drag"),
  sensitivities(s, of = "total"),
  sensitivities(s, fields = "speed"), sensitivities(s, fields = 3), sensitivities(s, secants = 1),
  sensitivities(s, fields = "none.at.all"),
  sensitivities(s, fields = "points.ship.held"), sensitivities(s, fields = "ropes.cable.segments"),
  sensitivities(s, fields = list(c("towing.speed", "ropes.cable.length"))),
  sensitivities(settle(update(g, pieces.sphere.drag_coefficient = 0), nodes = 50),
    fields = "pieces.sphere.drag_coefficient"),
  vary(), vary(1), vary(g, 3),
  vary(g, towing.sped = 1:2), vary(g, towing.speed = NULL),
  vary(g, towing.speed = list(1, 2)), vary(g, towing.speed = c(1, NA)), vary(g, 1:3),
  vary(g, towing.speed = 1, towing.speed = 2), vary(g, towing.speed = c("2 knot", "3 kg")),
  vary(g, towing.speed = 2, nodes = 0), uncertainty(s, "drag"), uncertainty(s, level = 2),
  uncertainty(s, method = "guess"), uncertainty(), uncertainty(g),
  plot(uncertainty(s), sources = "nothing"), share(), share(s), share(1, "a.html"),
  share(s, "a.txt"), share(s, "a.html", tow = 1), vary(g, a = data.frame(towing.speed = 1)),
  vary(g, designs(ropes.cable.length = c("300 m", "-2 m"))),
  vary(g, designs(ropes.cable.length = c(seq(300, 500, length.out = 500), -1))),
  vary(g, towing.speed = c("3 knot", "x")),
  vary(g, towing.speed = 2, nodes = "a"), vary(g, towing.speed = 2, tasks = 0),
  vary(g, towing.speed = value_range(1, 2)), designs(), designs(3), designs(a = value_range(2, 1)),
  designs(towing.speed = value_range(1, 2), how = "best"),
  designs(towing.speed = value_range(1, 2), number = -1), value_range(), value_range(1),
  designs(1:3), designs(a.b = value_range(1, 2)), designs(a.b = value_range(1, 2), number = 0),
  designs(a.b = value_range(1, 2), number = 8, seed = 1.5), designs(a.b = 1:2, how = "table"),
  designs(a.b = 1, "c.d + a.b" = 2), designs(a = data.frame(b = 1)), designs(a.b = list(1, 2)),
  designs(a.b = 1:2000, c.d = 1:2000), value_range("3 knot", 5), value_range("3 furlong", 5),
  value_range("fast", "5 knot"), value_range(0, 5, log = TRUE), value_range(0, 5, whole = 1),
  normal_value(1, 0), normal_value(1, 0.1, low = 9),
  value_range("3 knot", "5 m"), value_range(5, 3), normal_value(1), normal_value(1, -1),
  normal_value("a", "b"), run_study(), run_study("none"), read_result("none"),
  vary(g, tasks = 0), vary(g, 1, store = "a", tasks = 0),
  vary(g, data.frame(), store = "a", tasks = 0), vary(g, towing.speed = 1, store = 7),
  vary(g, towing.speed = 1, store = ""), vary(g, towing.speed = 1, store = "nowhere/a.study"),
  optimise_gear(), optimise_gear(g), optimise_gear(g, minimise = total_drag),
  optimise_gear(g, minimise = ~ total_drag), optimise_gear(g, minimise = "drag", change = ch),
  optimise_gear(g, minimise = 3, change = ch), optimise_gear(g, ~ total_drag, change = 3),
  optimise_gear(g, ~ total_drag, change = list(towing.sped = c(1, 2))),
  optimise_gear(g, ~ total_drag, change = list(towing.speed = 3)),
  optimise_gear(g, ~ total_drag, keep = "deep", change = ch),
  optimise_gear(g, ~ total_drag, keep = ~ total_drag, change = ch),
  optimise_gear(g, ~ total_drag, change = ch, starts = 0),
  optimise_gear(g, ~1, change = ch), optimise_gear(g, ~ log(-total_drag_kN), change = ch),
  optimise_gear(g, ~ total_drag, change = list(ropes.cable.length = c("800 kg", "1500 kg"))),
  optimise_gear(g, ~ total_drag, change = list(ropes.cable.length = c(TRUE, FALSE))),
  optimise_gear(g, ~ dept, change = ch), optimise_gear(g, ~ abs(total_drag), change = ch),
  optimise_gear(g, ~ total_drag, ~ body_depth >= "3 parsec", ch),
  optimise_gear(g, ~ total_drag, ~ body_depth >= "9 kg", ch),
  optimise_gear(g, ~ total_drag, ~ body_depth_m >= "9 m", ch),
  optimise_gear(g, ~ total_drag, ~ 3 >= 2, ch),
  optimise_gear(g, ~ total_drag, change = list(towing.speed = c("3 m/s", "1 m/s"))),
  optimise_gear(g, ~ total_drag, change = list(towing.speed = c(1, 1.5))),
  optimise_gear(g, ~ total_drag, change = list(towing.speed = c("fast", "3 m/s"))),
  optimise_gear(g, ~ total_drag, change = list(pieces.sphere.mass = c(-1, 3000))),
  optimise_gear(g, ~ total_drag, change = c(ch, ch)),
  optimise_gear(g, ~ total_drag, change = ch, max_solves = "many"),
  find_value(), find_value(g), find_value(g, towing.speed = c(1, 3)),
  find_value(g, target = list(body_depth = "300 m")),
  find_value(g, towing.sped = c(1, 3), target = list(body_depth = "300 m")),
  find_value(g, towing.speed = c(1, 3), target = "300 m"),
  find_value(g, towing.speed = c(1, 3), target = list("300 m")),
  find_value(g, towing.speed = c(1, 3), target = list(body_dept = "300 m")),
  find_value(g, towing.speed = c(1, 3), target = list(body_depth = "300 kN")),
  find_value(g, towing.speed = c(1, 3), target = list(body_depth = c(1, 2))),
  find_value(g, towing.speed = c(1, 3), target = list(body_depth = NA)),
  find_value(g, towing.speed = c(1, 3), target = list("body_depth +" = 3)),
  find_value(g, towing.speed = c(1, 3), target = list(body_depth = "300 m"), nodes = -1),
  find_value(g, towing.speed = c(1, 3), target = list(body_depth = "300 m"), accuracy = 3),
  trade_off(g, ~ total_drag, change = ch), trade_off(g), calibrate(), calibrate(g),
  calibrate(g, data = 1, change = ch, match = Drag ~ total_drag),
  calibrate(g, data = hauls, change = cd), calibrate(g, data = hauls, change = cd, match = "x"),
  calibrate(g, data = hauls, change = cd, match = Nothing ~ total_drag),
  calibrate(g, data = hauls[0, ], change = ch, match = Drag ~ total_drag),
  calibrate(g, data.frame(towing.sped = 1, Drag = 1), cd, Drag ~ total_drag),
  calibrate(g, data.frame(towing.speed = c(1, NA), Drag = 1), cd, Drag ~ total_drag),
  calibrate(g, data.frame(towing.speed = -3, Drag = 1:3), cd, Drag ~ total_drag),
  calibrate(g, hauls, ch, Drag ~ total_drag), calibrate(g, hauls, cd, Drag ~ total_dragg),
  calibrate(g, hauls[1, ], cd, Drag ~ total_drag),
  calibrate(g, hauls, cd, Drag ~ total_drag, error = c(1, 2)),
  calibrate(g, hauls, cd, Drag ~ total_drag, error = -1), confint(fit, level = 90),
  confint(fit, "mass"), predict(fit, data.frame(a = 1)), residuals(fit, "raw"),
  explain_misfit(fit, fields = "towing.speed"), plot(fit, by = "depth"),
  sample_posterior(), sample_posterior(1), sample_posterior(fit, draws = 0), explain_misfit(),
  explain_misfit(1), tow_speed(), tow_speed(1), read_sensor_log(), read_sensor_log("none.csv"),
  haul_means(1), haul_means(data.frame(time = 0:10, door = 1), 5, 1),
  read_currents("none.nc"), current_profile(), current_profile(1), flume(1), flume(fields = "a"),
  force_coefficients(reynolds = -1), force_coefficients(reynolds = NA),
  force_coefficients(reynolds = c(1, 2)), force_coefficients(solidity = 2),
  plot(force_coefficients(), force = "boards"), force_coefficients(solidity = 0),
  force_coefficients(solidity = numeric()), haul_means(1, 5, 6)
)

# Returns the variables of the calls; their parent has codend's exports, as a script sees them.
misuse_variables <- function() {
  exported <- list2env(
    mget(getNamespaceExports("codend"), envir = asNamespace("codend"), inherits = TRUE),
    parent = globalenv())
  there <- list2env(list(
    g = read_gear("towed_cable"), s = settle("towed_cable", nodes = 50),
    other = settle("crossing_cables", nodes = 50), tr = tow("towed_cable", until = 2, every = 1),
    ch = list(towing.speed = c("2 knot", "4 knot")),
    cd = list(pieces.sphere.drag_coefficient = c(0.2, 1.5)),
    hauls = data.frame(towing.speed = 1:4, Drag = c(2, 3, 6, 9)),
    day = as.Date("2020-01-01"), span = as.difftime(10, units = "mins"),
    change = function(plan, ...) update(read_gear(plan), ...), two_seam = two_seam,
    example_gear = example_gear, grid = function(...) update(example_gear("sorting_grid"), ...),
    wire = function(...) list(diameter = "12 mm", material = "steel_wire", ...),
    pull = function(...) asplit(data.frame(...), 1L) |> unname() |> lapply(as.list),
    profile = function(speed, toward = 0) {
      current_profile(data.frame(depth = 0, speed = speed, toward = toward))
    },
    turn = function(value) {
      tow("towed_cable", until = 2, nodes = 20,
        schedule = tow_schedule(course = data.frame(time = c(0, 1), value = value)))
    }
  ), parent = exported)
  there$fit <- calibrate(there$g, there$hauls, there$cd, Drag ~ total_drag_kN, nodes = 20)
  there
}

test_that("wrong calls throw a codend error that explains the mistake", {
  local_reproducible_output(width = 80)
  kept <- setwd(test_folder())
  on.exit(setwd(kept))
  there <- misuse_variables()
  texts <- vapply(as.list(wrong_calls), function(call) {
    said <- tryCatch({
      eval(call, there)
      "nothing is wrong"
    }, codend_error = function(e) {
      paste0("[", class(e)[1L], "] ", plain_message(e))
    }, error = function(e) paste("base error:", conditionMessage(e)))
    paste0(paste(deparse(call, 500L), collapse = " "), "\n  ", without_lists(said))
  }, "")
  expect_gte(length(texts), 150L)
  expect_identical(list.files(all.files = TRUE, no.. = TRUE), character())
  expect_identical(grep("\n  (nothing is wrong|base error)", texts, value = TRUE), character())
  expect_snapshot(cat(texts, sep = "\n"), cran = TRUE)
})

# A call of each export with its required arguments. gear_point() and other constructors do not
# check their arguments: gear() and tow() do.
least_calls <- alist(
  assembly(g), board_polar("flat_plate"),
  calibrate(g, data = hauls, change = cd, match = Drag ~ total_drag, nodes = 20), catalogue(),
  current_profile(table = 1), designs(towing.speed = 1:2), explain_misfit(fit),
  find_value(g, towing.speed = value_range(1, 3), target = list(body_depth = 100), nodes = 20),
  findings(g), flume(g), force_coefficients(), gear("a"), haul_means(log = 1, from = 1, to = 2),
  in_units(s), gear("a", gears = list(a = g)),
  measure_definitions(), measures(s), new_plan("gillnet"),
  normal_value(1, 0.1), optimise_gear(g, ~ total_drag, change = ch, nodes = 20),
  read_currents("a", longitude = 1, latitude = 1, time = 1), read_gear("cage"),
  read_moordyn("a"), read_net("a"), read_result("a"), read_sensor_log("a", columns = 1),
  report(s, "a.html"), run_study("a"), sample_posterior(fit), sensitivities(s), settle(g),
  share(s, "a.html"), state_at(tr, 1), tow(g, until = 2),
  tow_speed(g), track_schedule(log = 1, from = 1, to = 2),
  trade_off(g, list(a = ~ total_drag, b = ~ ship_tension), change = ch), uncertainty(s),
  value_range(1, 2), vary(g, towing.speed = 1:2, nodes = 20), view_3d(s), write_gear(g, "a.yaml"),
  write_result(s, "a.vtu")
)
constructors <- c("gear_point", "kite", "measure", "netting_panel", "otter_board", "piece", "rope",
  "seam", "tow_schedule")

test_that("every export throws a codend error for an argument of a wrong class", {
  kept <- setwd(test_folder())
  on.exit(setwd(kept))
  there <- misuse_variables()
  called <- vapply(least_calls, function(call) as.character(call[[1]]), "")
  exported <- getNamespaceExports("codend")
  # a new export needs a call in the list
  listed <- c(called, constructors, "gears", "tidy", "glance", "augment")
  expect_identical(setdiff(exported, listed), character())
  unchecked <- character()
  for (call in least_calls[called %in% exported]) {
    definition <- get(as.character(call[[1]]), there)
    call <- match.call(definition, call)
    for (name in setdiff(names(formals(definition)), "...")) {
      for (wrong in expression(mean, globalenv(), as.Date("2020-01-01"))) {
        tried <- call
        tried[[name]] <- wrong
        outcome <- tryCatch(eval(tried, there), codend_error = identity, error = identity)
        if (!inherits(outcome, "codend_error")) {
          unchecked <- c(unchecked, paste(deparse(tried, 500L), collapse = " "))
        }
      }
    }
  }
  expect_identical(unchecked, character())
})
