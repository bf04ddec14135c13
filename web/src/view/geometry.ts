// Ranges and directions of the viewer. The axes are x aft, y to starboard, z up (m).

import type { Range } from './scene';

export interface Axes { eye: number[]; right: number[]; up: number[] }

export function longest(range: Range) {
  return Math.max(range.high[0] - range.low[0], range.high[1] - range.low[1],
    range.high[2] - range.low[2], 1e-6);
}
export function middle(range: Range) {
  return range.low.map((v, k) => (v + range.high[k]) / 2);
}

// Returns the directions of a camera: towards the eye, to the right and up.
export function axes(turn: number, rise: number): Axes {
  const eye = [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)];
  const right = [-Math.sin(turn), Math.cos(turn), 0];
  const up = [
    eye[1] * right[2] - eye[2] * right[1], eye[2] * right[0] - eye[0] * right[2],
    eye[0] * right[1] - eye[1] * right[0]
  ];
  return { eye, right, up };
}
export function dot(a: number[], b: number[]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Returns the nearest of 1, 2, 5 and 10 times a power of ten.
export function round(size: number) {
  const power = Math.pow(10, Math.floor(Math.log10(size)));
  const lead = size / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}
