import { render } from 'preact';
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

export const motion_keys = () => [[say('space'), say('play, pause')],
  [', .', say('previous, next saved time')], ['Home, End', say('start, end')]];

export function new_motion(
  host: HTMLElement, viewer: { time(k: number, share: number): void }, told: Scene, options: MotionOptions
): Motion {
  const times = told.times, last = times.length - 1;
  const longest = 20;  // s, maximum playback time

  host.classList.add('moves');
  const bar = host.appendChild(element('div', 'view-time'));

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
    write();
    curve?.mark(now);
    if (options.moved) options.moved(now);
  }

  function write() {
    const k = frame_of(now), words = told.labels[now - times[k] < times[k + 1] - now ? k : k + 1];
    render([
      <button type="button" class="view-button" onClick={toggle}>{playing ? say('Pause') : say('Play')}</button>,
      <input type="range" min={times[0]} max={times[last]} step="any" value={now} aria-label={say('Time')}
        aria-valuetext={words} onInput={(event) => seek(Number(event.currentTarget.value))} />,
      <div class="label">{words}</div>
    ], bar);
  }
  function seek(time: number) {
    stop();
    show(time);
  }

  function stop() {
    if (playing) window.cancelAnimationFrame(playing.request);
    playing = null;
    write();
  }

  function play() {
    if (now >= times[last]) now = times[0];
    const rate = Math.max(1, (times[last] - times[0]) / longest);
    playing = { clock: null, request: 0 };
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

  function press(event: KeyboardEvent) {
    const on = (event.target as Element).tagName;
    if (event.ctrlKey || event.altKey || event.metaKey || /^(SELECT|TEXTAREA)$/.test(on)) return;
    const acts: Record<string, () => void> = {
      ' ': toggle, ','() { step(-1); }, '.'() { step(1); },
      Home() { seek(times[0]); }, End() { seek(times[last]); }
    };
    const act = acts[event.key];
    // The space bar activates a focused button.
    if (!act || event.key === ' ' && on === 'BUTTON') return;
    event.preventDefault();
    act();
  }
  host.addEventListener('keydown', press);

  // ---- graph ------------------------------------------------------------------------------------

  let curve: Graph | null = null;
  const measures = options.graph === false ? [] : told.graph || [], box = element('div', 'view-graph');
  if (measures.length) {
    host.appendChild(box);
    const draw = (k: number) => curve?.draw(measures[k]), place = box.appendChild(element('div'));
    render(<select aria-label={say('Measure to plot')} onChange={(event) => draw(Number(event.currentTarget.value))}>
      {measures.map((one, k) => <option value={k}>{one.words}</option>)}
    </select>, place);
    curve = new_graph(box, {
      times: told.graph_times, ends: told.ends, range: [times[0], times[last]], unit: 's', seek
    });
    draw(0);
  }

  function end() {
    stop();
    host.removeEventListener('keydown', press);
    box.remove();
    bar.remove();
    host.classList.remove('moves');
  }

  show(now);
  return { seek, end };
}
