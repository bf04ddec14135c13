// Requests of the flume tank's page to R, and the display of pending ones.
//
// `codendTalk`:
//   `ask(name, what, words)` sends a request that has a reply and returns its number.
//   `tell(name, what)` sends a message without a reply.
//   `next(words)` returns the number of an expected reply.
//   `answered(number)` marks a request as complete.
//   `busy(id, words)`, `free(id)` start and end the display of a background task.
//   `waits()` returns true while anything is pending.
window.codendTalk = (function () {
  'use strict';

  var say = window.codendSay, number = 0, pending = {}, shown = null;
  var told = 300;  // ms before a pending request is displayed

  function find(id) { return document.getElementById(id); }

  function oldest() {
    return Object.keys(pending).map(function (key) { return pending[key]; })
      .sort(function (a, b) { return a.since - b.since; })[0];
  }

  function look() {
    var first = oldest();
    if (!first) {
      find('working').hidden = true;
      window.clearInterval(shown);
      shown = null;
      return;
    }
    var passed = performance.now() - first.since;
    find('working').hidden = passed < told;
    find('working_words').textContent = first.words;
    find('working_time').textContent = passed < 2000 ? '' : Math.floor(passed / 1000) + ' s';
  }
  function watch() {
    if (!shown) shown = window.setInterval(look, 150);
  }

  function busy(id, words) {
    pending[id] = { words: words, since: performance.now() };
    watch();
  }
  function free(id) {
    delete pending[id];
    if (!oldest()) look();
  }

  function next(words) {
    number += 1;
    busy(number, words);
    return number;
  }

  document.addEventListener('click', function (event) {
    if (event.target.id !== 'cancel') return;
    Shiny.setInputValue('cancel', Date.now(), { priority: 'event' });
  });

  return {
    next: next,
    ask: function (name, what, words) {
      var mine = next(words || say('settling'));
      Shiny.setInputValue(name, { number: mine, asked: what }, { priority: 'event' });
      return mine;
    },
    tell: function (name, what) { Shiny.setInputValue(name, what, { priority: 'event' }); },
    answered: free,
    busy: busy,
    free: free,
    stop: function () { pending = {}; look(); },
    waits: function () { return !!oldest(); }
  };
}());
