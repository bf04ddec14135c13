// The colour scales of the legend.

import { say } from './element';
import type { Scale } from './scene';

// stops: colours of the scale
export function ColourBar({ scale, stops }: { scale: Scale; stops: string[] }) {
  const [heading, unit = ''] = scale.heading.split(/(?= \(.*$)/);
  let reach = -Infinity;
  return <div class="colour-bar">
    <div class="heading">{say(heading) + unit}</div>
    <div class="strip" style={{ background: `linear-gradient(to right, ${stops.join(', ')})` }} />
    <div class="ticks">{scale.ticks.map((words, k) => {
      const half = 3.6 * words.length;
      if (210 * scale.at[k] - half < reach + 5) return null;
      reach = 210 * scale.at[k] + half;
      return <span style={{ left: 100 * scale.at[k] + '%' }}>{words}</span>;
    })}</div>
  </div>;
}
