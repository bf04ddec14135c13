// The gallery's pictures, inst/app/gears/*.jpg: node gallery.js [gear...]. Run after a gear or the way
// that it is drawn has changed.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const { serve, launch } = require('./tank');

const folder = path.join(__dirname, '..', '..', 'inst', 'app', 'gears');

(async () => {
  const [tank, browser] = await Promise.all([serve(), launch()]);
  const page = await browser.newPage({ viewport: { width: 1200, height: 800 } });
  await page.goto(tank.url);
  await page.waitForSelector('.gear-card', { state: 'visible' });
  await page.addStyleTag({ content: '#tank { width: 400px !important; height: 250px !important; }' +
    '#tank > :not(canvas) { display: none !important; }' });
  const asked = process.argv.slice(2);
  const gears = asked.length ? asked : await page.$$eval('.gear-card', (all) => all.map((e) => e.dataset.gear));
  fs.mkdirSync(folder, { recursive: true });
  await page.waitForFunction(() => window.Shiny && window.Shiny.shinyapp && window.Shiny.shinyapp.isConnected());
  for (const gear of gears) {
    if (await page.isHidden('#gallery')) await page.click('#gears');
    const title = await page.textContent(`[data-gear="${gear}"] .card-title`);
    await page.click(`[data-gear="${gear}"]`);
    await page.waitForFunction((t) => document.querySelector('h1').textContent === t &&
      document.getElementById('gallery').hidden, title, { timeout: 120000 });
    await page.waitForTimeout(1500);
    await page.locator('#tank').screenshot({ path: path.join(folder, `${gear}.jpg`), type: 'jpeg', quality: 72 });
    console.log(gear);
  }
  await browser.close();
  tank.stop();
})();
