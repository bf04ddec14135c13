// Required values of measures. The user clicks the value of a measure, types a required value and
// chooses a field; R finds the value of the field.

import type { Edits, FromR } from '../protocol';
import { find } from '../view';
import { on } from './events';
import * as Form from './form';
import { tell } from './notices';
import { send } from './server';
import { say } from './words';

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
  value().value = (button.textContent ?? '').split('\n')[0].replace(/\s/g, '').replace('\u2212', '-');
  value().select();
  value().focus();
}

function ask() {
  answer('', '');
  send('target_wanted', {
    paths: field().value.split(' '), measure: measure.measure ?? '', unit: measure.unit ?? '', target: value().value,
    number: Date.now()
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
export function show(message: FromR['flume_target']): void {
  answer('', message.message);
  if (!message.reached) return;
  const all: Edits = {};
  message.paths.forEach((path) => { all[path] = { value: message.value, unit: message.unit }; });
  Form.edits(all);
}
// Updates the list of fields.
export function form(): void { if (!find('target_asks').hidden) Form.offer(field()); }
