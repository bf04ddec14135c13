// Catalogue items that fit a part of the plan, and the user's own rows.

import type { Catalogue, CatalogueRow, Edits, OwnRow } from '../protocol';
import { element } from '../view';
import * as Designs from './designs';
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
  send('own', { number: Date.now(), rows });
}

// Returns the form for a new row of the user.
function own_form(kind: string): HTMLElement {
  const box = element('details', 'own-row'), fields = known.fields[kind];
  box.appendChild(element('summary', '', say('own_row')));
  function ask(name: string, label: string): HTMLInputElement {
    const line = element('label', '', label), input = element('input', '', undefined,
      { type: 'text', autocomplete: 'off', maxlength: 60, 'data-own': name });
    line.appendChild(input);
    box.appendChild(line);
    return input;
  }
  const title = ask('title', say('own_name')), inputs = Object.keys(fields).map((name) => ({
    name, input: ask(name, say_field(name) + (fields[name] ? ' (' + say_unit(fields[name]) + ')' : ''))
  }));
  const add = element('button', 'primary own-add', say('own_add'), { type: 'button' });
  add.addEventListener('click', () => {
    const values = Object.fromEntries(inputs.map(({ name, input }) => [name, input.value]));
    tell_own([...own, { class: kind, title: title.value, values }]);
  });
  box.append(add, element('p', 'field-error', '', { id: 'own_error', role: 'alert', hidden: '' }));
  return box;
}

// Replaces a button by a list of items that fit its part, at most `most`. edit: changes the plan.
export function pick_from(button: HTMLElement, edit: (edits: Edits) => void): void {
  const most = 40, path = button.dataset.path ?? '', classes = (button.dataset.classes ?? '').split(' ');
  // Only one list is open at a time.
  listed?.close();
  const fitting = (rows: CatalogueRow[]) => rows.filter((row) => classes.includes(row.class));
  const fits = fitting(known.things);
  const box = element('div', 'picks'), list = element('ul', 'pick-list');
  const input = element('input', '', undefined,
    { type: 'search', 'aria-label': say('find_in_catalogue'), placeholder: say('find_such_as',
      { word: fits[0] ? fits[0].title.split(' ')[0] : '' }), autocomplete: 'off' });
  function row_of(row: CatalogueRow) {
    const facts = Object.entries(row.values).map(([name, value]) => say_field(name) + ' ' + value.replace(/_/g, ' '));
    const item = element('li'), one = element('button', 'link', row.title, { type: 'button' });
    item.appendChild(one);
    if (own.includes(row)) {
      const out = element('button', 'take-out', '\u00d7', { type: 'button',
        'aria-label': say('take_out', { label: row.title }) });
      out.addEventListener('click', (event) => {
        event.stopPropagation();
        tell_own(own.filter((each) => each !== row));
      });
      item.appendChild(out);
    }
    item.appendChild(element('span', 'note', facts.join(', ') + (row.says ? '. ' + row.says : '') +
      '. ' + say('source', { source: row.source === 'own' ? say('own_source') : row.source })));
    one.addEventListener('click', () => {
      edit(Object.fromEntries(Object.entries(row.values).map(([name, value]) =>
        [path + '.' + name, { value, unit: '' }])));
      close();
    });
    return { item, words: (row.title + ' ' + facts.join(' ') + ' ' + row.says).toLowerCase() };
  }
  function close() {
    listed = null;
    box.replaceWith(button);
  }
  const rows = fits.map(row_of);
  function narrow() {
    const words = input.value.trim().toLowerCase().replace(',', '.').split(/\s+/).filter(Boolean);
    const all = [...fitting(own).map(row_of), ...rows];
    const shown = all.filter((one) => words.every((word) => one.words.includes(word)));
    list.replaceChildren(...shown.slice(0, most).map((one) => one.item));
    if (!shown.length) list.appendChild(element('li', 'note', say('nothing_here')));
  }
  input.addEventListener('input', narrow);
  box.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      close();
      button.focus();
    }
  });
  box.append(input, list, own_form(classes[0]));
  listed = { narrow, close };
  narrow();
  button.replaceWith(box);
  input.focus();
}
