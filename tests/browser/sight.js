// Checks the legibility of a page from its computed styles: contrast as WCAG 2.2 defines it.
'use strict';

// Runs in a page. Returns the items with too little contrast, as strings. Text needs 4.5 to 1;
// lines of plots and edges of inputs and buttons need 3 to 1. Disabled items are skipped. Over a
// picture or a gradient, the worst colour counts.
function faint() {
  const parse = (text) => {
    const found = /^rgba?\(([^)]*)\)$/.exec(text);
    if (!found) return null;
    const part = found[1].split(/[\s,/]+/).map(Number);
    return { rgb: part.slice(0, 3), alpha: part.length > 3 ? part[3] : 1 };
  };
  const over = (top, below) => top.rgb.map((v, k) => top.alpha * v + (1 - top.alpha) * below[k]);
  const light = (rgb) => {
    const linear = rgb.map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  const contrast = (a, b) => {
    const [low, high] = [light(a), light(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  const shown = (e) => e.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
    e.getBoundingClientRect().width > 1 && e.getBoundingClientRect().height > 1;
  const asleep = (e) => e.closest(':disabled, [aria-disabled="true"], .disabled');
  // The possible colours behind an element.
  const behind = (element) => {
    const layers = [];
    let grounds = null;
    for (let e = element; e && !grounds; e = e.parentElement) {
      const style = getComputedStyle(e), colour = parse(style.backgroundColor);
      const stops = /gradient/.test(style.backgroundImage) ?
        (style.backgroundImage.match(/rgba?\([^)]*\)/g) || []).map((c) => parse(c).rgb) : [];
      if (stops.length) grounds = stops;
      else if (colour && colour.alpha === 1) grounds = [colour.rgb];
      else if (colour && colour.alpha > 0) layers.push(colour);
    }
    grounds = grounds || [[255, 255, 255]];
    // anything may lie over the picture, also dark gear
    if (element.closest('.codend-view') && layers.length) grounds = grounds.concat([[40, 40, 60], [198, 83, 0]]);
    return grounds.map((ground) => layers.reduceRight((below, layer) => over(layer, below), ground));
  };
  const worst = (colour, grounds) => Math.min(...grounds.map((g) => contrast(over(colour, g), g)));
  const found = new Set();
  const tell = (e, what, ratio, least) => {
    if (ratio >= least) return;
    const name = e.tagName.toLowerCase() + (e.id ? '#' + e.id : '') +
      (typeof e.className === 'string' && e.className ? '.' + e.className.trim().split(/\s+/).join('.') : '');
    found.add(`${what} ${name} ${ratio.toFixed(2)}: ${(e.textContent || '').trim().slice(0, 30)}`);
  };
  let asked = 0;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const e = node.parentElement;
    if (!node.textContent.trim() || /^(script|style|option|title|desc|noscript)$/i.test(e.tagName) || !shown(e) ||
      asleep(e) || e.closest('.skip-link')) continue;
    const style = getComputedStyle(e), svg = e.closest('svg');
    const grounds = svg ? behind(svg).concat([...svg.querySelectorAll('polygon, path, rect, circle')]
      .map((s) => parse(getComputedStyle(s).fill)).filter((c) => c && c.alpha === 1 && light(c.rgb) > 0.5)
      .map((c) => c.rgb)) : behind(e);
    tell(e, 'words', worst(parse(svg && e.closest('text') ? style.fill : style.color), grounds), 4.5);
    asked += 1;
  }
  document.querySelectorAll('input, select, textarea').forEach((e) => {
    if (!shown(e) || asleep(e) || /^(range|hidden|file)$/.test(e.type)) return;
    const style = getComputedStyle(e), ground = behind(e.parentElement);
    if (e.value) tell(e, 'words', worst(parse(style.color), behind(e)), 4.5);
    const edge = worst(parse(style.borderTopColor), ground);
    const body = worst(parse(style.backgroundColor), ground);
    tell(e, 'edge', Math.max(edge, body, e.closest('.codend-view') && style.borderTopWidth === '0px' ? 3 : 0), 3);
    asked += 1;
  });
  document.querySelectorAll('button').forEach((e) => {
    if (!shown(e) || asleep(e)) return;
    const style = getComputedStyle(e), ground = behind(e.parentElement);
    // the label alone is enough for a button
    if (style.borderTopWidth === '0px' || parse(style.borderTopColor).alpha === 0) return;
    tell(e, 'edge', Math.max(worst(parse(style.borderTopColor), ground), worst(parse(style.backgroundColor), ground)), 3);
  });
  document.querySelectorAll('svg').forEach((svg) => {
    if (!shown(svg)) return;
    const grounds = behind(svg);
    svg.querySelectorAll('path, line, polyline, polygon, circle, rect').forEach((e) => {
      if (e.closest('.grid') || e.closest('defs')) return;
      const style = getComputedStyle(e), stroke = parse(style.stroke), fill = parse(style.fill);
      if (!stroke || !stroke.alpha || style.strokeWidth === '0px') return;
      tell(e, 'line', Math.max(worst(stroke, grounds), 0), 3);
      asked += 1;
    });
  });
  return { asked, found: [...found] };
}

module.exports = { faint };
