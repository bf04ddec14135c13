// Opens pages of share() for every shipped gear in headless Chromium without a network. Measures
// and drawn tensions must equal R's, initially and after the same moves. A hostile name must not
// run, memory must not grow, and axe-core must pass. GEARS=a,b: only these gears; MOVES=: moves of
// each gear.
'use strict';
const test = require('node:test'), assert = require('node:assert');
const fs = require('fs'), os = require('os'), path = require('path');
const { execFileSync } = require('child_process');
const { launch } = require('./tank');
const share = require('./share-model.js');

const shipped = () => execFileSync('Rscript', ['-e', 'cat(codend::gears()$name, sep = ",")']).toString();
const gears = (process.env.GEARS || shipped() + ',t90_codend_by_volume').split(',');
// ropes; netting with a catch; netting of cells
const thorough = gears.filter((gear) => ['towed_cable', 'stow_net', 't90_codend'].includes(gear));
const moves = Object.fromEntries(gears.map((gear) =>
  [gear, Number(process.env.MOVES || (thorough.includes(gear) ? 10 : 1))]));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'codend-share-'));
let browser;

test.before(async () => {
  execFileSync('Rscript', [path.join(__dirname, 'share.R'), folder, ...gears.map((gear) => `${gear}=${moves[gear]}`)],
    { stdio: 'inherit' });
  browser = await launch('--host-resolver-rules=MAP * ~NOTFOUND');
});
test.after(async () => {
  if (browser) await browser.close();
  fs.rmSync(folder, { recursive: true });
});

async function opened(gear, size) {
  const page = await browser.newPage({ viewport: size || { width: 1200, height: 800 }, deviceScaleFactor: 0.25 });
  page.asked = [];
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) page.asked.push(request.url());
  });
  page.errors = [];
  page.on('pageerror', (error) => page.errors.push(String(error)));
  await page.goto('file://' + path.join(folder, gear + '.html'));
  await page.waitForFunction(() => window.codendShared?.ready || window.codendShared?.failed, null, { timeout: 120000 });
  assert.strictEqual(await page.evaluate(() => window.codendShared.failed), undefined);
  return page;
}
async function moved(page, values) {
  await page.evaluate((to) => window.codendTank.Form.edits(Object.fromEntries(window.codendShared.fields.flatMap(
    ({ paths, unit }, k) => paths.map((path) => [path, { value: to[k], unit }])))), values);
  await page.waitForFunction(() => window.codendShared.settled, null, { timeout: 120000 });
}
// Returns the displayed shape: slider values, measures and the viewer's data.
const shown = (page) => page.evaluate(() => {
  const { told, ropes } = document.getElementById('tank').codendViewer.gear();
  const drawn = {};
  for (const name of ['points', 'rope_tension', 'u', 'v']) drawn[name] = Array.from(told[name].floats);
  return { ...window.codendShared.shown, drawn, lines: ropes.part.length };
});

// Measures that jump when a twine becomes slack, and measures that count pixels.
const ordered = /slack_netting/, counted = /blockage/;

for (const gear of gears) {
  test(`${gear} page shows R's measures and tensions after ${moves[gear]} moves`, async () => {
    assert.ok(fs.statSync(path.join(folder, gear + '.html')).size < 1e6);
    const page = await opened(gear);
    let worst = 0;
    for (const [k, move] of JSON.parse(fs.readFileSync(path.join(folder, gear + '.json'))).entries()) {
      if (k) await moved(page, move.values);
      const found = await shown(page);
      assert.deepStrictEqual(found.values, move.values);
      assert.strictEqual(found.drawn.rope_tension.length, found.lines);
      for (const [name, values] of Object.entries(move.drawn)) {
        const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
        assert.strictEqual(found.drawn[name].length, values.length, name);
        // single-precision floats; null in R is NaN in the page
        const off = values.map((value, at) => value === null ? Number(!isNaN(found.drawn[name][at])) * largest :
          Math.abs(found.drawn[name][at] - value)).reduce((most, value) => Math.max(most, value), 0);
        assert.ok(off <= 1e-5 * largest, `${name}: off by ${off} of ${largest}`);
      }
      for (const [name, value] of Object.entries(move.measures)) {
        if (ordered.test(name)) continue;
        const off = Math.abs(found.measures[name] - value);
        // If rounding in stiff parts leaves more than 1e-11 of the largest tension, measures
        // deviate too.
        const close = move.residual <= 1e-11 && !counted.test(name);
        // small values are compared with 1 or 0.1 of their unit
        const share = off / Math.max(Math.abs(value), close ? 1 : 0.1);
        assert.ok(share < (counted.test(name) ? 1e-2 : close ? 1e-8 : 1e-6), `${name}: ${found.measures[name]}, not ${value}`);
        if (!counted.test(name)) worst = Math.max(worst, share);
      }
    }
    console.log(`# ${gear}: worst ${worst.toExponential(1)}`);
    assert.deepStrictEqual(page.asked, []);
    assert.deepStrictEqual(page.errors, []);
    await page.close();
  });
}

// Moves one slider at a time by 8 % of its range in either direction.
function random_moves(fields, values, count) {
  let seed = 38;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  return Array.from({ length: count }, () => {
    const at = Math.floor(random() * fields.length), field = fields[at];
    const step = (random() < 0.5 ? -0.08 : 0.08) * (field.upper - field.lower);
    const to = Math.min(Math.max(values[at] + step, field.lower), field.upper);
    values[at] = field.whole ? Math.round(to) : to;
    return values.slice();
  });
}

for (const gear of thorough) {
  test(`${gear} model solves 1000 moves with constant memory`, async () => {
    const of = await share.opened(path.join(folder, gear + '.html'));
    let early = 0;
    random_moves(of.page.fields, of.model.values(), 1000).forEach((values, k) => {
      assert.ok(of.move(values), `move ${k} to ${values}`);
      of.model.shape();
      if (k === 200) early = of.model.memory();
    });
    assert.strictEqual(of.model.memory(), early);
  });
}

if (gears.includes('t90_codend_by_volume')) test('a move to more than the netting holds leaves the gear as it was', async () => {
  const of = await share.opened(path.join(folder, 't90_codend_by_volume.html'));
  const before = of.model.shape(), volume = of.page.fields.findIndex((field) => field.paths[0] === 'catch.volume');
  const full = of.model.values();
  full[volume] = of.page.fields[volume].upper;
  assert.strictEqual(of.move(full), false);
  const settled = of.model.values()[volume];
  assert.ok(settled < full[volume]);
  const back = of.model.values();
  back[volume] = of.page.fields[volume].value;
  assert.ok(of.move(back));
  for (const [name, value] of Object.entries(before.measures)) {
    assert.ok(Math.abs(of.model.shape().measures[name] - value) <= 1e-5 * Math.max(Math.abs(value), 1), name);
  }
});

if (gears.includes('towed_cable')) test('a name that is a script runs nothing', async () => {
  const page = await opened('towed_cable');
  assert.match(await page.textContent('h1'), /<\/script><script>/);
  assert.strictEqual(await page.evaluate(() => window.hurt), undefined);
  await page.waitForSelector('#drawing svg');
  await page.click('#tab_Tow');
  await page.click('#tow_start');
  await page.waitForSelector('.tow-view .view-time');
  assert.strictEqual(await page.evaluate(() => window.hurt), undefined);
  assert.deepStrictEqual(page.errors, []);
  await page.close();
});

test('shared page drops overtaken moves and shows the last one\'s result', async () => {
  const page = await opened(gears[0]);
  const found = await page.evaluate(async () => {
    const input = document.querySelector('#quick [type=range]');
    for (let k = 0; k < 40; k++) {
      input.value = Number(input.min) + (k % 2) * (input.max - input.min);
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }
    const last = Number(input.value);
    await new Promise((resolve) => {
      const wait = setInterval(() => { if (window.codendTank.Form.still()) { clearInterval(wait); resolve(); } }, 20);
    });
    return { last, settled: window.codendShared.shown.values[0], moves: window.codendShared.times.moves };
  });
  assert.ok(Math.abs(found.settled - found.last) < 1e-9 * found.last);
  assert.ok(found.moves < 5, `${found.moves} of 40 moves were settled`);
  await page.close();
});

for (const gear of thorough) {
  for (const size of [{ width: 1400, height: 900 }, { width: 390, height: 844 }]) {
    test(`${gear} page passes axe-core at ${size.width} pixels`, async () => {
      const page = await opened(gear, size);
      await page.evaluate(() => document.querySelectorAll('details').forEach((d) => { d.open = true; }));
      await page.evaluate(fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8'));
      const found = await page.evaluate(() => window.axe.run({ preload: false }));
      assert.deepStrictEqual(found.violations.map((v) => v.id + ': ' + v.nodes.map((n) => n.html.slice(0, 120)).join(' | ')), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= size.width);
      await page.close();
    });
  }
}
