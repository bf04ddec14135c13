// Named arrays of a shared page, as packed_arrays() in R/share-arrays.R writes them.
//
// `codendArrays(head, bytes, arrays)`: `head` lists the position and type of each array in `bytes`.
// `arrays` contains the unpacked arrays by name. Returns {has(name), array(name)}.
function codendArrays(head, bytes, arrays) {
  'use strict';
  function numbers(of, Kind) {
    var n = of[1], size = Kind.BYTES_PER_ELEMENT, raw = bytes.slice(of[2], of[2] + n * size);
    if (!of[3]) return new Kind(raw.buffer);
    // Bytes of equal significance are stored together.
    var out = new Uint8Array(n * size);
    for (var b = 0; b < size; b++) {
      for (var k = 0; k < n; k++) out[size * k + b] = raw[b * n + k];
    }
    return new Kind(out.buffer);
  }
  function unpack(of) {
    if (of[0] === 'd') return numbers(of, Float64Array);
    if (of[0] === 'f') return numbers(of, Float32Array);
    var whole = numbers(of, Int32Array), words = [].concat(of[4]);
    for (var k = 1; k < whole.length; k++) whole[k] += whole[k - 1];
    return of[0] === 'i' ? whole : Array.from(whole, function (k) { return words[k]; });
  }
  return {
    has: function (name) { return name in head; },
    array: function (name) {
      if (!(name in arrays)) {
        if (!(name in head)) throw new Error('There is no array ' + name);
        arrays[name] = unpack(head[name]);
      }
      return arrays[name];
    }
  };
}
if (typeof module !== 'undefined') module.exports = codendArrays;
