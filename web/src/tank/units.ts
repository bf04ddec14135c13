// The user's units.

import type { Units } from '../protocol';
import { on } from './events';
import * as Form from './form';
import { send } from './server';

let units: Units = {}, changed: () => void = () => {};

export function preferred(): Units { return units; }
export function on_change(act: () => void): void { changed = act; }

export function prefer(chosen: Units): void {
  units = {};
  document.querySelectorAll<HTMLSelectElement>('.preferred').forEach((select) => {
    const name = select.dataset.dimension ?? '', unit = chosen[name];
    if (unit && select.querySelector('[value="' + CSS.escape(unit) + '"]')) select.value = unit;
    units[name] = select.value;
  });
  send('preferred', units);
  Form.prefer(chosen);
}
on('change', (target) => {
  if (!target.classList.contains('preferred')) return;
  prefer({ ...units, [target.dataset.dimension ?? '']: target.value });
  changed();
});
