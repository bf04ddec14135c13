// A gear in the engine: fills its arrays for the sliders' values, settles it and measures what it
// finds. For the worker of a shared page, and for tests in node.
//
// codendModel(engine, page, bytes): engine is the compiled engine, page what R wrote (R/share.R),
// bytes its arrays. It has
//   values()          the sliders' values that hold now, by number
//   move(values)      settles the gear at other values, a step at a time: see walk()
//   shape()           {points, places, boards, rope_tension, u, v, drag, opening, angle: as the viewer
//                     takes them, measures, warnings, conditions}
function codendModel(engine, page, bytes) {
  'use strict';
  var head = page.head, base = {}, arrays = {}, decoder = new TextDecoder();

  // ---- arrays -----------------------------------------------------------------------------------

  var of = codendArrays(head, bytes, arrays);

  function text(words, then) {
    var raw = new TextEncoder().encode(words + '\0'), at = engine._malloc(raw.length);
    engine.HEAPU8.set(raw, at);
    try { return then(at); } finally { engine._free(at); }
  }
  function words_at(at) {
    var end = at;
    while (engine.HEAPU8[end]) end++;
    return decoder.decode(engine.HEAPU8.subarray(at, end));
  }
  function hand_over(name, values) {
    text(name, function (at) {
      if (values instanceof Int32Array) {
        var to = engine._codend_wholes(at, values.length);
        engine.HEAP32.set(values, to >> 2);
      } else if (Array.isArray(values)) {
        text(values.join('\n'), function (list) { engine._codend_words(at, list, values.length); });
      } else {
        var place = engine._codend_numbers(at, values.length);
        engine.HEAPF64.set(values, place >> 3);
      }
    });
  }
  function found(name) {
    return text(name, function (at) {
      var count = engine._codend_count(at);
      if (count < 0) throw new Error('The engine does not know ' + name);
      var from = engine._codend_found(at) >> 3;
      return engine.HEAPF64.slice(from, from + count);
    });
  }
  function checked(result) {
    if (result < 0) throw new Error(words_at(engine._codend_error()));
    return result;
  }

  // ---- filling ----------------------------------------------------------------------------------

  var fields = page.fields, touched = {};
  page.terms.forEach(function (term) { touched[term.array] = true; });

  function share_of(field, value) {
    return (2 * value - field.lower - field.upper) / (field.upper - field.lower);
  }
  function chebyshev(t, n) {
    var angle = Math.acos(Math.min(Math.max(t, -1), 1)), out = [];
    for (var k = 0; k < n; k++) out.push(Math.cos(k * angle));
    return out;
  }
  // The sums of a term's series, one for each of its patterns.
  function sums(term, t) {
    var n = term.columns, one, two;
    if (term.of.length === 1) {
      one = chebyshev(t[term.of[0]], n);
    } else {
      var side = Math.round(Math.sqrt(n)), first = chebyshev(t[term.of[0]], side);
      two = chebyshev(t[term.of[1]], side);
      one = [];
      for (var b = 0; b < side; b++) for (var a = 0; a < side; a++) one.push(first[a] * two[b]);
    }
    var out = [], series = of.array(term.series), rows = term.rows;
    for (var r = 0; r < rows; r++) {
      for (var s = 0, k = 0; k < n; k++) s += series[r + rows * k] * one[k];
      out.push(s);
    }
    return out;
  }
  function fill(values) {
    var t = fields.map(function (field, k) { return share_of(field, values[k]); });
    Object.keys(touched).forEach(function (name) {
      if (!base[name]) base[name] = Float64Array.from(of.array(name));
      arrays[name] = base[name].slice();
    });
    page.terms.forEach(function (term) {
      var share = sums(term, t), x = arrays[term.array], index = of.array(term.index);
      var pattern = of.array(term.pattern), n = index.length;
      for (var r = 0; r < share.length; r++) {
        for (var k = 0; k < n; k++) x[index[k]] += pattern[r * n + k] * share[r];
      }
    });
    if (page.bag === 'front') engine._codend_front(0);
  }
  // Hands the arrays that have changed over and reads the model anew.
  function read() {
    Object.keys(touched).forEach(function (name) {
      if (!/^page\//.test(name)) hand_over(name, arrays[name]);
    });
    if (wake.length) hand_over('model.wake', wake);
    checked(engine._codend_read());
    hold();
  }
  // Held nodes stay where the sliders have them.
  var held = [], wake = new Float64Array(0);
  function hold() {
    if (!held.length) return;
    var x = position(), at = of.array('page/held');
    for (var k = 0; k < held.length; k++) for (var c = 0; c < 3; c++) x[3 * held[k] + c] = at[3 * k + c];
    put(x);
  }
  function position() { return found('position'); }
  function put(x) {
    var at = engine._codend_position(x.length);
    engine.HEAPF64.set(x, at >> 3);
  }
  function put_strain(strain) {
    var at = engine._codend_strain(strain.length);
    engine.HEAPF64.set(strain, at >> 3);
  }

  // ---- settling ---------------------------------------------------------------------------------

  var tolerance = page.tolerance, parts_at = 0, good = null;

  function settle() { return checked(engine._codend_settle(parts_at, tolerance, page.steps)) === 1; }
  // With a catch that is given by its volume the front moves until it is met: a secant, as R's.
  function settle_catch() {
    if (page.bag !== 'volume') return settle();
    var wanted = Math.log(of.array('page/catch.volume')[0]), end = Math.log(of.array('page/catch.deep')[0]);
    var front = Math.log(engine._codend_blocked()), before = null, low = null, high = null;
    for (var turn = 0; turn < 40; turn++) {
      engine._codend_front(Math.exp(front));
      read();
      if (!settle()) return false;
      var volume = engine._codend_volume();
      var off = volume > 0 ? Math.log(volume) - wanted : -Infinity;
      if (Math.abs(off) < 1e-9) return true;
      if (off < 0 && front >= end) return false;
      var here = { front: front, off: off };
      if (off < 0) low = here; else high = here;
      var slope = before ? (here.off - before.off) / (here.front - before.front) : 1;
      var guess = here.front - here.off / slope;
      var most = high ? high.front : Math.min(here.front + 1, end), least = low ? low.front : here.front - 1;
      front = isFinite(guess) && guess > least && guess < most ? guess :
        !low ? least : !high ? most : (least + most) / 2;
      if (before && Math.abs(off - before.off) < 1e-12) return Math.abs(off) < 1e-6;
      before = here;
    }
    return false;
  }
  // Drag grows with the square of the speed, and most lines pull against drag.
  function settle_at(values) {
    var speed = of.has('page/speed') ? of.array('page/speed')[0] : 0;
    fill(values);
    var now = of.has('page/speed') ? of.array('page/speed')[0] : 0;
    var grow = good && speed > 0 && now > 0 ? now * now / (speed * speed) : 1;
    read();
    if (good && grow !== 1) put_strain(good.strain.map(function (v) { return v * grow; }));
    if (!settle_catch()) return false;
    wake = found('wake');
    good = {
      values: values.slice(), x: position(), strain: found('strain'), wake: wake,
      blocked: engine._codend_blocked(), unstable: engine._codend_unstable() === 1,
      steps: engine._codend_iterations()
    };
    return true;
  }
  function restore() {
    put(good.x);
    put_strain(good.strain);
    wake = good.wake;
    if (page.bag) engine._codend_front(good.blocked);
    fill(good.values);
    read();
  }

  // How far sliders together go at once, in ranges, and how often a part that fails is halved.
  var most_way = 0.5, most_halved = 4;

  // From where the gear is to other values in parts: calls of the function that it gives settle the
  // next part each and say 'done', 'more' or 'stuck' (the gear stays where it came).
  function walk(values) {
    var from = good.values.slice(), way = 0, part = 0;
    fields.forEach(function (field, k) {
      way += Math.abs(values[k] - from[k]) / (field.upper - field.lower);
    });
    var size = 1 / Math.max(1, Math.ceil(way / most_way - 1e-9)), halved = 0;
    return function () {
      var next = part + size > 1 - 1e-9 ? 1 : part + size;
      var at = next === 1 ? values.slice() : from.map(function (v, k) { return v + next * (values[k] - v); });
      if (settle_at(at)) {
        part = next;
        return part === 1 ? 'done' : 'more';
      }
      restore();
      if (halved++ >= most_halved) return 'stuck';
      size /= 2;
      return 'more';
    };
  }

  // ---- what is shown ----------------------------------------------------------------------------

  // empty: the mean of a group without bars and cells.
  function group_means(groups, bars, cells, empty) {
    var element = of.array(groups.element), group = of.array(groups.group), n = groups.count;
    var weight = of.array(groups.weight), split = cells ? groups.split : element.length, into = new Float32Array(n);
    var total = new Float64Array(n), all = new Float64Array(n);
    for (var k = 0; k < element.length; k++) {
      var value = k < split ? bars[element[k]] : cells[element[k]];
      total[group[k]] += value * weight[k];
      all[group[k]] += weight[k];
    }
    for (k = 0; k < n; k++) into[k] = all[k] ? total[k] / all[k] : empty;
    return into;
  }
  function mesh_means(found, angles) {
    var m = page.scene.meshes, panel = of.array(m.panel), unit = of.array(m.unit);
    var value = Array.from(found, function (v, k) {
      if (isNaN(v)) return 0;
      return angles ? v * 180 / Math.PI : 100 * v / unit[panel[k]];
    });
    var count = of.array(m.means.count), column = of.array(m.means.column), weight = of.array(m.means.weight);
    var out = new Float32Array(count.length), at = 0, middle = null;
    for (var k = 0; k < count.length; k++) {
      if (!count[k]) {
        if (middle === null) middle = value.slice().sort(function (p, q) { return p - q; })[value.length >> 1];
        out[k] = middle;
        continue;
      }
      for (var total = 0, t = 0; t < count[k]; t++, at++) total += weight[at] * value[column[at]];
      out[k] = Math.max(total, 1e-6);
    }
    return out;
  }

  function minus(p, q) { return [p[0] - q[0], p[1] - q[1], p[2] - q[2]]; }
  function dot(p, q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
  function unit(v) { var l = Math.sqrt(dot(v, v)); return v.map(function (c) { return c / l; }); }
  // Three axes at right angles that three points fix.
  function triad(p) {
    var first = unit(minus(p[1], p[0])), other = minus(p[2], p[0]), along = dot(other, first);
    var second = unit([0, 1, 2].map(function (c) { return other[c] - along * first[c]; }));
    return [first, second, [
      first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
      first[0] * second[1] - first[1] * second[0]
    ]];
  }
  // Corners of free boards, as R's board_corners().
  function board_corners(x) {
    var out = new Float32Array(12 * page.scene.boards.length), own = of.has('page/boards') ? of.array('page/boards') : [];
    page.scene.boards.forEach(function (nodes, b) {
      var at = nodes.map(function (n) { return [x[3 * n], x[3 * n + 1], x[3 * n + 2]]; });
      var fixed = own.subarray(11 * b, 11 * b + 11), chord = fixed[9], span = fixed[10];
      var attached = [0, 1, 2].map(function (k) { return Array.from(fixed.subarray(3 * k, 3 * k + 3)); });
      var to = triad(at), from = triad(attached);
      [[0, -0.5], [0, 0.5], [1, 0.5], [1, -0.5]].forEach(function (corner, k) {
        var local = minus([corner[0] * chord, 0, corner[1] * span], attached[0]);
        var along = from.map(function (axis) { return dot(axis, local); });
        for (var c = 0; c < 3; c++) {
          out[12 * b + 3 * k + c] = at[0][c] + along[0] * to[0][c] + along[1] * to[1][c] + along[2] * to[2][c];
        }
      });
    });
    return out;
  }

  function shape() {
    checked(engine._codend_evaluate());
    var now = {
      x: position(), bar_tension: found('bar_tension'), u_tension: found('u_tension'),
      v_tension: found('v_tension'), plates: found('plates')
    };
    var at = found('points'), values = {}, drag = new Float32Array(found('drag'));
    found('measures').forEach(function (value, k) { values[page.order[k]] = value; });
    var scene = page.scene, drawn = of.array(scene.drawn), size = of.array('page/size'), k, c;
    for (k = 0; k < drag.length; k++) {
      drag[k] = size[k] > 0 ? Math.max(drag[k], 0) / Math.max(size[k], 1e-9) : 0;
    }
    var points = new Float32Array(3 * drawn.length), places = new Float32Array(3 * scene.marks.length);
    for (k = 0; k < drawn.length; k++) {
      for (c = 0; c < 3; c++) points[3 * k + c] = at[3 * drawn[k] + c];
    }
    scene.marks.forEach(function (nodes, k) {
      nodes.forEach(function (n) {
        for (var c = 0; c < 3; c++) places[3 * k + c] += at[3 * n + c] / nodes.length;
      });
    });
    var out = {
      points: points, places: places, boards: board_corners(now.x), drag: drag,
      rope_tension: group_means(scene.rope, now.bar_tension, null, 0),
      u: group_means(scene.u, now.bar_tension, now.u_tension, NaN),
      v: group_means(scene.v, now.bar_tension, now.v_tension, NaN)
    };
    var flow = page.conditions.water ? found('flow') : [0, 0];
    if (scene.meshes) {
      out.opening = mesh_means(found('opening'), false);
      out.angle = mesh_means(found('angle'), true);
    }
    return {
      moved: out, measures: values, warnings: warnings(now, values),
      flow: flow, conditions: conditions(flow), values: good.values.slice(), steps: good.steps
    };
  }

  // What a reader is warned of: [words] each.
  function warnings(now, values) {
    var out = [], degrees = 180 / Math.PI;
    if (good.unstable) out.push('The balance that was found does not last: a small push carries the gear away from it.');
    (page.boards || []).forEach(function (board, k) {
      var attack = now.plates[5 * k] * degrees, heel = now.plates[5 * k + 1] * degrees;
      var stall = of.array('page/stall')[k];
      if (Math.abs(heel) > page.fallen_heel) out.push(board + ' has fallen over: it heels by ' + heel.toFixed(0) + ' deg.');
      else if (attack < 0) out.push(board + ' is back-winded: the flow meets its outer face, at ' + attack.toFixed(0) + ' deg.');
      else if (attack > stall) out.push(board + ' is stalled: it meets the flow at ' + attack.toFixed(0) + ' deg, and its lift is largest at ' + stall.toFixed(0) + ' deg.');
    });
    var strength = of.array('page/strength'), part = of.array('frame.part.bars'), most = {};
    for (var k = 0; k < part.length; k++) {
      var p = part[k] - 1, share = strength[p] > 0 ? now.bar_tension[k] / strength[p] : 0;
      if (share > 1) most[p] = Math.max(most[p] || 0, share);
    }
    Object.keys(most).forEach(function (p) {
      out.push(page.names[p] + ' carries ' + (100 * most[p]).toFixed(0) + ' % of its breaking load.');
    });
    Object.keys(page.programs).forEach(function (name) {
      if (page.programs[name].kind === 'pull_used' && values[name] > 1) {
        out.push('The vessel cannot tow this gear so fast: it would take ' + (100 * values[name]).toFixed(0) + ' % of what it can pull.');
      }
    });
    return out;
  }

  function conditions(flow) {
    var speed = of.array('page/speed')[0], told = page.conditions, size = Math.hypot(flow[0], flow[1]);
    if (speed > 0) return 'towed at ' + Number((speed / page.knot).toFixed(2)) + ' knot' + told.waves;
    return size > 0 ? 'in a current of ' + size.toFixed(2) + ' m/s' + told.waves : told.still;
  }

  // ---- the beginning ----------------------------------------------------------------------------

  Object.keys(head).forEach(function (name) {
    if (/^(page|series|start)\//.test(name)) return;
    if (head[name][0] === 'g') {
      text(name, function (at) { engine._codend_groups(at, head[name][1]); });
    } else {
      hand_over(name, of.array(name));
    }
  });
  var lines = of.array('start/part');
  parts_at = engine._malloc(4 * lines.length);
  engine.HEAP32.set(lines, parts_at >> 2);
  var fixed = of.array('model.held');
  for (var k = 0; k < page.nodes; k++) if (fixed[k]) held.push(k);
  put(Float64Array.from(of.array('start/position')));
  put_strain(Float64Array.from(of.array('start/strain')));
  wake = of.has('start/wake') ? Float64Array.from(of.array('start/wake')) : wake;
  hand_over('model.wake', wake);
  if (!page.bag) hand_over('model.pressure.weight', new Float64Array(0));
  var own = fields.map(function (field) { return field.value; });
  if (!settle_at(own)) throw new Error('The gear did not settle on this page.');

  return {
    values: function () { return good.values.slice(); },
    walk: walk, shape: shape,
    // for tests
    memory: function () { return engine.HEAPU8.length; }
  };
}
if (typeof module !== 'undefined') module.exports = codendModel;
