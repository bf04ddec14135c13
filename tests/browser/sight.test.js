// Checks visibility: the gear next to labels and buttons, and contrast. Run by `make browser-test`.
'use strict';
const { test, before, after } = require('node:test');
const assert = require('node:assert/strict');
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { serve, launch, visit, open, tab } = require('./tank');
const { faint } = require('./sight');

const command = process.env.CODEND || path.join(__dirname, '..', '..', 'exec', 'codend');
const sizes = [{ width: 1440, height: 900 }, { width: 390, height: 844 }];
const patience = { timeout: 60000 };
let tank, browser, folder;
before(async () => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), 'sight-'));
  [tank, browser] = await Promise.all([serve(), launch()]);
});
after(async () => {
  await browser?.close();
  tank?.stop();
  fs.rmSync(folder, { recursive: true, force: true });
});

// Returns the drawn extent in an element's viewer and the overlays over it, in pixels of the
// element.
const looked = (page, host) => page.evaluate((host) => {
  const element = document.querySelector(host), frame = element.getBoundingClientRect();
  const over = [...element.querySelectorAll(
    '.view-title, .view-bar, .view-legend, .view-scale, .view-time')]
    .map((e) => [e.className, e.getBoundingClientRect()])
      .filter(([, box]) => box.width && box.height)
    .map(([name, box]) => [name, box.left - frame.left, box.top - frame.top, box.right - frame.left,
      box.bottom - frame.top]);
  return { reach: element.codendViewer.reach(), width: frame.width, height: frame.height, over };
}, host);
const in_sight = ({ reach, width, height, over }, told) => {
  assert.ok(reach[0] >= 0 && reach[1] >= 0 && reach[2] <= width && reach[3] <= height,
    `${told}: ${reach} leaves ${width} x ${height}`);
  for (const [name, left, top, right, bottom] of over) {
    assert.ok(reach[2] <= left || reach[0] >= right || reach[3] <= top || reach[1] >= bottom,
      `${told}: ${reach} under ${name} ${[left, top, right, bottom]}`);
  }
  // and large enough
  assert.ok((reach[2] - reach[0]) > 0.5 * width || (reach[3] - reach[1]) > 0.4 * height,
    `${told}: ${reach} in ${width} x ${height}`);
};

const begin = async (page, gear) => {
  const card = page.locator(`[data-gear="${gear}"]`);
  await card.waitFor(patience);
  const title = await card.locator('.card-title').textContent();
  await card.click();
  await page.waitForFunction((t) => document.querySelector('h1').textContent === t &&
    document.getElementById('gallery').hidden && window.codendTank.Tank.shown() &&
      !window.codendTank.Tank.waits(),
  title.trim(), patience);
  await page.waitForSelector('.measures td', { state: 'attached', ...patience });
};

// A beam trawl has its shoes ahead of its net, a purse seine is tall, a trawl long.
for (const gear of ['beam_trawl', 'purse_seine', 'poly_noreastern_trawl']) {
  test(`${gear} is visible next to labels and buttons in tank and pages`, async () => {
    const report = path.join(folder, `${gear}.html`);
    execFileSync(command, ['report', gear, '--out', report], { stdio: 'ignore' });
    for (const size of sizes) {
      const page = await visit(browser, tank.url, size);
      await begin(page, gear);
      in_sight(await looked(page, '#tank'), `tank ${size.width}`);
      await page.goto(`file://${report}`);
      await page.waitForFunction(() =>
        document.querySelector('.codend-view')?.codendViewer?.painted(), null,
        patience);
      in_sight(await looked(page, '.codend-view'), `report ${size.width}`);
      await page.close();
    }
  });
}

test('tank and report show text at contrast 4.5 and lines at 3', async () => {
  const report = path.join(folder, 'report.html');
  execFileSync(command, ['report', 'beam_trawl', '--out', report], { stdio: 'ignore' });
  for (const size of sizes) {
    const page = await visit(browser, tank.url, size);
    // the phone has dark colours
    await page.emulateMedia({ colorScheme: size.width < 500 ? 'dark' : 'light' });
    const stands_out = async (told, least) => {
      const { asked, found } = await page.evaluate(faint);
      assert.deepEqual(found, [], `${told} ${size.width}`);
      assert.ok(asked >= least, `${told} ${size.width}: asked of ${asked} only`);
    };
    await page.locator('[data-gear="beam_trawl"]').waitFor(patience);
    await stands_out('gallery', 40);
    await begin(page, 'beam_trawl');
    // a phone shows one of three sheets
    const phone = size.width < 500, least = phone ? 20 : 80;
    await stands_out('tank', least);
    for (const name of ['Tensions', 'Drag', 'Slopes', 'Tow', 'Designs', 'Changes', 'Plan', 'R code',
      'Save']) {
      await tab(page, name);
      await stands_out(name, least);
    }
    await page.click('#see_drawing');
    await page.waitForSelector('#drawing svg', patience);
    await stands_out('Drawing', 300);
    await page.click('#see_tank');
    if (phone) await page.click('.sheet[data-sheet="net"]');
    await page.click('.group > summary:has-text("Netting")');
    await page.click('.part > summary:has-text("Square")');
    await page.waitForSelector('.part .control', patience);
    await stands_out('fields', phone ? 40 : 120);
    await page.goto(`file://${report}`);
    await page.waitForFunction(() =>
      document.querySelector('.codend-view')?.codendViewer?.painted(), null,
      patience);
    await stands_out('report', 300);
    await page.close();
  }
});

test('contrast check reports each item with too little contrast', async () => {
  const page = await browser.newPage();
  await page.setContent(`<body style="background: #fff">
    <p style="color: #777">grey on white, 4.48</p><p style="color: #767676">a little darker,
      4.54</p>
    <div style="background: linear-gradient(#fff, #888)">
      <p style="color: #555">over a gradient</p></div>
    <button disabled style="color: #ccc">asleep</button>
    <input style="border: 1px solid #ddd; background: #fff" value="edge">
    <svg width="100" height="20"><path d="M0 10 H90" stroke="#aaa"></path>
      <text x="0" y="15" fill="#111">in</text></svg>
  </body>`);
  const { found } = await page.evaluate(faint);
  assert.deepEqual(found.map((one) => one.replace(/ [0-9.]+:.*/, '')),
    ['words p', 'words p', 'edge input', 'line path']);
  assert.match(found[0], /4\.48: grey/);
  assert.match(found[1], /over a gradient/);
  await page.close();
});
