// codendView.element(name, className, words, attributes) returns a new HTML element. Undefined
// attributes are omitted.
window.codendView = window.codendView || {};
// `codendView.say(words, values)` returns the displayed string for English words, with {n} replaced
// by values.n. inst/app/words.js replaces it by a translation.
window.codendView.say = function (words, values) {
  'use strict';
  return words.replace(/\{(\w+)\}/g, function (place, name) {
    return values && values[name] !== undefined ? values[name] : place;
  });
};
window.codendView.element = function (name, className, words, attributes) {
  'use strict';
  var made = document.createElement(name);
  if (className) made.className = className;
  if (words !== undefined) made.textContent = words;
  Object.keys(attributes || {}).forEach(function (key) {
    if (attributes[key] !== undefined) made.setAttribute(key, attributes[key]);
  });
  return made;
};
