// Messages between a shared page and its worker. `number` identifies a move.

import type { SharedGear, Shape, Step } from './model';

export type ToWorker =
  | { kind: 'start'; page: SharedGear; bytes: Uint8Array; wasm: ArrayBuffer }
  | { kind: 'move'; number: number; values: number[] };
export type ToPage =
  | { kind: 'shape'; number: number; step: Step; shape: Shape }
  | { kind: 'failed'; number: number; words: string };
