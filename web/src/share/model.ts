// A gear in the engine: fills its numbers for the values of the sliders, settles and measures it.
// The worker of a shared page and tests in node use it.

import { array_reader, type Head, type NamedArray } from './arrays';

// The functions of tools/wasm/engine_page.cpp, as Emscripten compiles them. Addresses are numbers.
export interface Engine {
  HEAPU8: Uint8Array; HEAP32: Int32Array; HEAPF64: Float64Array;
  _malloc(bytes: number): number;
  _free(at: number): void;
  _codend_wholes(name: number, count: number): number;
  _codend_words(name: number, list: number, count: number): void;
  _codend_numbers(name: number, count: number): number;
  _codend_groups(name: number, count: number): void;
  _codend_count(name: number): number;
  _codend_found(name: number): number;
  _codend_settle(tolerance: number, steps: number): number;
  _codend_evaluate(): number;
  _codend_error(): number;
}

// Values are in the unit of the field in the plan.
export interface Field { paths: string[]; whole: boolean; value: number; lower: number; upper: number }
interface Meshes { panel: string; unit: string; means: { count: string; column: string; weight: string } }
interface Groups { element: string; group: string; weight: string; count: number; split: number }
// The description of a gear by R/share-model.R. Strings are names of arrays.
export interface SharedGear {
  head: Head; tolerance: number; steps: number; fields: Field[]; touched: string[];
  terms: { of: number[]; nodes: number[][]; index: string; change: string }[];
  order: { name: string; kind: string; size: number }[];
  names: string[]; boards: string[]; fallen_heel: number; knot: number;
  conditions: { waves: string; still: string; water: boolean };
  scene: {
    drawn: string; marks: number[][]; rope: Groups; u: Groups; v: Groups;
    meshes?: Meshes;
  };
}
export interface Moved {
  points: Float32Array<ArrayBuffer>; places: Float32Array<ArrayBuffer>; boards: Float32Array<ArrayBuffer>;
  drag: Float32Array<ArrayBuffer>; rope_tension: Float32Array<ArrayBuffer>; u: Float32Array<ArrayBuffer>;
  v: Float32Array<ArrayBuffer>; opening?: Float32Array<ArrayBuffer>; angle?: Float32Array<ArrayBuffer>;
}
export interface Shape {
  moved: Moved; measures: Record<string, number>; warnings: string[]; flow: number[]; conditions: string;
  values: number[]; steps: number;
}
export type Step = 'done' | 'more' | 'stuck';
export type Model = ReturnType<typeof new_model>;

// bytes: the arrays of the gear. Throws an error if the gear does not settle.
export function new_model(engine: Engine, page: SharedGear, bytes: Uint8Array) {
  const head = page.head, arrays: Record<string, NamedArray> = {}, decoder = new TextDecoder();

  // ---- arrays -----------------------------------------------------------------------------------

  const array = array_reader(head, bytes, arrays);
  const numbers = (name: string) => array(name) as Float64Array | Float32Array | Int32Array;

  function text<Result>(words: string, then: (at: number) => Result): Result {
    const raw = new TextEncoder().encode(words + '\0'), at = engine._malloc(raw.length);
    engine.HEAPU8.set(raw, at);
    try { return then(at); } finally { engine._free(at); }
  }
  function words_at(at: number) {
    let end = at;
    while (engine.HEAPU8[end]) end++;
    return decoder.decode(engine.HEAPU8.subarray(at, end));
  }
  function hand_over(name: string, values: NamedArray) {
    text(name, (at) => {
      if (values instanceof Int32Array) {
        const to = engine._codend_wholes(at, values.length);
        engine.HEAP32.set(values, to >> 2);
      } else if (Array.isArray(values)) {
        text(values.join('\n'), (list) => { engine._codend_words(at, list, values.length); });
      } else {
        const place = engine._codend_numbers(at, values.length);
        engine.HEAPF64.set(values, place >> 3);
      }
    });
  }
  function found(name: string) {
    return text(name, (at) => {
      const count = engine._codend_count(at);
      if (count < 0) throw new Error('The engine does not know ' + name);
      const from = engine._codend_found(at) >> 3;
      return engine.HEAPF64.slice(from, from + count);
    });
  }
  function checked(result: number) {
    if (result < 0) throw new Error(words_at(engine._codend_error()));
    return result;
  }

  // ---- filling and settling ---------------------------------------------------------------------

  const fields = page.fields;
  let good: number[] | null = null;
  // Returns the settled values of the sliders.
  function settled(): number[] { return (good ?? []).slice(); }
  const base: number[] = [];
  // The arrays that sliders change, concatenated.
  page.touched.forEach((name) => { base.push(...numbers(name)); });

  // Returns the weights of the changes at all nodes of a term's sliders: Lagrange's polynomials. The
  // first slider varies fastest.
  function node_weights(term: SharedGear['terms'][number], values: number[]): number[] {
    return term.of.reduce((before, f, s) => {
      const nodes = term.nodes[s], out: number[] = [];
      nodes.forEach((node) => {
        let weight = 1;
        nodes.forEach((other) => { if (other !== node) weight *= (values[f] - other) / (node - other); });
        before.forEach((product) => { out.push(product * weight); });
      });
      return out;
    }, [1]);
  }
  function fill(values: number[]) {
    const x = Float64Array.from(base);
    let at = 0;
    page.terms.forEach((term) => {
      const index = numbers(term.index), change = numbers(term.change), n = index.length;
      node_weights(term, values).forEach((weight, c) => {
        for (let k = 0; k < n; k++) x[index[k]] += change[n * c + k] * weight;
      });
    });
    page.touched.forEach((name) => {
      const from = at;
      at += numbers(name).length;
      arrays[name] = x.subarray(from, at);
      hand_over(name, arrays[name]);
    });
  }
  // Returns false if the gear does not settle, and restores the last settled values.
  function settle_at(values: number[]) {
    fill(values);
    if (checked(engine._codend_settle(page.tolerance, page.steps)) === 1) {
      good = values.slice();
      return true;
    }
    if (good) fill(good);
    return false;
  }

  // Largest step of all sliders together, in slider ranges; maximum number of halvings of a step.
  const most_way = 0.5, most_halved = 4;

  // Returns a function that settles one step towards `values` per call. It returns 'done', 'more'
  // or 'stuck' (the gear stays at its last settled values).
  function walk(values: number[]): () => Step {
    const from = settled();
    let way = 0, part = 0;
    fields.forEach((field, k) => {
      way += Math.abs(values[k] - from[k]) / (field.upper - field.lower);
    });
    let size = 1 / Math.max(1, Math.ceil(way / most_way - 1e-9)), halved = 0;
    return () => {
      const next = part + size > 1 - 1e-9 ? 1 : part + size;
      const at = next === 1 ? values : from.map((v, k) => {
        const between = v + next * (values[k] - v);
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
  function group_means(groups: Groups, bars: Float64Array, cells: Float64Array | null, empty: number) {
    const element = numbers(groups.element), group = numbers(groups.group), n = groups.count;
    const weight = numbers(groups.weight), split = cells ? groups.split : element.length, into = new Float32Array(n);
    const total = new Float64Array(n), all = new Float64Array(n);
    for (let k = 0; k < element.length; k++) {
      const value = cells && k >= split ? cells[element[k]] : bars[element[k]];
      total[group[k]] += value * weight[k];
      all[group[k]] += weight[k];
    }
    for (let k = 0; k < n; k++) into[k] = all[k] ? total[k] / all[k] : empty;
    return into;
  }
  function mesh_means(m: Meshes, found: Float64Array, angles: boolean) {
    const panel = numbers(m.panel), unit = numbers(m.unit);
    const value = Array.from(found, (v, k) => {
      if (isNaN(v)) return 0;
      return angles ? v * 180 / Math.PI : 100 * v / unit[panel[k]];
    });
    const count = numbers(m.means.count), column = numbers(m.means.column), weight = numbers(m.means.weight);
    const out = new Float32Array(count.length);
    let at = 0, middle: number | null = null;
    for (let k = 0; k < count.length; k++) {
      if (!count[k]) {
        if (middle === null) middle = value.slice().sort((p, q) => p - q)[value.length >> 1];
        out[k] = middle;
        continue;
      }
      let total = 0;
      for (let t = 0; t < count[k]; t++, at++) total += weight[at] * value[column[at]];
      out[k] = Math.max(total, 1e-6);
    }
    return out;
  }

  function shape(): Shape {
    checked(engine._codend_evaluate());
    const bars = found('bar_tension'), at = found('points'), drag = new Float32Array(found('drag'));
    const values: Record<string, number> = {};
    found('measures').forEach((value, k) => { values[page.order[k].name] = value / page.order[k].size; });
    const scene = page.scene, drawn = numbers(scene.drawn), size = numbers('page/size');
    for (let k = 0; k < drag.length; k++) {
      drag[k] = size[k] > 0 ? Math.max(drag[k], 0) / Math.max(size[k], 1e-9) : 0;
    }
    const points = new Float32Array(3 * drawn.length), places = new Float32Array(3 * scene.marks.length);
    for (let k = 0; k < drawn.length; k++) {
      for (let c = 0; c < 3; c++) points[3 * k + c] = at[3 * drawn[k] + c];
    }
    scene.marks.forEach((nodes, k) => {
      nodes.forEach((n) => {
        for (let c = 0; c < 3; c++) places[3 * k + c] += at[3 * n + c] / nodes.length;
      });
    });
    const moved: Moved = {
      points, places, boards: new Float32Array(found('corners')), drag,
      rope_tension: group_means(scene.rope, bars, null, 0),
      u: group_means(scene.u, bars, found('u_tension'), NaN),
      v: group_means(scene.v, bars, found('v_tension'), NaN)
    };
    const flow = page.conditions.water ? Array.from(found('flow')) : [0, 0];
    if (scene.meshes) {
      moved.opening = mesh_means(scene.meshes, found('opening'), false);
      moved.angle = mesh_means(scene.meshes, found('angle'), true);
    }
    const report = found('report');
    return {
      moved, measures: values, warnings: warnings(report[1], values),
      flow, conditions: conditions(flow), values: settled(), steps: report[0]
    };
  }

  // Returns the warnings for the reader as strings.
  function warnings(unstable: number, values: Record<string, number>) {
    const out = [], degrees = 180 / Math.PI, plates = found('plates');
    if (unstable) out.push('The equilibrium is unstable: small disturbances grow.');
    (page.boards || []).forEach((board, k) => {
      const attack = plates[5 * k] * degrees, heel = plates[5 * k + 1] * degrees;
      const stall = numbers('page/stall')[k];
      const whole = (angle: number) => angle.toFixed(0) + ' deg';
      if (Math.abs(heel) > page.fallen_heel) out.push(`${board} has fallen over: it heels by ${whole(heel)}.`);
      else if (attack < 0) out.push(`${board} is back-winded: the flow hits its outer face, at ${whole(attack)}.`);
      else if (attack > stall) {
        out.push(`${board} is stalled: its angle of attack is ${whole(attack)}, but its lift is largest at ` +
          `${whole(stall)}.`);
      }
    });
    found('load').forEach((share, part) => {
      if (share > 1) out.push(page.names[part] + ' carries ' + (100 * share).toFixed(0) + ' % of its breaking load.');
    });
    page.order.forEach(({ name, kind, size }) => {
      if (kind === 'pull_used' && size * values[name] > 1) {
        out.push('The vessel cannot tow this gear so fast: it would take ' + (100 * size * values[name]).toFixed(0) +
          ' % of what it can pull.');
      }
    });
    return out;
  }

  function conditions(flow: ArrayLike<number>) {
    const speed = numbers('page/speed')[0], told = page.conditions, size = Math.hypot(flow[0], flow[1]);
    if (speed > 0) return 'towed at ' + Number((speed / page.knot).toFixed(2)) + ' knot' + told.waves;
    return size > 0 ? 'in a current of ' + size.toFixed(2) + ' m/s' + told.waves : told.still;
  }

  // ---- initialisation ---------------------------------------------------------------------------

  Object.keys(head).forEach((name) => {
    if (/^series\//.test(name)) return;
    if (head[name][0] === 'g') {
      text(name, (at) => { engine._codend_groups(at, head[name][1]); });
    } else {
      hand_over(name, array(name));
    }
  });
  if (!settle_at(fields.map((field) => field.value))) {
    throw new Error('The gear did not settle on this page.');
  }

  return {
    walk, shape,
    // for tests
    values: settled, memory: () => engine.HEAPU8.length
  };
}
