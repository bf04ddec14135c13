// A shared page: viewer, sliders and measures of a gear that a worker settles. The picture is shown
// before the engine starts.

import type * as View from '../view';
import type { ToPage, ToWorker } from './messages';
import type { SharedGear, Shape } from './model';
import { unpacker, type Part } from './packed';
import { error_digits, figures, snapped } from '../numbers';

// `codendView` is defined by the packed viewer, `codendShared` is for tests.
declare global {
  interface Window { codendView: typeof View; codendShared: typeof state }
}
const state = {
  times: { picture: 0, first: 0, moves: 0, stuck: 0 },
  ready: false, settled: false, failed: undefined as string | undefined,
  shown: null as Pick<Shape, 'measures' | 'values'> | null, sizes: {} as Record<string, number>,
  move: undefined as ((to: number[]) => void) | undefined
};
window.codendShared = state;

function by_id<Kind extends HTMLElement>(id: string): Kind { return document.getElementById(id) as Kind; }
const told = by_id('told'), packed = JSON.parse(by_id('packed').textContent ?? '') as Record<Part, string>;
const { bytes, text, json } = unpacker(packed);

function failed(error: unknown) {
  told.textContent = 'This browser cannot run the page: ' + (error instanceof Error ? error.message : String(error)) +
    '. The page needs Chrome 91, Firefox 113, Safari 16.4 or newer.';
  state.failed = String(error);
}

const moving = ['points', 'places', 'boards', 'rope_tension', 'u', 'v', 'drag', 'opening', 'angle'] as const;

function start(scene: View.Scene, page: SharedGear) {
  const { element, new_viewer } = window.codendView, viewer = new_viewer(by_id('tank'));
  viewer?.show(scene);
  state.times.picture = performance.now();

  // ---- sliders ----------------------------------------------------------------------------------

  const fields = page.fields, own = fields.map((field) => field.value), values = own.slice();
  const outputs: HTMLOutputElement[] = [], inputs = fields.map(({ label, lower, upper }, k) => {
    const box = element('div', 'slider'), id = 'slider-' + (k + 1);
    const about = { type: 'range', id, min: lower, max: upper, step: 'any', disabled: '' };
    const input = element('input', '', undefined, about);
    outputs.push(element('output', '', undefined, { for: id }));
    box.append(element('label', '', label, { for: id }), outputs[k], input);
    by_id('sliders').appendChild(box);
    return input;
  });
  const reset = by_id<HTMLButtonElement>('reset');
  function with_unit(k: number, value: number) { return (Number(value.toPrecision(6)) + ' ' + fields[k].unit).trim(); }
  function tell_slider(k: number) {
    outputs[k].value = with_unit(k, values[k]);
    inputs[k].setAttribute('aria-valuetext', outputs[k].value);
  }
  // Returns the sliders that stopped early, each with the reached and the requested value.
  function met(at: number[]) {
    return fields.map((field, k) => at[k] === values[k] ? '' :
      field.label + ' ' + with_unit(k, at[k]) + ' (of ' + with_unit(k, values[k]) + ')').filter(Boolean).join(', ');
  }
  let number = 0, shown = 0;
  function move() {
    number += 1;
    reset.disabled = values.every((v, k) => v === own[k]);
    if (towing) tow_off();
    state.settled = false;
    send({ kind: 'move', number, values: values.slice() });
    busy(true);
  }
  function slide(k: number, value: number) {
    values[k] = snapped(fields[k], value);
    tell_slider(k);
    move();
  }
  const steps: Record<string, number> = {
    ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10
  };
  inputs.forEach((input, k) => {
    input.addEventListener('input', () => slide(k, Number(input.value)));
    // A key moves the slider by one step or by ten.
    input.addEventListener('keydown', (event) => {
      const by = steps[event.key];
      if (!by) return;
      event.preventDefault();
      slide(k, values[k] + by * fields[k].step);
      input.value = String(values[k]);
    });
  });
  function set(to: number[]) {
    to.forEach((value, k) => {
      values[k] = value;
      inputs[k].value = String(value);
      tell_slider(k);
    });
  }
  set(own);
  reset.addEventListener('click', () => { set(own); move(); });
  state.move = (to) => { set(to); move(); };

  // ---- results ----------------------------------------------------------------------------------

  const names = Object.keys(page.programs), rows = names.map((name) => {
    const row = by_id<HTMLTableSectionElement>('measures').insertRow(), { size, words } = page.programs[name];
    state.sizes[name] = size;
    row.append(element('th', '', words, { scope: 'row' }),
      ...['now', 'error', 'change'].map((kind) => element('td', kind)));
    return row;
  });
  function busy(is: boolean) { document.body.classList.toggle('busy', is); }
  function write(measures: Record<string, number>) {
    names.forEach((name, k) => {
      const of = page.programs[name], now = measures[name] / of.size, cells = rows[k].cells;
      cells[1].textContent = figures(now) + ' ' + of.unit;
      cells[2].textContent = of.error ? error_digits(of.error * Math.abs(now)) : '';
      const change = now - of.value, size = Math.max(Math.abs(of.value), 1e-12);
      const words = Math.abs(change) < 5e-4 * size ? '' : (change > 0 ? '+' : '') + figures(change) + (of.value !== 0 ?
        ' (' + (change > 0 ? '+' : '\u2212') + Math.abs(100 * change / of.value).toFixed(1) + ' %)' : '');
      cells[3].textContent = words;
      cells[3].className = 'change' + (words ? change > 0 ? ' more' : ' less' : '');
    });
  }
  write(Object.fromEntries(names.map((name) => [name, page.programs[name].value * page.programs[name].size])));
  function show(shape: Shape) {
    const fixed: Partial<View.Scene> = { flow: shape.flow };
    moving.forEach((name) => {
      const floats = shape.moved[name];
      if (floats) fixed[name] = { floats };
    });
    viewer?.pass(fixed);
    write(shape.measures);
    by_id('conditions').textContent = shape.conditions;
    const list = by_id('warnings');
    list.replaceChildren(...shape.warnings.map((words) => element('li', '', words)));
    list.hidden = !shape.warnings.length;
    state.shown = { measures: shape.measures, values: shape.values };
  }

  // ---- the worker -------------------------------------------------------------------------------

  let send: (said: ToWorker) => void = () => {};
  function hear(said: ToPage) {
    if (said.kind === 'failed') {
      told.textContent = 'The engine stopped: ' + said.words;
      state.failed = said.words;
      busy(false);
      return;
    }
    show(said.shape);
    if (!state.ready) {
      state.times.first = performance.now();
      inputs.forEach((input) => { input.disabled = false; });
      told.textContent = 'Move a slider: the gear settles in this page.';
      state.ready = true;
      return;
    }
    if (said.number < number) return;
    if (said.step === 'stuck') {
      state.times.stuck += 1;
      told.textContent = 'The gear does not settle beyond ' + met(said.shape.values) +
        '; the picture shows the gear there.';
      set(said.shape.values);
      busy(false);
    } else if (said.step === 'done') {
      state.times.moves += 1;
      shown = said.number;
      told.textContent = 'Settled.';
      busy(false);
    }
    state.settled = shown === number || said.step === 'stuck';
  }
  Promise.all([text('worker'), bytes('wasm'), bytes('arrays')]).then(([code, wasm, arrays]) => {
    const made = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
    made.onmessage = (event) => hear(event.data);
    made.onerror = (event) => failed(event.message || 'the worker did not start');
    send = (said) => made.postMessage(said);
    const first: ToWorker = { kind: 'start', page, wasm, bytes: new Uint8Array(arrays) };
    made.postMessage(first, [wasm, arrays]);
  }).catch(failed);

  // ---- drawing and tow --------------------------------------------------------------------------

  const drawing = by_id<HTMLDetailsElement>('drawing'), place = drawing.querySelector('.drawing') as Element;
  drawing.addEventListener('toggle', async () => {
    if (!drawing.open || !('drawing' in packed)) return;
    const svg = new Blob([await bytes('drawing')], { type: 'image/svg+xml' });
    place.appendChild(element('img', '', undefined, {
      alt: 'The net laid flat with meshes, mesh sizes, twines and cutting rates, and its rigging. ' +
        'The plan as text is at the end of this page.',
      src: URL.createObjectURL(svg)
    }));
  });
  let towing = false, motion: View.Scene | null = null;
  const button = document.getElementById('tow');
  function tow_off() {
    towing = false;
    button?.setAttribute('aria-pressed', 'false');
    if (button) button.textContent = 'Play the tow';
    viewer?.show(scene);
  }
  button?.addEventListener('click', async () => {
    if (!viewer) return;
    if (towing) { tow_off(); move(); return; }
    motion = motion ?? await json<View.Scene>('tow');
    towing = true;
    button.setAttribute('aria-pressed', 'true');
    button.textContent = 'Back to the sliders';
    viewer.show(motion);
  });
}

async function open() {
  const script = document.createElement('script');
  script.textContent = await text('viewer');
  document.head.appendChild(script);
  const [scene, page] = await Promise.all([json<View.Scene>('scene'), json<SharedGear>('model')]);
  start(scene, page);
}

if (!('DecompressionStream' in window) || !('WebAssembly' in window) || !('Worker' in window)) failed('it is too old');
else open().catch(failed);
