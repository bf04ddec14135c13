// Runs the flume tank as a server for long: node --experimental-websocket soak.js [minutes]
// [users].
//
// Every user has a gear with a unique name, moves its towing speed about once a second, and leaves
// and returns now and then. One user requests a solve that takes too long. Each answer must belong
// to its user, no answer may fail, no process may outlive its page, and the server's memory may not
// grow. The test has no browser. It prints response times and the memory
// by minute, and ends with status 1 on failure.
'use strict';
const fs = require('node:fs');
const { serve } = require('./serve');
const { page } = require('./socket');

const minutes = Number(process.argv[2] || 60);
const users = Number(process.argv[3] || 10);
const wrong = [];
const times = [];
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// Returns the memory (MB) of a process, and the ids of its children (Linux); NaN and none
// elsewhere.
function memory(pid) {
  try {
    const status = fs.readFileSync(`/proc/${pid}/status`, 'utf8');
    return Number(status.match(/VmRSS:\s*(\d+)/)[1]) / 1024;
  } catch (error) {
    return NaN;
  }
}
function children(pid) {
  try {
    return fs.readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8').split(' ').filter(Boolean);
  } catch (error) {
    return [];
  }
}

// Simulates one user until the end; visits: how often the user comes.
async function use(url, name, end) {
  let number = 0;
  for (let visit = 1; Date.now() < end; visit++) {
    const tank = page(url);
    const opened = tank.wait(['flume_picture']);
    await tank.open();
    if (!await opened) { wrong.push(`${name}: no picture`); tank.close(); continue; }
    const text = tank.wait(['flume_plan']);
    tank.send({ plan_wanted: visit });
    const sent = await text;
    if (!sent) { wrong.push(`${name}: no plan`); tank.close(); continue; }
    const plan = sent.text.replace(/^name: .*$/m, `name: ${name} ${visit}`);
    const named = tank.wait(['flume_picture', 'flume_refused']);
    tank.send({ design: { number: 0, design: { plan } } });
    const own = await named;
    if (!own || own.scene?.name !== `${name} ${visit}`) {
      wrong.push(`${name}: ${JSON.stringify(own && own.message)}`);
    }
    const leaves = Date.now() + 60e3 + 60e3 * Math.random();
    while (Date.now() < Math.min(end, leaves)) {
      number += 1;
      const mine = number;
      const speed = (3 + 2 * Math.random()).toFixed(2);
      const answer = tank.wait(['flume_picture', 'flume_refused'], (m) => m.answers === mine);
      const asked = performance.now();
      const edits = { 'towing.speed': { value: Number(speed), unit: 'knot' } };
      tank.send({ design: { number: mine, edits } });
      const came = await answer;
      if (!came || came.type === 'flume_refused') {
        wrong.push(`${name}: ${came ? came.message : 'no answer in a minute'}`);
      } else {
        times.push(performance.now() - asked);
        const { name: drawn, conditions } = came.scene;
        if (drawn !== `${name} ${visit}`) wrong.push(`${name} got the picture of ${drawn}`);
        const told = Number((conditions.match(/([0-9.]+) knot/) || [])[1]);
        if (Math.abs(told - speed) > 0.006) {
          wrong.push(`${name} asked ${speed}, got "${conditions}"`);
        }
      }
      await sleep(500 + 1000 * Math.random());
    }
    tank.close();
  }
}

// Requests a net that takes longer than a page may wait.
async function trouble(url, end) {
  while (Date.now() < end) {
    const tank = page(url);
    const opened = tank.wait(['flume_picture']);
    await tank.open();
    await opened;
    const text = tank.wait(['flume_plan']);
    tank.send({ plan_wanted: 1 });
    const sent = await text;
    const plan = sent?.text + '\nresolution: {nodes: 20000}\n';
    if (sent) tank.send({ design: { number: 0, design: { plan } } });
    tank.send({ design: { number: 0, design: { plan: 'x'.repeat(3e6) } } });
    await sleep(5e3);
    tank.close();
    await sleep(15e3);
  }
}

const quantile = (sorted, share) => sorted[Math.floor(share * (sorted.length - 1))];

let tank;
(async () => {
  tank = await serve('midwater_trawl');
  const end = Date.now() + 60e3 * minutes;
  const resident = [];
  const look = setInterval(() => {
    const at = children(tank.pid);
    resident.push(memory(tank.pid));
    const all = at.map(memory).filter(Number.isFinite).reduce((a, b) => a + b, 0);
    console.log(`server ${resident.at(-1).toFixed(0)} MB, ${at.length} processes of users ` +
      `${all.toFixed(0)} MB, ${times.length} answers, ${wrong.length} wrong`);
  }, 60e3);
  const visits = [trouble(tank.url, end)];
  for (let k = 1; k <= users; k++) visits.push(use(tank.url, `User ${k}`, end));
  await Promise.all(visits);
  clearInterval(look);
  await sleep(5e3);
  const left = children(tank.pid).length;
  if (left) wrong.push(`${left} processes outlive their pages`);
  // after all users have visited; a leak per answer or visit would continue
  const settled = resident.slice(Math.floor(resident.length / 2));
  if (settled.length > 1 && settled.at(-1) > 1.15 * settled[0]) {
    wrong.push(`the server grew from ${settled[0].toFixed(0)} to ${settled.at(-1).toFixed(0)} MB`);
  }
  tank.stop();
  const sorted = [...times].sort((a, b) => a - b);
  const at = (share) => quantile(sorted, share).toFixed(0) + ' ms';
  console.log(`${sorted.length} answers to ${users} users: median ${at(0.5)}, ` +
    `95 % within ${at(0.95)}, longest ${at(1)}`);
  for (const what of wrong.slice(0, 20)) console.log(`wrong: ${what}`);
  process.exit(wrong.length || !sorted.length ? 1 : 0);
})().catch((error) => {
  console.error(error, tank && tank.log);
  if (tank) tank.stop();
  process.exit(1);
});
