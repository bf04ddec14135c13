// The viewer's bundle, inst/view/viewer.js. It defines `codendView`, which the other bundles use.
export { element, fill, file_name, find, save_as, say, translate_by } from './element';
export { new_graph } from './graph';
export { kept_colour } from './materials';
export { listen_pointers } from './pointers';
export { new_viewer } from './viewer';
export { h, render } from 'preact';
export * from 'preact/jsx-runtime';
export type { Values } from './element';
export type { About, Graph } from './graph';
export type { Measured, Mode, Scales, Scene } from './scene';
export type { KeptScene, Viewer } from './viewer';
