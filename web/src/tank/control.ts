// A control of the form, for one field of the plan.

import type { Field, Units } from '../protocol';
import { element } from '../view';
import { say, say_unit } from './words';

let preferred: Units = {}, known: Record<string, Record<string, number>> = {}, made = 0;
// Units that a preferred unit replaces. Mesh sizes stay in millimetres.
const large: Record<string, string[]> = {
  length: ['m', 'metre', 'metres', 'meter', 'meters', 'fathom', 'fathoms', 'ft', 'foot', 'feet'],
  force: ['kN', 'tf', 'lbf', 'kgf'], speed: ['m/s', 'knot', 'knots', 'kn', 'kt', 'kts']
};

export function set_preferred(units: Units): void { preferred = units; }
// units: factors to SI by dimension and unit
export function set_known(units: typeof known): void { known = units; }

export function tidy(value: number): number { return Number(value.toPrecision(6)); }

// Returns the preferred unit of a field, or null if the unit of the field stays.
export function liked({ dimension, unit }: Field): { unit: string; factor: number } | null {
  const wanted = preferred[dimension ?? ''], sizes = large[dimension ?? ''];
  if (!wanted || !sizes || !sizes.includes(unit) || wanted === unit) return null;
  const factor = known[dimension ?? '']?.[wanted];
  return factor ? { unit: wanted, factor } : null;
}

// Returns the units of a field with their factors, its own first.
function units_of({ unit, factor, dimension }: Field): [string, number][] {
  const others = Object.entries(known[dimension ?? ''] ?? {});
  return [[unit, factor], ...others.filter(([, other]) => Math.abs(other / factor - 1) > 1e-12)];
}

function number_row(field: Field, id: string): HTMLElement {
  const row = element('div', 'control-row'), like = liked(field), share = like ? field.factor / like.factor : 1;
  const shown = (value: number) => share === 1 ? value : tidy(value * share);
  const { value, low, high = 0, step = 0 } = field;
  if (typeof value === 'number' && low !== undefined) {
    const slider = element('input', '', undefined, {
      type: 'range', min: shown(low), max: shown(high), step: shown(step), 'aria-label': field.label
    });
    slider.value = String(shown(value));
    slider.setAttribute('aria-valuetext', shown(value) + ' ' + field.unit);
    row.appendChild(slider);
  }
  const input = element('input', 'number', undefined, {
    type: 'text', id, inputmode: 'text', autocomplete: 'off', spellcheck: 'false',
    'aria-describedby': id + '_help ' + id + '_error ' + id + '_echo'
  });
  input.value = typeof value === 'number' ? String(shown(value)) : field.typed ?? '';
  row.appendChild(input);
  if (field.dimension) {
    const select = element('select', 'unit', undefined,
      { 'aria-label': say('unit_of', { label: field.label }) });
    units_of(field).forEach(([unit, factor]) => {
      select.appendChild(element('option', '', say_unit(unit), { value: unit, 'data-factor': factor }));
    });
    select.value = (like ?? field).unit;
    select.dataset.factor = String((like ?? field).factor);
    row.appendChild(select);
  }
  return row;
}

function choice_row(field: Field, id: string): HTMLElement {
  const row = element('div', 'control-row');
  const select = element('select', 'choice', undefined,
    { id, 'aria-describedby': id + '_help ' + id + '_error' });
  if (!field.value) select.appendChild(element('option', '', '', { value: '' }));
  field.choices.forEach((one) => select.appendChild(element('option', '', one.replace(/_/g, ' '), { value: one })));
  select.value = String(field.value);
  row.appendChild(select);
  return row;
}

function text_row(field: Field, id: string): HTMLElement {
  const row = element('div', 'control-row'), long = field.kind === 'yaml' && String(field.value).length > 40;
  const input = long ? element('textarea', 'text', undefined, { rows: 2 }) :
    element('input', 'text', undefined, { type: 'text' });
  input.id = id;
  input.spellcheck = false;
  input.setAttribute('autocomplete', 'off');
  input.setAttribute('aria-describedby', id + '_help ' + id + '_error');
  input.value = String(field.value);
  if (field.kind === 'yaml') input.placeholder = say('as_plan_writes');
  row.appendChild(input);
  if (field.suggest?.length) {
    const list = element('datalist', '', undefined, { id: id + '_list' });
    list.append(...field.suggest.map((one) => element('option', '', undefined, { value: one })));
    input.setAttribute('list', list.id);
    row.appendChild(list);
  }
  return row;
}

// removable: true if the user may delete the field.
export function new_control(field: Field, removable: boolean): HTMLElement {
  made += 1;
  const id = 'control_' + made, label = element('label', '', field.label, { for: id });
  const box = element('div', 'control', undefined, {
    'data-control': id, 'data-kind': field.kind, 'data-paths': field.paths.join(' ')
  });
  let row: HTMLElement;
  if (field.kind === 'truth') {
    row = element('div', 'check');
    const tick = element('input', 'truth', undefined,
      { type: 'checkbox', id, 'aria-describedby': id + '_help ' + id + '_error' });
    tick.checked = field.value === true;
    row.append(tick, label);
    box.appendChild(row);
  } else {
    row = (field.kind === 'number' ? number_row : field.kind === 'choice' ? choice_row : text_row)(field, id);
    box.append(label, row);
  }
  if (removable) {
    row.appendChild(element('button', 'take-out', '\u00d7', {
      type: 'button', 'aria-label': say('take_out', { label: field.label }), title: say('take_out_tip')
    }));
  }
  const help = [field.help, field.must && say('must_be', { must: field.must })].filter(Boolean).join(' ');
  box.append(
    element('p', 'help note', help, { id: id + '_help', lang: 'en' }),
    element('p', 'echo note', '', { id: id + '_echo', hidden: '' }),
    element('p', 'field-error', '', { id: id + '_error', hidden: '' })
  );
  return box;
}
