// The page address, which encodes all designs, and the shared folder.

import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import { render } from 'preact';
import type { Design, FromR, SharedDesign, Words } from '../protocol';
import { find } from '../view';
import * as Catalogue from './catalogue';
import { on } from './events';
import * as Form from './form';
import * as History from './history';
import * as Kept from './kept';
import { gallery, tell } from './notices';
import * as Saves from './saves';
import { send } from './server';
import * as Talk from './talk';
import { prefer, preferred } from './units';
import { say } from './words';

const largest = 2 * 1024 * 1024;
let timer: number | undefined, mine: string | null = null;
// the request that opens an address or, after a lost connection, the design of the page again
let opening: { number: number; words: Words | null; done?: boolean } | null = null;

// ---- the address --------------------------------------------------------------------------------

export function pack(words: Words): string {
  const text = strFromU8(deflateSync(strToU8(JSON.stringify(words))), true);
  return btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

export function unpack(text: string): Words {
  const bytes = strToU8(atob(text.replace(/-/g, '+').replace(/_/g, '/')), true);
  // A small compressed text can expand to an arbitrary size; the rest is cut off.
  return JSON.parse(strFromU8(inflateSync(bytes, { out: new Uint8Array(largest) })));
}

// Opens the designs of the page address. Returns false if it has no new ones.
export function read(): boolean {
  const found = window.location.hash.match(/^#d=([A-Za-z0-9_-]+)$/);
  if (!found || found[1] === mine) return false;
  mine = found[1];
  try {
    open(unpack(found[1]));
  } catch {
    gallery(true);
    tell('gallery_refused', say('no_design_here'));
  }
  return true;
}

// Opens the design of the page again, after the connection was lost. Changes that R has not settled
// follow as soon as it is open.
export function open_again(): void {
  tell('refused', '');
  tell('gallery_refused', '');
  if (!History.has_design()) return;
  Form.flush();
  opening = { number: Talk.ask('words', History.on_screen()), words: null };
  History.again(opening.number);
}

// Opens the designs that an address or a file encodes; missing parts become empty.
export function open(words: Words | null): void {
  if (words?.units) prefer(words.units);
  if (Array.isArray(words?.own) && words.own.length) Catalogue.add_own(words.own);
  opening = { number: Talk.ask('words', words?.now ?? {}), words };
}

// R has opened a gear, and its picture follows.
export function opened({ answers, design }: FromR['flume_opened']): void {
  const mine = opening?.number === answers ? opening : null;
  if (mine) mine.done = true;
  if (mine && !mine.words) return;
  History.start(mine?.words?.now ?? design, answers);
  Kept.start();
}
// Sends changes that the opened design lacks, as soon as its form is on the page.
export function complete(): void {
  if (!opening?.done) return;
  const { words } = opening;
  opening = null;
  if (Array.isArray(words?.kept)) Kept.settle(words.kept);
  if (words?.draft?.plan || words?.draft?.base) History.replace(words.draft);
  else if (!words && History.current() !== History.on_screen()) History.settle();
}

// Returns the designs of the page.
function all(): Words {
  const now = History.on_screen(), own = Catalogue.own_rows();
  const draft: Design | null = History.current() === now ? null : History.current();
  return {
    now, kept: Kept.all().map(({ name, design }) => ({ name, ...design })), draft, units: preferred(),
    ...own.length ? { own } : {}
  };
}

// Schedules an update of the address.
export function moved(): void {
  window.clearTimeout(timer);
  timer = window.setTimeout(() => {
    if (Talk.waits()) { moved(); return; }
    timer = undefined;
    write();
  }, 600);
}
function write() {
  if (!History.has_design()) return;
  mine = pack(all());
  window.history.replaceState(null, '', '#d=' + mine);
}

// Returns true while the address is out of date.
export function waits(): boolean { return timer !== undefined; }

// ---- the shared folder --------------------------------------------------------------------------

// A random key of this browser. The server lets only this browser change its shared designs.
function own_key(): string {
  const kept = localStorage.getItem('codend-key');
  if (kept) return kept;
  const bytes = Array.from(crypto.getRandomValues(new Uint8Array(16)));
  const key = bytes.map((byte) => byte.toString(16).padStart(2, '0')).join('');
  localStorage.setItem('codend-key', key);
  return key;
}
function share(act: string, name: string, author: string) {
  tell('shared_error', '');
  // Names that look the same are the same.
  const plain = (text: string) => text.normalize('NFKC').trim();
  send('shared', {
    act, name: plain(name), author: plain(author), key: own_key(),
    words: act === 'put' ? all() : null
  });
}

// Lists the designs of the shared folder. Only the list of the page's tab removes designs, because it
// shows errors of a removal.
export function shared(designs: SharedDesign[]): void {
  document.querySelectorAll('.shared-list').forEach((list) => {
    const Act = ({ words, of, act }: { words: string; of: SharedDesign; act: () => void }) => <button type="button"
      aria-label={say('of_design', { act: words, name: of.name + ', ' + of.author })} onClick={act}>{words}</button>;
    render(designs.length ? designs.map((of) => <li>
      <span>{of.name}</span><span class="note">{of.author + ', ' + of.changed}</span>
      <Act words={say('open_copy')} of={of}
        act={() => Talk.ask('shared_open', { author: of.author, name: of.name })} />
      {list.closest('#shared') &&
        <Act words={say('remove')} of={of} act={() => share('take_out', of.name, of.author)} />}
    </li>) : <li class="note">{say('shared_none')}</li>, list);
  });
}
Saves.add('save_all', '-designs.json', () => JSON.stringify({ codend_designs: 1, ...all() }) + '\n');
on('click', ({ id }) => {
  const text = (id: string) => find<HTMLInputElement>(id).value;
  if (id === 'shared_put') share('put', text('shared_name'), text('shared_author'));
});
