// Named arrays of a shared page, as packed_arrays() in R/share-arrays.R writes them.

// type, length, first byte, and the distinct strings
export type Entry = ['d' | 'f' | 'i' | 'w' | 'g', number, number, string[]];
export type Head = Record<string, Entry>;
export type NamedArray = Float64Array | Float32Array | Int32Array | string[];

function unpack([type, count, from, strings]: Entry, bytes: Uint8Array): NamedArray {
  const raw = bytes.slice(from, from + count * (type === 'd' ? 8 : 4));
  if (type === 'd') return new Float64Array(raw.buffer);
  if (type === 'f') return new Float32Array(raw.buffer);
  const whole = new Int32Array(raw.buffer);
  for (let k = 1; k < whole.length; k++) whole[k] += whole[k - 1];
  return type === 'i' ? whole : Array.from(whole, (k) => strings[k]);
}

// Returns a function that returns an array by its name. `arrays` contains the unpacked ones.
export function array_reader(head: Head, bytes: Uint8Array, arrays: Record<string, NamedArray> = {}) {
  return (name: string): NamedArray => {
    if (!(name in arrays)) {
      if (!(name in head)) throw new Error('There is no array ' + name);
      arrays[name] = unpack(head[name], bytes);
    }
    return arrays[name];
  };
}
