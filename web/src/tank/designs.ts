// Stored designs, undo and redo, the page address, which encodes all designs, and the shared folder.

import type { FromR, KeptDesign, SharedDesign, Words } from '../protocol';
import { element, find, kept_colour } from '../view';
import { on } from './events';
import { gallery, tell } from './notices';
import { send } from './server';
import * as Talk from './talk';
import { prefer, preferred } from './units';
import { say } from './words';

const largest = 2 * 1024 * 1024;
let timer: number | undefined, mine: string | null = null, wanted: number | null = null;
let last: Words | null = null;  // the designs of the page, as in its address

// ---- the address --------------------------------------------------------------------------------

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader(), parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  for (;;) {
    const step = await reader.read();
    if (step.done) return new Blob(parts).arrayBuffer();
    size += step.value.length;
    // A small compressed text can expand to an arbitrary size.
    if (size > largest) {
      reader.cancel();
      throw new RangeError('too long');
    }
    parts.push(step.value);
  }
}

export async function pack(words: Words): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(words)), new CompressionStream('deflate-raw'));
  const text = Array.from(new Uint8Array(bytes), (byte) => String.fromCharCode(byte)).join('');
  return btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

export async function unpack(text: string): Promise<Words> {
  const plain = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
  const bytes = Uint8Array.from(plain, (one) => one.charCodeAt(0));
  const found = await through(bytes, new DecompressionStream('deflate-raw'));
  return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(found));
}

// Opens the designs of the page address. Returns false if it has no new ones.
export function read(): boolean {
  const found = window.location.hash.match(/^#d=([A-Za-z0-9_-]+)$/);
  if (!found || found[1] === mine) return false;
  mine = found[1];
  unpack(found[1]).then(open).catch(() => {
    gallery(true);
    tell('gallery_refused', say('no_design_here'));
  });
  return true;
}

// Opens the designs of the page again, after the connection was lost.
export function open_again(): void {
  tell('refused', '');
  tell('gallery_refused', '');
  if (last) open(last);
}

// Opens the designs that an address or a file encodes; missing parts become empty.
export function open(words: Words | null): void {
  if (words?.units) prefer(words.units);
  Talk.ask('words', {
    now: words?.now || {}, kept: Array.isArray(words?.kept) ? words.kept : [], draft: words?.draft || {},
    own: Array.isArray(words?.own) ? words.own : []
  });
}

// Schedules an update of the address.
export function moved(): void {
  window.clearTimeout(timer);
  timer = window.setTimeout(() => {
    if (Talk.waits()) { moved(); return; }
    timer = undefined;
    wanted = Date.now();
    send('words_wanted', wanted);
  }, 600);
}

// Writes R's description of the designs to the address.
export async function write({ words, number }: FromR['flume_words']): Promise<void> {
  if (words) {
    last = { ...words, units: preferred() };
    mine = await pack(last);
    window.history.replaceState(null, '', '#d=' + mine);
  }
  if (number === wanted) wanted = null;
}

// Returns true while the address is out of date.
export function waits(): boolean { return timer !== undefined || wanted !== null; }

// ---- steps --------------------------------------------------------------------------------------

function step(name: 'undo' | 'redo') {
  if (!find<HTMLButtonElement>(name).disabled) Talk.ask(name, 1);
}
on('click', ({ id }) => {
  if (id === 'undo' || id === 'redo') step(id);
  else if (id === 'keep') send('keep', { number: Date.now() });
  else if (id === 'back') act(first, 'open');
});
on('keydown', (target, event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  // Text fields have their own undo.
  if (/^(text|search)$/.test(target.type) || target.tagName === 'TEXTAREA') return;
  const key = event.key.toLowerCase();
  const name = key === 'z' ? (event.shiftKey ? 'redo' : 'undo') : key === 'y' ? 'redo' : null;
  if (!name) return;
  event.preventDefault();
  step(name);
});

// ---- stored designs -----------------------------------------------------------------------------

let first: number | null = null;
function act(id: number | null, what: string, name?: string) {
  if (id !== null) send('kept', { number: what === 'open' ? Talk.next() : Date.now(), id, act: what, name });
}

// Lists the stored designs.
export function show(kept: KeptDesign[]): void {
  first = kept.length ? kept[0].id : null;
  let seen = 0;
  find('kept_designs').replaceChildren(...kept.map((one, k) => {
    const row = element('div', 'kept-row'), tick = element('input', '', undefined,
      { type: 'checkbox', 'aria-label': say('in_picture_of', { name: one.name }), title: say('in_picture') });
    tick.checked = one.seen;
    tick.addEventListener('change', () => act(one.id, tick.checked ? 'show' : 'hide'));
    const colour = element('span', 'kept-colour');
    if (one.seen) colour.style.background = kept_colour(seen++);
    const name = element('input', '', undefined,
      { type: 'text', 'aria-label': say('kept_name'), maxlength: 60 });
    name.value = one.name;
    name.addEventListener('change', () => act(one.id, 'rename', name.value));
    row.append(tick, colour, name);
    [['open', say('put_on_screen')], ['compare', k ? say('compare_with') : say('compared_with')],
      ['remove', say('remove')]].forEach(([what, words]) => {
      const button = element('button', '', words,
        { type: 'button', 'aria-label': say('of_design', { act: words, name: one.name }) });
      button.disabled = what === 'compare' && k === 0 || what === 'remove' && kept.length === 1;
      button.addEventListener('click', () => act(one.id, what));
      row.appendChild(button);
    });
    return row;
  }));
  moved();
}

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
  send('shared', { number: Date.now(), act, name: plain(name), author: plain(author), key: own_key() });
}

// Lists the designs of the shared folder.
export function shared(designs: SharedDesign[]): void {
  document.querySelectorAll('.shared-list').forEach((list) => {
    list.textContent = '';
    if (!designs.length) list.appendChild(element('li', 'note', say('shared_none')));
    designs.forEach(({ name, author, changed }) => {
      const item = element('li');
      item.append(element('span', '', name), element('span', 'note', author + ', ' + changed));
      function button(key: string, act: () => void) {
        const made = element('button', '', say(key),
          { type: 'button', 'aria-label': say('of_design', { act: say(key), name: name + ', ' + author }) });
        made.addEventListener('click', act);
        item.appendChild(made);
      }
      button('open_copy', () => Talk.ask('shared_open', { author, name }));
      // Only this panel shows errors of a removal.
      if (list.closest('#shared')) button('remove', () => share('take_out', name, author));
      list.appendChild(item);
    });
  });
}
on('click', ({ id }) => {
  const text = (id: string) => find<HTMLInputElement>(id).value;
  if (id === 'shared_put') share('put', text('shared_name'), text('shared_author'));
});
