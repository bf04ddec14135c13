// The packed data of a shared page, as shared_parts() in R/share-page.R writes them.

export type Part = 'viewer' | 'tank' | 'page' | 'worker' | 'wasm' | 'scene' | 'model' | 'arrays' | 'drawing' | 'tow';

// Each part can be unpacked once.
export function unpacker(packed: Partial<Record<Part, string>>) {
  function bytes(name: Part): Promise<ArrayBuffer> {
    const raw = Uint8Array.from(atob(packed[name] ?? ''), (letter) => letter.charCodeAt(0));
    delete packed[name];
    const format = raw[0] === 0x1f ? 'gzip' : 'deflate';
    return new Response(new Blob([raw]).stream().pipeThrough(new DecompressionStream(format))).arrayBuffer();
  }
  async function text(name: Part): Promise<string> { return new TextDecoder().decode(await bytes(name)); }
  async function json<Kind>(name: Part): Promise<Kind> { return JSON.parse(await text(name)); }
  return { bytes, text, json };
}
