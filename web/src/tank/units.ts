// The user's units. R sends numbers in its default units.

import type { Units } from '../protocol';
import { on } from './events';
import * as Form from './form';

// factors to SI by dimension and unit, the default unit first
let factors: Record<string, Record<string, number>> = {};
let units: Units = {}, changed: () => void = () => {};

export function set_units(given: typeof factors): void { factors = given; }
export function preferred(): Units { return units; }
export function on_change(act: () => void): void { changed = act; }

// Returns the user's unit in place of a unit of R, and the factor to it.
export function shown_unit(unit: string): { unit: string; factor: number } {
  const dimension = Object.keys(factors).find((name) => Object.keys(factors[name])[0] === unit) ?? '';
  const wanted = units[dimension];
  if (!wanted) return { unit, factor: 1 };
  return { unit: wanted, factor: factors[dimension][unit] / factors[dimension][wanted] };
}

export function prefer(chosen: Units): void {
  units = {};
  document.querySelectorAll<HTMLSelectElement>('.preferred').forEach((select) => {
    const name = select.dataset.dimension ?? '', unit = chosen[name];
    if (unit && select.querySelector('[value="' + CSS.escape(unit) + '"]')) select.value = unit;
    units[name] = select.value;
  });
  Form.prefer(chosen);
  changed();
}
on('change', (target) => {
  if (target.classList.contains('preferred')) prefer({ ...units, [target.dataset.dimension ?? '']: target.value });
});
