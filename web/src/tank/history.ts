// The design of the page and its history. R settles the designs and stores none of them.

import type { Design, Edit, Edits } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Form from './form';
import { send } from './server';
import * as Talk from './talk';

interface State { past: Design[]; now: Design; future: Design[]; gesture: number }
const most = 60;  // undo steps
let state: State = { past: [], now: {}, future: [], gesture: -1 };
let shown: Design = {}, opened: Design = {};  // the designs of the last picture and of the last opened gear
// designs of requests by number, and the history before them
const sent = new Map<number, { design: Design; before: State }>();

export function current(): Design { return state.now; }
export function on_screen(): Design { return shown; }
export function as_opened(): Design { return opened; }
// Returns true if the page has a design.
export function has_design(): boolean { return shown.base !== undefined || shown.plan !== undefined; }

// A later value of a field replaces an earlier one; other changes stay in their order.
function is_value(edit: Edit): boolean { return typeof edit !== 'object' || 'value' in edit || 'gone' in edit; }
export function with_edits({ edits = [], ...start }: Design, added: Edits): Design {
  const all = Array.isArray(edits) ? edits : [edits], last = all[all.length - 1];
  const values = last && [last, added].every((some) => Object.values(some).every(is_value));
  if (!values) return { ...start, edits: [...all, added] };
  const others = Object.entries(last).filter(([path]) => !(path in added));
  return { ...start, edits: [...all.slice(0, -1), { ...Object.fromEntries(others), ...added }] };
}

function set(next: State) {
  state = next;
  find<HTMLButtonElement>('undo').disabled = !state.past.length;
  find<HTMLButtonElement>('redo').disabled = !state.future.length;
}

// Starts a history. number: of the request that opened the design.
export function start(design: Design, number: number): void {
  opened = design;
  set({ past: [], now: design, future: [], gesture: -1 });
  sent.clear();
  sent.set(number, { design, before: state });
}
// Notes the number of the request that opens the design on screen again.
export function again(number: number): void { sent.set(number, { design: shown, before: state }); }

// Adds a step. Changes of one gesture are one step. number: of the request.
function add(design: Design, gesture: number, number?: number) {
  const before = state, { past, now } = state;
  const first = gesture < 0 || gesture !== state.gesture;
  set({ past: first ? [...past, now].slice(-most) : past, now: design, future: [], gesture });
  if (number !== undefined) sent.set(number, { design, before });
}
export function change(edits: Edits, gesture: number, number?: number): void {
  add(with_edits(state.now, edits), gesture, number);
}

// Sends the whole design. before: history before the last change. Returns the number of the request.
export function settle(before = state): number {
  const number = Talk.next();
  sent.set(number, { design: state.now, before });
  send('design', { number, turn: Form.turn() ?? 0, design: state.now, anew: true });
  return number;
}
// Replaces the design in one step.
export function replace(design: Design): number {
  Form.flush();
  const before = state;
  add(design, -1);
  return settle(before);
}
function step(name: 'undo' | 'redo') {
  Form.flush();
  const { past, now, future } = state, back = name === 'undo', from = back ? past : future;
  const next = from[from.length - 1];
  if (!next) return;
  const rest = from.slice(0, -1);
  set(back ? { past: rest, now: next, future: [...future, now], gesture: -1 } :
    { past: [...past, now], now: next, future: rest, gesture: -1 });
  settle();
}

// A picture shows the design of a request.
export function settled(number: number): void {
  const found = sent.get(number);
  if (found) shown = found.design;
  sent.forEach((_, other) => { if (other < number) sent.delete(other); });
}
// R has not changed its design by this request.
export function refused(number: number): void {
  const found = sent.get(number);
  if (found && state.now === found.design) set(found.before);
}

on('click', ({ id }) => { if (id === 'undo' || id === 'redo') step(id); });
on('keydown', (target, event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  // Text fields have their own undo.
  if (/^(text|search)$/.test(target.type) || target.tagName === 'TEXTAREA') return;
  const key = event.key.toLowerCase();
  const name = key === 'z' ? (event.shiftKey ? 'redo' : 'undo') : key === 'y' ? 'redo' : null;
  if (!name) return;
  event.preventDefault();
  step(name);
});
