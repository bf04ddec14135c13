// The tables of measures: R sends numbers, the page writes and updates the tables.

import { render, type ComponentChildren } from 'preact';
import { decimals_of, error_digits, figures, fixed_decimals, signed } from '../numbers';
import type { FromR, MeasureAbout, Measures } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Kept from './kept';
import { tell } from './notices';
import * as Saves from './saves';
import { send } from './server';
import { note, table, text_table } from './table';
import { shown_unit } from './units';
import { say, say_measure, say_unit } from './words';

const none: Measures = { about: [], now: [], error: [] };
let shown: Measures | null = null, speaking: number | undefined;

// Returns the measures of the design on screen.
export function now(): Measures | null { return shown; }

const place_of = ({ about }: Measures, name: string) => about.findIndex((one) => one.name === name);
function number_of(measures: Measures, name: string, of: 'now' | 'error' = 'now') {
  return measures[of][place_of(measures, name)] ?? NaN;
}
// Returns the measures of all designs by name, in their order.
function union(...all: Measures[]): MeasureAbout[] {
  return [...new Map(all.flatMap(({ about }) => about).map((one) => [one.name, one])).values()];
}
function label({ label, unit }: MeasureAbout) {
  return say_measure(label) + ' (' + say_unit(shown_unit(unit).unit) + ')';
}

function interval({ level, lower, upper }: Measures, k: number, factor: number): string {
  if (typeof lower?.[k] !== 'number') return '';
  const end = (ends?: (number | null)[]) => figures((ends?.[k] ?? NaN) * factor);
  return say('interval', { level: level ?? '', low: end(lower), high: end(upper) });
}

// compares: true for columns that compare with the reference
function row(one: MeasureAbout, measures: Measures, kept: Measures, compares: boolean) {
  const { unit, factor } = shown_unit(one.unit);
  const value = number_of(measures, one.name) * factor, before = number_of(kept, one.name) * factor;
  const change = value - before, decimals = decimals_of(...[value, before].filter(isFinite));
  const digits = error_digits(number_of(measures, one.name, 'error') * factor), moved = signed(change, decimals);
  const lines = [fixed_decimals(value, decimals) + (digits && ' \u00b1 ' + digits),
    interval(measures, place_of(measures, one.name), factor)];
  const share = moved === '0' ? '0' : before === 0 ? '' : signed(100 * change / Math.abs(before), 1);
  return <tr key={one.name}>
    <th scope="row" title={one.definition}>{label(one)}</th>
    <td class="number">{window.codendServer ? lines[0] : <button type="button" class="measure-value"
      title={say('target_tip')} data-measure={one.name} data-unit={unit} data-label={label(one)}>
      {lines.filter(Boolean).join('\n')}</button>}</td>
    {compares && [fixed_decimals(before, decimals), moved, share].map((words) => <td class="number">{words}</td>)}
  </tr>;
}

function of_measures(caption: string, compares: boolean, rows: ComponentChildren) {
  const head = [say('measure'), say('now'), ...compares ? [say('kept'), say('change'), '%'] : []];
  return table(caption, head, rows);
}

// Stores the numbers of the design on screen. R sends the names only if they changed.
export function show({ about, ...numbers }: FromR['flume_measures']): void {
  shown = { about: about ?? shown?.about ?? [], ...numbers };
  Kept.complete();
  write();
  window.clearTimeout(speaking);
  speaking = window.setTimeout(() => { find('said').textContent = spoken(shown ?? none); }, 700);
}
// Returns the main measures as a sentence. After a series of changes, screen readers announce the last
// one only.
function spoken(measures: Measures): string {
  const main = measures.about.filter(({ name }, k) => k < 3 || name === 'total_drag_kN').map((one) => {
    const { unit, factor } = shown_unit(one.unit);
    return [say_measure(one.label), figures(number_of(measures, one.name) * factor), say_unit(unit)].join(' ');
  });
  return say('settled_said', { measures: main.join(', ') });
}

// Writes the numbers of the design on screen and of the reference.
export function write(): void {
  const measures = shown;
  if (!measures) return;
  const kept = Kept.all()[0]?.measures ?? none, about = union(measures, kept), { level } = measures;
  const compares = about.some(({ name }) => number_of(measures, name) !== number_of(kept, name));
  const rows = (key: boolean) =>
    about.filter((one) => one.key === key).map((one) => row(one, measures, kept, compares));
  const others = rows(false);
  const notes = [say('error_note'), window.codendServer ? '' : say('uncertainty_note'),
    level === undefined ? '' : say('interval_note', { level })];
  render([of_measures(say('key_measures'), compares, rows(true)), note(notes.filter(Boolean).join(' '))],
    find('measures'));
  render(others.length ? of_measures(say('other_measures'), compares, others) : null, find('other_measures'));
  find('measures_more').hidden = !others.length;
}

// ---- comparisons --------------------------------------------------------------------------------

function designs() {
  return [...Kept.all().map(({ name, measures }) => ({ name, measures })),
    { name: say('on_screen'), measures: shown ?? none }];
}

// Writes the table of the stored designs and of the design on screen.
export function write_designs(): void {
  const all = designs(), head = [say('measure'), ...all.map(({ name }) => name)];
  const rows = union(...all.map(({ measures }) => measures)).map((one) => {
    const { factor } = shown_unit(one.unit), values = all.map(({ measures }) => number_of(measures, one.name) * factor);
    const decimals = decimals_of(...values.filter(isFinite));
    return [label(one), ...values.map((value, k) => {
      const moved = k ? signed(value - values[0], decimals) : '';
      return fixed_decimals(value, decimals) + (moved && moved !== '0' ? '\n' + moved : '');
    })];
  });
  render(text_table(say('designs_caption'), head, rows), find('designs'));
}

// Returns a table as CSV. Spreadsheets must not run a string as a formula.
function csv(head: string[], rows: (string | number)[][]): string {
  const cell = (value: string | number) => typeof value === 'number' ? isFinite(value) ? String(value) : '' :
    '"' + value.replace(/^[=+@\t\r-]/, '\'$&').replace(/"/g, '""') + '"';
  return [head, ...rows].map((row) => row.map(cell).join(',') + '\n').join('');
}
Saves.add('save_designs', '-designs.csv', () => {
  const all = designs();
  return csv(['measure', 'unit', ...all.map(({ name }) => name)],
    union(...all.map(({ measures }) => measures)).map(({ name, label, unit }) =>
      [label, unit, ...all.map(({ measures }) => number_of(measures, name))]));
});

on('change', (target) => {
  if (target.id !== 'with_intervals') return;
  tell('uncertainty_error', '');
  send('intervals_wanted', target.checked);
});
