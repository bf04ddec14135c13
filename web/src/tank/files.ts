// Opens plans from a file dialog, by drag and drop, or from the text area.

import type { Problem } from '../protocol';
import { find } from '../view';
import * as Designs from './designs';
import { on } from './events';
import * as History from './history';
import { gallery, tell } from './notices';
import * as Talk from './talk';
import { say } from './words';

const largest = 2 * 1024 * 1024;
let typed: number | null = null;  // the request that settles the typed plan
const area = () => find<HTMLTextAreaElement>('plan_area');

function refuse(why: string) {
  gallery(true);
  tell('plan_file_error', why + ' ' + say('gear_stays'));
}

// Saved designs are opened as such; other files are sent to R as plans.
async function open(file: File) {
  tell('plan_file_error', '');
  if (file.size > largest) {
    refuse(say('file_large', { file: file.name, n: (file.size / largest * 2).toFixed(1) }));
    return;
  }
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
    if (text.includes('\0')) throw new TypeError('NUL');
    if (/^\s*\{\s*"codend_designs"/.test(text)) Designs.open(JSON.parse(text));
    else Talk.ask('plan_file', { name: file.name, text });
  } catch (error) {
    refuse(say(error instanceof SyntaxError ? 'file_no_designs' : 'file_no_text', { file: file.name }));
  }
}

on('change', (target) => {
  if (!target.classList.contains('plan-file') || !target.files?.length) return;
  open(target.files[0]);
  // Otherwise the same file could not be chosen again.
  target.value = '';
});
on('dragover', (_, event) => {
  event.preventDefault();
  document.body.classList.add('dropping');
});
on('dragleave', () => document.body.classList.remove('dropping'));
on('drop', (_, event) => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  const files = event.dataTransfer?.files;
  if (files?.length) open(files[0]);
});

on('click', ({ id }) => {
  if (id !== 'plan_text_settle') return;
  tell('plan_text_error', '');
  typed = History.replace({ plan: area().value });
});
// Reports a problem of the typed plan below its text. Returns false if the plan was not typed.
export function refused(problem?: Pick<Problem, 'message'> & { path?: string | null }): boolean {
  if (typed === null || !problem) return false;
  tell('plan_text_error', problem.message);
  if (problem.path) show_line(problem.path);
  return true;
}
// Returns true if the request settled the typed plan.
export function answered(number: number): boolean {
  if (number !== typed) return false;
  typed = null;
  return true;
}

// Returns the start of the line of a plan that a path refers to, or of its deepest known parent.
export function line_of(text: string, path: string): number {
  return path.replace(/\[\d+\]/g, '').split('.').reduce((from, step) => {
    const at = text.slice(from).search(new RegExp('(^|[\\s{,])' + step.replace(/[^A-Za-z0-9_]/g, '.') + ':', 'm'));
    return at >= 0 ? from + at + 1 : from;
  }, 0);
}

// Selects the line of the plan text that a path refers to.
export function show_line(path: string): void {
  const place = area(), from = line_of(place.value, path), to = place.value.indexOf('\n', from);
  place.focus();
  place.setSelectionRange(from, to < 0 ? place.value.length : to);
  const share = from / Math.max(place.value.length, 1);
  place.scrollTop = place.scrollHeight * share - place.clientHeight / 2;
}
