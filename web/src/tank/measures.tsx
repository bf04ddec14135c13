// The tables of measures: R sends numbers, the page writes and updates the tables.

import { render, type ComponentChildren } from 'preact';
import { error_digits, fixed_decimals, decimals_of, signed } from '../numbers';
import type { FromR, MeasureAbout } from '../protocol';
import { find } from '../view';
import { on } from './events';
import { tell } from './notices';
import { send } from './server';
import { note, table } from './table';
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
  const share = moved === '0' ? '0' : before === 0 ? '' : signed(100 * change / Math.abs(before), 1);
  return <tr key={one.name}>
    <th scope="row" title={one.definition}>{one.words}</th>
    <td class="number"><button type="button" class="measure-value" title={say('target_tip')} data-measure={one.name}
      data-unit={one.unit} data-label={one.words}>{lines.filter(Boolean).join('\n')}</button></td>
    {[fixed_decimals(before, decimals), moved, share].map((words) => <td class="number">{words}</td>)}
  </tr>;
}

function of_measures(caption: string, rows: ComponentChildren) {
  const head = [say('measure'), say('now'), say('kept'), say('change'), '%'];
  return table({ caption, head, numbers: head.map((_, k) => k > 0), foot: null }, rows);
}

// Shows the numbers of the design on screen and of the kept design.
export function show(message: FromR['flume_measures']): void {
  const rows = (key: boolean) => about.map((one, k) => one.key === key && row(one, k, message)).filter(Boolean);
  const others = rows(false), level = message.level;
  render([of_measures(say('key_measures'), rows(true)), note(say('error_note') +
    (level === null ? '' : ' ' + say('interval_note', { level })))], find('measures'));
  render(others.length ? of_measures(say('other_measures'), others) : null, find('other_measures'));
  find('measures_more').hidden = !others.length;
}

on('change', (target) => {
  if (target.id !== 'with_intervals') return;
  tell('uncertainty_error', '');
  send('intervals_wanted', target.checked);
});
