// The 3D viewer of codend's pages: one gear or several designs, settled or in motion. R/scene-gear.R
// makes scenes; gear.js and materials.js draw them. The axes are x aft, y to starboard, z up (m).
//
// `codendView.viewer(host, options)` fills the element `host`. It returns null without WebGL.
// Options:
//   `title` is true to show the gear's name over the picture.
//   `colour` is the initial quantity that colours show.
//   `wheel` is true if the mouse wheel always zooms.
//   `changed()` is called after a choice.
//   `passing()` returns true while another shape is expected.
//   `still` is false to omit the picture for printing.
//   `graph` and `moved(time)` are options of motion.js.
// Methods:
//   `show(now, kept)` shows a scene, or its changed parts, and stored designs [{key, name, scene}].
//   `pass(part)` shows an intermediate shape.
//   `choose(what, value)` sets focus (net, whole), from (bow, above, side, astern), colour, compare
//     (off, over, beside) or align (bosom, towing).
//   `seek(s)` moves to a time.
//   `look({turn})` turns the camera (radians).
//   `frame({turn, rise, near, focus})` shows the net from an angle, at `near` times the fitted
//     distance. focus: whole for the gear, boards for the net with its otter boards.
//   `picture(wide, worded)` and `film(kind, seconds, wide, worded)` are described in save.js.
//   `flat(...)` draws a projection on another canvas.
window.codendView = window.codendView || {};
window.codendView.viewer = function (host, options) {
  'use strict';
  var T = window.THREE, view = window.codendView, element = view.element, say = view.say;
  options = options || {};

  host.classList.add('codend-view');
  var canvas = element('canvas', 'view-canvas', undefined, { tabindex: '0', role: 'img' });
  host.appendChild(canvas);

  var renderer;
  try {
    renderer = new T.WebGLRenderer({ canvas: canvas, antialias: true, alpha: true });
  } catch (error) {
    host.appendChild(element('p', 'view-none',
      say('This browser does not support WebGL, which the 3D view needs.')));
    return null;
  }
  T.ColorManagement.enabled = false;
  renderer.outputColorSpace = T.LinearSRGBColorSpace;
  renderer.setClearColor(0, 0);
  renderer.autoClear = false;
  renderer.sortObjects = true;
  renderer.debug.checkShaderErrors = false;

  var materials = view.materials(), shared = materials.shared;
  var gears = { now: null }, kept = [], told = null;  // kept: [{key, name, gear}]
  var choice = {
    focus: 'net', from: 'bow', compare: 'off', align: 'bosom', colour: options.colour || 'tension'
  };
  // Camera directions: angle from x towards y, and elevation (radians).
  var directions = {
    bow: [-2.05, 0.3], above: [-Math.PI / 2, Math.PI / 2], side: [-Math.PI / 2, 0.06],
    astern: [0, 0.06]
  };
  var camera = {
    turn: directions.bow[0], rise: directions.bow[1], away: 1, at: [0, 0, 0],
    // position of the target in the picture, in half sizes from the centre
    across: 0, up: 0
  };
  var perspective = new T.PerspectiveCamera(28, 1, 0.1, 100);
  var flatCamera = new T.OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
  var modes = {
    tension: say('Tension'), slack: say('Slack'), mesh_opening: say('Mesh opening'),
    mesh_angle: say('Mesh angle'), drag: say('Drag')
  };

  // ---- focus ------------------------------------------------------------------------------------

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
  function middle(range) {
    return range.low.map(function (v, k) { return (v + range.high[k]) / 2; });
  }

  function compared() {
    if (choice.compare === 'off') return [gears.now];
    return kept.map(function (one) { return one.gear; }).concat(gears.now);
  }

  // Returns the displacement (m) that aligns a gear with the present one. It is horizontal above a
  // bed, because heights are comparable there.
  function shift_of(gear) {
    if (gear === gears.now) return [0, 0, 0];
    var at = gear.places_to_align()[choice.align], to = gears.now.places_to_align()[choice.align];
    return at && to ? [to[0] - at[0], to[1] - at[1], told.bed ? 0 : to[2] - at[2]] : [0, 0, 0];
  }

  // Returns the bounding box in focus. It changes only if the gear leaves it or becomes much
  // smaller, so that growth stays visible.
  var held = {};
  function focus() {
    var key = choice.focus;
    function of(gear) {
      var range = gear.range[key] || gear.range.whole, by = shift_of(gear);
      function moved(end) { return end.map(function (v, k) { return v + by[k]; }); }
      return { low: moved(range.low), high: moved(range.high) };
    }
    var all = compared().map(of).reduce(join);
    var before = held[key];
    if (before) {
      var size = longest(before), slack = 0.06 * size, fits = longest(all) > 0.6 * size;
      for (var axis = 0; axis < 3; axis++) {
        fits = fits && all.low[axis] > before.low[axis] - slack &&
          all.high[axis] < before.high[axis] + slack;
      }
      if (fits) return before;
    }
    held[key] = { low: all.low.slice(), high: all.high.slice() };
    return held[key];
  }

  function axes(turn, rise) {
    var eye = [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)];
    var right = [-Math.sin(turn), Math.cos(turn), 0];
    var up = [
      eye[1] * right[2] - eye[2] * right[1], eye[2] * right[0] - eye[0] * right[2],
      eye[0] * right[1] - eye[1] * right[0]
    ];
    return { eye: eye, right: right, up: up };
  }
  function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  // Returns the points in focus, with the radius of components. In motion, returns the box corners.
  function outline(range) {
    var corners = [], found = [];
    for (var k = 0; k < 8; k++) {
      corners.push([0, 1, 2].map(function (axis) {
        return k >> axis & 1 ? range.high[axis] : range.low[axis];
      }));
    }
    if (told.times.length > 1) return corners;
    compared().forEach(function (gear) {
      var by = shift_of(gear);
      [[gear.points], [gear.at, gear.told.marks.size]].forEach(function (all) {
        var p = all[0];
        for (var i = 0; i < p.length; i += 3) {
          var at = [p[i] + by[0], p[i + 1] + by[1], p[i + 2] + by[2]];
          if (at.every(function (v, axis) {
            return v >= range.low[axis] - 1e-6 && v <= range.high[axis] + 1e-6;
          })) found.push(at.concat(all[1] ? all[1][i / 3] / 2 : 0));
        }
      });
    });
    return found.length ? found : corners;
  }

  // Returns the margins (pixels) that labels and buttons take at the given sides. Each element
  // takes the side that costs least; at least half of the picture stays free.
  function taken_along(sides) {
    var width = host.clientWidth || 1, height = host.clientHeight || 1;
    var taken = { left: 0, right: 0, top: 0, bottom: 0 }, frame = host.getBoundingClientRect();
    [title, bar, legend, scaleBar].concat(Array.from(host.querySelectorAll('.view-time, .view-graph')))
      .forEach(function (part) {
        var box = part.getBoundingClientRect(), best = null;
        if (!box.width || !box.height) return;
        var strips = {
          left: box.right - frame.left, right: frame.right - box.left,
          top: box.bottom - frame.top, bottom: frame.bottom - box.top
        };
        sides.forEach(function (side) {
          var across = side === 'left' || side === 'right';
          var cost = Math.max(0, strips[side] - taken[side]) * (across ? height : width);
          if (!best || cost < best[0]) best = [cost, side];
        });
        taken[best[1]] = Math.max(taken[best[1]], strips[best[1]]);
      });
    [['left', 'right', width], ['top', 'bottom', height]].forEach(function (pair) {
      var much = (taken[pair[0]] + taken[pair[1]]) / (0.5 * pair[2]);
      if (much > 1) { taken[pair[0]] /= much; taken[pair[1]] /= much; }
    });
    return taken;
  }

  // Returns the part of the picture that labels and buttons leave free: fractions of width and
  // height, and the offset of its centre in half sizes of the picture.
  function free_part() {
    if (choice.compare === 'beside') return { wide: 0.9, tall: 0.75, across: 0, up: 0 };
    var width = host.clientWidth || 1, height = host.clientHeight || 1;
    var taken = taken_along(['left', 'right', 'top', 'bottom']);
    return {
      wide: 0.94 * (1 - (taken.left + taken.right) / width),
      tall: 0.94 * (1 - (taken.top + taken.bottom) / height),
      across: (taken.left - taken.right) / width, up: (taken.bottom - taken.top) / height
    };
  }

  // Returns the target and distance of a camera that sees a whole range in the free part:
  // {at, away}.
  function sight(range, turn, rise, aspect, free) {
    var way = axes(turn, rise), at = middle(range), away = 0, points = outline(range);
    var tall = Math.tan(perspective.fov * Math.PI / 360), wide = tall * aspect;
    for (var turnOver = 0; turnOver < 3; turnOver++) {
      var low = [Infinity, Infinity], high = [-Infinity, -Infinity];
      away = 0;
      points.forEach(function (point) {
        var d = [point[0] - at[0], point[1] - at[1], point[2] - at[2]], radius = point[3] || 0;
        away = Math.max(away, dot(d, way.eye) + Math.max(
          (Math.abs(dot(d, way.right)) + radius) / (free.wide * wide),
          (Math.abs(dot(d, way.up)) + radius) / (free.tall * tall)
        ));
      });
      away = Math.max(away, 1e-3);
      // The projected points determine the centre.
      points.forEach(function (point) {
        var d = [point[0] - at[0], point[1] - at[1], point[2] - at[2]], radius = point[3] || 0;
        var near = 1 - dot(d, way.eye) / away;
        [dot(d, way.right), dot(d, way.up)].forEach(function (v, k) {
          low[k] = Math.min(low[k], (v - radius) / near);
          high[k] = Math.max(high[k], (v + radius) / near);
        });
      });
      at = at.map(function (v, k) {
        return v + (low[0] + high[0]) / 2 * way.right[k] + (low[1] + high[1]) / 2 * way.up[k];
      });
    }
    return { at: at, away: away };
  }

  function aspect() {
    var box = boxes(canvas.clientWidth || 1, canvas.clientHeight || 1)[0];
    return box.width / box.height;
  }

  // Fits the focus into the picture without a turn of the camera.
  function aim() {
    var free = free_part(), found = sight(focus(), camera.turn, camera.rise, aspect(), free);
    camera.at = found.at;
    camera.away = camera.fit = found.away;
    camera.across = free.across;
    camera.up = free.up;
  }

  // Starts from the bow, unless another direction allows a much shorter distance. The front view
  // has the largest penalty, because a trawl hides most of itself there. The high view suits gears
  // that hang deep and narrow.
  function first_look() {
    var range = focus(), a = aspect(), free = free_part(), best = null;
    [['bow', directions.bow, 1], ['quarter', [-1.2, 0.3], 1.4], ['front', [-2.75, 0.22], 1.8],
      ['side', [-Math.PI / 2, 0.16], 1.5], ['high', [-1.3, 0.95], 1.5]].forEach(function (one) {
      var far = sight(range, one[1][0], one[1][1], a, free).away * one[2];
      if (!best || far < best[0]) best = [far, one];
    });
    camera.turn = best[1][1][0];
    camera.rise = best[1][1][1];
    press('from', best[1][0]);
  }

  // Resets the view. Labels of the scale take space that is known only after the first aim.
  function look_again() {
    held = {};
    first_look();
    aim();
    tell_scale();
    aim();
  }

  // ---- drawing ----------------------------------------------------------------------------------

  var water = materials.sheet(false, 0.22);
  var bed = materials.sheet(true, 1);
  function sheetMesh(material) {
    var geometry = new T.BufferGeometry();
    geometry.setAttribute('position', new T.BufferAttribute(new Float32Array(12), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    var mesh = new T.Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
  }
  var around = new T.Scene(), waterMesh = sheetMesh(water), bedMesh = sheetMesh(bed);
  bedMesh.renderOrder = -1;
  waterMesh.renderOrder = 5;
  var waters = new T.Mesh(new T.BufferGeometry(), materials.around);
  waters.geometry.setAttribute('position', new T.BufferAttribute(
    new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  waters.frustumCulled = false;
  waters.renderOrder = -2;
  around.add(waters);
  around.add(bedMesh);
  var above = new T.Scene();
  above.add(waterMesh);

  function round(size) {
    var power = Math.pow(10, Math.floor(Math.log10(size)));
    var lead = size / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  }

  // Returns the height of the bed (m).
  function bed_at(x, y) {
    var n = told.bed.normal;
    return (told.bed.height - n[0] * x - n[1] * y) / n[2];
  }

  // Renders the gear's shadow on the bed as seen from the sun, once per shape. sun: its direction.
  var cast = null, shaded = null, sun = [-0.34, 0.30, 0.89], sunCamera = new T.OrthographicCamera();
  sunCamera.matrixAutoUpdate = sunCamera.matrixWorldAutoUpdate = false;
  function cast_shadow(gear) {
    if (!told.bed || shaded === gear) return;
    shaded = gear;
    if (!cast) {
      cast = new T.WebGLRenderTarget(1024, 1024, {
        depthBuffer: true, generateMipmaps: true, minFilter: T.LinearMipmapLinearFilter
      });
    }
    var range = gear.range[choice.focus] || gear.range.whole, at = middle(range), n = told.bed.normal;
    // Points are projected to the bed along the sun's rays.
    var along = n[0] * sun[0] + n[1] * sun[1] + n[2] * sun[2];
    function fall(p) { return (dot(n, p) - told.bed.height) / along; }
    var reach = 0.62 * longest(range) + 0.35 * Math.abs(fall(range.high));
    var x = at[0] - sun[0] * fall(at), y = at[1] - sun[1] * fall(at), deep = 4 * (longest(range) + reach);
    var m = sunCamera.matrixWorldInverse.elements;
    [[1, 0, sun[0]], [0, 1, sun[1]]].forEach(function (row, k) {
      for (var c = 0; c < 3; c++) m[4 * c + k] = ((c < 2 ? row[c] : 0) - row[2] * n[c] / along) / reach;
      m[12 + k] = (row[2] * told.bed.height / along - (k ? y : x)) / reach;
    });
    for (var c = 0; c < 3; c++) m[4 * c + 2] = c === 2 ? -1 / deep : 0;
    m[14] = at[2] / deep;
    m[3] = m[7] = m[11] = 0;
    m[15] = 1;
    sunCamera.projectionMatrix.identity();
    shared.flat_.value = 1;
    shared.ahead.value.set(-sun[0], -sun[1], -sun[2]);
    shared.pixel.value = reach / 512;
    shared.spacing.value = twine_gap * shared.pixel.value;
    shared.fogMost.value = 0;
    shared.ghost.value = 1;
    shared.ghostColour.value.set(0);
    shared.ratio.value = 1;
    gear.place_marks(function () { return 0; });
    renderer.setRenderTarget(cast);
    renderer.clear();
    renderer.render(gear.scene, sunCamera);
    renderer.setRenderTarget(null);
    shared.ghost.value = 0;
    shared.fogMost.value = 0.6;
    bed.uniforms.shadow.value = cast.texture;
    bed.uniforms.shadowAt.value.set(x, y, reach);
  }

  var square = 1;
  function lay_sheets() {
    var range = focus(), size = longest(range), at = middle(range);
    square = round(size / 8);
    var reach = Math.max(2.6 * size, 1.1 * camera.away);
    [[waterMesh, water, function () { return 0; }], [bedMesh, bed, bed_at]].forEach(function (one) {
      if (one[0] === bedMesh && !told.bed) return;
      var place = one[0].geometry.getAttribute('position');
      [[-1, -1], [1, -1], [1, 1], [-1, 1]].forEach(function (sign, k) {
        var x = at[0] + sign[0] * reach, y = at[1] + sign[1] * reach;
        place.setXYZ(k, x, y, one[2](x, y));
      });
      place.needsUpdate = true;
      one[1].uniforms.square.value = square;
      one[1].uniforms.reach.value = reach;
      one[1].uniforms.middle.value = { x: at[0], y: at[1] };
    });
    waterMesh.visible = told.water;
    bedMesh.visible = !!told.bed;
  }

  // Minimum distance of drawn twines (pixels).
  var twine_gap = 14;

  // Sets the camera for a picture of this size (pixels).
  function set_eye(width, height) {
    var way = axes(camera.turn, camera.rise), range = gears.now.range.whole, size = longest(range);
    perspective.aspect = width / height;
    perspective.position.fromArray(camera.at.map(function (v, k) {
      return v + camera.away * way.eye[k];
    }));
    perspective.up.fromArray(way.up);
    perspective.lookAt(camera.at[0], camera.at[1], camera.at[2]);
    var far = Math.hypot(perspective.position.x - middle(range)[0],
      perspective.position.y - middle(range)[1], perspective.position.z - middle(range)[2]) + 3 * size;
    perspective.near = Math.max(camera.away * 0.02, far * 1e-4);
    perspective.far = far;
    perspective.updateProjectionMatrix();
    perspective.projectionMatrix.elements[8] -= camera.across;
    perspective.projectionMatrix.elements[9] -= camera.up;
    perspective.projectionMatrixInverse.copy(perspective.projectionMatrix).invert();
    perspective.updateMatrixWorld();
    shared.pixel.value = 2 * Math.tan(perspective.fov * Math.PI / 360) / height;
    shared.spacing.value = twine_gap * shared.pixel.value * camera.away;
    shared.flat_.value = 0;
    var reach = longest(focus()), shown = focus();
    shared.fogNear.value = camera.away - 0.1 * reach;
    shared.fogFar.value = camera.away + 3.5 * reach;
    // The water is lightest at the surface, or above a gear that hangs far below it.
    shared.waterTop.value = told.water && shown.high[2] > -0.5 * reach ? 0 : shown.high[2] + 0.3 * reach;
    shared.waterSpan.value = 1.1 * Math.max(shared.waterTop.value - shown.low[2], 0.5 * reach);
    materials.around.uniforms.away.value = camera.away;
    light(way);
  }

  // Places the light above and behind the camera's left shoulder.
  function light(way) {
    shared.light.value.set(0, 0, 0);
    [0, 1, 2].forEach(function (k) {
      shared.light.value.setComponent(k,
        0.75 * way.eye[k] - 0.3 * way.right[k] + 0.45 * way.up[k] + (k === 2 ? 0.35 : 0));
    });
    shared.light.value.normalize();
  }

  function size_at(place) {
    return shared.pixel.value * shared.ratio.value * perspective.position.distanceTo(place);
  }

  // ghost: uniform colour, or null. The opposite displacement of the camera moves the gear.
  function draw_gear(gear, eye, ghost, size) {
    var by = shift_of(gear), from = eye.position.clone();
    shared.ghost.value = ghost ? 0.85 : 0;
    if (ghost) shared.ghostColour.value.set(ghost);
    eye.position.sub(new T.Vector3().fromArray(by));
    eye.updateMatrixWorld();
    gear.place_marks(size);
    renderer.render(gear.scene, eye);
    eye.position.copy(from);
    eye.updateMatrixWorld();
  }

  // Draws the stored designs, each in its colour.
  function draw_kept(eye, size) {
    kept.forEach(function (one, k) { draw_gear(one.gear, eye, view.kept_colour(k), size); });
  }

  function boxes(width, height) {
    if (choice.compare !== 'beside' || !kept.length) {
      return [{ left: 0, top: 0, width: width, height: height, gear: gears.now }];
    }
    var all = kept.concat({ name: say('Now'), gear: gears.now }), n = all.length;
    var columns = Math.min(n, Math.max(1, Math.round(Math.sqrt(n * width / height))));
    var taken = taken_along(['top', 'bottom']);
    var w = width / columns, h = (height - taken.top - taken.bottom) / Math.ceil(n / columns);
    return all.map(function (one, k) {
      return {
        left: k % columns * w, top: taken.top + Math.floor(k / columns) * h, width: w, height: h,
        gear: one.gear, name: one.name
      };
    });
  }

  // While shapes change, a slow renderer draws at lower resolution. The first pictures measure the
  // drawing time (ms).
  var hasty = null, coarse = 0.5, slow = 30, times = [], quickest = Infinity;
  function hasten() {
    window.clearTimeout(hasty);
    hasty = window.setTimeout(function () {
      if (options.passing && options.passing()) { hasten(); return; }
      hasty = null;
      repaint();
    }, 250);
  }
  function take_time(began) {
    var gl = renderer.getContext();
    // This call waits until drawing is complete.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    times.push(performance.now() - began);
    if (times.length > 1) quickest = Math.min(quickest, times[times.length - 1]);
  }

  // Returns true if shapes are changing and the renderer is slow.
  function too_slow() { return hasty && quickest > slow && quickest < Infinity; }

  // Canvas pixels per CSS pixel.
  var ratio = 1;
  function draw(given) {
    var width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height || !gears.now) return false;
    ratio = given || (window.devicePixelRatio || 1) * (too_slow() ? coarse : 1);
    // A change of size waits for all earlier drawing, so it happens only if needed.
    if (canvas.width !== Math.floor(width * ratio) || canvas.height !== Math.floor(height * ratio)) {
      renderer.setDrawingBufferSize(width, height, ratio);
    }
    shared.ratio.value = ratio;
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    lay_sheets();
    boxes(width, height).forEach(function (box) {
      var foot = height - box.top - box.height;
      renderer.setScissorTest(true);
      renderer.setScissor(box.left, foot, box.width, box.height);
      renderer.setViewport(box.left, foot, box.width, box.height);
      // The first picture and intermediate shapes have no shadow, unless the renderer is fast.
      if (!shared.paper.value && (given || !hasty || quickest <= slow)) cast_shadow(box.gear);
      shared.ratio.value = ratio;
      set_eye(box.width, box.height);
      shared.pixel.value /= ratio;
      shared.ghost.value = 0;
      waters.visible = !shared.paper.value;
      renderer.render(around, perspective);
      if (choice.compare === 'over') draw_kept(perspective, size_at);
      draw_gear(box.gear, perspective, null, size_at);
      shared.ghost.value = 0;
      renderer.render(above, perspective);
    });
    renderer.setScissorTest(false);
    return true;
  }

  var waiting = false, drawn = 0;
  function repaint() {
    if (waiting) return;
    waiting = true;
    window.requestAnimationFrame(function () {
      waiting = false;
      paint_now();
    });
  }
  function paint_now() {
    var began = performance.now();
    if (saver.filming() || !draw()) return;
    if (hasty && times.length < 4) take_time(began);
    drawn += 1;
    seen = null;
    tell_scale();
    place_words();
    if (options.painted) options.painted();
  }

  // ---- labels around the picture ----------------------------------------------------------------

  var title = element('div', 'view-title');
  var bar = element('div', 'view-bar'), legend = element('div', 'view-legend');
  var scaleBar = element('div', 'view-scale'), tip = element('div', 'view-tip');
  var still = element('img', 'view-still', undefined, { alt: '' });
  tip.setAttribute('role', 'status');
  tip.hidden = true;
  var labels = {};
  ['surface', 'bed', 'vessel'].forEach(function (name) {
    labels[name] = element('div', 'view-label view-label-' + name);
    host.appendChild(labels[name]);
  });
  labels.surface.textContent = say('water surface');
  [title, bar, legend, scaleBar, tip, still].forEach(function (part) { host.appendChild(part); });

  function button(group, value, words, key) {
    var made = element('button', 'view-button', words, {
      type: 'button', 'data-group': group, 'data-value': value, 'aria-pressed': 'false',
      title: say('{words} (key {key})', { words: words, key: key })
    });
    made.addEventListener('click', function () { choose(group, value); });
    return made;
  }
  function group(words) { return element('div', 'view-group', undefined, { role: 'group', 'aria-label': words }); }

  var groups = { focus: group(say('Look at')), from: group(say('Look from')), compare: group(say('Kept designs')) };
  var names = [];  // labels of designs side by side
  [['net', say('Net'), 'n'], ['whole', say('Whole gear'), 'g']].forEach(function (one) {
    groups.focus.appendChild(button('focus', one[0], one[1], one[2]));
  });
  [['bow', say('Bow'), '1'], ['above', say('Above'), '2'], ['side', say('Side'), '3'],
    ['astern', say('Astern'), '4']].forEach(function (one) {
    groups.from.appendChild(button('from', one[0], one[1], one[2]));
  });
  [['off', say('Now'), '5'], ['over', say('Over'), '6'], ['beside', say('Side by side'), '7']].forEach(function (one) {
    groups.compare.appendChild(button('compare', one[0], one[1], one[2]));
  });
  var colours = element('select', 'view-colour', undefined, {
    'aria-label': say('Colours'),
    title: say('{words} (key {key})', { words: say('Colours'), key: 'c' })
  });
  colours.addEventListener('change', function () { choose('colour', colours.value); });
  var align = element('select', 'view-colour', undefined, {
    'aria-label': say('Designs are aligned at'), title: say('Designs are aligned at')
  });
  [['bosom', say('At the bosom')], ['towing', say('At the towing point')]].forEach(function (one) {
    align.appendChild(element('option', '', one[1], { value: one[0] }));
  });
  align.addEventListener('change', function () { choose('align', align.value); });
  groups.compare.appendChild(align);
  var help = element('button', 'view-button', '?', {
    type: 'button', 'aria-expanded': 'false', 'aria-label': say('Keys'),
    title: say('{words} (key {key})', { words: say('Keys'), key: 'h' })
  });
  var keys = element('div', 'view-keys');
  keys.hidden = true;
  [[say('drag, arrows'), say('turn')], [say('wheel, two fingers, + and -'), say('zoom')],
    [say('right button, Shift'), say('move')], ['1 2 3 4', say('bow, above, side, astern')],
    ['n, g', say('net, whole gear')], ['c', say('next colours')], ['0', say('reset view')], ['s', say('save')],
    [say('pointer'), say('names and values')]].forEach(function (one) {
    keys.appendChild(element('kbd', '', one[0]));
    keys.appendChild(element('span', '', one[1]));
  });
  help.addEventListener('click', function () {
    keys.hidden = !keys.hidden;
    help.setAttribute('aria-expanded', String(!keys.hidden));
  });
  var saver = view.save(host, {
    eye: function () { return camera; },
    times: function () { return told.times; },
    seek: function (time) { moment.seek(time); },
    look: look,
    release: repaint
  }, {
    canvas: canvas,
    draw: function (ratio) { hasty = null; draw(ratio); tell_scale(); place_words(); },
    words: function () {
      return [title, legend, scaleBar].concat(Array.from(host.querySelectorAll('.view-label, .view-time .label')));
    },
    name: function () { return told.name.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, ''); }
  });
  [groups.focus, groups.from, groups.compare, colours, saver.opener, help].forEach(function (part) {
    bar.appendChild(part);
  });
  host.appendChild(keys);
  host.appendChild(saver.panel);

  function press(what, value) {
    bar.querySelectorAll('[data-group="' + what + '"]').forEach(function (one) {
      one.setAttribute('aria-pressed', String(one.dataset.value === value));
    });
  }

  function colour_bar(kind, scale) {
    var made = element('div', 'colour-bar'), stops = told.colours[kind];
    var unit = scale.heading.match(/ \(.*$/);
    made.appendChild(element('div', 'heading', say(scale.heading.replace(/ \(.*$/, '')) + (unit || '')));
    var strip = element('div', 'strip');
    strip.style.background = 'linear-gradient(to right, ' + stops.join(', ') + ')';
    made.appendChild(strip);
    var row = element('div', 'ticks'), reach = -Infinity;
    scale.ticks.forEach(function (words, k) {
      var half = 3.6 * words.length;
      if (210 * scale.at[k] - half < reach + 5) return;
      reach = 210 * scale.at[k] + half;
      var tick = element('span', '', words);
      tick.style.left = 100 * scale.at[k] + '%';
      row.appendChild(tick);
    });
    made.appendChild(row);
    return made;
  }

  function write_legend() {
    legend.textContent = '';
    var scales = told.scales[choice.colour] || {};
    ['rope', 'netting'].forEach(function (kind) {
      if (scales[kind]) legend.appendChild(colour_bar(kind, scales[kind]));
    });
    var key = element('div', 'key');
    function entry(words, colour, className) {
      var item = element('span', 'entry', words), patch = element('i', className);
      patch.style.setProperty('--colour', colour);
      item.insertBefore(patch, item.firstChild);
      key.appendChild(item);
    }
    if (choice.colour === 'tension' || choice.colour === 'slack') {
      if (told.times.length > 1 || any(function (x) { return x === 0; })) {
        entry(say('slack'), gears.now.slack_colour(choice.colour), 'slack');
      } else {
        key.appendChild(element('span', 'entry', say('nothing is slack')));
      }
      if (any(function (x) { return x < 0; })) entry(say('in compression'), '#4A545C', 'line');
    }
    if (choice.colour === 'slack') entry(say('taut'), '#5F7482', 'line');
    if (!scales.rope && choice.colour.indexOf('mesh') === 0) entry(say('rope'), '#4A545C', 'line');
    if (choice.compare === 'over') {
      kept.forEach(function (one, k) { entry(one.name, view.kept_colour(k), 'line'); });
    }
    var marks = told.marks;
    marks.label.forEach(function (words, k) {
      if (marks.label.indexOf(words) === k) {
        entry(say(words), marks.fill[k], marks.board[k] >= 0 || marks.direction[k] ? 'plate' : 'ball');
      }
    });
    legend.appendChild(key);
  }

  // Returns true if `such` is true for any present tension.
  function any(such) {
    var gear = gears.now;
    return [gear.rope_tension, gear.netting.u, gear.netting.v].some(function (all) {
      return Array.prototype.some.call(all, such);
    });
  }

  function project(at, box) {
    var p = new T.Vector3(at[0], at[1], at[2]).project(perspective);
    return [box.left + box.width * (p.x + 1) / 2, box.top + box.height * (1 - p.y) / 2, p.z];
  }

  // Places the labels in the picture and hides labels out of sight.
  function place_words() {
    var width = canvas.clientWidth, height = canvas.clientHeight, box = boxes(width, height)[0];
    var range = focus(), at = middle(range), size = longest(range);
    function put(label, place, words) {
      var p = place && project(place, { left: 0, top: 0, width: width, height: height });
      var shown = p && p[2] < 1 && p[0] > 30 && p[0] < width - 30 && p[1] > 46 && p[1] < height - 90 &&
        choice.compare !== 'beside';
      label.hidden = !shown;
      if (!shown) return;
      if (words) label.textContent = words;
      label.style.left = p[0] + 'px';
      label.style.top = p[1] + 'px';
    }
    var side = [at[0] + 0.5 * size, at[1] - 0.75 * size];
    put(labels.surface, told.water && Math.abs(camera.rise) > 0.03 && [side[0], side[1], 0]);
    var depth = told.bed && (told.bed.height - told.bed.normal[0] * side[0] -
      told.bed.normal[1] * side[1]) / told.bed.normal[2];
    put(labels.bed, told.bed && [side[0], side[1], depth], told.bed &&
      say('sea bed, {n} m deep', { n: three(-depth) }));
    var vessel = gears.now.vessels[0];
    put(labels.vessel, vessel && [vessel.at[0], vessel.at[1], 0.5 * vessel.at[3]], say('vessel'));
    names.forEach(function (label) { label.remove(); });
    names = boxes(width, height).filter(function (one) { return one.name; }).map(function (one) {
      var label = element('div', 'view-label view-label-name', one.name);
      label.style.left = one.left + one.width / 2 + 'px';
      label.style.top = one.top + 18 + 'px';
      return host.appendChild(label);
    });
    return box;
  }

  // Updates the scale at the camera target, the flow arrow and the grid size.
  function tell_scale() {
    var box = boxes(canvas.clientWidth, canvas.clientHeight)[0];
    var metres = 2 * Math.tan(perspective.fov * Math.PI / 360) * camera.away / box.height;
    var long = round(90 * metres);
    scaleBar.textContent = '';
    var line = element('i', 'line');
    line.style.width = long / metres + 'px';
    scaleBar.appendChild(element('span', '', three(long) + ' m'));
    scaleBar.appendChild(line);
    var speed = Math.hypot(told.flow[0], told.flow[1]);
    if (speed) {
      var way = axes(camera.turn, camera.rise), along = [told.flow[0] / speed, told.flow[1] / speed, 0];
      var dx = dot(along, way.right), dy = -dot(along, way.up), seen2 = Math.hypot(dx, dy);
      var flow = element('span', 'flow', say('flow {n} m/s', { n: three(speed) }) + ' ');
      var arrow = element('i', 'arrow', seen2 < 0.15 ? '\u2299' : '\u2192');
      if (seen2 >= 0.15) arrow.style.transform = 'rotate(' + Math.atan2(dy, dx) + 'rad)';
      flow.appendChild(arrow);
      scaleBar.appendChild(flow);
    }
    if (told.bed || told.water && focus().high[2] > -0.3 * longest(focus())) {
      scaleBar.appendChild(element('span', 'squares', say('squares of {n} m', { n: three(square) })));
    }
  }

  // ---- formatted numbers ------------------------------------------------------------------------

  function three(x) {
    if (!isFinite(x)) return '';
    return String(Number(x.toPrecision(3)));
  }
  function force(newtons) {
    return Math.abs(newtons) >= 1000 ? three(newtons / 1000) + ' kN' : three(newtons) + ' N';
  }
  function thick(metres) { return three(1000 * metres) + ' mm'; }
  function plain(name) { return String(name).replace(/_/g, ' '); }

  // ---- the pointer ------------------------------------------------------------------------------

  // Returns screen positions of nodes and components (x and y in pixels, depth), on demand.
  var seen = null;
  function on_screen() {
    if (seen) return seen;
    var gear = gears.now, box = boxes(canvas.clientWidth, canvas.clientHeight).filter(function (b) {
      return b.gear === gears.now;
    })[0];
    set_eye(box.width, box.height);
    shared.pixel.value /= shared.ratio.value;
    function all(points) {
      var out = new Float32Array(points.length);
      var m = new T.Matrix4().multiplyMatrices(perspective.projectionMatrix,
        perspective.matrixWorldInverse).elements;
      for (var i = 0; i < points.length; i += 3) {
        var x = points[i], y = points[i + 1], z = points[i + 2];
        var w = m[3] * x + m[7] * y + m[11] * z + m[15];
        out[i] = box.left + box.width * ((m[0] * x + m[4] * y + m[8] * z + m[12]) / w + 1) / 2;
        out[i + 1] = box.top + box.height * (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) / 2;
        out[i + 2] = w;
      }
      return out;
    }
    seen = { points: all(gear.points), marks: all(gear.at) };
    return seen;
  }

  // Returns the element at a screen position: {kind, number, share} or null.
  function under(x, y) {
    var gear = gears.now, at = on_screen(), p = at.points, best = null;
    gear.marks.forEach(function (mark, i) {
      var w = at.marks[3 * i + 2];
      if (w <= 0) return;
      var off = Math.hypot(at.marks[3 * i] - x, at.marks[3 * i + 1] - y);
      var radius = Math.max(7, mark.half / (shared.pixel.value * shared.ratio.value * w));
      if (off < radius && (!best || w < best.away)) best = { kind: 'mark', number: i, away: w };
    });
    if (best) return best;
    var ends = gear.ropes.ends, near = 7;
    for (var l = 0; l < ends.length / 2; l++) {
      var a = 3 * ends[2 * l], b = 3 * ends[2 * l + 1];
      if (p[a + 2] <= 0 || p[b + 2] <= 0) continue;
      var dx = p[b] - p[a], dy = p[b + 1] - p[a + 1], long = dx * dx + dy * dy;
      var t = long ? Math.min(Math.max(((x - p[a]) * dx + (y - p[a + 1]) * dy) / long, 0), 1) : 0;
      var off = Math.hypot(p[a] + t * dx - x, p[a + 1] + t * dy - y);
      if (off < near) { near = off; best = { kind: 'rope', number: l, share: t }; }
    }
    if (best) return best;
    var net = gear.netting, closest = Infinity;
    for (var k = 0; k < net.part.length; k++) {
      var i = 3 * net.point[3 * k], j = 3 * net.point[3 * k + 1], c = 3 * net.point[3 * k + 2];
      if (p[i + 2] <= 0 || p[j + 2] <= 0 || p[c + 2] <= 0) continue;
      var area = (p[j] - p[i]) * (p[c + 1] - p[i + 1]) - (p[c] - p[i]) * (p[j + 1] - p[i + 1]);
      if (!area) continue;
      var s = ((x - p[i]) * (p[c + 1] - p[i + 1]) - (p[c] - p[i]) * (y - p[i + 1])) / area;
      var r = ((p[j] - p[i]) * (y - p[i + 1]) - (x - p[i]) * (p[j + 1] - p[i + 1])) / area;
      if (s < 0 || r < 0 || s + r > 1) continue;
      var w = p[i + 2] + s * (p[j + 2] - p[i + 2]) + r * (p[c + 2] - p[i + 2]);
      if (w < closest) { closest = w; best = { kind: 'netting', number: k }; }
    }
    return best;
  }

  function rows_of(found) {
    var gear = gears.now, parts = told.parts, k = found.number, rows = [], heading, note, z;
    function row(name, value) { if (value) rows.push([name, value]); }
    if (found.kind === 'mark') {
      var marks = told.marks;
      heading = plain(marks.part[k]);
      note = say(marks.label[k]);
      row(say('depth'), three(-gear.at[3 * k + 2]) + ' m');
    } else if (found.kind === 'rope') {
      var part = gear.ropes.part[k], tension = gear.rope_tension[k];
      heading = plain(parts.name[part]);
      var seam = parts.kind[part] === 'netting';
      note = seam ? say('seam') : say(plain(parts.role[part] || 'rope'));
      row(say('tension'), tension > 0 ? force(tension) : tension < 0 ? say('compression {force}', { force: force(-tension) }) :
        say('slack'));
      if (tension > 0 && parts.strength[part]) {
        row(say('of breaking load'), three(100 * tension / parts.strength[part]) + ' %');
      }
      if (parts.thickness[part]) row(say('diameter'), thick(parts.thickness[part]));
      if (gear.drag[part] && !seam) row(say('drag'), three(gear.drag[part]) + ' N/m');
      var a = gear.ropes.ends[2 * k], b = gear.ropes.ends[2 * k + 1];
      z = gear.points[3 * a + 2] + found.share * (gear.points[3 * b + 2] - gear.points[3 * a + 2]);
      row(say('depth'), three(-z) + ' m');
    } else {
      var of = gear.netting.part[k], meshes = gear.meshes(k);
      heading = plain(parts.name[of]);
      note = say('netting, {mesh} meshes, {twine} twine',
        { mesh: thick(parts.mesh[of]), twine: thick(parts.thickness[of]) });
      [[say('twine one way'), gear.netting.u[k]], [say('the other way'), gear.netting.v[k]]].forEach(function (one) {
        row(one[0], one[1] > 0 ? force(one[1]) : say('slack'));
      });
      if (isFinite(meshes.opening)) {
        row(say('mesh opening'), three(meshes.opening) + ' %');
        row(say('mesh angle'), three(meshes.angle) + '\u00b0');
      }
      if (gear.drag[of]) row(say('drag'), three(gear.drag[of]) + ' N/m\u00b2');
      z = [0, 1, 2].reduce(function (sum, c) {
        return sum + gear.points[3 * gear.netting.point[3 * k + c] + 2] / 3;
      }, 0);
      row(say('depth'), three(-z) + ' m');
    }
    return { heading: heading, note: note, rows: rows };
  }

  function point_at(x, y) {
    var found = gears.now && under(x, y);
    tip.hidden = !found;
    if (!found) return;
    var said = rows_of(found);
    tip.textContent = '';
    tip.appendChild(element('b', '', said.heading));
    if (said.note !== said.heading) tip.appendChild(element('div', 'note', said.note));
    said.rows.forEach(function (row) {
      var line = element('div', row[1] === say('slack') ? 'row slack' : 'row');
      line.appendChild(element('span', '', row[0]));
      line.appendChild(element('span', '', row[1]));
      tip.appendChild(line);
    });
    var right = x + 14 + tip.offsetWidth > host.clientWidth;
    tip.style.left = (right ? Math.max(4, x - 14 - tip.offsetWidth) : x + 14) + 'px';
    tip.style.top = Math.max(4, Math.min(y + 14, host.clientHeight - tip.offsetHeight - 4)) + 'px';
  }

  // ---- pointer, wheel and keys ------------------------------------------------------------------

  function look(place) {
    press('from', null);
    Object.assign(camera, place);
    repaint();
  }
  function turn_by(across, up) {
    camera.turn -= across;
    camera.rise = Math.min(Math.max(camera.rise + up, -Math.PI / 2), Math.PI / 2);
    press('from', null);
    repaint();
  }
  function zoom_by(factor, x, y) {
    var before = camera.away, size = longest(gears.now.range.whole);
    camera.away = Math.min(Math.max(before / factor, camera.fit / 400), 8 * size + 4 * camera.fit);
    // The zoom is centred on the pointer.
    if (x !== undefined) {
      var way = axes(camera.turn, camera.rise), up = canvas.clientHeight;
      var metres = 2 * Math.tan(perspective.fov * Math.PI / 360) / up * (before - camera.away);
      shift((x - canvas.clientWidth / 2 * (1 + camera.across)) * metres,
        (up / 2 * (1 - camera.up) - y) * metres, way);
    }
    repaint();
  }
  function shift(right, up, way) {
    camera.at = camera.at.map(function (v, k) { return v + right * way.right[k] + up * way.up[k]; });
  }
  function move_by(dx, dy) {
    var metres = 2 * Math.tan(perspective.fov * Math.PI / 360) * camera.away / canvas.clientHeight;
    shift(-dx * metres, dy * metres, axes(camera.turn, camera.rise));
    repaint();
  }

  function choose(what, value) {
    choice[what] = value;
    if (what === 'from' && directions[value]) {
      camera.turn = directions[value][0];
      camera.rise = directions[value][1];
    }
    if (what === 'colour') {
      colours.value = value;
      recolour();
    } else {
      press(what, value);
      held = {};
      shaded = null;
      if (gears.now) {
        offer_align();
        recolour();
        aim();
      }
    }
    if (told) write_legend();
    repaint();
    if (options.changed) options.changed();
  }

  function recolour() {
    compared().forEach(function (gear) { gear.colour(choice.colour); });
  }

  // Offers the alignment points of the gear.
  function offer_align() {
    var places = gears.now ? gears.now.places_to_align() : {};
    align.hidden = choice.compare === 'off' || !places.bosom || !places.towing;
    if (!places[choice.align]) choice.align = places.bosom ? 'bosom' : 'towing';
    align.value = choice.align;
  }

  var fingers = {}, apart = 0, hovering = null, chosen = false;
  // The wheel scrolls the page until the picture is clicked, unless the picture fills the window.
  function wheel_is_ours() {
    return chosen || host.clientHeight > window.innerHeight - 60 || options.wheel;
  }
  document.addEventListener('pointerdown', function (event) { chosen = host.contains(event.target); });
  canvas.addEventListener('pointerdown', function (event) {
    canvas.setPointerCapture(event.pointerId);
    fingers[event.pointerId] = [event.clientX, event.clientY, event.clientX, event.clientY];
    tip.hidden = true;
  });
  canvas.addEventListener('pointermove', function (event) {
    var before = fingers[event.pointerId];
    if (!before) {
      var box = canvas.getBoundingClientRect();
      if (!hovering) {
        window.requestAnimationFrame(function () {
          var at = hovering;
          hovering = null;
          if (at) point_at(at[0], at[1]);
        });
      }
      hovering = [event.clientX - box.left, event.clientY - box.top];
      return;
    }
    var dx = event.clientX - before[0], dy = event.clientY - before[1];
    before[0] = event.clientX;
    before[1] = event.clientY;
    var all = Object.keys(fingers);
    if (all.length === 1) {
      if (event.shiftKey || event.buttons === 2 || event.buttons === 4) move_by(dx, dy);
      else turn_by(dx * 0.008, dy * 0.008);
      return;
    }
    var a = fingers[all[0]], b = fingers[all[1]], gap = Math.hypot(a[0] - b[0], a[1] - b[1]);
    if (apart) zoom_by(gap / apart);
    apart = gap;
    move_by(dx / 2, dy / 2);
  });
  function lift(event) {
    var was = fingers[event.pointerId];
    delete fingers[event.pointerId];
    apart = 0;
    // A tap shows the values at its position.
    if (was && event.type === 'pointerup' &&
      Math.hypot(event.clientX - was[2], event.clientY - was[3]) < 4) {
      var box = canvas.getBoundingClientRect();
      point_at(event.clientX - box.left, event.clientY - box.top);
    }
  }
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);
  canvas.addEventListener('pointerleave', function () { hovering = null; tip.hidden = true; });
  canvas.addEventListener('contextmenu', function (event) { event.preventDefault(); });
  canvas.addEventListener('wheel', function (event) {
    if (!wheel_is_ours()) return;
    event.preventDefault();
    var box = canvas.getBoundingClientRect();
    zoom_by(Math.exp(-event.deltaY * 0.0015), event.clientX - box.left, event.clientY - box.top);
  }, { passive: false });

  function next_colour() {
    var all = Array.from(colours.options, function (o) { return o.value; });
    choose('colour', all[(all.indexOf(choice.colour) + 1) % all.length]);
  }
  var acts = {
    ArrowLeft: [turn_by, -0.1, 0], ArrowRight: [turn_by, 0.1, 0], ArrowUp: [turn_by, 0, 0.1],
    ArrowDown: [turn_by, 0, -0.1], '+': [zoom_by, 1.2], '=': [zoom_by, 1.2], '-': [zoom_by, 1 / 1.2],
    1: [choose, 'from', 'bow'], 2: [choose, 'from', 'above'], 3: [choose, 'from', 'side'],
    4: [choose, 'from', 'astern'], n: [choose, 'focus', 'net'], g: [choose, 'focus', 'whole'],
    c: [next_colour], h: [function () { help.click(); }], s: [function () { saver.opener.click(); }],
    0: [function () { look_again(); repaint(); }]
  };
  host.addEventListener('keydown', function (event) {
    if (event.ctrlKey || event.altKey || event.metaKey || !gears.now) return;
    if (/^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
    var key = event.key, act = acts[key];
    if (!groups.compare.hidden && { 5: 1, 6: 1, 7: 1 }[key]) {
      act = [choose, 'compare', { 5: 'off', 6: 'over', 7: 'beside' }[key]];
    }
    if (key === 'n' && !gears.now.range.net) return;
    if (key === 'Escape') { keys.hidden = true; tip.hidden = true; saver.close(); }
    if (!act) return;
    event.preventDefault();
    act[0](act[1], act[2]);
  });

  // ---- printing ---------------------------------------------------------------------------------

  // WebGL discards a picture after drawing, so it is copied immediately, on white.
  function on_white() {
    hasty = null;
    shared.paper.value = 1;
    bed.uniforms.strength.value = water.uniforms.strength.value = 0.05;
    var address = draw() ? canvas.toDataURL('image/png') : '';
    shared.paper.value = 0;
    bed.uniforms.strength.value = 1;
    water.uniforms.strength.value = 0.22;
    if (!address) return '';
    repaint();
    return address;
  }
  // In print layout the picture has no size, so the last still stays.
  function for_paper() {
    var made = on_white();
    if (made) still.src = made;
  }
  window.addEventListener('beforeprint', for_paper);
  // Some browsers print without a prior event.
  var stillTimer = null;
  function later() {
    window.clearTimeout(stillTimer);
    stillTimer = window.setTimeout(for_paper, 1500);
  }

  // ---- projections ------------------------------------------------------------------------------

  // Draws the gear as seen from `plane` (turn, rise) into `box` (left, top, width, height, pixels)
  // of another canvas, with `scale` pixels per metre around `at`. Returns false if it drew nothing.
  function flat(context, plane, box, at, scale) {
    var width = Math.min(box.width, canvas.clientWidth), height = Math.min(box.height, canvas.clientHeight);
    if (!gears.now || width < 2 || height < 2) return false;
    var turn = plane.turn, rise = plane.rise, way = axes(turn, rise), size = 4 * longest(gears.now.range.whole);
    var wide = width / scale / 2, tall = height / scale / 2;
    flatCamera.left = -wide;
    flatCamera.right = wide;
    flatCamera.top = tall;
    flatCamera.bottom = -tall;
    flatCamera.near = 0;
    flatCamera.far = 2 * size;
    flatCamera.position.fromArray(at.map(function (v, k) { return v + size * way.eye[k]; }));
    flatCamera.up.fromArray(way.up);
    flatCamera.lookAt(at[0], at[1], at[2]);
    flatCamera.updateProjectionMatrix();
    flatCamera.updateMatrixWorld();
    shared.flat_.value = 1;
    shared.ahead.value.fromArray(way.eye).negate();
    shared.pixel.value = 1 / scale / ratio;
    shared.spacing.value = twine_gap / scale;
    shared.fogNear.value = 10 * size;
    shared.fogFar.value = 20 * size;
    light(way);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, width, height);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    function pixel() { return 1 / scale; }
    if (choice.compare !== 'off') draw_kept(flatCamera, pixel);
    draw_gear(gears.now, flatCamera, null, pixel);
    renderer.setScissorTest(false);
    context.drawImage(canvas, 0, canvas.height - Math.round(height * ratio), Math.round(width * ratio),
      Math.round(height * ratio), box.left + (box.width - width) / 2, box.top + (box.height - height) / 2,
      width, height);
    return true;
  }

  // ---- scenes -----------------------------------------------------------------------------------

  function take(gear, part) {
    gear.take(part);
    shaded = null;
    gear.range = gear.ranges();
    gear.colour(choice.colour);
  }
  function take_now(part) {
    if (!gears.now) gears.now = view.gear(materials);
    take(gears.now, part);
  }
  function take_kept(all) {
    kept = all.map(function (one) {
      var before = kept.filter(function (other) { return other.key === one.key; })[0];
      var gear = before ? before.gear : view.gear(materials);
      if (one.scene.points) take(gear, one.scene);
      else Object.assign(gear.told, one.scene);
      return { key: one.key, name: one.name, gear: gear };
    });
    if (!kept.length) choice.compare = 'off';
  }

  // Fits the view again if the gear leaves the focus, at the same zoom.
  function follow() {
    var before = held[choice.focus];
    if (focus() === before) return;
    var zoom = camera.away / camera.fit;
    aim();
    camera.away *= zoom;
  }

  var moment = null, netless = false;
  var shown = {
    show: function (now, beside) {
      var first = !gears.now || now.name !== told.name;
      take_now(now);
      take_kept(beside || []);
      told = gears.now.told;
      canvas.setAttribute('aria-label', say(
        '{name} in three dimensions. {conditions}. Arrow keys turn it, plus and minus zoom.', told
      ));
      if (options.title) {
        title.textContent = '';
        title.appendChild(element('div', 'name', told.name));
        title.appendChild(element('div', 'conditions', told.conditions));
      }
      groups.compare.hidden = !kept.length;
      offer_align();
      // Without netting, only the whole gear can be in focus.
      var net = groups.focus.querySelector('[data-value="net"]');
      net.disabled = !gears.now.range.net;
      if (!gears.now.range.net && choice.focus === 'net') {
        choice.focus = 'whole';
        netless = true;
      } else if (gears.now.range.net && netless) {
        choice.focus = 'net';
        netless = false;
      }
      press('focus', choice.focus);
      press('compare', choice.compare);
      colours.textContent = '';
      Object.keys(modes).forEach(function (mode) {
        var scale = told.scales[mode];
        if (mode.indexOf('mesh') === 0 && !(scale && scale.netting)) return;
        colours.appendChild(element('option', '', modes[mode], { value: mode }));
      });
      if (first && now.colour) choice.colour = told.colour;
      if (!colours.querySelector('[value="' + choice.colour + '"]')) choice.colour = 'tension';
      colours.value = choice.colour;
      recolour();
      write_legend();
      if (moment && now.times) { moment.end(); moment = null; }
      if (told.times.length > 1 && !moment) moment = view.motion(host, shown, told, options);
      if (first) {
        look_again();
        hasten();
      } else {
        follow();
      }
      repaint();
      if (options.still !== false) later();
    },
    // Scales and labels stay until show() updates them.
    pass: function (part) {
      hasten();
      take_now(part);
      follow();
      repaint();
    },
    hastens: function () { return hasty !== null; },
    choose: choose,
    time: function (k, share) {
      gears.now.move(k, share);
      shaded = null;
      gears.now.colour(choice.colour);
      repaint();
    },
    seek: function (time) { if (moment) moment.seek(time); },
    look: look,
    frame: function (from) {
      choice.focus = from.focus || choice.focus;
      look_again();
      var at = Object.assign({ turn: camera.turn, rise: camera.rise, near: 1 }, from);
      look({ turn: at.turn, rise: at.rise });
      aim();
      camera.away *= at.near;
    },
    picture: saver.picture,
    film: saver.film,
    redraw: paint_now,
    flat: flat,
    focus: function () { return focus(); },
    gear: function () { return gears.now; },
    choice: choice,
    // For tests and measurements: a node position, whether a picture is pending, picture count.
    point: function (k) { return Array.from(gears.now.points.slice(3 * k, 3 * k + 3)); },
    waits: function () { return waiting || hasty !== null; },
    painted: function () { return drawn; },
    // bounds of the focus in the picture: left, top, right and bottom (pixels)
    reach: function () {
      var box = boxes(canvas.clientWidth, canvas.clientHeight)[0], found = [Infinity, Infinity, -Infinity, -Infinity];
      outline(focus()).forEach(function (point) {
        var p = project(point, box);
        for (var k = 0; k < 2; k++) {
          found[k] = Math.min(found[k], p[k]);
          found[k + 2] = Math.max(found[k + 2], p[k]);
        }
      });
      return found;
    },
    under: function (x, y) { return under(x, y); }
  };

  // Narrow pictures have smaller labels, and buttons in a row of their own.
  function fold() {
    host.classList.toggle('narrow', host.clientWidth < 640);
    host.classList.toggle('titled', !!options.title);
  }
  fold();
  var width = 0;
  new window.ResizeObserver(function () {
    fold();
    if (!gears.now) return;
    // A new shape of the page requires a new fit.
    if (Math.abs(canvas.clientWidth - width) > 40) {
      var zoom = camera.away / (camera.fit || 1), at = camera.at;
      aim();
      camera.away *= zoom;
      if (zoom !== 1) camera.at = at;
      width = canvas.clientWidth;
    }
    repaint();
  }).observe(canvas);

  host.codendViewer = shown;
  return shown;
};
