import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decimals_of, error_digits, figures, fixed_decimals, signed } from '../src/numbers';

test('figures() and error_digits() write numbers like R', () => {
  assert.deepEqual([0, 12345.6, -0.01234, 1e-9, NaN].map(figures), ['0', '12\u202f346', '\u22120.0123', '0', 'none']);
  assert.deepEqual([0.123, 0.35, 12, 0].map(error_digits), ['0.13', '0.4', '12', '']);
});

test('signed() and fixed_decimals() write tables like R', () => {
  const signs = [[1.26, 1], [-0.04, 1], [0.04, 2], [NaN, 1], [-12345.6, 0]].map(([x, n]) => signed(x, n));
  assert.deepEqual(signs, ['+1.3', '0', '+0.04', '', '\u221212\u202f346']);
  assert.deepEqual([-2e-8, 4e-5, 0, -6e-5, NaN].map((x) => fixed_decimals(x, 4)), ['0', '0', '0', '-0.0001', '']);
});

test('decimals_of() keeps four digits of the largest value', () => {
  assert.deepEqual([[153.91, 2], [0.08823], [11443], [0], []].map((values) => decimals_of(...values)), [1, 4, 0, 0, 0]);
});
