// The scene on its canvas: a camera, and a layer for each overlay.

// Upper bounds of slack, as shares of the largest; the last class is the rest. Width tells what colour tells.
const SLACK_CLASSES = [0.01, 0.03, 0.1, 0.3, 0.6, Infinity];
const SLACK_WIDTHS = [3.2, 2.4, 1.7, 1, 0.8, 0.6];
// Lines up to a pixel wide are the cheap ones; rasterisers take long for one path of thousands of crossing parts, and long for thousands of paths.
const PARTS_PER_PATH = 8;
// Of the view's right side, in pixels: what stands there hides nothing that fits.
const BUTTONS = 52;

class View {
  constructor(canvas, model, options) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.model = model;
    this.options = options;
    this.framesDrawn = 0;
    this.links = new Float64Array(4);
    this.hasSensors = model.c["shape.kind"].some((kind) => (kind & 4) !== 0);
    this.readColours();
    this.chooseSlackScale();
    this.camera = { x: 0, y: 0, scale: 20 };
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    this.colour = new Proxy({}, { get: (known, name) => known[name] ??= style.getPropertyValue("--" + name).trim() });
  }

  // The largest slack of the legend: that of the 98th of 100 proved steps, in round figures.
  chooseSlackScale() {
    const slack = this.model.c["step.slack"], seen = [];
    const stride = Math.max(1, Math.floor(slack.length / 20000));
    for (let i = 0; i < slack.length; i += stride) if (slack[i] > 0) seen.push(slack[i]);
    seen.sort((a, b) => a - b);
    const high = (seen.length ? seen[Math.floor(seen.length * 0.98)] : 1024) * this.model.about.quanta.slack;
    const round = 10 ** Math.floor(Math.log10(high));
    this.slackScale = round * [1, 2, 5, 10].find((factor) => factor * round >= high * 0.999);
    this.slackBounds = SLACK_CLASSES.map((share) => share * this.slackScale);
  }

  slackClass(slack) { return this.slackBounds.findIndex((bound) => slack <= bound); }

  resize() {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.canvas.width = Math.max(1, Math.round(this.width * ratio));
    this.canvas.height = Math.max(1, Math.round(this.height * ratio));
    this.ratio = ratio;
  }

  toScreen(x, y) {
    return [(x - this.camera.x) * this.camera.scale + this.width / 2, (this.camera.y - y) * this.camera.scale + this.height / 2];
  }
  toWorld(x, y) {
    return [(x - this.width / 2) / this.camera.scale + this.camera.x, this.camera.y - (y - this.height / 2) / this.camera.scale];
  }

  // All bodies of the step, whole. Of a body at rest that is far larger than what moves (a ground) the part near that is
  // enough. With the whole run, where nearly all of it happens, too, if that is not far larger.
  fit(step, wholeRun = false) {
    const m = this.model, c = m.c, isMoving = (body) => (c["body.type"][body] & 3) !== 0, box = [Infinity, Infinity, -Infinity, -Infinity];
    const size = (of) => Math.max(of[2] - of[0], of[3] - of[1]);
    const grow = (other) => other.forEach((side, i) => (box[i] = i < 2 ? Math.min(box[i], side) : Math.max(box[i], side)));
    m.moveTo(step);
    for (const moving of [true, false]) {
      const farLarger = 3, room = box[0] < box[2] ? farLarger * size(box) : Infinity, seen = [...box];
      const isNear = (side, i) => side >= seen[i % 2] - room && side <= seen[i % 2 + 2] + room;
      for (let body = 0; body < m.bodyCount; ++body) {
        if (!m.present[body] || isMoving(body) !== moving) continue;
        const its = this.boxAt(body, m.poseStart[body] + step - c["body.first"][body]);
        grow(moving || size(its) <= room ? its : its.map((side, i) => (isNear(side, i) ? side : seen[i])));
      }
    }
    const course = wholeRun && this.boxOfCourse(isMoving);
    if (course && size(course) <= 2 * size(box)) grow(course);
    if (box[0] <= box[2]) this.frame(box, 0, BUTTONS);
    this.moved = false;
  }

  // The box of nearly all that moves in all steps: one runaway does not make the rest small. Null where nothing moves.
  boxOfCourse(isMoving) {
    const m = this.model, c = m.c, sides = [[], [], [], []];
    for (let body = 0; body < m.bodyCount; ++body) {
      if (!isMoving(body)) continue;
      const stride = Math.max(1, Math.floor(c["body.steps"][body] / 40));
      for (let pose = m.poseStart[body]; pose < m.poseStart[body + 1]; pose += stride)
        this.boxAt(body, pose).forEach((value, side) => sides[side].push(value));
    }
    return sides[0].length === 0 ? null : sides.map((list, side) => {
      list.sort((a, b) => a - b);
      return list[Math.min(list.length - 1, Math.floor(list.length * (side < 2 ? 0.01 : 0.99)))];
    });
  }

  // The box in the world of a body at a pose: left, bottom, right, top.
  boxAt(body, pose) {
    const m = this.model, c = m.c, box = (this.shapeBoxes ??= new Map()).get(body) ?? this.shapeBox(body);
    this.shapeBoxes.set(body, box);
    const angle = c["pose.angle"][pose] * m.about.quanta.angle, cos = Math.cos(angle), sin = Math.sin(angle);
    const x = c["pose.x"][pose] * m.unit + cos * box.x - sin * box.y, y = c["pose.y"][pose] * m.unit + sin * box.x + cos * box.y;
    const w = Math.abs(cos) * box.w + Math.abs(sin) * box.h, h = Math.abs(sin) * box.w + Math.abs(cos) * box.h;
    return [x - w, y - h, x + w, y + h];
  }

  // The box of a body's shapes in its own frame: its middle and half its sides.
  shapeBox(body) {
    const m = this.model, low = [0, 0], high = [0, 0];
    let first = true;
    for (let shape = m.shapeStart[body]; shape < m.shapeStart[body + 1]; ++shape) {
      const radius = m.shapeKind(shape) === 1 ? m.c["shape.radius"][shape] * m.unit : 0;
      for (let k = m.shapePointStart[shape]; k < m.shapePointStart[shape + 1]; ++k) {
        [m.px[k], m.py[k]].forEach((value, axis) => {
          low[axis] = first ? value - radius : Math.min(low[axis], value - radius);
          high[axis] = first ? value + radius : Math.max(high[axis], value + radius);
        });
        first = false;
      }
    }
    return { x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2, w: (high[0] - low[0]) / 2, h: (high[1] - low[1]) / 2 };
  }

  // A box of the world in the middle of the view, `room` around it; so many pixels at the right side stay free.
  frame([left, bottom, right, top], room, free = 0) {
    const width = right - left + room, height = top - bottom + room;
    this.camera.scale = Math.min(Math.max(this.width - free, 1) / width, this.height / height) * 0.94;
    this.camera.x = (left + right) / 2 + free / 2 / this.camera.scale;
    this.camera.y = (bottom + top) / 2;
  }

  // By hand, and so worth a place in the address.
  look(x, y, scale) {
    Object.assign(this.camera, { x, y, scale: Math.min(20000, Math.max(0.05, scale)) });
    this.moved = true;
  }

  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const [wx, wy] = this.toWorld(x, y);
    this.look(this.camera.x, this.camera.y, this.camera.scale * factor);
    const [nx, ny] = this.toWorld(x, y);
    this.camera.x += wx - nx;
    this.camera.y += wy - ny;
  }

  pan(dx, dy) {
    this.moved = true;
    this.camera.x -= dx / this.camera.scale;
    this.camera.y += dy / this.camera.scale;
  }

  // Lines are in world units under this transform: a pixel is 1 / scale.
  draw(step, chosen) {
    const g = this.context, m = this.model, shown = this.options;
    m.moveTo(step);
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.fillStyle = this.colour.scene;
    g.fillRect(0, 0, this.canvas.width, this.canvas.height);
    const k = this.camera.scale * this.ratio;
    g.setTransform(k, 0, 0, -k, this.canvas.width / 2 - this.camera.x * k, this.canvas.height / 2 + this.camera.y * k);
    this.pixel = 1 / this.camera.scale;
    g.lineJoin = "round";
    this.findSeen();
    if (shown.boxes) this.drawBoxes(step);
    this.drawPeriodicBox();
    if (shown.trails) this.drawTrails(step);
    this.drawBodies();
    if (shown.hulls) this.drawProofOutlines("hull", this.colour.hull, [2, 3], m.pairsHere, step);
    if (shown.envelopes) this.drawProofOutlines("envelope", this.colour.envelope, [7, 3], m.pairsHere, step);
    if (shown.slack || shown.handed) this.drawLinks(step);
    if (shown.certificates) this.drawCertificates(m.pairsHere, step, 1);
    if (shown.joints) this.drawJoints(step);
    if (shown.contacts) this.drawContacts(step);
    g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    const lit = this.litBodies(chosen);
    if (shown.numbers) this.drawNumbers(lit);
    if (chosen) {
      this.dim();
      g.setTransform(k, 0, 0, -k, this.canvas.width / 2 - this.camera.x * k, this.canvas.height / 2 + this.camera.y * k);
      if (chosen.body === undefined) this.drawChosen(chosen, step);
      else this.drawChosenBody(chosen.body, step);
      g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      if (chosen.body === undefined) this.drawNames(chosen, step);
      else this.drawNumbers([], lit);
    }
    ++this.framesDrawn;
  }

  // What lies outside of the view need not be drawn.
  findSeen() {
    const m = this.model;
    const [left, top] = this.toWorld(0, 0), [right, bottom] = this.toWorld(this.width, this.height);
    this.seen ??= new Uint8Array(m.bodyCount);
    for (let body = 0; body < m.bodyCount; ++body) {
      const r = m.reach[body];
      this.seen[body] = m.present[body] && m.x[body] + r >= left && m.x[body] - r <= right && m.y[body] + r >= bottom && m.y[body] - r <= top ? 1 : 0;
    }
  }

  // Where what goes out on one side comes in on the other: about the origin.
  drawPeriodicBox() {
    const [width, height] = this.model.about.period || [0, 0];
    if (!(width > 0)) return;
    const g = this.context;
    g.strokeStyle = this.colour.trail;
    g.lineWidth = 1.6 * this.pixel;
    g.setLineDash([9 * this.pixel, 5 * this.pixel]);
    g.strokeRect(-width / 2, -height / 2, width, height);
    g.setLineDash([]);
  }

  // Where the bodies that are seen were in the last two seconds. In a periodic box a line ends where it leaves.
  drawTrails(step) {
    const m = this.model, c = m.c, list = [], longest = (m.about.period?.[0] || Infinity) / 2;
    const frames = Math.max(1, Math.round(2 / m.about.timeStep));
    for (let body = 0; body < m.bodyCount; ++body) {
      if (!this.seen[body]) continue;
      const now = m.poseStart[body] + step - c["body.first"][body];
      for (let pose = Math.max(m.poseStart[body] + 1, now - frames); pose <= now; ++pose) {
        const x = c["pose.x"][pose] * m.unit, y = c["pose.y"][pose] * m.unit;
        const fromX = c["pose.x"][pose - 1] * m.unit, fromY = c["pose.y"][pose - 1] * m.unit;
        if (Math.hypot(x - fromX, y - fromY) < longest) list.push(fromX, fromY, x, y);
      }
    }
    this.strokeSegments(list, this.colour.trail, 1.4);
  }

  styleOf(body) {
    const type = this.model.c["body.type"][body] & 3, flags = this.model.flags[body];
    if (!(flags & 2)) return "disabled";
    if (type === 0) return "static";
    if (type === 1) return "kinematic";
    return flags & 1 ? "dynamic" : "sleeping";
  }

  traceShape(g, body, shape) {
    const m = this.model, c = m.cos[body], s = m.sin[body], x = m.x[body], y = m.y[body];
    const from = m.shapePointStart[shape], until = m.shapePointStart[shape + 1];
    if (m.shapeKind(shape) === 1) {
      const cx = x + c * m.px[from] - s * m.py[from], cy = y + s * m.px[from] + c * m.py[from];
      const r = m.c["shape.radius"][shape] * m.unit;
      g.moveTo(cx + r * c, cy + r * s);
      g.arc(cx, cy, r, Math.atan2(s, c), Math.atan2(s, c) + 2 * Math.PI);
      g.lineTo(cx, cy);
      return;
    }
    for (let k = from; k < until; ++k) {
      const wx = x + c * m.px[k] - s * m.py[k], wy = y + s * m.px[k] + c * m.py[k];
      if (k === from) g.moveTo(wx, wy);
      else g.lineTo(wx, wy);
    }
    if (m.shapeKind(shape) === 0) g.closePath();
  }

  traceBody(g, body, wanted) {
    const m = this.model;
    for (let shape = m.shapeStart[body]; shape < m.shapeStart[body + 1]; ++shape)
      if (wanted(shape)) this.traceShape(g, body, shape);
  }

  // One path for all bodies of a look. How a line is dashed says what its colour says.
  drawBodies() {
    const g = this.context, m = this.model, looks = { static: [], disabled: [], sleeping: [], kinematic: [], dynamic: [] };
    for (let body = 0; body < m.bodyCount; ++body) if (this.seen[body]) looks[this.styleOf(body)].push(body);
    const lines = { static: [1.6, []], disabled: [1, [1, 3]], sleeping: [1, [4, 2]], kinematic: [1.6, [9, 2, 2, 2]], dynamic: [1.1, []] };
    for (const [look, bodies] of Object.entries(looks)) {
      const name = look === "disabled" ? "sleeping" : look;
      const [width, dash] = lines[look];
      this.stroke(this.colour[name + "-edge"], width, dash);
      g.fillStyle = this.colour[name];
      this.inParts(bodies.length, (i) => this.traceBody(g, bodies[i], (shape) => !m.isSensor(shape) && m.shapeKind(shape) !== 2), () => {
        g.fill("nonzero");
        g.stroke();
      });
      this.inParts(bodies.length, (i) => this.traceBody(g, bodies[i], (shape) => m.shapeKind(shape) === 2), () => g.stroke());
      if (!this.hasSensors) continue;
      this.stroke(this.colour["sensor-edge"], 1, [1, 3]);
      this.inParts(bodies.length, (i) => this.traceBody(g, bodies[i], (shape) => m.isSensor(shape)), () => g.stroke());
    }
    g.setLineDash([]);
  }

  stroke(colour, width, dash = []) {
    const g = this.context;
    g.strokeStyle = colour;
    g.lineWidth = width * this.pixel;
    g.setLineDash(dash.map((length) => length * this.pixel));
  }

  // Lines between the nearest points of pairs: by slack where apart, crossed where Box2D tested.
  drawLinks(step, pairs = this.model.pairsHere) {
    const g = this.context, m = this.model, shown = this.options, out = this.links;
    const classes = SLACK_CLASSES.map(() => []), unproved = [], handed = [];
    for (const pair of pairs) {
      const row = m.rowOf(pair, step), answer = m.answerAt(row), slack = m.slackAt(row);
      let list = null;
      if (answer === HANDED_OVER) list = shown.handed ? handed : null;
      else if (shown.slack && slack > 0) list = classes[this.slackClass(slack)];
      else if (shown.slack && slack === 0 && !m.isTouchingAt(row)) list = unproved;
      if (!list || !this.seesPair(pair) || !m.linkOf(pair, out)) continue;
      list.push(out[0], out[1], out[2], out[3]);
    }
    const many = classes.reduce((sum, list) => sum + list.length / 4, 0);
    g.globalAlpha = Math.min(1, Math.max(0.25, 1200 / Math.max(1, many)));
    for (let i = classes.length - 1; i >= 0; --i) this.strokeSegments(classes[i], this.colour["slack-" + i], SLACK_WIDTHS[i]);
    g.globalAlpha = 1;
    this.strokeSegments(unproved, this.colour.unproved, 1, [2, 3]);
    this.strokeSegments(handed, this.colour.handed, 2);
    this.drawCrosses(handed);
  }

  // Calls trace(i) for each i, and paint() after every few.
  inParts(count, trace, paint) {
    const g = this.context;
    for (let from = 0; from < count; from += PARTS_PER_PATH) {
      g.beginPath();
      for (let i = from; i < Math.min(count, from + PARTS_PER_PATH); ++i) trace(i);
      paint();
    }
  }

  seesPair(pair) {
    const m = this.model, a = m.entryOf[m.c["pair.a"][pair]], b = m.entryOf[m.c["pair.b"][pair]];
    return a >= 0 && b >= 0 && (this.seen[a] || this.seen[b]);
  }

  strokeSegments(list, colour, width, dash = []) {
    if (!list.length) return;
    const g = this.context;
    this.stroke(colour, width, dash);
    this.inParts(list.length / 4, (i) => {
      g.moveTo(list[4 * i], list[4 * i + 1]);
      g.lineTo(list[4 * i + 2], list[4 * i + 3]);
    }, () => g.stroke());
  }

  drawCrosses(list) {
    if (!list.length) return;
    const g = this.context, r = 3.6 * this.pixel;
    this.stroke(this.colour.handed, 1.8);
    this.inParts(list.length / 4, (i) => {
      const x = (list[4 * i] + list[4 * i + 2]) / 2, y = (list[4 * i + 1] + list[4 * i + 3]) / 2;
      g.moveTo(x - r, y - r);
      g.lineTo(x + r, y + r);
      g.moveTo(x - r, y + r);
      g.lineTo(x + r, y - r);
    }, () => g.stroke());
  }

  // The polygons that proofs of these pairs speak of: "hull" or "envelope".
  drawProofOutlines(kind, colour, dash, pairs, step) {
    const g = this.context, m = this.model, c = m.c, done = new Set();
    this.stroke(colour, 1.2, dash);
    g.beginPath();
    for (const pair of pairs) {
      const [from, until] = m.proofsAt(pair, step);
      for (let i = from; i < until; ++i)
        for (const side of ["A", "B"]) {
          const outline = c["proof." + kind + side][i];
          if (outline < 0 || done.has(outline)) continue;
          done.add(outline);
          this.traceOutline(g, outline);
        }
    }
    g.stroke();
    g.setLineDash([]);
  }

  traceOutline(g, outline) {
    const m = this.model, c = m.c, body = m.entryOf[c["outline.body"][outline]];
    if (!(body >= 0)) return;
    for (let k = m.outlineStart[outline]; k < m.outlineStart[outline + 1]; ++k) {
      const [x, y] = this.place(body, c["outline.x"][k] * m.unit, c["outline.y"][k] * m.unit);
      if (k === m.outlineStart[outline]) g.moveTo(x, y);
      else g.lineTo(x, y);
    }
    g.closePath();
  }

  place(body, x, y) {
    const m = this.model;
    return [m.x[body] + m.cos[body] * x - m.sin[body] * y, m.y[body] + m.sin[body] * x + m.cos[body] * y];
  }

  // A proof in the world: its line (two ends), the other body's nearest point, and the foot of that on the line.
  proofInWorld(pair, i) {
    const m = this.model, c = m.c, u = m.unit;
    const bodies = [m.entryOf[c["pair.a"][pair]], m.entryOf[c["pair.b"][pair]]];
    if (bodies[0] < 0 || bodies[1] < 0) return null;
    const owner = c["proof.owner"][i];
    if (c["proof.kind"][i] === DISKS)
      return {
        disks: [
          [...this.place(bodies[0], c["proof.x0"][i] * u, c["proof.y0"][i] * u), c["proof.ra"][i] * u],
          [...this.place(bodies[1], c["proof.ox"][i] * u, c["proof.oy"][i] * u), c["proof.rb"][i] * u],
        ],
      };
    const angle = c["proof.angle"][i] * m.about.quanta.angle, own = bodies[owner];
    const nx = m.cos[own] * Math.cos(angle) - m.sin[own] * Math.sin(angle);
    const ny = m.sin[own] * Math.cos(angle) + m.cos[own] * Math.sin(angle);
    const p = this.place(own, c["proof.x0"][i] * u, c["proof.y0"][i] * u);
    const q = this.place(own, c["proof.x1"][i] * u, c["proof.y1"][i] * u);
    const o = this.place(bodies[1 - owner], c["proof.ox"][i] * u, c["proof.oy"][i] * u);
    const gap = (o[0] - p[0]) * nx + (o[1] - p[1]) * ny;
    const foot = [o[0] - gap * nx, o[1] - gap * ny];
    // From end to end of the edge and of the foot, and a little beyond.
    const along = [p, q, foot].map((point) => (point[1] - p[1]) * nx - (point[0] - p[0]) * ny);
    const beyond = Math.min(0.35 * Math.min(m.reach[bodies[0]], m.reach[bodies[1]]) + 4 * this.pixel, 30 * this.pixel);
    const ends = [Math.min(...along) - beyond, Math.max(...along) + beyond].map((t) => [p[0] - t * ny, p[1] + t * nx]);
    return { ends, other: o, foot };
  }

  drawCertificates(pairs, step, weight) {
    const g = this.context, m = this.model, lines = [], gaps = [];
    g.beginPath();
    for (const pair of pairs) {
      const [from, until] = m.proofsAt(pair, step);
      for (let i = from; i < until; ++i) {
        const proof = this.proofInWorld(pair, i);
        if (!proof) continue;
        for (const [x, y, r] of proof.disks ?? []) {
          g.moveTo(x + r, y);
          g.arc(x, y, r, 0, 2 * Math.PI);
        }
        if (!proof.ends) continue;
        lines.push(...proof.ends[0], ...proof.ends[1]);
        gaps.push(...proof.foot, ...proof.other);
      }
    }
    this.stroke(this.colour.certificate, weight, [4, 4]);
    g.stroke();
    this.strokeSegments(gaps, this.colour.certificate, weight, [2, 2]);
    this.strokeSegments(lines, this.colour.certificate, 1.6 * weight);
  }

  // Rows of a table of things that last some steps: [row of the step's values], by their spans.
  *spansAt(first, steps, starts, step) {
    for (let i = 0; i < first.length; ++i) {
      const at = step - first[i];
      if (at >= 0 && at < steps[i]) yield starts[i] + at;
    }
  }

  drawContacts(step) {
    const g = this.context, m = this.model, c = m.c, r = 3.2 * this.pixel;
    g.fillStyle = this.colour.contact;
    const rows = [...this.spansAt(c["contact.first"], c["contact.steps"], m.contactStart, step)];
    this.inParts(rows.length, (i) => {
      const x = c["contact.x"][rows[i]] * m.unit, y = c["contact.y"][rows[i]] * m.unit;
      g.moveTo(x - r, y);
      g.lineTo(x, y - r);
      g.lineTo(x + r, y);
      g.lineTo(x, y + r);
      g.closePath();
    }, () => g.fill());
  }

  drawJoints(step) {
    const m = this.model, c = m.c, list = [];
    for (const row of this.spansAt(c["joint.first"], c["joint.steps"], m.jointStart, step))
      for (const name of ["joint.ax", "joint.ay", "joint.bx", "joint.by"]) list.push(c[name][row] * m.unit);
    this.strokeSegments(list, this.colour.joint, 1.2);
  }

  drawBoxes(step) {
    const g = this.context, c = this.model.c, u = this.model.unit;
    this.stroke(this.colour.box, 0.8, [1, 2]);
    const here = [...c["box.step"].keys()].filter((i) => step >= c["box.step"][i] && step < c["box.end"][i]);
    this.inParts(here.length, (k) => {
      const i = here[k];
      g.rect(c["box.left"][i] * u, c["box.bottom"][i] * u, c["box.width"][i] * u, c["box.height"][i] * u);
    }, () => g.stroke());
    g.setLineDash([]);
  }

  bodiesOf(group) {
    return [group.a, group.b].map((number) => this.model.entryOf[number] ?? -1);
  }

  // Of what is chosen, a pair or a body: the bodies that stay lit.
  litBodies(chosen) {
    if (!chosen) return [];
    const bodies = chosen.body === undefined ? this.bodiesOf(chosen) : [this.model.entryOf[chosen.body] ?? -1];
    return bodies.filter((body) => body >= 0);
  }

  // Everything drawn so far steps back.
  dim() {
    const g = this.context;
    g.globalAlpha = 0.62;
    g.fillStyle = this.colour.scene;
    g.fillRect(0, 0, this.width, this.height);
    g.globalAlpha = 1;
  }

  lightBody(body) {
    const g = this.context, m = this.model, name = { disabled: "sleeping" }[this.styleOf(body)] ?? this.styleOf(body);
    g.beginPath();
    this.traceBody(g, body, () => true);
    this.stroke(this.colour.chosen, 5);
    g.stroke();
    // The inner half goes again: of a body of many fixtures the outline alone is marked.
    g.beginPath();
    this.traceBody(g, body, (shape) => !m.isSensor(shape) && m.shapeKind(shape) !== 2);
    g.fillStyle = this.colour[name];
    g.fill("nonzero");
    this.stroke(this.colour[name + "-edge"], 0.8);
    g.stroke();
  }

  drawChosen(group, step) {
    const pair = this.model.spanAt(group, step);
    for (const body of this.bodiesOf(group)) if (body >= 0) this.lightBody(body);
    if (pair === undefined) return;
    if (this.options.slack || this.options.handed) this.drawLinks(step, [pair]);
    this.drawProofOutlines("hull", this.colour.hull, [2, 3], [pair], step);
    this.drawProofOutlines("envelope", this.colour.envelope, [7, 3], [pair], step);
    this.drawCertificates([pair], step, 1.4);
  }

  // A body with the lines of all its pairs.
  drawChosenBody(number, step) {
    const m = this.model, body = m.entryOf[number] ?? -1;
    if (body >= 0) this.lightBody(body);
    const own = m.pairsHere.filter((pair) => m.c["pair.a"][pair] === number || m.c["pair.b"][pair] === number);
    if (this.options.slack || this.options.handed) this.drawLinks(step, own);
  }

  label(text, x, y, colour) {
    const g = this.context;
    g.lineWidth = 4;
    g.lineJoin = "round";
    g.strokeStyle = this.colour.scene;
    g.strokeText(text, x, y);
    g.fillStyle = colour;
    g.fillText(text, x, y);
  }

  // Of each body once: of those that are lit, their names are written later.
  drawNumbers(without, bodies = this.model.c["body.number"].keys()) {
    const g = this.context, m = this.model;
    g.font = "11px system-ui, sans-serif";
    g.textAlign = "center";
    g.textBaseline = "middle";
    for (const body of bodies)
      if (this.seen[body] && !without.includes(body)) this.label(String(m.c["body.number"][body]), ...this.placeOfNumber(body), this.colour.ink);
  }

  // The middle of the shapes: of a ground the origin may be anywhere.
  placeOfNumber(body) {
    const box = (this.shapeBoxes ??= new Map()).get(body) ?? this.shapeBox(body);
    this.shapeBoxes.set(body, box);
    return this.toScreen(...this.place(body, box.x, box.y));
  }

  drawNames(group, step) {
    const g = this.context, m = this.model, pair = m.spanAt(group, step);
    g.font = "bold 13px system-ui, sans-serif";
    g.textAlign = "center";
    g.textBaseline = "middle";
    const linked = pair !== undefined && m.linkOf(pair, this.links);
    this.bodiesOf(group).forEach((body, i) => {
      if (body < 0) return;
      // In the body, near the other one: the middle of a ground may be anywhere.
      let [x, y] = this.toScreen(m.x[body], m.y[body]);
      if (linked) {
        // From the middle of the gap towards the body's own middle.
        const [ax, ay] = this.toScreen((this.links[0] + this.links[2]) / 2, (this.links[1] + this.links[3]) / 2);
        const length = Math.hypot(x - ax, y - ay) || 1;
        const gap = Math.hypot(this.links[0] - this.links[2], this.links[1] - this.links[3]) * this.camera.scale;
        const away = (gap / 2 + Math.min(20, Math.max(14, length))) / length;
        x = ax + (x - ax) * away;
        y = ay + (y - ay) * away;
      }
      this.label(String(i === 0 ? group.a : group.b), x, y, this.colour.chosen);
    });
  }
}
