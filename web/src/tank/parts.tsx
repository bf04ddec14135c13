// The groups of the form and their parts, which are filled when they open.

import type { ComponentChildren } from 'preact';
import type { Group, Part } from '../protocol';
import { new_control } from './control';
import { made } from './made';
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
  const box = made<HTMLDetailsElement>(<details class={kind} data-key={key}>
    <summary>{title}{count && <span class="count">{count}</span>}</summary>
  </details>);
  function now() {
    fills.delete(box);
    fill(box);
  }
  fills.set(box, now);
  box.addEventListener('toggle', () => {
    if (box.open) fills.get(box)?.();
    opened[key] = box.open;
  });
  if (opened[key]) unfold(box);
  return box;
}

const Tool = ({ kind, words, ...rest }: { kind: string; words: string; [name: string]: unknown }) =>
  <button type="button" class={kind} {...rest}>{words}</button>;
export const ToolRow = ({ children }: { children?: ComponentChildren }) => <div class="part-tools">{children}</div>;

function part_tools({ path, title: part, open, named, required, picks = [] }: Part, title: string) {
  const acts = [
    ['copy', say('copy'), say('copy_part', { part })], ['rename', say('rename'), say('rename_part', { part })],
    ['ahead', '\u2191', say('move_ahead', { part })], ['behind', '\u2193', say('move_behind', { part })]
  ];
  return [
    open && <Tool kind="add-field" words={say('add_field')} data-path={path} data-title={title} />,
    ...named ? acts.map(([act, words, label]) =>
      <Tool kind="part-act" words={words} data-path={path} data-act={act} aria-label={label} />) : [],
    path && !required && <Tool kind="danger take-part" words={say('take_part')} data-path={path}
      aria-label={say('take_out', { label: part })} />,
    ...picks.map((pick) => <Tool kind="pick" data-path={pick.path} data-classes={pick.classes.join(' ')}
      words={say('from_catalogue') + (pick.path === path ? '' : ': ' + say_field(pick.path.split('.').pop() ?? ''))} />)
  ].filter(Boolean);
}

function fill_part(part: Part, title: string, box: HTMLElement) {
  const tools = part_tools(part, title), row = tools.length ? [made(<ToolRow>{tools}</ToolRow>)] : [];
  const fields = (part.fields ?? []).map((field) => new_control(field, !field.required));
  if (part.help) box.append(made(<p class="note" lang="en">{part.help}</p>));
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
      box.append(made(<ToolRow><Tool kind="add-field" data-path="" data-title={one.title}
        words={say('add_to', { group: one.words.toLowerCase() })} /></ToolRow>));
    }
  });
}
