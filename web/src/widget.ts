// The viewer as an HTML widget.

import { new_viewer, type Scene, type Viewer } from './view';

declare const HTMLWidgets: { widget(widget: object): void };

HTMLWidgets.widget({
  name: 'codend',
  type: 'output',
  factory(el: HTMLElement) {
    let viewer: Viewer | null = null;
    return {
      renderValue(x: { title: boolean; scene: Scene }) {
        viewer = viewer || new_viewer(el, { title: x.title });
        viewer?.show(x.scene);
      },
      resize() {}
    };
  }
});
