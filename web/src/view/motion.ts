import { element, say } from './element';
import { new_graph, type Graph } from './graph';
import type { Scene } from './scene';

// Time controls of the viewer: slider, play button, keys and a graph of a measure. Space plays and
// pauses; comma and full stop step between stored times; Home and End go to the ends.
export interface MotionOptions {
  // false hides the graph
  graph?: boolean;
  // called for every displayed time
  moved?(time: number): void;
}
export interface Motion {
  // Shows a time and pauses.
  seek(time: number): void;
  // Removes the controls.
  end(): void;
}

export function new_motion(
  host: HTMLElement, viewer: { time(k: number, share: number): void }, told: Scene, options: MotionOptions
): Motion {
  const times = told.times, last = times.length - 1;
  const longest = 20;  // s, maximum playback time

  host.classList.add('moves');
  const bar = element('div', 'view-time');
  const button = element('button', 'view-button', undefined, { type: 'button' });
  const slider = element('input', '', undefined, {
    type: 'range', min: times[0], max: times[last], step: 'any', 'aria-label': say('Time')
  });
  const label = element('div', 'label');
  bar.append(button, slider, label);
  host.appendChild(bar);

  let now = times[0], playing: { clock: number | null; request: number } | null = null;

  function frame_of(time: number) {
    let k = 0;
    while (k < last - 1 && times[k + 1] <= time) k++;
    return k;
  }

  function show(time: number) {
    now = Math.min(Math.max(time, times[0]), times[last]);
    const k = frame_of(now), share = (now - times[k]) / (times[k + 1] - times[k]);
    viewer.time(k, share);
    const words = told.labels[share < 0.5 ? k : k + 1];
    label.textContent = words;
    slider.value = String(now);
    slider.setAttribute('aria-valuetext', words);
    mark();
    if (options.moved) options.moved(now);
  }

  function stop() {
    if (playing) window.cancelAnimationFrame(playing.request);
    playing = null;
    button.textContent = say('Play');
  }

  function play() {
    if (now >= times[last]) now = times[0];
    const rate = Math.max(1, (times[last] - times[0]) / longest);
    playing = { clock: null, request: 0 };
    button.textContent = say('Pause');
    function tick(clock: number) {
      if (!playing) return;
      const passed = playing.clock === null ? 0 : (clock - playing.clock) / 1000;
      playing.clock = clock;
      show(now + rate * passed);
      if (now >= times[last]) { stop(); return; }
      playing.request = window.requestAnimationFrame(tick);
    }
    playing.request = window.requestAnimationFrame(tick);
  }

  function toggle() { if (playing) stop(); else play(); }

  function step(by: number) {
    stop();
    let k = frame_of(now);
    if (now >= times[last]) k = last;
    if (by < 0 && now > times[k]) k++;
    show(times[Math.min(Math.max(k + by, 0), last)]);
  }

  button.addEventListener('click', toggle);
  slider.addEventListener('input', () => { stop(); show(Number(slider.value)); });
  function press(event: KeyboardEvent) {
    const on = (event.target as Element).tagName;
    if (event.ctrlKey || event.altKey || event.metaKey || /^(SELECT|TEXTAREA)$/.test(on)) return;
    const acts: Record<string, () => void> = {
      ' ': toggle, ','() { step(-1); }, '.'() { step(1); },
      Home() { stop(); show(times[0]); }, End() { stop(); show(times[last]); }
    };
    const act = acts[event.key];
    // The space bar activates a focused button.
    if (!act || event.key === ' ' && on === 'BUTTON') return;
    event.preventDefault();
    act();
  }
  host.addEventListener('keydown', press);
  const keys = host.querySelector('.view-keys') as Element, added: HTMLElement[] = [];
  [[say('space'), say('play, pause')], [', .', say('previous, next saved time')],
    ['Home, End', say('start, end')]].forEach((one) => {
    const parts = [element('kbd', '', one[0]), element('span', '', one[1])];
    added.push(...parts);
    keys.append(...parts);
  });

  // ---- graph ------------------------------------------------------------------------------------

  let curve: Graph | null = null;
  const measures = options.graph === false ? [] : told.graph || [];
  function mark() { if (curve) curve.mark(now); }
  if (measures.length) {
    const box = element('div', 'view-graph');
    added.push(box);
    const select = element('select', '', undefined, { 'aria-label': say('Measure to plot') });
    measures.forEach((one, k) => {
      select.appendChild(element('option', '', one.words, { value: k }));
    });
    box.appendChild(select);
    host.appendChild(box);
    const drawn = curve = new_graph(box, {
      times: told.graph_times, ends: told.ends, range: [times[0], times[last]],
      seek (time: number) { stop(); show(time); }
    });
    const draw = () => drawn.draw(measures[Number(select.value)]);
    select.addEventListener('change', draw);
    draw();
  }

  function end() {
    stop();
    host.removeEventListener('keydown', press);
    added.concat(bar).forEach((one) => { one.remove(); });
    host.classList.remove('moves');
  }

  stop();
  show(now);
  return { seek: (time) => { stop(); show(time); }, end };
}
