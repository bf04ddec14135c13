// The colour scales of the legend.

import { element, say } from './element';
import type { Scale } from './scene';

// Returns the bar of a colour scale. stops: its colours.
export function colour_bar(scale: Scale, stops: string[]): HTMLElement {
  const made = element('div', 'colour-bar');
  const unit = scale.heading.match(/ \(.*$/);
  made.appendChild(element('div', 'heading', say(scale.heading.replace(/ \(.*$/, '')) + (unit || '')));
  const strip = element('div', 'strip');
  strip.style.background = 'linear-gradient(to right, ' + stops.join(', ') + ')';
  made.appendChild(strip);
  const row = element('div', 'ticks');
  let reach = -Infinity;
  scale.ticks.forEach((words, k) => {
    const half = 3.6 * words.length;
    if (210 * scale.at[k] - half < reach + 5) return;
    reach = 210 * scale.at[k] + half;
    const tick = element('span', '', words);
    tick.style.left = 100 * scale.at[k] + '%';
    row.appendChild(tick);
  });
  made.appendChild(row);
  return made;
}
