// The server of a shared page. The page is the flume tank's (web/src/tank); a worker with the engine settles the gear
// at the values of its fields. The picture is shown before the engine starts.

import type {
  Asked, Design, Edit, Edits, Field, Form, FromR, MeasureAbout, MeasureNumbers, Problem, Server, Told
} from '../protocol';
import type * as View from '../view';
import type { ToPage, ToWorker } from './messages';
import type { SharedGear, Shape } from './model';
import { unpacker, type Part } from './packed';

// The data of shared_page() in R/share-page.R
interface Page {
  begin: Pick<FromR['flume_begin'], 'language' | 'words' | 'sought' | 'units' | 'preferred' | 'about'>;
  form: Form; measures: MeasureAbout[]; numbers: MeasureNumbers; notes: string[]; parts: Record<string, string>;
  plan: string;
}
type Handlers = { [Name in keyof Told]?: (what: Told[Name]) => void } &
  { words(what: { number: number; asked: Asked['words'] }): void };

declare global { interface Window { codendShared: typeof state } }
// For tests
const state = {
  times: { picture: 0, first: 0, moves: 0, stuck: 0 },
  ready: false, settled: false, failed: undefined as string | undefined,
  shown: null as Pick<Shape, 'measures' | 'values'> | null, fields: [] as (SharedGear['fields'][number] & Field)[]
};
window.codendShared = state;

const packed = JSON.parse(document.getElementById('packed')?.textContent ?? '') as Record<Part, string>;
const { bytes, text, json } = unpacker(packed);
// a page without R
const without = {
  languages: [], checked: true, catalogue: { things: [], fields: {} }, gears: [], kinds: [], formats: [], opens: true,
  shares: false, can_share: false, guide: false, tow_saves: []
};

function failed(error: unknown) {
  state.failed = String(error);
  document.body.append('This browser cannot run the page: ' + (error instanceof Error ? error.message : String(error)) +
    '. The page needs Chrome 91, Firefox 113, Safari 16.4 or newer.');
}

function new_server({ begin, form, ...page }: Page, gear: SharedGear, scene: View.Scene): Server {
  const drawing = text('drawing'), base = scene.name, own = gear.fields.map((field) => field.value);
  const all = [...form.quick, ...form.groups.flatMap(({ parts }) => parts ?? []).flatMap(({ fields }) => fields ?? [])];
  const place = ({ paths }: Pick<Field, 'paths'>) => state.fields.findIndex((one) => one.paths.join() === paths.join());
  state.fields = gear.fields.map((field) =>
    ({ ...all.find((one) => one.paths.join() === field.paths.join()) as Field, ...field }));
  return (said, said_shape) => {
    let values = own.slice(), send: (said: ToWorker) => void = () => {}, waiting: number | null = null;

    // Returns the form with the present values.
    function form_now(): Form {
      const now = (one: Field) => ({ ...one, value: values[place(one)] });
      return {
        ...form, quick: form.quick.map(now), groups: form.groups.map((group) => ({
          ...group, parts: group.parts?.map((part) => ({ ...part, fields: part.fields?.map(now) ?? null })) ?? null
        }))
      };
    }
    // Returns a value in the unit of its field, NaN if it is invalid.
    function read({ unit, factor, dimension, whole }: Field, edit: Edit) {
      const [, number, named] = /^([-+\d.,e]+)\s*(.*)$/.exec(String(edit.value).trim()) ?? [];
      const wanted = named || edit.unit || unit;
      const size = wanted === unit ? factor : begin.units[dimension ?? '']?.[wanted];
      const value = Number(number?.replace(',', '.')) * (size / factor);
      return whole ? Math.round(value) : value;
    }
    function take(edits: Edits) {
      state.fields.forEach((field, k) => {
        if (field.paths.every((path) => path in edits)) values[k] = read(field, edits[field.paths[0]]);
      });
    }
    function tell_draft(laid_out: boolean) {
      const problems: Problem[] = state.fields
        .filter(({ lower, upper }, k) => !(values[k] >= lower && values[k] <= upper))
        .map(({ paths, must }) => ({ path: paths[0], message: 'The value must be ' + must + '.' }));
      said('flume_draft', { ...laid_out && { form: form_now() }, understood: {}, problems, settling: false });
      return !problems.length;
    }
    function settle(number: number) {
      if (waiting !== null) said('flume_idle', { answers: waiting });
      waiting = number;
      state.settled = false;
      send({ kind: 'move', number, values });
    }
    function design({ edits = [] }: Design) {
      values = own.slice();
      edits.forEach(take);
    }
    function picture(answers: number, notes: string[], part: Partial<View.Scene>) {
      said('flume_picture', { answers, edited: answers, notes, towed: false, scene: { name: base, ...part } });
    }
    function show({ moved, flow, conditions, measures, values, warnings }: Shape, answers: number, done: boolean) {
      said_shape({ answers: done ? answers : 0, counts: {}, part: { flow, conditions } }, { ...moved });
      state.shown = { measures, values };
      if (!done) return;
      const now = page.measures.map(({ name }) => measures[name]);
      picture(answers, warnings, { conditions });
      said('flume_measures', { now, error: now.map((value, k) =>
        Math.abs(value * (page.numbers.error[k] ?? NaN) / (page.numbers.now[k] ?? NaN))) });
    }
    function hear(answer: ToPage) {
      const { number } = answer;
      if (answer.kind === 'failed') {
        state.failed = answer.words;
        said('flume_refused', { answers: number, where: 'page', message: 'The engine stopped: ' + answer.words });
        return;
      }
      const { step, shape } = answer, latest = number === waiting, first = !state.ready;
      if (first) {
        state.times.first = performance.now();
        state.ready = true;
      } else if (!latest) return;
      const done = latest && step !== 'more';
      if (done) {
        waiting = null;
        state.settled = true;
        state.times[step === 'done' ? 'moves' : 'stuck'] += 1;
      }
      // the page may send its next move now
      show(shape, number, done && step === 'done');
      if (step !== 'stuck') return;
      const met = state.fields.filter((_, k) => shape.values[k] !== values[k]).map(({ paths, unit }) =>
        `${paths[0]} ${Number(shape.values[place({ paths })].toPrecision(6))} ${unit}`);
      said('flume_draft', { understood: {}, settling: false, problems: [{ path: null,
        message: `The gear does not settle beyond ${met.join(', ')}; the picture shows the gear there.` }] });
      said('flume_idle', { answers: number });
    }

    const handlers: Handlers = {
      design({ number, edits, design: whole, anew }) {
        if (whole) design(whole);
        else take(edits ?? {});
        if (tell_draft(anew)) settle(number);
        else said('flume_idle', { answers: number });
      },
      words({ number, asked }) {
        design(asked);
        said('flume_opened', { answers: number, design: { base } });
        tell_draft(true);
        settle(number);
      },
      kept({ number }) { said('flume_kept', { number, design: null }); },
      async drawing_wanted() { said('flume_drawing', { svg: await drawing }); },
      plan_wanted() { said('flume_plan', { text: page.plan }); },
      part_wanted({ name, path = page.parts[name ?? ''] ?? '' }) {
        const within = (inner: string, outer: string) => (inner + '.').startsWith(outer + '.');
        const names = Object.keys(page.parts).filter((one) =>
          within(page.parts[one], path) || within(path, page.parts[one]));
        said('flume_part', { path, names, clicked: name !== undefined });
      },
      async tow_wanted() { said('flume_tow', { scene: await json<View.Scene>('tow') }); }
    };
    // the page receives its handler first
    queueMicrotask(() => {
      said('flume_begin', { ...without, ...begin, tows: 'tow' in packed });
      // the address may have a design
      if (waiting === null) said('flume_opened', { answers: 0, design: { base } });
      picture(0, page.notes, scene);
      said('flume_measures', { about: page.measures, ...page.numbers });
      tell_draft(true);
      state.times.picture = performance.now();
    });
    Promise.all([text('worker'), bytes('wasm'), bytes('arrays')]).then(([code, wasm, arrays]) => {
      const made = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
      made.onmessage = (event) => hear(event.data);
      made.onerror = (event) => failed(event.message || 'the worker did not start');
      send = (said) => made.postMessage(said);
      const first: ToWorker = { kind: 'start', page: gear, wasm, bytes: new Uint8Array(arrays) };
      made.postMessage(first, [wasm, arrays]);
      if (waiting !== null) send({ kind: 'move', number: waiting, values });
    }).catch(failed);
    return (name, what) => handlers[name as keyof Handlers]?.(what as never);
  };
}

async function open() {
  const [page, gear, scene] =
    await Promise.all([json<Page>('page'), json<SharedGear>('model'), json<View.Scene>('scene')]);
  window.codendServer = new_server(page, gear, scene);
  for (const name of ['viewer', 'tank'] as const) {
    const script = document.createElement('script');
    script.textContent = await text(name);
    document.head.appendChild(script);
  }
}

if (!('DecompressionStream' in window) || !('WebAssembly' in window) || !('Worker' in window)) failed('it is too old');
else open().catch(failed);
