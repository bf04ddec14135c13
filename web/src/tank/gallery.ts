// Start page of the flume tank: a gallery of gears, and a new gear from a few numbers.

import { find } from '../view';
import { on } from './events';
import { gallery, tell } from './notices';
import * as Talk from './talk';
import { say } from './words';

on('click', (target) => {
  const card = target.closest<HTMLElement>('.gear-card');
  if (card) {
    tell('gallery_refused', '');
    Talk.ask('words', { base: card.dataset.gear }, say('settling_gear',
      { gear: card.querySelector('.card-title')?.textContent }));
  }
  if (target.id === 'gears') gallery(find('gallery').hidden);
  if (target.id === 'make_gear') make();
});

on('change', (target) => {
  if (target.id !== 'new_kind') return;
  document.querySelectorAll<HTMLElement>('.new-numbers').forEach((each) => {
    each.hidden = each.dataset.kind !== target.value;
  });
});

function make() {
  const kind = find<HTMLSelectElement>('new_kind').value, values: Record<string, string> = {};
  document.querySelectorAll<HTMLInputElement>('.new-numbers[data-kind="' + kind + '"] [data-ask]').forEach((each) => {
    values[each.dataset.ask ?? ''] = each.value;
  });
  tell('new_error', '');
  Talk.ask('new', { kind, values });
}
on('keydown', (target, event) => { if (event.key === 'Enter' && target.dataset.ask) make(); });
