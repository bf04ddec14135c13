// The gear in the flume tank.

import { find, new_viewer, type Mode, type Scales, type Scene, type Viewer } from '../view';
import * as Form from './form';
import * as Kept from './kept';
import * as Predict from './predict';
import { send } from './server';

let viewer: Viewer | null = null, about: Scene | null = null;
// the last complete scene, its colour scales without stored designs, and the stored designs that the viewer has
let complete: Scene | null = null, own_scales: Scene['scales'] = {}, known: number[] = [];

// Requests from R the plan path of a clicked part.
function listen_clicks(viewer: Viewer, canvas: HTMLCanvasElement) {
  let from: number[] | null = null;
  canvas.addEventListener('pointerdown', (event) => { from = [event.clientX, event.clientY]; });
  canvas.addEventListener('click', (event) => {
    if (!about || !from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4) return;
    const box = canvas.getBoundingClientRect(), gear = viewer.gear();
    const found = viewer.under(event.clientX - box.left, event.clientY - box.top);
    if (!found) return;
    send('part_wanted', { name: found.kind === 'mark' ?
      about.marks.part[found.number] :
      about.parts.name[(found.kind === 'rope' ? gear.ropes : gear.netting).part[found.number]] });
  });
}

// Creates the viewer.
export function listen(): void {
  viewer = new_viewer(find('tank'), { still: false, passing: () => !Form.still() });
  if (viewer) listen_clicks(viewer, document.querySelector('#tank canvas') as HTMLCanvasElement);
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
}
// Shows the parts that the user has chosen.
export function highlight(names: string[]): void { viewer?.highlight(names); }

// For tests and measurements: the viewer, a node position, and whether a picture is pending.
export function shown(): Viewer | null { return viewer; }
export function point(k: number): number[] { return viewer ? viewer.point(k) : []; }
export function waits(): boolean { return !viewer || viewer.waits(); }
