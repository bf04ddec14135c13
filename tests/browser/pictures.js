// Writes the tank's pictures, gallery/tank/*.webp: node pictures.js [name...]. Run it after page
// changes.
'use strict';
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { serve, launch, visit, control, measure, tab } = require('./tank');

const root = path.join(__dirname, '..', '..');
const desk = { width: 1440, height: 900 }, phone = { width: 390, height: 844 };
const patience = { timeout: 120000 };

async function still(page) {
  await page.waitForSelector('.measures td', { state: 'attached', ...patience });
  await page.waitForFunction(() => !window.codendTank.Talk.waits() &&
    !window.codendTank.Tank.waits(), null, patience);
  if (await page.isVisible('#drawing')) await page.waitForSelector('#drawing svg', patience);
  await page.waitForTimeout(2500);
}

async function gear(page, name) {
  await page.click(`[data-gear="${name}"]`);
  await still(page);
}

async function set(page, field, value) {
  const drag = (await measure(page, 'total drag'))[0];
  await control(page, field).locator('.number').fill(value);
  await page.waitForFunction((drag) =>
    [...document.querySelectorAll('.measures tbody tr')].some((row) =>
    /^total drag/.test(row.cells[0].textContent) && row.cells[1].textContent !== drag), drag,
      patience);
  await still(page);
}

// Actions before each picture; a returned element replaces the page in the picture.
const scenes = {
  gallery: (page) => page.waitForLoadState('networkidle'),
  async unfinished(page) {
    await page.setInputFiles('.plan-file >> nth=0',
      path.join(root, 'inst', 'extdata', 'survey_trawl.yaml'));
    await still(page);
    await page.click('#see_drawing');
    const deep = page.locator('#drawing [data-path="wings.upper.meshes.deep"]').first();
    await deep.waitFor({ state: 'attached', ...patience });
    await deep.dispatchEvent('click');
    await page.fill('#drawing .typed input', '60');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#unfinished', { state: 'visible', ...patience });
    await page.waitForSelector('#drawing .wrong', { state: 'attached', ...patience });
    await page.click('#drawing_all');
    await page.waitForTimeout(1000);
  },
  async designs(page) {
    await gear(page, 'midwater_trawl');
    await set(page, 'towing.speed', '5');
    await page.click('#keep');
    await set(page, 'warps.length', '800');
    await page.click('button:has-text("Side by side")');
    await still(page);
  },
  async vary(page) {
    await gear(page, 'midwater_trawl');
    await tab(page, 'Vary');
    await page.click('#vary_start');
    await page.waitForFunction(() => /^(\d+) of \1 values$/.test(
      document.getElementById('vary_said').textContent), null, patience);
    const graph = page.locator('#varied svg').first();
    await graph.scrollIntoViewIfNeeded();
    const place = await graph.boundingBox();
    await page.mouse.move(place.x + place.width / 2, place.y + place.height / 2);
  },
  async catalogue(page) {
    await gear(page, 'poly_noreastern_trawl');
    await page.evaluate(() => window.codendTank.Form.open('otter_boards'));
    await page.locator('.pick').first().click();
    await page.locator('.pick-list').first().scrollIntoViewIfNeeded();
    await page.waitForTimeout(1000);
  },
  phone: (page) => gear(page, 'midwater_trawl'),
  async report(page) {
    await gear(page, 'midwater_trawl');
    await tab(page, 'Save');
    const [saved] = await Promise.all([page.waitForEvent('download', patience),
      page.click('#save_report')]);
    const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'report-')), 'report.html');
    await saved.saveAs(file);
    await page.goto('file://' + file);
    await page.waitForTimeout(3000);
  },
  bottom_trawl: (page) => gear(page, 'poly_noreastern_trawl'),
  purse_seine: (page) => gear(page, 'purse_seine'),
  stow_net: (page) => gear(page, 'stow_net'),
  gillnet: (page) => gear(page, 'gillnet'),
  cage: (page) => gear(page, 'cage')
};

// Converts PNG to WebP in the browser.
const webp = (page, png) => page.evaluate(async (bytes) => {
  const picture = await createImageBitmap(await (await fetch('data:image/png;base64,' + bytes))
    .blob());
  const copy = new OffscreenCanvas(picture.width, picture.height);
  copy.getContext('2d').drawImage(picture, 0, 0);
  const made = await copy.convertToBlob({ type: 'image/webp', quality: 0.85 });
  return Array.from(new Uint8Array(await made.arrayBuffer()));
}, png.toString('base64'));

(async () => {
  const [tank, browser] = await Promise.all([serve(), launch()]);
  const writer = await browser.newPage();
  const asked = process.argv.slice(2);
  const all = [...Object.keys(scenes), 'phone_dark', 'bottom_trawl_dark'];
  for (const name of asked.length ? asked : all) {
    const [scene, dark] = name.split('_dark');
    const page = await visit(browser, tank.url, scene === 'phone' ? phone : desk);
    if (dark !== undefined) await page.emulateMedia({ colorScheme: 'dark' });
    await page.waitForSelector('.gear-card', { state: 'visible', ...patience });
    await scenes[scene](page);
    const made = await webp(writer, await page.screenshot());
    fs.writeFileSync(path.join(root, 'gallery', 'tank', `${name}.webp`), Buffer.from(made));
    console.log(name, ...page.problems);
    await page.close();
  }
  await browser.close();
  tank.stop();
})();
