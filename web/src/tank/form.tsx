// The flume tank's form: all fields of the plan, from the description that R/page-form.R makes of
// the schema. Edits are sent to R as changes of the plan that the form shows.

import { render } from 'preact';
import type { Edit, Edits, Field, Form, FromR, Group, Part, Problem, Understood } from '../protocol';
import { element, find } from '../view';
import { pick_from } from './catalogue';
import { liked, new_control, tidy } from './control';
import * as Drawing from './drawing';
import { on } from './events';
import * as History from './history';
import { made } from './made';
import { new_group, open_later, ToolRow, unfold } from './parts';
import * as Predict from './predict';
import { send as send_to_r } from './server';
import { note } from './table';
import * as Talk from './talk';
import { bare, say, say_field, say_field_of, say_path, sought } from './words';

// A field in its displayed unit.
export type ShownField = Pick<Field, 'label' | 'kind' | 'choices' | 'unit' | 'value' | 'low' | 'high'>;
interface Entry { group: Group; part: Part; field: Field }

let form: Form | null = null, entries: Entry[] = [];
let unsent: Edits = {};                     // by path
let sent: number | null = null;             // number of the pending request
let typing: number | undefined;             // timer while a number is typed
let anew = false;                           // true if R must send a new form with the reply
let last: Element | null = null;            // control that was edited last
let gesture = 0;                            // number of the present gesture, which undo reverts as one step
let adding: HTMLElement | null = null;      // the button that requested the list of fields
let problems: Problem[] = [];

// ---- layout -------------------------------------------------------------------------------------

export function show(message: Form): void {
  if (form && form.turn !== message.turn) unsent = {};
  form = message;
  // R labels fields at the top in English; users label their own.
  form.quick.forEach((field) => {
    if (!field.label || field.usual && document.documentElement.lang !== 'en') field.label = say_path(field.paths[0]);
  });
  form.groups.forEach((group) => {
    group.words = say('room.' + group.title);
    group.parts?.forEach((part) => {
      part.title = part.path ? say_path(part.path) : group.words;
      part.fields?.forEach((field) => { field.label = say_field_of(part.path, field.paths[0]); });
    });
  });
  entries = message.groups.flatMap((group) => (group.parts ?? []).flatMap((part) =>
    (part.fields ?? []).map((field) => ({ group, part, field }))));
  last = null;
  lay_out(message);
}
// Shows the fields in other units.
export function refresh(): void { if (form) lay_out(form); }

function lay_out({ quick, groups }: Form) {
  const active = document.activeElement as HTMLInputElement | null, at = active?.closest<HTMLElement>('.control');
  const focused = at && active ? { paths: at.dataset.paths ?? '', type: active.type } : null, kept = window.scrollY;
  find('quick').replaceChildren(...quick.map((field) => new_control(field, false)));
  find('form').replaceChildren(...groups.filter((one) => one.parts?.length || one.open).map(new_group));
  search();
  mark();
  window.scrollTo({ top: kept, behavior: 'instant' });
  if (!focused) return;
  controls_of(focused.paths.split(' ')[0]).some((box) => {
    const to = box.querySelector<HTMLElement>('[type="' + focused.type + '"]') ??
      box.querySelector<HTMLElement>('input, select');
    to?.focus({ preventScroll: true });
    return !!to;
  });
}

function all<Kind extends HTMLElement = HTMLElement>(selector: string, within: ParentNode = document): Kind[] {
  return Array.from(within.querySelectorAll<Kind>(selector));
}
function paths_of(box: HTMLElement): string[] { return (box.dataset.paths ?? '').split(' '); }
function controls_of(path: string): HTMLElement[] {
  return all('.control').filter((box) => paths_of(box).includes(path));
}
function part_has(part: Part, path: string): boolean {
  return (part.fields ?? []).some((field) => field.paths.includes(path));
}

// Opens the part of a path, or its nearest parent. Returns false if there is none.
// quiet: true leaves the keyboard focus unchanged.
export function open(path: string, quiet = false): boolean {
  if (!form) return false;
  const places = form.groups.flatMap((group) => (group.parts ?? []).map((part) => ({ group, part })));
  const steps = path.split('.');
  let place, near = '';
  while (steps.length && !place) {
    near = steps.join('.');
    place = places.find(({ part }) => part.path === near || part_has(part, near));
    steps.pop();
  }
  if (!place) return false;
  const { group, part } = place;
  Drawing.sheet('net');
  find<HTMLInputElement>('find_field').value = '';
  search();
  const outer = all<HTMLDetailsElement>('#form > .group').find((box) => box.dataset.key === group.title);
  if (!outer) return false;
  unfold(outer);
  const inner = all<HTMLDetailsElement>('.part', outer).find((box) => box.dataset.key === part.path);
  if (inner) unfold(inner);
  const target = controls_of(near).find((one) => outer.contains(one)) ?? inner ?? outer;
  all('.marked').forEach((one) => one.classList.remove('marked'));
  target.classList.add('marked');
  if (quiet) return true;
  target.scrollIntoView({ block: 'nearest' });
  target.querySelector<HTMLElement>('input[type=text], select, textarea, input')?.focus({ preventScroll: true });
  return true;
}

// ---- search -------------------------------------------------------------------------------------

function label_in({ part, field }: Entry) { return (part.path ? part.title + ': ' : '') + field.label.toLowerCase(); }

function search() {
  const words = bare(find<HTMLInputElement>('find_field').value).split(/\s+/).filter(Boolean), whole = find('form');
  const place = document.getElementById('found_fields') ?? made(<div id="found_fields" />);
  if (!place.isConnected) whole.before(place);
  place.textContent = '';
  whole.hidden = words.length > 0;
  if (!words.length || !form) return;
  const found = entries.filter(({ group, part, field }) =>
    matches(words, [group.title, group.words, part.title, field.label].join(' '), field.paths.join(' ')));
  place.append(...found.slice(0, 30).map((one) =>
    new_control({ ...one.field, label: label_in(one) }, !one.field.required)));
  const n = found.length, absent = n ? [] : absent_fields(form, words).slice(0, 8);
  const said = n > 30 ? say('and_more_fields', { n: n - 30 }) : n ? say('fields_many', { n }) : say('no_field');
  place.append(made(<div>
    {n !== 1 && note(said)}
    {absent.length > 0 && note(say('could_have'))}
    {absent.map((button) => <ToolRow>{button}</ToolRow>)}
  </div>));
}

// Returns true if all words match: anywhere in names and labels, or at the start of synonyms in any
// language.
function matches(words: string[], text: string, paths: string): boolean {
  const named = bare(text + ' ' + paths.replace(/[._]/g, ' ')), called = ' ' + sought(paths);
  return words.every((word) => named.includes(word) || called.includes(' ' + word));
}

// Returns buttons that add the absent fields that match.
function absent_fields({ groups }: Form, words: string[]) {
  const add = (label: string, path: string, title: string, wanted: string) =>
    <button type="button" class="add-field" data-path={path} data-title={title} data-wanted={wanted}>{label}</button>;
  return groups.flatMap(({ title, absent, parts }) => [
    ...absent.filter((name) => matches(words, '', name)).map((name) => add(say_field(name), '', title, name)),
    ...(parts ?? []).flatMap((part) => part.absent ?? []).flatMap((path) => {
      const steps = path.split('.'), name = steps.pop() ?? '';
      return matches(words, '', name) ? [add(say_path(path), steps.join('.'), title, path)] : [];
    })
  ]);
}
on('input', ({ id }) => { if (id === 'find_field') search(); });

// ---- edits --------------------------------------------------------------------------------------

function send() {
  if (sent || !form || !Object.keys(unsent).length) return;
  sent = Talk.next();
  const edits = unsent;
  Predict.sent(sent, edits);
  flush(sent);
  send_to_r('design', { number: sent, turn: form.turn, edits, anew });
  anew = false;
}

// Moves edits into the history of the page. number: of the request that sends them.
export function flush(number?: number): void {
  if (Object.keys(unsent).length) History.change(unsent, gesture, number);
  unsent = {};
}

// The latest change of a path is the last one that R applies.
function add(path: string, edit: Edit) {
  delete unsent[path];
  unsent[path] = edit;
}

function change(box: HTMLElement, edit: Edit) {
  if (last !== box) gesture += 1;
  last = box;
  paths_of(box).forEach((path) => add(path, edit));
  send();
}

// Applies changes as one undo step.
export function edits(changes: Edits): void {
  gesture += 1;
  last = null;
  Object.entries(changes).forEach(([path, edit]) => add(path, edit));
  anew = true;
  send();
  gesture += 1;
}
export function edit(path: string, what: Edit): void { edits({ [path]: what }); }

const slider_of = (box: HTMLElement) => box.querySelector<HTMLInputElement>('[type=range]');
const number_of = (box: HTMLElement) => box.querySelector('.number') as HTMLInputElement;
const unit_of = (box: HTMLElement) => box.querySelector<HTMLSelectElement>('.unit');
const truth_of = (box: HTMLElement) => box.querySelector('.truth') as HTMLInputElement;
const text_of = (box: HTMLElement) => box.querySelector('.choice, .text') as HTMLInputElement;

// Copies an edit to the other controls of the same field.
function mirror(box: HTMLElement, { value = '' }: Edit) {
  controls_of(paths_of(box)[0]).forEach((other) => {
    if (other === box || other.dataset.kind !== box.dataset.kind) return;
    if (other.dataset.kind === 'number') {
      const unit = unit_of(other), mine = unit_of(box), convert = unit && mine && typeof value === 'number';
      const shown = convert ? tidy(value * Number(mine.dataset.factor) / Number(unit.dataset.factor)) : value;
      number_of(other).value = String(shown);
      reach(slider_of(other), Number(shown));
    } else if (other.dataset.kind === 'truth') truth_of(other).checked = value === true;
    else text_of(other).value = String(value);
  });
}

// Extends the range of a slider to a typed value.
function reach(slider: HTMLInputElement | null, value: number) {
  if (!slider) return;
  if (value < Number(slider.min)) slider.min = String(value);
  if (value > Number(slider.max)) slider.max = String(value);
  slider.value = String(value);
}

function move(box: HTMLElement, source: Element) {
  let edit: Edit;
  if (box.dataset.kind === 'number') {
    const slider = slider_of(box), field = number_of(box), slid = source === slider;
    if (slider && slid) field.value = slider.value;
    const typed = field.value.trim(), plain = /^[-+]?\d*\.?\d+$/.test(typed);
    if (!typed) return;
    if (source === field && plain) reach(slider, Number(typed));
    edit = { value: slid ? Number(typed) : typed, unit: unit_of(box)?.value ?? '' };
    if (plain) Predict.move(box.dataset.paths ?? '', Number(typed) * Number(unit_of(box)?.dataset.factor ?? 1));
    slider?.setAttribute('aria-valuetext', typed + ' ' + edit.unit);
  } else if (box.dataset.kind === 'truth') {
    edit = { value: truth_of(box).checked };
  } else {
    edit = { value: text_of(box).value };
    if (edit.value === '') return;
  }
  mirror(box, edit);
  change(box, edit);
}

// Converts the displayed numbers to another unit.
function convert(box: HTMLElement, unit: HTMLSelectElement) {
  const factor = unit.selectedOptions[0].dataset.factor, share = Number(unit.dataset.factor) / Number(factor);
  unit.dataset.factor = factor;
  const slider = slider_of(box), field = number_of(box);
  const converted = (value: string) => String(tidy(Number(value) * share));
  if (field.value === '' || !isFinite(Number(field.value))) return;
  field.value = converted(field.value);
  if (!slider) return;
  const { min, max, step } = slider;
  slider.min = converted(min);
  slider.max = converted(max);
  slider.step = converted(step);
  slider.value = field.value;
}

on('input', (target) => {
  const box = target.closest<HTMLElement>('.control');
  if (!box) return;
  if (target.type === 'range') move(box, target);
  else if (target.classList.contains('number')) {
    window.clearTimeout(typing);
    typing = window.setTimeout(() => {
      typing = undefined;
      move(box, target);
    }, 400);
  }
});
// The arrow keys step a number as its slider does.
on('keydown', (target, event) => {
  const box = target.closest<HTMLElement>('.control'), slider = box && slider_of(box);
  if (!slider || !target.classList.contains('number') || !/^Arrow(Up|Down)$/.test(event.key)) return;
  event.preventDefault();
  if (event.key === 'ArrowUp') slider.stepUp(); else slider.stepDown();
  move(box, slider);
});
on('change', (target) => {
  const box = target.closest<HTMLElement>('.control');
  if (!box) return;
  const unit = unit_of(box);
  if (unit && target.classList.contains('unit')) convert(box, unit);
  else if (target.classList.contains('number')) {
    if (typing !== undefined) {
      window.clearTimeout(typing);
      typing = undefined;
      move(box, target);
    }
  } else if (target.matches('.choice, .truth, .text')) move(box, target);
  gesture += 1;
});

on('click', (target) => {
  const button = target.closest('button');
  if (!button) return;
  const { path = '', act = '', title = '', instead = '' } = button.dataset;
  const is = (name: string) => button.classList.contains(name);
  if (is('take-out')) {
    const box = button.closest<HTMLElement>('.control');
    if (box) change(box, { gone: true });
  } else if (is('take-part')) edit(path, { gone: true });
  else if (is('pick')) pick_from(button, edits);
  else if (is('doubt')) edit(path, { value: instead, unit: '' });
  else if (is('add-field')) {
    adding = button;
    send_to_r('offers', { path, title });
  } else if (is('part-act')) {
    if (act === 'ahead' || act === 'behind') edit(path, { move: act === 'ahead' ? -1 : 1 });
    else ask_name(button, path, act);
  } else if (is('go-to')) {
    open(path);
    Drawing.seek(path);
  }
});

// Shows a text field for the name of a copy or for a new name.
function ask_name(button: HTMLElement, path: string, act: string) {
  const steps = path.split('.'), name = steps.pop() ?? '', parent = steps.join('.');
  const number = name.match(/^(.*?)(\d+)$/), copies = act === 'copy';
  const next = number ? number[1] + (Number(number[2]) + 1) : name + '_2';
  const row = made<HTMLFormElement>(<form class="control-row name-row" onSubmit={(event) => {
    event.preventDefault();
    const given = input.value.trim().replace(/[^A-Za-z0-9_]+/g, '_');
    if (!given || given === name) return;
    open_later(parent + '.' + given);
    Drawing.seek(parent + '.' + given);
    if (copies) edit(parent + '.' + given, { like: path, after: name });
    else edit(path, { rename: given });
  }}>
    <input type="text" aria-label={copies ? say('copy_name') : say('new_name', { name })} autocomplete="off"
      value={copies ? next : name} />
    <button class="primary" type="submit">{say(copies ? 'copy' : 'rename')}</button>
  </form>);
  const input = row.querySelector('input') as HTMLInputElement;
  button.replaceWith(row);
  input.select();
  input.focus();
}

// Lists the fields that can be added. The chosen field becomes a control.
export function offers(message: FromR['flume_offers']): void {
  const button = adding, fields = message.offers;
  fields.forEach((field) => { field.label = say_field_of(message.path, field.paths[0]); });
  if (!button?.isConnected || button.dataset.path !== message.path || button.dataset.title !== message.title) return;
  const select = made<HTMLSelectElement>(<select class="offered" aria-label={say('field_to_add')} onChange={() => {
    if (select.value === '') return;
    const field = fields[Number(select.value)], box = new_control(field, false);
    box.classList.add('marked');
    select.closest('.part-tools')?.before(box);
    open_later(field.paths[0]);
    select.replaceWith(button);
    box.querySelector<HTMLElement>('input, select, textarea')?.focus();
  }}>
    <option value="">{say('which_field')}</option>
    {fields.map(({ label, help }, k) => <option value={k} title={help}>{label}</option>)}
  </select>);
  button.replaceWith(select);
  const wanted = fields.findIndex((field) => field.paths[0] === button.dataset.wanted);
  if (wanted >= 0) {
    select.value = String(wanted);
    select.dispatchEvent(new Event('change'));
  } else select.focus();
}

// ---- problems -----------------------------------------------------------------------------------

function show_error(box: HTMLElement, words: string) {
  const place = box.querySelector<HTMLElement>('.field-error');
  if (!place) return;
  place.textContent = words;
  place.hidden = !words;
  all('input, select, textarea', box).forEach((field) => {
    if (words) field.setAttribute('aria-invalid', 'true');
    else field.removeAttribute('aria-invalid');
  });
}
function plain_path(path: string | null | undefined): string { return (path ?? '').replace(/\[(\d+)\]/g, '.$1'); }

// Marks all fields and parts that prevent the draft from settling.
function mark() {
  all('.control').forEach((box) => show_error(box, ''));
  all('.group, .part').forEach((box) => box.classList.remove('wrong'));
  problems.forEach((problem) => {
    const path = plain_path(problem.path);
    if (!path) return;
    form?.groups.forEach((group) => (group.parts ?? []).forEach((part) => {
      const inside = part.path && (path === part.path || path.startsWith(part.path + '.'));
      if (!inside && !part_has(part, path)) return;
      all('.group, .part').filter(({ dataset: { key } }) => key && [group.title, part.path].includes(key))
        .forEach((box) => box.classList.add('wrong'));
    }));
    controls_of(path).forEach((box) => show_error(box, problem.message));
  });
}

// Displays R's interpretation of typed numbers, with its doubts.
function echo(understood: Record<string, Understood | null>) {
  Object.entries(understood ?? {}).forEach(([path, one]) => {
    if (!one) return;
    controls_of(path).forEach((box) => {
      const place = box.querySelector<HTMLElement>('.echo');
      if (!place) return;
      const { text, doubt } = one, instead = doubt?.instead;
      place.hidden = false;
      render(<>{'= ' + text + (doubt ? '. ' + doubt.message + ' ' : '')}{instead && <button type="button" class="doubt"
        data-path={path} data-instead={instead}>{say('no_instead', { instead })}</button>}</>, place);
    });
  });
}

// Shows the problems of the draft, unless it is settling, and R's interpretation of typed numbers.
export function draft(message: FromR['flume_draft']): void {
  if (!form) return;
  if (!message.settling) {
    problems = message.problems;
    mark();
    render(problems.map(({ message, path }) => <li>{path ? <button type="button" class="link go-to"
      data-path={plain_path(path)}>{message}</button> : message}</li>), find('draft_problems'));
    find('unfinished').hidden = !problems.length;
    Drawing.wrong(problems.map((one) => plain_path(one.path)));
  }
  echo(message.understood);
}

// Marks the control of a rejected edit. Returns false if no control shows it.
export function refused(message: FromR['flume_refused']): boolean {
  if (message.answers !== sent) return false;
  const boxes = message.path ? controls_of(plain_path(message.path)) : [];
  boxes.forEach((box) => show_error(box, message.message));
  return boxes.length > 0;
}

// Forgets the pending request after a lost connection.
export function lost(): void { sent = null; }

export function answered(number: number): void {
  if (number !== sent) return;
  sent = null;
  send();
}

// ---- for other modules --------------------------------------------------------------------------

// Returns the number of the opened gear, or null.
export function turn(): number | null { return form ? form.turn : null; }

// For measurements: returns the number of the pending request, or null.
export function pending(): number | null { return sent; }

// Returns true if no edit is pending.
export function still(): boolean { return !sent && typing === undefined; }

// Returns the field of a path in its displayed unit, or null.
export function field(path: string): ShownField | null {
  const found = entries.filter((one) => one.field.paths.includes(path)).pop()?.field;
  if (!found) return null;
  const { label, kind, choices, unit } = found, like = kind === 'number' ? liked(found) : null;
  const in_unit = (value?: number) => like && value !== undefined ? tidy(value * found.factor / like.factor) : value;
  const value = typeof found.value === 'number' ? in_unit(found.value) ?? null : found.value;
  return {
    label, kind, choices, unit: like ? like.unit : unit ?? '', value: found.typed ?? value, low: in_unit(found.low),
    high: in_unit(found.high)
  };
}

// Fills a list with all numeric fields, frequently changed ones first. The selection stays; the
// default is the field whose path matches `first`.
export function offer(select: HTMLSelectElement, first?: RegExp): void {
  const names: string[] = [], before = select.value;
  const list = (label: string, fields: { field: Field; label: string }[]) => {
    const group = element('optgroup', '', undefined, { label });
    fields.forEach(({ field, label }) => {
      const key = field.paths.join(' ');
      if (field.kind !== 'number' || !field.value || names.includes(key)) return;
      names.push(key);
      group.appendChild(element('option', '', label, { value: key }));
    });
    return group;
  };
  const groups = [
    list(say('changed_first'), (form?.quick ?? []).map((field) => ({ field, label: field.label }))),
    list(say('all_others'), entries.map((one) => ({ field: one.field, label: label_in(one) })))
  ];
  if (select.dataset.names === names.join('|')) return;
  select.dataset.names = names.join('|');
  select.replaceChildren(...groups.filter((group) => group.childNodes.length));
  const liked = first && names.find((name) => first.test(name));
  select.value = names.includes(before) ? before : liked || names[0];
}
