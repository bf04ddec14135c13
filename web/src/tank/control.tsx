// A control of the form, for one field of the plan.

import type { Field } from '../protocol';
import { made } from './made';
import { factors_of, preferred } from './units';
import { say, say_unit } from './words';

interface Row { field: Field; id: string }
let count = 0;
// Units that a preferred unit replaces. Mesh sizes stay in millimetres.
const large: Record<string, string[]> = {
  length: ['m', 'metre', 'metres', 'meter', 'meters', 'fathom', 'fathoms', 'ft', 'foot', 'feet'],
  force: ['kN', 'tf', 'lbf', 'kgf'], speed: ['m/s', 'knot', 'knots', 'kn', 'kt', 'kts']
};

export function tidy(value: number): number { return Number(value.toPrecision(6)); }

// Returns the preferred unit of a field, or null if the unit of the field stays.
export function liked({ dimension, unit }: Field): { unit: string; factor: number } | null {
  const wanted = preferred()[dimension ?? ''], sizes = large[dimension ?? ''];
  if (!wanted || !sizes || !sizes.includes(unit) || wanted === unit) return null;
  const factor = factors_of(dimension)[wanted];
  return factor ? { unit: wanted, factor } : null;
}

// Returns the units of a field with their factors, its own first.
function units_of({ unit, factor, dimension }: Field): [string, number][] {
  const others = Object.entries(factors_of(dimension));
  return [[unit, factor], ...others.filter(([, other]) => Math.abs(other / factor - 1) > 1e-12)];
}

function NumberRow({ field, id }: Row) {
  const like = liked(field), share = like ? field.factor / like.factor : 1;
  const shown = (value: number) => share === 1 ? value : tidy(value * share);
  const { value, low, high = 0, step = 0, label } = field, number = typeof value === 'number' ? shown(value) : null;
  return <>
    {number !== null && low !== undefined && <input type="range" min={shown(low)} max={shown(high)} step={shown(step)}
      value={number} aria-label={label} aria-valuetext={number + ' ' + field.unit} />}
    <input class="number" type="text" id={id} autocomplete="off" spellcheck={false} value={number ?? field.typed ?? ''}
      aria-describedby={id + '_help ' + id + '_error ' + id + '_echo'} />
    {field.dimension && <select class="unit" aria-label={say('unit_of', { label })} value={(like ?? field).unit}
      data-factor={(like ?? field).factor}>
      {units_of(field).map(([unit, factor]) => <option value={unit} data-factor={factor}>{say_unit(unit)}</option>)}
    </select>}
  </>;
}

function ChoiceRow({ field, id }: Row) {
  return <select class="choice" id={id} aria-describedby={id + '_help ' + id + '_error'} value={String(field.value)}>
    {!field.value && <option value="" />}
    {field.choices.map((one) => <option value={one}>{one.replace(/_/g, ' ')}</option>)}
  </select>;
}

function TextRow({ field, id }: Row) {
  const value = String(field.value), yaml = field.kind === 'yaml', suggest = field.suggest ?? [];
  const about = {
    id, value, class: 'text', autocomplete: 'off', spellcheck: false, 'aria-describedby': id + '_help ' + id + '_error',
    placeholder: yaml ? say('as_plan_writes') : undefined, list: suggest.length ? id + '_list' : undefined
  };
  return <>
    {yaml && value.length > 40 ? <textarea rows={2} {...about} /> : <input type="text" {...about} />}
    {suggest.length > 0 && <datalist id={id + '_list'}>{suggest.map((one) => <option value={one} />)}</datalist>}
  </>;
}

// removable: true if the user may delete the field.
export function new_control(field: Field, removable: boolean): HTMLElement {
  count += 1;
  const id = 'control_' + count, label = <label for={id}>{field.label}</label>;
  const Kind = field.kind === 'number' ? NumberRow : field.kind === 'choice' ? ChoiceRow : TextRow;
  const out = removable && <button type="button" class="take-out" aria-label={say('take_out', { label: field.label })}
    title={say('take_out_tip')}>{'\u00d7'}</button>;
  return made(<div class="control" data-control={id} data-kind={field.kind} data-paths={field.paths.join(' ')}>
    {field.kind === 'truth' ? <div class="check">
      <input class="truth" type="checkbox" id={id} checked={field.value === true}
        aria-describedby={id + '_help ' + id + '_error'} />{label}{out}
    </div> : [label, <div class="control-row"><Kind field={field} id={id} />{out}</div>]}
    <p class="help note" id={id + '_help'} lang="en">
      {[field.help, field.must && say('must_be', { must: field.must })].filter(Boolean).join(' ')}</p>
    <p class="echo note" id={id + '_echo'} hidden />
    <p class="field-error" id={id + '_error'} hidden />
  </div>);
}
