// Names and values of the part under the pointer.

import { say } from './element';
import type { Gear } from './gear';

export type Found = { kind: 'mark' | 'netting'; number: number } | { kind: 'rope'; number: number; share: number };

// Returns a number with three digits.
export function three(x: number) {
  if (!isFinite(x)) return '';
  return String(Number(x.toPrecision(3)));
}
function force(newtons: number) {
  return Math.abs(newtons) >= 1000 ? three(newtons / 1000) + ' kN' : three(newtons) + ' N';
}
function thick(metres: number) { return three(1000 * metres) + ' mm'; }
function plain(name: string) { return String(name).replace(/_/g, ' '); }

// Returns the name and the values of a part.
export function described(gear: Gear, found: Found) {
  const { told } = gear, parts = told.parts, k = found.number;
  const rows: [string, string][] = [];
  let heading, note, z;
  function row(name: string, value: string) { if (value) rows.push([name, value]); }
  if (found.kind === 'mark') {
    const marks = told.marks;
    heading = plain(marks.part[k]);
    note = say(marks.label[k]);
    row(say('depth'), three(-gear.at[3 * k + 2]) + ' m');
  } else if (found.kind === 'rope') {
    const part = gear.ropes.part[k], tension = gear.rope_tension[k];
    heading = plain(parts.name[part]);
    const seam = parts.kind[part] === 'netting';
    note = seam ? say('seam') : say(plain(parts.role[part] || 'rope'));
    row(say('tension'), tension > 0 ? force(tension) :
      tension < 0 ? say('compression {force}', { force: force(-tension) }) :
      say('slack'));
    if (tension > 0 && parts.strength[part]) {
      row(say('of breaking load'), three(100 * tension / parts.strength[part]) + ' %');
    }
    if (parts.thickness[part]) row(say('diameter'), thick(parts.thickness[part]));
    if (gear.drag[part] && !seam) row(say('drag'), three(gear.drag[part]) + ' N/m');
    const a = gear.ropes.ends[2 * k], b = gear.ropes.ends[2 * k + 1];
    z = gear.points[3 * a + 2] + found.share * (gear.points[3 * b + 2] - gear.points[3 * a + 2]);
    row(say('depth'), three(-z) + ' m');
  } else {
    const of = gear.netting.part[k], meshes = gear.meshes(k);
    heading = plain(parts.name[of]);
    note = say('netting, {mesh} meshes, {twine} twine',
      { mesh: thick(parts.mesh[of]), twine: thick(parts.thickness[of]) });
    const { u, v } = gear.netting;
    row(say('twine one way'), u[k] > 0 ? force(u[k]) : say('slack'));
    row(say('the other way'), v[k] > 0 ? force(v[k]) : say('slack'));
    if (isFinite(meshes.opening)) {
      row(say('mesh opening'), three(meshes.opening) + ' %');
      row(say('mesh angle'), three(meshes.angle) + '\u00b0');
    }
    if (gear.drag[of]) row(say('drag'), three(gear.drag[of]) + ' N/m\u00b2');
    z = [0, 1, 2].reduce((sum, c) => sum + gear.points[3 * gear.netting.point[3 * k + c] + 2] / 3, 0);
    row(say('depth'), three(-z) + ' m');
  }
  return { heading, note, rows };
}
