// What is below a point of the view, and what is said of it.

// The pair whose line is nearest to a point of the screen, as a group; null where none is near.
function pairAt(view, x, y, step) {
  const m = view.model, out = view.links;
  m.moveTo(step);
  let best = 12, found = null;
  for (const pair of m.pairsHere) {
    if (!m.linkOf(pair, out)) continue;
    const [ax, ay] = view.toScreen(out[0], out[1]), [bx, by] = view.toScreen(out[2], out[3]);
    const ex = bx - ax, ey = by - ay, length2 = ex * ex + ey * ey;
    const t = length2 > 0 ? Math.min(1, Math.max(0, ((x - ax) * ex + (y - ay) * ey) / length2)) : 0;
    const d = Math.hypot(x - ax - t * ex, y - ay - t * ey);
    if (d < best) { best = d; found = pair; }
  }
  return found === null ? null : m.groupOfPair[found];
}

// The number of a body below a point of the screen, moving ones first; or null.
function bodyAt(view, x, y) {
  const m = view.model, [wx, wy] = view.toWorld(x, y), out = new Float64Array(2);
  let found = null;
  for (let body = m.bodyCount - 1; body >= 0; --body) {
    const isMoving = (m.c["body.type"][body] & 3) !== 0;
    if (!view.seen[body] || (found !== null && !isMoving)) continue;
    if (!m.isInside(body, wx, wy, 2 * view.pixel, out)) continue;
    found = m.c["body.number"][body];
    if (isMoving) break;
  }
  return found;
}

// A body, if the point is in one, else a pair: { body } or a group, or null.
function whatIsAt(view, x, y, step) {
  const body = bodyAt(view, x, y);
  return body === null ? pairAt(view, x, y, step) : { body };
}

function describePair(model, group, step) {
  const pair = model.spanAt(group, step), name = "Bodies " + group.a + " and " + group.b;
  if (pair === undefined) return name;
  const row = model.rowOf(pair, step), slack = model.slackAt(row);
  const state = model.isTouchingAt(row) ? "they touch" : slack > 0 ? "at least " + lengthText(slack) + (model.about.world ? "" : " m") + " apart"
    : slack === 0 ? "nothing is proved" : ANSWERS[model.answerAt(row)];
  return name + ": " + state + ", " + countText(group.events.length, "event");
}

function describeBody(model, number, step) {
  const body = model.entryOf[number] ?? -1, name = "Body " + number;
  if (body < 0) return name + ": not there at this step";
  let pairs = 0, touching = 0;
  for (const pair of model.pairsHere)
    if (model.c["pair.a"][pair] === number || model.c["pair.b"][pair] === number) {
      ++pairs;
      if (model.isTouchingAt(model.rowOf(pair, step))) ++touching;
    }
  const type = BODY_TYPES[model.c["body.type"][body] & 3], asleep = type === "dynamic" && !(model.flags[body] & 1);
  return name + ": " + type + (asleep ? ", asleep" : "") + ", " + countText(pairs, "pair") + (touching ? ", touches " + touching : "");
}

function countText(count, what) { return count + " " + what + (count === 1 ? "" : "s"); }

// A text beside the pointer: over the scene, over the time line, over the chart of tests.
class Hover {
  constructor(box) { this.box = box; }

  // textAt(x, y): what is said of a place of the element, in its pixels; "" for nothing.
  watch(element, textAt) {
    element.addEventListener("pointermove", (event) => {
      if (event.buttons || event.pointerType === "touch") { this.hide(); return; }
      const frame = element.getBoundingClientRect();
      this.show(textAt(event.clientX - frame.left, event.clientY - frame.top), event.clientX, event.clientY);
    });
    for (const name of ["pointerleave", "pointerdown"]) element.addEventListener(name, () => this.hide());
  }

  show(text, x, y) {
    if (!text) { this.hide(); return; }
    const box = this.box, away = 14;
    box.textContent = text;
    box.hidden = false;
    const left = x + away + box.offsetWidth < window.innerWidth ? x + away : Math.max(0, x - away - box.offsetWidth);
    const top = y + away + box.offsetHeight < window.innerHeight ? y + away : Math.max(0, y - away - box.offsetHeight);
    box.style.left = left + "px";
    box.style.top = top + "px";
  }

  hide() { this.box.hidden = true; }
}

function connectHover(app) {
  const hover = new Hover(document.getElementById("hover")), m = app.model;
  hover.watch(app.view.canvas, (x, y) => {
    if (app.playing) return "";
    const found = whatIsAt(app.view, x, y, app.step);
    return !found ? "" : found.body === undefined ? describePair(m, found, app.step) : describeBody(m, found.body, app.step);
  });
  hover.watch(app.timeline.canvas, (x, y) => app.timeline.textAt(x, y));
  hover.watch(document.getElementById("load"), (x) => app.figures.textAt(x));
}
