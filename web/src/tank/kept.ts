// The stored designs: the design as opened and designs that the user keeps. The first one is the
// reference of comparisons.

import type { Design, FromR, KeptDesign, Measures } from '../protocol';
import { element, find, kept_colour, type Scene } from '../view';
import * as Designs from './designs';
import { on } from './events';
import * as History from './history';
import * as Measured from './measures';
import { tell } from './notices';
import { send } from './server';
import * as Tabs from './tabs';
import * as Tank from './tank';
import { say } from './words';

export interface Kept {
  id: number; name: string; seen: boolean; design: Design; scene: Partial<Scene>; measures: Measures;
}
const most = 24, longest = 60;  // stored designs, and characters of a name
let kept: Kept[] = [], made = 0;
let waiting: KeptDesign[] = [], asked: number | null = null, replaces = false;

export function all(): Kept[] { return kept; }

function clean(name: string, otherwise: string) {
  return name.replace(/[\p{C}\s]+/gu, ' ').trim().slice(0, longest) || otherwise;
}
function add(name: string, design: Design, scene: Partial<Scene>, measures: Measures) {
  made += 1;
  kept = [...kept, { id: made, name: clean(name, 'Design ' + made), seen: true, design, scene, measures }];
}

// Stores the design on screen.
function keep(name = '') {
  const scene = Tank.scene(), measures = Measured.now();
  if (!scene || !measures) return;
  if (kept.length >= most) {
    tell('refused', say('kept_full', { n: most }));
    return;
  }
  add(name, History.on_screen(), scene, measures);
  changed();
}

// Forgets all designs; the next complete design on screen is the first one.
export function start(): void {
  kept = [];
  made = 0;
  settle([]);
}
// Stores the opened design as soon as it is complete.
export function complete(): void { if (!kept.length) keep('As opened'); }

// Settles the designs of an address in sequence. The first one replaces the opened design.
export function settle(designs: KeptDesign[]): void {
  waiting = designs.slice(0, most);
  replaces = true;
  next();
}
function next() {
  const first = waiting[0];
  asked = first ? Date.now() : null;
  if (first && asked) send('kept', { number: asked, design: first });
}
export function settled({ number, design }: FromR['flume_kept']): void {
  if (number !== asked) return;
  const { name, ...given } = waiting.shift() as KeptDesign;
  if (design) {
    if (replaces) kept = [];
    replaces = false;
    add(name, given, design.scene, { about: design.about, ...design.numbers });
    changed();
  }
  next();
}

// ---- the list -----------------------------------------------------------------------------------

function changed() {
  list();
  Tank.compare();
  Measured.write();
  Tabs.changed();
  Designs.moved();
}

function act(one: Kept, what: string) {
  if (what === 'open') History.replace(one.design);
  else {
    kept = kept.filter((other) => other !== one);
    if (what === 'compare') kept.unshift(one);
    // The reference is always visible.
    kept[0].seen = true;
    changed();
  }
}

function list() {
  let seen = 0;
  find('kept_designs').replaceChildren(...kept.map((one, k) => {
    const row = element('div', 'kept-row'), tick = element('input', '', undefined,
      { type: 'checkbox', 'aria-label': say('in_picture_of', { name: one.name }), title: say('in_picture') });
    tick.checked = one.seen;
    tick.addEventListener('change', () => {
      one.seen = tick.checked || k === 0;
      changed();
    });
    const colour = element('span', 'kept-colour');
    if (one.seen) colour.style.background = kept_colour(seen++);
    const name = element('input', '', undefined,
      { type: 'text', 'aria-label': say('kept_name'), maxlength: longest });
    name.value = one.name;
    name.addEventListener('change', () => {
      one.name = clean(name.value, one.name);
      changed();
    });
    row.append(tick, colour, name);
    [['open', say('put_on_screen')], ['compare', k ? say('compare_with') : say('compared_with')],
      ['remove', say('remove')]].forEach(([what, words]) => {
      const button = element('button', '', words,
        { type: 'button', 'aria-label': say('of_design', { act: words, name: one.name }) });
      button.disabled = what === 'compare' && k === 0 || what === 'remove' && kept.length === 1;
      button.addEventListener('click', () => act(one, what));
      row.appendChild(button);
    });
    return row;
  }));
}

on('click', ({ id }) => {
  if (id === 'keep') keep();
  else if (id === 'back' && kept.length) History.replace(kept[0].design);
});
