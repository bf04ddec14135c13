// The tabs below the tank, and the texts and tables that R sends for the open tab.

import { render } from 'preact';
import type { FromR, Told } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as History from './history';
import * as Kept from './kept';
import * as Measures from './measures';
import { send } from './server';
import * as Slopes from './slopes';
import { note, table_of_r } from './table';
import * as Talk from './talk';
import { say } from './words';

let timer: number | undefined, stale = false, awaited = 0;
const tables: Record<string, Told['table_wanted']['name']> = {
  Tensions: 'tensions', Drag: 'drag', Changes: 'differences'
};
const all = () => Array.from(find('shown').children) as HTMLElement[];
const selected = () => all().find((tab) => tab.ariaSelected === 'true') as HTMLElement;

function open(tab: HTMLElement) {
  all().forEach((one) => {
    one.ariaSelected = String(one === tab);
    one.tabIndex = one === tab ? 0 : -1;
    find(one.id + '_panel').hidden = one !== tab;
  });
  stale = true;
  want();
}
on('click', (target) => { if (target.role === 'tab') open(target); });
on('keydown', (target, { key }) => {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
  if (target.role !== 'tab' || !step) return;
  const tabs = all().filter((tab) => tab.checkVisibility());
  const next = tabs[(tabs.indexOf(target) + step + tabs.length) % tabs.length];
  next.focus();
  open(next);
});

// Requests the content of the open tab from R.
function want() {
  window.clearTimeout(timer);
  timer = window.setTimeout(() => {
    if (Talk.waits()) { want(); return; }
    timer = undefined;
    if (!stale) return;
    stale = false;
    const name = selected().dataset.value ?? '';
    const kept = Kept.all()[0]?.design;
    if (name === 'Designs') Measures.write_designs();
    if (name === 'Slopes') Slopes.write_all();
    if (name === 'Plan') send('plan_wanted', null);
    else if (name === 'R code' && kept) send('code_wanted', { opened: History.as_opened(), kept });
    else if (tables[name]) send('table_wanted', { name: tables[name], kept });
    else return;
    awaited += 1;
  }, 50);
}
// Requests the content after a change, once nothing is pending.
export function changed(): void { stale = true; want(); }
// Returns true while content of the open tab is missing.
export function waits(): boolean { return stale || timer !== undefined || awaited > 0; }
export function lost(): void { awaited = 0; }

// Caption and heads of the tables of each tab, and a note below a table, or without rows.
const about: Record<string, { words: string[]; note?: string; empty?: string }[]> = {
  tensions: [
    { words: ['ropes_by_tension', 'part', 'largest_kn', 'mean_kn', 'breaking_load_kn', 'margin'], note: 'margin_note' },
    { words: ['netting_by_tension', 'part', 'tenth_n', 'mean_n'] }
  ],
  drag: [['drag_by_group', 'group'], ['drag_by_part', 'part']].map((first) =>
    ({ words: [...first, 'drag_kn', 'share', 'to_starboard_kn', 'lift_kn'] })),
  differences: [{ words: ['fields_differ', 'field', 'kept', 'now'], empty: 'no_difference' }]
};
const shown: Record<string, FromR['flume_table']['tables']> = {};
let chosen: string[] = [];
function write(name: string) {
  render(shown[name].map((one, k) => {
    const { words, note: below, empty } = about[name][k], [caption, ...head] = words.map((key) => say(key));
    const made = table_of_r(one, caption, head, chosen), said = made ? below : empty;
    return [made, note(said ? say(said) : null)];
  }), find(name));
}
export function show({ name, tables }: FromR['flume_table']): void {
  awaited -= 1;
  shown[name] = tables;
  write(name);
}
// Highlights the rows of these parts.
export function highlight(names: string[]): void {
  chosen = names;
  Object.keys(shown).forEach(write);
}
export function show_plan({ text }: FromR['flume_plan']): void {
  awaited -= 1;
  find<HTMLTextAreaElement>('plan_area').value = text;
}
export function show_code({ text }: FromR['flume_code']): void {
  awaited -= 1;
  find('code').textContent = text;
}
