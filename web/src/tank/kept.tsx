// The stored designs: the design as opened and designs that the user keeps. The first one is the
// reference of comparisons.

import { render } from 'preact';
import type { Design, FromR, KeptDesign, Measures } from '../protocol';
import { find, kept_colour, type Scene } from '../view';
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

function Row({ one, k, colour }: { one: Kept; k: number; colour: number }) {
  const acts = [['open', say('put_on_screen')], ['compare', k ? say('compare_with') : say('compared_with')],
    ['remove', say('remove')]];
  return <div class="kept-row">
    <input type="checkbox" checked={one.seen} aria-label={say('in_picture_of', { name: one.name })}
      title={say('in_picture')} onChange={(event) => {
        one.seen = event.currentTarget.checked || k === 0;
        changed();
      }} />
    <span class="kept-colour" style={one.seen ? { background: kept_colour(colour) } : undefined} />
    <input type="text" aria-label={say('kept_name')} maxLength={longest} value={one.name} onChange={(event) => {
      one.name = clean(event.currentTarget.value, one.name);
      changed();
    }} />
    {acts.map(([what, words]) => <button type="button" aria-label={say('of_design', { act: words, name: one.name })}
      disabled={what === 'compare' && k === 0 || what === 'remove' && kept.length === 1}
      onClick={() => act(one, what)}>{words}</button>)}
  </div>;
}
function list() {
  const before = (k: number) => kept.slice(0, k).filter((one) => one.seen).length;
  render(kept.map((one, k) => <Row key={one.id} one={one} k={k} colour={before(k)} />), find('kept_designs'));
}

on('click', ({ id }) => {
  if (id === 'keep') keep();
  else if (id === 'back' && kept.length) History.replace(kept[0].design);
});
