// The gear in the flume tank: the viewer and three projections with axes. The axes are x aft, y to
// starboard, z up (m).

import { find, new_viewer, ticks, type Mode, type Scales, type Scene, type Viewer } from '../view';
import * as Form from './form';
import * as Kept from './kept';
import * as Predict from './predict';
import { send } from './server';
import { say } from './words';

interface Plane { turn: number; rise: number; axes: [number, number]; names: [string, string] }
let viewer: Viewer | null = null, about: Scene | null = null, timer: number | undefined;
// the last complete scene, its colour scales without stored designs, and the stored designs that the viewer has
let complete: Scene | null = null, own_scales: Scene['scales'] = {}, known: number[] = [];
const ink = '#202428', soft = '#4D555C', sea = '#2C6E9B';
const planes: Record<string, Plane> = {
  xy: {
    turn: -Math.PI / 2, rise: Math.PI / 2, axes: [0, 1], names: ['x_aft', 'y_starboard']
  },
  xz: { turn: -Math.PI / 2, rise: 0, axes: [0, 2], names: ['x_aft', 'depth_axis'] },
  yz: { turn: 0, rise: 0, axes: [1, 2], names: ['y_starboard', 'depth_axis'] }
};

function text(
  context: CanvasRenderingContext2D, words: string, x: number, y: number, align: CanvasTextAlign, colour: string
) {
  context.font = '12px system-ui, sans-serif';
  context.textAlign = align;
  context.textBaseline = 'middle';
  context.fillStyle = colour;
  context.fillText(words, x, y);
}

function open(canvas: HTMLCanvasElement) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  if (!width || !height) return null;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width, height };
}

// Returns false if the canvas has no size.
function paint_plane(viewer: Viewer, about: Scene, name: string): boolean {
  const page = open(find('plane_' + name));
  if (!page) return false;
  const plane = planes[name], range = viewer.focus(), context = page.context;
  const across = plane.axes[0], up = plane.axes[1];
  const box = { left: 54, top: 8, width: page.width - 66, height: page.height - 48 };
  function size(axis: number) { return Math.max(range.high[axis] - range.low[axis], 1e-6); }
  const scale = 0.93 * Math.min(box.width / size(across), box.height / size(up));
  const middle = range.low.map((v, k) => (v + range.high[k]) / 2);
  function x_of(v: number) { return box.left + box.width / 2 + scale * (v - middle[across]); }
  function y_of(v: number) { return box.top + box.height / 2 - scale * (v - middle[up]); }
  const left = middle[across] - box.width / 2 / scale, right = middle[across] + box.width / 2 / scale;
  const foot = middle[up] - box.height / 2 / scale, top = middle[up] + box.height / 2 / scale;
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
    [left, right].forEach((v, k) => {
      const at = middle.slice();
      at[across] = v;
      context[k ? 'lineTo' : 'moveTo'](x_of(v), y_of(viewer.bed_at(at[0], at[1])));
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
  ticks(left, right, box.width / 70).forEach((t) => {
    text(context, String(t), x_of(t), box.top + box.height + 12, 'center', soft);
    context.fillRect(x_of(t), box.top + box.height, 1, 4);
  });
  ticks(foot, top, box.height / 40).forEach((t) => {
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
  timer = window.setTimeout(() => {
    timer = undefined;
    const shown = viewer, scene = about;
    if (!shown || !scene) return;
    if (shown.hastens()) { repaint_planes(); return; }
    const painted = Object.keys(planes).map((name) => paint_plane(shown, scene, name)).some(Boolean);
    // The projections were drawn on the tank's own canvas.
    if (painted) shown.redraw();
  }, 120);
}

// Requests from R the plan path of a clicked part.
function listen_clicks(viewer: Viewer, canvas: HTMLCanvasElement) {
  let from: number[] | null = null;
  canvas.addEventListener('pointerdown', (event) => { from = [event.clientX, event.clientY]; });
  canvas.addEventListener('click', (event) => {
    if (!about || !from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4) return;
    const box = canvas.getBoundingClientRect(), gear = viewer.gear();
    const found = viewer.under(event.clientX - box.left, event.clientY - box.top);
    if (!found) return;
    send('part_wanted', { number: Date.now(), name: found.kind === 'mark' ?
      about.marks.part[found.number] :
      about.parts.name[(found.kind === 'rope' ? gear.ropes : gear.netting).part[found.number]] });
  });
}

// Creates the viewer.
export function listen(): void {
  viewer = new_viewer(find('tank'), { changed: repaint_planes, still: false, passing: () => !Form.still() });
  if (viewer) listen_clicks(viewer, document.querySelector('#tank canvas') as HTMLCanvasElement);
  const watch = new ResizeObserver(repaint_planes);
  document.querySelectorAll('canvas.plane').forEach((each) => { watch.observe(each); });
}
// Returns a colour scale for each quantity that covers all designs.
function common_scales(all: Partial<Scene>[]): Scene['scales'] {
  const found: Scene['scales'] = {};
  all.forEach(({ scales = {} }) => (Object.keys(scales) as Mode[]).forEach((mode) => {
    const known: Scales = found[mode] ??= {};
    Object.entries(scales[mode] ?? {}).forEach(([kind, scale]) => {
      const name = kind as keyof Scales, other = known[name];
      if (scale && !(other && other.limits[1] >= scale.limits[1])) known[name] = scale;
    });
  }));
  return found;
}

// Shows a scene of R/flume-picture.R and the stored designs. number: of the request.
export function picture(part: Partial<Scene>, number = 0): void {
  if (!viewer) return;
  own_scales = part.scales ?? own_scales;
  const seen = Kept.all().filter((one) => one.seen);
  const scales = common_scales([{ scales: own_scales }, ...seen.map((one) => one.scene)]);
  viewer.show({ ...part, scales }, seen.map(({ id, name, scene }) =>
    ({ key: id, name, scene: known.includes(id) ? { scales } : { ...scene, scales } })));
  known = seen.map((one) => one.id);
  const { told, points, at, corners } = viewer.gear();
  about = told;
  const ahead = part.points &&
    Predict.settle(number, { points, places: at, boards: corners }, !part.ropes);
  complete = { ...told, scales: own_scales, ...Predict.last() };
  if (ahead?.points) moved(ahead);
  repaint_planes();
}
// Updates the stored designs in the picture.
export function compare(): void { if (about) picture({ name: about.name }); }
// Returns the last complete scene, or null.
export function scene(): Partial<Scene> | null { return complete; }
// Shows an intermediate or predicted shape.
export function moved(part: Partial<Scene>): void {
  if (!viewer) return;
  viewer.pass(part);
  about = viewer.gear().told;
  repaint_planes();
}
// Shows the parts that the user has chosen.
export function highlight(names: string[]): void { viewer?.highlight(names); }

// For tests and measurements: the viewer, a node position, and whether a picture is pending.
export function shown(): Viewer | null { return viewer; }
export function point(k: number): number[] { return viewer ? viewer.point(k) : []; }
export function waits(): boolean { return !viewer || viewer.waits() || timer !== undefined; }
