// The tables of measures: R sends numbers, the page writes and updates the tables.

import { h, render, type ComponentChild } from 'preact';
import { error_digits, fixed_decimals, decimals_of, signed } from '../numbers';
import type { FromR, MeasureAbout } from '../protocol';
import { find } from '../view';
import { say } from './words';

let about: MeasureAbout[] = [];

// Stores names, units and definitions of the measures, in the order of their numbers.
export function set_about(message: FromR['flume_measures_about']): void { about = message.measures; }

function row(one: MeasureAbout, k: number, { now, error, kept, intervals }: FromR['flume_measures']) {
  const scaled = (values: (number | null)[]) => {
    const value = values[k];
    return value === null ? NaN : value * one.factor;
  };
  const value = scaled(now), before = scaled(kept), change = value - before;
  const decimals = decimals_of(...[value, before].filter(isFinite));
  const digits = error_digits(scaled(error)), moved = signed(change, decimals);
  const lines = [fixed_decimals(value, decimals), digits && say('computed_to') + ' ' + digits, intervals?.[k] ?? ''];
  return h('tr', { key: one.name },
    h('th', { scope: 'row', title: one.definition }, one.words),
    h('td', { class: 'number' }, h('button', {
      type: 'button', class: 'measure-value', title: say('target_tip'), 'data-measure': one.name, 'data-unit': one.unit,
      'data-label': one.words
    }, lines.filter(Boolean).join('\n'))),
    h('td', { class: 'number' }, fixed_decimals(before, decimals)), h('td', { class: 'number' }, moved),
    h('td', { class: 'number' }, moved === '0' ? '0' : before === 0 ? '' : signed(100 * change / Math.abs(before), 1)));
}

function table(caption: string, rows: ComponentChild[]) {
  const heads = [say('measure'), say('now'), say('kept'), say('change'), '%'];
  return h('div', { class: 'table-scroll', tabIndex: 0, role: 'region', 'aria-label': caption },
    h('table', { class: 'table table-sm flume-table' }, h('caption', null, caption),
      h('thead', null, h('tr', null, heads.map((words, k) =>
        h('th', { scope: 'col', class: k ? 'number' : undefined }, words)))),
      h('tbody', null, rows)));
}

// Shows the numbers of the design on screen and of the kept design.
export function show(message: FromR['flume_measures']): void {
  const rows = (key: boolean) => about.map((one, k) => one.key === key && row(one, k, message)).filter(Boolean);
  const others = rows(false), level = message.level;
  render([table(say('key_measures'), rows(true)), h('p', { class: 'note' }, say('error_note'),
    level === null ? '' : ' ' + say('interval_note', { level }))], find('measures'));
  render(others.length ? table(say('other_measures'), others) : null, find('other_measures'));
  find('measures_more').hidden = !others.length;
}
