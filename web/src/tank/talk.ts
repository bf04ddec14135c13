// Requests of the flume tank's page to R, and the display of pending ones.

import type { Asked } from '../protocol';
import { find } from '../view';
import { on } from './events';
import { send } from './server';
import { say } from './words';

const told = 300;  // ms before a pending request is displayed
let number = 0, shown: number | undefined;
let pending: Record<string | number, { words: string; since: number }> = {};

function oldest() {
  return Object.values(pending).sort((a, b) => a.since - b.since)[0];
}

function look() {
  const first = oldest();
  if (!first) {
    find('working').hidden = true;
    window.clearInterval(shown);
    shown = undefined;
    return;
  }
  const passed = performance.now() - first.since;
  find('working').hidden = passed < told;
  find('working_words').textContent = first.words;
  find('working_time').textContent = passed < 2000 ? '' : Math.floor(passed / 1000) + ' s';
}

// Starts the display of a background task.
export function busy(id: string | number, words: string): void {
  pending[id] = { words, since: performance.now() };
  if (!shown) shown = window.setInterval(look, 150);
}
// Ends the display of a background task or of a request.
export function free(id: string | number): void {
  delete pending[id];
  if (!oldest()) look();
}
export function stop(): void { pending = {}; look(); }
// Returns true while anything is pending.
export function waits(): boolean { return !!oldest(); }

// Returns the number of an expected reply.
export function next(words = say('settling')): number {
  number += 1;
  busy(number, words);
  return number;
}
// Sends a request that has a reply, and returns its number.
export function ask<Name extends keyof Asked>(name: Name, asked: Asked[Name], words = say('settling')): number {
  const mine = next(words);
  send(name, { number: mine, asked });
  return mine;
}

on('click', (target) => { if (target.id === 'cancel') send('cancel', null); });
