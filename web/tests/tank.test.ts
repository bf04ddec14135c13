import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';

// The modules attach handlers to the page when they load.
const addEventListener = () => {}, $ = () => ({ on: () => {}, trigger: () => {} });
Object.assign(globalThis, { window: globalThis, document: { addEventListener }, $, addEventListener });

test('line_of() finds the line of a path, or of its deepest known parent', async () => {
  const { line_of } = await import('../src/tank/files');
  const plan = 'name: net\nropes:\n  warp:\n    length: 3 m\n  sweep: {length: 4 m}\n';
  const line = (path: string) => plan.slice(0, line_of(plan, path)).split('\n').length;
  const paths = ['name', 'ropes.warp.length', 'ropes.sweep.length', 'ropes.bridle', 'ropes[1].warp'];
  assert.deepEqual(paths.map(line), [1, 4, 5, 2, 3]);
});

test('pack() and unpack() keep the designs of an address', async () => {
  const { pack, unpack } = await import('../src/tank/designs');
  const words = { now: { plan: 'name: M\u00f8re' }, kept: [], units: { length: 'm' } };
  assert.deepEqual(unpack(pack(words)), words);
  assert.match(pack(words), /^[A-Za-z0-9_-]+$/);
});

test('unpack() rejects a text that expands to more than 2 MB', async () => {
  const { unpack } = await import('../src/tank/designs');
  const packed = deflateRawSync(JSON.stringify('x'.repeat(3e6))).toString('base64url');
  assert.ok(packed.length < 1e4);
  assert.throws(() => unpack(packed), SyntaxError);
});

test('ticks() returns round numbers', async () => {
  const { ticks } = await import('../src/view/graph');
  assert.deepEqual(ticks(0.3, 2.2, 4), [0.5, 1, 1.5, 2]);
  assert.deepEqual(ticks(-1, 1, 2), [-1, 0, 1]);
});

test('with_edits() replaces earlier values of a field and keeps the order of other changes', async () => {
  const { with_edits } = await import('../src/tank/history');
  const value = (x: number) => ({ value: x, unit: 'm' });
  const one = with_edits({ base: 'cage' }, { a: value(1), b: value(2) });
  const two = with_edits(one, { a: value(3) });
  assert.deepEqual(two, { base: 'cage', edits: [{ b: value(2), a: value(3) }] });
  assert.deepEqual(Object.keys(two.edits?.[0] ?? {}), ['b', 'a']);
  const three = with_edits(with_edits(two, { c: { like: 'a' } }), { a: value(4) });
  assert.deepEqual(three.edits, [{ b: value(2), a: value(3) }, { c: { like: 'a' } }, { a: value(4) }]);
  assert.deepEqual(one.edits, [{ a: value(1), b: value(2) }]);
});

test('labels of measures and fields are translated', async () => {
  const { say_field_of, say_measure, say_path, set_words } = await import('../src/tank/words');
  set_words({ sought: {}, words: {
    'measure.door_spread': '\u00e9cartement', 'measure.hook_#_depth': 'profondeur de l\u2019hame\u00e7on #',
    'field.otter_boards': 'panneaux', 'usual.warps.length': 'Fune fil\u00e9e'
  } });
  assert.deepEqual(['port door spread (m)', 'stern trawl door spread', 'hook 3 depth', 'odd'].map(say_measure),
    ['port: \u00e9cartement (m)', 'stern: trawl: \u00e9cartement', 'profondeur de l\u2019hame\u00e7on 3', 'odd']);
  assert.deepEqual(['otter_boards.lift_coefficient', 'warps.length', 'name'].map(say_path),
    ['Panneaux: lift coefficient', 'Fune fil\u00e9e', 'Name']);
  assert.equal(say_field_of('sections.body', 'sections.body.twine.diameter'), 'Twine: diameter');
});
