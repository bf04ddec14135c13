// The page of the flume tank: passes R's messages to the modules. The bundle, inst/app/tank.js, defines
// `codendTank` for tests.

import type { FromR, MovedHeader } from '../protocol';
import { element, file_name, find, save_as } from '../view';
import * as Catalogue from './catalogue';
import * as Designs from './designs';
import * as Drawing from './drawing';
import { on } from './events';
import { show_line } from './files';
import * as Form from './form';
import './gallery';
import * as Measures from './measures';
import { gallery, is_open, set_open, tell } from './notices';
import { hear, hear_bytes, on_page, send } from './server';
import * as Slopes from './slopes';
import * as Talk from './talk';
import * as Tank from './tank';
import * as Target from './target';
import * as Tow from './tow';
import * as Units from './units';
import * as Vary from './vary';
import { say } from './words';

export { Designs, Form, Talk, Tank, Tow, send };

let speaking: number | undefined, wanted: number | undefined;

// After a series of changes, screen readers announce the last one only.
function read_out(words: string) {
  window.clearTimeout(speaking);
  speaking = window.setTimeout(() => { find('said').textContent = words; }, 700);
}

// The page is loaded again in another language, with the same design.
on('change', (target) => {
  if (target.id !== 'language') return;
  const address = new URL(window.location.href);
  address.searchParams.set('lang', target.value);
  window.location.assign(address.href);
});
Units.on_change(Designs.moved);

// Requests the drawing and the plan text when nothing is pending.
function want_texts() {
  window.clearTimeout(wanted);
  wanted = window.setTimeout(() => {
    if (Talk.waits()) { want_texts(); return; }
    const tab = document.querySelector<HTMLElement>('#shown .active');
    Drawing.want();
    if (tab?.dataset.value === 'Plan') send('plan_wanted', Date.now());
  }, 400);
}

// ---- replies ------------------------------------------------------------------------------------

function answer(number: number) {
  Talk.free(number);
  Form.answered(number);
}

function picture(message: FromR['flume_picture']) {
  // The first gear is not a reply, so errors about the address stay visible.
  const answering = is_open() || message.answers;
  set_open();
  tell('refused', '');
  if (answering) {
    ['gallery_refused', 'plan_file_error', 'new_error', 'plan_text_error'].forEach((id) => tell(id, ''));
    gallery(false);
  }
  Tank.picture(message);
  find('gear_name').textContent = message.name;
  find('gear_conditions').textContent = message.conditions;
  find('noted').replaceChildren(...message.notes.map((one) => element('li', '', one)));
  find('worth').hidden = !message.notes.length;
  read_out(message.said);
  answer(message.answers);
  Designs.moved();
  Slopes.stale();
  Vary.stale();
  Tow.design(message.towed);
  want_texts();
}

// Intermediate shape while a slider moves; other outputs follow.
function moved(bytes: ArrayBuffer) {
  const size = new DataView(bytes).getUint32(0, true);
  const told = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, size))) as MovedHeader;
  let at = 4 + size;
  Object.entries(told.counts).forEach(([name, count]) => {
    Object.assign(told.part, { [name]: { floats: new Float32Array(bytes, at, count) } });
    at += 4 * count;
  });
  Tank.moved(told.part);
  find('gear_conditions').textContent = told.conditions;
  Form.answered(told.answers);
}

// The elements that show errors of requests, by kind.
const in_gallery: Record<string, string> = {
  plan_file: 'plan_file_error', new: 'new_error', shipped: 'gallery_refused', words: 'gallery_refused',
  gallery: 'gallery_refused'
};
const in_panels: Record<string, string> = {
  tow: 'tow_error', slopes: 'slopes_error', uncertainty: 'uncertainty_error', vary: 'vary_error',
  target: 'target_error', own: 'own_error', shared: 'shared_error'
};
function refused(message: FromR['flume_refused']) {
  const { where, path, cancelled } = message;
  if (in_panels[where]) {
    tell(in_panels[where], message.message);
  } else if (where === 'plan_text') {
    tell('plan_text_error', message.message);
    if (!cancelled && path) show_line(path);
  } else if (in_gallery[where]) {
    if (!is_open() || where !== 'shipped') gallery(true);
    tell(in_gallery[where], message.message + (is_open() ? ' ' + say('gear_stays') : ''));
  } else {
    const beside = where === 'design' && Form.refused(message);
    tell('refused', (cancelled ? say('cancelled') : beside ? say('field_refused') : message.message) + ' ' +
      say('last_shape_stays'));
  }
  answer(message.answers);
}

function draft(message: FromR['flume_draft']) {
  find<HTMLButtonElement>('undo').disabled = !message.undo;
  find<HTMLButtonElement>('redo').disabled = !message.redo;
  if (message.form) {
    if (Form.turn() !== message.form.turn) Drawing.opened();
    Form.show(message.form);
    Slopes.form();
    Vary.form();
    Target.form();
  }
  Form.draft(message);
  if (message.settling || message.form) Drawing.want(true);
  Designs.moved();
}

// Shows the part that was clicked in the tank, without a jump of the page.
function part({ path }: FromR['flume_part']) {
  if (!Form.open(path, true)) return;
  const panel = find('controls'), marked = panel.querySelector('.marked');
  if (marked) panel.scrollTop += marked.getBoundingClientRect().top - panel.getBoundingClientRect().top - 60;
  Drawing.seek(path);
}

function listen() {
  Tank.listen();
  hear('flume_picture', picture);
  hear_bytes('flume_moved', moved);
  hear('flume_refused', refused);
  hear('flume_idle', (message) => {
    answer(message.answers);
    want_texts();
  });
  hear('flume_draft', draft);
  hear('flume_measures_about', Measures.set_about);
  hear('flume_measures', Measures.show);
  hear('flume_sensitivities', Slopes.show);
  hear('flume_varied', Vary.show);
  hear('flume_target', Target.show);
  hear('flume_tow', Tow.show);
  hear('flume_offers', Form.offers);
  hear('flume_kept', (message) => Designs.show(message.kept));
  hear('flume_words', Designs.write);
  hear('flume_own', (message) => Catalogue.take_own(message.rows));
  hear('flume_shared', (message) => Designs.shared(message.designs));
  hear('flume_shared_done', () => tell('shared_error', ''));
  hear('flume_clerk', ({ busy, what }) => {
    if (busy) Talk.busy('clerk ' + what, say('busy.' + what));
    else Talk.free('clerk ' + what);
    if (what === 'uncertainty') tell('uncertainty_error', '');
  });
  hear('flume_drawing', (message) => Drawing.show(message.svg));
  hear('flume_part', part);
  hear('flume_plan', (message) => {
    find<HTMLTextAreaElement>('plan_area').value = message.text;
    tell('plan_text_error', '');
  });
}

on('click', ({ id }) => {
  if (id === 'save_picture') save_as(Tank.save_picture(), file_name(find('gear_name').textContent ?? '') + '.png');
});

document.addEventListener('DOMContentLoaded', () => {
  find<HTMLButtonElement>('undo').disabled = find<HTMLButtonElement>('redo').disabled = true;
  const opens = find('flume').classList.contains('opens');
  if (!opens && !/^#d=/.test(window.location.hash)) find('gallery').hidden = false;
  on_page('shown.bs.tab', want_texts);
});
window.addEventListener('hashchange', () => Designs.read());
on_page('shiny:connected', () => {
  listen();
  if (Designs.read()) find('gear_name').textContent = say('opening_address');
});
on_page('shiny:disconnected', () => {
  Talk.stop();
  tell('refused', say('process_ended'));
  tell('gallery_refused', say('process_gone'));
});
