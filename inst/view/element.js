// Makes elements of a page for the viewer and the tank: codendView.element(name, className, words,
// attributes); attributes that are undefined are left out.
window.codendView = window.codendView || {};
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
