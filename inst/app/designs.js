// Stored designs, undo and redo, and the page address, which encodes all designs.
//
// `codendDesigns`:
//   `open(words)` opens the designs that an address or a file encodes.
//   `read()` opens the designs of the page address and returns false if it has no new ones.
//   `moved()` schedules an update of the address.
//   `words(said, number)` writes R's description of the designs to the address.
//   `show(kept)` lists the stored designs.
//   `shared(designs)` lists the designs of the shared folder.
//   `waits()` returns true while the address is out of date.
window.codendDesigns = (function () {
  'use strict';

  var element = window.codendView.element, say = window.codendSay;
  var timer = null, mine = null, wanted = null, largest = 2 * 1024 * 1024;
  function find(id) { return document.getElementById(id); }

  // ---- the address --------------------------------------------------------------------------------

  function through(bytes, stream) {
    var reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    var parts = [], size = 0;
    function next() {
      return reader.read().then(function (step) {
        if (step.done) return new Blob(parts).arrayBuffer();
        size += step.value.length;
        // A small compressed text can expand to an arbitrary size.
        if (size > largest) { reader.cancel(); throw new RangeError('too long'); }
        parts.push(step.value);
        return next();
      });
    }
    return next();
  }

  function pack(words) {
    return through(new TextEncoder().encode(JSON.stringify(words)), new CompressionStream('deflate-raw'))
      .then(function (bytes) {
        var text = '';
        new Uint8Array(bytes).forEach(function (byte) { text += String.fromCharCode(byte); });
        return btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
      });
  }

  function unpack(text) {
    var plain = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
    var bytes = Uint8Array.from(plain, function (one) { return one.charCodeAt(0); });
    return through(bytes, new DecompressionStream('deflate-raw')).then(function (found) {
      return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(found));
    });
  }

  function read() {
    var found = window.location.hash.match(/^#d=([A-Za-z0-9_-]+)$/);
    if (!found || found[1] === mine) return false;
    mine = found[1];
    unpack(found[1]).then(function (words) { open(words, 'words'); }).catch(function () {
      window.codendPage.gallery(true);
      window.codendPage.tell('gallery_refused', say('no_design_here'));
    });
    return true;
  }
  window.addEventListener('hashchange', read);

  // words: {now, kept: [...], draft, own, units}; missing parts become empty.
  function open(words) {
    if (words && words.units) window.codendPage.prefer(words.units);
    window.codendTalk.ask('words', {
      now: (words && words.now) || {}, kept: (words && Array.isArray(words.kept)) ? words.kept : [],
      draft: (words && words.draft) || {}, own: (words && Array.isArray(words.own)) ? words.own : []
    });
  }

  function moved() {
    window.clearTimeout(timer);
    timer = window.setTimeout(function () {
      if (window.codendTalk.waits()) { moved(); return; }
      timer = null;
      wanted = Date.now();
      window.codendTalk.tell('words_wanted', wanted);
    }, 600);
  }

  // `said` is null without a design.
  function words(said, number) {
    if (said) said.units = window.codendPage.preferred();
    (said ? pack(said) : Promise.resolve(null)).then(function (text) {
      if (text) {
        mine = text;
        window.history.replaceState(null, '', '#d=' + text);
      }
      if (number === wanted) wanted = null;
    });
  }

  // ---- steps --------------------------------------------------------------------------------------

  function step(name) {
    if (!find(name).disabled) window.codendTalk.ask(name, 1);
  }
  document.addEventListener('click', function (event) {
    var id = event.target.id;
    if (id === 'undo' || id === 'redo') step(id);
    else if (id === 'keep') window.codendTalk.tell('keep', { number: Date.now() });
    else if (id === 'back') act(first, 'open');
  });
  document.addEventListener('keydown', function (event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    // Text fields have their own undo.
    if (/^(text|search)$/.test(event.target.type) || event.target.tagName === 'TEXTAREA') return;
    var key = event.key.toLowerCase();
    var name = key === 'z' ? (event.shiftKey ? 'redo' : 'undo') : key === 'y' ? 'redo' : null;
    if (!name) return;
    event.preventDefault();
    step(name);
  });

  // ---- stored designs -----------------------------------------------------------------------------

  var first = null;
  function act(id, what, name) {
    if (id === null) return;
    if (what === 'open') {
      Shiny.setInputValue('kept', { number: window.codendTalk.next('settling'), id: id, act: what },
        { priority: 'event' });
    } else {
      window.codendTalk.tell('kept', { number: Date.now(), id: id, act: what, name: name });
    }
  }

  function show(kept) {
    var place = find('kept_designs');
    place.textContent = '';
    first = kept.length ? kept[0].id : null;
    var seen = 0;
    kept.forEach(function (one, k) {
      var row = element('div', 'kept-row'), tick = element('input', 'form-check-input', undefined,
        { type: 'checkbox', 'aria-label': say('in_picture_of', { name: one.name }), title: say('in_picture') });
      tick.checked = one.seen;
      tick.addEventListener('change', function () { act(one.id, tick.checked ? 'show' : 'hide'); });
      row.appendChild(tick);
      var colour = element('span', 'kept-colour');
      if (one.seen) colour.style.background = window.codendView.kept_colour(seen++);
      row.appendChild(colour);
      var name = element('input', 'form-control form-control-sm', undefined,
        { type: 'text', 'aria-label': say('kept_name'), maxlength: 60 });
      name.value = one.name;
      name.addEventListener('change', function () { act(one.id, 'rename', name.value); });
      row.appendChild(name);
      [['open', say('put_on_screen')], ['compare', k ? say('compare_with') : say('compared_with')],
        ['remove', say('remove')]].forEach(function (each) {
        var button = element('button', 'btn btn-outline-secondary btn-sm', each[1],
          { type: 'button', 'aria-label': say('of_design', { act: each[1], name: one.name }) });
        button.disabled = each[0] === 'compare' && k === 0 || each[0] === 'remove' && kept.length === 1;
        button.addEventListener('click', function () { act(one.id, each[0]); });
        row.appendChild(button);
      });
      place.appendChild(row);
    });
    moved();
  }

  // ---- the shared folder --------------------------------------------------------------------------

  // A random key of this browser. The server lets only this browser change its shared designs.
  function key() {
    var kept = localStorage.getItem('codend-key');
    if (!kept) {
      kept = Array.from(crypto.getRandomValues(new Uint8Array(16)), function (byte) {
        return byte.toString(16).padStart(2, '0');
      }).join('');
      localStorage.setItem('codend-key', kept);
    }
    return kept;
  }
  function share(what, name, author) {
    window.codendPage.tell('shared_error', '');
    window.codendTalk.tell('shared', { number: Date.now(), act: what, name: name, author: author,
      key: key() });
  }
  function shared(designs) {
    document.querySelectorAll('.shared-list').forEach(function (list) {
      list.textContent = '';
      if (!designs.length) list.appendChild(element('li', 'note', say('shared_none')));
      designs.forEach(function (one) {
        var item = element('li'), its = { name: one.name + ', ' + one.author };
        function button(key, act) {
          var made = element('button', 'btn btn-outline-secondary btn-sm', say(key),
            { type: 'button', 'aria-label': say('of_design', { act: say(key), name: its.name }) });
          made.addEventListener('click', act);
          item.appendChild(made);
        }
        item.appendChild(element('span', '', one.name));
        item.appendChild(element('span', 'note', one.author + ', ' + one.changed));
        button('open_copy', function () {
          window.codendTalk.ask('shared_open', { author: one.author, name: one.name });
        });
        // Only this panel shows errors of a removal.
        if (list.closest('#shared')) {
          button('remove', function () { share('take_out', one.name, one.author); });
        }
        list.appendChild(item);
      });
    });
  }
  document.addEventListener('click', function (event) {
    if (event.target.id === 'shared_put') {
      share('put', find('shared_name').value, find('shared_author').value);
    }
  });

  return {
    open: open, read: read, moved: moved, words: words, show: show, shared: shared,
    waits: function () { return timer !== null || wanted !== null; }
  };
}());
