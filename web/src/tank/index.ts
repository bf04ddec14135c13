// The page of the flume tank: passes R's messages to the modules. The bundle, inst/app/tank.js, defines
// `codendTank` for tests.

import { h, render } from 'preact';
import type { FileHeader, FromR, MovedHeader, PredictionHeader } from '../protocol';
import { element, find, save_as } from '../view';
import * as Catalogue from './catalogue';
import * as Designs from './designs';
import * as Dividers from './dividers';
import * as Drawing from './drawing';
import { on } from './events';
import * as Files from './files';
import * as Form from './form';
import './gallery';
import * as History from './history';
import * as Kept from './kept';
import { Page } from './layout';
import * as Measures from './measures';
import { gallery, is_open, set_open, tell } from './notices';
import * as Predict from './predict';
import * as Saves from './saves';
import { connect, hear, hear_bytes, send, sending } from './server';
import * as Slopes from './slopes';
import * as Tabs from './tabs';
import * as Talk from './talk';
import * as Tank from './tank';
import * as Target from './target';
import * as Tow from './tow';
import * as Units from './units';
import * as Vary from './vary';
import { capital, say, set_words } from './words';

export { Designs, Form, Tabs, Talk, Tank, Tow, send, sending };

let wanted: number | undefined;

// The page is loaded again in another language, with the same design.
on('change', (target) => {
  if (target.id !== 'language') return;
  const address = new URL(window.location.href);
  address.searchParams.set('lang', target.value);
  window.location.assign(address.href);
});
Units.on_change(() => {
  Form.refresh();
  Measures.write();
  Slopes.write();
  Vary.write();
  Designs.moved();
  Tabs.changed();
});

// Requests the drawing and the content of the open tab when nothing is pending.
function want_texts() {
  Tabs.changed();
  window.clearTimeout(wanted);
  wanted = window.setTimeout(() => {
    if (Talk.waits()) want_texts();
    else Drawing.want();
  }, 400);
}

// ---- replies ------------------------------------------------------------------------------------

// Returns true for the answer to a typed plan.
function answer(number: number): boolean {
  Talk.free(number);
  Form.answered(number);
  return Files.answered(number);
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
  History.settled(message.edited);
  Tank.picture(message.scene, message.answers);
  find('gear_name').textContent = message.scene.name ?? '';
  find('gear_conditions').textContent = capital(message.scene.conditions ?? '');
  find('noted').replaceChildren(...message.notes.map((one) => element('li', '', one)));
  find('worth').hidden = !message.notes.length;
  answer(message.answers);
  Designs.moved();
  Slopes.stale();
  Vary.stale();
  Tow.design(message.towed);
  want_texts();
}

// A file, a derivative of the shape, or an intermediate shape while a slider moves; other outputs follow.
function take_bytes(
  header: MovedHeader | PredictionHeader | FileHeader, arrays: Record<string, Float32Array>, rest: ArrayBuffer
) {
  if ('file' in header) {
    save_as(new Blob([rest]), header.file);
    return;
  }
  const { points, places, boards } = arrays, shape = { points, places, boards };
  if ('predicts' in header) {
    Predict.take(header, shape);
    return;
  }
  Object.entries(arrays).forEach(([name, floats]) => Object.assign(header.part, { [name]: { floats } }));
  Tank.moved({ ...header.part, ...Predict.settle(header.answers, shape, !header.part.ropes) });
  find('gear_conditions').textContent = capital(header.part.conditions ?? '');
  Form.answered(header.answers);
}

// The elements that show errors of requests, by kind.
const in_gallery: Record<string, string> = {
  plan_file: 'plan_file_error', new: 'new_error', words: 'gallery_refused',
  gallery: 'gallery_refused'
};
const in_panels: Record<string, string> = {
  tow: 'tow_error', slopes: 'slopes_error', uncertainty: 'uncertainty_error', vary: 'vary_error',
  target: 'target_error', own: 'own_error', shared: 'shared_error', save: 'save_error'
};
function refused(message: FromR['flume_refused']) {
  const { where, cancelled } = message;
  if (where === 'design') History.refused(message.answers);
  if (in_panels[where]) {
    tell(in_panels[where], message.message);
  } else if (where === 'design' && Files.refused(message)) {
    tell('refused', '');
  } else if (in_gallery[where]) {
    gallery(true);
    tell(in_gallery[where], message.message + (is_open() ? ' ' + say('gear_stays') : ''));
  } else {
    const beside = where === 'design' && Form.refused(message);
    tell('refused', (cancelled ? say('cancelled') : beside ? say('field_refused') : message.message) + ' ' +
      say('last_shape_stays'));
  }
  answer(message.answers);
  Predict.stop();
}

function draft(message: FromR['flume_draft']) {
  if (!message.settling) Files.refused(message.problems[0]);
  if (message.form) {
    const opened = Form.turn() !== message.form.turn;
    if (opened) Drawing.opened();
    Form.show(message.form);
    if (opened) Predict.start();
    Slopes.form();
    Vary.form();
    Target.form();
  }
  Form.draft(message);
  if (!message.settling) Designs.complete();
  if (message.settling || message.form) Drawing.want(true);
  Designs.moved();
}

// Shows a chosen part in the tank and in the tables; if it was clicked in the tank, also in form and
// drawing, without a jump of the page.
function part({ path, names, clicked }: FromR['flume_part']) {
  Tank.highlight(names);
  Tabs.highlight(names);
  if (!clicked || !Form.open(path, true)) return;
  const panel = find('controls'), marked = panel.querySelector('.marked');
  if (marked) panel.scrollTop += marked.getBoundingClientRect().top - panel.getBoundingClientRect().top - 60;
  Drawing.seek(path);
}

// Forgets requests that nobody will answer.
function forget() {
  Talk.stop();
  Tabs.lost();
  Form.lost();
}

// Builds the page. After a lost connection, the page exists and opens its designs again.
function begin(message: FromR['flume_begin']) {
  if (document.getElementById('flume')) {
    forget();
    Designs.open_again();
    return;
  }
  document.documentElement.lang = message.language;
  set_words(message);
  document.title = say('page_title');
  Catalogue.set_catalogue(message.catalogue);
  Units.set_units(message);
  document.body.textContent = '';
  render(h(Page, message), document.body);
  Tank.listen();
  Drawing.listen();
  Dividers.listen();
  if (Designs.read()) find('gear_name').textContent = say('opening_address');
  else find('gallery').hidden = message.opens;
}

hear({
  flume_begin: begin,
  flume_opened: Designs.opened,
  flume_picture: picture,
  flume_refused: refused,
  flume_idle(message) {
    // The text of a typed plan that does not settle stays.
    if (!answer(message.answers)) want_texts();
    Predict.stop();
  },
  flume_draft: draft,
  flume_measures: Measures.show,
  flume_sensitivities: Slopes.show,
  flume_varied: Vary.show,
  flume_target: Target.show,
  flume_tow: Tow.show,
  flume_offers: Form.offers,
  flume_kept: Kept.settled,
  flume_words({ answers, words }) {
    answer(answers);
    Designs.open(words);
  },
  flume_own(message) { Catalogue.take_own(message.rows); },
  flume_shared(message) { Designs.shared(message.designs); },
  flume_shared_done() { tell('shared_error', ''); },
  flume_clerk({ busy, what }) {
    if (busy) Talk.busy('clerk ' + what, say('busy.' + what));
    else Talk.free('clerk ' + what);
  },
  flume_drawing(message) { Drawing.show(message.svg); },
  flume_part: part,
  flume_plan(message) {
    Tabs.show_plan(message);
    tell('plan_text_error', '');
  },
  flume_code: Tabs.show_code,
  flume_table: Tabs.show
});
hear_bytes(take_bytes);

Saves.add('save_code', '.R', () => find('code').textContent + '\n');

window.addEventListener('hashchange', () => Designs.read());
connect(() => {
  forget();
  tell('refused', say('process_ended'));
  tell('gallery_refused', say('process_gone'));
}, History.has_design);
