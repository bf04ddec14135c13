import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { array_reader } from '../src/share/arrays';
import { decoded, unpacker } from '../src/share/packed';

// Encodes bytes as letters_of() in R/share-arrays.R: 13 bits, lowest first, in two of 91 characters.
const printed = Array.from({ length: 94 }, (_, k) => String.fromCharCode(33 + k));
const letters = printed.filter((one) => !'"<\\'.includes(one));
function encoded(bytes: Uint8Array): [number, string] {
  let text = '', held = 0, bits = 0;
  const write = () => { text += letters[held % 8192 % 91] + letters[Math.floor(held % 8192 / 91)]; };
  bytes.forEach((byte) => {
    held += byte * 2 ** bits;
    bits += 8;
    if (bits < 13) return;
    write();
    held = Math.floor(held / 8192);
    bits -= 13;
  });
  if (bits) write();
  return [bytes.length, text];
}

test('decoded() restores all bytes of the letters of a shared page', () => {
  const bytes = Uint8Array.from({ length: 1000 }, (_, k) => k * 7 % 256);
  assert.deepEqual(decoded(...encoded(bytes)), bytes);
});

test('unpacker() inflates JSON once', async () => {
  const { json, text } = unpacker({ model: encoded(new Uint8Array(deflateSync('{"name": "M\u00f8re"}'))) });
  assert.deepEqual(await json('model'), { name: 'M\u00f8re' });
  await assert.rejects(text('model'));
});

test('array_reader() reads differences, distinct strings and bytes of equal weight', () => {
  const whole = new Uint8Array(Int32Array.of(5, -2, 1).buffer);
  const numbers = new Uint8Array(Float64Array.of(0.5, 2).buffer);
  const together = Uint8Array.from({ length: 16 }, (_, k) => numbers[8 * (k % 2) + (k >> 1)]);
  const array = array_reader({
    whole: ['i', 3, 0, 0, []], words: ['w', 2, 12, 0, ['rope', 'net']], numbers: ['d', 2, 20, 1, []]
  }, Uint8Array.from([...whole, ...new Uint8Array(Int32Array.of(1, -1).buffer), ...together]));
  assert.deepEqual(array('whole'), Int32Array.of(5, 3, 4));
  assert.deepEqual(array('words'), ['net', 'rope']);
  assert.deepEqual(array('numbers'), Float64Array.of(0.5, 2));
  assert.throws(() => array('other'), /no array other/);
});
