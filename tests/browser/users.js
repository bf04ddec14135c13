// Simulates many users: node --experimental-websocket users.js [users] [seconds] [messages a second
// of one more user]. The latter floods the server in bursts of 600, each from a new page.
//
// One user has a page in Chromium. The others use the tank without a browser, as in soak.js,
// because two cores that render ten browsers would measure only the rendering. Each user drags one
// slider for a quarter of a second, about once a second, with one pending request at a time, as the
// page has.
//
// Prints response times: from the slider position to the message with the shape, and, in Chromium,
// to the next picture of another shape (usually a prediction) and to the picture of the settled
// shape. Prints the CPU time of the R processes. Ends with status 1 on failure.
'use strict';
const fs = require('node:fs');
const { serve, launch, open } = require('./tank');
const { page: scripted } = require('./socket');

const users = Number(process.argv[2] || 10);
const seconds = Number(process.argv[3] || 60);
const flood = Number(process.argv[4] || 0);
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const wrong = [];

// CPU seconds of a process (Linux), or NaN, and of its present and past children.
function cpu(pid) {
  try {
    const fields = fs.readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1].split(' ')
      .map(Number);
    const below = fs.readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8').split(' ')
      .filter(Boolean).map(cpu).reduce((sum, one) => sum + one.own + one.others, 0);
    return { own: (fields[11] + fields[12]) / 100,
      others: (fields[13] + fields[14]) / 100 + below };
  } catch (error) {
    return { own: NaN, others: NaN };
  }
}

// Runs in the page: drags sliders for some seconds. Returns {times, reactions}: [ms to the
// message, ms to the picture] of each answer, and ms from the start of each movement to the first
// picture of another shape.
async function draw(seconds) {
  const times = [], reactions = [], asked = {};
  const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  const canvas = document.querySelector('#tank canvas'), gl = canvas.getContext('webgl2');
  let moved = 0;
  window.codendTank.sending.watch = (name) => {
    if (name === 'design') asked[window.codendTank.Form.pending()] = moved;
  };
  const watch = setInterval(() => {
    const pending = window.codendTank.Form.pending(), arrived = performance.now();
    Object.keys(asked).filter((number) => Number(number) !== pending).forEach((number) => {
      const since = asked[number];
      delete asked[number];
      requestAnimationFrame(() => setTimeout(() => {
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        times.push([arrived - since, performance.now() - since]);
      }, 0));
    });
  }, 1);
  const react = (since, points) => {
    if (window.codendTank.Tank.shown().gear().points === points) {
      setTimeout(() => react(since, points), 1);
      return;
    }
    requestAnimationFrame(() => setTimeout(() => {
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      reactions.push(performance.now() - since);
    }, 0));
  };
  const refused = () => [...document.querySelectorAll('.alert, .field-error')]
    .some((e) => !e.hidden);
  const end = performance.now() + 1000 * seconds;
  while (performance.now() < end) {
    const sliders = [...document.querySelectorAll('#quick .control [type=range]')];
    const slider = sliders[Math.floor(Math.random() * sliders.length)];
    const low = Number(slider.min), size = slider.max - low;
    const from = (slider.value - low) / size, to = 0.3 + 0.4 * Math.random();
    // the pointer reaches the slider
    slider.dispatchEvent(new Event('pointerover', { bubbles: true }));
    await pause(300);
    for (let k = 1; k <= 5; k++) {
      slider.value = low + size * (from + (to - from) * k / 5);
      moved = performance.now();
      if (k === 1) react(moved, window.codendTank.Tank.shown().gear().points);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      await pause(50);
    }
    slider.dispatchEvent(new Event('change', { bubbles: true }));
    await pause(500 + 1000 * Math.random());
    if (refused()) return { times, reactions, error: document.body.innerText.slice(0, 400) };
  }
  await pause(2000);
  clearInterval(watch);
  return { times, reactions,
    error: Object.keys(asked).length ? 'an answer is missing' : undefined };
}

// Opens a page without a browser and settles a first design, which starts its process.
async function come(url) {
  const tank = scripted(url), opened = tank.wait(['flume_picture']);
  await tank.open();
  if (!await opened) wrong.push('no picture');
  const answer = tank.wait(['flume_picture'], (m) => m.answers === 1, 300);
  tank.send({ design: { number: 1, edits: {} } });
  if (!await answer) wrong.push('no answer');
  return tank;
}

// Drags the towing speed for some seconds. Returns the ms to each message.
async function speak(tank, name, seconds) {
  const times = [];
  const end = Date.now() + 1000 * seconds;
  let number = 1, speed = 4;
  while (Date.now() < end) {
    const from = speed, to = 3.5 + Math.random(), begun = performance.now();
    for (let share = 0; share < 1;) {
      share = Math.min(1, (1 + Math.floor((performance.now() - begun) / 50)) / 5);
      speed = from + (to - from) * share;
      number += 1;
      const mine = number, asked = performance.now();
      const answer = tank.wait(['flume_moved', 'flume_picture', 'flume_refused'],
        (m) => m.answers === mine);
      tank.send({ design: { number: mine,
        edits: { 'towing.speed': { value: speed, unit: 'knot' } } } });
      const came = await answer;
      if (!came || came.type === 'flume_refused') {
        wrong.push(`${name}: ${came ? came.message : 'no answer in a minute'}`);
      } else {
        times.push(performance.now() - asked);
      }
    }
    await sleep(500 + 1000 * Math.random());
  }
  tank.close();
  return times;
}

// Sends `rate` designs per second for some seconds; in bursts if a page may not send as many.
async function pour(url, rate, seconds) {
  const end = Date.now() + 1000 * seconds;
  let sent = 0;
  while (Date.now() < end) {
    const tank = scripted(url);
    await tank.open();
    await tank.wait(['flume_picture']);
    const leaves = Date.now() + (rate > 40 ? 0 : 1000 * seconds);
    do {
      for (let k = 0; k < (rate > 40 ? 600 : 1); k++) {
        sent += 1;
        const edits = { 'towing.speed': { value: 3.5 + sent % 10 / 10, unit: 'knot' } };
        tank.send({ design: { number: sent, edits } });
      }
      await sleep(rate > 40 ? 600000 / rate : 1000 / rate);
    } while (Date.now() < Math.min(end, leaves));
    tank.close();
  }
  return sent;
}

function say(name, all) {
  all.sort((a, b) => a - b);
  const at = (share) => Math.round(all[Math.min(all.length - 1, Math.floor(share * all.length))]);
  console.log(`${name}: ${all.length} answers, median ${at(0.5)} ms, 95 % ${at(0.95)} ms, ` +
    `largest ${at(1)} ms`);
}

(async () => {
  const tank = await serve('midwater_trawl');
  const browser = await launch();
  const page = await open(browser, tank.url, { width: 390, height: 844 });
  const pages = [];
  for (let k = 1; k < users; k++) pages.push(await come(tank.url));
  const before = cpu(tank.pid);
  const others = pages.map((one, k) => speak(one, `user ${k + 2}`, seconds));
  const poured = flood ? pour(tank.url, flood, seconds) : 0;
  const found = await page.evaluate(draw, seconds);
  const spoken = (await Promise.all(others)).flat();
  const after = cpu(tank.pid), answers = found.times.length + spoken.length;
  if (flood) console.log(`one more sent ${await poured} messages`);
  say('slider to first reaction', found.reactions);
  say('slider to message, in Chromium', found.times.map((t) => t[0]));
  say('slider to picture', found.times.map((t) => t[1]));
  if (spoken.length) say('slider to message, the others', spoken);
  const spent = (whose) => (1000 * (after[whose] - before[whose]) / answers).toFixed(0);
  console.log(`CPU an answer: process that serves ${spent('own')} ms, ` +
    `all others ${spent('others')} ms`);
  wrong.push(...[found.error].concat(page.problems, page.strange).filter(Boolean));
  if (/[Ee]rror/.test(tank.log)) wrong.push(tank.log);
  console.log(wrong.length ? `wrong: ${wrong.join('\n')}` : 'no error');
  await browser.close();
  tank.stop();
  process.exit(wrong.length ? 1 : 0);
})();
