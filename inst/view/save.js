// Saves the view: a high-resolution picture (PNG) or a video (WebM) of a turn or of the tow, with
// or without labels.
window.codendView = window.codendView || {};
// `host` is the element of the viewer, `viewer` its functions that are used here.
// `parts` contains:
//   `canvas` of the gear.
//   `words()` returns the elements over the picture.
//   `draw(ratio)` draws the gear with `ratio` pixels per CSS pixel.
//   `name()` returns the file name.
// Methods:
//   `picture(wide, worded)` returns a canvas `wide` pixels wide.
//   `film(kind, seconds, wide, worded)` returns a promise of a Blob.
window.codendView.save = function (host, viewer, parts) {
  'use strict';
  var element = window.codendView.element, say = window.codendView.say, turnSeconds = 12, towSeconds = 20;
  var kinds = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

  // ---- labels as pixels -------------------------------------------------------------------------

  // Draws page elements on a canvas: backgrounds, text, colour strips and legend symbols.
  function draw_words(context, ratio) {
    var frame = host.getBoundingClientRect();
    function box_of(one) {
      var box = one.getBoundingClientRect();
      return { x: box.left - frame.left, y: box.top - frame.top, wide: box.width, tall: box.height };
    }
    function text(node) {
      var of = node.parentElement, style = window.getComputedStyle(of), range = document.createRange();
      range.selectNodeContents(node);
      var box = box_of(range), turn = new DOMMatrix(style.transform);
      context.save();
      context.translate(box.x + box.wide / 2, box.y + box.tall / 2);
      context.transform(turn.a, turn.b, turn.c, turn.d, 0, 0);
      context.font = style.fontWeight + ' ' + style.fontSize + ' ' + style.fontFamily;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      if (style.textShadow !== 'none') {
        context.strokeStyle = '#ffffff';
        context.lineWidth = 3;
        context.strokeText(node.textContent, 0, 0);
      }
      context.fillStyle = style.color;
      context.fillText(node.textContent, 0, 0);
      context.restore();
    }
    function shape(one) {
      var style = window.getComputedStyle(one), box = box_of(one), dashes = one.className === 'slack';
      context.fillStyle = dashes ? style.getPropertyValue('--colour') : style.backgroundColor;
      if (one.className === 'strip') {
        var found = style.backgroundImage.match(/rgba?\([^)]*\)/g);
        context.fillStyle = context.createLinearGradient(box.x, 0, box.x + box.wide, 0);
        found.forEach(function (colour, k) { context.fillStyle.addColorStop(k / (found.length - 1), colour); });
      }
      context.beginPath();
      if (one.className === 'ball') {
        context.arc(box.x + box.wide / 2, box.y + box.tall / 2, box.wide / 2, 0, 2 * Math.PI);
      } else if (dashes) {
        for (var x = 0; x < box.wide; x += 10) context.rect(box.x + x, box.y, Math.min(6, box.wide - x), box.tall);
      } else {
        context.roundRect(box.x, box.y, box.wide, box.tall, parseFloat(style.borderTopLeftRadius) || 0);
      }
      context.fill();
      [
        ['Left', 0, 0, 0, 1], ['Right', 1, 0, 1, 1], ['Top', 0, 0, 1, 0], ['Bottom', 0, 1, 1, 1]
      ].forEach(function (side) {
        var width = parseFloat(style['border' + side[0] + 'Width']);
        if (!width || one.className === 'ball') return;
        context.strokeStyle = style['border' + side[0] + 'Color'];
        context.lineWidth = width;
        context.beginPath();
        context.moveTo(box.x + side[1] * box.wide, box.y + side[2] * box.tall);
        context.lineTo(box.x + side[3] * box.wide, box.y + side[4] * box.tall);
        context.stroke();
      });
    }
    context.save();
    context.scale(ratio, ratio);
    parts.words().forEach(function (part) {
      if (!part.checkVisibility()) return;
      shape(part);
      part.querySelectorAll('.strip, i:not(.arrow)').forEach(shape);
      var walker = document.createTreeWalker(part, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) if (walker.currentNode.textContent.trim()) text(walker.currentNode);
    });
    context.restore();
  }

  function compose(made, worded) {
    var ratio = made.width / host.clientWidth;
    parts.draw(ratio);
    var context = made.getContext('2d');
    context.drawImage(parts.canvas, 0, 0, made.width, made.height);
    if (worded) draw_words(context, ratio);
  }
  function sheet(wide) {
    var made = document.createElement('canvas'), tall = wide * host.clientHeight / host.clientWidth;
    // Videos require even sizes.
    made.width = 2 * Math.round(wide / 2);
    made.height = 2 * Math.round(tall / 2);
    return made;
  }

  function picture(wide, worded) {
    var made = sheet(wide || parts.canvas.width);
    compose(made, worded);
    viewer.release();
    return made;
  }
  // Returns the width of a picture whose longer side has `longer` pixels.
  function across(longer) {
    return Math.round(longer * Math.min(1, host.clientWidth / host.clientHeight));
  }

  // ---- video ------------------------------------------------------------------------------------

  var filming = null;
  function film(kind, seconds, wide, worded) {
    var type = kinds.filter(function (one) { return window.MediaRecorder.isTypeSupported(one); })[0];
    var made = sheet(wide), start = viewer.eye().turn, times = viewer.times(), chunks = [];
    function frame(share) {
      if (kind === 'tow') viewer.seek(times[0] + share * (times[times.length - 1] - times[0]));
      else viewer.look({ turn: start + 2 * Math.PI * share });
      compose(made, worded);
    }
    frame(0);
    var recorder = new window.MediaRecorder(made.captureStream(30), { mimeType: type, videoBitsPerSecond: 16e6 });
    recorder.ondataavailable = function (event) { chunks.push(event.data); };
    filming = recorder;
    return new Promise(function (resolve) {
      var began = null;
      recorder.onstop = function () {
        filming = null;
        if (kind !== 'tow') viewer.look({ turn: start });
        viewer.release();
        resolve(new Blob(chunks, { type: 'video/webm' }));
      };
      function next(clock) {
        if (filming !== recorder) return;
        began = began === null ? clock : began;
        var share = Math.min((clock - began) / (1000 * seconds), 1);
        frame(share);
        tell(say('{n} % is recorded.', { n: Math.round(100 * share) }));
        if (share < 1) window.requestAnimationFrame(next);
        // The delay lets the last frame be recorded.
        else window.setTimeout(function () { if (recorder.state !== 'inactive') recorder.stop(); }, 150);
      }
      recorder.start();
      window.requestAnimationFrame(next);
    });
  }

  // ---- the panel --------------------------------------------------------------------------------

  var panel = element('div', 'view-keys view-save'), said = element('div', 'said', '', { role: 'status' });
  panel.hidden = true;
  var label = element('label', '', ' ' + say('with title and legend'));
  var worded = element('input', '', undefined, { type: 'checkbox' });
  worded.checked = true;
  label.insertBefore(worded, label.firstChild);
  panel.appendChild(label);
  function tell(words) { said.textContent = words; }
  function hand_over(blob, ending) {
    var link = element('a', '', undefined, { download: parts.name() + ending });
    link.href = URL.createObjectURL(blob);
    link.click();
    window.setTimeout(function () { URL.revokeObjectURL(link.href); }, 60000);
    tell(say('Saved.'));
  }
  function save_picture() {
    picture(across(3840), worded.checked).toBlob(function (blob) { hand_over(blob, '.png'); }, 'image/png');
  }
  function save_film(kind) {
    // A second click stops the recording.
    if (filming) { filming.stop(); return; }
    var times = viewer.times(), lasts = kind === 'tow' ?
      Math.min(times[times.length - 1] - times[0], towSeconds) : turnSeconds;
    film(kind, lasts, across(1920), worded.checked).then(function (blob) { hand_over(blob, '.webm'); });
  }
  function button(words, act) {
    var made = element('button', 'view-button', words, { type: 'button' });
    made.addEventListener('click', act);
    panel.appendChild(made);
    return made;
  }
  button(say('Picture (PNG)'), save_picture);
  if (window.MediaRecorder && window.HTMLCanvasElement.prototype.captureStream) {
    button(say('Video of a turn (WebM)'), function () { save_film('turn'); });
    var tow = button(say('Video of the tow (WebM)'), function () { save_film('tow'); });
  }
  panel.appendChild(said);
  var opener = element('button', 'view-button', say('Save'), {
    type: 'button', 'aria-expanded': 'false',
    title: say('{words} (key {key})', { words: say('Save a picture or a video'), key: 's' })
  });
  opener.addEventListener('click', function () {
    panel.hidden = !panel.hidden;
    if (tow) tow.hidden = viewer.times().length < 2;
    opener.setAttribute('aria-expanded', String(!panel.hidden));
  });

  return {
    opener: opener, panel: panel, picture: picture, film: film,
    filming: function () { return filming !== null; },
    close: function () { if (!panel.hidden) opener.click(); }
  };
};
