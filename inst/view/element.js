// Makes elements of a page for the viewer and the tank: codendView.element(name, className, words,
// attributes); attributes that are undefined are left out.
window.codendView = window.codendView || {};
// codendView.say(words, values) is what a page says for English words, {n} filled by the value n: the words
// themselves, unless the page has others (inst/app/words.js).
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
