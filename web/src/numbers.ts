// Numbers of pages as strings, as R writes them.

// Returns four significant digits, and at most four decimals, like figures() in R.
export function figures(x: number): string {
  return isFinite(x) ? fixed_decimals(x, decimals_of(x)).replace('-', '\u2212') : 'none';
}

// Returns an error, rounded up to one or two digits, like error_text() in R.
export function error_digits(error: number): string {
  if (!(error > 0)) return '';
  const size = Math.floor(Math.log10(error)), unit = Math.pow(10, error < 2 * Math.pow(10, size) ? size - 1 : size);
  const up = Math.max(Math.ceil(error / unit * (1 - 1e-9)) * unit, 1e-4);
  return up.toFixed(Math.min(Math.max(-Math.round(Math.log10(unit)), 0), 4));
}

// Returns the decimals that give four digits of the largest value, but at most four.
export function decimals_of(...values: number[]): number {
  const largest = Number(Math.max(0, ...values.map(Math.abs)).toPrecision(4));
  return largest ? Math.min(Math.max(3 - Math.floor(Math.log10(Math.max(largest, 1e-3))), 0), 4) : 0;
}

// Returns a number with separated thousands, and "0" if all decimals are 0.
export function fixed_decimals(x: number, decimals: number): string {
  if (!isFinite(x)) return '';
  const text = x.toFixed(decimals);
  if (!/[1-9]/.test(text)) return '0';
  const parts = text.split('.');
  if (Math.abs(x) >= 1e4) parts[0] = parts[0].replace(/\B(?=(\d{3})+$)/g, '\u202f');
  return parts.join('.');
}

// Returns a difference such as "+3.2", and "0" if all decimals are 0.
export function signed(x: number, decimals: number): string {
  const text = fixed_decimals(Math.abs(x), decimals);
  return text && text !== '0' ? (x < 0 ? '\u2212' : '+') + text : text;
}
