// The packed data of a shared page, as shared_parts() in R/share-page.R writes them.

export type Part = 'viewer' | 'worker' | 'wasm' | 'scene' | 'shapes' | 'model' | 'arrays' | 'drawing' | 'tow';

// Returns the value of one of 91 characters.
function letter(code: number): number { return code - 33 - Number(code > 34) - Number(code > 60) - Number(code > 92); }

// Decodes 13 bits, lowest first, from each pair of characters.
export function decoded(count: number, text: string): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(count);
  for (let at = 0, k = 0, held = 0, bits = 0; at < count; k += 2) {
    held |= (letter(text.charCodeAt(k)) + 91 * letter(text.charCodeAt(k + 1))) << bits;
    for (bits += 13; bits > 7 && at < count; bits -= 8, held >>= 8) out[at++] = held & 255;
  }
  return out;
}

// Each part can be unpacked once.
export function unpacker(packed: Partial<Record<Part, [number, string]>>) {
  function bytes(name: Part): Promise<ArrayBuffer> {
    const [count, text] = packed[name] ?? [0, ''];
    delete packed[name];
    const stream = new Blob([decoded(count, text)]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
  }
  async function text(name: Part): Promise<string> { return new TextDecoder().decode(await bytes(name)); }
  async function json<Kind>(name: Part): Promise<Kind> { return JSON.parse(await text(name)); }
  return { bytes, text, json };
}
