// Reopens pictures and videos that pages save: PNG by its header, WebM by its EBML elements.
'use strict';
const test = require('node:test');
const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { execFileSync } = require('node:child_process');
const axe = require('axe-core');
const { launch } = require('./tank');
const { faint } = require('./sight');

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'save-'));
const write = (kind, gear) => execFileSync('Rscript', [path.join(__dirname, 'view.R'), folder, kind, gear]);
let browser;
test.before(async () => {
  write('300', 'poly_noreastern_trawl');
  write('tow', 'towed_cable');
  browser = await launch();
});
test.after(async () => {
  await browser.close();
  fs.rmSync(folder, { recursive: true });
});

async function open(gear, size) {
  const page = await browser.newPage({ viewport: size });
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(error.message));
  page.on('console', (message) => { if (message.type() === 'error') page.problems.push(message.text()); });
  await page.goto('file://' + path.join(folder, gear + '.html'));
  await page.waitForFunction(() => {
    const view = document.querySelector('.codend-view');
    return view && view.codendViewer && view.codendViewer.painted() && !view.codendViewer.waits();
  });
  return page;
}
const saved = async (page, button) => {
  const [file] = await Promise.all([page.waitForEvent('download', { timeout: 120000 }), page.click(button)]);
  return { name: file.suggestedFilename(), bytes: fs.readFileSync(await file.path()) };
};

// Reads EBML elements (RFC 8794): calls found(id, bytes) for each and enters container elements.
function elements(bytes, found, at = 0, end = bytes.length) {
  const holders = new Set([0x18538067, 0x1F43B675, 0x1654AE6B, 0xAE, 0xE0, 0xA0, 0x1A45DFA3]);
  const number = (keep) => {
    let length = 1;
    while (length < 9 && !(bytes[at] & (0x80 >> (length - 1)))) length++;
    let value = keep ? bytes[at] : bytes[at] & (0xFF >> length);
    let open = !keep && value === (0xFF >> length);
    for (let k = 1; k < length; k++) {
      open = open && bytes[at + k] === 0xFF;
      value = value * 256 + bytes[at + k];
    }
    at += length;
    return open ? Infinity : value;
  };
  while (at < end) {
    const id = number(true), size = Math.min(number(false), end - at);
    found(id, bytes.subarray(at, at + size));
    // an element of unknown size ends at the end of its parent
    if (holders.has(id)) elements(bytes, found, at, at + size);
    at += size;
  }
}
function film(bytes) {
  const told = { frames: 0 };
  elements(bytes, (id, of) => {
    if (id === 0x4282) told.kind = of.toString('latin1');
    if (id === 0xB0) told.width = of.readUIntBE(0, of.length);
    if (id === 0xBA) told.height = of.readUIntBE(0, of.length);
    if (id === 0xA3 || id === 0xA1) told.frames += 1;
  });
  return told;
}

test('picture has 3,840 pixels along its longer side and optionally a legend', async () => {
  const page = await open('poly_noreastern_trawl', { width: 1200, height: 800 });
  await page.click('text="Save"');
  const worded = await saved(page, 'text="Picture (PNG)"');
  assert.equal(worded.name, 'poly-nor-eastern-survey-bottom-trawl.png');
  assert.equal(worded.bytes.subarray(1, 4).toString(), 'PNG');
  assert.deepEqual([worded.bytes.readUInt32BE(16), worded.bytes.readUInt32BE(20)], [3840, 2560]);
  await page.uncheck('text="with title and legend"');
  const bare = await saved(page, 'text="Picture (PNG)"');
  assert.equal(bare.bytes.readUInt32BE(16), 3840);
  // the title's corner is white with letters, or water
  const corner = (bytes) => page.evaluate(async (text) => {
    const picture = await createImageBitmap(await (await fetch('data:image/png;base64,' + text)).blob());
    const copy = new OffscreenCanvas(600, 100);
    copy.getContext('2d').drawImage(picture, 0, 0);
    const all = copy.getContext('2d').getImageData(40, 30, 560, 60).data, seen = new Set();
    let low = 255, high = 0;
    for (let k = 0; k < all.length; k += 4) {
      low = Math.min(low, all[k]);
      high = Math.max(high, all[k]);
      seen.add(all[k + 3]);
    }
    return { low, high, opaque: seen.size === 1 && seen.has(255) };
  }, bytes.toString('base64'));
  const withWords = await corner(worded.bytes), without = await corner(bare.bytes);
  assert.ok(withWords.low < 60 && withWords.high > 230, JSON.stringify(withWords));
  assert.ok(without.low > 120 && without.opaque, JSON.stringify(without));
  // the same picture each time
  const again = await saved(page, 'text="Picture (PNG)"');
  assert.ok(again.bytes.equals(bare.bytes));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('turn saves a video and restores the camera', async () => {
  const page = await open('poly_noreastern_trawl', { width: 640, height: 400 });
  const before = await page.evaluate(() => document.querySelector('.codend-view').codendViewer.picture().toDataURL());
  const text = await page.evaluate(async () => {
    const made = await document.querySelector('.codend-view').codendViewer.film('turn', 3, 640, true);
    const bytes = new Uint8Array(await made.arrayBuffer());
    let all = '';
    for (const byte of bytes) all += String.fromCharCode(byte);
    return btoa(all);
  });
  const told = film(Buffer.from(text, 'base64'));
  assert.equal(told.kind, 'webm');
  assert.deepEqual([told.width, told.height], [640, 400]);
  assert.ok(told.frames >= 5, JSON.stringify(told));
  assert.equal(await page.evaluate(() => document.querySelector('.codend-view').codendViewer.picture().toDataURL()),
    before);
  await page.close();
});

test('tow saves a video of the whole tow', async () => {
  const page = await open('towed_cable', { width: 390, height: 844 });
  await page.click('text="Save"');
  const made = await saved(page, 'text="Video of the tow (WebM)"');
  assert.match(made.name, /\.webm$/);
  const told = film(made.bytes);
  assert.equal(told.kind, 'webm');
  assert.equal(told.height, 1920);
  assert.ok(told.frames >= 5, JSON.stringify(told));
  // it ends at the last time step
  assert.equal(await page.inputValue('.view-time input'), '10');
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('save panel passes axe-core and contrast checks on both screens', async () => {
  for (const size of [{ width: 1200, height: 800 }, { width: 390, height: 844 }]) {
    const page = await open('poly_noreastern_trawl', size);
    await page.click('text="Save"');
    await page.evaluate(axe.source);
    const found = await page.evaluate(() => window.axe.run(document, { preload: false }));
    assert.deepEqual(found.violations.map((one) => one.id), []);
    assert.deepEqual((await page.evaluate(faint)).found, []);
    const box = await page.locator('.view-save').boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= size.width && box.y + box.height <= size.height);
    await page.close();
  }
});
