// Graphs of chosen measures.

import { element, file_name, new_graph, save_as, type About, type Graph, type Measured } from '../view';
import { say } from './words';

export interface GraphsAbout extends About {
  // called after each drawing
  drawn?(): void;
}
interface Drawn { graph: Graph; measure: Measured }

// Draws graphs in the element `place`; `select` offers the measures without a graph. first(words)
// returns the default choice. `shown` of a measure is its name in the page's language.
export function new_graphs(
  place: HTMLElement, select: HTMLSelectElement, first: (words: string[]) => string[]
) {
  const about = {} as GraphsAbout;
  let all: Measured[] = [], chosen: string[] = [], drawn: Drawn[] = [];

  function said(one: Measured) { return one.shown || one.words; }

  function figure(measure: Measured) {
    const box = element('figure', 'graph'), head = element('figcaption', '', said(measure));
    const png = element('button', 'link save-graph', 'PNG',
      { type: 'button', 'aria-label': say('save_graph', { words: said(measure) }) });
    const out = element('button', 'take-out', '\u00d7',
      { type: 'button', 'aria-label': say('take_graph', { words: said(measure) }) });
    head.append(png, out);
    box.appendChild(head);
    place.appendChild(box);
    const graph = new_graph(box, about);
    graph.draw(measure);
    png.addEventListener('click', async () => save_as(await graph.png(), file_name(measure.words) + '.png'));
    out.addEventListener('click', () => {
      chosen = chosen.filter((words) => words !== measure.words);
      lay_out();
    });
    drawn.push({ graph, measure });
  }

  function lay_out() {
    place.textContent = '';
    select.replaceChildren(element('option', '', say('which_measure'), { value: '' }));
    drawn = [];
    all.forEach((one) => {
      if (chosen.includes(one.words)) figure(one);
      else select.appendChild(element('option', '', said(one), { value: one.words }));
    });
    about.drawn?.();
  }
  select.addEventListener('change', () => {
    if (!select.value) return;
    chosen.push(select.value);
    lay_out();
  });

  return {
    show(measures: Measured[], what: GraphsAbout) {
      const words = measures.map((one) => one.words), same = words.join() === all.map((one) => one.words).join();
      all = measures;
      Object.assign(about, what);
      if (!same) {
        const kept = chosen.filter((one) => words.includes(one));
        chosen = kept.length ? kept : first(words);
        lay_out();
        return;
      }
      // Graphs are redrawn in place, so that buttons stay under the pointer.
      drawn.forEach((one) => {
        one.measure = measures[words.indexOf(one.measure.words)];
        one.graph.draw(one.measure);
      });
      about.drawn?.();
    },
    mark(time: number) { drawn.forEach(({ graph }) => graph.mark(time)); }
  };
}
