// SPDX-License-Identifier: MIT
// How the number of events grows with D/sigma: the chosen motion at twenty ratios, each structure a curve on logarithmic axes.

const RATIOS = Array.from({ length: 20 }, (_, i) => i + 1); // powers of two
const CURVES = ["--certificate", "--a", "--b", "--watched"];

class Growth {
  constructor(core, canvas) {
    this.core = core;
    this.canvas = canvas;
    this.other = null;
    this.stop();
  }

  /** Forgets what was measured: another motion is chosen. */
  stop() {
    clearTimeout(this.timer);
    this.counts = [];
    this.canvas.hidden = true;
    byId("growth-legend").replaceChildren();
  }

  /** Measures one ratio after the other, on bodies and motions of its own: what plays goes on playing. */
  start(place, seen) {
    this.stop();
    this.other ??= new Core(this.core.module, this.core.plain("open"));
    this.canvas.hidden = false;
    const next = (i) => {
      const error = MODES.motions.use(this.other, { ...place, ratio: RATIOS[i] });
      if (error === 0)
        this.counts.push([RATIOS[i], Array.from({ length: this.other.plain("follower_count") }, (_, f) => this.other.kinds.reduce((sum, k) =>
          sum + (k.counts ? this.other.call("events_in_all", f, k.kind) : 0), 0))]);
      this.draw();
      if (i + 1 < RATIOS.length) this.timer = setTimeout(() => next(i + 1), 0);
      else seen(this.words());
    };
    next(0);
  }

  names() {
    return this.counts[0][1].map((_, f) => this.core.structures[this.other.call("follower_structure", f)].name);
  }
  words() {
    const [low] = this.counts, high = this.counts[this.counts.length - 1];
    if (!low) return "This motion cannot be made at any D/σ.";
    return this.names().map((name, f) => `${name}: ${low[1][f]} events at D/σ ${2 ** low[0]}, ${high[1][f]} at ${(2 ** high[0]).toLocaleString("en")}`).join("; ");
  }

  draw() {
    if (this.canvas.hidden || this.counts.length === 0) return;
    const box = this.canvas.getBoundingClientRect(), dots = Math.min(window.devicePixelRatio || 1, 2), g = this.canvas.getContext("2d");
    const [w, h] = [box.width, box.height], [left, right, top, bottom] = [46, w - 14, 8, h - 24];
    [this.canvas.width, this.canvas.height] = [Math.round(w * dots), Math.round(h * dots)];
    g.setTransform(dots, 0, 0, dots, 0, 0);
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
    const decades = Math.max(1, Math.ceil(Math.log10(Math.max(...this.counts.flatMap((c) => c[1])))));
    const x = (power) => left + ((power - 1) / 19) * (right - left), y = (count) => bottom - (Math.log10(Math.max(count, 1)) / decades) * (bottom - top);
    g.font = '12px system-ui, "DejaVu Sans", sans-serif';
    g.fillStyle = colour("--soft");
    g.strokeStyle = colour("--line");
    g.textAlign = "right";
    g.textBaseline = "middle";
    for (let d = 0; d <= decades; d++) {
      g.fillText((10 ** d).toLocaleString("en"), left - 5, y(10 ** d));
      g.strokeRect(left, y(10 ** d), right - left, 0);
    }
    g.textBaseline = "alphabetic";
    for (const power of w < 500 ? [1, 10, 20] : [1, 5, 10, 15, 20]) {
      g.textAlign = power === 1 ? "left" : power === 20 ? "right" : "center";
      g.fillText((power === 1 ? "D/σ " : "") + (2 ** power).toLocaleString("en"), x(power), h - 6);
    }
    this.names().forEach((_, f) => {
      g.strokeStyle = colour(CURVES[f]);
      g.lineWidth = f === 0 ? 3 : 1.5;
      g.beginPath();
      for (const [power, counts] of this.counts) g.lineTo(x(power), y(counts[f]));
      g.stroke();
    });
    this.canvas.setAttribute("aria-label", `Events against D/σ. ${this.words()}`);
    byId("growth-legend").replaceChildren(...this.names().map((name, f) => {
      const swatch = element("i", { className: "stroke" });
      swatch.style.borderColor = `var(${CURVES[f]})`;
      return element("li", {}, swatch, `${name}, ${this.counts[this.counts.length - 1][1][f].toLocaleString("en")} at the end`);
    }));
  }
}
