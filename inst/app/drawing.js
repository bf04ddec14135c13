// The net drawing in the flume tank: a thing that is clicked opens its fields in the form.
//
// codendDrawing.show(text) shows an SVG; .want() asks for it where its tab is seen, once nothing moves.
window.codendDrawing = (function () {
  'use strict';

  var timer = null, stale = true;
  function find(id) { return document.getElementById(id); }
  function seen() {
    var tab = document.querySelector('#shown .active');
    return tab && tab.dataset.value === 'Drawing';
  }

  function want(moved) {
    if (moved) stale = true;
    window.clearTimeout(timer);
    if (!stale || !seen()) return;
    timer = window.setTimeout(function () {
      if (window.codendTalk.waits()) { want(); return; }
      stale = false;
      window.codendTalk.tell('drawing_wanted', Date.now());
    }, 300);
  }

  // Texts of a plan may be anybody's: nothing in the drawing may run or load.
  function harmless(root) {
    root.querySelectorAll('script, foreignObject, iframe, image, use, animate, set, style, a')
      .forEach(function (one) { one.remove(); });
    [root].concat([].slice.call(root.querySelectorAll('*'))).forEach(function (one) {
      [].slice.call(one.attributes).forEach(function (attribute) {
        if (/^on|href$/i.test(attribute.name)) one.removeAttribute(attribute.name);
      });
    });
    return root;
  }

  function show(text) {
    var found = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    if (found.nodeName !== 'svg') return;
    var svg = document.importNode(harmless(found), true), place = find('drawing');
    svg.removeAttribute('width');
    svg.removeAttribute('height');
    place.textContent = '';
    place.appendChild(svg);
    svg.querySelectorAll('[data-path]').forEach(function (one) {
      one.setAttribute('tabindex', '0');
      one.setAttribute('role', 'button');
      one.setAttribute('aria-label', 'Change ' + one.dataset.path.replace(/[._]/g, ' '));
    });
  }

  function open(target) {
    var thing = target.closest && target.closest('#drawing [data-path]');
    if (!thing) return false;
    document.querySelectorAll('#drawing .chosen').forEach(function (one) {
      one.classList.remove('chosen');
    });
    thing.classList.add('chosen');
    if (!window.codendForm.open(thing.dataset.path)) {
      window.codendPage.tell('refused', 'The form has no field of ' + thing.dataset.path + '.');
    }
    return true;
  }
  document.addEventListener('click', function (event) { open(event.target); });
  document.addEventListener('keydown', function (event) {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    if (event.target.closest && event.target.closest('#drawing [data-path]') && open(event.target)) {
      event.preventDefault();
    }
  });
  return { show: show, want: want };
}());
