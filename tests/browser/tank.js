// Opens a headless Chromium for codend's flume tank. CHROMIUM: path of the browser
// [/usr/bin/chromium]; see serve.js for other variables.
'use strict';
const fs = require('node:fs');
const { chromium } = require('playwright-core');
const { serve } = require('./serve');

const launch = (...flags) => chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update',
    '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...flags]
});

// Opens a page. `problems` collects its errors, `strange` its requests to other servers. Chromium
// renders WebGL in software, which is faster at half the resolution. Reduced motion stops colour
// transitions, so that no test measures a contrast halfway.
async function visit(browser, url, size = { width: 1440, height: 900 }) {
  const page = await browser.newPage({ viewport: size, deviceScaleFactor: 0.5,
    reducedMotion: 'reduce' });
  const own = new URL(url).origin;
  page.problems = [];
  page.strange = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) {
      page.problems.push(`${message.text()} ${message.location().url}`);
    }
  });
  page.on('pageerror', (error) => page.problems.push(error.stack));
  page.on('request', (request) => {
    const to = request.url();
    if (!to.startsWith(own) && !/^(data|blob):/.test(to)) page.strange.push(to);
  });
  page.on('websocket', (socket) => {
    if (!socket.url().startsWith(own.replace('http', 'ws'))) page.strange.push(socket.url());
  });
  await page.goto(url);
  return page;
}

// Opens the page of a tank that starts with a gear.
async function open(browser, url, size) {
  const page = await visit(browser, url, size);
  await page.waitForSelector('[data-control]', { timeout: 60000 });
  await page.waitForSelector('.measures td', { state: 'attached', timeout: 60000 });
  await page.waitForFunction(() => document.querySelector('h1').textContent !== 'Flume tank', null,
    { timeout: 60000 });
  return page;
}

// Returns the control of a field; the quick control if the form has one too.
const control = (page, fieldPath) => page.locator(`.control[data-paths~="${fieldPath}"]`).first();

// Returns a measure's row as strings, as soon as it is there: [now, kept, change, %].
async function measure(page, name) {
  const row = page.locator('.measures tbody tr', {
    has: page.locator('th', { hasText: new RegExp(`^${name} \\(`) })
  });
  return row.first().evaluate((row) =>
    [...row.querySelectorAll('td')].map((cell) => cell.textContent),
    null, { timeout: 60000 });
}

// Resolves when a page has its answers and its address stores the design.
const answered = (page) => page.waitForFunction(() => window.codendTank.Form.still() &&
  !window.codendTank.Talk.waits() && !window.codendTank.Designs.waits(), null, { timeout: 60000 });

// Saves a file by the id of its button. Returns its name and text.
async function save(page, id) {
  const [file] = await Promise.all([page.waitForEvent('download', { timeout: 120000 }),
    page.click('#' + id)]);
  return [file.suggestedFilename(), fs.readFileSync(await file.path(), 'utf8')];
}

// Opens a tab by its English name, on a phone in its sheet, and waits for its content.
async function tab(page, name) {
  const results = page.locator('[data-sheet="results"].sheet');
  if (await results.isVisible()) await results.click();
  await page.click(`#shown [data-value="${name}"]`);
  await complete(page);
}

// Resolves when the open tab has its content and no transition runs.
const complete = (page) => page.waitForFunction(() => !window.codendTank.Tabs.waits() &&
  !document.getAnimations().length, null, { timeout: 60000 });

module.exports = { serve, launch, visit, open, control, measure, answered, save, tab, complete };
