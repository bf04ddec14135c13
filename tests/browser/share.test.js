// Pages of share() in headless Chromium without a network: their measures are R's after the same moves,
// a hostile name runs nothing, memory stays flat, and axe-core finds nothing. Skipped where codend has no
// engine for pages (make wasm).
'use strict';
const test = require('node:test'), assert = require('node:assert');
const fs = require('fs'), os = require('os'), path = require('path');
const { execFileSync } = require('child_process');
const { chromium } = require('playwright-core');
const share = require('./share-model.js');

const gears = (process.env.GEARS || 'towed_cable,stow_net,t90_codend').split(',');
const moves = Number(process.env.MOVES || 10);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'codend-share-'));
const made = execFileSync('Rscript', ['-e', 'cat(codend:::can_share())']).toString() === 'TRUE';
const skip = made ? false : 'the engine for pages is not made';
let browser;

test.before(async () => {
  if (!made) return;
  execFileSync('Rscript', [path.join(__dirname, 'share.R'), folder, String(moves), ...gears], { stdio: 'inherit' });
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--disable-background-networking', '--host-resolver-rules=MAP * ~NOTFOUND']
  });
});
test.after(async () => {
  if (browser) await browser.close();
  fs.rmSync(folder, { recursive: true });
});

async function opened(gear, size) {
  const page = await browser.newPage({ viewport: size || { width: 1200, height: 800 } });
  page.asked = [];
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) page.asked.push(request.url());
  });
  page.errors = [];
  page.on('pageerror', (error) => page.errors.push(String(error)));
  await page.goto('file://' + path.join(folder, gear + '.html'));
  await page.waitForFunction(() => window.codendReady || window.codendFailed, null, { timeout: 120000 });
  assert.strictEqual(await page.evaluate(() => window.codendFailed), undefined);
  return page;
}
async function moved(page, values) {
  await page.evaluate((to) => window.codendMove(to), values);
  await page.waitForFunction(() => window.codendSettled, null, { timeout: 120000 });
  return page.evaluate(() => ({
    measures: window.codendShown.measures, values: window.codendShown.values
  }));
}

// What turns on whether a twine is just slack, and what is counted by cells of a picture.
const ordered = /slack_netting/, counted = /blockage/;

for (const gear of gears) {
  test(`${gear}: measures after ${moves} moves are R's`, { skip }, async () => {
    assert.ok(fs.statSync(path.join(folder, gear + '.html')).size < 1e6);
    const page = await opened(gear);
    const sizes = await page.evaluate(() => window.codendSizes);
    let worst = 0;
    for (const move of JSON.parse(fs.readFileSync(path.join(folder, gear + '.json')))) {
      const found = await moved(page, move.values);
      assert.deepStrictEqual(found.values, move.values);
      for (const [name, value] of Object.entries(move.measures)) {
        if (ordered.test(name)) continue;
        const off = Math.abs(found.measures[name] / sizes[name] - value);
        // where rounding of stiff parts leaves more than 1e-11 of the largest tension, measures follow it
        const close = move.residual <= 1e-11 && !counted.test(name);
        // what is small is held to shares of its unit, or of a tenth of it
        const share = off / Math.max(Math.abs(value), close ? 1 : 0.1);
        assert.ok(share < (counted.test(name) ? 1e-2 : close ? 1e-8 : 1e-6), `${name}: ${found.measures[name] / sizes[name]}, not ${value}`);
        if (!counted.test(name)) worst = Math.max(worst, share);
      }
    }
    console.log(`# ${gear}: worst ${worst.toExponential(1)}`);
    assert.deepStrictEqual(page.asked, []);
    assert.deepStrictEqual(page.errors, []);
    await page.close();
  });
}

// One slider at a time, 8 % of its range this way or that.
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

for (const gear of gears) {
  test(`${gear}: none of 1000 moves fails, and memory stays flat`, { skip }, async () => {
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

const hostile = skip || (gears.includes('towed_cable') ? false : 'the cable has that name');
test('a name that is a script runs nothing', { skip: hostile }, async () => {
  const page = await opened('towed_cable');
  assert.match(await page.textContent('h1'), /<\/script><script>/);
  assert.strictEqual(await page.evaluate(() => window.hurt), undefined);
  await page.click('#drawing summary');
  await page.waitForSelector('#drawing img');
  await page.click('#tow');
  await page.waitForFunction(() => document.querySelector('.view-time'));
  await page.click('#tow');
  assert.strictEqual(await page.evaluate(() => window.hurt), undefined);
  assert.deepStrictEqual(page.errors, []);
  await page.close();
});

test('moves that are overtaken are dropped, and what is told last holds', { skip }, async () => {
  const page = await opened(gears[0]);
  const found = await page.evaluate(async () => {
    const inputs = Array.from(document.querySelectorAll('#sliders input'));
    for (let k = 0; k < 40; k++) {
      inputs[0].value = Number(inputs[0].min) + (k % 2) * (inputs[0].max - inputs[0].min);
      inputs[0].dispatchEvent(new Event('input'));
    }
    const last = Number(inputs[0].value);
    await new Promise((resolve) => {
      const wait = setInterval(() => { if (window.codendSettled) { clearInterval(wait); resolve(); } }, 20);
    });
    return { last, settled: window.codendShown.values[0], moves: window.codendTimes.moves };
  });
  assert.ok(Math.abs(found.settled - found.last) < 1e-9 * found.last);
  assert.ok(found.moves < 5, `${found.moves} of 40 moves were settled`);
  await page.close();
});

for (const gear of gears) {
  for (const size of [{ width: 1400, height: 900 }, { width: 390, height: 844 }]) {
    test(`${gear}: axe-core finds nothing at ${size.width} pixels`, { skip }, async () => {
      const page = await opened(gear, size);
      await page.evaluate(() => document.querySelectorAll('details').forEach((d) => { d.open = true; }));
      await page.evaluate(fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8'));
      const found = await page.evaluate(() => window.axe.run());
      assert.deepStrictEqual(found.violations.map((v) => v.id + ': ' + v.nodes.map((n) => n.html.slice(0, 120)).join(' | ')), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= size.width);
      await page.close();
    });
  }
}
