// Measures of a settled shape as R has them (R/measure-*.R), by the programs of R/share-measures.R.
//
// codendMeasures(of, page): of.array(name) gives an array, as it is filled now; page is what R wrote.
// It has measure(found), which takes what the engine found - x, force, bar_tension, u_tension,
// v_tension, plates, reported(name) - and returns {values: SI by name, drag: of every part along the
// flow over its size, meshes: or null}. Sums run in the order of R's.
function codendMeasures(of, page) {
  'use strict';
  var whole = page.whole, programs = page.programs, a = of.array;

  function zeros(n) { return new Float64Array(n); }
  function sum(values) { for (var s = 0, k = 0; k < values.length; k++) s += values[k]; return s; }

  // ---- what all of a shape's measures take ------------------------------------------------------

  // Along the flow, across it and up, as R's flow_axes().
  function flow_axes() {
    var flow = [1, 0], x = a('water.x'), y = a('water.y'), best = 0;
    if (a('page/speed')[0] === 0) {
      for (var k = 0; k < x.length; k++) {
        var speed = Math.sqrt(x[k] * x[k] + y[k] * y[k]);
        if (speed > best) { best = speed; flow = [x[k] / speed, y[k] / speed]; }
      }
    }
    return { flow: [flow[0], flow[1], 0], across: [-flow[1], flow[0], 0], up: [0, 0, 1] };
  }
  // Velocity of the water past the vessel at a depth.
  function water_at(depth) {
    var d = a('water.depth'), x = a('water.x'), y = a('water.y'), n = d.length;
    if (n === 1) return [x[0], y[0]];
    return [between(d, x, depth), between(d, y, depth)];
  }
  // Straight between points; beyond the ends their values hold.
  function between(at, values, x) {
    var n = at.length;
    if (x <= at[0]) return values[0];
    if (x >= at[n - 1]) return values[n - 1];
    for (var k = 1; at[k] < x;) k++;
    return values[k - 1] + (values[k] - values[k - 1]) * ((x - at[k - 1]) / (at[k] - at[k - 1]));
  }

  // Positions of nodes and of points tied between two of them.
  function points_of(x) {
    var first = a('ties.first'), second = a('ties.second'), share = a('ties.share');
    var all = zeros(x.length + 3 * first.length);
    all.set(x);
    for (var k = 0; k < first.length; k++) {
      for (var c = 0; c < 3; c++) {
        all[x.length + 3 * k + c] = (1 - share[k]) * x[3 * (first[k] - 1) + c] +
          share[k] * x[3 * (second[k] - 1) + c];
      }
    }
    return all;
  }

  // Hydrodynamic force on every part, 3 each.
  function part_drag(found) {
    var total = zeros(3 * whole.parts);
    whole.flow.forEach(function (one) {
      var part = a(whole.element_part[one.kind]), force = found.reported(one.name);
      for (var k = 0; k < part.length; k++) {
        for (var c = 0; c < 3; c++) total[3 * part[k] + c] += force[3 * k + c];
      }
    });
    return total;
  }

  // Twine of netting, bars and cells: tension, length of one line and of all, and the part.
  function netting_lines(found) {
    var bars = a(whole.netting), cell = a(whole.cell_part), n = cell.length;
    var tension = [], long = [], part = [], k;
    var rest = a('bars.rest'), many = a('bars.multiplicity'), bar_part = a(whole.bar_part);
    for (k = 0; k < bars.length; k++) {
      tension.push(found.bar_tension[bars[k]]);
      long.push(many[bars[k]] * rest[bars[k]]);
      part.push(bar_part[bars[k]]);
    }
    if (!n) return { tension: tension, long: long, part: part };
    var in_cell = a(whole.cell_bars), cells = a('cells.rest'), straight = a('cells.straight');
    [found.u_tension, found.v_tension].forEach(function (of_cells) {
      for (k = 0; k < n; k++) {
        tension.push(of_cells[k]);
        long.push(in_cell[k] * cells[k]);
        part.push(cell[k]);
      }
    });
    for (k = 0; k < n; k++) {
      if (!(straight[k] > 0)) continue;
      tension.push(found.straight_tension[k]);
      long.push(in_cell[k] * straight[k]);
      part.push(cell[k]);
    }
    return { tension: tension, long: long, part: part };
  }

  // Mean tension over the share of the length that is loaded most.
  function most_loaded(tension, long) {
    var order = Array.from(tension.keys()).sort(function (i, j) {
      return tension[j] - tension[i] || i - j;
    });
    var most = whole.loaded_most * sum(long), reached = 0, total = 0;
    for (var k = 0; k < order.length && reached < most; k++) {
      total += tension[order[k]] * Math.min(long[order[k]], most - reached);
      reached += long[order[k]];
    }
    return total / most;
  }

  // Tension at both ends of a bar of a rope, as R's end_tensions().
  function end_tensions(found, bar) {
    var node = a('bars.node'), x = found.x, tension = found.bar_tension[bar], c;
    if (tension <= 0) return [tension, tension];
    var ends = [node[2 * bar] - 1, node[2 * bar + 1] - 1], way = minus(at(x, ends[1]), at(x, ends[0]));
    var size = Math.sqrt(dot(way, way)), rope = a(whole.bar_part)[bar], force = [0, 0, 0];
    whole.flow.forEach(function (one) {
      if (one.kind !== 'bars') return;
      var drag = found.reported(one.name);
      for (c = 0; c < 3; c++) force[c] += drag[3 * bar + c] / 2;
    });
    var half = whole.gravity * a('bars.rest')[bar] / 2;
    return ends.map(function (end, k) {
      var wet = a('water.free_surface')[0] ? (1 - Math.sign(x[3 * end + 2])) / 2 : 1;
      var weight = half * (a('page/rope_mass')[rope] - wet * a('water.density')[0] * a('page/rope_volume')[rope]);
      var pull = [0, 1, 2].map(function (c) {
        return way[c] / size * tension + (k ? -1 : 1) * (force[c] - (c === 2 ? weight : 0));
      });
      return Math.sqrt(dot(pull, pull));
    });
  }
  function largest_end(found, bars) {
    var most = -Infinity;
    bars.forEach(function (bar) {
      var both = end_tensions(found, bar);
      most = Math.max(most, both[0], both[1]);
    });
    return most;
  }

  // Force of the sea bed: {normal, along, length of rope that touches}.
  function ground_of(found, axes) {
    var total = [0, 0, 0], normal = a('ground.normal'), touching = new Set();
    var contact = found.reported('contact_force'), node = a(whole.contacts);
    for (var k = 0; k < contact.length; k++) {
      total[k % 3] += contact[k];
      if (contact[k] !== 0) touching.add(node[(k - k % 3) / 3]);
    }
    var plates = found.reported('plate_ground_force');
    for (k = 0; k < plates.length; k++) total[k % 3] += plates[k];
    var length = 0, rest = a('bars.rest'), ends = a('bars.node');
    a(whole.ground_ropes).forEach(function (bar) {
      var on = touching.has(ends[2 * bar] - 1) + touching.has(ends[2 * bar + 1] - 1);
      length += rest[bar] * on / 2;
    });
    return { normal: dot(normal, total), along: dot(total, axes.flow), length: length };
  }

  function dot(p, q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
  function cross(p, q) {
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  }
  function minus(p, q) { return [p[0] - q[0], p[1] - q[1], p[2] - q[2]]; }
  function at(x, k) { return [x[3 * k], x[3 * k + 1], x[3 * k + 2]]; }

  // The horizontal part of the vector area within an outline of nodes, as along x and along y.
  function outline_area(x, outline) {
    var ahead = 0, side = 0;
    outline.forEach(function (p, k) {
      var q = outline[(k + 1) % outline.length];
      ahead += x[3 * p + 1] * x[3 * q + 2] - x[3 * q + 1] * x[3 * p + 2];
      side += x[3 * p + 2] * x[3 * q] - x[3 * q + 2] * x[3 * p];
    });
    return [ahead / 2, side / 2];
  }

  // ---- meshes ---------------------------------------------------------------------------------

  // As R's mesh_places(): opening, angle, u, v (3 each) and place of all places of meshes.
  function mesh_places(points) {
    var m = page.scene.meshes;
    if (!m) return null;
    var from = a(m.from), to = a(m.to), share = a(m.share), all = zeros(3 * from.length), k, c;
    for (k = 0; k < from.length; k++) {
      for (c = 0; c < 3; c++) {
        var p = points[3 * from[k] + c], q = points[3 * to[k] + c];
        all[3 * k + c] = share[k] === 1 ? q : p + (q - p) * share[k];
      }
    }
    var kept = a(m.kept), before = a(m.before), after = a(m.after), per = a(m.per_mesh);
    var slant = a(m.slant), square = a(m.square), turned = a(m.turned), n = kept.length;
    var count = a(m.down.count), column = a(m.down.column), weight = a(m.down.weight), next = 0;
    var out = { opening: zeros(n), angle: zeros(n), u: zeros(3 * n), v: zeros(3 * n), x: zeros(3 * n) };
    for (k = 0; k < n; k++) {
      var here = at(all, kept[k]), fore = at(all, kept[before[k]]), aft = at(all, kept[after[k]]);
      var one = minus(here, fore), two = minus(aft, here), i = minus(aft, fore);
      var opening = (Math.sqrt(dot(one, one)) + Math.sqrt(dot(two, two))) * per[k];
      i = i.map(function (v) { return v * per[k]; });
      var straight = Math.sqrt(dot(i, i));
      var bent = straight === 0 ? 1 : opening / Math.max(straight, 1e-300), j = [0, 0, 0];
      i = i.map(function (v) { return v * bent; });
      for (var t = 0; t < count[k]; t++, next++) {
        for (c = 0; c < 3; c++) j[c] += weight[next] * all[3 * column[next] + c];
      }
      for (c = 0; c < 3; c++) j[c] -= i[c] * slant[k];
      var half = square[k] ? 1 : 0.5, d = square[k] ? 0 : 1;
      var u = [0, 1, 2].map(function (c) { return (j[c] * d + i[c]) * half; });
      var v = [0, 1, 2].map(function (c) { return (j[c] - i[c] * d) * half; });
      var cosine = dot(u, v) / (Math.sqrt(dot(u, u)) * Math.sqrt(dot(v, v)));
      var angle = Math.acos(Math.min(Math.max(cosine, -1), 1));
      out.angle[k] = isFinite(cosine) ? turned[k] ? Math.PI - angle : angle : NaN;
      out.opening[k] = opening;
      for (c = 0; c < 3; c++) {
        out.u[3 * k + c] = u[c];
        out.v[3 * k + c] = v[c];
        out.x[3 * k + c] = here[c];
      }
    }
    return out;
  }

  function mean_of_meshes(found, panels, field) {
    var m = page.scene.meshes, panel = a(m.panel), meshes = a(m.meshes), total = 0, all = 0;
    for (var k = 0; k < panel.length; k++) {
      if (panels.indexOf(panel[k]) < 0 || !(meshes[k] > 0) || isNaN(found[field][k])) continue;
      total += found[field][k] * meshes[k];
      all += meshes[k];
    }
    return total / all;
  }

  // Area across the flow that twine hides, as R's twine_shadow() with src/shadow.cpp.
  function twine_shadow(found, axes) {
    var m = page.scene.meshes, panel = a(m.panel), meshes = a(m.meshes), width = a('page/width');
    var square = a(m.square), reach = a(m.reach), of_panel = a(m.panel_square), kept = [], k;
    for (k = 0; k < meshes.length; k++) if (meshes[k] > 0) kept.push(k);
    if (!kept.length) return 0;
    function seen(values, k) {
      var p = at(values, k);
      return [dot(axes.across, p), dot(axes.up, p)];
    }
    function long(p) { return Math.sqrt(p[0] * p[0] + p[1] * p[1]); }
    var pieces = kept.map(function (k) {
      var u = seen(found.u, k), v = seen(found.v, k), s = of_panel[panel[k]];
      var bars = meshes[k] * (2 - s), area = bars * Math.abs(u[0] * v[1] - u[1] * v[0]);
      function through(bar) {
        return 1 - Math.min(1, bars * width[panel[k]] * long(bar) / Math.max(area, 1e-12));
      }
      return {
        at: seen(found.x, k), area: area,
        depth: -Math.log(Math.max(through(u) * through(v), 0.01)) * area,
        i: [u[0] - (s ? 0 : v[0]), u[1] - (s ? 0 : v[1])],
        j: [(s ? 0 : u[0]) + v[0], (s ? 0 : u[1]) + v[1]], reach: reach.subarray(4 * k, 4 * k + 4)
      };
    });
    var n = pieces.length, wide = 0, deep = 0, area = 0;
    pieces.forEach(function (p) {
      wide += long(p.i) * (p.reach[1] - p.reach[0]);
      deep += long(p.j) * (p.reach[3] - p.reach[2]);
      area += p.area;
    });
    wide /= n;
    deep /= n;
    var across = Math.max(1, Math.min(16, even(4 * Math.sqrt(wide / Math.max(deep, 1e-9)))));
    return shadow(pieces, across, even(16 / across), Math.sqrt(area / n));
  }
  // Rounds half to even, as R and nearbyint() do.
  function even(x) {
    var low = Math.floor(x), over = x - low;
    return over < 0.5 ? low : over > 0.5 ? low + 1 : low + low % 2;
  }
  function shadow(pieces, across, down, size) {
    var parts = across * down, middle = [[], []], low = [], cell = [], cells = [];
    for (var way = 0; way < 2; way++) {
      var least = Infinity, most = -Infinity;
      pieces.forEach(function (p) {
        for (var c = 0; c < across; c++) {
          var right = p.reach[0] + (c + 0.5) / across * (p.reach[1] - p.reach[0]);
          for (var d = 0; d < down; d++) {
            var aft = p.reach[2] + (d + 0.5) / down * (p.reach[3] - p.reach[2]);
            var here = p.at[way] + p.i[way] * right + p.j[way] * aft;
            middle[way].push(here);
            least = Math.min(least, here);
            most = Math.max(most, here);
          }
        }
      });
      low.push(least);
      var wide = Math.max(most - least, 1e-6);
      cells.push(Math.min(Math.max(even(wide / Math.max(size, 1e-6)), 1), 400));
      cell.push(wide / cells[way]);
    }
    var thick = zeros(cells[0] * cells[1]);
    function number(way, k) {
      return Math.min(Math.trunc((middle[way][k] - low[way]) / cell[way]), cells[way] - 1);
    }
    for (var k = 0; k < middle[0].length; k++) {
      thick[number(0, k) + cells[0] * number(1, k)] += pieces[Math.floor(k / parts)].depth / parts;
    }
    var one = cell[0] * cell[1], hidden = 0;
    for (k = 0; k < thick.length; k++) hidden += 1 - Math.exp(-thick[k] / one);
    return hidden * one;
  }

  // ---- volumes --------------------------------------------------------------------------------

  function triple(p, q, r) { return dot(p, cross(q, r)); }

  function volume_within(program, x, points) {
    var from = a(program.from), to = a(program.to), share = a(program.between), n = from.length;
    var places = zeros(3 * n), middle = [0, 0, 0], k, c;
    for (k = 0; k < n; k++) {
      for (c = 0; c < 3; c++) {
        var p = points[3 * from[k] + c], q = points[3 * to[k] + c];
        places[3 * k + c] = share[k] === 1 ? q : p + (q - p) * share[k];
        middle[c] += places[3 * k + c] / n;
      }
    }
    var total = 0, facets = a(program.facets);
    for (k = 0; k < facets.length; k += 3) {
      total += triple(minus(at(places, facets[k]), middle), minus(at(places, facets[k + 1]), middle),
        minus(at(places, facets[k + 2]), middle));
    }
    var lid_from = a(program.lid_from), lid_to = a(program.lid_to), lid = a(program.lid), rims = {};
    for (k = 0; k < lid.length; k++) {
      var rim = rims[lid[k]] = rims[lid[k]] || { at: [0, 0, 0], count: 0 };
      rim.count += 1;
      for (c = 0; c < 3; c++) rim.at[c] += x[3 * lid_from[k] + c];
    }
    for (k = 0; k < lid.length; k++) {
      var over = rims[lid[k]].at.map(function (v) { return v / rims[lid[k]].count; });
      total += triple(minus(over, middle), minus(at(x, lid_from[k]), middle),
        minus(at(x, lid_to[k]), middle));
    }
    return Math.abs(total / 6);
  }

  // The integral of z n_z over a triangle.
  function upward(p, q, r) {
    var area = ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2;
    return area * (p[2] + q[2] + r[2]) / 3;
  }
  function enclosed_volume(program, points) {
    var node = a(program.triangles), weight = a(program.weights), rope = program.rope, total = 0;
    for (var k = 0; k < weight.length; k++) {
      total += weight[k] * upward(at(points, node[3 * k]), at(points, node[3 * k + 1]),
        at(points, node[3 * k + 2]));
    }
    var middle = [0, 0, 0], under = 0;
    rope.forEach(function (n) {
      for (var c = 0; c < 3; c++) middle[c] += points[3 * n + c] / rope.length;
    });
    rope.forEach(function (n, k) {
      under += upward(at(points, n), at(points, rope[(k + 1) % rope.length]), middle);
    });
    return Math.abs(total + program.way * under);
  }

  // ---- measures by their kind -----------------------------------------------------------------

  function pair_mean(program, x, of_pair) {
    var total = 0;
    program.pairs.forEach(function (pair) { total += of_pair(minus(at(x, pair[1]), at(x, pair[0]))); });
    return total / program.pairs.length;
  }
  function by_part(state, program, axis) {
    var total = 0;
    program.parts.forEach(function (part) { total += dot(state.axes[axis], at(state.drag, part)); });
    return total;
  }
  function first_pair(program, x) {
    return minus(at(x, program.pairs[0][1]), at(x, program.pairs[0][0]));
  }
  var asked = {
    spread: function (s, p) {
      return pair_mean(p, s.x, function (d) { return Math.sqrt(d[0] * d[0] + d[1] * d[1]); });
    },
    height: function (s, p) { return -first_pair(p, s.x)[2]; },
    length: function (s, p) { var d = first_pair(p, s.x); return Math.sqrt(dot(d, d)); },
    depth: function (s, p) {
      var total = 0;
      p.nodes.forEach(function (n) { total += s.x[3 * n + 2]; });
      return -(total / p.nodes.length);
    },
    sinking_speed: function () { return 0; },
    clearance: function (s, p) {
      return dot(a('ground.normal'), at(s.x, p.nodes[0])) - a('ground.height')[0];
    },
    area: function (s, p) { var both = outline_area(s.x, p.outline); return Math.hypot(both[0], both[1]); },
    angle: function (s, p) {
      var d = minus(at(s.x, p.nodes[1]), at(s.x, p.nodes[0]));
      return p.way === 'declination' ? Math.atan2(-d[2], Math.sqrt(d[0] * d[0] + d[1] * d[1])) :
        Math.atan2(Math.abs(d[1]), d[0]);
    },
    attitude: function (s, p) { return s.found.plates[5 * p.board + p.angle]; },
    tension: function (s, p) {
      if (p.place === 'max') return largest_end(s.found, p.bars);
      if (p.place === 'middle') return s.found.bar_tension[p.bars[0]];
      return end_tensions(s.found, p.bars[0])[p.place === 'start' ? 0 : 1];
    },
    drag: function (s, p) { return by_part(s, p, 'flow'); },
    lift: function (s, p) { return by_part(s, p, 'up'); },
    mesh_opening: function (s, p) { return mean_of_meshes(s.meshes, p.panels, 'opening'); },
    mesh_angle: function (s, p) { return mean_of_meshes(s.meshes, p.panels, 'angle'); },
    volume: function (s, p) { return volume_within(p, s.x, s.points); },
    volume_share: function (s, p) {
      return volume_within(p, s.x, s.points) / a('page/shares')[p.share];
    },
    enclosed_volume: function (s, p) { return enclosed_volume(p, s.points); }
  };

  function total_drag(s) {
    var total = [0, 0, 0];
    whole.supports.forEach(function (node) {
      for (var c = 0; c < 3; c++) total[c] -= s.found.force[3 * node + c];
    });
    return -dot(total, s.axes.flow);
  }
  function filtered(s) {
    var depth = 0, mouth = whole.mouth;
    mouth.outline.forEach(function (n) { depth -= s.x[3 * n + 2] / mouth.outline.length; });
    var past = water_at(depth), both = outline_area(s.x, mouth.outline);
    return Math.abs(both[0] * past[0] + both[1] * past[1]);
  }
  // Ground passed by the lines between wing ends; nodes rest in the vessel's axes.
  function swept(s) {
    var total = 0;
    whole.wings.forEach(function (pair) {
      total += Math.abs(-(s.x[3 * pair[1] + 1] - s.x[3 * pair[0] + 1]) * -a('page/speed')[0]);
    });
    return total / whole.wings.length;
  }
  function engine(s) {
    var speeds = a('page/vessel.speed'), pulls = a('page/vessel.pull'), n = speeds.length, pull;
    var speed = a('page/speed')[0];
    if (speed <= speeds[n - 1]) {
      pull = between(speeds, pulls, speed);
    } else {
      var slope = (pulls[n - 1] - pulls[n - 2]) / (speeds[n - 1] - speeds[n - 2]);
      pull = Math.max(0, pulls[n - 1] + slope * (speed - speeds[n - 1]));
    }
    var share = Math.max(0, s.drag_whole) / pull, full = a('page/vessel.power')[0];
    var power = full * Math.pow(share, 1.5), fuel;
    if (of.has('page/vessel.consumption')) {
      var used = a('page/vessel.consumption');
      fuel = power * (used.length > 1 ? between(a('page/vessel.load'), used, power / full) : used[0]) /
        a('page/vessel.density')[0];
    }
    return { share: share, power: power, fuel: fuel };
  }
  var standard = {
    total_drag: function (s) { return s.drag_whole; },
    tow_power: function (s) { return s.drag_whole * a('page/speed')[0]; },
    filtered_volume: filtered,
    swept_area: swept,
    mouth_blockage: function (s) {
      var both = outline_area(s.x, whole.mouth.outline);
      return twine_shadow(s.meshes, s.axes) / Math.hypot(both[0], both[1]);
    },
    engine_power: function (s) { return engine(s).power; },
    pull_used: function (s) { return engine(s).share; },
    fuel_rate: function (s) { return engine(s).fuel; },
    fuel_per_swept_area: function (s) { return engine(s).fuel / swept(s); },
    fuel_per_filtered_volume: function (s) { return engine(s).fuel / filtered(s); },
    fuel_per_catch: function (s) { return engine(s).fuel / (a('page/vessel.catch')[0] / 3600); },
    catch_volume: function (s) { return of.catching.volume(s.points); },
    catch_surface: function (s) { return of.catching.surface(s.points); },
    catch_front: function () { return of.catching.blocked(); },
    largest_rope_tension: function (s) { return largest_end(s.found, a(whole.ropes)); },
    largest_panel_twine_tension: function (s) {
      var total = {}, long = {}, most = -Infinity;
      s.netting.part.forEach(function (part, k) {
        total[part] = (total[part] || 0) + s.netting.tension[k] * s.netting.long[k];
        long[part] = (long[part] || 0) + s.netting.long[k];
      });
      Object.keys(total).forEach(function (part) { most = Math.max(most, total[part] / long[part]); });
      return most;
    },
    most_loaded_twine_tension: function (s) {
      return most_loaded(s.netting.tension, s.netting.long);
    },
    slack_netting: function (s) {
      var slack = 0;
      s.netting.tension.forEach(function (t, k) { if (t === 0) slack += s.netting.long[k]; });
      return slack / sum(s.netting.long);
    },
    rope_on_ground: function (s) { return s.ground.length; },
    ground_load: function (s) { return s.ground.normal; },
    ground_friction: function (s) { return s.ground.along / s.drag_whole; },
    least_depth: function (s) {
      for (var most = -Infinity, k = 2; k < s.x.length; k += 3) most = Math.max(most, s.x[k]);
      return -most + 0;
    },
    greatest_depth: function (s) {
      for (var least = Infinity, k = 2; k < s.x.length; k += 3) least = Math.min(least, s.x[k]);
      return -least + 0;
    }
  };

  function measure(found) {
    var told = {}, reported = found.reported;
    found.reported = function (name) { return told[name] = told[name] || reported(name); };
    var s = { found: found, x: found.x, points: points_of(found.x), axes: flow_axes() };
    s.drag = part_drag(found);
    s.drag_whole = total_drag(s);
    s.netting = netting_lines(found);
    s.ground = of.has('ground.normal') ? ground_of(found, s.axes) : null;
    s.meshes = mesh_places(s.points);
    var values = {};
    Object.keys(programs).forEach(function (name) {
      var program = programs[name], kind = (program.asked ? asked : standard)[program.kind];
      values[name] = kind(s, program);
    });
    var size = a('page/size'), drag = new Float32Array(whole.parts);
    for (var k = 0; k < whole.parts; k++) {
      drag[k] = size[k] > 0 ? Math.max(dot(s.axes.flow, at(s.drag, k)), 0) / Math.max(size[k], 1e-9) : 0;
    }
    return { values: values, drag: drag, meshes: s.meshes, points: s.points };
  }

  return { measure: measure, water_at: water_at, points: points_of };
}
if (typeof module !== 'undefined') module.exports = codendMeasures;
