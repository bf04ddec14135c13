// Translations of the flume tank's page, from inst/app/words.csv, also for the viewer.

import { fill, find, translate_by, type Values } from '../view';

// The script runs before the page exists.
let given: { words: Record<string, string>; sought: Record<string, string> } | null = null;
function known() {
  given = given || JSON.parse(find('words').textContent ?? '') as NonNullable<typeof given>;
  return given;
}
function has(key: string): boolean { return Object.prototype.hasOwnProperty.call(known().words, key); }

// Returns the string of a key, with {n} replaced by values.n. Unknown keys are returned unchanged.
export function say(key: string, values?: Values): string { return fill(has(key) ? known().words[key] : key, values); }
translate_by((words, values) => has('view.' + words) ? say('view.' + words, values) :
  fill(say_field(words.replace(/ /g, '_')), values));

export function say_field(name: string): string {
  return has('field.' + name) ? say('field.' + name) : name.replace(/_/g, ' ');
}
export function say_path(path: string): string { return path.split('.').map(say_field).join(' '); }
export function say_unit(unit: string): string { return has('unit.' + unit) ? say('unit.' + unit) : unit; }

// Also after the name of a gear in a rig: "port door spread". Empty without a translation.
function measured(words: string): string {
  const number = words.match(/\d+/), space = words.indexOf(' ');
  const key = 'measure.' + words.replace(/\d+/, '#').replace(/ /g, '_');
  if (has(key)) return say(key).replace('#', number?.[0] ?? '');
  const of_gear = space < 0 ? '' : measured(words.slice(space + 1));
  return of_gear && words.slice(0, space) + ': ' + of_gear;
}
// Translates "door spread (m)".
export function say_measure(words: string): string {
  const [, name, unit] = words.match(/^(.*?)( \(.*\))?$/) ?? [];
  return (measured(name) || name) + (unit || '');
}

// Returns the text in lower case without accents.
export function bare(text: string): string {
  return text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '').replace(/\u00f8/g, 'o')
    .replace(/\u00e6/g, 'ae').trim();
}
// Returns the names of fields in all languages, for the search.
export function sought(paths: string): string {
  return bare(paths.split(/[. ]/).map((name) => known().sought[name] || '').join(' '));
}
