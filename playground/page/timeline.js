// SPDX-License-Identifier: MIT
// All events of a course, a row for each structure: where the ticks stand close, much has to be repaired.

const KIND_COLOURS = { push: "--push", stab: "--stab", roll: "--roll" };

class Timeline {
  constructor(canvas, core, seek) {
    this.canvas = canvas;
    this.core = core;
    canvas.addEventListener("pointerdown", (event) => {
      const box = canvas.getBoundingClientRect();
      seek(Math.min(1, Math.max(0, (event.clientX - box.left - this.left) / (box.width - this.left - 8))));
    });
    this.left = 8;
  }

  /** After a new course, or in a new size or theme: the ticks, drawn once. */
  read() {
    const core = this.core, names = new Map(core.kinds.map((k) => [k.kind, k.name]));
    this.rows = [];
    for (let i = 0; i < core.plain("follower_count"); i++) {
      const marks = core.marks(i), ticks = [];
      for (let k = 0; k < marks.length; k += 2) ticks.push([marks[k], names.get(marks[k + 1])]);
      this.rows.push({ name: core.structures[core.call("follower_structure", i)].name, ticks });
    }
    this.canvas.setAttribute("aria-label", "Time line of events: " + this.rows.map((r) => `${r.name} ${r.ticks.length}`).join(", "));
    this.back = null;
  }

  paint(width, height, dots) {
    const back = this.back = document.createElement("canvas"), g = back.getContext("2d");
    [back.width, back.height] = [width * dots, height * dots];
    g.scale(dots, dots);
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
    g.font = '12px system-ui, "DejaVu Sans", sans-serif';
    const until = this.core.call("until"), rowHeight = height / this.rows.length;
    this.rows.forEach((row, i) => {
      const top = i * rowHeight;
      g.fillStyle = colour("--soft");
      g.fillText(`${row.name}: ${row.ticks.length}${row.ticks.length >= 4096 ? " or more" : ""}`, this.left, top + 12);
      g.strokeStyle = colour("--line");
      g.strokeRect(this.left, top + 16.5, width - this.left - 8, rowHeight - 19);
      for (const [time, kind] of row.ticks) {
        g.fillStyle = colour(KIND_COLOURS[kind] || "--other");
        g.fillRect(this.left + (time / until) * (width - this.left - 8) - 0.6, top + 17, 1.2, rowHeight - 20);
      }
    });
  }

  draw() {
    const box = this.canvas.getBoundingClientRect(), dots = Math.min(window.devicePixelRatio || 1, 2);
    if (!this.rows || box.width < 40) return;
    const [w, h] = [Math.round(box.width), Math.round(box.height)];
    if (!this.back || this.canvas.width !== w * dots || this.canvas.height !== h * dots) {
      [this.canvas.width, this.canvas.height] = [w * dots, h * dots];
      this.paint(w, h, dots);
    }
    const g = this.canvas.getContext("2d");
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.clearRect(0, 0, this.canvas.width, this.canvas.height);
    g.drawImage(this.back, 0, 0);
    g.setTransform(dots, 0, 0, dots, 0, 0);
    const x = this.left + (this.core.call("time") / this.core.call("until")) * (w - this.left - 8);
    g.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--ink").trim();
    g.fillRect(x - 1, 14, 2, h - 14);
  }
}
