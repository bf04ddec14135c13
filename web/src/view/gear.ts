import * as T from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import Delaunator from 'delaunator';
import { shapes_once, type ShapeName } from './bodies';
import { floats, integers, places, values, type PlaceSource, type ValueSource } from './decode';
import { rgb, type Materials } from './materials';
import { join, type Mode, type Panel, type Range, type Scale, type Scene } from './scene';

interface Body { geometry: T.BufferGeometry; colour: number[]; from: number; matrix: T.Matrix4 }
interface Vessel { marks: number[]; hull: Body; house: Body; mast: Body; gallows: Body; at: number[] }
// inputs of the shader of ropes
type TubeInput = 'from' | 'to' | 'wayFrom' | 'wayTo' | 'colour' | 'about';
interface Tubes {
  ends: Int32Array; part: Int32Array; geometry: T.BufferGeometry; values: Record<TubeInput, Float32Array>;
  // Copies values to the buffers.
  tell(names: TubeInput[]): void;
}
// Netting that is drawn, by triangle.
interface Netting {
  point: Int32Array; mesh: Float32Array; drawn: Float32Array; at: Int32Array; part: number[]; scale: number[];
  full: number[]; spot: Int32Array; u: Float32Array; v: Float32Array; geometry: T.BufferGeometry;
  alike: { triangles: number[]; bars: number; length: number; scale: number }[];
  gap: T.BufferAttribute; position: T.BufferAttribute; normal: T.BufferAttribute; colourU: T.BufferAttribute;
  colourV: T.BufferAttribute; about: T.BufferAttribute;
}

export interface Gear {
  scene: T.Scene; told: Scene; source: { points: PlaceSource; places: PlaceSource; boards: PlaceSource };
  values: Record<'rope_tension' | 'u' | 'v' | 'drag', ValueSource> & Record<'opening' | 'angle', ValueSource | null>;
  stops: { rope: number[][]; netting: number[][] };
  // names of the parts that the user has chosen
  chosen: Set<string>;
  points: Float32Array; at: Float32Array; corners: Float32Array; moment: number;
  ropes: Tubes; netting: Netting; rope_tension: Float32Array; drag: Float32Array;
  marks: { body: Body; shape: ShapeName; least: number; half: number }[]; vessels: Vessel[];
  bodies: { geometry: T.BufferGeometry; all: Body[] } & Record<'colour' | 'position' | 'normal', T.BufferAttribute>;
  range: { whole: Range; net: Range | null; boards: Range | null };
  // Places components; size returns metres per pixel at a position.
  place_marks(size: (place: T.Vector3) => number): void;
  take(part: Partial<Scene>): void;
  move(k: number, share: number): void;
  slack_colour(mode: Mode): string;
  colour(mode: Mode): void;
  meshes(t: number): { opening: number; angle: number };
  places_to_align(): { bosom?: number[] | null; towing?: number[] | null };
  ranges(): Gear['range'];
}

// A gear in the viewer: reads the numbers of a scene and updates its drawn shapes.
export function new_gear(materials: Materials): Gear {
  const taut = rgb('#5F7482'), quiet = rgb('#4A545C'), chosen = rgb('#FF2D95');
  const told = {} as Scene, gear = { scene: new T.Scene(), told, chosen: new Set() } as unknown as Gear;

  // ---- geometry ---------------------------------------------------------------------------------

  // Returns the triangles of all panels. Corners have a node, mesh coordinates and drawn
  // coordinates. Triangles have three indices of values (of cells or points of clouds), a part, and
  // the number of mesh coordinates per drawn coordinate.
  function surfaces(panels: Panel[]) {
    const points: number[] = [], mesh: number[] = [], drawn: number[] = [], at: number[] = [], part: number[] = [];
    const scale: number[] = [], full: number[] = [], front: { ends: number[]; like: number }[] = [];
    let base = 0;
    // Returns 1 if a triangle encloses the catch, else 0. Stores the edges at its front.
    function filled(panel: Panel, point: Int32Array, uv: Float32Array, corners: number[]) {
      const { full, down } = panel;
      if (typeof full !== 'number') return 0;
      const beyond = corners.map((corner) => down[0] * uv[2 * corner] + down[1] * uv[2 * corner + 1] - full);
      const low = Math.min.apply(null, beyond), half = (Math.max.apply(null, beyond) - low) / 2;
      if (low + half < 0) return 0;
      const edge = corners.filter((_, k) => low < half && beyond[k] < low + half / 2);
      if (edge.length === 2) front.push({ ends: edge.map((k) => point[k]), like: at.length / 3 - 1 });
      return 1;
    }
    panels.forEach((panel) => {
      const point = integers(panel.point), uv = floats(panel.mesh);
      function add(a: number, b: number, c: number, va: number, vb: number, vc: number) {
        const area = (uv[2 * b] - uv[2 * a]) * (uv[2 * c + 1] - uv[2 * a + 1]) -
          (uv[2 * c] - uv[2 * a]) * (uv[2 * b + 1] - uv[2 * a + 1]);
        if (Math.abs(area) < 1e-6) return;
        [a, b, c].forEach((corner) => {
          points.push(point[corner]);
          mesh.push(uv[2 * corner], uv[2 * corner + 1]);
          for (let k = 0; k < 2; k++) drawn.push(uv[2 * corner + k] / panel.scale + panel.offset[k]);
        });
        at.push(base + va, base + vb, base + vc);
        part.push(panel.part);
        scale.push(panel.scale);
        full.push(filled(panel, point, uv, [a, b, c]));
      }
      const columns = panel.columns, rows = panel.rows;
      if (!columns) {
        const found = new Delaunator(uv).triangles;
        for (let t = 0; t < found.length; t += 3) {
          add(found[t], found[t + 1], found[t + 2], found[t], found[t + 1], found[t + 2]);
        }
        base += point.length;
        return;
      }
      for (let r = 0; r + 1 < rows; r++) {
        for (let c = 0; c + 1 < columns; c++) {
          const a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
          const cell = r * (columns - 1) + c;
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
    front.forEach((edge) => {
      points.push(front[0].ends[0], edge.ends[0], edge.ends[1]);
      mesh.push(0.2, 0.2, 0.4, 0.3, 0.3, 0.4);
      drawn.push(0.2, 0.2, 0.4, 0.3, 0.3, 0.4);
      scale.push(1);
      for (let c = 0; c < 3; c++) at.push(at[3 * edge.like + c]);
      part.push(part[edge.like]);
      full.push(1);
    });
    return {
      point: Int32Array.from(points), mesh: Float32Array.from(mesh), drawn: Float32Array.from(drawn),
      at: Int32Array.from(at), part: Int32Array.from(part), scale, full, spot: spots(points, part)
    };
  }

  // Returns the number of bars of one family in a triangle.
  function bars_in(mesh: Float32Array, t: number) {
    const a = 6 * t;
    return Math.abs((mesh[a + 2] - mesh[a]) * (mesh[a + 5] - mesh[a + 1]) -
      (mesh[a + 4] - mesh[a]) * (mesh[a + 3] - mesh[a + 1])) / 2;
  }

  // Returns a number for every corner. Corners at one node of one part share a number.
  function spots(points: number[], part: number[]) {
    const known = new Map();
    return Int32Array.from(points, (point, corner) => {
      const key = point * 65536 + part[Math.floor(corner / 3)];
      if (!known.has(key)) known.set(key, known.size);
      return known.get(key);
    });
  }

  function attribute(geometry: T.BufferGeometry, name: string, size: number, count: number) {
    const made = new T.BufferAttribute(new Float32Array(size * count), size);
    geometry.setAttribute(name, made);
    return made;
  }

  // Builds the tubes of ropes in one buffer, because software renderers draw instances one by one.
  // `values` contains the shader inputs of each line by name.
  function tubes_of(ends: Int32Array, part: Int32Array, thickness: number[]): Tubes {
    const lines = ends.length / 2, tube = new T.CylinderGeometry(1, 1, 1, 8, 1, true);
    tube.rotateX(Math.PI / 2);
    tube.translate(0, 0, 0.5);
    const corners = tube.getAttribute('position').count;
    const made = lines ? mergeGeometries(Array.from({ length: lines }, () => tube)) : new T.BufferGeometry();
    const values = {} as Record<TubeInput, Float32Array>, read = {} as Record<TubeInput, T.BufferAttribute>;
    for (const name of ['from', 'to', 'wayFrom', 'wayTo', 'colour', 'about'] as const) {
      read[name] = attribute(made, name, 3, corners * lines);
      values[name] = new Float32Array(3 * lines);
    }
    for (let k = 0; k < lines; k++) values.about[3 * k] = thickness[part[k]] / 2;
    function tell(names: TubeInput[]) {
      names.forEach((name) => {
        const value = values[name], out = read[name].array;
        for (let from = 0, to = 0; from < value.length; from += 3) {
          for (let c = 0; c < corners; c++) {
            out[to++] = value[from];
            out[to++] = value[from + 1];
            out[to++] = value[from + 2];
          }
        }
        read[name].needsUpdate = true;
      });
    }
    return { ends, part, geometry: made, values, tell };
  }

  function lay_out() {
    if (gear.netting) {
      gear.netting.geometry.dispose();
      gear.ropes.geometry.dispose();
    }
    gear.scene.clear();
    const made = surfaces(told.netting || []) as unknown as Netting, n = made.part.length, parts = told.parts;
    const geometry = new T.BufferGeometry();
    geometry.setAttribute('mesh', new T.BufferAttribute(made.mesh, 2));
    geometry.setAttribute('drawn', new T.BufferAttribute(made.drawn, 2));
    made.gap = attribute(geometry, 'gap', 2, 3 * n);
    const alike = new Map<string, Netting['alike'][number]>();
    made.position = attribute(geometry, 'position', 3, 3 * n);
    made.normal = attribute(geometry, 'normal', 3, 3 * n);
    made.colourU = attribute(geometry, 'colourU', 3, 3 * n);
    made.colourV = attribute(geometry, 'colourV', 3, 3 * n);
    made.about = attribute(geometry, 'about', 3, 3 * n);
    for (let t = 0; t < n; t++) {
      const bar = Math.max(parts.bar[made.part[t]], 1e-9), thick = parts.thickness[made.part[t]] / bar;
      for (let c = 0; c < 3; c++) {
        made.about.array[9 * t + 3 * c] = Math.min(thick, 0.5) + made.full[t];
      }
      // Groups triangles with the same bar length and scale.
      const key = bar.toPrecision(3) + ' ' + made.scale[t].toPrecision(3);
      const own = alike.get(key) || { triangles: [], bars: 0, length: bar, scale: made.scale[t] };
      alike.set(key, own);
      own.triangles.push(t);
      own.bars += bars_in(made.mesh, t);
    }
    made.alike = Array.from(alike.values());
    made.geometry = geometry;
    made.u = new Float32Array(n);
    made.v = new Float32Array(n);
    gear.netting = made;
    [materials.nettingCore, materials.nettingEdge].forEach((material, k) => {
      const mesh = new T.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 2 * k;
      gear.scene.add(mesh);
    });

    gear.ropes = tubes_of(integers(told.ropes.ends), integers(told.ropes.part), parts.thickness);
    const rope = gear.ropes.geometry;
    const tubes = new T.Mesh(rope, materials.rope);
    tubes.frustumCulled = false;
    gear.scene.add(tubes);
    lay_out_marks();
  }

  // ---- components -------------------------------------------------------------------------------

  // Shape of each role, and its minimum half size (pixels).
  const roles: Record<string, [ShapeName, number]> = {
    otter_board: ['plate', 7], kite: ['cloth', 6], canvas: ['cloth', 6], float: ['float', 2.6],
    hammer: ['clump', 5], weight: ['sinker', 4.5], sinker: ['sinker', 1.6], catch: ['bag', 4],
    ring: ['ring', 2.6], hook: ['hook', 1.8], fixed: ['anchor', 4.5], moved: ['ball', 2.6],
    shoe_end: ['runner', 2.6]
  };

  // All components and vessels share one buffer, because one draw call is faster than many. Every gear
  // has a support.
  function lay_out_marks() {
    const made = shapes_once(), marks = told.marks, bodies: Body[] = [];
    let corners = 0;
    function body(shape: ShapeName, colour: string) {
      const geometry = made[shape];
      if (!geometry.index) {
        geometry.setIndex(Array.from({ length: geometry.getAttribute('position').count },
          (_, i) => i));
      }
      const one: Body = { geometry, colour: rgb(colour), from: corners, matrix: new T.Matrix4() };
      corners += geometry.getAttribute('position').count;
      bodies.push(one);
      return one;
    }
    gear.marks = marks.role.map((role, i) => {
      const known = roles[role] || ['ball', 3];
      return { body: body(known[0], marks.fill[i]), shape: known[0], least: known[1], half: 0 };
    });
    gear.vessels = (told.vessels || []).map((own) => ({
      marks: own, hull: body('hull', '#24506E'), house: body('box', '#6B7780'),
      mast: body('box', '#39434B'), gallows: body('box', '#39434B'), at: []
    }));
    if (gear.bodies) gear.bodies.geometry.dispose();
    const geometry = mergeGeometries(bodies.map((one) => one.geometry));
    const colour = attribute(geometry, 'colour', 3, corners), of = (name: string) =>
      geometry.getAttribute(name) as T.BufferAttribute;
    gear.bodies = { geometry, all: bodies, colour, position: of('position'), normal: of('normal') };
    bodies.forEach((one) => fill(one, one.colour));
    const mesh = new T.Mesh(geometry, materials.solid);
    mesh.frustumCulled = false;
    gear.scene.add(mesh);
  }
  function fill(body: Body, colour: number[]) {
    const count = body.geometry.getAttribute('position').count;
    for (let c = 0; c < count; c++) gear.bodies.colour.array.set(colour, 3 * (body.from + c));
  }

  // Applies the matrix of each body to its vertices.
  function place_bodies() {
    const position = gear.bodies.position, normal = gear.bodies.normal;
    gear.bodies.all.forEach((one) => {
      const m = one.matrix.elements, p = one.geometry.getAttribute('position').array;
      const n = one.geometry.getAttribute('normal').array;
      let to = 3 * one.from;
      for (let i = 0; i < p.length; i += 3, to += 3) {
        for (let k = 0; k < 3; k++) {
          position.array[to + k] = m[k] * p[i] + m[4 + k] * p[i + 1] + m[8 + k] * p[i + 2] + m[12 + k];
          normal.array[to + k] = m[k] * n[i] + m[4 + k] * n[i + 1] + m[8 + k] * n[i + 2];
        }
      }
    });
    position.needsUpdate = normal.needsUpdate = true;
  }

  // Returns two directions in the plate of a component without an attitude of its own. Plates with
  // sideways lift are upright, at 30 degrees to the flow. Others lie across it, at 45 degrees.
  function symbolPlate(way: string) {
    const c = Math.cos(Math.PI / 6), h = Math.SQRT1_2;
    return [
      way === 'port' ? [c, 0.5, 0] : way === 'starboard' ? [c, -0.5, 0] : [0, 1, 0],
      way === 'down' ? [h, 0, h] : way === 'port' || way === 'starboard' ? [0, 0, 1] : [-h, 0, h]
    ];
  }

  // size: function of a position that returns metres per pixel.
  gear.place_marks = (size) => {
    const at = gear.at, boards = gear.corners, marks = told.marks;
    const x = new T.Vector3(), y = new T.Vector3(), z = new T.Vector3(), m = new T.Vector3();
    gear.marks.forEach((mark, i) => {
      m.set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
      const least = mark.least * size(m);
      let half;
      if (mark.shape === 'plate' || mark.shape === 'cloth') {
        if (marks.board[i] >= 0) {
          const c = [0, 1, 2, 3].map((k) => {
            const from = 3 * (4 * marks.board[i] + k);
            return new T.Vector3(boards[from], boards[from + 1], boards[from + 2]);
          });
          x.copy(c[2]).add(c[3]).sub(c[0]).sub(c[1]).multiplyScalar(0.5);
          y.copy(c[1]).add(c[2]).sub(c[0]).sub(c[3]).multiplyScalar(0.5);
          m.copy(c[0]).add(c[1]).add(c[2]).add(c[3]).multiplyScalar(0.25);
        } else {
          const sides = symbolPlate(marks.direction[i]);
          half = Math.max(marks.size[i], 1e-3);
          x.fromArray(sides[0]).multiplyScalar(half);
          y.fromArray(sides[1]).multiplyScalar(half);
        }
        const grow = Math.max(1, 2 * least / Math.max(Math.min(x.length(), y.length()), 1e-9));
        x.multiplyScalar(grow);
        y.multiplyScalar(grow);
        z.crossVectors(x, y).normalize().multiplyScalar(x.length());
        // The hollow side faces the flow.
        const out = { port: [0, -1, 0], starboard: [0, 1, 0], down: [0, 0, -1] }[marks.direction[i]];
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
    gear.vessels.forEach((vessel) => {
      const low = new T.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
      vessel.marks.forEach((i) => {
        m.set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        low.min(m);
        high.max(m);
      });
      m.addVectors(low, high).multiplyScalar(0.5);
      const spread = high.y - low.y, length = Math.max(Math.min(Math.max(3.6 * spread, 16), 60),
        20 * size(m));
      vessel.at = [m.x - length / 2, m.y, 0, length];
      function box(body: Body, ahead: number, across: number, foot: number, long: number, wide: number, high_: number) {
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
  gear.take = (part) => {
    // Another gear may have no netting.
    if (part.ropes) told.opening = told.angle = null;
    Object.assign(told, part);
    gear.source = {
      points: places(told.points), places: places(told.places), boards: places(told.boards)
    };
    gear.values = {
      rope_tension: values(told.rope_tension) as ValueSource, u: values(told.u) as ValueSource,
      v: values(told.v) as ValueSource, drag: values(told.drag) as ValueSource, opening: values(told.opening),
      angle: values(told.angle)
    };
    gear.stops = { rope: told.colours.rope.map(rgb), netting: told.colours.netting.map(rgb) };
    if (part.ropes || part.netting || part.parts || !gear.netting) lay_out();
    gear.move(0, 0);
  };

  // Moves the gear to the fraction `share` between stored time k and the next.
  gear.move = (k, share) => {
    const p = gear.points = gear.source.points.of(k, share);
    gear.at = gear.source.places.of(k, share);
    gear.corners = gear.source.boards.of(k, share);
    gear.moment = share < 0.5 ? k : k + 1;
    const net = gear.netting, n = net.part.length, normal = new Float32Array(p.length);
    const area = new Float64Array(n);
    for (let t = 0; t < n; t++) {
      const a = 3 * net.point[3 * t], b = 3 * net.point[3 * t + 1], c = 3 * net.point[3 * t + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      area[t] = Math.hypot(x, y, z) / 2;
      [a, b, c].forEach((at, corner) => {
        net.position.array[9 * t + 3 * corner] = p[at];
        net.position.array[9 * t + 3 * corner + 1] = p[at + 1];
        net.position.array[9 * t + 3 * corner + 2] = p[at + 2];
        // Panels may meet with opposite normals; the first one determines the sign.
        const sign = normal[at] * x + normal[at + 1] * y + normal[at + 2] * z < 0 ? -1 : 1;
        normal[at] += sign * x;
        normal[at + 1] += sign * y;
        normal[at + 2] += sign * z;
      });
    }
    for (let i = 0; i < 3 * n; i++) {
      const from = 3 * net.point[i];
      for (let axis = 0; axis < 3; axis++) net.normal.array[3 * i + axis] = normal[from + axis];
    }
    net.position.needsUpdate = net.normal.needsUpdate = true;
    // Twines are closer together in less open meshes.
    net.alike.forEach((one) => {
      const all = one.triangles.reduce((sum, t) => sum + area[t], 0);
      const gap = Math.max(all / Math.max(one.bars * one.length, 1e-12), 0.05 * one.length);
      one.triangles.forEach((t) => {
        for (let c = 0; c < 3; c++) net.gap.array.set([gap, one.scale * gap], 6 * t + 2 * c);
      });
    });
    net.gap.needsUpdate = true;

    const ends = gear.ropes.ends, lines = ends.length / 2;
    let along = 0;
    const rope = gear.ropes.values;
    function set(values: Float32Array, line: number, x: number, y: number, z: number) {
      values[3 * line] = x;
      values[3 * line + 1] = y;
      values[3 * line + 2] = z;
    }
    for (let l = 0; l < lines; l++) {
      const f = 3 * ends[2 * l], e = 3 * ends[2 * l + 1];
      let dx = p[e] - p[f], dy = p[e + 1] - p[f + 1], dz = p[e + 2] - p[f + 2];
      const long = Math.hypot(dx, dy, dz) || 1;
      set(rope.from, l, p[f], p[f + 1], p[f + 2]);
      set(rope.to, l, p[e], p[e + 1], p[e + 2]);
      dx /= long; dy /= long; dz /= long;
      set(rope.wayFrom, l, dx, dy, dz);
      set(rope.wayTo, l, dx, dy, dz);
      const joined = l > 0 && ends[2 * l - 1] === ends[2 * l];
      if (joined) {
        // Neighbours share their direction at the joint, unless the rope turns sharply there.
        const w = rope.wayTo, at3 = 3 * (l - 1);
        const sx = w[at3] + dx, sy = w[at3 + 1] + dy, sz = w[at3 + 2] + dz;
        const sum = Math.hypot(sx, sy, sz);
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

  function shareOn(scale: Scale, value: number) {
    const low = scale.limits[0], high = scale.limits[1], x = Math.max(value, low);
    const share = scale.log ? Math.log(x / low) / Math.log(high / low) : (x - low) / (high - low);
    return Math.min(Math.max(share, 0), 1);
  }

  function paint(stops: number[][], share: number, out: Float32Array | number[], at: number) {
    const place = share * (stops.length - 1), k = Math.min(Math.floor(place), stops.length - 2);
    const f = place - k, a = stops[k], b = stops[k + 1];
    for (let c = 0; c < 3; c++) out[at + c] = a[c] + f * (b[c] - a[c]);
  }
  function put(colour: number[], out: Float32Array | number[], at: number) {
    for (let c = 0; c < 3; c++) out[at + c] = colour[c];
  }

  // Slack twine is muted if the colours show another quantity.
  gear.slack_colour = (mode) => mode === 'slack' ? told.colours.slack : told.colours.slack_muted;

  // Updates the colours. mode: tension, slack, mesh_opening, mesh_angle or drag.
  gear.colour = (mode) => {
    const k = gear.moment;
    const scales = told.scales[mode] || {}, ropes = gear.ropes, net = gear.netting;
    const shows = mode === 'tension' || mode === 'slack', loose = rgb(gear.slack_colour(mode));
    const marked = told.parts.name.map((name) => gear.chosen.has(name));
    const tension = gear.rope_tension = gear.values.rope_tension.of(k);
    const drag = gear.drag = gear.values.drag.of(k);
    for (let l = 0; l < ropes.part.length; l++) {
      const value = mode === 'drag' ? drag[ropes.part[l]] : tension[l], out = ropes.values.colour;
      // Seams have the colours of netting.
      const of = told.parts.kind[ropes.part[l]] === 'netting' ? 'netting' : 'rope';
      const slack = shows && tension[l] === 0;
      ropes.values.about[3 * l + 1] = (slack ? 1 : 0) + 2 * told.parts.form[ropes.part[l]];
      if (slack) put(loose, out, 3 * l);
      // Beams and struts in compression.
      else if (shows && tension[l] < 0) put(quiet, out, 3 * l);
      else if (mode === 'slack') put(taut, out, 3 * l);
      else if (!scales.rope || !scales[of]) put(quiet, out, 3 * l);
      else paint(gear.stops[of], shareOn(scales[of], value), out, 3 * l);
      if (marked[ropes.part[l]]) put(chosen, out, 3 * l);
    }
    gear.marks.forEach(({ body }, i) => fill(body, gear.chosen.has(told.marks.part[i]) ? chosen : body.colour));
    gear.bodies.colour.needsUpdate = true;
    ropes.tell(['colour', 'about']);

    const u = gear.values.u.of(k), v = gear.values.v.of(k);
    const source = mode === 'mesh_opening' ? gear.values.opening : mode === 'mesh_angle' ? gear.values.angle : null;
    const whole = source && source.of(k);
    // Returns the mean of the known positive values at three indices, or 0 if most are slack.
    function mean(all: Float32Array, t: number) {
      if (net.at[3 * t] === net.at[3 * t + 1]) return all[net.at[3 * t]];
      let sum = 0, known = 0, slack = 0;
      for (let c = 0; c < 3; c++) {
        const value = all[net.at[3 * t + c]];
        if (value !== value) continue;
        known++;
        if (value > 0) sum += value; else slack++;
      }
      return 2 * slack >= known ? 0 : sum / (known - slack);
    }
    for (let t = 0; t < net.part.length; t++) {
      net.u[t] = mean(u, t);
      net.v[t] = mean(v, t);
    }
    colour_family(net.u, net.colourU.array as Float32Array, 1);
    colour_family(net.v, net.colourV.array as Float32Array, 2);
    // Colours one family of twines. Each point has the mean of its adjacent triangles.
    function colour_family(tension: Float32Array, out: Float32Array, place: number) {
      const count = 1 + net.spot.reduce((most, spot) => Math.max(most, spot), -1);
      const number = new Float32Array(count), taut_ = new Float32Array(count), sum = new Float32Array(count);
      for (let c = 0; c < net.spot.length; c++) {
        const t = Math.floor(c / 3), spot = net.spot[c];
        number[spot] += 1;
        if (shows && tension[t] <= 0) continue;
        taut_[spot] += 1;
        if (scales.netting) {
          sum[spot] += shareOn(scales.netting, whole ? mean(whole, t) :
            mode === 'drag' ? drag[net.part[t]] : tension[t]);
        }
      }
      const colours = new Float32Array(3 * count), own = [0, 0, 0];
      for (let spot = 0; spot < count; spot++) {
        const slack = 1 - taut_[spot] / number[spot];
        if (mode === 'slack') put(taut, own, 0);
        else if (!scales.netting) put(quiet, own, 0);
        else paint(gear.stops.netting, sum[spot] / Math.max(taut_[spot], 1), own, 0);
        for (let k = 0; k < 3; k++) colours[3 * spot + k] = own[k] + slack * (loose[k] - own[k]);
      }
      for (let c = 0; c < net.spot.length; c++) {
        const spot = net.spot[c];
        const own = marked[net.part[Math.floor(c / 3)]];
        for (let k = 0; k < 3; k++) out[3 * c + k] = own ? chosen[k] : colours[3 * spot + k];
        // Only this mode shows slack as dashes.
        net.about.array[3 * c + place] = mode === 'slack' ? 1 - taut_[spot] / number[spot] : 0;
      }
    }
    net.colourU.needsUpdate = net.colourV.needsUpdate = net.about.needsUpdate = true;
  };

  // Returns the present opening (%) and angle (degrees) of the meshes in a triangle.
  gear.meshes = (t) => {
    function one(name: 'opening' | 'angle') {
      const all = gear.values[name];
      return all ? all.of(gear.moment)[gear.netting.at[3 * t]] : NaN;
    }
    return { opening: one('opening'), angle: one('angle') };
  };

  // Returns the present alignment points {bosom, towing}, each [x, y, z] or missing. The bosom is
  // the aftmost point of the headline; `towing` is the mean of the towing points.
  gear.places_to_align = () => {
    const found: ReturnType<Gear['places_to_align']> = {}, p = gear.points, ropes = gear.ropes, marks = told.marks;
    for (let l = 0; l < ropes.part.length; l++) {
      if (told.parts.role[ropes.part[l]] !== 'headline') continue;
      [2 * l, 2 * l + 1].forEach((end) => {
        const i = 3 * ropes.ends[end];
        if (!found.bosom || p[i] > found.bosom[0]) found.bosom = [p[i], p[i + 1], p[i + 2]];
      });
    }
    function middle_of(role: string): number[] | null {
      const own = marks.role.map((name, i) => name === role ? i : -1)
        .filter((i) => i >= 0);
      if (!own.length) return null;
      return [0, 1, 2].map((axis) => own.reduce((sum, i) => sum + gear.at[3 * i + axis], 0) / own.length);
    }
    found.towing = middle_of('moved') || middle_of('fixed');
    return found;
  };

  // Returns bounding boxes {low, high} over all times: of the whole gear, of its netting with
  // adjacent components, and of both with the otter boards. The last two are null without netting.
  gear.ranges = () => {
    function of(chosen: number[], source: PlaceSource): Range | null {
      const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
      chosen.forEach((i) => {
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis], source.low[3 * i + axis]);
          high[axis] = Math.max(high[axis], source.low[3 * i + axis] + source.size[3 * i + axis]);
        }
      });
      return low[0] <= high[0] ? { low, high } : null;
    }
    const all = Array.from({ length: gear.points.length / 3 }, (_, i) => i);
    const marks = gear.marks.map((_, i) => i);
    const own = of(Array.from(new Set(gear.netting.point)), gear.source.points);
    // Components within a sixth of the net's size belong to the net, such as the shoes of a beam.
    const near = own ? Math.max(...own.high.map((v, k) => v - own.low[k])) / 6 : 0;
    const beside = marks.filter((i) => {
      const one = own && of([i], gear.source.places);
      return one && [0, 1, 2].every((k) => one.low[k] > own.low[k] - near && one.high[k] < own.high[k] + near);
    });
    const boards = marks.filter((i) => told.marks.role[i] === 'otter_board');
    const net = join(own, of(beside, gear.source.places));
    return {
      whole: join(of(all, gear.source.points), of(marks, gear.source.places)) as Range,
      net, boards: net && join(net, of(boards, gear.source.places))
    };
  };

  return gear;
}
