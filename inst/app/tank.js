// The gear in the flume tank: the viewer and three projections with axes. The axes are x aft, y to
// starboard, z up (m).
//
// `codendTank`:
//   `listen()` creates the viewer.
//   `picture(message)` shows the scenes of R/flume-picture.R.
//   `moved(part)` shows an intermediate shape.
window.codendTank = (function () {
  'use strict';

  var say = window.codendSay, viewer = null, about = null, timer = null;
  var ink = '#202428', soft = '#4D555C', sea = '#2C6E9B';
  var planes = {
    xy: {
      turn: -Math.PI / 2, rise: Math.PI / 2, axes: [0, 1], names: ['x_aft', 'y_starboard']
    },
    xz: { turn: -Math.PI / 2, rise: 0, axes: [0, 2], names: ['x_aft', 'depth_axis'] },
    yz: { turn: 0, rise: 0, axes: [1, 2], names: ['y_starboard', 'depth_axis'] }
  };

  function text(context, words, x, y, align, colour) {
    context.font = '12px system-ui, sans-serif';
    context.textAlign = align;
    context.textBaseline = 'middle';
    context.fillStyle = colour;
    context.fillText(words, x, y);
  }

  function open(canvas) {
    var ratio = window.devicePixelRatio || 1;
    var width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return null;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    var context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    return { context: context, width: width, height: height };
  }

  // Returns the height of the seabed (m).
  function bed_at(x, y) {
    var n = about.bed.normal;
    return (about.bed.height - n[0] * x - n[1] * y) / n[2];
  }

  // Returns false if the canvas has no size.
  function paint_plane(name) {
    var page = open(document.getElementById('plane_' + name));
    if (!page) return false;
    var plane = planes[name], range = viewer.focus(), context = page.context;
    var across = plane.axes[0], up = plane.axes[1];
    var box = { left: 54, top: 8, width: page.width - 66, height: page.height - 48 };
    function size(axis) { return Math.max(range.high[axis] - range.low[axis], 1e-6); }
    var scale = 0.93 * Math.min(box.width / size(across), box.height / size(up));
    var middle = range.low.map(function (v, k) { return (v + range.high[k]) / 2; });
    function x_of(v) { return box.left + box.width / 2 + scale * (v - middle[across]); }
    function y_of(v) { return box.top + box.height / 2 - scale * (v - middle[up]); }
    var left = middle[across] - box.width / 2 / scale, right = middle[across] + box.width / 2 / scale;
    var foot = middle[up] - box.height / 2 / scale, top = middle[up] + box.height / 2 / scale;
    context.fillStyle = '#F3F8FB';
    context.fillRect(box.left, box.top, box.width, box.height);
    context.save();
    context.beginPath();
    context.rect(box.left, box.top, box.width, box.height);
    context.clip();
    if (up === 2 && about.water && top > 0) {
      context.fillStyle = '#ffffff';
      context.fillRect(box.left, box.top, box.width, y_of(0) - box.top);
      context.fillStyle = sea;
      context.fillRect(box.left, y_of(0), box.width, 1);
    }
    if (up === 2 && about.bed) {
      context.fillStyle = '#E3D9C3';
      context.beginPath();
      [left, right].forEach(function (v, k) {
        var at = middle.slice();
        at[across] = v;
        context[k ? 'lineTo' : 'moveTo'](x_of(v), y_of(bed_at(at[0], at[1])));
      });
      context.lineTo(box.left + box.width, box.top + box.height + 1);
      context.lineTo(box.left, box.top + box.height + 1);
      context.fill();
    }
    viewer.flat(context, plane, box, middle, scale);
    context.restore();
    context.strokeStyle = '#78838C';
    context.lineWidth = 1;
    context.strokeRect(box.left, box.top, box.width, box.height);
    window.codendView.ticks(left, right, box.width / 70).forEach(function (t) {
      text(context, String(t), x_of(t), box.top + box.height + 12, 'center', soft);
      context.fillRect(x_of(t), box.top + box.height, 1, 4);
    });
    window.codendView.ticks(foot, top, box.height / 40).forEach(function (t) {
      text(context, String(up === 2 ? (-t || 0) : t), box.left - 6, y_of(t), 'right', soft);
      context.fillRect(box.left - 4, y_of(t), 4, 1);
    });
    text(context, say(plane.names[0]), box.left + box.width / 2, page.height - 8, 'center', ink);
    context.save();
    context.translate(10, box.top + box.height / 2);
    context.rotate(-Math.PI / 2);
    text(context, say(plane.names[1]), 0, 0, 'center', ink);
    context.restore();
    return true;
  }

  // Waits until the gear stops moving, because the projections cost as much as the 3D view.
  function repaint_planes() {
    window.clearTimeout(timer);
    timer = window.setTimeout(function () {
      timer = null;
      if (!viewer || !about) return;
      if (viewer.hastens()) { repaint_planes(); return; }
      var painted = Object.keys(planes).map(paint_plane).some(Boolean);
      // The projections were drawn on the tank's own canvas.
      if (painted) viewer.redraw();
    }, 120);
  }

  // Requests from R the plan path of a clicked part.
  function listen_clicks(canvas) {
    var from = null;
    canvas.addEventListener('pointerdown', function (event) { from = [event.clientX, event.clientY]; });
    canvas.addEventListener('click', function (event) {
      if (!about || !from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4) return;
      var box = canvas.getBoundingClientRect(), gear = viewer.gear();
      var found = viewer.under(event.clientX - box.left, event.clientY - box.top);
      if (!found) return;
      window.codendTalk.tell('part_wanted', { number: Date.now(), name: found.kind === 'mark' ?
        about.marks.part[found.number] :
        about.parts.name[(found.kind === 'rope' ? gear.ropes : gear.netting).part[found.number]] });
    });
  }

  return {
    listen: function () {
      viewer = window.codendView.viewer(document.getElementById('tank'), {
        changed: repaint_planes, still: false,
        passing: function () { return !window.codendForm.still(); }
      });
      if (viewer) listen_clicks(document.querySelector('#tank canvas'));
      var watch = new ResizeObserver(repaint_planes);
      document.querySelectorAll('canvas.plane').forEach(function (each) { watch.observe(each); });
    },
    picture: function (message) {
      if (!viewer) return;
      viewer.show(Object.assign(message.now, message.of_all), message.kept.map(function (one) {
        return { key: one.id, name: one.name, scene: Object.assign({}, one.scene, message.of_all) };
      }));
      about = viewer.gear().told;
      repaint_planes();
    },
    moved: function (part) {
      if (!viewer) return;
      viewer.pass(part);
      about = viewer.gear().told;
      repaint_planes();
    },
    viewer: function () { return viewer; },
    // For tests and measurements: a node position, and whether a picture is pending.
    point: function (k) { return viewer.point(k); },
    waits: function () { return !viewer || viewer.waits() || timer !== null; }
  };
}());
