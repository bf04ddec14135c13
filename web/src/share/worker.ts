// The worker of a shared page settles the gear at the latest values of the sliders, in steps if
// they are far away. A new move replaces an older one after the current step.

import type { ToPage, ToWorker } from './messages';
import { new_model, type Engine, type Model, type Step } from './model';

// inst/share/engine.js, which precedes this script
declare function codendEngine(options: object): Promise<Engine>;

// For tests in node.
export { new_model };

let model: Model | null = null, busy = false, number = 0;
let wanted: { number: number; values: number[] } | null = null, next: (() => Step) | null = null;

function tell(said: ToPage, moved: ArrayBuffer[] = []) { postMessage(said, { transfer: moved }); }
function failed(error: unknown) {
  tell({ kind: 'failed', number, words: error instanceof Error ? error.message : String(error) });
}
function show(from: Model, step: Step) {
  const shape = from.shape();
  tell({ kind: 'shape', number, step, shape },
    Object.values(shape.moved).map((array: Float32Array<ArrayBuffer>) => array.buffer));
}

function work(settled: Model) {
  if (wanted) {
    next = settled.walk(wanted.values);
    number = wanted.number;
    wanted = null;
  }
  if (!next) { busy = false; return; }
  try {
    const step = next();
    if (step !== 'more') next = null;
    show(settled, step);
  } catch (error) {
    next = null;
    failed(error);
  }
  // The timeout lets messages of new moves arrive.
  setTimeout(work, 0, settled);
}

globalThis.onmessage = (event: MessageEvent<ToWorker>) => {
  const said = event.data;
  if (said.kind === 'start') {
    codendEngine({ wasmBinary: said.wasm, print() {}, printErr() {} }).then((engine) => {
      model = new_model(engine, said.page, said.bytes);
      show(model, 'done');
      busy = true;
      work(model);
    }).catch(failed);
    return;
  }
  wanted = said;
  if (!busy && model) { busy = true; setTimeout(work, 0, model); }
};
