// The data of a scene, as R/scene-gear.R writes them, and shared pages and the tank as they move.

// base64 of little-endian numbers, or the numbers
export type Packed = string | Float32Array | Int32Array;
export interface Series { text: string; count: number; order: number }
export interface FixedNumbers { floats: Packed }
export interface MovingPlaces { floats?: undefined; low: Packed; step: Packed; size: Packed; steps: Series }
export interface MovingValues { floats?: undefined; top: number; steps: Series }
export type Places = FixedNumbers | MovingPlaces;
export type Numbers = FixedNumbers | MovingValues;

export interface Panel {
  part: number; columns: number | null; rows: number; down: number[]; full: number | null;
  point: Packed; mesh: Packed; scale: number; offset: number[];
}
export interface Scale { heading: string; limits: number[]; log: boolean; ticks: string[]; at: number[] }
export type Scales = Partial<Record<'rope' | 'netting', Scale>>;
// JSON has no NaN, so R writes null or "NA".
type MaybeNumber = number | null | string;
export interface Measured { words: string; shown?: string; values: MaybeNumber[]; errors?: MaybeNumber[] }

export interface Scene {
  name: string; conditions: string; colour?: Mode; water: boolean; flow: number[];
  bed: { normal: number[]; height: number } | null;
  times: number[]; labels: string[]; graph: Measured[]; graph_times: number[]; ends: string[];
  parts: {
    name: string[]; kind: string[]; role: string[]; thickness: number[]; strength: number[];
    mesh: number[]; bar: number[]; form: number[];
  };
  ropes: { ends: Packed; part: Packed };
  netting: Panel[];
  marks: {
    role: string[]; part: string[]; label: string[]; fill: string[]; board: number[]; direction: string[];
    size: number[];
  };
  vessels: number[][];
  colours: { rope: string[]; netting: string[]; slack: string; slack_muted: string };
  scales: Partial<Record<Mode, Scales>>;
  points: Places; places: Places; boards: Places;
  rope_tension: Numbers; u: Numbers; v: Numbers; drag: Numbers;
  opening: Numbers | null; angle: Numbers | null;
}

export type Mode = 'tension' | 'slack' | 'mesh_opening' | 'mesh_angle' | 'drag';
export interface Range { low: number[]; high: number[] }

// A new range, or the other one if one is missing.
export function join(one: Range | null, other: Range | null): Range | null {
  if (!one || !other) return one || other;
  return {
    low: one.low.map((v, k) => Math.min(v, other.low[k])), high: one.high.map((v, k) => Math.max(v, other.high[k]))
  };
}
