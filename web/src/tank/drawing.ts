// The net drawing in the flume tank, which is also an editor. Users zoom and pan, click a number to
// change it, or drag the lower edge of a panel to make it deeper.

import { element, find, listen_pointers } from '../view';
import { on } from './events';
import * as Form from './form';
import { tell } from './notices';
import { send } from './server';
import { say, say_path } from './words';

type Thing = SVGGraphicsElement;
interface Grip { path: string; deep: number; box: DOMRect; rect: SVGRectElement }

// box: the visible part [left, top, width, height], whole: the sheet (mm), sought: path to scroll to
let box: number[] | null = null, whole = [0, 0, 1, 1], sought: string | null = null, wrong_paths: string[] = [];
let timer: number | undefined, stale = true, handle: Grip | null = null;
const legible = 11;  // px, the smallest letters when the drawing opens
function seen() { return find('drawing').clientWidth > 0; }
function svg(): SVGSVGElement | null { return find('drawing').querySelector('svg'); }
function things(selector: string): Thing[] { return Array.from(svg()?.querySelectorAll<Thing>(selector) ?? []); }

// Requests a new drawing from R if it is visible and out of date.
export function want(moved = false): void {
  if (moved) stale = true;
  window.clearTimeout(timer);
  if (!stale || !seen()) return;
  timer = window.setTimeout(() => {
    stale = false;
    send('drawing_wanted', null);
  }, 600);
}

// Plans can come from strangers, so scripts and links are removed.
function harmless(root: Element) {
  root.querySelectorAll('script, foreignObject, iframe, image, use, animate, set, style, a')
    .forEach((one) => { one.remove(); });
  [root, ...root.querySelectorAll('*')].forEach((one) => {
    Array.from(one.attributes).forEach((attribute) => {
      if (/^on|href$/i.test(attribute.name)) one.removeAttribute(attribute.name);
    });
  });
  return root;
}

// Shows an SVG.
export function show(text: string): void {
  const found = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  if (found.nodeName !== 'svg') return;
  const made = document.importNode(harmless(found), true) as unknown as SVGSVGElement, place = find('drawing');
  const focused = document.activeElement as HTMLElement | null;
  const at = focused && place.contains(focused) && focused.dataset.path;
  made.removeAttribute('width');
  made.removeAttribute('height');
  place.querySelectorAll('svg').forEach((one) => { one.remove(); });
  place.appendChild(made);
  handle = null;
  made.querySelectorAll<Thing>('[data-path]').forEach((one) => {
    one.setAttribute('tabindex', '0');
    one.setAttribute('role', 'button');
    const shown = one.querySelector('text');
    one.setAttribute('aria-label', say('change_field', { field: say_path(path_of(one)) }) +
      (shown ? ': ' + shown.textContent : ''));
    if (one.dataset.path === at) one.focus({ preventScroll: true });
  });
  whole = (made.getAttribute('viewBox') ?? '').split(' ').map(Number);
  look();
  mark();
  if (sought) seek(sought);
}

// ---- zoom and pan -------------------------------------------------------------------------------

// Zooms so that the smallest letters are legible, and starts at the first panel and, if they fit,
// the columns of text to its left.
function open_view() {
  const place = find('drawing'), sizes = things('[data-path] text').map((one) => Number(one.getAttribute('font-size')));
  const least = sizes.length ? Math.min(...sizes) : 2.5;
  const wide = Math.min(whole[2], place.clientWidth * least / legible);
  box = [whole[0], whole[1], wide, wide * place.clientHeight / place.clientWidth];
  const [first] = things('[data-component="panel"]');
  if (!first) return see_all();
  if (wide < whole[2]) {
    const b = first.getBBox(), middle = b.x + b.width / 2;
    const text = Math.min(...things('text').map((one) => one.getBBox().x)) - 2;
    box[0] = Math.max(0, middle - 0.75 * box[2], Math.min(middle - 0.5 * box[2], text));
    box[1] = Math.max(0, b.y - 0.1 * box[3]);
  }
}

function look() {
  if (!svg() || !seen()) return;
  if (!box) open_view();
  if (!box) return;
  const place = find('drawing');
  box[3] = box[2] * place.clientHeight / Math.max(place.clientWidth, 1);
  svg()?.setAttribute('viewBox', box.map((v) => v.toFixed(3)).join(' '));
}

function see_all() {
  const place = find('drawing'), wide = Math.max(whole[2], whole[3] * place.clientWidth / place.clientHeight);
  box = [whole[0] - (wide - whole[2]) / 2, whole[1], wide, 0];
  look();
}

// `by` is a factor on the visible width, below 1 to zoom in. `x` and `y` are the fixed point
// as fractions of the picture.
function zoom(by: number, x: number, y: number) {
  if (!box) return;
  const share = Math.min(Math.max(by, 5 / box[2]), 1.3 * Math.max(whole[2], whole[3]) / box[2]);
  box[0] += box[2] * (1 - share) * x;
  box[1] += box[3] * (1 - share) * y;
  box[2] *= share;
  look();
}
function pan(dx: number, dy: number) {
  if (!box) return;
  box[0] += dx * box[2];
  box[1] += dy * box[3];
  look();
}

// Scrolls to an element that is out of sight.
function bring(thing: Thing) {
  if (!box) return;
  const b = thing.getBBox(), x = b.x + b.width / 2, y = b.y + b.height / 2;
  if (x > box[0] && y > box[1] && x < box[0] + box[2] && y < box[1] + box[3]) return;
  box[0] = within(whole[0], whole[2], x - box[2] / 2, box[2]);
  box[1] = within(whole[1], whole[3], y - box[3] / 2, box[3]);
  look();
}
function within(low: number, size: number, from: number, length: number) {
  return Math.max(low, Math.min(from, low + size - length));
}
// Scrolls to a part now, or when it is next drawn.
export function seek(path: string): void {
  const [thing] = things('[data-path="' + CSS.escape(path) + '"]');
  sought = thing ? null : path;
  if (!thing || !box) return;
  bring(thing);
  choose(thing);
}

let moved = () => 0;
function thing_of(event: Event) { return (event.target as Element).closest<Thing>('[data-path]'); }
function path_of(thing: Thing) { return thing.dataset.path ?? ''; }
const in_form = (event: Event) => (event.target as Element).closest('.typed');
export function listen() {
  const place = find('drawing');
  moved = listen_pointers(place, {
    down(event) {
      if (in_form(event)) return false;
      if ((event.target as Element).classList.contains('edge-handle')) begin_drag(event);
    },
    move(dx, dy, event) {
      if (dragged) drag(event);
      else if (moved() > 4) pan(-dx / place.clientWidth, -dy / place.clientHeight);
    },
    zoom(by, x, y) { if (!dragged) zoom(1 / by, x / place.clientWidth, y / place.clientHeight); },
    up() { if (dragged) end_drag(); },
    wheels: () => !!box
  });
  new ResizeObserver(() => { look(); want(); }).observe(place);
  place.addEventListener('keydown', (event) => {
    if (!box || in_form(event)) return;
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]
    };
    const thing = thing_of(event);
    if (steps[event.key]) pan(...steps[event.key]);
    else if (event.key === '+' || event.key === '=') zoom(0.8, 0.5, 0.5);
    else if (event.key === '-') zoom(1.25, 0.5, 0.5);
    else if (event.key === '0') see_all();
    else if ((event.key === 'Enter' || event.key === ' ') && thing) change(thing);
    else return;
    event.preventDefault();
  });
  place.addEventListener('focusin', (event) => {
    const thing = thing_of(event);
    if (!thing || !box || moved()) return;
    bring(thing);
  });
  place.addEventListener('click', (event) => {
    const thing = thing_of(event);
    if (moved() > 4 || !thing) return;
    change(thing);
  });
}

// ---- edits --------------------------------------------------------------------------------------

// Edits a clicked element: a value in place, a part in the form.
function change(thing: Thing) {
  const path = path_of(thing), field = Form.field(path), text = thing.querySelector('text');
  choose(thing);
  tell_chosen(path);
  if (text && field) type_in(thing, path, field);
  else if (!Form.open(path, true)) {
    tell('refused', say('no_form_field', { path }));
  }
  if (!text) grip(thing, path);
}

// Returns the elements that display the value of a field.
function figures(path: string) {
  return things('[data-path="' + CSS.escape(path) + '"]')
    .filter((one) => one.querySelector('text'));
}

// Returns the editable elements in the order of the Tab key: part by part, each field once.
function by_part() {
  const parts = new Map<string, Thing[]>(), seen = new Set<string>();
  things('[data-path]').forEach((one) => {
    const path = path_of(one), part = path.replace(/[.](meshes|twine|mesh_size|cutting)([.].*)?$/, '');
    if (seen.has(path) || !one.querySelector('text') || !Form.field(path)) return;
    seen.add(path);
    parts.set(part, [...parts.get(part) ?? [], one]);
  });
  return [...parts.values()].flat();
}

let chosen = '';
// A part was chosen in the drawing or the form.
function tell_chosen(path: string) {
  if (path !== chosen) send('part_wanted', { path });
  chosen = path;
}
on('focusin', (target) => {
  const path = target.closest<HTMLElement>('#form .part')?.dataset.path;
  if (!path || path === chosen) return;
  tell_chosen(path);
  seek(path);
});
function choose(thing: Element) {
  document.querySelectorAll('#drawing .chosen').forEach((one) => { one.classList.remove('chosen'); });
  thing.classList.add('chosen');
}

function type_in(thing: Thing, path: string, field: Form.ShownField) {
  const place = find('drawing'), old = place.querySelector('.typed');
  if (old) old.remove();
  const r = thing.getBoundingClientRect(), home = place.getBoundingClientRect();
  const row = element('form', 'typed control-row'), input = element(field.kind === 'choice' ? 'select' : 'input',
    '', undefined, { 'aria-label': say_path(path), autocomplete: 'off' });
  if (field.kind === 'choice') {
    field.choices.forEach((one) => { input.appendChild(element('option', '', one, { value: one })); });
  }
  input.value = String(field.value ?? '');
  row.appendChild(input);
  if (field.unit) row.appendChild(element('span', 'note', field.unit));
  row.style.left = Math.max(0, Math.min(r.left - home.left, home.width - 150)) + 'px';
  row.style.top = Math.max(0, Math.min(r.bottom - home.top, home.height - 40)) + 'px';
  let done = false;
  function finish(keep: boolean) {
    if (done) return;
    done = true;
    const typed = String(input.value).trim();
    row.remove();
    if (keep && typed && typed !== String(field.value)) {
      figures(path).forEach((one) => {
        const text = one.querySelector('text') as SVGTextElement;
        text.textContent = typed;
        text.removeAttribute('textLength');
      });
      Form.edit(path, { value: typed, unit: field.unit });
    }
    const now = figures(path)[0];
    if (now) now.focus({ preventScroll: true });
  }
  row.addEventListener('submit', (event) => { event.preventDefault(); finish(true); });
  const control: HTMLElement = input;
  control.addEventListener('keydown', (event) => {
    event.stopPropagation();
    if (event.key === 'Escape') { finish(false); return; }
    if (event.key !== 'Tab') return;
    event.preventDefault();
    const all = by_part(), paths = all.map(path_of);
    const next = all[paths.indexOf(path) + (event.shiftKey ? -1 : 1)];
    finish(true);
    if (next) { next.focus(); change(next); }
  });
  control.addEventListener('blur', () => { finish(true); });
  place.appendChild(row);
  input.focus();
  if (input instanceof HTMLInputElement) input.select();
}

// Adds a handle to the lower edge of a chosen panel.
let dragged: { grip: Grip; from: number; deep: number } | null = null;
function grip(thing: Thing, path: string) {
  handle?.rect.remove();
  handle = null;
  const field = Form.field(path + '.meshes.deep'), shape = thing.querySelector('polygon'), sheet = svg();
  if (!field || !shape || !sheet || typeof field.value !== 'number') return;
  const b = shape.getBBox(), rect = document.createElementNS(sheet.namespaceURI, 'rect') as SVGRectElement;
  rect.setAttribute('class', 'edge-handle');
  Object.entries({ x: b.x, y: b.y + b.height - 1, width: b.width, height: 2 })
    .forEach(([name, value]) => { rect.setAttribute(name, String(value)); });
  handle = { path: path + '.meshes.deep', deep: field.value, box: b, rect };
  sheet.appendChild(rect);
}
function begin_drag(event: PointerEvent) {
  if (!handle) return;
  dragged = { grip: handle, from: event.clientY, deep: handle.deep };
  find('drawing').setPointerCapture(event.pointerId);
}
function drag(event: PointerEvent) {
  if (!dragged || !box) return;
  const about = dragged.grip, mm = box[3] / find('drawing').clientHeight * (event.clientY - dragged.from);
  dragged.deep = Math.max(1, Math.round(about.deep * (1 + mm / about.box.height)));
  about.rect.setAttribute('y', String(about.box.y + about.box.height * dragged.deep / about.deep - 1));
  find('drawing_said').textContent = say('meshes_deep', { n: dragged.deep });
}
function end_drag() {
  const one = dragged;
  dragged = null;
  if (one && one.deep !== one.grip.deep) Form.edit(one.grip.path, { value: one.deep, unit: '' });
}

// ---- problems -----------------------------------------------------------------------------------

// Marks fields with problems.
export function wrong(paths: string[]): void {
  wrong_paths = paths;
  mark();
}
function mark() {
  things('[data-path]').forEach((one) => {
    const path = path_of(one);
    one.classList.toggle('wrong', wrong_paths.some((wrong) =>
      wrong && (wrong === path || wrong.startsWith(path + '.') || path.startsWith(wrong + '.'))));
  });
}

// Enlarges the drawing or the tank, or shows both again.
function see(name: string) {
  const flume = find('flume'), seen = flume.dataset.seen === name ? '' : name;
  flume.dataset.seen = seen;
  ['drawing', 'tank'].forEach((one) => find('see_' + one).setAttribute('aria-pressed', String(one === seen)));
}
// Shows a part of the page on a phone.
export function sheet(name: string): void {
  find('flume').dataset.sheet = name;
  document.querySelectorAll<HTMLElement>('.sheet').forEach((one) => {
    one.setAttribute('aria-pressed', String(one.dataset.sheet === name));
  });
}
on('keydown', (target, event) => {
  const name = { d: 'drawing', t: 'tank' }[event.key.toLowerCase()];
  if (!name || event.ctrlKey || event.altKey || event.metaKey || target.matches('input, select, textarea')) return;
  if (!find('design').hidden) see(name);
});
on('click', ({ id, dataset, classList }) => {
  if (id === 'see_tank' || id === 'see_drawing') see(id.replace('see_', ''));
  else if (classList.contains('sheet')) sheet(dataset.sheet ?? '');
  else if (id === 'drawing_in') zoom(0.8, 0.5, 0.5);
  else if (id === 'drawing_out') zoom(1.25, 0.5, 0.5);
  else if (id === 'drawing_all' && box) see_all();
});
// Resets the view for another plan.
export function opened(): void { box = sought = null; }
