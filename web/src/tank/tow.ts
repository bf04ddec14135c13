// A tow of the present design: its inputs, its view with a time slider, and its graphs.

import type { Change, FromR } from '../protocol';
import { element, find, new_viewer, type Viewer } from '../view';
import { on } from './events';
import { new_graphs } from './graphs';
import { tell } from './notices';
import { send } from './server';
import { say, say_measure } from './words';

let viewer: Viewer | null = null, graphs: ReturnType<typeof new_graphs> | null = null;
function text(id: string) { return find<HTMLInputElement>(id).value.trim(); }

function changes() {
  const said: Record<string, Change> = {};
  const kinds: [string, 'to' | 'by'][] = [['speed', 'to'], ['course', 'by'], ['warp_out', 'by']];
  kinds.forEach(([name, way]) => {
    const id = 'tow_' + name, value = text(id);
    if (value) said[name] = { from: text(id + '_from'), over: text(id + '_over'), [way]: value };
  });
  return said;
}

function ask(planned: boolean) {
  tell('tow_error', '');
  send('tow_wanted', {
    until: text('tow_until'), ...(planned ? { planned: true } : { changes: changes() })
  });
}

// Default graphs: the first measure that matches each pattern.
const first = [/door spread|spread/, /mouth height|height/, /tension/, /depth/, /energy imbalance/];
function choose(all: string[]) {
  const found = first.map((kind) => all.find((words) => kind.test(words)));
  return [...new Set(found)].filter((words) => words !== undefined);
}

// Plays a computed tow.
export function show({ scene }: FromR['flume_tow']): void {
  find('towed').hidden = false;
  tell('tow_stale', '');
  if (!viewer) {
    const host = element('div', 'tow-view');
    find('tow_place').appendChild(host);
    viewer = new_viewer(host, {
      title: true, graph: false, still: false, moved: (time) => graphs?.mark(time)
    });
    if (!viewer) return;
  }
  const shown = viewer, time = scene.times[0];
  graphs = graphs || new_graphs(find('tow_graphs'), find('tow_more'), choose);
  scene.graph.forEach((one) => { one.shown = say_measure(one.words); });
  graphs.show(scene.graph, {
    times: scene.graph_times, ends: scene.ends, range: [time, scene.times[scene.times.length - 1]],
    unit: 's', seek: (at) => shown.seek(at)
  });
  viewer.show(scene);
  find('tow_place').scrollIntoView({ block: 'nearest' });
}

// Marks the tow as out of date. planned: true if the new plan defines a tow.
export function design(planned: boolean): void {
  find('tow_planned').hidden = !planned;
  if (viewer) tell('tow_stale', say('tow_stale'));
}

on('click', ({ id }) => {
  if (id === 'tow_start') ask(false);
  else if (id === 'tow_planned') ask(true);
});

// For tests.
export function shown(): Viewer | null { return viewer; }
