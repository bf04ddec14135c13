// The user's units. R sends numbers in its default units.

import type { FromR, Units } from '../protocol';
import { on } from './events';

// units: factors to SI by dimension and unit; preferred: units to choose from, the default one first
let known: Pick<FromR['flume_begin'], 'units' | 'preferred'> = { units: {}, preferred: {} };
let units: Units = {}, changed: () => void = () => {};

export function set_units(given: typeof known): void { known = given; }
export function preferred(): Units { return units; }
export function on_change(act: () => void): void { changed = act; }
export function factors_of(dimension: string | null): Record<string, number> {
  return known.units[dimension ?? ''] ?? {};
}

// Returns the user's unit in place of a unit of R, and the factor to it.
export function shown_unit(unit: string): { unit: string; factor: number } {
  const dimension = Object.keys(known.preferred).find((name) => known.preferred[name][0] === unit) ?? '';
  const wanted = units[dimension], factors = factors_of(dimension);
  return wanted ? { unit: wanted, factor: factors[unit] / factors[wanted] } : { unit, factor: 1 };
}

export function prefer(chosen: Units): void {
  units = {};
  document.querySelectorAll<HTMLSelectElement>('.preferred').forEach((select) => {
    const name = select.dataset.dimension ?? '', unit = chosen[name];
    if (unit && known.preferred[name].includes(unit)) select.value = units[name] = unit;
  });
  changed();
}
on('change', (target) => {
  if (target.classList.contains('preferred')) prefer({ ...units, [target.dataset.dimension ?? '']: target.value });
});
