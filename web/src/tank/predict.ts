// The linear prediction of the shape while a number changes, until R sends the settled shape. R
// computes the derivative when the user reaches for a slider; then the last two settled shapes give it.

import type { Edits, PredictionHeader } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Form from './form';
import { send } from './server';
import * as Tank from './tank';

const arrays = ['points', 'places', 'boards'] as const;
export type Shape = Record<typeof arrays[number], Float32Array>;

// the last settled shape, the paths of the moving field, its values (SI) in that shape and now, and the
// derivative of the shape by it
let settled: Shape | null = null, field = '', at = NaN, now = NaN, slope: Shape | null = null;
let asked = false;
const values = new Map<number, number>();  // of the field, by number of the request

function each(act: (name: keyof Shape, k: number) => number, like: Shape): Shape {
  const of = (name: keyof Shape) => like[name].map((_, k) => act(name, k));
  return { points: of('points'), places: of('places'), boards: of('boards') };
}
function alike(one: Shape | null, other: Shape | null): boolean {
  return !!one && !!other && arrays.every((name) => one[name].length === other[name].length);
}
const by_floats = (shape: Shape) => Object.fromEntries(arrays.map((name) => [name, { floats: shape[name] }]));

// Returns the shape to draw instead of the settled one, or nothing.
function predicted(): Partial<ReturnType<typeof by_floats>> {
  const from = settled, by = slope, change = now - at;
  const moves = !!from && !!by && Math.abs(change) > 1e-9 * Math.abs(at);
  find('flume').classList.toggle('predicts', moves);
  find('predicted').hidden = !moves;
  return moves ? by_floats(each((name, k) => from[name][k] + change * by[name][k], from)) : {};
}
function draw() {
  const shape = predicted();
  if (shape.points) Tank.moved(shape);
}
function forget(paths = '') {
  field = paths;
  slope = null;
  at = now = NaN;
  asked = false;
  values.clear();
}

// Requests the derivative by a field that the user is about to move.
function reach(target: HTMLElement) {
  const box = target.closest<HTMLElement>('.control'), paths = box?.dataset.paths ?? '';
  if (!box?.querySelector('[type=range]') || !Form.still() || field === paths && (slope || asked)) return;
  forget(paths);
  asked = true;
  send('prediction_wanted', { paths: paths.split(' ') });
}
(['pointerover', 'pointerdown', 'focusin'] as const).forEach((name) => on(name, reach));
// A new gear has a form. The first request prepares R's process for all later ones.
export function start(): void {
  const slider = document.querySelector<HTMLElement>('#quick [type=range]');
  if (slider) reach(slider);
}

export function take({ predicts, value }: PredictionHeader, derivative: Shape): void {
  if (predicts.join(' ') !== field || !alike(settled, derivative)) return;
  slope = derivative;
  at = value;
  draw();
}
// A field has a new value (SI).
export function move(paths: string, value: number): void {
  if (paths !== field) forget(paths);
  now = value;
  draw();
}
// The page sends changes. number: of the request.
export function sent(number: number, edits: Edits): void {
  if (Object.keys(edits).join(' ') === field) values.set(number, now);
}

// Takes the settled shape of a request. same: true if its parts are the same as before. Returns a
// prediction to draw instead if the field has moved on.
export function settle(number: number, shape: Shape, same: boolean) {
  const value = values.get(number), before = settled, change = (value ?? NaN) - at;
  values.delete(number);
  settled = shape;
  if (value === undefined) forget();
  else {
    if (!same || !alike(before, shape)) slope = null;
    else if (change && before) slope = each((name, k) => (shape[name][k] - before[name][k]) / change, shape);
    at = value;
  }
  return predicted();
}
// Shows the settled shape again if R does not settle the present value.
export function stop(): void {
  if (!settled || !Form.still() || find('predicted').hidden) return;
  now = at;
  Tank.moved({ ...by_floats(settled), ...predicted() });
}
// Returns the last settled shape.
export function last() { return settled ? by_floats(settled) : {}; }
