// The 3D viewer of codend's pages: one gear or several designs, settled or in motion. R/scene-gear.R
// makes scenes; gear.ts and materials.ts draw them. The axes are x aft, y to starboard, z up (m).

import { render } from 'preact';
import * as T from 'three';
import { element, file_name, say } from './element';
import { new_gear, type Gear } from './gear';
import { axes, dot, longest, middle, round, type Axes } from './geometry';
import { ColourBar } from './legend';
import { kept_colour, new_materials } from './materials';
import { motion_keys, new_motion, type Motion, type MotionOptions } from './motion';
import { listen_pointers } from './pointers';
import { new_saver } from './save';
import { join, type Mode, type Range, type Scene } from './scene';
import { described, three, type Found } from './tip';

export interface ViewerOptions extends MotionOptions {
  // true to show the gear's name over the picture
  title?: boolean;
  // false to omit the picture for printing
  still?: boolean;
  // returns true while another shape is expected
  passing?(): boolean;
}
export interface KeptScene { key: string | number; name: string; scene: Partial<Scene> }
type Corner = 'left' | 'right' | 'top' | 'bottom';
type Bed = NonNullable<Scene['bed']>;
interface Box { left: number; top: number; width: number; height: number; gear: Gear; name?: string }
interface Choice {
  focus: 'net' | 'whole' | 'boards'; from: string; compare: 'off' | 'over' | 'beside'; align: 'bosom' | 'towing';
  colour: Mode;
}
export type Viewer = NonNullable<ReturnType<typeof new_viewer>>;

// Fills the element `host`. Returns null without WebGL.
export function new_viewer(host: HTMLElement & { codendViewer?: unknown }, options: ViewerOptions = {}) {
  host.classList.add('codend-view');
  const canvas = element('canvas', 'view-canvas', undefined, { tabindex: '0', role: 'img' });
  host.appendChild(canvas);

  let renderer: T.WebGLRenderer;
  try {
    renderer = new T.WebGLRenderer({ canvas, antialias: true, alpha: true });
  } catch {
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

  const materials = new_materials(), shared = materials.shared;
  // show() sets the present gear and its scene.
  const gears = {} as { now: Gear };
  let told!: Scene, kept: { key: string | number; name: string; gear: Gear }[] = [];
  const choice: Choice = { focus: 'net', from: 'bow', compare: 'off', align: 'bosom', colour: 'tension' };
  // Camera directions: angle from x towards y, and elevation (radians).
  const directions: Record<string, [number, number]> = {
    bow: [-2.05, 0.3], above: [-Math.PI / 2, Math.PI / 2], side: [-Math.PI / 2, 0.06],
    astern: [0, 0.06]
  };
  const camera = {
    turn: directions.bow[0], rise: directions.bow[1], at: [0, 0, 0],
    // distance to the target, and the distance that fits the focus (m)
    away: 1, fit: 1,
    // position of the target in the picture, in half sizes from the centre
    across: 0, up: 0
  };
  const perspective = new T.PerspectiveCamera(28, 1, 0.1, 100);
  const modes: Record<Mode, string> = {
    tension: say('Tension'), slack: say('Slack'), mesh_opening: say('Mesh opening'),
    mesh_angle: say('Mesh angle'), drag: say('Drag')
  };

  // ---- focus ------------------------------------------------------------------------------------

  function compared() {
    if (choice.compare === 'off') return [gears.now];
    return kept.map((one) => one.gear).concat(gears.now);
  }

  // Returns the displacement (m) that aligns a gear with the present one. It is horizontal above a
  // bed, because heights are comparable there.
  function shift_of(gear: Gear) {
    if (gear === gears.now) return [0, 0, 0];
    const at = gear.places_to_align()[choice.align], to = gears.now.places_to_align()[choice.align];
    return at && to ? [to[0] - at[0], to[1] - at[1], told.bed ? 0 : to[2] - at[2]] : [0, 0, 0];
  }

  // Returns the bounding box in focus. It changes only if the gear leaves it or becomes much
  // smaller, so that growth stays visible.
  let held: Partial<Record<Choice['focus'], Range>> = {};
  function focus(): Range {
    const key = choice.focus;
    function of(gear: Gear) {
      const range = gear.range[key] || gear.range.whole, by = shift_of(gear);
      function moved(end: number[]) { return end.map((v, k) => v + by[k]); }
      return { low: moved(range.low), high: moved(range.high) };
    }
    const all = compared().map(of).reduce((one, other) => join(one, other) as Range);
    const before = held[key];
    if (before) {
      const size = longest(before), slack = 0.06 * size;
      let fits = longest(all) > 0.6 * size;
      for (let axis = 0; axis < 3; axis++) {
        fits = fits && all.low[axis] > before.low[axis] - slack &&
          all.high[axis] < before.high[axis] + slack;
      }
      if (fits) return before;
    }
    return held[key] = { low: all.low.slice(), high: all.high.slice() };
  }

  // Returns the points in focus, with the radius of components. In motion, returns the box corners.
  function outline(range: Range) {
    const corners: number[][] = [], found: number[][] = [];
    for (let k = 0; k < 8; k++) {
      corners.push([0, 1, 2].map((axis) => k >> axis & 1 ? range.high[axis] : range.low[axis]));
    }
    if (told.times.length > 1) return corners;
    compared().forEach((gear) => {
      const by = shift_of(gear);
      [[gear.points], [gear.at, gear.told.marks.size]].forEach((all) => {
        const p = all[0];
        for (let i = 0; i < p.length; i += 3) {
          const at = [p[i] + by[0], p[i + 1] + by[1], p[i + 2] + by[2]];
          const inside = at.every((v, axis) => v >= range.low[axis] - 1e-6 && v <= range.high[axis] + 1e-6);
          if (inside) found.push(at.concat(all[1] ? all[1][i / 3] / 2 : 0));
        }
      });
    });
    return found.length ? found : corners;
  }

  // Returns the margins (pixels) that labels and buttons take at the given sides. Each element
  // takes the side that costs least; at least half of the picture stays free.
  function taken_along(sides: Corner[]) {
    const width = host.clientWidth || 1, height = host.clientHeight || 1;
    const taken = { left: 0, right: 0, top: 0, bottom: 0 }, frame = host.getBoundingClientRect();
    [title, bar, legend, scaleBar, ...host.querySelectorAll('.view-time, .view-graph')]
      .forEach((part) => {
        const box = part.getBoundingClientRect();
        let least = Infinity, best: Corner = sides[0];
        if (!box.width || !box.height) return;
        const strips = {
          left: box.right - frame.left, right: frame.right - box.left,
          top: box.bottom - frame.top, bottom: frame.bottom - box.top
        };
        sides.forEach((side) => {
          const across = side === 'left' || side === 'right';
          const cost = Math.max(0, strips[side] - taken[side]) * (across ? height : width);
          if (cost < least) { least = cost; best = side; }
        });
        taken[best] = Math.max(taken[best], strips[best]);
      });
    const pairs: [Corner, Corner, number][] = [['left', 'right', width], ['top', 'bottom', height]];
    pairs.forEach(([one, other, size]) => {
      const much = (taken[one] + taken[other]) / (0.5 * size);
      if (much > 1) { taken[one] /= much; taken[other] /= much; }
    });
    return taken;
  }

  // Returns the part of the picture that labels and buttons leave free: fractions of width and
  // height, and the offset of its centre in half sizes of the picture.
  function free_part() {
    if (choice.compare === 'beside') return { wide: 0.9, tall: 0.75, across: 0, up: 0 };
    const width = host.clientWidth || 1, height = host.clientHeight || 1;
    const taken = taken_along(['left', 'right', 'top', 'bottom']);
    return {
      wide: 0.94 * (1 - (taken.left + taken.right) / width),
      tall: 0.94 * (1 - (taken.top + taken.bottom) / height),
      across: (taken.left - taken.right) / width, up: (taken.bottom - taken.top) / height
    };
  }

  // Returns the target and distance of a camera that sees a whole range in the free part:
  // {at, away}.
  function sight(range: Range, turn: number, rise: number, aspect: number, free: { wide: number; tall: number }) {
    const way = axes(turn, rise);
    let at = middle(range), away = 0;
    const points = outline(range);
    const tall = Math.tan(perspective.fov * Math.PI / 360), wide = tall * aspect;
    for (let turnOver = 0; turnOver < 3; turnOver++) {
      const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
      away = 0;
      points.forEach((point) => {
        const d = [point[0] - at[0], point[1] - at[1], point[2] - at[2]], radius = point[3] || 0;
        away = Math.max(away, dot(d, way.eye) + Math.max(
          (Math.abs(dot(d, way.right)) + radius) / (free.wide * wide),
          (Math.abs(dot(d, way.up)) + radius) / (free.tall * tall)
        ));
      });
      away = Math.max(away, 1e-3);
      // The projected points determine the centre.
      points.forEach((point) => {
        const d = [point[0] - at[0], point[1] - at[1], point[2] - at[2]], radius = point[3] || 0;
        const near = 1 - dot(d, way.eye) / away;
        [dot(d, way.right), dot(d, way.up)].forEach((v, k) => {
          low[k] = Math.min(low[k], (v - radius) / near);
          high[k] = Math.max(high[k], (v + radius) / near);
        });
      });
      at = at.map((v, k) => v + (low[0] + high[0]) / 2 * way.right[k] + (low[1] + high[1]) / 2 * way.up[k]);
    }
    return { at, away };
  }

  function aspect() {
    const box = boxes(canvas.clientWidth || 1, canvas.clientHeight || 1)[0];
    return box.width / box.height;
  }

  // Fits the focus into the picture without a turn of the camera.
  function aim() {
    const free = free_part(), found = sight(focus(), camera.turn, camera.rise, aspect(), free);
    camera.at = found.at;
    camera.away = camera.fit = found.away;
    camera.across = free.across;
    camera.up = free.up;
  }

  // Starts from the bow, unless another direction allows a much shorter distance. The front view
  // has the largest penalty, because a trawl hides most of itself there. The high view suits gears
  // that hang deep and narrow.
  function first_look() {
    const range = focus(), a = aspect(), free = free_part();
    const looks: [string, number, number, number][] = [
      ['bow', ...directions.bow, 1], ['quarter', -1.2, 0.3, 1.4], ['front', -2.75, 0.22, 1.8],
      ['side', -Math.PI / 2, 0.16, 1.5], ['high', -1.3, 0.95, 1.5]
    ];
    const away = looks.map(([, turn, rise, penalty]) => sight(range, turn, rise, a, free).away * penalty);
    const [name, turn, rise] = looks[away.indexOf(Math.min(...away))];
    camera.turn = turn;
    camera.rise = rise;
    choice.from = name;
    write_bar();
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

  const water = materials.sheet(false, 0.22);
  const bed = materials.sheet(true, 1);
  function sheetMesh(material: T.Material) {
    const geometry = new T.BufferGeometry();
    geometry.setAttribute('position', new T.BufferAttribute(new Float32Array(12), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const mesh = new T.Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
  }
  const around = new T.Scene(), waterMesh = sheetMesh(water), bedMesh = sheetMesh(bed);
  bedMesh.renderOrder = -1;
  waterMesh.renderOrder = 5;
  const waters = new T.Mesh(new T.BufferGeometry(), materials.around);
  waters.geometry.setAttribute('position', new T.BufferAttribute(
    new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  waters.frustumCulled = false;
  waters.renderOrder = -2;
  around.add(waters);
  around.add(bedMesh);
  const above = new T.Scene();
  above.add(waterMesh);

  // Returns the height of the bed (m).
  function bed_at(x: number, y: number) {
    const { normal: n, height } = told.bed as Bed;
    return (height - n[0] * x - n[1] * y) / n[2];
  }

  // Renders the gear's shadow on the bed as seen from the sun, once per shape. sun: its direction.
  let cast: T.WebGLRenderTarget | null = null, shaded: Gear | null = null;
  const sun = [-0.34, 0.30, 0.89], sunCamera = new T.OrthographicCamera();
  sunCamera.matrixAutoUpdate = sunCamera.matrixWorldAutoUpdate = false;
  function cast_shadow(gear: Gear) {
    if (!told.bed || shaded === gear) return;
    const { normal: n, height } = told.bed;
    shaded = gear;
    if (!cast) {
      cast = new T.WebGLRenderTarget(1024, 1024, {
        depthBuffer: true, generateMipmaps: true, minFilter: T.LinearMipmapLinearFilter
      });
    }
    const range = gear.range[choice.focus] || gear.range.whole, at = middle(range);
    // Points are projected to the bed along the sun's rays.
    const along = n[0] * sun[0] + n[1] * sun[1] + n[2] * sun[2];
    function fall(p: number[]) { return (dot(n, p) - height) / along; }
    const reach = 0.62 * longest(range) + 0.35 * Math.abs(fall(range.high));
    const x = at[0] - sun[0] * fall(at), y = at[1] - sun[1] * fall(at), deep = 4 * (longest(range) + reach);
    const m = sunCamera.matrixWorldInverse.elements;
    [[1, 0, sun[0]], [0, 1, sun[1]]].forEach((row, k) => {
      for (let c = 0; c < 3; c++) m[4 * c + k] = ((c < 2 ? row[c] : 0) - row[2] * n[c] / along) / reach;
      m[12 + k] = (row[2] * height / along - (k ? y : x)) / reach;
    });
    for (let c = 0; c < 3; c++) m[4 * c + 2] = c === 2 ? -1 / deep : 0;
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
    gear.place_marks(() => 0);
    renderer.setRenderTarget(cast);
    renderer.clear();
    renderer.render(gear.scene, sunCamera);
    renderer.setRenderTarget(null);
    shared.ghost.value = 0;
    shared.fogMost.value = 0.6;
    bed.uniforms.shadow.value = cast.texture;
    bed.uniforms.shadowAt.value.set(x, y, reach);
  }

  let square = 1;
  function lay_sheets() {
    const range = focus(), size = longest(range), at = middle(range);
    square = round(size / 8);
    const reach = Math.max(2.6 * size, 1.1 * camera.away);
    const sheets: [T.Mesh, T.ShaderMaterial, (x: number, y: number) => number][] = [
      [waterMesh, water, () => 0], [bedMesh, bed, bed_at]
    ];
    sheets.forEach(([mesh, material, height]) => {
      if (mesh === bedMesh && !told.bed) return;
      const place = mesh.geometry.getAttribute('position');
      [[-1, -1], [1, -1], [1, 1], [-1, 1]].forEach((sign, k) => {
        const x = at[0] + sign[0] * reach, y = at[1] + sign[1] * reach;
        place.setXYZ(k, x, y, height(x, y));
      });
      place.needsUpdate = true;
      material.uniforms.square.value = square;
      material.uniforms.reach.value = reach;
      material.uniforms.middle.value = { x: at[0], y: at[1] };
    });
    waterMesh.visible = told.water;
    bedMesh.visible = !!told.bed;
  }

  // Minimum distance of drawn twines (pixels).
  const twine_gap = 14;

  // Sets the camera for a picture of this size (pixels).
  function set_eye(width: number, height: number) {
    const way = axes(camera.turn, camera.rise), range = gears.now.range.whole, size = longest(range);
    perspective.aspect = width / height;
    perspective.position.fromArray(camera.at.map((v, k) => v + camera.away * way.eye[k]));
    perspective.up.fromArray(way.up);
    perspective.lookAt(camera.at[0], camera.at[1], camera.at[2]);
    const far = Math.hypot(perspective.position.x - middle(range)[0],
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
    const reach = longest(focus()), shown = focus();
    shared.fogNear.value = camera.away - 0.1 * reach;
    shared.fogFar.value = camera.away + 3.5 * reach;
    // The water is lightest at the surface, or above a gear that hangs far below it.
    shared.waterTop.value = told.water && shown.high[2] > -0.5 * reach ? 0 : shown.high[2] + 0.3 * reach;
    shared.waterSpan.value = 1.1 * Math.max(shared.waterTop.value - shown.low[2], 0.5 * reach);
    materials.around.uniforms.away.value = camera.away;
    light(way);
  }

  // Places the light above and behind the camera's left shoulder.
  function light(way: Axes) {
    shared.light.value.fromArray(way.eye.map((ahead, k) =>
      0.75 * ahead - 0.3 * way.right[k] + 0.45 * way.up[k] + (k === 2 ? 0.35 : 0))).normalize();
  }

  function size_at(place: T.Vector3) {
    return shared.pixel.value * shared.ratio.value * perspective.position.distanceTo(place);
  }

  // ghost: uniform colour, or null. The opposite displacement of the camera moves the gear.
  function draw_gear(gear: Gear, eye: T.Camera, ghost: string | null, size: (place: T.Vector3) => number) {
    const by = shift_of(gear), from = eye.position.clone();
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
  function draw_kept(eye: T.Camera, size: (place: T.Vector3) => number) {
    kept.forEach((one, k) => { draw_gear(one.gear, eye, kept_colour(k), size); });
  }

  function boxes(width: number, height: number): Box[] {
    if (choice.compare !== 'beside' || !kept.length) {
      return [{ left: 0, top: 0, width, height, gear: gears.now }];
    }
    const all = [...kept, { name: say('Now'), gear: gears.now }], n = all.length;
    const columns = Math.min(n, Math.max(1, Math.round(Math.sqrt(n * width / height))));
    const taken = taken_along(['top', 'bottom']);
    const w = width / columns, h = (height - taken.top - taken.bottom) / Math.ceil(n / columns);
    return all.map((one, k) => ({
      left: k % columns * w, top: taken.top + Math.floor(k / columns) * h, width: w, height: h,
      gear: one.gear, name: one.name
    }));
  }

  // While shapes change, a slow renderer draws at lower resolution. The first pictures measure the
  // drawing time (ms).
  let hasty: number | undefined;
  const coarse = 0.5, slow = 30, times: number[] = [];
  let quickest = Infinity;
  function hasten() {
    window.clearTimeout(hasty);
    hasty = window.setTimeout(() => {
      if (options.passing && options.passing()) { hasten(); return; }
      hasty = undefined;
      repaint();
    }, 250);
  }
  function take_time(began: number) {
    const gl = renderer.getContext();
    // This call waits until drawing is complete.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    times.push(performance.now() - began);
    if (times.length > 1) quickest = Math.min(quickest, times[times.length - 1]);
  }

  // Returns true if shapes are changing and the renderer is slow.
  function too_slow() { return hasty && quickest > slow && quickest < Infinity; }

  // Canvas pixels per CSS pixel.
  let ratio = 1;
  function draw(given?: number) {
    const width = canvas.clientWidth, height = canvas.clientHeight;
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
    boxes(width, height).forEach((box) => {
      const foot = height - box.top - box.height;
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

  let waiting = false, drawn = 0;
  function repaint() {
    if (waiting) return;
    waiting = true;
    window.requestAnimationFrame(() => {
      waiting = false;
      paint_now();
    });
  }
  function paint_now() {
    const began = performance.now();
    if (saver.filming() || !draw()) return;
    if (hasty && times.length < 4) take_time(began);
    drawn += 1;
    seen = null;
    tell_scale();
    place_words();
  }

  // ---- labels around the picture ----------------------------------------------------------------

  const layer = (name: string) => host.appendChild(element('div', name));
  const labels = {
    surface: layer('view-label view-label-surface'), bed: layer('view-label view-label-bed'),
    vessel: layer('view-label view-label-vessel')
  };
  labels.surface.textContent = say('water surface');
  labels.vessel.textContent = say('vessel');
  const names = layer('view-names'), title = layer('view-title'), bar = layer('view-bar');
  const legend = layer('view-legend'), scaleBar = layer('view-scale'), tip = layer('view-tip');
  const still = host.appendChild(element('img', 'view-still', undefined, { alt: '' })), keys = layer('view-keys');
  tip.setAttribute('role', 'status');
  tip.hidden = keys.hidden = true;

  const buttons: [keyof Choice, string, [string, string, string][]][] = [
    ['focus', say('Look at'), [['net', say('Net'), 'n'], ['whole', say('Whole gear'), 'g']]],
    ['from', say('Look from'), [['bow', say('Bow'), '1'], ['above', say('Above'), '2'], ['side', say('Side'), '3'],
      ['astern', say('Astern'), '4']]],
    ['compare', say('Kept designs'), [['off', say('Now'), '5'], ['over', say('Over'), '6'],
      ['beside', say('Side by side'), '7']]]
  ];
  const with_key = (words: string, key: string) => say('{words} (key {key})', { words, key });
  const saver = new_saver(host, {
    turn: () => camera.turn,
    times() { return told.times; },
    seek(time: number) { moment?.seek(time); },
    look,
    release: repaint
  }, {
    canvas,
    draw(ratio) { hasty = undefined; draw(ratio); tell_scale(); place_words(); },
    words() {
      return [title, legend, scaleBar].concat(Array.from(host.querySelectorAll('.view-label, .view-time .label')));
    },
    name: () => file_name(told.name)
  });
  function toggle_keys() {
    keys.hidden = !keys.hidden;
    write_bar();
  }
  function toggle_saver() {
    saver.toggle();
    write_bar();
  }
  function Select({ what, words, tip, hidden, options }: {
    what: 'colour' | 'align'; words: string; tip?: string; hidden?: boolean; options: [string, string][];
  }) {
    return <select class="view-colour" aria-label={words} title={tip ?? words} hidden={hidden} value={choice[what]}
      onChange={(event) => choose(what, event.currentTarget.value)}>
      {options.map(([value, words]) => <option value={value}>{words}</option>)}
    </select>;
  }
  const colours = () => (Object.keys(modes) as Mode[]).filter((mode) =>
    mode.indexOf('mesh') || told.scales[mode]?.netting);
  // Writes the buttons and lists. Without netting, only the whole gear can be in focus.
  function write_bar() {
    if (!told) return;
    const places = gears.now.places_to_align(), words = say('Colours');
    render([
      buttons.map(([group, words, all]) =>
        <div class="view-group" role="group" aria-label={words} hidden={group === 'compare' && !kept.length}>
          {all.map(([value, words, key]) => <button type="button" class="view-button" data-group={group}
            data-value={value} data-key={key} aria-pressed={choice[group] === value} title={with_key(words, key)}
            disabled={value === 'net' && !gears.now.range.net} onClick={() => choose(group, value)}>{words}</button>)}
          {group === 'compare' && <Select what="align" words={say('Designs are aligned at')}
            hidden={choice.compare === 'off' || !places.bosom || !places.towing}
            options={[['bosom', say('At the bosom')], ['towing', say('At the towing point')]]} />}
        </div>),
      <Select what="colour" words={words} tip={with_key(words, 'c')}
        options={colours().map((mode) => [mode, modes[mode]])} />,
      <button type="button" class="view-button" aria-expanded={!saver.panel.hidden} onClick={toggle_saver}
        title={with_key(say('Save a picture or a video'), 's')}>{say('Save')}</button>,
      <button type="button" class="view-button" aria-expanded={!keys.hidden} aria-label={say('Keys')}
        title={with_key(say('Keys'), 'h')} onClick={toggle_keys}>?</button>
    ], bar);
    render([[say('drag, arrows'), say('turn')], [say('wheel, two fingers, + and -'), say('zoom')],
      [say('right button, Shift'), say('move')], ['1 2 3 4', say('bow, above, side, astern')],
      ['n, g', say('net, whole gear')], ['c', say('next colours')], ['0', say('reset view')], ['s', say('save')],
      [say('pointer'), say('names and values')], ...told.times.length > 1 ? motion_keys() : []
    ].map(([key, words]) => [<kbd>{key}</kbd>, <span>{words}</span>]), keys);
  }

  function write_legend() {
    const scales = told.scales[choice.colour] || {}, marks = told.marks, colour = choice.colour;
    const shows = colour === 'tension' || colour === 'slack', any_slack = told.times.length > 1 || any((x) => x === 0);
    const Entry = ({ words, of, kind = 'line' }: { words: string; of: string; kind?: string }) =>
      <span class="entry"><i class={kind} style={'--colour: ' + of} />{words}</span>;
    render([
      scales.rope && <ColourBar scale={scales.rope} stops={told.colours.rope} />,
      scales.netting && <ColourBar scale={scales.netting} stops={told.colours.netting} />,
      <div class="key">
        {shows && (any_slack ? <Entry words={say('slack')} of={gears.now.slack_colour(colour)} kind="slack" /> :
          <span class="entry">{say('nothing is slack')}</span>)}
        {shows && any((x) => x < 0) && <Entry words={say('in compression')} of="#4A545C" />}
        {colour === 'slack' && <Entry words={say('taut')} of="#5F7482" />}
        {!scales.rope && !colour.indexOf('mesh') && <Entry words={say('rope')} of="#4A545C" />}
        {choice.compare === 'over' && kept.map((one, k) => <Entry words={one.name} of={kept_colour(k)} />)}
        {marks.label.map((words, k) => marks.label.indexOf(words) === k && <Entry words={say(words)} of={marks.fill[k]}
          kind={marks.board[k] >= 0 || marks.direction[k] ? 'plate' : 'ball'} />)}
      </div>
    ], legend);
  }

  // Returns true if `such` is true for any present tension.
  function any(such: (tension: number) => boolean) {
    const gear = gears.now;
    return [gear.rope_tension, gear.netting.u, gear.netting.v].some((all) => Array.prototype.some.call(all, such));
  }

  function project(at: number[], box: { left: number; top: number; width: number; height: number }) {
    const p = new T.Vector3(at[0], at[1], at[2]).project(perspective);
    return [box.left + box.width * (p.x + 1) / 2, box.top + box.height * (1 - p.y) / 2, p.z];
  }

  // Places the labels in the picture and hides labels out of sight.
  function place_words() {
    const width = canvas.clientWidth, height = canvas.clientHeight;
    const range = focus(), at = middle(range), size = longest(range);
    function put(label: HTMLElement, place: number[] | null | false | undefined, words?: string) {
      const p = place && project(place, { left: 0, top: 0, width, height });
      const shown = p && p[2] < 1 && p[0] > 30 && p[0] < width - 30 && p[1] > 46 && p[1] < height - 90 &&
        choice.compare !== 'beside';
      label.hidden = !shown;
      if (!shown) return;
      if (words) label.textContent = words;
      label.style.left = p[0] + 'px';
      label.style.top = p[1] + 'px';
    }
    const side = [at[0] + 0.5 * size, at[1] - 0.75 * size];
    put(labels.surface, told.water && Math.abs(camera.rise) > 0.03 && [side[0], side[1], 0]);
    const depth = told.bed ? bed_at(side[0], side[1]) : 0;
    put(labels.bed, told.bed && [side[0], side[1], depth], say('sea bed, {n} m deep', { n: three(-depth) }));
    const vessel = gears.now.vessels[0];
    put(labels.vessel, vessel && [vessel.at[0], vessel.at[1], 0.5 * vessel.at[3]]);
    render(boxes(width, height).filter((one) => one.name).map((one) => <div class="view-label view-label-name"
      style={{ left: one.left + one.width / 2, top: one.top + 18 }}>{one.name}</div>), names);
  }

  // Updates the scale at the camera target, the flow arrow and the grid size.
  function tell_scale() {
    const box = boxes(canvas.clientWidth, canvas.clientHeight)[0];
    const metres = 2 * Math.tan(perspective.fov * Math.PI / 360) * camera.away / box.height;
    const long = round(90 * metres);
    const speed = Math.hypot(told.flow[0], told.flow[1]), way = axes(camera.turn, camera.rise);
    const along = [told.flow[0] / speed, told.flow[1] / speed, 0];
    const dx = dot(along, way.right), dy = -dot(along, way.up), across = Math.hypot(dx, dy) >= 0.15;
    const grid = told.bed || told.water && focus().high[2] > -0.3 * longest(focus());
    render([
      <span>{three(long) + ' m'}</span>, <i class="line" style={{ width: long / metres }} />,
      speed > 0 && <span class="flow">{say('flow {n} m/s', { n: three(speed) }) + ' '}
        <i class="arrow" style={across ? { transform: `rotate(${Math.atan2(dy, dx)}rad)` } : {}}>
          {across ? '\u2192' : '\u2299'}</i>
      </span>,
      grid && <span class="squares">{say('squares of {n} m', { n: three(square) })}</span>
    ], scaleBar);
  }

  // ---- the pointer ------------------------------------------------------------------------------

  // Returns screen positions of nodes and components (x and y in pixels, depth), on demand.
  let seen: { points: Float32Array; marks: Float32Array } | null = null;
  function on_screen() {
    if (seen) return seen;
    const gear = gears.now, box = boxes(canvas.clientWidth, canvas.clientHeight).filter((b) => b.gear === gears.now)[0];
    set_eye(box.width, box.height);
    shared.pixel.value /= shared.ratio.value;
    function all(points: Float32Array) {
      const out = new Float32Array(points.length);
      const m = perspective.projectionMatrix.clone().multiply(perspective.matrixWorldInverse), p = new T.Vector4();
      for (let i = 0; i < points.length; i += 3) {
        p.set(points[i], points[i + 1], points[i + 2], 1).applyMatrix4(m);
        out[i] = box.left + box.width * (p.x / p.w + 1) / 2;
        out[i + 1] = box.top + box.height * (1 - p.y / p.w) / 2;
        out[i + 2] = p.w;
      }
      return out;
    }
    seen = { points: all(gear.points), marks: all(gear.at) };
    return seen;
  }

  // Returns the element at a screen position: {kind, number, share} or null.
  function under(x: number, y: number): Found | null {
    const gear = gears.now, at = on_screen(), p = at.points;
    let best: Found | null = null, nearest = Infinity;
    gear.marks.forEach((mark, i) => {
      const w = at.marks[3 * i + 2];
      if (w <= 0) return;
      const off = Math.hypot(at.marks[3 * i] - x, at.marks[3 * i + 1] - y);
      const radius = Math.max(7, mark.half / (shared.pixel.value * shared.ratio.value * w));
      if (off < radius && w < nearest) { nearest = w; best = { kind: 'mark', number: i }; }
    });
    if (best) return best;
    const ends = gear.ropes.ends;
    let near = 7;
    for (let l = 0; l < ends.length / 2; l++) {
      const a = 3 * ends[2 * l], b = 3 * ends[2 * l + 1];
      if (p[a + 2] <= 0 || p[b + 2] <= 0) continue;
      const dx = p[b] - p[a], dy = p[b + 1] - p[a + 1], long = dx * dx + dy * dy;
      const t = long ? Math.min(Math.max(((x - p[a]) * dx + (y - p[a + 1]) * dy) / long, 0), 1) : 0;
      const off = Math.hypot(p[a] + t * dx - x, p[a + 1] + t * dy - y);
      if (off < near) { near = off; best = { kind: 'rope', number: l, share: t }; }
    }
    if (best) return best;
    const net = gear.netting;
    let closest = Infinity;
    for (let k = 0; k < net.part.length; k++) {
      const i = 3 * net.point[3 * k], j = 3 * net.point[3 * k + 1], c = 3 * net.point[3 * k + 2];
      if (p[i + 2] <= 0 || p[j + 2] <= 0 || p[c + 2] <= 0) continue;
      const area = (p[j] - p[i]) * (p[c + 1] - p[i + 1]) - (p[c] - p[i]) * (p[j + 1] - p[i + 1]);
      if (!area) continue;
      const s = ((x - p[i]) * (p[c + 1] - p[i + 1]) - (p[c] - p[i]) * (y - p[i + 1])) / area;
      const r = ((p[j] - p[i]) * (y - p[i + 1]) - (x - p[i]) * (p[j + 1] - p[i + 1])) / area;
      if (s < 0 || r < 0 || s + r > 1) continue;
      const w = p[i + 2] + s * (p[j + 2] - p[i + 2]) + r * (p[c + 2] - p[i + 2]);
      if (w < closest) { closest = w; best = { kind: 'netting', number: k }; }
    }
    return best;
  }

  function point_at(x: number, y: number) {
    const found = gears.now && under(x, y);
    tip.hidden = !found;
    if (!found) return;
    const said = described(gears.now, found);
    render([
      <b>{said.heading}</b>, said.note !== said.heading && <div class="note">{said.note}</div>,
      said.rows.map(([name, value]) => <div class={value === say('slack') ? 'row slack' : 'row'}>
        <span>{name}</span><span>{value}</span></div>)
    ], tip);
    const right = x + 14 + tip.offsetWidth > host.clientWidth;
    tip.style.left = (right ? Math.max(4, x - 14 - tip.offsetWidth) : x + 14) + 'px';
    tip.style.top = Math.max(4, Math.min(y + 14, host.clientHeight - tip.offsetHeight - 4)) + 'px';
  }

  // ---- pointer, wheel and keys ------------------------------------------------------------------

  // The camera is at none of the named directions.
  function left_named() {
    if (choice.from) {
      choice.from = '';
      write_bar();
    }
  }
  function look(place: Partial<typeof camera>) {
    left_named();
    Object.assign(camera, place);
    repaint();
  }
  function turn_by(across: number, up: number) {
    camera.turn -= across;
    camera.rise = Math.min(Math.max(camera.rise + up, -Math.PI / 2), Math.PI / 2);
    left_named();
    repaint();
  }
  function zoom_by(factor: number, x?: number, y = 0) {
    const before = camera.away, size = longest(gears.now.range.whole);
    camera.away = Math.min(Math.max(before / factor, camera.fit / 400), 8 * size + 4 * camera.fit);
    // The zoom is centred on the pointer.
    if (x !== undefined) {
      const way = axes(camera.turn, camera.rise), up = canvas.clientHeight;
      const metres = 2 * Math.tan(perspective.fov * Math.PI / 360) / up * (before - camera.away);
      shift((x - canvas.clientWidth / 2 * (1 + camera.across)) * metres,
        (up / 2 * (1 - camera.up) - y) * metres, way);
    }
    repaint();
  }
  function shift(right: number, up: number, way: Axes) {
    camera.at = camera.at.map((v, k) => v + right * way.right[k] + up * way.up[k]);
  }
  function move_by(dx: number, dy: number) {
    const metres = 2 * Math.tan(perspective.fov * Math.PI / 360) * camera.away / canvas.clientHeight;
    shift(-dx * metres, dy * metres, axes(camera.turn, camera.rise));
    repaint();
  }

  function choose(what: keyof Choice, value: string) {
    Object.assign(choice, { [what]: value });
    if (what === 'from' && directions[value]) {
      camera.turn = directions[value][0];
      camera.rise = directions[value][1];
    }
    if (gears.now) {
      if (what !== 'colour') {
        held = {};
        shaded = null;
        fit_align();
        aim();
      }
      recolour();
      write_bar();
      write_legend();
    }
    repaint();
  }

  function recolour() {
    compared().forEach((gear) => { gear.colour(choice.colour); });
  }

  // Chooses an alignment point that the gear has.
  function fit_align() {
    const places = gears.now.places_to_align();
    if (!places[choice.align]) choice.align = places.bosom ? 'bosom' : 'towing';
  }

  let hovering: number[] | null = null, chosen = false;
  document.addEventListener('pointerdown', (event) => { chosen = host.contains(event.target as Node); });
  function place_of(event: PointerEvent) {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  const moved = listen_pointers(canvas, {
    down({ pointerId }) {
      canvas.setPointerCapture(pointerId);
      tip.hidden = true;
    },
    hover(event) {
      if (!hovering) {
        window.requestAnimationFrame(() => {
          const at = hovering;
          hovering = null;
          if (at) point_at(at[0], at[1]);
        });
      }
      hovering = place_of(event);
    },
    move(dx, dy, { shiftKey, buttons }, count) {
      if (count > 1 || shiftKey || buttons === 2 || buttons === 4) move_by(dx, dy);
      else turn_by(dx * 0.008, dy * 0.008);
    },
    zoom: zoom_by,
    // A tap shows the values at its position.
    up(event) {
      const [x, y] = place_of(event);
      if (event.type === 'pointerup' && moved() < 4) point_at(x, y);
    },
    // The wheel scrolls the page until the picture is clicked, unless the picture fills the window.
    wheels: () => chosen || host.clientHeight > window.innerHeight - 60
  });
  canvas.addEventListener('pointerleave', () => { hovering = null; tip.hidden = true; });
  canvas.addEventListener('contextmenu', (event) => { event.preventDefault(); });

  function next_colour() {
    const all = colours();
    choose('colour', all[(all.indexOf(choice.colour) + 1) % all.length]);
  }
  const acts: Record<string, () => void> = {
    ArrowLeft: () => turn_by(-0.1, 0), ArrowRight: () => turn_by(0.1, 0), ArrowUp: () => turn_by(0, 0.1),
    ArrowDown: () => turn_by(0, -0.1), '+': () => zoom_by(1.2), '=': () => zoom_by(1.2), '-': () => zoom_by(1 / 1.2),
    c: next_colour, h: toggle_keys, s: toggle_saver, 0: () => { look_again(); repaint(); }
  };
  host.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !gears.now) return;
    if (/^(INPUT|SELECT|TEXTAREA)$/.test((event.target as Element).tagName)) return;
    const { key } = event;
    if (key === 'Escape') { keys.hidden = tip.hidden = saver.panel.hidden = true; write_bar(); }
    const button = Array.from(bar.querySelectorAll<HTMLButtonElement>('[data-key]'))
      .find((one) => one.dataset.key === key && one.checkVisibility());
    const act = button ? () => button.click() : acts[key];
    if (!act) return;
    event.preventDefault();
    act();
  });

  // ---- printing ---------------------------------------------------------------------------------

  // WebGL discards a picture after drawing, so it is copied immediately, on white.
  function on_white() {
    hasty = undefined;
    shared.paper.value = 1;
    bed.uniforms.strength.value = water.uniforms.strength.value = 0.05;
    const address = draw() ? canvas.toDataURL('image/png') : '';
    shared.paper.value = 0;
    bed.uniforms.strength.value = 1;
    water.uniforms.strength.value = 0.22;
    if (!address) return '';
    repaint();
    return address;
  }
  // In print layout the picture has no size, so the last still stays.
  function for_paper() {
    const made = on_white();
    if (made) still.src = made;
  }
  window.addEventListener('beforeprint', for_paper);
  // Some browsers print without a prior event.
  let stillTimer: number | undefined;
  function later() {
    window.clearTimeout(stillTimer);
    stillTimer = window.setTimeout(for_paper, 1500);
  }

  // ---- scenes -----------------------------------------------------------------------------------

  function take(gear: Gear, part: Partial<Scene>) {
    gear.take(part);
    shaded = null;
    gear.range = gear.ranges();
    gear.colour(choice.colour);
  }
  function take_now(part: Partial<Scene>) {
    if (!gears.now) gears.now = new_gear(materials);
    take(gears.now, part);
  }
  function take_kept(all: KeptScene[]) {
    kept = all.map((one) => {
      const before = kept.filter((other) => other.key === one.key)[0];
      const gear = before ? before.gear : new_gear(materials);
      if (one.scene.points) take(gear, one.scene);
      else Object.assign(gear.told, one.scene);
      return { key: one.key, name: one.name, gear };
    });
    if (!kept.length) choice.compare = 'off';
  }

  // Fits the view again if the gear leaves the focus, at the same zoom.
  function follow() {
    const before = held[choice.focus];
    if (focus() === before) return;
    const zoom = camera.away / camera.fit;
    aim();
    camera.away *= zoom;
  }

  let moment: Motion | null = null, netless = false;
  const shown = {
    show(now: Partial<Scene>, beside: KeptScene[] = []) {
      const first = !gears.now || now.name !== told.name;
      take_now(now);
      take_kept(beside);
      told = gears.now.told;
      canvas.setAttribute('aria-label', say(
        '{name} in three dimensions. {conditions}. Arrow keys turn it, plus and minus zoom.',
        { name: told.name, conditions: told.conditions }
      ));
      if (options.title) {
        render([<div class="name">{told.name}</div>, <div class="conditions">{told.conditions}</div>], title);
      }
      fit_align();
      if (!gears.now.range.net && choice.focus === 'net') {
        choice.focus = 'whole';
        netless = true;
      } else if (gears.now.range.net && netless) {
        choice.focus = 'net';
        netless = false;
      }
      if (first && now.colour) choice.colour = now.colour;
      if (!colours().includes(choice.colour)) choice.colour = 'tension';
      write_bar();
      recolour();
      write_legend();
      if (moment && now.times) { moment.end(); moment = null; }
      if (told.times.length > 1 && !moment) moment = new_motion(host, shown, told, options);
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
    pass(part: Partial<Scene>) {
      hasten();
      take_now(part);
      follow();
      repaint();
    },
    // Colours the parts with these names.
    highlight(names: string[]) {
      gears.now.chosen = new Set(names);
      recolour();
      repaint();
    },
    choose,
    time(k: number, share: number) {
      gears.now.move(k, share);
      shaded = null;
      gears.now.colour(choice.colour);
      repaint();
    },
    seek(time: number) { if (moment) moment.seek(time); },
    look,
    frame(from: Partial<{ turn: number; rise: number; near: number; focus: Choice['focus'] }>) {
      choice.focus = from.focus || choice.focus;
      look_again();
      const at = Object.assign({ turn: camera.turn, rise: camera.rise, near: 1 }, from);
      look({ turn: at.turn, rise: at.rise });
      aim();
      camera.away *= at.near;
    },
    picture: saver.picture,
    film: saver.film,
    gear: () => gears.now,
    // For tests and measurements: a node position, whether a picture is pending, picture count.
    point(k: number) { return Array.from(gears.now.points.slice(3 * k, 3 * k + 3)); },
    waits() { return waiting || hasty !== undefined; },
    painted() { return drawn; },
    // bounds of the focus in the picture: left, top, right and bottom (pixels)
    reach() {
      const box = boxes(canvas.clientWidth, canvas.clientHeight)[0], found = [Infinity, Infinity, -Infinity, -Infinity];
      outline(focus()).forEach((point) => {
        const p = project(point, box);
        for (let k = 0; k < 2; k++) {
          found[k] = Math.min(found[k], p[k]);
          found[k + 2] = Math.max(found[k + 2], p[k]);
        }
      });
      return found;
    },
    under(x: number, y: number): Found | null { return under(x, y); }
  };

  // Narrow pictures have smaller labels, and buttons in a row of their own.
  function fold() {
    host.classList.toggle('narrow', host.clientWidth < 640);
    host.classList.toggle('titled', !!options.title);
  }
  fold();
  let width = 0;
  new window.ResizeObserver(() => {
    fold();
    if (!gears.now) return;
    // A new shape of the page requires a new fit.
    if (Math.abs(canvas.clientWidth - width) > 40) {
      const zoom = camera.away / camera.fit, at = camera.at;
      aim();
      camera.away *= zoom;
      if (zoom !== 1) camera.at = at;
      width = canvas.clientWidth;
    }
    repaint();
  }).observe(canvas);

  host.codendViewer = shown;
  return shown;
}
