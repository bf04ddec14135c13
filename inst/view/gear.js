// A gear in the viewer: reads the numbers of a scene and updates its drawn shapes.
window.codendView = window.codendView || {};
window.codendView.gear = function (materials) {
  'use strict';
  var T = window.THREE, rgb = window.codendView.rgb;
  var taut = rgb('#5F7482'), quiet = rgb('#4A545C');
  var told = {}, gear = { scene: new T.Scene(), told: told };

  // ---- numbers ----------------------------------------------------------------------------------

  function bytes(text) {
    var raw = atob(text), out = new Uint8Array(raw.length);
    for (var i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
    return out.buffer;
  }
  function floats(given) {
    return given instanceof Float32Array ? given : new Float32Array(bytes(given));
  }
  function integers(given) {
    return given instanceof Int32Array ? given : new Int32Array(bytes(given));
  }

  // Decodes n series of 16-bit integers from deflated differences in time. sign: true if signed.
  function series(part, sign) {
    var raw = T.unzlibSync(new Uint8Array(bytes(part.text))), size = raw.length / 2;
    var out = sign ? new Int16Array(size) : new Uint16Array(size), times = size / part.count;
    for (var i = 0; i < size; i++) out[i] = raw[i] | raw[size + i] << 8;
    for (var order = 0; order < part.order; order++) {
      for (i = 0; i < size; i++) if (i % times) out[i] += out[i - 1];
    }
    return { of: out, times: times };
  }

  // Positions at stored times. `of(k, share)` interpolates between time k and the next.
  function places(part) {
    if (part.floats !== undefined) {
      var fixed = floats(part.floats);
      return { of: function () { return fixed; }, low: fixed, size: new Float32Array(fixed.length) };
    }
    var low = floats(part.low), step = floats(part.step), all = series(part.steps), n = low.length;
    var now = new Float32Array(n), times = all.times, steps = all.of;
    return {
      low: low, size: floats(part.size),
      of: function (k, share) {
        var next = k + 1 < times ? 1 : 0;
        for (var i = 0; i < n; i++) {
          var a = steps[i * times + k], b = steps[i * times + k + next];
          now[i] = low[i] + step[i] * (a + share * (b - a));
        }
        return now;
      }
    };
  }

  // Values at stored times, from signed square roots in 12 bits; -32768 is NaN.
  function values(part) {
    if (!part) return null;
    if (part.floats !== undefined) {
      var fixed = floats(part.floats);
      return { of: function () { return fixed; } };
    }
    var all = series(part.steps, true), n = part.steps.count, out = new Float32Array(n);
    return {
      of: function (k) {
        for (var i = 0; i < n; i++) {
          var r = all.of[i * all.times + k];
          out[i] = r === -32768 ? NaN : (r < 0 ? -1 : 1) * part.top * (r / 4095) * (r / 4095);
        }
        return out;
      }
    };
  }

  // ---- geometry ---------------------------------------------------------------------------------

  // Returns the triangles of all panels. Corners have a node, mesh coordinates and drawn
  // coordinates. Triangles have three indices of values (of cells or points of clouds), a part, and
  // the number of mesh coordinates per drawn coordinate.
  function surfaces(panels) {
    var points = [], mesh = [], drawn = [], at = [], part = [], scale = [], full = [], base = 0, front = [];
    // Returns 1 if a triangle encloses the catch, else 0. Stores the edges at its front.
    function filled(panel, point, uv, corners) {
      if (typeof panel.full !== 'number') return 0;
      var beyond = corners.map(function (corner) {
        return panel.down[0] * uv[2 * corner] + panel.down[1] * uv[2 * corner + 1] - panel.full;
      });
      var low = Math.min.apply(null, beyond), half = (Math.max.apply(null, beyond) - low) / 2;
      if (low + half < 0) return 0;
      var edge = corners.filter(function (_, k) { return low < half && beyond[k] < low + half / 2; });
      if (edge.length === 2) front.push({ ends: edge.map(function (k) { return point[k]; }), like: at.length / 3 - 1 });
      return 1;
    }
    panels.forEach(function (panel) {
      var point = integers(panel.point), uv = floats(panel.mesh);
      function add(a, b, c, va, vb, vc) {
        var area = (uv[2 * b] - uv[2 * a]) * (uv[2 * c + 1] - uv[2 * a + 1]) -
          (uv[2 * c] - uv[2 * a]) * (uv[2 * b + 1] - uv[2 * a + 1]);
        if (Math.abs(area) < 1e-6) return;
        [a, b, c].forEach(function (corner) {
          points.push(point[corner]);
          mesh.push(uv[2 * corner], uv[2 * corner + 1]);
          drawn.push(uv[2 * corner] / panel.scale + panel.offset[0], uv[2 * corner + 1] / panel.scale + panel.offset[1]);
        });
        at.push(base + va, base + vb, base + vc);
        part.push(panel.part);
        scale.push(panel.scale);
        full.push(filled(panel, point, uv, [a, b, c]));
      }
      var columns = panel.columns, rows = panel.rows;
      if (!columns) {
        var found = new T.Delaunator(uv).triangles;
        for (var t = 0; t < found.length; t += 3) {
          add(found[t], found[t + 1], found[t + 2], found[t], found[t + 1], found[t + 2]);
        }
        base += point.length;
        return;
      }
      for (var r = 0; r + 1 < rows; r++) {
        for (var c = 0; c + 1 < columns; c++) {
          var a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
          var cell = r * (columns - 1) + c;
          // Mirrored panels have mirrored diagonals.
          if (2 * c + 2 <= columns) {
            add(a, b, e, cell, cell, cell);
            add(a, e, d, cell, cell, cell);
          } else {
            add(a, b, d, cell, cell, cell);
            add(b, e, d, cell, cell, cell);
          }
        }
      }
      base += (columns - 1) * (rows - 1);
    });
    // A fan of triangles shows the fish at the front of the catch.
    front.forEach(function (edge) {
      points.push(front[0].ends[0], edge.ends[0], edge.ends[1]);
      mesh.push(0.2, 0.2, 0.4, 0.3, 0.3, 0.4);
      drawn.push(0.2, 0.2, 0.4, 0.3, 0.3, 0.4);
      scale.push(1);
      for (var c = 0; c < 3; c++) at.push(at[3 * edge.like + c]);
      part.push(part[edge.like]);
      full.push(1);
    });
    return {
      point: Int32Array.from(points), mesh: Float32Array.from(mesh), drawn: Float32Array.from(drawn),
      at: Int32Array.from(at), part: Int32Array.from(part), scale: scale, full: full, spot: spots(points, part)
    };
  }

  // Returns the number of bars of one family in a triangle.
  function bars_in(mesh, t) {
    var a = 6 * t;
    return Math.abs((mesh[a + 2] - mesh[a]) * (mesh[a + 5] - mesh[a + 1]) -
      (mesh[a + 4] - mesh[a]) * (mesh[a + 3] - mesh[a + 1])) / 2;
  }

  // Returns a number for every corner. Corners at one node of one part share a number.
  function spots(points, part) {
    var known = new Map();
    return Int32Array.from(points, function (point, corner) {
      var key = point * 65536 + part[Math.floor(corner / 3)];
      if (!known.has(key)) known.set(key, known.size);
      return known.get(key);
    });
  }

  function attribute(geometry, name, size, count, instanced) {
    var Kind = instanced ? T.InstancedBufferAttribute : T.BufferAttribute;
    var made = new Kind(new Float32Array(size * count), size);
    geometry.setAttribute(name, made);
    return made;
  }

  // Above this number of lines, tubes are instances. Renderers without a graphics card draw
  // instances one by one, so fewer lines have their tubes in the buffer.
  var mostWritten = 1000;

  // Builds the tubes of ropes. `values` contains the shader inputs of each line by name.
  function tubes_of(ends, part, thickness) {
    var lines = ends.length / 2, tube = new T.CylinderGeometry(1, 1, 1, 8, 1, true), made;
    tube.rotateX(Math.PI / 2);
    tube.translate(0, 0, 0.5);
    var corner = tube.getAttribute('position').array, corners = corner.length / 3;
    var written = lines <= mostWritten ? corners : 1;
    if (written > 1) {
      var index = tube.index.array, at = new Float32Array(3 * corners * lines);
      var all = new Uint32Array(index.length * lines);
      for (var l = 0; l < lines; l++) {
        at.set(corner, 3 * corners * l);
        for (var i = 0; i < index.length; i++) all[index.length * l + i] = corners * l + index[i];
      }
      made = new T.BufferGeometry();
      made.setIndex(new T.BufferAttribute(all, 1));
      made.setAttribute('position', new T.BufferAttribute(at, 3));
    } else {
      made = new T.InstancedBufferGeometry();
      made.index = tube.index;
      made.setAttribute('position', tube.getAttribute('position'));
      made.instanceCount = lines;
    }
    var ropes = { ends: ends, part: part, geometry: made, values: {} }, read = {};
    ['from', 'to', 'wayFrom', 'wayTo', 'colour', 'about'].forEach(function (name) {
      read[name] = attribute(made, name, 3, written * lines, written === 1);
      ropes.values[name] = new Float32Array(3 * lines);
    });
    for (var k = 0; k < lines; k++) ropes.values.about[3 * k] = thickness[part[k]] / 2;
    // Copies values to the buffers.
    ropes.tell = function (names) {
      names.forEach(function (name) {
        var value = ropes.values[name], out = read[name].array;
        for (var from = 0, to = 0; from < value.length; from += 3) {
          for (var c = 0; c < written; c++) {
            out[to++] = value[from];
            out[to++] = value[from + 1];
            out[to++] = value[from + 2];
          }
        }
        read[name].needsUpdate = true;
      });
    };
    return ropes;
  }

  function lay_out() {
    if (gear.netting) {
      gear.netting.geometry.dispose();
      gear.ropes.geometry.dispose();
    }
    gear.scene.clear();
    var made = surfaces(told.netting || []), n = made.part.length, parts = told.parts;
    var geometry = new T.BufferGeometry();
    geometry.setAttribute('mesh', new T.BufferAttribute(made.mesh, 2));
    geometry.setAttribute('drawn', new T.BufferAttribute(made.drawn, 2));
    made.gap = attribute(geometry, 'gap', 2, 3 * n);
    var alike = new Map();
    made.position = attribute(geometry, 'position', 3, 3 * n);
    made.normal = attribute(geometry, 'normal', 3, 3 * n);
    made.colourU = attribute(geometry, 'colourU', 3, 3 * n);
    made.colourV = attribute(geometry, 'colourV', 3, 3 * n);
    made.about = attribute(geometry, 'about', 3, 3 * n);
    for (var t = 0; t < n; t++) {
      var bar = Math.max(parts.bar[made.part[t]], 1e-9), thick = parts.thickness[made.part[t]] / bar;
      for (var c = 0; c < 3; c++) {
        made.about.array[9 * t + 3 * c] = Math.min(thick, 0.5) + made.full[t];
      }
      // Groups triangles with the same bar length and scale.
      var key = bar.toPrecision(3) + ' ' + made.scale[t].toPrecision(3);
      if (!alike.has(key)) alike.set(key, { triangles: [], bars: 0, length: bar, scale: made.scale[t] });
      alike.get(key).triangles.push(t);
      alike.get(key).bars += bars_in(made.mesh, t);
    }
    made.alike = Array.from(alike.values());
    made.geometry = geometry;
    made.u = new Float32Array(n);
    made.v = new Float32Array(n);
    gear.netting = made;
    [materials.nettingCore, materials.nettingEdge].forEach(function (material, k) {
      var mesh = new T.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 2 * k;
      gear.scene.add(mesh);
    });

    gear.ropes = tubes_of(integers(told.ropes.ends), integers(told.ropes.part), parts.thickness);
    var rope = gear.ropes.geometry;
    var tubes = new T.Mesh(rope, materials.rope);
    tubes.frustumCulled = false;
    gear.scene.add(tubes);
    lay_out_marks();
  }

  // ---- components -------------------------------------------------------------------------------

  // Returns a plate of 1 by 1 in x and y, bent towards z.
  function plate(bend, thick) {
    var made = new T.BoxGeometry(1, 1, thick, 10, 1, 1), at = made.getAttribute('position');
    for (var i = 0; i < at.count; i++) {
      var x = at.getX(i);
      at.setZ(i, at.getZ(i) + bend * (1 - 4 * x * x));
    }
    made.computeVertexNormals();
    return made;
  }

  // Returns a hull of length 1: stern at the origin, bow at x = -1, deck above z = 0.
  function hull() {
    var deck = new T.Shape();
    deck.moveTo(0, -0.13);
    deck.lineTo(-0.62, -0.135);
    deck.quadraticCurveTo(-0.86, -0.12, -1, 0);
    deck.quadraticCurveTo(-0.86, 0.12, -0.62, 0.135);
    deck.lineTo(0, 0.13);
    deck.closePath();
    var made = new T.ExtrudeGeometry(deck, { depth: 0.15, bevelEnabled: false, curveSegments: 8 });
    var at = made.getAttribute('position');
    for (var i = 0; i < at.count; i++) {
      // The hull is narrow at the keel and rises towards the bow.
      var up = at.getZ(i) / 0.15, x = at.getX(i);
      at.setY(i, at.getY(i) * (0.45 + 0.55 * up));
      at.setX(i, x * (0.9 + 0.1 * up));
      at.setZ(i, -0.07 + (0.13 + 0.06 * x * x) * up);
    }
    made.computeVertexNormals();
    return made;
  }

  function joined(all) {
    var corners = [], normals = [], index = [];
    all.forEach(function (one) {
      var from = corners.length / 3, count = one.getAttribute('position').count;
      corners.push.apply(corners, one.getAttribute('position').array);
      normals.push.apply(normals, one.getAttribute('normal').array);
      for (var i = 0; i < (one.index ? one.index.count : count); i++) {
        index.push(from + (one.index ? one.index.array[i] : i));
      }
    });
    var made = new T.BufferGeometry();
    made.setAttribute('position', new T.BufferAttribute(Float32Array.from(corners), 3));
    made.setAttribute('normal', new T.BufferAttribute(Float32Array.from(normals), 3));
    made.setIndex(index);
    return made;
  }
  function box(x, y, z, wide, tall, deep) {
    return new T.BoxGeometry(wide, tall, deep).translate(x, y, z);
  }
  function ring(radius, thick, arc) { return new T.TorusGeometry(radius, thick, 6, 18, arc || 2 * Math.PI); }

  // Returns a board: two foils with a slot between them, ribs behind, and a shoe below.
  function board() {
    function foil(x, wide, bend) { return plate(bend, 0.035).scale(wide, 0.94, 1).translate(x, 0.02, 0); }
    return joined([
      foil(-0.33, 0.3, 0.035).rotateY(0.10), foil(0.16, 0.66, 0.075),
      box(0, 0.49, 0.03, 0.98, 0.03, 0.12), box(0, 0.02, 0.015, 0.92, 0.03, 0.09),
      box(0, -0.475, 0.03, 1, 0.06, 0.16)
    ]);
  }
  // Returns a float with its seam and two ears.
  function float() {
    return joined([
      new T.SphereGeometry(1, 18, 12), ring(1, 0.06).rotateX(Math.PI / 2),
      ring(0.2, 0.07).translate(1.12, 0, 0), ring(0.2, 0.07).translate(-1.12, 0, 0)
    ]);
  }
  // Returns a drum with rounded ends and an eye.
  function sinker() {
    return joined([
      new T.CylinderGeometry(0.72, 0.72, 0.9, 16), new T.CylinderGeometry(0.45, 0.72, 0.28, 16).translate(0, 0.59, 0),
      new T.CylinderGeometry(0.72, 0.45, 0.28, 16).translate(0, -0.59, 0), ring(0.26, 0.09).translate(0, 0.95, 0)
    ]).rotateX(Math.PI / 2);
  }
  // Returns a heap of chain links.
  function clump() {
    return joined([0, 1, 2, 3, 4, 5, 6].map(function (k) {
      return ring(0.5, 0.19).scale(1, 1.5, 1).rotateZ(k * 1.1).rotateX(k * 0.9)
        .translate(0.35 * Math.cos(2.4 * k), 0.35 * Math.sin(2.4 * k), 0.2 * k - 0.6);
    }));
  }
  function hook() {
    return joined([
      new T.CylinderGeometry(0.09, 0.09, 1.5, 6).rotateX(Math.PI / 2).translate(0.5, 0, -0.6),
      ring(0.5, 0.09, Math.PI).rotateX(-Math.PI / 2).translate(0, 0, -1.35),
      new T.CylinderGeometry(0.09, 0.02, 0.5, 6).rotateX(Math.PI / 2).translate(-0.5, 0, -1.15)
    ]);
  }
  // Returns the end of a beam trawl's shoe: a runner that is turned up at the front.
  function runner() {
    return joined([box(0, 0, -0.5, 1.6, 0.9, 0.2), box(-1.1, 0, -0.25, 0.8, 0.9, 0.2).rotateY(0.25)]);
  }
  // Returns a full bag, longer than wide, with lobes between its lines.
  function bag() {
    var made = new T.SphereGeometry(1, 32, 18), at = made.getAttribute('position');
    for (var i = 0; i < at.count; i++) {
      var swell = 1 + 0.035 * Math.cos(8 * Math.atan2(at.getZ(i), at.getX(i))), y = at.getY(i);
      at.setXYZ(i, at.getX(i) * swell, 1.5 * y + 0.25 * y * y, at.getZ(i) * swell);
    }
    made.computeVertexNormals();
    return made.rotateZ(-Math.PI / 2);
  }

  var shapes = null;
  function shapesOnce() {
    if (shapes) return shapes;
    shapes = {
      plate: board(), cloth: plate(0.05, 0.012), ball: new T.SphereGeometry(1, 18, 12), float: float(),
      sinker: sinker(), clump: clump(), runner: runner(), bag: bag(), ring: ring(0.85, 0.16), hook: hook(),
      anchor: new T.CylinderGeometry(0, 1, 1.6, 4).rotateX(Math.PI / 2), hull: hull(),
      box: new T.BoxGeometry(1, 1, 1)
    };
    return shapes;
  }

  // Shape of each role, and its minimum half size (pixels).
  var roles = {
    otter_board: ['plate', 7], kite: ['cloth', 6], canvas: ['cloth', 6], float: ['float', 2.6],
    hammer: ['clump', 5], weight: ['sinker', 4.5], sinker: ['sinker', 1.6], catch: ['bag', 4],
    ring: ['ring', 2.6], hook: ['hook', 1.8], fixed: ['anchor', 4.5], moved: ['ball', 2.6],
    shoe_end: ['runner', 2.6]
  };

  // All components and vessels share one buffer, because one draw call is faster than many.
  function lay_out_marks() {
    var made = shapesOnce(), marks = told.marks, bodies = [], corners = 0, sides = 0;
    function body(shape, colour) {
      var geometry = made[shape];
      if (!geometry.index) {
        geometry.setIndex(Array.from({ length: geometry.getAttribute('position').count },
          function (_, i) { return i; }));
      }
      var one = { geometry: geometry, colour: rgb(colour), from: corners, matrix: new T.Matrix4() };
      corners += geometry.getAttribute('position').count;
      sides += geometry.index.count;
      bodies.push(one);
      return one;
    }
    gear.marks = marks.role.map(function (role, i) {
      var known = roles[role] || ['ball', 3];
      return { body: body(known[0], marks.fill[i]), shape: known[0], least: known[1] };
    });
    gear.vessels = (told.vessels || []).map(function (own) {
      return {
        marks: own, hull: body('hull', '#24506E'), house: body('box', '#6B7780'),
        mast: body('box', '#39434B'), gallows: body('box', '#39434B')
      };
    });
    if (gear.bodies) gear.bodies.geometry.dispose();
    var geometry = new T.BufferGeometry(), index = new Uint32Array(sides), at = 0;
    var colour = attribute(geometry, 'colour', 3, corners);
    bodies.forEach(function (one) {
      var own = one.geometry.index.array, count = one.geometry.getAttribute('position').count;
      for (var i = 0; i < own.length; i++) index[at++] = one.from + own[i];
      for (var c = 0; c < count; c++) colour.array.set(one.colour, 3 * (one.from + c));
    });
    geometry.setIndex(new T.BufferAttribute(index, 1));
    gear.bodies = {
      geometry: geometry, all: bodies, position: attribute(geometry, 'position', 3, corners),
      normal: attribute(geometry, 'normal', 3, corners)
    };
    var mesh = new T.Mesh(geometry, materials.solid);
    mesh.frustumCulled = false;
    gear.scene.add(mesh);
  }

  // Applies the matrix of each body to its vertices.
  function place_bodies() {
    var position = gear.bodies.position, normal = gear.bodies.normal;
    gear.bodies.all.forEach(function (one) {
      var m = one.matrix.elements, p = one.geometry.getAttribute('position').array;
      var n = one.geometry.getAttribute('normal').array, to = 3 * one.from;
      for (var i = 0; i < p.length; i += 3, to += 3) {
        for (var k = 0; k < 3; k++) {
          position.array[to + k] = m[k] * p[i] + m[4 + k] * p[i + 1] + m[8 + k] * p[i + 2] + m[12 + k];
          normal.array[to + k] = m[k] * n[i] + m[4 + k] * n[i + 1] + m[8 + k] * n[i + 2];
        }
      }
    });
    position.needsUpdate = normal.needsUpdate = true;
  }

  // Returns two directions in the plate of a component without an attitude of its own. Plates with
  // sideways lift are upright, at 30 degrees to the flow. Others lie across it, at 45 degrees.
  function symbolPlate(way) {
    var c = Math.cos(Math.PI / 6), h = Math.SQRT1_2;
    return [
      way === 'port' ? [c, 0.5, 0] : way === 'starboard' ? [c, -0.5, 0] : [0, 1, 0],
      way === 'down' ? [h, 0, h] : way === 'port' || way === 'starboard' ? [0, 0, 1] : [-h, 0, h]
    ];
  }

  // size: function of a position that returns metres per pixel.
  gear.place_marks = function (size) {
    var at = gear.at, boards = gear.corners, marks = told.marks;
    var x = new T.Vector3(), y = new T.Vector3(), z = new T.Vector3(), m = new T.Vector3();
    gear.marks.forEach(function (mark, i) {
      m.set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
      var least = mark.least * size(m), half;
      if (mark.shape === 'plate' || mark.shape === 'cloth') {
        if (marks.board[i] >= 0) {
          var c = [0, 1, 2, 3].map(function (k) {
            var from = 3 * (4 * marks.board[i] + k);
            return new T.Vector3(boards[from], boards[from + 1], boards[from + 2]);
          });
          x.copy(c[2]).add(c[3]).sub(c[0]).sub(c[1]).multiplyScalar(0.5);
          y.copy(c[1]).add(c[2]).sub(c[0]).sub(c[3]).multiplyScalar(0.5);
          m.copy(c[0]).add(c[1]).add(c[2]).add(c[3]).multiplyScalar(0.25);
        } else {
          var sides = symbolPlate(marks.direction[i]);
          half = Math.max(marks.size[i], 1e-3);
          x.fromArray(sides[0]).multiplyScalar(half);
          y.fromArray(sides[1]).multiplyScalar(half);
        }
        var grow = Math.max(1, 2 * least / Math.max(Math.min(x.length(), y.length()), 1e-9));
        x.multiplyScalar(grow);
        y.multiplyScalar(grow);
        z.crossVectors(x, y).normalize().multiplyScalar(x.length());
        // The hollow side faces the flow.
        var out = { port: [0, -1, 0], starboard: [0, 1, 0], down: [0, 0, -1] }[marks.direction[i]];
        if (z.dot(new T.Vector3().fromArray(out || [0, 0, 1])) < 0) z.negate();
      } else {
        half = marks.size[i] / Math.sqrt(Math.PI);
        half = Math.max(half, least);
        x.set(half, 0, 0);
        y.set(0, half, 0);
        z.set(0, 0, half);
      }
      mark.body.matrix.makeBasis(x, y, z).setPosition(m);
      mark.half = Math.max(x.length(), y.length()) / (mark.shape === 'plate' || mark.shape === 'cloth' ? 2 : 1);
    });
    gear.vessels.forEach(function (vessel) {
      var low = new T.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
      vessel.marks.forEach(function (i) {
        m.set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        low.min(m);
        high.max(m);
      });
      m.addVectors(low, high).multiplyScalar(0.5);
      var spread = high.y - low.y, length = Math.max(Math.min(Math.max(3.6 * spread, 16), 60),
        20 * size(m));
      vessel.at = [m.x - length / 2, m.y, 0, length];
      function box(body, ahead, across, foot, long, wide, high_) {
        body.matrix.makeScale(length * long, length * wide, length * high_)
          .setPosition(m.x - length * ahead, m.y + length * across, length * (foot + high_ / 2));
      }
      vessel.hull.matrix.makeScale(length, Math.max(length, 3.9 * spread), length)
        .setPosition(m.x, m.y, 0);
      box(vessel.house, 0.66, 0, 0.06, 0.17, 0.15, 0.15);
      box(vessel.mast, 0.66, 0, 0.2, 0.015, 0.015, 0.16);
      box(vessel.gallows, 0.03, 0, 0.06, 0.02, 0.2, 0.12);
    });
    place_bodies();
  };

  // ---- positions and colours --------------------------------------------------------------------

  // Merges a part of a scene into the known scene.
  gear.take = function (part) {
    // Another gear may have no netting.
    if (part.ropes) told.opening = told.angle = null;
    Object.keys(part).forEach(function (name) { told[name] = part[name]; });
    gear.source = {
      points: places(told.points), places: places(told.places), boards: places(told.boards)
    };
    gear.values = {};
    ['rope_tension', 'u', 'v', 'opening', 'angle', 'drag'].forEach(function (name) {
      gear.values[name] = values(told[name]);
    });
    gear.stops = { rope: told.colours.rope.map(rgb), netting: told.colours.netting.map(rgb) };
    if (part.ropes || part.netting || part.parts || !gear.netting) lay_out();
    gear.move(0, 0);
  };

  // Moves the gear to the fraction `share` between stored time k and the next.
  gear.move = function (k, share) {
    var p = gear.points = gear.source.points.of(k, share);
    gear.at = gear.source.places.of(k, share);
    gear.corners = gear.source.boards.of(k, share);
    gear.moment = share < 0.5 ? k : k + 1;
    var net = gear.netting, n = net.part.length, normal = new Float32Array(p.length);
    var area = new Float64Array(n);
    for (var t = 0; t < n; t++) {
      var a = 3 * net.point[3 * t], b = 3 * net.point[3 * t + 1], c = 3 * net.point[3 * t + 2];
      var ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      var vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      var x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      area[t] = Math.hypot(x, y, z) / 2;
      [a, b, c].forEach(function (at, corner) {
        net.position.array[9 * t + 3 * corner] = p[at];
        net.position.array[9 * t + 3 * corner + 1] = p[at + 1];
        net.position.array[9 * t + 3 * corner + 2] = p[at + 2];
        // Panels may meet with opposite normals; the first one determines the sign.
        var sign = normal[at] * x + normal[at + 1] * y + normal[at + 2] * z < 0 ? -1 : 1;
        normal[at] += sign * x;
        normal[at + 1] += sign * y;
        normal[at + 2] += sign * z;
      });
    }
    for (var i = 0; i < 3 * n; i++) {
      var from = 3 * net.point[i];
      for (var axis = 0; axis < 3; axis++) net.normal.array[3 * i + axis] = normal[from + axis];
    }
    net.position.needsUpdate = net.normal.needsUpdate = true;
    // Twines are closer together in less open meshes.
    net.alike.forEach(function (one) {
      var all = one.triangles.reduce(function (sum, t) { return sum + area[t]; }, 0);
      var gap = Math.max(all / Math.max(one.bars * one.length, 1e-12), 0.05 * one.length);
      one.triangles.forEach(function (t) {
        for (var c = 0; c < 3; c++) net.gap.array.set([gap, one.scale * gap], 6 * t + 2 * c);
      });
    });
    net.gap.needsUpdate = true;

    var ends = gear.ropes.ends, lines = ends.length / 2, along = 0, rope = gear.ropes.values;
    function set(values, line, x, y, z) {
      values[3 * line] = x;
      values[3 * line + 1] = y;
      values[3 * line + 2] = z;
    }
    for (var l = 0; l < lines; l++) {
      var f = 3 * ends[2 * l], e = 3 * ends[2 * l + 1];
      var dx = p[e] - p[f], dy = p[e + 1] - p[f + 1], dz = p[e + 2] - p[f + 2];
      var long = Math.hypot(dx, dy, dz) || 1;
      set(rope.from, l, p[f], p[f + 1], p[f + 2]);
      set(rope.to, l, p[e], p[e + 1], p[e + 2]);
      dx /= long; dy /= long; dz /= long;
      set(rope.wayFrom, l, dx, dy, dz);
      set(rope.wayTo, l, dx, dy, dz);
      var joined = l > 0 && ends[2 * l - 1] === ends[2 * l];
      if (joined) {
        // Neighbours share their direction at the joint, unless the rope turns sharply there.
        var w = rope.wayTo, at3 = 3 * (l - 1);
        var sx = w[at3] + dx, sy = w[at3 + 1] + dy, sz = w[at3 + 2] + dz;
        var sum = Math.hypot(sx, sy, sz);
        if (sum > 1.2) {
          set(rope.wayTo, l - 1, sx / sum, sy / sum, sz / sum);
          set(rope.wayFrom, l, sx / sum, sy / sum, sz / sum);
        }
      } else {
        along = 0;
      }
      rope.about[3 * l + 2] = along;
      along += long;
    }
    gear.ropes.tell(['from', 'to', 'wayFrom', 'wayTo', 'about']);
  };

  function shareOn(scale, value) {
    var low = scale.limits[0], high = scale.limits[1], x = Math.max(value, low);
    var share = scale.log ? Math.log(x / low) / Math.log(high / low) : (x - low) / (high - low);
    return Math.min(Math.max(share, 0), 1);
  }

  function paint(stops, share, out, at) {
    var place = share * (stops.length - 1), k = Math.min(Math.floor(place), stops.length - 2);
    var f = place - k, a = stops[k], b = stops[k + 1];
    for (var c = 0; c < 3; c++) out[at + c] = a[c] + f * (b[c] - a[c]);
  }
  function put(colour, out, at) { for (var c = 0; c < 3; c++) out[at + c] = colour[c]; }

  // Slack twine is muted if the colours show another quantity.
  gear.slack_colour = function (mode) {
    return mode === 'slack' ? told.colours.slack : told.colours.slack_muted;
  };

  // Updates the colours. mode: tension, slack, mesh_opening, mesh_angle or drag.
  gear.colour = function (mode) {
    var k = gear.moment, scales = told.scales[mode] || {}, ropes = gear.ropes, net = gear.netting;
    var shows = mode === 'tension' || mode === 'slack', loose = rgb(gear.slack_colour(mode));
    var tension = gear.rope_tension = gear.values.rope_tension.of(k);
    var drag = gear.drag = gear.values.drag.of(k);
    for (var l = 0; l < ropes.part.length; l++) {
      var value = mode === 'drag' ? drag[ropes.part[l]] : tension[l], out = ropes.values.colour;
      // Seams have the colours of netting.
      var of = told.parts.kind[ropes.part[l]] === 'netting' ? 'netting' : 'rope';
      var slack = shows && tension[l] === 0;
      ropes.values.about[3 * l + 1] = (slack ? 1 : 0) + 2 * told.parts.form[ropes.part[l]];
      if (slack) put(loose, out, 3 * l);
      // Beams and struts in compression.
      else if (shows && tension[l] < 0) put(quiet, out, 3 * l);
      else if (mode === 'slack') put(taut, out, 3 * l);
      else if (!scales.rope || !scales[of]) put(quiet, out, 3 * l);
      else paint(gear.stops[of], shareOn(scales[of], value), out, 3 * l);
    }
    ropes.tell(['colour', 'about']);

    var u = gear.values.u.of(k), v = gear.values.v.of(k);
    var whole = mode === 'mesh_opening' ? gear.values.opening : mode === 'mesh_angle' &&
      gear.values.angle;
    whole = whole && whole.of(k);
    // Returns the mean of the known positive values at three indices, or 0 if most are slack.
    function mean(all, t) {
      if (net.at[3 * t] === net.at[3 * t + 1]) return all[net.at[3 * t]];
      var sum = 0, known = 0, slack = 0;
      for (var c = 0; c < 3; c++) {
        var value = all[net.at[3 * t + c]];
        if (value !== value) continue;
        known++;
        if (value > 0) sum += value; else slack++;
      }
      return 2 * slack >= known ? 0 : sum / (known - slack);
    }
    for (var t = 0; t < net.part.length; t++) {
      net.u[t] = mean(u, t);
      net.v[t] = mean(v, t);
    }
    colour_family(net.u, net.colourU.array, 1);
    colour_family(net.v, net.colourV.array, 2);
    // Colours one family of twines. Each point has the mean of its adjacent triangles.
    function colour_family(tension, out, place) {
      var count = 1 + net.spot.reduce(function (most, spot) { return Math.max(most, spot); }, -1);
      var number = new Float32Array(count), taut_ = new Float32Array(count), sum = new Float32Array(count);
      for (var c = 0; c < net.spot.length; c++) {
        var t = Math.floor(c / 3), spot = net.spot[c];
        number[spot] += 1;
        if (shows && tension[t] <= 0) continue;
        taut_[spot] += 1;
        if (scales.netting) {
          sum[spot] += shareOn(scales.netting, whole ? mean(whole, t) :
            mode === 'drag' ? drag[net.part[t]] : tension[t]);
        }
      }
      var colours = new Float32Array(3 * count), own = [0, 0, 0];
      for (spot = 0; spot < count; spot++) {
        var slack = 1 - taut_[spot] / number[spot];
        if (mode === 'slack') put(taut, own, 0);
        else if (!scales.netting) put(quiet, own, 0);
        else paint(gear.stops.netting, sum[spot] / Math.max(taut_[spot], 1), own, 0);
        for (var k = 0; k < 3; k++) colours[3 * spot + k] = own[k] + slack * (loose[k] - own[k]);
      }
      for (c = 0; c < net.spot.length; c++) {
        spot = net.spot[c];
        for (k = 0; k < 3; k++) out[3 * c + k] = colours[3 * spot + k];
        // Only this mode shows slack as dashes.
        net.about.array[3 * c + place] = mode === 'slack' ? 1 - taut_[spot] / number[spot] : 0;
      }
    }
    net.colourU.needsUpdate = net.colourV.needsUpdate = net.about.needsUpdate = true;
  };

  // Returns the present opening (%) and angle (degrees) of the meshes in a triangle.
  gear.meshes = function (t) {
    function one(name) {
      var all = gear.values[name];
      return all ? all.of(gear.moment)[gear.netting.at[3 * t]] : NaN;
    }
    return { opening: one('opening'), angle: one('angle') };
  };

  // Returns the present alignment points {bosom, towing}, each [x, y, z] or missing. The bosom is
  // the aftmost point of the headline; `towing` is the mean of the towing points.
  gear.places_to_align = function () {
    var found = {}, p = gear.points, ropes = gear.ropes, marks = told.marks;
    for (var l = 0; l < ropes.part.length; l++) {
      if (told.parts.role[ropes.part[l]] !== 'headline') continue;
      [2 * l, 2 * l + 1].forEach(function (end) {
        var i = 3 * ropes.ends[end];
        if (!found.bosom || p[i] > found.bosom[0]) found.bosom = [p[i], p[i + 1], p[i + 2]];
      });
    }
    function middle_of(role) {
      var own = marks.role.map(function (name, i) { return name === role ? i : -1; })
        .filter(function (i) { return i >= 0; });
      return own.length ? [0, 1, 2].map(function (axis) {
        return own.reduce(function (sum, i) { return sum + gear.at[3 * i + axis]; }, 0) / own.length;
      }) : null;
    }
    found.towing = middle_of('moved') || middle_of('fixed');
    return found;
  };

  // Returns bounding boxes {low, high} over all times: of the whole gear, of its netting with
  // adjacent components, and of both with the otter boards. The last two are null without netting.
  gear.ranges = function () {
    function of(chosen, source) {
      var low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
      chosen.forEach(function (i) {
        for (var axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis], source.low[3 * i + axis]);
          high[axis] = Math.max(high[axis], source.low[3 * i + axis] + source.size[3 * i + axis]);
        }
      });
      return low[0] <= high[0] ? { low: low, high: high } : null;
    }
    function join(a, b) {
      if (!a || !b) return a || b;
      return {
        low: a.low.map(function (v, k) { return Math.min(v, b.low[k]); }),
        high: a.high.map(function (v, k) { return Math.max(v, b.high[k]); })
      };
    }
    var all = Array.from({ length: gear.points.length / 3 }, function (_, i) { return i; });
    var marks = gear.marks.map(function (_, i) { return i; });
    var net = of(Array.from(new Set(gear.netting.point)), gear.source.points);
    // Components within a sixth of the net's size belong to the net, such as the shoes of a beam.
    var near = net && Math.max.apply(null, net.high.map(function (v, k) { return v - net.low[k]; })) / 6;
    var beside = marks.filter(function (i) {
      var one = net && of([i], gear.source.places);
      return one && [0, 1, 2].every(function (k) {
        return one.low[k] > net.low[k] - near && one.high[k] < net.high[k] + near;
      });
    });
    var boards = marks.filter(function (i) { return told.marks.role[i] === 'otter_board'; });
    net = join(net, of(beside, gear.source.places));
    return {
      whole: join(of(all, gear.source.points), of(marks, gear.source.places)),
      net: net, boards: net && join(net, of(boards, gear.source.places))
    };
  };

  return gear;
};
