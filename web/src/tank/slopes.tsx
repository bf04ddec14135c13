// Effects of a small change of a field, next to the measures. The user chooses field and change; R
// computes the derivatives.

import { render } from 'preact';
import { decimals_of, signed } from '../numbers';
import type { FromR, Sensitivity } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Form from './form';
import { tell } from './notices';
import { send } from './server';
import { note, table, text_table } from './table';
import * as Tabs from './tabs';
import * as Talk from './talk';
import { shown_unit } from './units';
import { say, say_measure, say_path, say_unit } from './words';

const amounts: Record<string, number> = {};
let found: Record<string, Sensitivity> = {}, timer: number | undefined;
const field = () => find<HTMLSelectElement>('more_field'), amount = () => find<HTMLInputElement>('more_amount');
function key() { return field().value; }

function ask(paths: string[] | null) {
  tell('slopes_error', '');
  send('slopes_wanted', { paths });
}

// Updates the list of fields, and requests derivatives of the chosen field if it is visible and unknown,
// after pending requests.
export function form(): void {
  window.clearTimeout(timer);
  if (!find<HTMLDetailsElement>('more_of').open) return;
  Form.offer(field(), /^floats\.number/);
  const one = found[key()];
  write();
  if (one || !key()) return;
  timer = window.setTimeout(() => {
    if (Talk.waits()) { form(); return; }
    ask(key().split(' '));
  }, 300);
}

// Returns the row of a measure, null if the field does not affect it.
function row(one: Sensitivity, k: number, more: number) {
  const { unit, factor } = shown_unit(one.units[k]), change = one.slope[k] * more * factor;
  const decimals = decimals_of(change);
  if (Math.abs(change) < 1e-9) return null;
  const of_kink = (slope: number | null, sign: number) =>
    slope === null ? '' : signed(sign * slope * more * factor, decimals);
  const tip = () => say('kink_tip', { below: of_kink(one.below[k], -1), above: of_kink(one.above[k], 1) });
  return <tr>
    <th scope="row">{say_measure(one.measures[k]) + ' (' + say_unit(unit) + ')'}</th>
    <td class="number">{signed(change, decimals)}
      {!one.smooth[k] && <abbr class="kink" title={tip()}>{' ' + say('kink')}</abbr>}</td>
  </tr>;
}

export function write(): void {
  const place = find('more_does'), one = found[key()], input = amount();
  input.disabled = !one;
  find('more_unit').textContent = one ? one.unit : '';
  if (one && document.activeElement !== input) input.value = String(amounts[key()] ?? one.more);
  const more = input.valueAsNumber;
  if (!one || !isFinite(more)) {
    render(null, place);
    return;
  }
  const head = [say('measure'), say('change')], rows = one.measures.map((_, k) => row(one, k, more));
  const kinks = rows.some((cells, k) => cells && !one.smooth[k]);
  render([
    table(say('would_do'), head, rows),
    note(say('slope_at', { value: (Number(one.value.toPrecision(6)) + ' ' + one.unit).trim() }) +
      (kinks ? ' ' + say('kink_note') : ''))
  ], place);
}

// Writes the table of all known fields: changes in percent of the measure for 10 % more of the field.
export function write_all(): void {
  const fields = Object.values(found), head = [say('measure'), ...fields.map(({ paths }) => say_path(paths[0]))];
  const measures = [...new Set(fields.flatMap((one) => one.measures))];
  const rows = measures.map((words) => [say_measure(words), ...fields.map(({ measures, elasticity, smooth }) => {
    const k = measures.indexOf(words), share = elasticity[k] ?? NaN;
    const text = signed(10 * share, Math.abs(share) < 0.1 ? 2 : 1);
    return text && text !== '0' && !smooth[k] ? text + ' *' : text;
  })]).filter((cells) => cells.slice(1).some((text) => text && text !== '0'));
  render(fields.length ? [text_table(say('slopes_caption'), head, rows), note(say('slopes_star'))] : null,
    find('slopes'));
}

// Adds R's results to the known ones.
export function show({ fields }: FromR['flume_sensitivities']): void {
  fields.forEach((one) => { found[one.paths.join(' ')] = one; });
  write();
  Tabs.changed();
}
// Discards all results after a change of the design.
export function stale(): void { found = {}; form(); }

// This event does not bubble.
document.addEventListener('toggle', (event) => { if ((event.target as Element).id === 'more_of') form(); }, true);
on('change', ({ id }) => { if (id === 'more_field') form(); });
on('input', (target) => {
  if (target.id !== 'more_amount') return;
  amounts[key()] = target.valueAsNumber;
  write();
});
on('click', ({ id }) => {
  if (id === 'slopes_table') ask(null);
  if (id !== 'slopes_all') return;
  ask(null);
  const tab = document.querySelector('#shown [data-value="Slopes"]') as HTMLElement;
  tab.click();
  tab.scrollIntoView({ block: 'start' });
});
