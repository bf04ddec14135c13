// Translations of the flume tank's page, from inst/app/words.csv.
//
// codendSay(key, values) returns the string of a key, with {n} replaced by values.n. Unknown keys
// are returned unchanged. Methods:
//   `field(name)`, `path(path)`, `measure('door spread (m)')`, `unit(unit)` translate names.
//   `sought(paths)` returns the names of fields in all languages, for the search.
//   `bare(text)` returns the text in lower case without accents.
// This file also replaces `codendView.say`, which the viewer uses.
window.codendSay = (function () {
  'use strict';

  // Scripts in the head run before the page exists.
  var given = null;
  function known() {
    given = given || JSON.parse(document.getElementById('words').textContent);
    return given;
  }
  function has(key) { return Object.prototype.hasOwnProperty.call(known().words, key); }

  var fill = window.codendView.say;
  function say(key, values) { return fill(has(key) ? known().words[key] : key, values); }
  window.codendView.say = function (words, values) {
    return has('view.' + words) ? say('view.' + words, values) :
      fill(term('field', words.replace(/ /g, '_')), values);
  };
  function term(family, name) {
    return has(family + '.' + name) ? say(family + '.' + name) : name.replace(/_/g, ' ');
  }

  say.field = function (name) { return term('field', name); };
  say.path = function (path) { return path.split('.').map(say.field).join(' '); };
  say.unit = function (unit) { return has('unit.' + unit) ? say('unit.' + unit) : unit; };
  // Also after the name of a gear in a rig: "port door spread". Empty without a translation.
  function measured(words) {
    var number = words.match(/\d+/), space = words.indexOf(' ');
    var key = 'measure.' + words.replace(/\d+/, '#').replace(/ /g, '_');
    if (has(key)) return say(key).replace('#', number);
    var of_gear = space < 0 ? '' : measured(words.slice(space + 1));
    return of_gear && words.slice(0, space) + ': ' + of_gear;
  }
  say.measure = function (words) {
    var parts = words.match(/^(.*?)( \(.*\))?$/);
    return (measured(parts[1]) || parts[1]) + (parts[2] || '');
  };
  say.bare = function (text) {
    return text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '').replace(/\u00f8/g, 'o')
      .replace(/\u00e6/g, 'ae').trim();
  };
  say.sought = function (paths) {
    return say.bare(paths.split(/[. ]/).map(function (name) { return known().sought[name] || ''; }).join(' '));
  };
  return say;
}());
