// Required values of measures. The user clicks the value of a measure, types a required value and
// chooses a field; R finds the value of the field.

import { figures } from '../numbers';
import type { Edits, FromR } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Form from './form';
import { tell } from './notices';
import { send } from './server';
import { shown_unit } from './units';
import { say, say_measure, say_path, say_unit } from './words';

let measure: DOMStringMap = {};
const field = () => find<HTMLSelectElement>('target_field'), value = () => find<HTMLInputElement>('target_value');
function answer(error: string, said: string) {
  tell('target_error', error);
  find('target_said').textContent = said;
}

function open(button: HTMLElement) {
  measure = button.dataset;
  find('target_label').textContent = say('target_required', { measure: measure.label });
  Form.offer(field());
  answer('', '');
  find('target_asks').hidden = false;
  value().value = (button.textContent ?? '').split(/[\n\u00b1]/)[0].replace(/\s/g, '').replace('\u2212', '-');
  value().select();
  value().focus();
}

function ask() {
  answer('', '');
  send('target_wanted', {
    paths: field().value.split(' '), measure: measure.measure ?? '', unit: measure.unit ?? '', target: value().value
  });
}

on('click', (target) => {
  const button = target.closest<HTMLElement>('.measure-value');
  if (button) open(button);
  if (target.id === 'target_start') ask();
  if (target.id === 'target_close') find('target_asks').hidden = true;
});
on('keydown', (target, event) => { if (target.id === 'target_value' && event.key === 'Enter') ask(); });

// Sets the field to R's result, or reports the nearest value.
export function show(found: FromR['flume_target']): void {
  const { unit, factor } = shown_unit(found.measure_unit);
  const in_words = (value: number) => (figures(value * factor) + ' ' + say_unit(unit)).trim();
  const of_field = (value: number) => (value + ' ' + found.unit).trim();
  answer('', say(found.reached ? 'target_reached' : 'target_nearest', {
    field: say_path(found.paths[0]), value: of_field(found.value), measure: say_measure(found.measure),
    result: in_words(found.result),
    low: of_field(found.low), high: of_field(found.high), target: in_words(found.target)
  }));
  if (!found.reached) return;
  const all: Edits = {};
  found.paths.forEach((path) => { all[path] = { value: found.value, unit: found.unit }; });
  Form.edits(all);
}
// Updates the list of fields.
export function form(): void { if (!find('target_asks').hidden) Form.offer(field()); }
