// Translations of the flume tank's page, from inst/app/words.csv, also for the viewer.

import type { FromR } from '../protocol';
import { fill, translate_by, type Values } from '../view';

let known: Pick<FromR['flume_begin'], 'words' | 'sought'> = { words: {}, sought: {} };
// words: strings by key, sought: names of fields in all languages
export function set_words(given: typeof known): void { known = given; }
export function has_word(key: string): boolean { return Object.hasOwn(known.words, key); }
export function capital(text: string): string { return text.charAt(0).toUpperCase() + text.slice(1); }

// Returns the string of a key, with {n} replaced by values.n. Unknown keys are returned unchanged.
export function say(key: string, values?: Values): string {
  return fill(has_word(key) ? known.words[key] : key, values);
}
translate_by((words, values) => has_word('view.' + words) ? say('view.' + words, values) :
  fill(say_field(words.replace(/ /g, '_')), values));

export function say_field(name: string): string {
  return has_word('field.' + name) ? say('field.' + name) : name.replace(/_/g, ' ');
}
// Returns "Otter boards: lift coefficient" for "otter_boards.lift_coefficient".
export function say_path(path: string): string {
  if (has_word('usual.' + path)) return say('usual.' + path);
  const steps = path.split('.').map(say_field), last = steps.pop() ?? '';
  return capital(steps.length ? steps.join(' ') + ': ' + last : last);
}
// Returns the label of a field in a part.
export function say_field_of(part: string, path: string): string {
  return capital(path.slice(part ? part.length + 1 : 0).split('.').map(say_field).join(': '));
}
export function say_unit(unit: string): string { return has_word('unit.' + unit) ? say('unit.' + unit) : unit; }

// Also after the name of a gear in a rig: "port door spread". Empty without a translation.
function measured(words: string): string {
  const number = words.match(/\d+/), space = words.indexOf(' ');
  const key = 'measure.' + words.replace(/\d+/, '#').replace(/ /g, '_');
  if (has_word(key)) return say(key).replace('#', number?.[0] ?? '');
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
  return bare(paths.split(/[. ]/).map((name) => known.sought[name] || '').join(' '));
}
