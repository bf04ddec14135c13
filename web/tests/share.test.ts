import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { array_reader } from '../src/share/arrays';
import { unpacker } from '../src/share/packed';

test('unpacker() inflates JSON once', async () => {
  const { json, text } = unpacker({ model: deflateSync('{"name": "M\u00f8re"}').toString('base64') });
  assert.deepEqual(await json('model'), { name: 'M\u00f8re' });
  await assert.rejects(text('model'));
});

test('array_reader() reads differences and distinct strings', () => {
  const parts = [Int32Array.of(5, -2, 1), Int32Array.of(1, -1), Float64Array.of(0.5, 2)];
  const array = array_reader({
    whole: ['i', 3, 0, []], words: ['w', 2, 12, ['rope', 'net']], numbers: ['d', 2, 20, []]
  }, Uint8Array.from(parts.flatMap((one) => [...new Uint8Array(one.buffer)])));
  assert.deepEqual(array('whole'), Int32Array.of(5, 3, 4));
  assert.deepEqual(array('words'), ['net', 'rope']);
  assert.deepEqual(array('numbers'), Float64Array.of(0.5, 2));
  assert.throws(() => array('other'), /no array other/);
});
