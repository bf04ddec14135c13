// Catalogue items that fit a part of the plan, and the user's own rows.

import { render } from 'preact';
import type { Catalogue, CatalogueRow, Edits, OwnRow } from '../protocol';
import * as Designs from './designs';
import { made } from './made';
import { tell } from './notices';
import { send } from './server';
import { say, say_field, say_unit } from './words';

let known: Catalogue = { things: [], fields: {} }, own: CatalogueRow[] = [];
let listed: { narrow(): void; close(): void } | null = null;
export function set_catalogue(catalogue: Catalogue): void { known = catalogue; }

// Stores the user's own rows and refreshes an open list.
export function take_own(rows: CatalogueRow[]): void {
  own = rows;
  listed?.narrow();
  Designs.moved();
}
export function own_rows(): CatalogueRow[] { return own; }
export function add_own(rows: OwnRow[]): void { tell_own([...own, ...rows]); }
function tell_own(rows: OwnRow[]) {
  tell('own_error', '');
  send('own', { rows });
}

// Returns the form for a new row of the user.
function OwnForm({ kind }: { kind: string }) {
  const Ask = ({ name, label }: { name: string; label: string }) =>
    <label>{label}<input type="text" autocomplete="off" maxLength={60} data-own={name} /></label>;
  const add = ({ currentTarget }: { currentTarget: HTMLElement }) => {
    const inputs = currentTarget.parentElement?.querySelectorAll<HTMLInputElement>('[data-own]') ?? [];
    const { title, ...values } = Object.fromEntries(Array.from(inputs, (one) => [one.dataset.own ?? '', one.value]));
    tell_own([...own, { class: kind, title, values }]);
  };
  return <details class="own-row">
    <summary>{say('own_row')}</summary>
    <Ask name="title" label={say('own_name')} />
    {Object.entries(known.fields[kind]).map(([name, unit]) =>
      <Ask name={name} label={say_field(name) + (unit && ' (' + say_unit(unit) + ')')} />)}
    <button type="button" class="primary own-add" onClick={add}>{say('own_add')}</button>
    <p class="field-error" id="own_error" role="alert" hidden />
  </details>;
}

// Replaces a button by a list of items that fit its part, at most `most`. edit: changes the plan.
export function pick_from(button: HTMLElement, edit: (edits: Edits) => void): void {
  const most = 40, path = button.dataset.path ?? '', classes = (button.dataset.classes ?? '').split(' ');
  // Only one list is open at a time.
  listed?.close();
  const fitting = (rows: CatalogueRow[]) => rows.filter((row) => classes.includes(row.class));
  const word = fitting(known.things)[0]?.title.split(' ')[0] ?? '', list = made(<ul class="pick-list" />);
  const input = made<HTMLInputElement>(<input type="search" aria-label={say('find_in_catalogue')}
    placeholder={say('find_such_as', { word })} autocomplete="off" onInput={narrow} />);
  const box = made(<div class="picks" onKeyDown={(event) => {
    if (event.key !== 'Escape') return;
    close();
    button.focus();
  }} />);
  const facts_of = ({ values }: CatalogueRow) =>
    Object.entries(values).map(([name, value]) => say_field(name) + ' ' + value.replace(/_/g, ' ')).join(', ');
  function pick({ values }: CatalogueRow) {
    edit(Object.fromEntries(Object.entries(values).map(([name, value]) => [path + '.' + name, { value, unit: '' }])));
    close();
  }
  const Item = ({ row }: { row: CatalogueRow }) => <li>
    <button type="button" class="link" onClick={() => pick(row)}>{row.title}</button>
    {own.includes(row) && <button type="button" class="take-out" aria-label={say('take_out', { label: row.title })}
      onClick={(event) => {
        event.stopPropagation();
        tell_own(own.filter((each) => each !== row));
      }}>{'\u00d7'}</button>}
    <span class="note">{facts_of(row) + (row.says ? '. ' + row.says : '') + '. ' +
      say('source', { source: row.source === 'own' ? say('own_source') : row.source })}</span>
  </li>;
  function close() {
    listed = null;
    box.replaceWith(button);
  }
  function narrow() {
    const words = input.value.trim().toLowerCase().replace(',', '.').split(/\s+/).filter(Boolean);
    const shown = [...fitting(own), ...fitting(known.things)].filter((row) => {
      const text = (row.title + ' ' + facts_of(row) + ' ' + row.says).toLowerCase();
      return words.every((word) => text.includes(word));
    });
    render(shown.length ? shown.slice(0, most).map((row) => <Item row={row} />) :
      <li class="note">{say('nothing_here')}</li>, list);
  }
  box.append(input, list, made(<OwnForm kind={classes[0]} />));
  listed = { narrow, close };
  narrow();
  button.replaceWith(box);
  input.focus();
}
