// Many users at once: node users.js [users] [seconds]. Each has a page of its own and moves one of
// its sliders about once a second; prints how long the answers took, from slider to message and to
// picture, and the CPU time of the R process. Ends with status 1 when anything went wrong.
'use strict';
const fs = require('node:fs');
const { serve, launch, open } = require('./tank');

const users = Number(process.argv[2] || 10);
const seconds = Number(process.argv[3] || 60);

// CPU seconds of a process (Linux), or NaN.
function cpu(pid) {
  try {
    const fields = fs.readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1].split(' ');
    return (Number(fields[11]) + Number(fields[12])) / 100;
  } catch (error) {
    return NaN;
  }
}

// In the page: moves sliders until the time is over; [ms to the message, ms to the picture] of
// each.
async function click(seconds) {
  const picture = window.codendTank.picture;
  const times = [];
  let answered;
  window.codendTank.picture = (message) => {
    const arrived = performance.now();
    picture(message);
    const painted = () => answered && answered([arrived, performance.now()]);
    requestAnimationFrame(() => setTimeout(painted, 0));
  };
  const refused = () => [...document.querySelectorAll('.alert-danger, .field-error')]
    .some((e) => !e.hidden);
  const end = performance.now() + 1000 * seconds;
  while (performance.now() < end) {
    const sliders = [...document.querySelectorAll('#quick .control [type=range]')];
    const slider = sliders[Math.floor(Math.random() * sliders.length)];
    const share = 0.3 + 0.4 * Math.random();
    const asked = performance.now();
    const answer = new Promise((resolve) => { answered = resolve; });
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    const came = await Promise.race([answer, new Promise((r) => setTimeout(r, 30000))]);
    if (!came || refused()) return { times, error: document.body.innerText.slice(0, 400) };
    times.push(came.map((t) => t - asked));
    await new Promise((r) => setTimeout(r, 500 + 1000 * Math.random()));
  }
  return { times };
}

(async () => {
  const tank = await serve('midwater_trawl');
  const browser = await launch();
  const pages = [];
  for (let k = 0; k < users; k++) {
    pages.push(await open(browser, tank.url, { width: 390, height: 844 }));
  }
  const before = cpu(tank.pid);
  const found = await Promise.all(pages.map((page) => page.evaluate(click, seconds)));
  const spent = cpu(tank.pid) - before;
  const wrong = found.map((f) => f.error).concat(...pages.map((p) => p.problems.concat(p.strange)))
    .filter(Boolean);
  const say = (name, which) => {
    const all = found.flatMap((f) => f.times.map((t) => t[which])).sort((a, b) => a - b);
    const at = (share) => Math.round(all[Math.min(all.length - 1, Math.floor(share * all.length))]);
    console.log(`${name}: ${all.length} answers, median ${at(0.5)} ms, 95 % ${at(0.95)} ms, ` +
      `largest ${at(1)} ms`);
    return all.length;
  };
  const count = say('slider to message', 0);
  say('slider to picture', 1);
  console.log(`R process: ${(1000 * spent / count).toFixed(0)} ms of CPU an answer`);
  if (/[Ee]rror/.test(tank.log)) wrong.push(tank.log);
  console.log(wrong.length ? `wrong: ${wrong.join('\n')}` : 'no error');
  await browser.close();
  tank.stop();
  process.exitCode = wrong.length ? 1 : 0;
})();
