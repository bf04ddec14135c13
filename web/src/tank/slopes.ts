// Effects of a small change of a field, next to the measures. The user chooses field and change; R
// computes the derivatives.

import type { FromR, Sensitivity } from '../protocol';
import { element, find } from '../view';
import { on } from './events';
import * as Form from './form';
import { tell } from './notices';
import { send } from './server';
import * as Tabs from './tabs';
import * as Talk from './talk';
import { say } from './words';

const amounts: Record<string, number> = {};
let found: Record<string, Sensitivity> = {}, timer: number | undefined;
const field = () => find<HTMLSelectElement>('more_field'), amount = () => find<HTMLInputElement>('more_amount');
function key() { return field().value; }

function ask(paths: string[] | null) {
  tell('slopes_error', '');
  send('slopes_wanted', { paths, number: Date.now() });
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

function figures(x: number, like: number) {
  const size = Math.abs(like), decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
  let text = Math.abs(x).toFixed(decimals);
  if (!/[1-9]/.test(text)) {
    if (!x) return '0';
    text = Math.abs(x).toPrecision(2);
  }
  return (x < 0 ? '\u2212' : '+') + text;
}

function write() {
  const place = find('more_does'), one = found[key()], input = amount();
  place.textContent = '';
  input.disabled = !one;
  find('more_unit').textContent = one ? one.unit : '';
  if (!one) return;
  if (document.activeElement !== input) input.value = String(amounts[key()] ?? one.more);
  const more = input.valueAsNumber;
  if (!isFinite(more)) return;
  const scroll = element('div', 'table-scroll', undefined, { tabindex: 0, role: 'region',
    'aria-label': say('would_do') });
  const table = element('table'), body = element('tbody');
  let kinks = false;
  one.measures.forEach((words, k) => {
    const change = one.slope[k] * more, below = one.below[k], above = one.above[k];
    const of_kink = (slope: number | null, sign: number) => slope === null ? '' : figures(sign * slope * more, change);
    // Measures that the field does not affect are omitted.
    if (Math.abs(change) < 1e-9) return;
    const row = element('tr'), cell = element('td', 'number', figures(change, change));
    row.appendChild(element('th', '', words + ' (' + one.units[k] + ')', { scope: 'row' }));
    if (!one.smooth[k]) {
      kinks = true;
      cell.appendChild(element('abbr', 'kink', ' ' + say('kink'), {
        title: say('kink_tip', { below: of_kink(below, -1), above: of_kink(above, 1) })
      }));
    }
    row.appendChild(cell);
    body.appendChild(row);
  });
  table.appendChild(body);
  scroll.appendChild(table);
  place.append(scroll, element('p', 'note', say('slope_at', {
    value: (Number(one.value.toPrecision(6)) + ' ' + one.unit).trim()
  }) + (kinks ? ' ' + say('kink_note') : '')));
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
