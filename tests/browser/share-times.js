// Times a shared page in headless Chromium: first picture, first result, moves of 5 % of a slider's
// range, jumps from end to end, and the longest time without response.
//
//   node share-times.js RATE PAGE.html...
// The browser slows the page's own thread RATE times, but not its worker. So times of the worker
// (all except the picture and the stall) are reported as measured and times RATE.
'use strict';
const path = require('path');
const { launch } = require('./tank');

const rate = Number(process.argv[2]), files = process.argv.slice(3);
const sorted = (list) => list.slice().sort((a, b) => a - b);
const middle = (list) => sorted(list)[list.length >> 1];

async function timed(browser, file) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 800 } });
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate });
  await page.goto('file://' + path.resolve(file), { waitUntil: 'commit' });
  await page.waitForFunction(() => window.codendShared?.ready || window.codendShared?.failed, null, { timeout: 120000 });
  const found = await page.evaluate(async () => {
    const { fields } = window.codendShared;
    let seed = 38;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    let stall = 0, before = performance.now();
    const beat = setInterval(() => {
      stall = Math.max(stall, performance.now() - before);
      before = performance.now();
    }, 4);
    async function move(values) {
      const began = performance.now();
      window.codendTank.Form.edits(Object.fromEntries(fields.flatMap(({ paths, unit }, k) =>
        paths.map((path) => [path, { value: values[k], unit }]))));
      while (!window.codendTank.Form.still()) await new Promise((go) => setTimeout(go, 2));
      return performance.now() - began;
    }
    const own = fields.map((field) => field.value), moves = [], jumps = [];
    for (let k = 0; k < 40; k++) {
      const at = Math.floor(random() * fields.length), field = fields[at], values = own.slice();
      values[at] += (values[at] + 0.05 * (field.upper - field.lower) > field.upper ? -0.05 : 0.05) *
        (field.upper - field.lower);
      moves.push(await move(values));
      moves.push(await move(own));
    }
    for (let at = 0; at < fields.length; at++) {
      for (const end of ['lower', 'upper']) {
        const values = own.slice();
        values[at] = fields[at][end];
        jumps.push(await move(values));
      }
    }
    for (let k = 0; k < 6; k++) {
      jumps.push(await move(fields.map((field) => random() < 0.5 ? field.lower : field.upper)));
    }
    clearInterval(beat);
    return { moves, jumps, stall, picture: window.codendShared.times.picture, first: window.codendShared.times.first,
      stuck: window.codendShared.times.stuck };
  });
  await page.close();
  return found;
}

(async () => {
  const browser = await launch();
  await timed(browser, files[0]); // the browser starts
  console.log('ms: page | picture | first answer | move median, worst | jump median, worst | stall | stuck');
  for (const file of files) {
    const of = await timed(browser, file);
    const ms = (list) => `${middle(list).toFixed(0)}, ${Math.max(...list).toFixed(0)}`;
    console.log(`${path.basename(file, '.html')} | ${of.picture.toFixed(0)} | ${of.first.toFixed(0)} | ` +
      `${ms(of.moves)} | ${ms(of.jumps)} | ${of.stall.toFixed(0)} | ${of.stuck}`);
  }
  await browser.close();
})();
