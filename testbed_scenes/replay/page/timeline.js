// One pair over time: its slack, what answered for it, its events, and stock's tests at the same steps.

// Letters, places and shapes tell kinds apart, not colours alone. Kinds that are not here share a row.
const EVENT_ROWS = [
  { kinds: ["push"], name: "push", glyph: "triangle" },
  { kinds: ["stab"], name: "stab", glyph: "wedge" },
  { kinds: ["roll"], name: "roll", glyph: "ring" },
  { kinds: ["coarsen"], name: "coarsen", glyph: "diamond" },
  { kinds: ["start"], name: "start", glyph: "bar" },
  { kinds: ["contact"], name: "contact", glyph: "cross" },
  { kinds: ["leave"], name: "leave", glyph: "plus" },
  { kinds: ["part"], name: "part", glyph: "bar" },
];
const SLACK_HEIGHT = 48, ROW_HEIGHT = 14, SUM_HEIGHT = 24, LABELS = 84;

function glyphPath(g, glyph, x, y, r) {
  if (glyph === "triangle") { g.moveTo(x - r, y + r); g.lineTo(x + r, y + r); g.lineTo(x, y - r); g.closePath(); }
  if (glyph === "wedge") { g.moveTo(x - r, y - r); g.lineTo(x + r, y - r); g.lineTo(x, y + r); g.closePath(); }
  if (glyph === "ring") { g.moveTo(x + r, y); g.arc(x, y, r, 0, 2 * Math.PI); }
  if (glyph === "diamond") { g.moveTo(x - r, y); g.lineTo(x, y - r); g.lineTo(x + r, y); g.lineTo(x, y + r); g.closePath(); }
  if (glyph === "bar") { g.moveTo(x, y - r); g.lineTo(x, y + r); }
  if (glyph === "cross") { g.moveTo(x - r, y - r); g.lineTo(x + r, y + r); g.moveTo(x - r, y + r); g.lineTo(x + r, y - r); }
  if (glyph === "plus") { g.moveTo(x - r, y); g.lineTo(x + r, y); g.moveTo(x, y - r); g.lineTo(x, y + r); }
}

function lengthText(value) {
  return String(Number(value >= 100 ? value.toFixed(0) : value >= 0.9995 ? value.toFixed(2) : value.toFixed(3)));
}

// A start has no level before it, and a contact none after it, whatever the numbers are.
function levelText(event) {
  const level = (value) => (value < 0 ? "disks" : String(value));
  if (event.kind === "start") return event.after < 0 ? " disks" : "";
  if (event.kind === "contact" || event.before === event.after) return "";
  return " " + level(event.before) + "→" + level(event.after);
}

class Timeline {
  constructor(canvas, model, view, onSeek) {
    this.canvas = canvas;
    this.model = model;
    this.view = view;
    this.strip = new Strip(canvas);
    this.group = null;
    const seek = (event) => onSeek(this.stepAt(event.clientX - canvas.getBoundingClientRect().left));
    canvas.addEventListener("pointerdown", (event) => { canvas.setPointerCapture(event.pointerId); seek(event); });
    canvas.addEventListener("pointermove", (event) => { if (event.buttons) seek(event); });
  }

  stepAt(x) {
    const share = (x - LABELS) / (this.canvas.clientWidth - LABELS - 8);
    return Math.round(Math.min(1, Math.max(0, share)) * (this.model.stepCount - 1));
  }

  // A pair, or of all pairs (or those of a body) the sum: { events }.
  choose(group) {
    this.group = group;
    this.events = group.events.map((i) => this.model.event(i));
    this.strip.forget();
    const kinds = new Set(this.events.map((event) => event.kind));
    this.rows = EVENT_ROWS.filter((row) => row.kinds.some((kind) => kinds.has(kind)));
    if (this.isSum()) {
      this.canvas.style.height = 6 + this.rows.length * SUM_HEIGHT + 18 + "px";
      return;
    }
    let highest = 0;
    for (const pair of group.spans)
      for (let row = this.model.stepStart[pair]; row < this.model.stepStart[pair + 1]; ++row)
        highest = Math.max(highest, this.model.c["step.slack"][row]);
    this.highest = Math.max(0.05, highest * this.model.about.quanta.slack);
    this.canvas.style.height = SLACK_HEIGHT + 14 + (this.rows.length + (this.model.about.world ? 0 : 3)) * ROW_HEIGHT + 18 + "px";
  }

  // A group without two bodies of its own: of all pairs, or of all of one body.
  isSum() { return this.group.a === undefined; }

  xOf(step) { return LABELS + (step / Math.max(1, this.model.stepCount - 1)) * (this.width - LABELS - 8); }

  draw(step) {
    if (!this.group) return;
    const { width, height } = this.strip.begin();
    if (width === 0) return;
    Object.assign(this, { width, height });
    this.strip.draw((g) => this.drawBackdrop(g), (g) => {
      g.fillStyle = this.view.colour.accent;
      const x = this.xOf(step);
      g.fillRect(x - 0.75, 0, 1.5, height - 14);
      g.beginPath();
      g.moveTo(x - 5, 0);
      g.lineTo(x + 5, 0);
      g.lineTo(x, 6);
      g.fill();
    });
  }

  // What the mark below a point is: an event of its row, or the step.
  textAt(x, y) {
    if (!this.group || x < LABELS) return "";
    if (this.isSum()) {
      const row = this.rows[Math.floor((y - 6) / SUM_HEIGHT)], step = this.stepAt(x);
      return row ? "step " + step + ": " + row.name + " " + this.countsOf(row)[step] : "";
    }
    const row = this.rows[Math.floor((y - SLACK_HEIGHT - 14) / ROW_HEIGHT)], near = 5;
    let found = null;
    for (const event of row ? this.events : []) {
      const away = Math.abs(this.xOf(event.step) - x);
      if (row.kinds.includes(event.kind) && away < near && (!found || away < Math.abs(this.xOf(found.step) - x))) found = event;
    }
    if (found) return "step " + found.step + ": " + found.kind + levelText(found) + (found.gap > 0 ? ", then " + lengthText(found.gap) + " apart" : "");
    const step = this.stepAt(x);
    const pair = this.model.spanAt(this.group, step);
    if (pair === undefined) return "step " + step + ": not watched";
    const slack = this.model.slackAt(this.model.rowOf(pair, step));
    return "step " + step + (slack > 0 ? ": slack " + lengthText(slack) : "");
  }

  drawBackdrop(g) {
    const colour = this.view.colour;
    g.font = "11px system-ui, sans-serif";
    g.textBaseline = "middle";
    g.lineWidth = 1;
    if (this.isSum()) { this.drawSums(g, colour); return; }
    this.drawSlack(g, colour);
    let y = SLACK_HEIGHT + 14;
    const label = (text, at) => {
      g.fillStyle = colour.soft;
      g.textAlign = "right";
      g.fillText(text, LABELS - 8, at + ROW_HEIGHT / 2);
      g.strokeStyle = colour.grid;
      g.beginPath();
      g.moveTo(LABELS, at + ROW_HEIGHT - 0.5);
      g.lineTo(this.width - 8, at + ROW_HEIGHT - 0.5);
      g.stroke();
    };
    for (const row of this.rows) {
      label(row.name, y);
      this.drawEvents(g, row, y + ROW_HEIGHT / 2);
      y += ROW_HEIGHT;
    }
    if (this.model.about.world) { this.drawAxis(g, y); return; }
    label("call of Box2D", y);
    this.drawStrip(g, y, colour.handed, (row) => (this.model.answerAt(row) === HANDED_OVER ? 1 : 0));
    y += ROW_HEIGHT;
    label(this.model.stock + ": SAT", y);
    this.drawStrip(g, y, colour.ink, (row) => this.model.c["step.polygon"][row]);
    y += ROW_HEIGHT;
    label(this.model.stock + ": TOI", y);
    this.drawStrip(g, y, colour.ink, (row) => this.model.c["step.toi"][row]);
    y += ROW_HEIGHT;
    this.drawAxis(g, y);
  }

  // Of each kind how many in each step: bars, the highest as high as the row.
  drawSums(g, colour) {
    this.rows.forEach((row, i) => {
      const bottom = 6 + (i + 1) * SUM_HEIGHT - 3, counts = this.countsOf(row), most = Math.max(...counts);
      g.fillStyle = colour.soft;
      g.textAlign = "right";
      g.fillText(row.name, LABELS - 8, bottom - 5);
      g.fillStyle = row.glyph === "cross" ? colour.handed : colour.ink;
      const width = Math.max(1, this.xOf(1) - this.xOf(0));
      counts.forEach((count, step) => {
        const height = Math.sqrt(count / most) * (SUM_HEIGHT - 5);
        const left = Math.max(LABELS, this.xOf(step) - width / 2), right = Math.min(this.width - 8, this.xOf(step) + width / 2);
        if (count > 0) g.fillRect(left, bottom - height, right - left, height);
      });
      g.strokeStyle = colour.grid;
      g.beginPath();
      g.moveTo(LABELS, bottom + 0.5);
      g.lineTo(this.width - 8, bottom + 0.5);
      g.stroke();
    });
    this.drawAxis(g, 6 + this.rows.length * SUM_HEIGHT);
  }

  countsOf(row) {
    const counts = new Array(this.model.stepCount).fill(0);
    for (const event of this.events) if (row.kinds.includes(event.kind)) ++counts[Math.max(0, event.step)];
    return counts;
  }

  // A root scale: what is near matters more. Gaps are where there is no contact.
  drawSlack(g, colour) {
    const m = this.model, top = 8, bottom = SLACK_HEIGHT + 6;
    const yOf = (slack) => bottom - Math.sqrt(slack / this.highest) * (bottom - top);
    g.fillStyle = colour.soft;
    g.textAlign = "right";
    g.fillText("slack", LABELS - 34, (top + bottom) / 2);
    g.fillText(lengthText(this.highest), LABELS - 4, top);
    g.fillText("0", LABELS - 4, bottom - 2);
    g.strokeStyle = colour.line;
    g.strokeRect(LABELS, top, this.width - LABELS - 8, bottom - top);
    g.strokeStyle = colour.accent;
    g.lineWidth = 1.4;
    g.beginPath();
    for (const pair of this.group.spans) {
      let drawing = false;
      for (let row = m.stepStart[pair], step = m.c["pair.first"][pair]; row < m.stepStart[pair + 1]; ++row, ++step) {
        const slack = m.slackAt(row);
        if (slack === null) { drawing = false; continue; }
        if (drawing) g.lineTo(this.xOf(step), yOf(slack));
        else { g.moveTo(this.xOf(step) - 0.5, yOf(slack)); g.lineTo(this.xOf(step), yOf(slack)); }
        drawing = true;
      }
    }
    g.stroke();
    g.lineWidth = 1;
  }

  drawEvents(g, row, y) {
    const colour = this.view.colour;
    g.strokeStyle = g.fillStyle = row.glyph === "cross" ? colour.handed : colour.ink;
    g.lineWidth = 1.3;
    g.beginPath();
    for (const event of this.events)
      if (row.kinds.includes(event.kind)) glyphPath(g, row.glyph, this.xOf(event.step), y, 3.4);
    if (row.glyph === "triangle" || row.glyph === "wedge" || row.glyph === "diamond") g.fill();
    g.stroke();
  }

  // Bars as high as the count: half for one, full for more.
  drawStrip(g, y, colour, countOf) {
    const m = this.model, width = Math.max(1, this.xOf(1) - this.xOf(0));
    g.fillStyle = colour;
    for (const pair of this.group.spans)
      for (let row = m.stepStart[pair], step = m.c["pair.first"][pair]; row < m.stepStart[pair + 1]; ++row, ++step) {
        const count = countOf(row);
        if (count <= 0) continue;
        const height = count === 1 ? 6 : 11;
        g.fillRect(this.xOf(step) - width / 2, y + ROW_HEIGHT - 1 - height, width, height);
      }
  }

  drawAxis(g, y) {
    const last = this.model.stepCount - 1, round = 10 ** Math.floor(Math.log10(Math.max(1, last)));
    const every = [0.1, 0.2, 0.5, 1].map((f) => Math.max(1, f * round)).find((f) => (last / f) * 44 < this.width - LABELS) ?? round * 2;
    g.fillStyle = this.view.colour.soft;
    g.textAlign = "center";
    for (let step = 0; step <= last; step += every) g.fillText(String(step), Math.min(this.xOf(step), this.width - 12), y + 9);
  }

  describe() {
    const counts = {};
    for (const event of this.events) counts[event.kind] = (counts[event.kind] || 0) + 1;
    const words = Object.entries(counts).map(([kind, count]) => count + " " + kind).join(", ");
    if (this.isSum()) return "Events in each step: " + (words || "none") + ".";
    return "Time line of bodies " + this.group.a + " and " + this.group.b + ": " + (words || "no events") +
      (this.model.about.world ? "" : "; " + (this.model.stock === "off" ? "with the plugin off, Box2D" : "stock Box2D") + " tested the two " + this.group.tests + " times") + ". The list of events below says the same.";
  }
}
