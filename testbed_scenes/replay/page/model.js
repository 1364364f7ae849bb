// The replay, and what is asked of it: who is where at a step, which pairs there are, what proves them apart.

const BODY_TYPES = ["static", "kinematic", "dynamic"];
const ANSWERS = ["not asked", "proved apart", "contact points found by the plugin", "handed to Box2D"];
const UNASKED = 0, APART = 1, MANIFOLD = 2, HANDED_OVER = 3;
const PROOF_KINDS = ["remembered edge", "edge of an envelope", "direction", "bounding disks"];
const DISKS = 3;

// Where each row's part of the next table begins, and at the end its length.
function startsOf(counts) {
  const starts = new Int32Array(counts.length + 1);
  for (let i = 0; i < counts.length; ++i) starts[i + 1] = starts[i] + counts[i];
  return starts;
}

// The last index in [from, until) whose value is not above `value`; from - 1 if there is none.
function lastNotAbove(values, value, from, until) {
  let low = from, high = until;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

class Model {
  constructor(about, columns) {
    this.about = about;
    this.stock = about.stock ?? "stock";
    this.c = columns;
    this.stepCount = about.stepCount;
    this.unit = about.quanta.position;
    const c = columns;
    this.poseStart = startsOf(c["body.steps"]);
    this.shapeStart = startsOf(c["body.shapes"]);
    this.shapePointStart = startsOf(c["shape.points"]);
    this.outlineStart = startsOf(c["outline.points"]);
    this.stepStart = startsOf(c["pair.steps"]);
    this.proofStart = startsOf(c["certificate.proofs"]);
    this.contactStart = startsOf(c["contact.steps"]);
    this.jointStart = startsOf(c["joint.steps"]);
    this.bodyCount = c["body.number"].length;
    this.pairCount = c["pair.a"].length;
    let highest = 0;
    for (const number of c["body.number"]) highest = Math.max(highest, number);
    this.entryOf = new Int32Array(highest + 1);
    for (const name of ["x", "y", "cos", "sin"]) this[name] = new Float64Array(this.bodyCount);
    this.present = new Uint8Array(this.bodyCount);
    this.flags = new Uint8Array(this.bodyCount);
    this.step = -1;
    this.readShapes();
    this.findCertificates();
    this.groupPairs();
  }

  // Points in lengths, in body frames; and a radius about each body's origin that holds it.
  readShapes() {
    const c = this.c, count = c["shape.x"].length;
    this.px = new Float64Array(count);
    this.py = new Float64Array(count);
    for (let i = 0; i < count; ++i) {
      this.px[i] = c["shape.x"][i] * this.unit;
      this.py[i] = c["shape.y"][i] * this.unit;
    }
    this.reach = new Float64Array(this.bodyCount);
    for (let body = 0; body < this.bodyCount; ++body)
      for (let shape = this.shapeStart[body]; shape < this.shapeStart[body + 1]; ++shape)
        for (let k = this.shapePointStart[shape]; k < this.shapePointStart[shape + 1]; ++k)
          this.reach[body] = Math.max(this.reach[body],
            Math.hypot(this.px[k], this.py[k]) + (this.shapeKind(shape) === 1 ? c["shape.radius"][shape] * this.unit : 0));
  }

  shapeKind(shape) { return this.c["shape.kind"][shape] & 3; }
  isSensor(shape) { return (this.c["shape.kind"][shape] & 4) !== 0; }

  findCertificates() {
    const pairs = this.c["certificate.pair"];
    this.certificateStart = new Int32Array(this.pairCount + 1);
    for (const pair of pairs) ++this.certificateStart[pair + 1];
    for (let i = 0; i < this.pairCount; ++i) this.certificateStart[i + 1] += this.certificateStart[i];
  }

  // Spans and events of the same two bodies, together.
  groupPairs() {
    const c = this.c;
    const byKey = new Map();
    const group = (a, b) => {
      const key = a * 16777216 + b;
      let found = byKey.get(key);
      if (!found) byKey.set(key, (found = { a, b, spans: [], events: [], tests: 0, saved: 0 }));
      return found;
    };
    this.groupOfPair = new Array(this.pairCount);
    for (let pair = 0; pair < this.pairCount; ++pair) {
      const its = (this.groupOfPair[pair] = group(c["pair.a"][pair], c["pair.b"][pair]));
      its.spans.push(pair);
      for (let i = this.stepStart[pair]; i < this.stepStart[pair + 1]; ++i) {
        its.tests += c["step.polygon"][i];
        if ((c["step.verdict"][i] & 3) === APART) its.saved += c["step.polygon"][i];
      }
    }
    for (let i = 0; i < c["event.a"].length; ++i) group(c["event.a"][i], c["event.b"][i]).events.push(i);
    this.groups = [...byKey.values()];
    this.groupByKey = byKey;
  }

  groupOf(a, b) { return this.groupByKey.get(Math.min(a, b) * 16777216 + Math.max(a, b)); }

  // Everything about a step that drawing asks for often.
  moveTo(step) {
    if (step === this.step) return;
    this.step = step;
    const c = this.c, unit = this.unit, turn = this.about.quanta.angle;
    this.entryOf.fill(-1);
    for (let body = 0; body < this.bodyCount; ++body) {
      const at = step - c["body.first"][body];
      this.present[body] = at >= 0 && at < c["body.steps"][body] ? 1 : 0;
      if (!this.present[body]) continue;
      const pose = this.poseStart[body] + at, angle = c["pose.angle"][pose] * turn;
      this.x[body] = c["pose.x"][pose] * unit;
      this.y[body] = c["pose.y"][pose] * unit;
      this.cos[body] = Math.cos(angle);
      this.sin[body] = Math.sin(angle);
      this.flags[body] = c["pose.flags"][pose];
      this.entryOf[c["body.number"][body]] = body;
    }
    this.pairsHere = [];
    for (let pair = 0; pair < this.pairCount; ++pair) {
      const at = step - c["pair.first"][pair];
      if (at >= 0 && at < c["pair.steps"][pair]) this.pairsHere.push(pair);
    }
  }

  // Row of step.* for a pair that has the step.
  rowOf(pair, step) { return this.stepStart[pair] + step - this.c["pair.first"][pair]; }
  spanAt(group, step) {
    return group.spans.find((pair) => step >= this.c["pair.first"][pair] && step < this.c["pair.first"][pair] + this.c["pair.steps"][pair]);
  }
  slackAt(row) { const slack = this.c["step.slack"][row]; return slack < 0 ? null : slack * this.about.quanta.slack; }
  answerAt(row) { return this.c["step.verdict"][row] & 3; }
  isTouchingAt(row) { return (this.c["step.verdict"][row] & 4) !== 0; }

  // [from, until) in proof.*: what proves the pair apart at the step.
  proofsAt(pair, step) {
    const i = lastNotAbove(this.c["certificate.step"], step, this.certificateStart[pair], this.certificateStart[pair + 1]);
    return i < this.certificateStart[pair] ? [0, 0] : [this.proofStart[i], this.proofStart[i + 1]];
  }

  // The point of a body nearest to (x, y), both in the world: into `out`. Its polygons are taken as filled.
  nearestPoint(body, x, y, out) {
    const c = this.cos[body], s = this.sin[body];
    const dx = x - this.x[body], dy = y - this.y[body];
    const lx = c * dx + s * dy, ly = c * dy - s * dx;
    let best = Infinity, bx = 0, by = 0;
    for (let shape = this.shapeStart[body]; shape < this.shapeStart[body + 1]; ++shape) {
      if (this.isSensor(shape)) continue;
      const kind = this.shapeKind(shape), from = this.shapePointStart[shape], until = this.shapePointStart[shape + 1];
      if (kind === 1) continue; // only polygons have pairs of their own
      let inside = kind === 0;
      for (let k = from, j = kind === 0 ? until - 1 : from; k < until; j = k++) {
        const ax = this.px[j], ay = this.py[j], ex = this.px[k] - ax, ey = this.py[k] - ay;
        const rx = lx - ax, ry = ly - ay;
        if (ex * ry - ey * rx < 0) inside = false;
        const length2 = ex * ex + ey * ey;
        const t = length2 > 0 ? Math.min(1, Math.max(0, (rx * ex + ry * ey) / length2)) : 0;
        const qx = ax + t * ex, qy = ay + t * ey;
        const d = (lx - qx) * (lx - qx) + (ly - qy) * (ly - qy);
        if (d < best) { best = d; bx = qx; by = qy; }
      }
      if (inside) { best = -1; bx = lx; by = ly; break; }
    }
    out[0] = this.x[body] + c * bx - s * by;
    out[1] = this.y[body] + s * bx + c * by;
  }

  // Whether a point of the world lies in a body, or so near to it: in one of its polygons or circles, or on a chain.
  isInside(body, x, y, near, out) {
    this.nearestPoint(body, x, y, out);
    if (Math.hypot(out[0] - x, out[1] - y) < near) return true;
    const dx = x - this.x[body], dy = y - this.y[body], c = this.cos[body], s = this.sin[body];
    for (let shape = this.shapeStart[body]; shape < this.shapeStart[body + 1]; ++shape) {
      const k = this.shapePointStart[shape];
      if (this.shapeKind(shape) === 1 && Math.hypot(c * dx + s * dy - this.px[k], c * dy - s * dx - this.py[k]) < this.c["shape.radius"][shape] * this.unit + near)
        return true;
    }
    return false;
  }

  // Nearest points of two bodies, near enough for a line on a screen: a few projections to and fro.
  linkOf(pair, out) {
    const a = this.entryOf[this.c["pair.a"][pair]], b = this.entryOf[this.c["pair.b"][pair]];
    if (a < 0 || b < 0) return false;
    const p = out.subarray(0, 2), q = out.subarray(2, 4);
    // From the smaller body: the middle of a ground says nothing.
    const [small, large, ps, pl] = this.reach[a] < this.reach[b] ? [a, b, p, q] : [b, a, q, p];
    this.nearestPoint(large, this.x[small], this.y[small], pl);
    this.nearestPoint(small, pl[0], pl[1], ps);
    this.nearestPoint(large, ps[0], ps[1], pl);
    return true;
  }

  event(i) {
    const c = this.c;
    return {
      step: c["event.step"][i], kind: this.about.eventKinds[c["event.kind"][i]],
      before: c["event.before"][i], after: c["event.after"][i],
      gap: Math.max(0, c["event.gap"][i]) * this.about.quanta.slack,
    };
  }
}
