// SPDX-License-Identifier: MIT
// Draws displays (playground/display.h) on a canvas.

const MARKS = { AREA: 0, PATH: 1, DOT: 2, RING: 3, LABEL: 4 };
// In the order of play_ink: name, fill, stroke, width, dashes; colours are the style sheet's.
const INKS = [
  ["a", "--a-fill", "--a", 2],
  ["b", "--b-fill", "--b", 2],
  ["envelope-a", null, "--a", 1.5, [6, 4]],
  ["envelope-b", null, "--b", 1.5, [6, 4]],
  ["level-a", null, "--faint", 1],
  ["level-b", null, "--faint", 1],
  ["line", null, "--certificate", 3],
  ["old-line", null, "--event", 2, [3, 5]],
  ["watched", "--watched", "--watched", 2],
  ["window", null, "--watched", 1.5, [2, 3]],
  ["event", "--event", "--event", 3],
  ["contact", "--contact", "--contact", 3],
  ["triangle-a", "--a-fill", "--a", 0.8],
  ["triangle-b", "--b-fill", "--b", 0.8],
  ["parallelogram", "--cell-fill", "--cell", 0.8],
  ["sum", "--sum", "--soft", 1.5],
  ["cell", "--event-fill", "--chosen", 3],
  ["point", "--chosen", "--chosen", 2],
  ["box", null, "--soft", 2],
  ["grid", null, "--faint", 1],
  ["candidate", null, "--faint", 1],
  ["near", null, "--certificate", 2],
  ["sketch", "--event", "--event", 2],
];

/** The middle of the box around points. */
function middleOf(points) {
  let [lx, ly, hx, hy] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 2) {
    lx = Math.min(lx, points[i]);
    hx = Math.max(hx, points[i]);
    ly = Math.min(ly, points[i + 1]);
    hy = Math.max(hy, points[i + 1]);
  }
  return [(lx + hx) / 2, (ly + hy) / 2];
}

class Picture {
  /** `reserve`: a column on the right, in dots, where other things stand. */
  constructor(canvas, labelOf, reserve = 0) {
    this.reserve = reserve;
    this.canvas = canvas;
    this.labelOf = labelOf;
    this.frame = [-1, -1, 1, 1];
    this.zoom = 1;
    this.focus = null;
    this.shift = [0, 0];
    this.readColours();
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => name && style.getPropertyValue(name).trim();
    this.inks = INKS.map(([, fill, stroke, width, dashes]) => ({ fill: colour(fill), stroke: colour(stroke), width, dashes: dashes || [] }));
    this.ground = colour("--scene");
  }

  /** The canvas has as many dots as the screen shows. */
  fit() {
    const box = this.canvas.getBoundingClientRect(), dots = Math.min(window.devicePixelRatio || 1, 2);
    this.width = Math.max(1, box.width);
    this.height = Math.max(1, box.height);
    const w = Math.round(this.width * dots), h = Math.round(this.height * dots);
    if (this.canvas.width !== w || this.canvas.height !== h) [this.canvas.width, this.canvas.height] = [w, h];
    this.dots = dots;
    const [lx, ly, hx, hy] = this.frame;
    this.scale = this.zoom * Math.min((this.width - this.reserve) / (hx - lx), this.height / (hy - ly));
    const middle = [(lx + hx) / 2, (ly + hy) / 2];
    const at = this.zoom > 1 && this.focus ? this.focus : middle;
    this.origin = [(this.width - this.reserve) / 2 - at[0] * this.scale, this.height / 2 + at[1] * this.scale];
  }
  toScreen(x, y) { return [this.origin[0] + x * this.scale, this.origin[1] - y * this.scale]; }
  toWorld(px, py) { return [(px - this.origin[0]) / this.scale, (this.origin[1] - py) / this.scale]; }

  draw(numbers) {
    this.fit();
    const g = this.canvas.getContext("2d");
    g.setTransform(this.dots, 0, 0, this.dots, 0, 0);
    g.fillStyle = this.ground;
    g.fillRect(0, 0, this.width, this.height);
    g.lineJoin = g.lineCap = "round";
    this.watched = null;
    this.taken = (this.knobs || []).slice(); // where a label should not lie
    for (let i = 0; i < numbers.length;) {
      const [mark, ink, strength, label, count] = numbers.subarray(i, i + 5);
      const points = numbers.subarray(i + 5, i + 5 + 2 * count);
      this.item(g, mark, ink, strength, label, points);
      const name = INKS[ink][0];
      if (name === "watched" && mark === MARKS.DOT && !this.watched) this.watched = [points[0], points[1]];
      if ((name === "a" || name === "b") && mark === MARKS.AREA) this.taken.push(middleOf(points));
      if (name === "watched" && mark === MARKS.DOT) this.taken.push([points[0], points[1]]);
      i += 5 + 2 * count;
    }
    g.globalAlpha = 1;
  }

  /** From a body to the knob that turns it. */
  stalk(from, to, ink) {
    const g = this.canvas.getContext("2d"), style = this.inks[ink];
    g.globalAlpha = 0.5;
    g.setLineDash([]);
    g.lineWidth = 1.5;
    g.strokeStyle = style.stroke;
    g.beginPath();
    g.moveTo(...from);
    g.lineTo(...to);
    g.stroke();
    g.globalAlpha = 1;
  }

  item(g, mark, ink, strength, label, points) {
    const style = this.inks[ink];
    g.globalAlpha = mark === MARKS.RING || INKS[ink][0] === "old-line" ? strength : 1;
    g.lineWidth = style.width;
    g.setLineDash(style.dashes);
    g.strokeStyle = style.stroke;
    g.fillStyle = style.fill || style.stroke;
    if (mark === MARKS.AREA || mark === MARKS.PATH) {
      g.beginPath();
      for (let k = 0; k < points.length; k += 2) g.lineTo(...this.toScreen(points[k], points[k + 1]));
      if (mark === MARKS.AREA) g.closePath();
      if (mark === MARKS.AREA && style.fill) g.fill();
      g.stroke();
      return;
    }
    for (let k = 0; k < points.length; k += 2) {
      const [x, y] = this.toScreen(points[k], points[k + 1]);
      if (mark === MARKS.LABEL && (x < -30 || y < -30 || x > this.width + 30 || y > this.height + 30)) continue;
      if (mark === MARKS.LABEL) this.label(g, style, this.labelOf(label), x, y, INKS[ink][0]);
      else {
        g.beginPath();
        g.arc(x, y, mark === MARKS.DOT ? 4 : 8 + 18 * (1 - strength), 0, 2 * Math.PI);
        if (mark === MARKS.DOT) g.fill();
        else g.stroke();
      }
    }
  }

  /** Left end and middle height of a label beside a point: of four places the one farthest from what is there. */
  freePlace(x, y, width) {
    const places = [[x + 20, y - 22], [x - 20 - width, y - 22], [x + 20, y + 22], [x - 20 - width, y + 22]].map(([left, top]) =>
      [Math.min(Math.max(left, 6), this.width - width - 54), Math.min(Math.max(top, 16), this.height - 16)]);
    const clearance = ([left, top]) => Math.min(Infinity, ...this.taken.map(([wx, wy]) => {
      const [px, py] = this.toScreen(wx, wy);
      return Math.hypot(left + width / 2 - px, top - py);
    }));
    return places.reduce((best, place) => (clearance(place) > clearance(best) ? place : best));
  }

  /** Names of bodies in their middle; of events beside the point, on a plate, and inside of the picture. */
  label(g, style, text, x, y, ink) {
    const event = ink === "event" || ink === "contact" || ink === "point";
    g.font = `600 ${event ? 15 : 17}px system-ui, "DejaVu Sans", sans-serif`;
    g.textBaseline = "middle";
    const width = g.measureText(text).width;
    if (!event) {
      g.textAlign = "center";
      g.fillStyle = style.stroke;
      g.fillText(text, x, y);
      return;
    }
    const [left, top] = this.freePlace(x, y, width + 12);
    g.globalAlpha = 1;
    g.setLineDash([]);
    g.beginPath();
    g.rect(left, top - 12, width + 12, 24);
    g.fillStyle = this.ground;
    g.fill();
    g.lineWidth = 1.5;
    g.stroke();
    g.textAlign = "left";
    g.fillStyle = style.stroke;
    g.fillText(text, left + 6, top + 1);
  }
}
