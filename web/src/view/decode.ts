// Decodes the numbers of a scene.

import { strToU8, unzlibSync } from 'fflate';
import type { Numbers, Packed, Places, Series } from './scene';

export interface PlaceSource { of(k: number, share: number): Float32Array; low: Float32Array; size: Float32Array }
export interface ValueSource { of(k: number): Float32Array }

const bytes = (text: string) => strToU8(atob(text), true).buffer as ArrayBuffer;
export function floats(given: Packed): Float32Array {
  return typeof given === 'string' ? new Float32Array(bytes(given)) : given as Float32Array;
}
export function integers(given: Packed): Int32Array {
  return typeof given === 'string' ? new Int32Array(bytes(given)) : given as Int32Array;
}

// Decodes n series of 16-bit integers from deflated differences in time. sign: true if signed.
function series(part: Series, sign?: boolean) {
  const raw = unzlibSync(new Uint8Array(bytes(part.text))), size = raw.length / 2;
  const out = sign ? new Int16Array(size) : new Uint16Array(size), times = size / part.count;
  for (let i = 0; i < size; i++) out[i] = raw[i] | raw[size + i] << 8;
  for (let order = 0; order < part.order; order++) {
    for (let i = 0; i < size; i++) if (i % times) out[i] += out[i - 1];
  }
  return { of: out, times };
}

// Positions at stored times. `of(k, share)` interpolates between time k and the next.
export function places(part: Places): PlaceSource {
  if (part.floats !== undefined) {
    const fixed = floats(part.floats);
    return { of: () => fixed, low: fixed, size: new Float32Array(fixed.length) };
  }
  const low = floats(part.low), step = floats(part.step), all = series(part.steps), n = low.length;
  const now = new Float32Array(n), times = all.times, steps = all.of;
  return {
    low, size: floats(part.size),
    of: (k: number, share: number) => {
      const next = k + 1 < times ? 1 : 0;
      for (let i = 0; i < n; i++) {
        const a = steps[i * times + k], b = steps[i * times + k + next];
        now[i] = low[i] + step[i] * (a + share * (b - a));
      }
      return now;
    }
  };
}

// Values at stored times, from signed square roots in 12 bits; -32768 is NaN.
export function values(part: Numbers | null | undefined): ValueSource | null {
  if (!part) return null;
  if (part.floats !== undefined) {
    const fixed = floats(part.floats);
    return { of: () => fixed };
  }
  const all = series(part.steps, true), n = part.steps.count, out = new Float32Array(n);
  return {
    of: (k: number) => {
      for (let i = 0; i < n; i++) {
        const r = all.of[i * all.times + k];
        out[i] = r === -32768 ? NaN : (r < 0 ? -1 : 1) * part.top * (r / 4095) * (r / 4095);
      }
      return out;
    }
  };
}
