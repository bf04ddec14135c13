// The catch of a shared page: what of the netting around it lies behind its front, as R's
// R/lattice-catch.R has it, and where the front lies that encloses a volume (R/settle-catch.R).
//
// codendCatch(of, page): of.array(name) gives an array as it is filled now. It has weights() (of the
// pressure at the triangles' corners, for the front as it is), blocked(), set(front), volume(points)
// and surface(points).
function codendCatch(of, page) {
  'use strict';
  var node = of.array(page.node), triangles = node.length / 3, blocked = page.blocked;

  // Meshes from the front back.
  function inside() {
    var depth = of.array('page/catch.depth'), most = 0, k;
    for (k = 0; k < depth.length; k++) most = Math.max(most, depth[k]);
    var out = new Float64Array(depth.length);
    for (k = 0; k < depth.length; k++) {
      out[k] = blocked - depth[k];
      if (Math.abs(out[k]) < 1e-9 * most) out[k] = 0;
    }
    return out;
  }

  // The parts of triangles behind the front, cut into triangles: {triangle, share, corner: three
  // times weights of the triangle's corners, front: whether each lies on the front}.
  function pieces() {
    var at = inside(), out = [];
    function corner(t, from, to) {
      var w = [0, 0, 0];
      if (from === to) { w[from] = 1; return w; }
      var p = at[3 * t + from], q = at[3 * t + to], s = p / (p - q);
      w[from] = 1 - s;
      w[to] = s;
      return w;
    }
    function add(t, from, to) {
      var c = [0, 1, 2].map(function (k) { return corner(t, from[k], to[k]); });
      var share = Math.abs(c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) +
        c[0][1] * (c[1][2] * c[2][0] - c[1][0] * c[2][2]) +
        c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]));
      out.push({
        triangle: t, share: share, corner: c,
        front: [0, 1, 2].map(function (k) { return from[k] !== to[k] || at[3 * t + from[k]] === 0; })
      });
    }
    for (var t = 0; t < triangles; t++) {
      var v = [at[3 * t], at[3 * t + 1], at[3 * t + 2]];
      if (v[0] >= 0 && v[1] >= 0 && v[2] >= 0) { add(t, [0, 1, 2], [0, 1, 2]); continue; }
      for (var k = 0; k < 3; k++) {
        var l = (k + 1) % 3, m = (k + 2) % 3;
        if (v[k] > 0 && v[l] < 0 && v[m] < 0) add(t, [k, k, k], [k, l, m]);
        if (v[k] < 0 && v[l] >= 0 && v[m] >= 0) {
          add(t, [l, m, k], [l, m, l]);
          add(t, [m, k, k], [m, m, l]);
        }
      }
    }
    return out;
  }

  function weights() {
    var out = new Float64Array(3 * triangles), held = of.array('page/catch.weight');
    pieces().forEach(function (p) {
      for (var c = 0; c < 3; c++) {
        out[3 * p.triangle + c] += held[p.triangle] * p.share / 3 *
          (p.corner[0][c] + p.corner[1][c] + p.corner[2][c]);
      }
    });
    return out;
  }

  function place(points, p, k) {
    var out = [0, 0, 0];
    for (var n = 0; n < 3; n++) {
      for (var c = 0; c < 3; c++) {
        out[c] += p.corner[k][n] * points[3 * node[3 * p.triangle + n] + c];
      }
    }
    return out;
  }
  function minus(p, q) { return [p[0] - q[0], p[1] - q[1], p[2] - q[2]]; }
  function cross(p, q) {
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  }
  function dot(p, q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
  function size(c) {
    var n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    return Math.sqrt(dot(n, n)) / 2;
  }
  function corners(points, p) { return [0, 1, 2].map(function (k) { return place(points, p, k); }); }

  function surface(points) {
    var real = of.array('page/catch.real'), total = 0;
    pieces().forEach(function (p) { total += size(corners(points, p)) * real[p.triangle]; });
    return total;
  }

  function volume(points) {
    var weight = of.array('page/catch.weight'), all = pieces(), middle = [0, 0, 0], edge = 0;
    var found = all.map(function (p) { return corners(points, p); });
    [0, 1, 2].forEach(function (k) {
      all.forEach(function (p, i) {
        if (!p.front[k]) return;
        edge += 1;
        for (var c = 0; c < 3; c++) middle[c] += found[i][k][c];
      });
    });
    middle = middle.map(function (v) { return v / edge; });
    var total = 0;
    all.forEach(function (p, i) {
      var c = found[i];
      total += dot(minus(c[0], middle), cross(minus(c[1], middle), minus(c[2], middle))) / 6 *
        weight[p.triangle];
    });
    return total + bulge(points, all, found);
  }

  // Between flat pieces and netting that is curved lengthwise; see R's bulge_volume().
  function bulge(points, all, found) {
    var weight = of.array('page/catch.weight'), real = of.array('page/catch.real');
    var depth = of.array('page/catch.depth'), across = of.array('page/catch.across');
    var normal = {}, size_of = {}, form = new Float64Array(triangles), t, k;
    function at(t, k) {
      var n = 3 * node[3 * t + k];
      return [points[n], points[n + 1], points[n + 2]];
    }
    for (t = 0; t < triangles; t++) {
      var sign = Math.sign(weight[t]) * real[t];
      var out = cross(minus(at(t, 1), at(t, 0)), minus(at(t, 2), at(t, 0))).map(function (v) {
        return v * sign;
      });
      for (k = 0; k < 3; k++) {
        var n = node[3 * t + k], now = normal[n] = normal[n] || [0, 0, 0];
        for (var c = 0; c < 3; c++) now[c] += out[c];
        size_of[n] = (size_of[n] || 0) + Math.sqrt(dot(out, out));
      }
    }
    var tip = {};
    Object.keys(normal).forEach(function (n) {
      var long = Math.sqrt(dot(normal[n], normal[n]));
      tip[n] = long < 0.8 * size_of[n];
      normal[n] = normal[n].map(function (v) { return v / long; });
    });
    for (t = 0; t < triangles; t++) {
      var nodes = [0, 1, 2].map(function (k) { return node[3 * t + k]; });
      if (nodes.some(function (n) { return tip[n]; })) continue;
      var bend = function (i, j) {
        return dot(minus(normal[nodes[j]], normal[nodes[i]]), minus(at(t, j), at(t, i)));
      };
      var first = bend(0, 1), second = bend(0, 2), mixed = (first + second - bend(1, 2)) / 2;
      var step = function (x, k) { return x[3 * t + k] - x[3 * t]; };
      var twice = step(depth, 1) * step(across, 2) - step(depth, 2) * step(across, 1);
      var p = step(across, 2) / twice, q = -step(across, 1) / twice;
      var lengthwise = p * p * first + q * q * second + 2 * p * q * mixed;
      if (isFinite(lengthwise)) form[t] = lengthwise;
    }
    var total = 0;
    all.forEach(function (p, i) {
      var t = p.triangle, d = p.corner.map(function (w) {
        return w[0] * depth[3 * t] + w[1] * depth[3 * t + 1] + w[2] * depth[3 * t + 2];
      });
      var sides = Math.pow(d[1] - d[0], 2) + Math.pow(d[2] - d[1], 2) + Math.pow(d[0] - d[2], 2);
      total += size(found[i]) * real[t] * form[t] * sides;
    });
    return total / 24 / 2;
  }

  return {
    weights: weights, volume: volume, surface: surface, blocked: function () { return blocked; },
    set: function (front) { blocked = front; }
  };
}
if (typeof module !== 'undefined') module.exports = codendCatch;
