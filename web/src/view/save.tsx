import { render } from 'preact';
import { element, save_as, say } from './element';

// Saves the view: a high-resolution picture (PNG) or a video (WebM) of a turn or of the tow, with
// or without labels.

// functions of the viewer that are used here
interface Filmed {
  turn(): number;
  times(): number[];
  seek(time: number): void;
  look(place: { turn: number }): void;
  release(): void;
}
interface Parts {
  canvas: HTMLCanvasElement;
  // Returns the elements over the picture.
  words(): Element[];
  // Draws the gear with `ratio` pixels per CSS pixel.
  draw(ratio: number): void;
  // Returns the file name.
  name(): string;
}

// host: element of the viewer. Methods: picture(wide, worded) returns a canvas `wide` pixels wide, and
// film(kind, seconds, wide, worded) a promise of a Blob.
export function new_saver(host: HTMLElement, viewer: Filmed, parts: Parts) {
  const turnSeconds = 12, towSeconds = 20, fewestFrames = 24;
  const kinds = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

  // ---- labels as pixels -------------------------------------------------------------------------

  // Draws page elements on a canvas: backgrounds, text, colour strips and legend symbols.
  function draw_words(context: CanvasRenderingContext2D, ratio: number) {
    const frame = host.getBoundingClientRect();
    function box_of(one: Element | globalThis.Range) {
      const box = one.getBoundingClientRect();
      return { x: box.left - frame.left, y: box.top - frame.top, wide: box.width, tall: box.height };
    }
    function text(node: Node) {
      const words = node.textContent ?? '', style = window.getComputedStyle(node.parentElement as Element);
      const range = document.createRange();
      range.selectNodeContents(node);
      const box = box_of(range), turn = new DOMMatrix(style.transform);
      context.save();
      context.translate(box.x + box.wide / 2, box.y + box.tall / 2);
      context.transform(turn.a, turn.b, turn.c, turn.d, 0, 0);
      context.font = style.fontWeight + ' ' + style.fontSize + ' ' + style.fontFamily;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      if (style.textShadow !== 'none') {
        context.strokeStyle = '#ffffff';
        context.lineWidth = 3;
        context.strokeText(words, 0, 0);
      }
      context.fillStyle = style.color;
      context.fillText(words, 0, 0);
      context.restore();
    }
    function shape(one: Element) {
      const style = window.getComputedStyle(one), box = box_of(one), dashes = one.className === 'slack';
      context.fillStyle = dashes ? style.getPropertyValue('--colour') : style.backgroundColor;
      if (one.className === 'strip') {
        const found = style.backgroundImage.match(/rgba?\([^)]*\)/g) ?? [];
        const strip = context.createLinearGradient(box.x, 0, box.x + box.wide, 0);
        found.forEach((colour, k) => { strip.addColorStop(k / (found.length - 1), colour); });
        context.fillStyle = strip;
      }
      context.beginPath();
      if (one.className === 'ball') {
        context.arc(box.x + box.wide / 2, box.y + box.tall / 2, box.wide / 2, 0, 2 * Math.PI);
      } else if (dashes) {
        for (let x = 0; x < box.wide; x += 10) context.rect(box.x + x, box.y, Math.min(6, box.wide - x), box.tall);
      } else {
        context.roundRect(box.x, box.y, box.wide, box.tall, parseFloat(style.borderTopLeftRadius) || 0);
      }
      context.fill();
      const sides: [string, number, number, number, number][] = [
        ['left', 0, 0, 0, 1], ['right', 1, 0, 1, 1], ['top', 0, 0, 1, 0], ['bottom', 0, 1, 1, 1]
      ];
      sides.forEach(([side, x, y, to_x, to_y]) => {
        const width = parseFloat(style.getPropertyValue(`border-${side}-width`));
        if (!width || one.className === 'ball') return;
        context.strokeStyle = style.getPropertyValue(`border-${side}-color`);
        context.lineWidth = width;
        context.beginPath();
        context.moveTo(box.x + x * box.wide, box.y + y * box.tall);
        context.lineTo(box.x + to_x * box.wide, box.y + to_y * box.tall);
        context.stroke();
      });
    }
    context.save();
    context.scale(ratio, ratio);
    parts.words().forEach((part) => {
      if (!part.checkVisibility()) return;
      shape(part);
      part.querySelectorAll('.strip, i:not(.arrow)').forEach(shape);
      const walker = document.createTreeWalker(part, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) if (walker.currentNode.textContent?.trim()) text(walker.currentNode);
    });
    context.restore();
  }

  function compose(made: HTMLCanvasElement, worded: boolean) {
    const ratio = made.width / host.clientWidth;
    parts.draw(ratio);
    const context = made.getContext('2d') as CanvasRenderingContext2D;
    context.drawImage(parts.canvas, 0, 0, made.width, made.height);
    if (worded) draw_words(context, ratio);
  }
  function sheet(wide: number) {
    const made = document.createElement('canvas'), tall = wide * host.clientHeight / host.clientWidth;
    // Videos require even sizes.
    made.width = 2 * Math.round(wide / 2);
    made.height = 2 * Math.round(tall / 2);
    return made;
  }

  function picture(wide = 0, worded = false) {
    const made = sheet(wide || parts.canvas.width);
    compose(made, worded);
    viewer.release();
    return made;
  }
  // Returns the width of a picture whose longer side has `longer` pixels.
  function across(longer: number) {
    return Math.round(longer * Math.min(1, host.clientWidth / host.clientHeight));
  }

  // ---- video ------------------------------------------------------------------------------------

  let filming: MediaRecorder | null = null;
  function film(kind: string, seconds: number, wide: number, worded: boolean): Promise<Blob> {
    const type = kinds.filter((one) => window.MediaRecorder.isTypeSupported(one))[0];
    const made = sheet(wide), start = viewer.turn(), times = viewer.times(), chunks: Blob[] = [];
    function frame(share: number) {
      if (kind === 'tow') viewer.seek(times[0] + share * (times[times.length - 1] - times[0]));
      else viewer.look({ turn: start + 2 * Math.PI * share });
      compose(made, worded);
    }
    frame(0);
    const recorder = new window.MediaRecorder(made.captureStream(30), { mimeType: type, videoBitsPerSecond: 16e6 });
    recorder.ondataavailable = (event) => { chunks.push(event.data); };
    filming = recorder;
    return new Promise((resolve) => {
      let share = 0, before: number | null = null;
      recorder.onstop = () => {
        filming = null;
        if (kind !== 'tow') viewer.look({ turn: start });
        viewer.release();
        resolve(new Blob(chunks, { type: 'video/webm' }));
      };
      function next(clock: number) {
        if (filming !== recorder) return;
        // A slow computer draws few frames per second: it records a longer video, not fewer frames.
        share = Math.min(share + Math.min((clock - (before ?? clock)) / (1000 * seconds), 1 / fewestFrames), 1);
        before = clock;
        frame(share);
        tell(say('{n} % is recorded.', { n: Math.round(100 * share) }));
        if (share < 1) window.requestAnimationFrame(next);
        // The delay lets the last frame be recorded.
        else window.setTimeout(() => { if (recorder.state !== 'inactive') recorder.stop(); }, 150);
      }
      recorder.start();
      window.requestAnimationFrame(next);
    });
  }

  // ---- the panel --------------------------------------------------------------------------------

  const panel = host.appendChild(element('div', 'view-keys view-save'));
  const films = 'MediaRecorder' in window && 'captureStream' in HTMLCanvasElement.prototype;
  let worded = true;
  panel.hidden = true;
  function tell(words: string) {
    const Act = ({ words, act }: { words: string; act: () => void }) =>
      <button type="button" class="view-button" onClick={act}>{words}</button>;
    render([
      <label><input type="checkbox" checked={worded} onChange={(event) => { worded = event.currentTarget.checked; }} />
        {' ' + say('with title and legend')}</label>,
      <Act words={say('Picture (PNG)')} act={save_picture} />,
      films && <Act words={say('Video of a turn (WebM)')} act={() => save_film('turn')} />,
      films && viewer.times().length > 1 &&
        <Act words={say('Video of the tow (WebM)')} act={() => save_film('tow')} />,
      <div class="said" role="status">{words}</div>
    ], panel);
  }
  function hand_over(blob: Blob, ending: string) {
    save_as(blob, parts.name() + ending);
    tell(say('Saved.'));
  }
  function save_picture() {
    picture(across(3840), worded).toBlob((blob) => { hand_over(blob as Blob, '.png'); }, 'image/png');
  }
  function save_film(kind: string) {
    // A second click stops the recording.
    if (filming) { filming.stop(); return; }
    const times = viewer.times(), lasts = kind === 'tow' ?
      Math.min(times[times.length - 1] - times[0], towSeconds) : turnSeconds;
    film(kind, lasts, across(1920), worded).then((blob) => { hand_over(blob, '.webm'); });
  }
  return {
    panel, picture, film,
    filming() { return filming !== null; },
    toggle() {
      panel.hidden = !panel.hidden;
      if (!panel.hidden) tell('');
    }
  };
}
