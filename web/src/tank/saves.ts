// Files that the page saves. All other files come from R.

import { file_name, find, save_as } from '../view';
import { on } from './events';
import { tell } from './notices';
import { send } from './server';

const made_here: Record<string, { ending: string; make: () => string | string[] }> = {};

// Adds a file for the button `id`. make() returns its address (a string) or its text (in an array).
export function add(id: string, ending: string, make: () => string | string[]): void {
  made_here[id] = { ending, make };
}

on('click', ({ id, classList }) => {
  const own = made_here[id];
  if (own) {
    const made = own.make(), name = file_name(find('gear_name').textContent ?? '') + own.ending;
    save_as(typeof made === 'string' ? made : new Blob(made), name);
  } else if (classList.contains('save')) {
    tell('save_error', '');
    send('save_wanted', id.replace('save_', ''));
  }
});
