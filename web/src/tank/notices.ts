// Messages next to the parts of the page, and the choice between gallery and design.

import { find } from '../view';

// Writes a message into an element, or hides the element if there is none.
export function tell(id: string, words: string): void {
  const place = document.getElementById(id);
  if (!place) return;
  place.textContent = words;
  place.hidden = !words;
}

let opened = false;
// Returns true after the first gear.
export function is_open(): boolean { return opened; }
export function set_open(): void { opened = true; }

// Shows the gallery or the design.
export function gallery(yes: boolean): void {
  if (!yes && !opened) return;
  if (find('gallery').hidden === !yes && find('design').hidden === yes) return;
  find('gallery').hidden = !yes;
  find('design').hidden = yes;
  find('gears').setAttribute('aria-expanded', String(yes));
  // The jump is instant, because the form's layout restores the present scroll position.
  window.scrollTo({ top: 0, behavior: 'instant' });
}
