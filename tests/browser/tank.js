// Starts codend's flume tank and a headless Chromium for it.
// CHROMIUM: path of the browser [/usr/bin/chromium]; CODEND: the command [exec/codend of the
// checkout].
'use strict';
const { spawn } = require('node:child_process');
const path = require('node:path');
const { chromium } = require('playwright-core');

const command = process.env.CODEND || path.join(__dirname, '..', '..', 'exec', 'codend');

// Resolves to { url, log (all that the process has said), stop } once the page is served.
function serve(...arguments_) {
  const child = spawn(command, ['flume', ...arguments_], { stdio: ['ignore', 'pipe', 'pipe'] });
  const tank = { log: '', pid: child.pid, stop: () => child.kill('SIGTERM') };
  return new Promise((resolve, reject) => {
    const listen = (chunk) => {
      tank.log += chunk;
      const found = tank.log.match(/Listening on (http:\S+)/);
      if (found) { tank.url = found[1]; resolve(tank); }
    };
    child.stdout.on('data', listen);
    child.stderr.on('data', listen);
    child.on('exit', (code) => reject(new Error(`codend flume ended (${code}): ${tank.log}`)));
  });
}

const launch = () => chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update']
});

// Opens the page; what goes wrong in it is kept in `problems`, requests to anything but its server
// in `strange`.
async function open(browser, url, size = { width: 1440, height: 900 }) {
  const page = await browser.newPage({ viewport: size });
  page.problems = [];
  page.strange = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) page.problems.push(message.text());
  });
  page.on('pageerror', (error) => page.problems.push(error.message));
  page.on('request', (request) => {
    const to = request.url();
    if (!to.startsWith(url) && !/^(data|blob):/.test(to)) page.strange.push(to);
  });
  page.on('websocket', (socket) => {
    if (!socket.url().startsWith(url.replace('http', 'ws'))) page.strange.push(socket.url());
  });
  await page.goto(url);
  await page.waitForSelector('[data-control]', { timeout: 60000 });
  await page.waitForSelector('.measures td', { timeout: 60000 });
  return page;
}

// The control of a field.
const control = (page, fieldPath) => page.locator(`.control[data-paths~="${fieldPath}"]`);

// A measure's row as texts: [now, pinned, change, %].
async function measure(page, name) {
  const row = page.locator('.measures tbody tr', {
    has: page.locator('th', { hasText: new RegExp(`^${name} \\(`) })
  });
  return row.locator('td').allTextContents();
}

module.exports = { serve, launch, open, control, measure };
