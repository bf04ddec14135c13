// A gear in the engine: fills its numbers for the values of the sliders, settles and measures it.
// The worker of a shared page and tests in node use it.
//
// `codendModel(engine, page, bytes)`: `engine` is the compiled engine, `page` the description of
// R/share.R, `bytes` its arrays. Methods:
//   `values()` returns the settled values of the sliders.
//   `walk(values)` returns a function that settles the gear step by step.
//   `shape()` returns {moved, measures, warnings, flow, conditions, values, steps}.
//     `moved` contains points, places, boards, drag, rope_tension, u, v, opening and angle.
function codendModel(engine, page, bytes) {
  'use strict';
  var head = page.head, arrays = {}, decoder = new TextDecoder();

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

  // ---- filling and settling ---------------------------------------------------------------------

  var fields = page.fields, good = null, base = [];
  // The arrays that sliders change, concatenated.
  page.touched.forEach(function (name) { base.push.apply(base, of.array(name)); });

  // Returns the weights of the changes at all nodes of a term's sliders: Lagrange's polynomials. The
  // first slider varies fastest.
  function node_weights(term, values) {
    return term.of.reduce(function (before, f, s) {
      var nodes = term.nodes[s], out = [];
      nodes.forEach(function (node) {
        var weight = 1;
        nodes.forEach(function (other) { if (other !== node) weight *= (values[f] - other) / (node - other); });
        before.forEach(function (product) { out.push(product * weight); });
      });
      return out;
    }, [1]);
  }
  function fill(values) {
    var x = Float64Array.from(base), at = 0;
    page.terms.forEach(function (term) {
      var index = of.array(term.index), change = of.array(term.change), n = index.length;
      node_weights(term, values).forEach(function (weight, c) {
        for (var k = 0; k < n; k++) x[index[k]] += change[n * c + k] * weight;
      });
    });
    page.touched.forEach(function (name) {
      var from = at;
      at += of.array(name).length;
      arrays[name] = x.subarray(from, at);
      hand_over(name, arrays[name]);
    });
  }
  // Returns false if the gear does not settle, and restores the last settled values.
  function settle_at(values) {
    fill(values);
    if (checked(engine._codend_settle(page.tolerance, page.steps)) === 1) {
      good = values.slice();
      return true;
    }
    if (good) fill(good);
    return false;
  }

  // Largest step of all sliders together, in slider ranges; maximum number of halvings of a step.
  var most_way = 0.5, most_halved = 4;

  // Returns a function that settles one step towards `values` per call. It returns 'done', 'more'
  // or 'stuck' (the gear stays at its last settled values).
  function walk(values) {
    var from = good, way = 0, part = 0;
    fields.forEach(function (field, k) {
      way += Math.abs(values[k] - from[k]) / (field.upper - field.lower);
    });
    var size = 1 / Math.max(1, Math.ceil(way / most_way - 1e-9)), halved = 0;
    return function () {
      var next = part + size > 1 - 1e-9 ? 1 : part + size;
      var at = next === 1 ? values : from.map(function (v, k) {
        var between = v + next * (values[k] - v);
        return fields[k].whole ? Math.round(between) : between;
      });
      if (settle_at(at)) {
        part = next;
        return part === 1 ? 'done' : 'more';
      }
      if (halved++ >= most_halved) return 'stuck';
      size /= 2;
      return 'more';
    };
  }

  // ---- results ----------------------------------------------------------------------------------

  // empty: the value of a group without bars and cells.
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

  function shape() {
    checked(engine._codend_evaluate());
    var bars = found('bar_tension'), at = found('points'), values = {}, drag = new Float32Array(found('drag'));
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
      points: points, places: places, boards: new Float32Array(found('corners')), drag: drag,
      rope_tension: group_means(scene.rope, bars, null, 0),
      u: group_means(scene.u, bars, found('u_tension'), NaN),
      v: group_means(scene.v, bars, found('v_tension'), NaN)
    };
    var flow = page.conditions.water ? found('flow') : [0, 0];
    if (scene.meshes) {
      out.opening = mesh_means(found('opening'), false);
      out.angle = mesh_means(found('angle'), true);
    }
    var report = found('report');
    return {
      moved: out, measures: values, warnings: warnings(report[1], values),
      flow: flow, conditions: conditions(flow), values: good.slice(), steps: report[0]
    };
  }

  // Returns the warnings for the reader as strings.
  function warnings(unstable, values) {
    var out = [], degrees = 180 / Math.PI, plates = found('plates');
    if (unstable) out.push('The equilibrium is unstable: small disturbances grow.');
    (page.boards || []).forEach(function (board, k) {
      var attack = plates[5 * k] * degrees, heel = plates[5 * k + 1] * degrees;
      var stall = of.array('page/stall')[k];
      if (Math.abs(heel) > page.fallen_heel) out.push(board + ' has fallen over: it heels by ' + heel.toFixed(0) + ' deg.');
      else if (attack < 0) out.push(board + ' is back-winded: the flow hits its outer face, at ' + attack.toFixed(0) + ' deg.');
      else if (attack > stall) out.push(board + ' is stalled: its angle of attack is ' + attack.toFixed(0) + ' deg, but its lift is largest at ' + stall.toFixed(0) + ' deg.');
    });
    found('load').forEach(function (share, part) {
      if (share > 1) out.push(page.names[part] + ' carries ' + (100 * share).toFixed(0) + ' % of its breaking load.');
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

  // ---- initialisation ---------------------------------------------------------------------------

  Object.keys(head).forEach(function (name) {
    if (/^series\//.test(name)) return;
    if (head[name][0] === 'g') {
      text(name, function (at) { engine._codend_groups(at, head[name][1]); });
    } else {
      hand_over(name, of.array(name));
    }
  });
  if (!settle_at(fields.map(function (field) { return field.value; }))) {
    throw new Error('The gear did not settle on this page.');
  }

  return {
    values: function () { return good.slice(); },
    walk: walk, shape: shape,
    // for tests
    memory: function () { return engine.HEAPU8.length; }
  };
}
if (typeof module !== 'undefined') module.exports = codendModel;
