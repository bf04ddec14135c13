// Tables of the tank's page. All columns except the first one are aligned as numbers, unless they have
// strings of R.

import type { ComponentChildren } from 'preact';
import { decimals_of, fixed_decimals } from '../numbers';
import type { Table } from '../protocol';
import { say } from './words';

export function note(words: string | null) { return words && <p class="note">{words}</p>; }

const number = (k: number) => k > 0 ? 'number' : '';
// rows: elements of the table's body
export function table(caption: string, head: string[], rows: ComponentChildren, kind = number) {
  return <div class="table-scroll" tabIndex={0} role="region" aria-label={caption}>
    <table>
      <caption>{caption}</caption>
      <thead><tr>{head.map((words, k) => <th scope="col" class={kind(k)}>{words}</th>)}</tr></thead>
      <tbody>{rows}</tbody>
    </table>
  </div>;
}
function row_of(cells: string[], kind: (k: number) => string, chosen = false) {
  return <tr class={chosen ? 'chosen' : ''}>{cells.map((words, k) =>
    k ? <td class={kind(k)}>{words}</td> : <th scope="row">{words}</th>)}</tr>;
}
// Returns a table of strings.
export function text_table(caption: string, head: string[], rows: string[][]) {
  return table(caption, head, rows.map((cells) => row_of(cells, number)));
}
// Returns a table of R, or false without rows. chosen: names of parts whose rows are highlighted
export function table_of_r({ columns, parts }: Table, caption: string, head: string[], chosen: string[]) {
  const kinds = columns.map((column) => column.some((value) => typeof value === 'number') ? 'number' : '');
  const kind = (k: number) => kinds[k], cells = columns.map((column, k) => {
    const decimals = decimals_of(...column.filter((value) => typeof value === 'number'));
    return column.map((value) =>
      typeof value === 'number' ? fixed_decimals(value, decimals) : value ?? (kinds[k] ? '' : say('none')));
  });
  return columns[0].length > 0 && table(caption, head, columns[0].map((_, row) => row_of(cells.map((one) => one[row]),
    kind, parts[row]?.some((name) => chosen.includes(name)))), kind);
}
