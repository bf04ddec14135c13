// Files that the page saves. All other files come from R.

import { file_name, find, save_as } from '../view';
import { on } from './events';
import { tell } from './notices';
import { send } from './server';

const made_here: Record<string, { ending: string; make: () => string }> = {};

// Adds a file for the button `id`. make() returns its text.
export function add(id: string, ending: string, make: () => string): void { made_here[id] = { ending, make }; }

on('click', ({ id, classList }) => {
  const own = made_here[id];
  if (own) save_as(new Blob([own.make()]), file_name(find('gear_name').textContent ?? '') + own.ending);
  else if (classList.contains('save')) {
    tell('save_error', '');
    send('save_wanted', id.replace('save_', ''));
  }
});
