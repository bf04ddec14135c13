// The gear on canvases: the tank in three dimensions, and the three planes. Lines are painted from
// far to near. x is aft, y to starboard, z up; metres.
//
// codendTank.palettes(colours), .picture(message), .choose(group, value); what they take is made in
// R/flume-picture.R.
window.codendTank = (function () {
  'use strict';

  var shown = { now: null, pinned: null };
  var about = { flow: [0, 0], water: true, bed: null };
  var palettes = { ropes: [], netting: [] };
  var choice = { focus: 'net', from: 'bow', compare: 'off' };
  // Direction of the eye from the middle of the gear: angle from x aft towards y, and upwards,
  // radians.
  var views = {
    bow: [-2.05, 0.34], above: [-Math.PI / 2, Math.PI / 2], side: [-Math.PI / 2, 0], astern: [0, 0]
  };
  var camera = { turn: views.bow[0], rise: views.bow[1], zoom: 1, pan: [0, 0] };
  var ink = '#202428', soft = '#5B636A', sea = '#2C6E9B', bedColour = '#8A6D3B', ghost = '#9AA3AB';
  var waiting = false;

  function bytes(text) {
    return Uint8Array.from(atob(text.replace(/\s/g, '')), function (c) { return c.charCodeAt(0); });
  }
  function floats(text) { return new Float32Array(bytes(text).buffer); }

  // Takes a part of a message over what the drawing already holds.
  function take(drawing, part) {
    drawing = drawing || {};
    if (part.fixed) {
      drawing.ends = {
        netting: new Int32Array(bytes(part.fixed.netting).buffer),
        ropes: new Int32Array(bytes(part.fixed.ropes).buffer)
      };
      drawing.mark = part.fixed.marks;
    }
    drawing.points = floats(part.moved.points);
    drawing.colour = { netting: bytes(part.moved.netting), ropes: bytes(part.moved.ropes) };
    drawing.at = floats(part.moved.marks);
    drawing.boards = floats(part.moved.boards);
    drawing.range = {
      whole: rangeOf(drawing, ['ropes', 'netting']), net: rangeOf(drawing, ['netting'])
    };
    return drawing;
  }

  function rangeOf(drawing, kinds) {
    var low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    kinds.forEach(function (kind) {
      var ends = drawing.ends[kind];
      for (var i = 0; i < ends.length; i++) {
        for (var axis = 0; axis < 3; axis++) {
          var value = drawing.points[3 * ends[i] + axis];
          if (value < low[axis]) low[axis] = value;
          if (value > high[axis]) high[axis] = value;
        }
      }
    });
    return low[0] <= high[0] ? { low: low, high: high } : null;
  }

  function join(one, other) {
    if (!one || !other) return one || other;
    return {
      low: one.low.map(function (v, k) { return Math.min(v, other.low[k]); }),
      high: one.high.map(function (v, k) { return Math.max(v, other.high[k]); })
    };
  }

  function longest(range) {
    return Math.max(range.high[0] - range.low[0], range.high[1] - range.low[1],
      range.high[2] - range.low[2], 1e-6);
  }

  // What the views look at. It follows the gear only when it leaves, so that a gear that grows is
  // seen to grow.
  var held = {};
  function focus() {
    var key = choice.focus;
    function of(drawing) { return drawing.range[key] || drawing.range.whole; }
    var now = of(shown.now), pinned = of(shown.pinned);
    var all = choice.compare === 'off' ? now : join(now, pinned);
    var kept = held[key];
    if (kept) {
      var size = longest(kept), slack = 0.06 * size, fits = longest(all) > 0.6 * size;
      for (var axis = 0; axis < 3; axis++) {
        fits = fits && all.low[axis] > kept.low[axis] - slack &&
          all.high[axis] < kept.high[axis] + slack;
      }
      if (fits) return kept;
    }
    held[key] = { low: all.low.slice(), high: all.high.slice() };
    return held[key];
  }

  // ---- projection -------------------------------------------------------------------------------

  // A function(x, y, z, out, k) that puts screen x, y and depth at out[k...], with `scale` (pixels
  // per metre at the middle). box: left, top, width, height in pixels.
  function projection(range, turn, rise, zoom, pan, box, perspective) {
    var eye = [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)];
    var right = [-Math.sin(turn), Math.cos(turn), 0];
    var up = [
      eye[1] * right[2] - eye[2] * right[1], eye[2] * right[0] - eye[0] * right[2],
      eye[0] * right[1] - eye[1] * right[0]
    ];
    var middle = range.low.map(function (v, k) { return (v + range.high[k]) / 2; });
    var half = range.low.map(function (v, k) { return (range.high[k] - v) / 2; });
    function reach(axis) {
      return half.reduce(function (sum, h, k) { return sum + Math.abs(axis[k]) * h; }, 0) || 1e-6;
    }
    // Perspective makes what is near larger, and axes need room for their words.
    var room = perspective ? 0.8 : 0.93;
    var fit = room * Math.min(box.width / 2 / reach(right), box.height / 2 / reach(up));
    var scale = fit * zoom;
    var away = 4 * Math.hypot(half[0], half[1], half[2]) / zoom + 1e-6;
    var cx = box.left + box.width / 2 + pan[0], cy = box.top + box.height / 2 + pan[1];
    function put(x, y, z, out, k) {
      var dx = x - middle[0], dy = y - middle[1], dz = z - middle[2];
      var near = eye[0] * dx + eye[1] * dy + eye[2] * dz;
      var s = perspective ? scale * away / Math.max(away - near, 0.02 * away) : scale;
      out[k] = cx + s * (right[0] * dx + right[1] * dy + right[2] * dz);
      out[k + 1] = cy - s * (up[0] * dx + up[1] * dy + up[2] * dz);
      out[k + 2] = near;
      out[k + 3] = s;
    }
    put.scale = scale;
    put.eye = eye;
    return put;
  }

  function place(put, at) {
    var out = [0, 0, 0, 0];
    put(at[0], at[1], at[2], out, 0);
    return out;
  }

  // ---- painting ---------------------------------------------------------------------------------

  function paintGear(context, drawing, put, plain) {
    var count = drawing.points.length / 3;
    var screen = new Float32Array(4 * count);
    for (var i = 0; i < count; i++) {
      var p = 3 * i;
      put(drawing.points[p], drawing.points[p + 1], drawing.points[p + 2], screen, 4 * i);
    }
    var nets = drawing.ends.netting.length / 2, ropes = drawing.ends.ropes.length / 2;
    var marks = plain ? 0 : drawing.at.length / 3;
    var total = nets + ropes + marks;
    var depth = new Float32Array(total), order = new Uint32Array(total);
    var spots = new Float32Array(4 * marks);
    for (i = 0; i < marks; i++) {
      put(drawing.at[3 * i], drawing.at[3 * i + 1], drawing.at[3 * i + 2], spots, 4 * i);
    }
    for (i = 0; i < total; i++) {
      order[i] = i;
      if (i < nets + ropes) {
        var ends = i < nets ? drawing.ends.netting : drawing.ends.ropes;
        var k = i < nets ? i : i - nets;
        depth[i] = screen[4 * ends[2 * k] + 2] + screen[4 * ends[2 * k + 1] + 2];
      } else {
        depth[i] = 2 * spots[4 * (i - nets - ropes) + 2];
      }
    }
    order.sort(function (a, b) { return depth[a] - depth[b]; });
    context.lineCap = 'round';
    for (var n = 0; n < total; n++) {
      i = order[n];
      if (i >= nets + ropes) {
        paintMark(context, drawing, i - nets - ropes, spots, put);
        continue;
      }
      var rope = i >= nets, line = rope ? i - nets : i;
      var kind = rope ? 'ropes' : 'netting';
      var a = 4 * drawing.ends[kind][2 * line], b = 4 * drawing.ends[kind][2 * line + 1];
      context.strokeStyle = plain ? ghost : palettes[kind][drawing.colour[kind][line]];
      context.lineWidth = rope ? (plain ? 1.6 : 2.6) : (plain ? 0.6 : 0.9);
      context.beginPath();
      context.moveTo(screen[a], screen[a + 1]);
      context.lineTo(screen[b], screen[b + 1]);
      context.stroke();
    }
  }

  // The corners of a plate: of a free board as they are, else as in the page of view(), with at
  // least so many pixels to each side of its middle.
  function corners(drawing, i, s) {
    var mark = drawing.mark, least = (mark.role[i] === 'canvas' ? 3 : 6) / s;
    var middle = [0, 1, 2].map(function (axis) { return drawing.at[3 * i + axis]; });
    if (mark.board[i] >= 0) {
      var all = [0, 1, 2, 3].map(function (k) {
        var from = 3 * (4 * mark.board[i] + k);
        return middle.map(function (v, axis) { return drawing.boards[from + axis] - v; });
      });
      var grow = Math.max(1, 2 * least / mark.size[i]);
      return all.map(function (c) {
        return c.map(function (v, axis) { return middle[axis] + grow * v; });
      });
    }
    var half = Math.max(mark.size[i] / 2, least);
    var c = Math.cos(Math.PI / 6), h = Math.SQRT1_2;
    var way = mark.direction[i] || 'up';
    var first = way === 'port' ? [c, 0.5, 0] : way === 'starboard' ? [c, -0.5, 0] : [0, 1, 0];
    var second = way === 'up' ? [-h, 0, h] : way === 'down' ? [h, 0, h] : [0, 0, 1];
    return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(function (sign) {
      return middle.map(function (v, axis) {
        return v + half * (sign[0] * first[axis] + sign[1] * second[axis]);
      });
    });
  }

  function paintMark(context, drawing, i, spots, put) {
    var mark = drawing.mark, x = spots[4 * i], y = spots[4 * i + 1], s = spots[4 * i + 3];
    context.fillStyle = mark.fill[i];
    context.strokeStyle = ink;
    context.lineWidth = 1;
    context.beginPath();
    if (mark.plate[i]) {
      corners(drawing, i, s).forEach(function (corner, k) {
        var at = place(put, corner);
        if (k) context.lineTo(at[0], at[1]); else context.moveTo(at[0], at[1]);
      });
      context.closePath();
    } else {
      var radius = s * mark.size[i] / Math.sqrt(Math.PI);
      context.arc(x, y, Math.max(3.2 * mark.symbol[i], radius), 0, 7);
    }
    context.fill();
    context.stroke();
  }

  // box: where given, words stay inside it.
  function text(context, words, x, y, align, colour, bold, box) {
    context.font = (bold ? '600 ' : '') + '12px system-ui, sans-serif';
    context.textAlign = align;
    if (box) {
      var half = context.measureText(words).width / 2 + 4;
      x = Math.min(Math.max(x, box.left + half), box.left + box.width - half);
      y = Math.min(Math.max(y, box.top + 10), box.top + box.height - 10);
    }
    context.textBaseline = 'middle';
    context.fillStyle = colour;
    context.fillText(words, x, y);
  }

  // Round numbers between two, about `wanted` of them.
  function ticks(low, high, wanted) {
    var rough = (high - low) / Math.max(wanted, 1);
    var power = Math.pow(10, Math.floor(Math.log10(rough)));
    var step = [1, 2, 5, 10].map(function (m) { return m * power; })
      .filter(function (s) { return s >= rough * 0.999; })[0];
    var out = [];
    for (var t = Math.ceil(low / step); t * step <= high * (1 + 1e-9); t++) {
      out.push(Number((t * step).toPrecision(12)));
    }
    return out;
  }

  // Height of the sea bed.
  function bedAt(x, y) {
    var n = about.bed.normal;
    return (about.bed.height - n[0] * x - n[1] * y) / n[2];
  }

  // A sheet over the ranges, with its height by place: the water's surface or the sea bed.
  function paintSheet(context, put, range, height, colour, fill, words) {
    var seen = [[0, 0], [1, 0], [1, 1], [0, 1]].map(function (c) {
      var x = c[0] ? range.high[0] : range.low[0], y = c[1] ? range.high[1] : range.low[1];
      return place(put, [x, y, height(x, y)]);
    });
    context.beginPath();
    seen.forEach(function (c, k) {
      if (k) context.lineTo(c[0], c[1]); else context.moveTo(c[0], c[1]);
    });
    context.closePath();
    context.fillStyle = fill;
    context.fill();
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.stroke();
    text(context, words, seen[0][0] + 6, seen[0][1] - 9, 'left', colour);
  }

  // Sheets on the far side of the gear (far: whether those) as the eye is above or below them.
  function paintSheets(context, put, range, far) {
    var above = camera.rise > 0.02, below = camera.rise < -0.02;
    if (about.water && (far ? below : above)) {
      paintSheet(context, put, range, function () { return 0; }, sea, 'rgba(74, 144, 194, 0.12)',
        'water surface');
    }
    if (about.bed && (far ? above : below)) {
      paintSheet(context, put, range, bedAt, bedColour, 'rgba(178, 143, 92, 0.22)', 'sea bed');
    }
  }

  // Edges of the box around the range that carry axes, with their ticks and words a fixed number of
  // pixels away from them.
  function paintAxes(context, put, range, box) {
    var low = range.low, high = range.high;
    var edges = [
      { axis: 0, from: [low[0], low[1], low[2]], out: [0, -1, 0], name: 'x aft (m)' },
      { axis: 1, from: [low[0], low[1], low[2]], out: [-1, 0, 0], name: 'y starboard (m)' },
      { axis: 2, from: [high[0], low[1], low[2]], out: [0.7, -0.7, 0], name: 'depth (m)' }
    ];
    edges.forEach(function (edge) {
      var to = edge.from.slice();
      to[edge.axis] = high[edge.axis];
      var a = place(put, edge.from), b = place(put, to);
      var seen = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (seen < 24) return;
      // The way off the edge on the screen: across it, on the side where `out` points.
      var c = place(put, edge.from.map(function (v, k) {
        return v + 0.01 * longest(range) * edge.out[k];
      }));
      var off = [-(b[1] - a[1]) / seen, (b[0] - a[0]) / seen];
      if (off[0] * (c[0] - a[0]) + off[1] * (c[1] - a[1]) < 0) off = [-off[0], -off[1]];
      context.strokeStyle = '#8A949C';
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(a[0], a[1]);
      context.lineTo(b[0], b[1]);
      var marks = ticks(low[edge.axis], high[edge.axis], Math.min(8, seen / 60)).map(function (t) {
        var at = edge.from.slice();
        at[edge.axis] = t;
        return [t, place(put, at)];
      });
      marks.forEach(function (mark) {
        context.moveTo(mark[1][0], mark[1][1]);
        context.lineTo(mark[1][0] + 5 * off[0], mark[1][1] + 5 * off[1]);
      });
      context.stroke();
      marks.forEach(function (mark) {
        var words = String(edge.axis === 2 ? (-mark[0] || 0) : mark[0]);
        text(context, words, mark[1][0] + 18 * off[0], mark[1][1] + 14 * off[1], 'center', soft);
      });
      text(context, edge.name, (a[0] + b[0]) / 2 + 56 * off[0], (a[1] + b[1]) / 2 + 34 * off[1],
        'center', ink, false, box);
    });
  }

  // The flow as an arrow in a corner, in the view's own directions.
  function paintFlow(context, put, box) {
    var speed = Math.hypot(about.flow[0], about.flow[1]);
    if (!speed) return;
    var zero = place(put, [0, 0, 0]);
    var one = place(put, [about.flow[0] / speed, about.flow[1] / speed, 0]);
    var dx = one[0] - zero[0], dy = one[1] - zero[1], seen = Math.hypot(dx, dy) / put.scale;
    var cx = box.left + 30, cy = box.top + box.height - 22;
    text(context, 'flow ' + speed.toFixed(2) + ' m/s', cx + 28, cy, 'left', sea);
    var size = Math.hypot(dx, dy) || 1;
    context.strokeStyle = context.fillStyle = sea;
    context.lineWidth = 2;
    context.beginPath();
    if (seen < 0.15) {
      context.arc(cx, cy, 6, 0, 7);
      context.stroke();
      context.beginPath();
      context.arc(cx, cy, 1.5, 0, 7);
      context.fill();
      return;
    }
    dx *= 20 / size; dy *= 20 / size;
    context.moveTo(cx - dx, cy - dy);
    context.lineTo(cx + dx, cy + dy);
    context.moveTo(cx + 0.4 * dx - 0.35 * dy, cy + 0.4 * dy + 0.35 * dx);
    context.lineTo(cx + dx, cy + dy);
    context.lineTo(cx + 0.4 * dx + 0.35 * dy, cy + 0.4 * dy - 0.35 * dx);
    context.stroke();
  }

  function open(canvas) {
    var ratio = window.devicePixelRatio || 1;
    var width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return null;
    var across = Math.round(width * ratio), up = Math.round(height * ratio);
    if (canvas.width !== across) canvas.width = across;
    if (canvas.height !== up) canvas.height = up;
    var context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    return { context: context, width: width, height: height };
  }

  function paintTank() {
    var page = open(document.getElementById('tank'));
    if (!page) return;
    var range = focus(), wide = page.width > page.height, half;
    var boxes = [{ left: 0, top: 0, width: page.width, height: page.height, drawing: 'now' }];
    if (choice.compare === 'beside') {
      half = wide ? { width: page.width / 2, height: page.height }
        : { width: page.width, height: page.height / 2 };
      boxes = [
        { left: 0, top: 0, width: half.width, height: half.height, drawing: 'pinned' },
        { left: wide ? half.width : 0, top: wide ? 0 : half.height, width: half.width,
          height: half.height, drawing: 'now' }
      ];
    }
    boxes.forEach(function (box) {
      var context = page.context;
      context.save();
      context.beginPath();
      context.rect(box.left, box.top, box.width, box.height);
      context.clip();
      var put = projection(range, camera.turn, camera.rise, camera.zoom, camera.pan, box, true);
      var all = join(range, shown.now.range.whole);
      paintSheets(context, put, all, true);
      paintAxes(context, put, range, box);
      if (choice.compare === 'over' && shown.pinned) paintGear(context, shown.pinned, put, true);
      paintGear(context, shown[box.drawing], put, false);
      paintSheets(context, put, all, false);
      paintFlow(context, put, box);
      if (choice.compare === 'beside') {
        text(context, box.drawing === 'now' ? 'Now' : 'Pinned', box.left + box.width / 2,
          box.top + 16, 'center', ink, true);
      }
      context.restore();
      if (box.left || box.top) {
        context.strokeStyle = '#C5CCD3';
        context.lineWidth = 1;
        context.strokeRect(box.left, box.top, 0, 0);
        context.beginPath();
        context.moveTo(box.left, box.top);
        context.lineTo(wide ? box.left : page.width, wide ? page.height : box.top);
        context.stroke();
      }
    });
  }

  var planes = {
    xy: {
      turn: -Math.PI / 2, rise: Math.PI / 2, axes: [0, 1], names: ['x aft (m)', 'y starboard (m)']
    },
    xz: { turn: -Math.PI / 2, rise: 0, axes: [0, 2], names: ['x aft (m)', 'depth (m)'] },
    yz: { turn: 0, rise: 0, axes: [1, 2], names: ['y starboard (m)', 'depth (m)'] }
  };

  function paintPlane(name) {
    var page = open(document.getElementById('plane_' + name));
    if (!page) return;
    var plane = planes[name], range = focus(), context = page.context;
    var box = { left: 54, top: 8, width: page.width - 66, height: page.height - 48 };
    var put = projection(range, plane.turn, plane.rise, 1, [0, 0], box, false);
    var scale = put.scale;
    var middle = range.low.map(function (v, k) { return (v + range.high[k]) / 2; });
    var across = plane.axes[0], up = plane.axes[1];
    function end(axis, sign, size) { return middle[axis] + sign * size / 2 / scale; }
    context.fillStyle = '#F6F9FB';
    context.fillRect(box.left, box.top, box.width, box.height);
    context.save();
    context.beginPath();
    context.rect(box.left, box.top, box.width, box.height);
    context.clip();
    if (up === 2 && about.water) {
      var level = place(put, [middle[0], middle[1], 0])[1];
      if (level > box.top) {
        context.fillStyle = '#ffffff';
        context.fillRect(box.left, box.top, box.width, level - box.top);
      }
      context.strokeStyle = sea;
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(box.left, level);
      context.lineTo(box.left + box.width, level);
      context.stroke();
    }
    if (up === 2 && about.bed) {
      context.fillStyle = '#E6DAC6';
      context.beginPath();
      [[-1, 'bed'], [1, 'bed'], [1, 'floor'], [-1, 'floor']].forEach(function (corner, k) {
        var at = middle.slice();
        at[across] = end(across, corner[0], box.width);
        at[2] = corner[1] === 'bed' ? bedAt(at[0], at[1]) : end(2, -1, box.height);
        var on = place(put, at);
        if (k) context.lineTo(on[0], on[1]); else context.moveTo(on[0], on[1]);
      });
      context.fill();
    }
    if (choice.compare !== 'off' && shown.pinned) paintGear(context, shown.pinned, put, true);
    paintGear(context, shown.now, put, false);
    context.restore();
    context.strokeStyle = '#8A949C';
    context.lineWidth = 1;
    context.strokeRect(box.left, box.top, box.width, box.height);
    var left = end(across, -1, box.width), right = end(across, 1, box.width);
    ticks(left, right, box.width / 70).forEach(function (t) {
      var x = box.left + box.width / 2 + scale * (t - middle[across]);
      text(context, String(t), x, box.top + box.height + 12, 'center', soft);
      context.fillRect(x, box.top + box.height, 1, 4);
    });
    var foot = end(up, -1, box.height), head = end(up, 1, box.height);
    ticks(foot, head, box.height / 40).forEach(function (t) {
      var y = box.top + box.height / 2 - scale * (t - middle[up]);
      text(context, String(up === 2 ? (-t || 0) : t), box.left - 6, y, 'right', soft);
      context.fillRect(box.left - 4, y, 4, 1);
    });
    text(context, plane.names[0], box.left + box.width / 2, page.height - 8, 'center', ink);
    context.save();
    context.translate(10, box.top + box.height / 2);
    context.rotate(-Math.PI / 2);
    text(context, plane.names[1], 0, 0, 'center', ink);
    context.restore();
  }

  function paint() {
    waiting = false;
    if (!shown.now) return;
    paintTank();
    // A frame later: the eye is on the tank.
    window.requestAnimationFrame(function () { Object.keys(planes).forEach(paintPlane); });
  }

  function repaint() {
    if (waiting) return;
    waiting = true;
    window.requestAnimationFrame(paint);
  }

  // ---- legend -----------------------------------------------------------------------------------

  function element(name, className, words) {
    var made = document.createElement(name);
    if (className) made.className = className;
    if (words !== undefined) made.textContent = words;
    return made;
  }

  function colourBar(kind, scale) {
    var bar = element('div', 'colour-bar');
    bar.appendChild(element('div', 'heading', scale.heading));
    var strip = element('div', 'strip');
    strip.style.background = 'linear-gradient(to right, ' + palettes[kind].slice(1)
      .filter(function (c, k) { return k % 12 === 0; }).join(', ') + ')';
    bar.appendChild(strip);
    var row = element('div', 'ticks');
    // Pixels that the words so far reach to, on a bar of 210.
    var reach = -Infinity;
    scale.ticks.forEach(function (words, k) {
      var half = 3.6 * words.length;
      if (210 * scale.at[k] - half < reach + 5) return;
      reach = 210 * scale.at[k] + half;
      var tick = element('span', '', words);
      tick.style.left = 100 * scale.at[k] + '%';
      row.appendChild(tick);
    });
    bar.appendChild(row);
    return bar;
  }

  function paintLegend(legend) {
    var box = document.getElementById('tank_legend');
    box.textContent = '';
    ['ropes', 'netting'].forEach(function (kind) {
      if (legend[kind]) box.appendChild(colourBar(kind, legend[kind]));
    });
    var key = element('div', 'key');
    function entry(words, colour, className) {
      var item = element('span', 'entry', words), patch = element('i', className);
      patch.style.background = colour;
      item.insertBefore(patch, item.firstChild);
      key.appendChild(item);
    }
    entry('slack', palettes.ropes[0], 'line');
    if (choice.compare === 'over') entry('pinned', ghost, 'line');
    var mark = shown.now.mark;
    mark.label.forEach(function (words, k) {
      if (mark.label.indexOf(words) === k) {
        entry(words, mark.fill[k], mark.plate[k] ? 'plate' : 'ball');
      }
    });
    box.appendChild(key);
  }

  // ---- hands ------------------------------------------------------------------------------------

  function turnBy(across, up) {
    camera.turn -= across;
    camera.rise = Math.min(Math.max(camera.rise + up, -Math.PI / 2), Math.PI / 2);
    press('from', null);
    repaint();
  }

  function zoomBy(factor) {
    camera.zoom = Math.min(Math.max(camera.zoom * factor, 0.2), 60);
    repaint();
  }

  function press(group, value) {
    document.querySelectorAll('[data-group="' + group + '"]').forEach(function (button) {
      button.setAttribute('aria-pressed', String(button.dataset.value === value));
    });
  }

  var legend = null;
  function choose(group, value) {
    choice[group] = value;
    if (group === 'from') { camera.turn = views[value][0]; camera.rise = views[value][1]; }
    if (group !== 'compare') { camera.zoom = 1; camera.pan = [0, 0]; }
    held = {};
    press(group, value);
    if (legend) paintLegend(legend);
    repaint();
  }

  function listen() {
    var canvas = document.getElementById('tank'), fingers = {}, apart = 0;
    canvas.addEventListener('pointerdown', function (event) {
      canvas.setPointerCapture(event.pointerId);
      fingers[event.pointerId] = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointermove', function (event) {
      var before = fingers[event.pointerId];
      if (!before) return;
      var dx = event.clientX - before[0], dy = event.clientY - before[1];
      fingers[event.pointerId] = [event.clientX, event.clientY];
      var all = Object.keys(fingers);
      if (all.length === 1) {
        if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
          camera.pan = [camera.pan[0] + dx, camera.pan[1] + dy];
          repaint();
        } else {
          turnBy(dx * 0.008, dy * 0.008);
        }
        return;
      }
      var a = fingers[all[0]], b = fingers[all[1]], gap = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (apart) zoomBy(gap / apart);
      apart = gap;
    });
    function lift(event) { delete fingers[event.pointerId]; apart = 0; }
    canvas.addEventListener('pointerup', lift);
    canvas.addEventListener('pointercancel', lift);
    canvas.addEventListener('contextmenu', function (event) { event.preventDefault(); });
    canvas.addEventListener('wheel', function (event) {
      event.preventDefault();
      zoomBy(Math.exp(-event.deltaY * 0.0015));
    }, { passive: false });
    canvas.addEventListener('keydown', function (event) {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      var act = {
        ArrowLeft: [turnBy, -0.1, 0], ArrowRight: [turnBy, 0.1, 0], ArrowUp: [turnBy, 0, 0.1],
        ArrowDown: [turnBy, 0, -0.1], '+': [zoomBy, 1.2], '=': [zoomBy, 1.2], '-': [zoomBy, 1 / 1.2]
      }[event.key];
      if (!act) return;
      event.preventDefault();
      act[0](act[1], act[2]);
    });
    document.addEventListener('click', function (event) {
      var button = event.target.closest && event.target.closest('[data-group]');
      if (button) choose(button.dataset.group, button.dataset.value);
    });
    // Canvases in a tab have no size until it is opened.
    var watch = new ResizeObserver(repaint);
    document.querySelectorAll('canvas').forEach(function (each) { watch.observe(each); });
  }

  return {
    listen: listen,
    choose: choose,
    palettes: function (colours) { palettes = colours; },
    picture: function (message) {
      shown.now = take(shown.now, message.now);
      shown.pinned = take(shown.pinned, message.pinned);
      about = { flow: message.flow, water: message.water, bed: message.bed };
      legend = message.legend;
      document.getElementById('tank').setAttribute('aria-label', message.name +
        ' in three dimensions. ' + message.conditions);
      // Without netting there is nothing but the whole gear.
      var net = document.querySelector('[data-group="focus"][data-value="net"]');
      net.disabled = !shown.now.range.net;
      if (!shown.now.range.net && choice.focus === 'net') choose('focus', 'whole');
      paintLegend(legend);
      repaint();
    },
    // What tests and measurements read: a position, and whether a picture is still to be painted.
    point: function (k) { return Array.from(shown.now.points.slice(3 * k, 3 * k + 3)); },
    waits: function () { return waiting; }
  };
}());
