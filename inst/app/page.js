// The flume tank's page: passes R's messages to the modules.
//
// `codendPage`:
//   `tell(id, words)` writes a message into an element, or hides it if there is none.
//   `gallery(yes)` shows the gallery or the design.
//   `prefer(units)`, `preferred()` set and return the user's units.
window.codendPage = (function () {
  'use strict';

  var say = window.codendSay, units = {}, speaking = null, wanted = null, opened = false;
  function find(id) { return document.getElementById(id); }

  function tell(id, words) {
    var place = find(id);
    if (!place) return;
    place.textContent = words || '';
    place.hidden = !words;
  }

  function gallery(yes) {
    if (!yes && !opened) return;
    if (find('gallery').hidden === !yes && find('design').hidden === !!yes) return;
    find('gallery').hidden = !yes;
    find('design').hidden = !!yes;
    find('gears').setAttribute('aria-expanded', String(!!yes));
    // Shiny then computes visible outputs only.
    $(find('design')).trigger(yes ? 'hidden' : 'shown');
    // The jump is instant, because the form's layout restores the present scroll position.
    window.scrollTo({ top: 0, behavior: 'instant' });
  }

  // After a series of changes, screen readers announce the last one only.
  function read_out(words) {
    window.clearTimeout(speaking);
    speaking = window.setTimeout(function () { find('said').textContent = words; }, 700);
  }

  // ---- units --------------------------------------------------------------------------------------

  function prefer(chosen) {
    units = {};
    document.querySelectorAll('.preferred').forEach(function (select) {
      var name = select.dataset.dimension, unit = chosen[name];
      if (unit && select.querySelector('[value="' + CSS.escape(unit) + '"]')) select.value = unit;
      units[name] = select.value;
    });
    Shiny.setInputValue('preferred', units, { priority: 'event' });
    window.codendForm.prefer(chosen);
  }
  document.addEventListener('change', function (event) {
    if (!event.target.classList.contains('preferred')) return;
    units[event.target.dataset.dimension] = event.target.value;
    prefer(units);
    window.codendDesigns.moved();
  });

  // The page is loaded again in another language, with the same design.
  document.addEventListener('change', function (event) {
    if (event.target.id !== 'language') return;
    var address = new URL(window.location.href);
    address.searchParams.set('lang', event.target.value);
    window.location.assign(address.href);
  });

  // ---- requests when idle -------------------------------------------------------------------------

  function want_texts() {
    window.clearTimeout(wanted);
    wanted = window.setTimeout(function () {
      if (window.codendTalk.waits()) { want_texts(); return; }
      var tab = document.querySelector('#shown .active');
      window.codendDrawing.want();
      if (tab && tab.dataset.value === 'Plan') window.codendTalk.tell('plan_wanted', Date.now());
    }, 400);
  }

  // ---- replies ------------------------------------------------------------------------------------

  function notes(all) {
    var list = find('noted');
    list.textContent = '';
    (all || []).forEach(function (one) {
      var item = document.createElement('li');
      item.textContent = one;
      list.appendChild(item);
    });
    find('worth').hidden = !list.childNodes.length;
  }

  function answer(number) {
    window.codendTalk.answered(number);
    window.codendForm.answered(number);
  }

  function listen() {
    window.codendTank.listen();
    Shiny.addCustomMessageHandler('flume_picture', function (message) {
      // The first gear is not a reply, so errors about the address stay visible.
      var answering = opened || message.answers;
      opened = true;
      tell('refused', '');
      if (answering) {
        ['gallery_refused', 'plan_file_error', 'new_error', 'plan_text_error'].forEach(function (id) {
          tell(id, '');
        });
        gallery(false);
      }
      window.codendTank.picture(message);
      find('gear_name').textContent = message.name;
      find('gear_conditions').textContent = message.conditions;
      notes(message.notes);
      read_out(message.said);
      answer(message.answers);
      window.codendDesigns.moved();
      window.codendSlopes.stale();
      window.codendVary.stale();
      window.codendTow.design(message.towed);
      want_texts();
    });
    // Intermediate shape while a slider moves; other outputs follow. R/flume-picture.R defines the
    // bytes.
    Shiny.addCustomMessageHandler('flume_moved', function (bytes) {
      var size = new DataView(bytes).getUint32(0, true), at = 4 + size;
      var told = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, size)));
      Object.keys(told.counts).forEach(function (name) {
        told.part[name] = { floats: new Float32Array(bytes, at, told.counts[name]) };
        at += 4 * told.counts[name];
      });
      window.codendTank.moved(told.part);
      find('gear_conditions').textContent = told.conditions;
      window.codendForm.answered(told.answers);
    });
    Shiny.addCustomMessageHandler('flume_refused', function (message) {
      var places = {
        plan_file: 'plan_file_error', plan_text: 'plan_text_error', 'new': 'new_error',
        shipped: 'gallery_refused', words: 'gallery_refused', gallery: 'gallery_refused'
      };
      var own = {
        tow: 'tow_error', slopes: 'slopes_error', uncertainty: 'uncertainty_error', vary: 'vary_error', target: 'target_error',
        own: 'own_error', shared: 'shared_error'
      }[message.where];
      var stays = opened ? ' ' + say('gear_stays') : '';
      if (own) {
        tell(own, message.message);
      } else if (message.where === 'plan_text') {
        tell('plan_text_error', message.message);
        if (!message.cancelled) window.codendFiles.showLine(message.path);
      } else if (places[message.where]) {
        if (!opened || message.where !== 'shipped') gallery(true);
        tell(places[message.where], message.message + stays);
      } else {
        var beside = message.where === 'design' && window.codendForm.refused(message);
        tell('refused', (message.cancelled ? say('cancelled') : beside ? say('field_refused') :
          message.message) + ' ' + say('last_shape_stays'));
      }
      answer(message.answers);
    });
    Shiny.addCustomMessageHandler('flume_idle', function (message) {
      answer(message.answers);
      want_texts();
    });
    Shiny.addCustomMessageHandler('flume_draft', function (message) {
      find('undo').disabled = !message.undo;
      find('redo').disabled = !message.redo;
      if (message.form) {
        if (window.codendForm.turn() !== message.form.turn) window.codendDrawing.opened();
        window.codendForm.show(message.form);
        window.codendSlopes.form();
        window.codendVary.form();
        window.codendTarget.form();
      }
      window.codendForm.draft(message);
      if (message.settling || message.form) window.codendDrawing.want(true);
      window.codendDesigns.moved();
    });
    Shiny.addCustomMessageHandler('serve_sensitivities', function (message) {
      window.codendSlopes.show(message.fields);
    });
    Shiny.addCustomMessageHandler('flume_varied', window.codendVary.show);
    Shiny.addCustomMessageHandler('flume_target', window.codendTarget.show);
    Shiny.addCustomMessageHandler('flume_tow', function (message) {
      window.codendTow.show(message.scene);
    });
    Shiny.addCustomMessageHandler('flume_offers', window.codendForm.offers);
    Shiny.addCustomMessageHandler('flume_kept', function (message) {
      window.codendDesigns.show(message.kept || []);
    });
    Shiny.addCustomMessageHandler('flume_words', function (message) {
      window.codendDesigns.words(message.words, message.number);
    });
    Shiny.addCustomMessageHandler('flume_own', function (message) {
      window.codendForm.own(message.rows);
    });
    Shiny.addCustomMessageHandler('flume_shared', function (message) {
      window.codendDesigns.shared(message.designs || []);
    });
    Shiny.addCustomMessageHandler('flume_shared_done', function (message) { tell('shared_error', message.none); });
    Shiny.addCustomMessageHandler('flume_clerk', function (message) {
      if (message.busy) window.codendTalk.busy('clerk ' + message.what, say('busy.' + message.what));
      else window.codendTalk.free('clerk ' + message.what);
      if (message.what === 'uncertainty') tell('uncertainty_error', '');
    });
    Shiny.addCustomMessageHandler('flume_drawing', function (message) {
      window.codendDrawing.show(message.svg);
    });
    // Shows the part that was clicked in the tank, without a jump of the page.
    Shiny.addCustomMessageHandler('flume_part', function (message) {
      if (!window.codendForm.open(message.path, true)) return;
      var panel = find('controls'), part = panel.querySelector('.marked');
      panel.scrollTop += part.getBoundingClientRect().top - panel.getBoundingClientRect().top - 60;
      window.codendDrawing.seek(message.path);
    });
    Shiny.addCustomMessageHandler('flume_plan', function (message) {
      find('plan_area').value = message.text;
      tell('plan_text_error', '');
    });
  }

  document.addEventListener('click', function (event) {
    if (event.target.id !== 'save_picture') return;
    var link = document.createElement('a');
    link.href = window.codendTank.viewer().picture(3840, true).toDataURL('image/png');
    link.download = find('gear_name').textContent.toLowerCase().replace(/[^a-z0-9]+/g, '-')
      .replace(/^-|-$/g, '') + '.png';
    link.click();
  });

  document.addEventListener('DOMContentLoaded', function () {
    find('undo').disabled = find('redo').disabled = true;
    var opens = find('flume').classList.contains('opens');
    if (!opens && !/^#d=/.test(window.location.hash)) find('gallery').hidden = false;
    document.addEventListener('shown.bs.tab', want_texts);
    $(document).on('shown.bs.tab', want_texts);
  });
  $(document).on('shiny:connected', function () {
    listen();
    if (window.codendDesigns.read()) find('gear_name').textContent = say('opening_address');
  });
  $(document).on('shiny:disconnected', function () {
    window.codendTalk.stop();
    tell('refused', say('process_ended'));
    tell('gallery_refused', say('process_gone'));
  });

  return {
    tell: tell, gallery: gallery, prefer: prefer, preferred: function () { return units; }
  };
}());
