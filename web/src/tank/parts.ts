// The groups of the form and their parts, which are filled when they open.

import type { Group, Part } from '../protocol';
import { element } from '../view';
import { new_control } from './control';
import { say, say_field } from './words';

// open groups and parts, by title or path
const opened: Record<string, boolean> = {};
const fills = new WeakMap<Element, () => void>();

// Opens a group or a part.
export function unfold(box: HTMLDetailsElement): void {
  fills.get(box)?.();
  box.open = true;
}
// Opens a part when it is next laid out.
export function open_later(key: string): void { opened[key] = true; }

function fold(kind: string, key: string, title: string, count: string, fill: (box: HTMLElement) => void) {
  const box = element('details', kind, undefined, { 'data-key': key }), head = element('summary', '', title);
  if (count) head.appendChild(element('span', 'count', count));
  box.appendChild(head);
  let filled = false;
  function now() {
    if (filled) return;
    filled = true;
    fill(box);
  }
  fills.set(box, now);
  box.addEventListener('toggle', () => {
    if (box.open) now();
    opened[key] = box.open;
  });
  if (opened[key]) unfold(box);
  return box;
}

function tool(class_name: string, words: string, attributes: Record<string, string>) {
  return element('button', class_name, words, { type: 'button', ...attributes });
}

function part_tools(part: Part, title: string): HTMLElement[] {
  const tools: HTMLElement[] = [], path = part.path;
  if (part.open) tools.push(tool('add-field', say('add_field'), { 'data-path': path, 'data-title': title }));
  if (part.named) {
    const its = { part: part.title };
    const acts = [
      ['copy', say('copy'), say('copy_part', its)], ['rename', say('rename'), say('rename_part', its)],
      ['ahead', '\u2191', say('move_ahead', its)], ['behind', '\u2193', say('move_behind', its)]
    ];
    acts.forEach(([act, words, label]) => {
      tools.push(tool('part-act', words, { 'data-path': path, 'data-act': act, 'aria-label': label }));
    });
  }
  if (path && !part.required) {
    tools.push(element('button', 'danger take-part', say('take_part'),
      { type: 'button', 'data-path': path, 'aria-label': say('take_out', { label: part.title }) }));
  }
  (part.picks ?? []).forEach((pick) => {
    const of = pick.path === path ? '' : ': ' + say_field(pick.path.split('.').pop() ?? '');
    tools.push(tool('pick', say('from_catalogue') + of,
      { 'data-path': pick.path, 'data-classes': pick.classes.join(' ') }));
  });
  return tools;
}

export function tool_row(tools: HTMLElement[]): HTMLElement {
  const row = element('div', 'part-tools');
  row.append(...tools);
  return row;
}

function fill_part(part: Part, title: string, box: HTMLElement) {
  const tools = part_tools(part, title), row = tools.length ? [tool_row(tools)] : [];
  const fields = (part.fields ?? []).map((field) => new_control(field, !field.required));
  if (part.help) box.appendChild(element('p', 'note', part.help, { lang: 'en' }));
  box.append(...part.named ? [...row, ...fields] : [...fields, ...row]);
}

export function new_group(one: Group): HTMLElement {
  const parts = one.parts ?? [], count = parts.length > 1 ? say('parts_many', { n: parts.length }) : '';
  return fold('group', one.title, one.words, count, (box) => {
    parts.forEach((part) => {
      if (!part.path) { fill_part(part, one.title, box); return; }
      box.appendChild(fold('part', part.path, part.title, '', (inner) => {
        inner.dataset.path = part.path;
        fill_part(part, one.title, inner);
      }));
    });
    if (one.open) {
      box.appendChild(tool_row([tool('add-field', say('add_to', { group: one.words.toLowerCase() }),
        { 'data-path': '', 'data-title': one.title })]));
    }
  });
}
