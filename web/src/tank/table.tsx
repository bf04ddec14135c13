// Tables of the tank's page.

import type { ComponentChildren } from 'preact';
import type { Table } from '../protocol';

export function note(words: string | null) { return words && <p class="note">{words}</p>; }

// rows: elements of the table's body
type Frame = Omit<Table, 'rows' | 'note' | 'parts'>;
export function table({ caption, head, numbers, foot }: Frame, rows: ComponentChildren) {
  return <div class="table-scroll" tabIndex={0} role="region" aria-label={caption}>
    <table>
      <caption>{caption}</caption>
      <thead><tr>{head.map((words, k) => <th scope="col" class={numbers[k] ? 'number' : ''}>{words}</th>)}</tr></thead>
      <tbody>{rows}</tbody>
      {foot && <tfoot>{row_of(foot, numbers)}</tfoot>}
    </table>
  </div>;
}
function row_of(cells: string[], numbers: boolean[], chosen?: boolean) {
  return <tr class={chosen ? 'chosen' : ''}>{cells.map((words, k) =>
    k ? <td class={numbers[k] ? 'number' : ''}>{words}</td> : <th scope="row">{words}</th>)}</tr>;
}
// chosen: names of parts whose rows are highlighted
export function rows_of({ rows, numbers, parts }: Pick<Table, 'rows' | 'numbers' | 'parts'>, chosen: string[] = []) {
  return rows.map((cells, k) => row_of(cells, numbers, parts?.[k]?.some((name) => chosen.includes(name))));
}
// Returns a table of strings. All columns except the first one are aligned as numbers.
export function text_table(caption: string, head: string[], rows: string[][]) {
  const numbers = head.map((_, k) => k > 0);
  return table({ caption, head, numbers, foot: null }, rows_of({ rows, numbers }));
}
