// Messages between a shared page and its worker. `number` identifies a move.

import type { SharedGear, Shape } from './model';

export type ToWorker =
  | { kind: 'start'; page: SharedGear; bytes: Uint8Array; wasm: ArrayBuffer }
  | { kind: 'move'; number: number; values: number[] };
export type ToPage =
  | { kind: 'shape'; number: number; done: boolean; shape: Shape }
  | { kind: 'stuck'; number: number; shape: Shape }
  | { kind: 'failed'; number: number; words: string };
