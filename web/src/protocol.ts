// Messages between R and the page of the flume tank. tests/testthat/helper-flume.R reads this file and
// checks the messages of all tests against it. Each message and each of its fields has its own line.

import type { Measured, Scene } from './view';

// A change of a plan field; R/flume-edits.R describes them.
// A value without other items has no unit.
export interface Edit {
  value?: string | number | boolean; unit?: string; gone?: true; like?: string; after?: string; rename?: string;
  move?: number;
}
export type Edits = Record<string, Edit>;

// A control of the form; R/page-fields.R describes it. The page adds labels and titles, here and below.
export interface Field {
  label: string; usual?: boolean; paths: string[]; help: string; must: string | null; required: boolean;
  kind: 'number' | 'choice' | 'truth' | 'word' | 'yaml'; value: string | number | boolean | null;
  unit: string; factor: number; dimension: string | null; whole: boolean; low?: number; high?: number; step?: number;
  typed: string | null; choices: string[]; suggest: string[];
}
// A part of a group of the form; R/page-form.R describes both. The fields of a group itself are a part
// without a path.
export interface Part {
  path: string; title: string; fields: Field[] | null; help?: string; picks?: { path: string; classes: string[] }[];
  absent?: string[]; open?: boolean; named?: boolean; required?: boolean;
}
export interface Group { title: string; words: string; parts: Part[] | null; open: boolean; absent: string[] }
export interface Form { turn: number; kind: string; quick: Field[]; groups: Group[] }

export interface Problem { path: string | null; message: string }
// R's interpretation of a typed number
export interface Understood { text: string; doubt: { message: string; instead: string | null } | null }

// A row of the catalogue; R/flume-catalogue.R describes it.
export interface CatalogueRow {
  class: string; title: string; says: string; values: Record<string, string>; source: string;
}
export type OwnRow = Pick<CatalogueRow, 'class' | 'title' | 'values'>;
export interface Catalogue { things: CatalogueRow[]; fields: Record<string, Record<string, string>> }

// A design: a shipped plan or the text of a plan, with changes in their order; R/flume-designs.R reads it.
export interface Design { base?: string; plan?: string; edits?: Edits[] }
export interface KeptDesign extends Design { name: string }
// The designs of an address or a file. `draft` is a design that differs from `now` and has not settled.
export interface Words { now?: Design; kept?: KeptDesign[]; draft?: Design | null; own?: OwnRow[]; units?: Units }
export type Units = Record<string, string>;
export interface SharedDesign { author: string; name: string; changed: string }

// The effect of a field on the measures; R/flume-sensitivities.R describes it.
export interface Sensitivity {
  paths: string[]; value: number; unit: string; more: number; measures: string[]; units: string[];
  slope: number[]; below: (number | null)[]; above: (number | null)[]; smooth: boolean[];
  elasticity: (number | null)[];
}
// A measure; `key` is true for key measures. Labels of measures are in English.
export interface MeasureAbout { name: string; label: string; unit: string; definition: string; key: boolean }
type Maybe = number | null;
// Numbers in the order of the measures. Intervals have a level.
export interface MeasureNumbers { now: Maybe[]; error: Maybe[]; level?: number; lower?: Maybe[]; upper?: Maybe[] }
export interface Measures extends MeasureNumbers { about: MeasureAbout[] }
// Measures over a field; R/flume-vary.R describes them.
export interface Varied {
  path: string; unit: string; now: number | null; of: number; range: number[]; values: number[]; problems: string[];
  measures: (Measured & { unit: string })[];
}

// A change of speed, course or warp, as typed.
export interface Change { from: string; over: string; to?: string; by?: string }

// A table by columns. `parts` names the gear's parts in each row.
export interface Table { columns: (string | number | null)[][]; parts: string[][] }

// Messages from R. `answers` is the number of a request, 0 without one. A page without R has `about`, a note about
// itself, and `tows` if it has a tow.
export interface FromR {
  flume_begin: {
    language: string;
    languages: { name: string; words: string }[];
    checked: boolean;
    words: Record<string, string>;
    sought: Record<string, string>;
    catalogue: Catalogue;
    units: Record<string, Record<string, number>>;
    preferred: Record<string, string[]>;
    gears: { name: string; title: string; kind: string; panels: number; ropes: number; speed: number }[];
    kinds: { name: string; values: Record<string, string> }[];
    formats: { name: string; title: string; extension: string; opens: string }[];
    tow_saves: string[];
    opens: boolean;
    shares: boolean;
    can_share: boolean;
    guide: boolean;
    about?: string;
    tows?: boolean;
  };
  flume_opened: {
    answers: number;
    design: Design;
  };
  flume_picture: {
    answers: number;
    edited: number;
    notes: string[];
    towed: boolean;
    scene: Partial<Scene>;
  };
  flume_idle: {
    answers: number;
  };
  flume_refused: {
    answers: number;
    where: string;
    message: string;
    path?: string | null;
    cancelled?: boolean;
  };
  flume_draft: {
    form?: Form | null;
    understood: Record<string, Understood | null>;
    problems: Problem[];
    settling: boolean;
  };
  flume_measures: {
    about?: MeasureAbout[];
    now: Maybe[];
    error: Maybe[];
    level?: number;
    lower?: Maybe[];
    upper?: Maybe[];
  };
  flume_clerk: {
    busy: boolean;
    what: string;
  };
  flume_offers: {
    path: string;
    title: string;
    offers: Field[];
  };
  flume_kept: {
    number: number;
    design: { scene: Scene; about: MeasureAbout[]; numbers: MeasureNumbers } | null;
  };
  flume_words: {
    answers: number;
    words: Words;
  };
  flume_own: {
    rows: CatalogueRow[];
  };
  flume_shared: {
    designs: SharedDesign[];
  };
  flume_shared_done: Record<string, never>;
  flume_drawing: {
    svg: string;
  };
  flume_part: {
    path: string;
    names: string[];
    clicked: boolean;
  };
  flume_plan: {
    text: string;
  };
  flume_code: {
    text: string;
  };
  flume_table: {
    name: string;
    tables: Table[];
  };
  flume_sensitivities: {
    fields: Sensitivity[];
  };
  flume_varied: {
    running: boolean;
    varied: Varied;
  };
  flume_target: {
    paths: string[];
    value: number;
    unit: string;
    low: number;
    high: number;
    reached: boolean;
    measure: string;
    measure_unit: string;
    target: number;
    result: number;
  };
  flume_tow: {
    scene: Scene;
  };
}

// The headers of binary messages (R/flume-message.R): a file, whose bytes follow; a shape while a slider
// moves (R/flume-picture.R); the derivative of the shape by the fields `predicts` with their `value` in SI
// (R/flume-prediction.R). Floats follow the last two, `counts` by name.
export interface FileHeader { file: string }
export interface PredictionHeader { predicts: string[]; value: number; counts: Record<string, number> }
export interface MovedHeader { answers: number; counts: Record<string, number>; part: Partial<Scene> }

// A server in the page (web/src/share/page.ts) instead of R. It receives the handlers of its messages and returns the
// handler of the page's messages.
export type Server = (
  said: <Name extends keyof FromR>(name: Name, message: FromR[Name]) => void,
  said_shape: (header: MovedHeader, arrays: Record<string, Float32Array>) => void
) => (name: string, what: unknown) => void;

declare global { interface Window { codendServer?: Server } }

// Requests with an answer. `asked` of the message has the type that is listed here.
export interface Asked {
  new: { kind: string; values: Record<string, string> };
  plan_file: { name: string; text: string };
  words: Design;
  shared_open: { author: string; name: string };
}

// Other messages to R.
export interface Told {
  design: { number: number; turn: number; edits?: Edits; design?: Design; anew: boolean };
  kept: { number: number; design: Design };
  own: { rows: OwnRow[] };
  offers: { path: string; title: string };
  shared: { act: string; name: string; author: string; key: string; words: Words | null };
  cancel: null;
  plan_wanted: null;
  code_wanted: { opened: Design; kept: Design };
  table_wanted: { name: 'tensions' | 'drag' | 'differences'; kept?: Design };
  save_wanted: string;
  intervals_wanted: boolean;
  drawing_wanted: null;
  part_wanted: { name?: string; path?: string };
  prediction_wanted: { paths: string[] };
  slopes_wanted: { paths: string[] | null };
  vary_wanted: { paths: string[]; unit: string; from: string; to: string; number: number };
  vary_stop: null;
  target_wanted: { paths: string[]; measure: string; unit: string; target: string };
  tow_wanted: { until: string; planned?: true; changes?: Record<string, Change> };
}
