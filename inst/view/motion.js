// Plays a trajectory: moves the lines and marks of the scene between kept times, by a slider, a
// button and the keyboard (space plays and stops, arrows step, Home and End go to the ends).
// data: time (s) and label per kept time; points (3 x points x times), lines (each with its rgl
// object, the points at its ends, palette and colour numbers), marks (3 x marks x times), plates
// (each with its rgl object, the mark it shows and, of a free board, its corners (3 x 4 x times)) and
// balls (their rgl object and marks).
function (el, x, data) {
  var scene = el.rglinstance;
  var times = data.time;
  var last = times.length - 1;
  var longest = 20;  // seconds in which a whole tow plays, unless it is shorter

  function bytes(text) {
    return Uint8Array.from(atob(text.replace(/\s/g, '')), function (c) { return c.charCodeAt(0); });
  }
  var points = new Float32Array(bytes(data.points).buffer);
  var marks = new Float32Array(bytes(data.marks).buffer);
  var pointCount = points.length / times.length;
  var markCount = marks.length / times.length;
  var lines = data.lines.map(function (line) {
    return {
      id: line.id, ends: new Int32Array(bytes(line.ends).buffer), colour: bytes(line.colour),
      palette: line.palette
    };
  });

  var plates = [].concat(data.plates || []).map(function (plate) {
    return {
      id: plate.id, mark: plate.mark,
      corners: plate.corners && new Float32Array(bytes(plate.corners).buffer)
    };
  });

  // Numbers of one moment: share of the way from kept time k to the next.
  function between(all, count, k, share, i) {
    var here = all[k * count + i];
    return share > 0 ? here + share * (all[(k + 1) * count + i] - here) : here;
  }

  function ready(id) {
    var object = scene.getObj(id);
    if (!object.initialized) scene.initObj(object);
    return object;
  }

  // rgl draws a thick line as copies of its ends, each of which also knows the other end.
  function moveLines(line, k, share) {
    var object = ready(line.id);
    if (object.vOffsets.cofs < 0) {
      object.colors = [object.colors[0], object.colors[0]];
      scene.initObj(object);
    }
    var at = object.vOffsets;
    var count = line.ends.length / 2;
    var end = [0, 0, 0];
    var other = [0, 0, 0];
    for (var i = 0; i < line.ends.length; i++) {
      for (var axis = 0; axis < 3; axis++) {
        end[axis] = between(points, pointCount, k, share, 3 * line.ends[i] + axis);
        other[axis] = between(points, pointCount, k, share, 3 * line.ends[i ^ 1] + axis);
      }
      var number = line.colour[(share < 0.5 ? k : k + 1) * count + (i >> 1)];
      var copies = object.alias && object.alias[i] || [];
      for (var c = -1; c < copies.length; c++) {
        var start = (c < 0 ? i : copies[c]) * at.stride;
        for (axis = 0; axis < 3; axis++) {
          object.values[start + axis] = end[axis];
          if (at.nextofs >= 0) object.values[start + at.nextofs + axis] = other[axis];
          object.values[start + at.cofs + axis] = line.palette[axis][number];
        }
      }
    }
    upload(object);
  }

  function upload(object) {
    var gl = scene.gl || scene.initGL();
    gl.bindBuffer(gl.ARRAY_BUFFER, object.buf);
    gl.bufferData(gl.ARRAY_BUFFER, object.values, gl.DYNAMIC_DRAW);
  }

  function markAt(mark, k, share) {
    return [0, 1, 2].map(function (axis) {
      return between(marks, markCount, k, share, 3 * (mark - 1) + axis);
    });
  }

  function movePlate(plate, k, share) {
    var object = ready(plate.id);
    var to = markAt(plate.mark, k, share);
    var from = markAt(plate.mark, 0, 0);
    for (var i = 0; i < object.vertices.length; i++) {
      for (var axis = 0; axis < 3; axis++) {
        object.values[i * object.vOffsets.stride + axis] = plate.corners
          ? between(plate.corners, 12, k, share, 3 * i + axis)
          : object.vertices[i][axis] + to[axis] - from[axis];
      }
    }
    upload(object);
  }

  function moveBalls(balls, k, share) {
    var object = ready(balls.id);
    [].concat(balls.mark).forEach(function (mark, i) {
      var to = markAt(mark, k, share);
      for (var axis = 0; axis < 3; axis++) {
        object.values[i * object.vOffsets.stride + axis] = to[axis];
      }
    });
  }

  var bar = document.createElement('div');
  bar.style.cssText = 'position: absolute; left: 14px; right: 14px; bottom: 12px; display: flex; ' +
    'gap: 12px; align-items: center; font: 13px system-ui, sans-serif; color: #202428';
  var button = document.createElement('button');
  button.style.cssText = 'width: 70px; padding: 4px 0; border: 1px solid #8a949c; ' +
    'border-radius: 4px; background: #ffffff; color: #202428; cursor: pointer';
  var slider = document.createElement('input');
  slider.type = 'range';
  slider.min = times[0];
  slider.max = times[last];
  slider.step = 'any';
  slider.value = times[0];
  slider.style.cssText = 'flex: 1; cursor: pointer';
  slider.setAttribute('aria-label', 'Time');
  var label = document.createElement('div');
  label.style.cssText = 'min-width: 210px; font-variant-numeric: tabular-nums';
  [button, slider, label].forEach(function (part) { bar.appendChild(part); });
  el.appendChild(bar);

  var now = times[0];
  var playing = null;

  function frameOf(time) {
    var k = 0;
    while (k < last - 1 && times[k + 1] <= time) k++;
    return k;
  }

  function show(time) {
    now = Math.min(Math.max(time, times[0]), times[last]);
    var k = frameOf(now);
    var share = last > 0 ? (now - times[k]) / (times[k + 1] - times[k]) : 0;
    lines.forEach(function (line) { moveLines(line, k, share); });
    plates.forEach(function (plate) { movePlate(plate, k, share); });
    if (data.balls) moveBalls(data.balls, k, share);
    var text = data.label[share < 0.5 ? k : k + 1];
    label.textContent = text;
    slider.value = now;
    slider.setAttribute('aria-valuetext', text);
    scene.drawScene();
  }

  function stop() {
    if (playing) window.cancelAnimationFrame(playing.request);
    playing = null;
    button.textContent = 'Play';
  }

  function play() {
    if (now >= times[last]) now = times[0];
    var rate = Math.max(1, (times[last] - times[0]) / longest);
    playing = { clock: null };
    button.textContent = 'Pause';
    function tick(clock) {
      if (!playing) return;
      var passed = playing.clock === null ? 0 : (clock - playing.clock) / 1000;
      playing.clock = clock;
      show(now + rate * passed);
      if (now >= times[last]) return stop();
      playing.request = window.requestAnimationFrame(tick);
    }
    playing.request = window.requestAnimationFrame(tick);
  }

  function toggle() {
    if (playing) stop(); else play();
  }

  // To the kept time before or after.
  function step(by) {
    stop();
    var k = frameOf(now);
    if (last > 0 && now >= times[last]) k = last;
    if (by < 0 && now > times[k]) k++;
    show(times[Math.min(Math.max(k + by, 0), last)]);
  }

  button.onclick = toggle;
  slider.oninput = function () { stop(); show(Number(slider.value)); };
  // Keys count while the page's focus is here, so that a document around it keeps its own.
  el.tabIndex = 0;
  el.style.outline = 'none';
  el.addEventListener('keydown', function (event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    var act = {
      ' ': toggle, ArrowLeft: function () { step(-1); }, ArrowRight: function () { step(1); },
      Home: function () { stop(); show(times[0]); }, End: function () { stop(); show(times[last]); }
    }[event.key];
    // A focused button takes its own space bar.
    if (!act || event.key === ' ' && event.target.tagName === 'BUTTON') return;
    event.preventDefault();
    act();
  });

  stop();
  show(now);
  el.focus({ preventScroll: true });
}
