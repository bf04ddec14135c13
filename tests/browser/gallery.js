// Pictures of the shipped gears from their pages of view_3d(), without buttons: README's in gallery/*.webp,
// and the cards of the tank's gallery in inst/app/gears/*.jpg. node gallery.js [gear...]: run after a gear
// or the way that it is drawn has changed.
'use strict';
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { execFileSync } = require('node:child_process');
const { launch } = require('./tank');

const root = path.join(__dirname, '..', '..');
const cards = { folder: path.join(root, 'inst', 'app', 'gears'), wide: 400, tall: 250 };
const large = { folder: path.join(root, 'gallery'), wide: 1350, tall: 900 };
// README's gears, with where the eye is when not at its first place: angles (radians), share of distance.
const shown = {
  midwater_trawl: { turn: -2.35, rise: 0.22, near: 0.9 },
  poly_noreastern_trawl: { turn: -2.3, rise: 0.3, near: 0.95 },
  pair_trawl: { turn: -2.45, rise: 0.36, near: 0.95 },
  beam_trawl: { turn: -2.45, rise: 0.3, near: 0.95 },
  purse_seine: {},
  cage: { turn: -2.05, rise: 0.24 },
  stow_net: { turn: -2.25, rise: 0.2 },
  longline: {},
  small_midwater_trawl: { turn: -2.3, rise: 0.18, near: 0.95 }
};

(async () => {
  const asked = process.argv.slice(2), folder = fs.mkdtempSync(path.join(os.tmpdir(), 'gallery-'));
  const gears = asked.length ? asked :
    fs.readdirSync(path.join(root, 'inst', 'gears')).map((file) => path.basename(file, '.yaml'));
  execFileSync('Rscript', [path.join(__dirname, 'view.R'), folder, '0', ...gears], { stdio: 'inherit' });
  const browser = await launch();
  for (const gear of gears) {
    const page = await browser.newPage();
    for (const size of shown[gear] ? [cards, large] : [cards]) {
      await page.setViewportSize({ width: size.wide, height: size.tall });
      await page.goto('file://' + path.join(folder, gear + '.html'));
      await page.addStyleTag({ content: '.codend-view > :not(canvas) { display: none !important; }' });
      await page.waitForFunction(() => document.querySelector('.codend-view').codendViewer?.painted());
      const bytes = await page.evaluate(async ([card, view]) => {
        const viewer = document.querySelector('.codend-view').codendViewer;
        viewer.frame(view);
        const canvas = viewer.picture(card ? 400 : 1800, false);
        const made = await new Promise((go) => canvas.toBlob(go, card ? 'image/jpeg' : 'image/webp', card ? 0.8 : 0.88));
        return Array.from(new Uint8Array(await made.arrayBuffer()));
      }, [size === cards, shown[gear] || {}]);
      fs.writeFileSync(path.join(size.folder, gear + (size === cards ? '.jpg' : '.webp')), Buffer.from(bytes));
    }
    await page.close();
    console.log(gear);
  }
  await browser.close();
  fs.rmSync(folder, { recursive: true });
})();
