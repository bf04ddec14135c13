// The structure of the flume tank's page. Other modules fill and change its elements, by their ids.

import type { ComponentChildren } from 'preact';
import type { FromR } from '../protocol';
import { capital, has_word, say, say_field, say_unit } from './words';

type Begin = FromR['flume_begin'];
type Children = { children?: ComponentChildren };

function Button({ id, words, primary, ...rest }: {
  id: string; words: string; primary?: boolean; [name: string]: unknown;
}) {
  return <button type="button" id={id} class={primary ? 'primary' : undefined} {...rest}>{words}</button>;
}
const FieldError = ({ id }: { id: string }) => <p id={id} class="field-error" role="alert" hidden />;
const Note = ({ children }: Children) => <p class="note">{children}</p>;
const Divider = ({ id, value }: { id: string; value: number }) => <div id={id} role="separator" tabIndex={0}
  aria-orientation="vertical" aria-label={say(id)} aria-valuenow={value} />;
function Text({ id, label, ...rest }: { id: string; label: string; [name: string]: unknown }) {
  return <label>{label}<input type="text" id={id} autocomplete="off" {...rest} /></label>;
}

// ---- header and start page ----------------------------------------------------------------------

function Header({ preferred, language, languages, checked }: Begin) {
  const labels = { length: 'lengths_in', force: 'forces_in', speed: 'speeds_in' };
  return <header>
    <div><h1 id="gear_name">{say('tank_name')}</h1><p id="gear_conditions" class="note" lang="en" /></div>
    <div class="header-tools" role="group" aria-label={say('design')}>
      <Button id="gears" words={say('gears')} title={say('gears_tip')} />
      <Button id="undo" words={say('undo')} title={say('undo_tip')} disabled />
      <Button id="redo" words={say('redo')} title={say('redo_tip')} disabled />
      <Button id="keep" words={say('keep')} primary /><Button id="back" words={say('back')} />
      {Object.entries(labels).map(([dimension, label]) =>
        <select class="preferred" data-dimension={dimension} aria-label={say(label)}>
          {preferred[dimension].map((unit) => <option value={unit}>{say_unit(unit)}</option>)}
        </select>)}
      <select id="language" aria-label={say('language')}>
        {languages.map(({ name, words }) =>
          <option value={name} lang={name} selected={name === language}>{words}</option>)}
      </select>
      {!checked && <span id="machine_made" class="note" title={say('machine_made')}>{say('machine_short')}</span>}
    </div>
  </header>;
}

function size({ panels, ropes, speed }: Begin['gears'][number]): string {
  return [
    panels && say(panels === 1 ? 'panels_one' : 'panels_many', { n: panels }),
    ropes && say(ropes === 1 ? 'ropes_one' : 'ropes_many', { n: ropes }), speed && speed + ' ' + say_unit('knot')
  ].filter(Boolean).join(', ');
}

function Gallery(begin: Begin) {
  const { gears, kinds, shares } = begin;
  return <main id="gallery" aria-labelledby="gallery_heading" hidden>
    <h2 id="gallery_heading">{say('begin')}</h2>
    <div id="gallery_refused" class="alert" role="alert" hidden />
    <div class="cards">{gears.map((gear) =>
      <button type="button" class="gear-card" data-gear={gear.name}>
        <img src={'gears/' + gear.name + '.webp'} alt="" loading="lazy" width="320" height="200" />
        <span class="card-title" lang="en">{gear.title}</span>
        <span class="note">{[say('kind.' + gear.kind), size(gear)].filter(Boolean).join(': ')}</span>
      </button>)}</div>
    <div class="beginnings">
      <section class="panel" aria-labelledby="new_heading">
        <h2 id="new_heading">{say('new_heading')}</h2>
        <div id="new_gear">
          <label>{say('kind')}<select id="new_kind">
            {kinds.map(({ name }) => <option value={name}>{say('kind.' + name)}</option>)}</select></label>
          {kinds.map(({ name, values }, k) =>
            <fieldset class="new-numbers" data-kind={name} hidden={k > 0}>
              <legend class="visually-hidden">{say('kind.' + name)}</legend>
              {!Object.keys(values).length && <Note>{say('as_shipped')}</Note>}
              {Object.entries(values).map(([field, value]) => <label>{capital(say_field(field))}
                <input type="text" value={value} data-ask={field} autocomplete="off" /></label>)}
            </fieldset>)}
          <FieldError id="new_error" />
          <Button id="make_gear" words={say('make_it')} primary />
        </div>
      </section>
      <section class="panel" aria-labelledby="own_heading">
        <h2 id="own_heading">{say('own_heading')}</h2>
        <label>{say('open_plan')}<input type="file" class="plan-file" accept=".yaml,.yml,.json" /></label>
        <Note>{say('plan_limits')}</Note>
        <FieldError id="plan_file_error" />
      </section>
      {shares && <section class="panel"><h2>{say('shared_heading')}</h2><ul class="shared-list" /></section>}
    </div>
  </main>;
}

// ---- design -------------------------------------------------------------------------------------

const Tank = () => <section class="tank" aria-label={say('tank_region')}>
  <div class="see" role="group" aria-label={say('seen_region')}>
    <Button id="see_drawing" words={say('drawing')} title={say('enlarge', { key: 'D' })} aria-pressed="false" />
    <Button id="see_tank" words={say('in_tank')} title={say('enlarge', { key: 'T' })} aria-pressed="false" />
    <span class="drawing-tools">
      <Button id="drawing_in" words="+" aria-label={say('zoom_in')} />
      <Button id="drawing_out" words={'\u2212'} aria-label={say('zoom_out')} />
      <Button id="drawing_all" words={say('whole_sheet')} />
      <span id="drawing_said" class="note" role="status">{say('drawing_hint')}</span>
    </span>
  </div>
  <div id="drawing" role="group" aria-label={say('net_drawing')} tabIndex={0} />
  <Divider id={'divider_drawing'} value={44} />
  <div id="tank" />
  <p id="predicted" class="note" hidden>{say('predicted')}</p>
</section>;

const Controls = () => <section id="controls" class="panel controls" aria-labelledby="controls_heading">
  <h2 id="controls_heading">{say('every_field')}</h2>
  <div id="worth" hidden><h2>{say('warnings')}</h2><ul id="noted" /></div>
  <input id="find_field" type="search" placeholder={say('find_hint')} aria-label={say('find_field')}
    autocomplete="off" />
  <div id="form" />
</section>;

const Alerts = () => <div class="alerts">
  <div id="refused" class="alert" role="alert" hidden />
  <div id="unfinished" class="alert" role="status" hidden>
    <strong>{say('unfinished')}</strong><ul id="draft_problems" />
  </div>
</div>;

// On a phone, one sheet below the tank shows one of three parts of the page.
function Sheets() {
  const sheets = { tow: say('tab_tow'), net: say('sheet_net'), results: say('sheet_results') };
  return <div id="sheets" role="group" aria-label={say('design')}>
    {Object.entries(sheets).map(([name, words]) => <button type="button" class="sheet" data-sheet={name}
      aria-pressed={name === 'tow'}>{words}</button>)}
  </div>;
}

const Measures = ({ guide, about }: Begin) => <section class="measures" aria-label={say('measures')}>
  <div id="measures" />
  <div id="target_asks" class="asks" hidden>
    <label><span id="target_label" /><input id="target_value" type="text" autocomplete="off" /></label>
    <label>{say('field')}<select id="target_field" /></label>
    <div class="button-row">
      <Button id="target_start" words={say('target_start')} primary />
      <Button id="target_close" words={say('target_close')} />
    </div>
    <FieldError id="target_error" /><p id="target_said" class="note" role="status" />
  </div>
  <details id="measures_more"><summary>{say('all_other_measures')}</summary><div id="other_measures" /></details>
  <label class="check"><input type="checkbox" id="with_intervals" />{say('how_sure')}</label>
  <FieldError id="uncertainty_error" />
  <Note>{about ?? (guide ? <a href="doc/measures.html" target="_blank">{say('what_measures_mean')}</a> :
    <>{say('what_measures_mean')} <code>vignette("measures", "codend")</code></>)}</Note>
  <details id="more_of">
    <summary>{say('little_more')}</summary>
    <div class="control-row">
      <input id="more_amount" type="number" step="any" aria-label={say('how_much_more')} />
      <span id="more_unit" /><span>{say('more_of')}</span>
      <select id="more_field" aria-label={say('of_which_field')} />
    </div>
    <FieldError id="slopes_error" />
    <div id="more_does" aria-live="polite" />
    <Button id="slopes_all" words={say('all_first_fields')} />
  </details>
</section>;

// ---- tabs ---------------------------------------------------------------------------------------

// A file. Its explanation has the key `id`_about by default.
function Save({ id, words, about }: { id: string; words?: string; about?: string }) {
  const key = id + '_about';
  return <li><Button id={id} words={words ?? say(id)} class="save" />
    <span class="note">{about ?? (has_word(key) && say(key))}</span></li>;
}

const Slopes = () => <>
  <Note>{say('slopes_note')}</Note>
  <Button id="slopes_table" words={say('find_slopes')} primary /><div id="slopes" />
</>;

const Vary = () => <>
  <Note>{say('vary_note')}</Note>
  <div class="asks">
    <label>{say('field')}<select id="vary_field" /></label>
    <Text id="vary_from" label={say('from')} /><Text id="vary_to" label={say('to')} />
    <Text id="vary_number" label={say('values')} type="number" value="11" min="2" max="41" />
  </div>
  <div class="button-row">
    <Button id="vary_start" words={say('draw_graphs')} primary /><Button id="vary_stop" words={say('stop')} hidden />
  </div>
  <FieldError id="vary_error" />
  <div id="varied" hidden>
    <p id="vary_said" class="note" role="status" /><p id="vary_stale" class="note" hidden />
    <div id="vary_graphs" class="graphs" />
    <label>{say('another_graph')}<select id="vary_more" /></label>
    <ul class="downloads"><Save id={'save_vary'} /></ul>
  </div>
</>;

function Tow({ tow_saves }: Begin) {
  const change = (name: string, label: string, about: string, over: string) => <div class="tow-change">
    <Text id={'tow_' + name} label={label} placeholder={about} />
    <Text id={'tow_' + name + '_from'} label={say('change_from')} value="10 s" />
    <Text id={'tow_' + name + '_over'} label={say('change_over')} value={over} />
  </div>;
  return <>
    <Note>{say('tow_note')}</Note>
    <div class="asks">
      <Text id="tow_until" label={say('tow_for')} value="60 s" />
      {change('speed', say('speed_becomes'), say('such_as', { example: '5 knot' }), '20 s')}
      {change('course', say('turn_by'), say('such_as', { example: '90 deg' }), '60 s')}
      {change('warp_out', say('warp_paid'), say('such_as_two', { example: '50 m', other: '-50 m' }), '60 s')}
    </div>
    <div class="button-row">
      <Button id="tow_start" words={say('tow')} primary />
      <Button id="tow_planned" words={say('tow_planned')} hidden />
    </div>
    <FieldError id="tow_error" />
    <div id="towed" hidden>
      <p id="tow_stale" class="note" hidden /><div id="tow_place" /><div id="tow_graphs" class="graphs" />
      <label>{say('another_graph')}<select id="tow_more" /></label>
      <ul class="downloads">{tow_saves.map((name) => <Save id={'save_tow_' + name} words={say('tow_saves.' + name)}
        about={say('tow_saves.' + name + '.about')} />)}</ul>
    </div>
  </>;
}

const Designs = ({ shares }: Begin) => <>
  <div id="kept_designs" /><div id="designs" />
  {shares && <section id="shared">
    <h2>{say('shared_heading')}</h2><ul class="shared-list" /><Note>{say('shared_note')}</Note>
    <div class="asks"><Text id="shared_author" label={say('shared_author')} maxLength={30} />
      <Text id="shared_name" label={say('shared_name')} maxLength={30} /></div>
    <Button id="shared_put" words={say('shared_put')} primary /><FieldError id="shared_error" />
  </section>}
</>;

const Plan = () => <>
  <label for="plan_area">{say('plan_on_screen')}</label>
  <textarea id="plan_area" rows={24} spellcheck={false} wrap="off" aria-describedby="plan_text_error" />
  <FieldError id="plan_text_error" /><Button id="plan_text_settle" words={say('settle_plan')} primary />
</>;

const Code = () => <>
  <p>{say('code_settles')}</p><pre id="code" tabIndex={0} role="region" aria-label={say('tab_code')} />
  <ul class="downloads"><Save id={'save_code'} /></ul>
</>;

function Saves({ can_share, formats }: Begin) {
  const ids = ['save_report', can_share && 'save_share', 'save_plan', 'save_planes', 'save_drawing_svg',
    'save_drawing_pdf', 'save_drawing_dxf', 'save_slopes', 'save_all', 'save_designs', 'save_measures', 'save_drag'];
  return <ul class="downloads">
    {ids.map((id) => id && <Save id={id} />)}
    {formats.map(({ name, title, extension, opens }) => <Save id={'save_' + name}
      words={title + ' (' + extension + ')'} about={say('for_program', { program: opens })} />)}
  </ul>;
}

function Tabs(begin: Begin) {
  const tables = (name: string) => <div id={name} />;
  // The first tab needs no data of R.
  const tabs: [string, string, ComponentChildren][] = [
    ['Designs', say('tab_designs'), <Designs {...begin} />], ['Tensions', say('tab_tensions'), tables('tensions')],
    ['Drag', say('tab_drag'), tables('drag')], ['Slopes', say('tab_slopes'), <Slopes />],
    ['Vary', say('tab_vary'), <Vary />], ['Tow', say('tab_tow'), <Tow {...begin} />],
    ['Changes', say('tab_changes'), tables('differences')], ['Plan', say('tab_plan'), <Plan />],
    ['R code', say('tab_code'), <Code />], ['Save', say('tab_save'), <Saves {...begin} />]
  ];
  const id = (name: string) => 'tab_' + name.replace(' ', '_');
  return <section class="panel more" aria-label={say('more_region')}>
    <div id="shown" role="tablist" aria-label={say('more_region')}>{tabs.map(([name, words], k) =>
      <button type="button" role="tab" id={id(name)} data-value={name} aria-controls={id(name) + '_panel'}
        aria-selected={k === 0} tabIndex={k ? -1 : 0}>{words}</button>)}</div>
    <FieldError id="save_error" />
    {tabs.map(([name, , content], k) =>
      <div role="tabpanel" id={id(name) + '_panel'} aria-labelledby={id(name)} hidden={k > 0}>{content}</div>)}
  </section>;
}

export const Page = (begin: Begin) => <>
  <a class="skip-link" href="#controls">{say('skip')}</a>
  <div id="flume" class={begin.about && 'alone' + (begin.tows ? '' : ' still')} data-sheet="tow" data-seen="">
    <Header {...begin} />
    <div id="working" role="status" hidden>
      <span id="working_words">{say('settling')}</span><span id="working_time" />
      <Button id="cancel" words={say('cancel')} />
    </div>
    <Gallery {...begin} />
    <main id="design" class="flume-grid" hidden={!begin.opens}>
      <Tank /><Divider id={'divider_fields'} value={75} /><Sheets /><Alerts />
      <section class="main-fields" aria-label={say('changed_first')}><div id="quick" /></section>
      <Controls /><Measures {...begin} /><Tabs {...begin} />
    </main>
    <div id="said" class="visually-hidden" role="status" aria-live="polite" />
  </div>
</>;
