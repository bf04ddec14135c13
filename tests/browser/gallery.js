// Writes pictures of the shipped gears from their view_3d() pages, without buttons: gallery/*.webp
// for README and inst/app/gears/*.webp for the cards of the tank's gallery. node gallery.js
// [gear...]
'use strict';
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { execFileSync } = require('node:child_process');
const { launch } = require('./tank');

const root = path.join(__dirname, '..', '..');
// Pixels of the page, then of the image and of the canvas that is scaled down.
const cards = { folder: path.join(root, 'inst', 'app', 'gears'), wide: 800, tall: 500, made: 400, drawn: 1600 };
const large = { folder: path.join(root, 'gallery'), wide: 900, tall: 600, made: 1600, drawn: 3200 };
const linked = fs.readFileSync(path.join(root, 'README.md'), 'utf8').match(/(?<=gallery\/)\w+(?=\.webp)/g);
// Camera positions that differ from the default: angles (radians), ratio of distances, visible
// range.
const views = {
  midwater_trawl: { turn: -2.35, rise: 0.25, focus: 'boards' },
  poly_noreastern_trawl: { turn: -2.3, rise: 0.3 },
  pair_trawl: { turn: -2.45, rise: 0.36 },
  beam_trawl: { turn: -2.45, rise: 0.3 },
  demersal_seine: { turn: -2.3, rise: 0.35 },
  cage: { turn: -2.05, rise: 0.24 },
  stow_net: { turn: -2.25, rise: 0.2 },
  small_midwater_trawl: { turn: -2.3, rise: 0.2 }
};

(async () => {
  const asked = process.argv.slice(2), folder = fs.mkdtempSync(path.join(os.tmpdir(), 'gallery-'));
  const gears = asked.length ? asked :
    fs.readdirSync(path.join(root, 'inst', 'gears')).map((file) => path.basename(file, '.yaml'));
  execFileSync('Rscript', [path.join(__dirname, 'view.R'), folder, '0', ...gears], { stdio: 'inherit' });
  const browser = await launch();
  for (const gear of gears) {
    const page = await browser.newPage();
    for (const size of linked.includes(gear) ? [cards, large] : [cards]) {
      await page.setViewportSize({ width: size.wide, height: size.tall });
      await page.goto('file://' + path.join(folder, gear + '.html'));
      await page.addStyleTag({ content: '.codend-view > :not(canvas) { display: none !important; }' });
      await page.waitForFunction(() => document.querySelector('.codend-view').codendViewer?.painted());
      const text = await page.evaluate(([card, size, view]) => {
        const viewer = document.querySelector('.codend-view').codendViewer;
        viewer.frame(view);
        let canvas = viewer.picture(size.drawn, false);
        while (canvas.width > size.made) {
          const half = document.createElement('canvas');
          half.width = canvas.width / 2;
          half.height = canvas.height / 2;
          half.getContext('2d').drawImage(canvas, 0, 0, half.width, half.height);
          canvas = half;
        }
        return canvas.toDataURL('image/webp', card ? 0.7 : 0.8);
      }, [size === cards, size, views[gear] || {}]);
      fs.writeFileSync(path.join(size.folder, gear + '.webp'),
        Buffer.from(text.split(',')[1], 'base64'));
    }
    await page.close();
    console.log(gear);
  }
  await browser.close();
  fs.rmSync(folder, { recursive: true });
})();
