// Measures against a field of the design. The user chooses the range; R settles the gears.

import type { FromR } from '../protocol';
import { find, type Measured } from '../view';
import { on } from './events';
import * as Form from './form';
import { new_graphs } from './graphs';
import { tell } from './notices';
import { send } from './server';
import { shown_unit } from './units';
import { say, say_measure, say_path, say_unit } from './words';

let graphs: ReturnType<typeof new_graphs> | null = null, field = '', last: FromR['flume_varied'] | null = null;
const input = (id: string) => find<HTMLInputElement>(id);

// Sets the range to the limits of the field's slider.
function ends() {
  const select = find<HTMLSelectElement>('vary_field');
  if (select.value === field) return;
  field = select.value;
  const one = Form.field(field.split(' ')[0]);
  const end = (value?: number) => one && value !== undefined ? (value + ' ' + one.unit).trim() : '';
  input('vary_from').value = end(one?.low);
  input('vary_to').value = end(one?.high);
}

// Updates the list of fields.
export function form(): void {
  Form.offer(find('vary_field'));
  ends();
}

// Draws the results so far.
export function show(message: FromR['flume_varied']): void {
  last = message;
  write();
}
export function write(): void {
  if (!last) return;
  const { varied, running } = last, done = varied.values.length;
  const drawn = graphs = graphs || new_graphs(find('vary_graphs'), find('vary_more'), (words) => words.slice(0, 4));
  find('varied').hidden = false;
  find('vary_stop').hidden = !running;
  const wrong = varied.values.map((value, k) =>
    varied.problems[k] && value + ' ' + varied.unit + ': ' + varied.problems[k]).filter(Boolean);
  find('vary_said').textContent = say('values_done', { done, of: varied.of }) + (running ? ' \u2026' : '') +
    (wrong.length ? '. ' + wrong.join(' ') : '');
  if (!varied.measures.length) return;
  const { now } = varied, measures = varied.measures.map((one) => {
    const { unit, factor } = shown_unit(one.unit);
    const scaled = (values: Measured['values'] = []) =>
      values.map((value) => typeof value === 'number' ? value * factor : value);
    const words = say_measure(one.words) + ' (' + say_unit(unit) + ')';
    return { words, values: scaled(one.values), errors: scaled(one.errors) };
  });
  drawn.show(measures, {
    times: varied.values, range: varied.range, unit: varied.unit,
    axis: say_path(varied.path) + (varied.unit ? ' (' + varied.unit + ')' : ''),
    drawn: () => { if (now !== null) drawn.mark(now); }
  });
}

// Marks the results as out of date after a change of the design.
export function stale(): void {
  if (!find('varied').hidden) tell('vary_stale', say('vary_stale'));
}

on('change', ({ id }) => { if (id === 'vary_field') ends(); });
on('click', ({ id }) => {
  if (id === 'vary_stop') send('vary_stop', null);
  if (id !== 'vary_start') return;
  tell('vary_error', '');
  tell('vary_stale', '');
  send('vary_wanted', {
    paths: field.split(' '), unit: Form.field(field.split(' ')[0])?.unit ?? '', from: input('vary_from').value,
    to: input('vary_to').value, number: input('vary_number').valueAsNumber
  });
});
