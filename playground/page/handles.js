// SPDX-License-Identifier: MIT
// What is taken hold of: buttons on the picture, for fingers, mice and keys. A body's button moves it, its knob turns it.

const STEP = 0.05, LARGE_STEP = 0.25, TURN = Math.PI / 60;
const KNOB_AT = 1.2; // of the body's radius

class Handles {
  /** `hold(body, x, y, angle)` gets where a body shall be. */
  constructor(view, picture, core, hold) {
    Object.assign(this, { picture, core, hold });
    this.all = [];
    for (const body of [0, 1])
      for (const kind of ["move", "turn"]) this.add(view, body, kind);
  }

  add(view, body, kind) {
    const name = "AB"[body], button = element("button", { type: "button", className: `handle ${kind}` });
    button.dataset.body = body;
    button.id = `${kind}-${name.toLowerCase()}`;
    if (kind === "turn") button.append(element("span", { textContent: "↻" }));
    button.setAttribute("aria-keyshortcuts", kind === "turn" ? "ArrowLeft ArrowRight [ ]" : "ArrowLeft ArrowRight ArrowUp ArrowDown [ ]");
    const handle = { button, body, kind };
    this.all.push(handle);
    view.append(button);
    button.addEventListener("keydown", (event) => this.key(event, handle));
    button.addEventListener("pointerdown", (event) => this.grab(event, handle));
  }

  /** To where the bodies are now; hidden where nothing may be moved. */
  update(shown) {
    this.picture.knobs = [];
    for (const { button, body, kind } of this.all) {
      button.hidden = !shown;
      if (!shown) continue;
      const at = this.core.place(body), name = "AB"[body], degrees = Math.round((at.angle * 180) / Math.PI);
      const reach = kind === "turn" ? KNOB_AT * at.radius : 0;
      let [x, y] = this.picture.toScreen(at.x + reach * Math.cos(at.angle), at.y + reach * Math.sin(at.angle));
      if (kind === "turn") { // always to be got hold of, beside the buttons for zoom
        x = Math.min(Math.max(x, 22), this.picture.width - (y < 120 ? 22 + this.picture.reserve : 22));
        y = Math.min(Math.max(y, 22), this.picture.height - 22);
      }
      if (kind === "turn") this.picture.knobs.push(this.picture.toWorld(x, y));
      if (kind === "turn") this.picture.stalk(this.picture.toScreen(at.x, at.y), [x, y], body);
      button.style.left = `${x}px`;
      button.style.top = `${y}px`;
      if (kind === "move") {
        const size = Math.max(44, 1.5 * at.radius * this.picture.scale);
        button.style.width = button.style.height = `${size}px`;
      }
      const label = kind === "move" ? `Move body ${name}, at ${at.x.toFixed(2)}, ${at.y.toFixed(2)}. Arrow keys move it, [ and ] turn it`
        : `Turn body ${name}, at ${degrees} degrees. Arrow keys turn it`;
      if (button.getAttribute("aria-label") !== label) button.setAttribute("aria-label", label);
    }
  }

  key(event, { body, kind }) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? LARGE_STEP : STEP, at = this.core.place(body);
    const turns = { "[": 1, q: 1, Q: 1, "]": -1, e: -1, E: -1 }, ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in turns) at.angle += turns[event.key] * TURN * (event.shiftKey ? 5 : 1);
    else if (!(event.key in ways)) return;
    else if (kind === "turn") at.angle -= (ways[event.key][0] - ways[event.key][1]) * TURN * (event.shiftKey ? 5 : 1);
    else {
      at.x += step * ways[event.key][0];
      at.y += step * ways[event.key][1];
    }
    event.preventDefault();
    event.stopPropagation();
    this.hold(body, at.x, at.y, at.angle);
  }

  grab(event, { button, body, kind }) {
    if (event.button > 0) return;
    const start = this.core.place(body);
    const world = (e) => {
      const box = this.picture.canvas.getBoundingClientRect();
      return this.picture.toWorld(e.clientX - box.left, e.clientY - box.top);
    };
    const [fromX, fromY] = world(event), angle = Math.atan2(fromY - start.y, fromX - start.x);
    const move = (e) => {
      const [x, y] = world(e);
      if (kind === "move") this.hold(body, start.x + x - fromX, start.y + y - fromY, this.core.place(body).angle);
      else this.hold(body, start.x, start.y, start.angle + Math.atan2(y - start.y, x - start.x) - angle);
    };
    const drop = () => {
      button.removeEventListener("pointermove", move);
      button.removeEventListener("pointerup", drop);
      button.removeEventListener("pointercancel", drop);
    };
    button.setPointerCapture(event.pointerId);
    button.addEventListener("pointermove", move);
    button.addEventListener("pointerup", drop);
    button.addEventListener("pointercancel", drop);
  }
}

/** x in the mixed hierarchy: B's place in A's frame. */
class PointHandle {
  constructor(view, picture, core, hold) {
    Object.assign(this, { picture, core, hold });
    const button = this.button = element("button", { type: "button", className: "handle move", id: "move-x" });
    button.style.width = button.style.height = "44px";
    button.setAttribute("aria-keyshortcuts", "ArrowLeft ArrowRight ArrowUp ArrowDown [ ]");
    view.append(button);
    button.addEventListener("keydown", (event) => this.key(event));
    button.addEventListener("pointerdown", (event) => {
      const move = (e) => {
        const box = picture.canvas.getBoundingClientRect();
        this.put(...picture.toWorld(e.clientX - box.left, e.clientY - box.top));
      };
      const drop = () => button.removeEventListener("pointermove", move);
      button.setPointerCapture(event.pointerId);
      button.addEventListener("pointermove", move);
      for (const end of ["pointerup", "pointercancel"]) button.addEventListener(end, drop, { once: true });
    });
  }
  /** Where x is. */
  at() {
    const a = this.core.place(0), b = this.core.place(1), dx = b.x - a.x, dy = b.y - a.y, c = Math.cos(a.angle), s = Math.sin(a.angle);
    return [c * dx + s * dy, c * dy - s * dx];
  }
  put(x, y) {
    const a = this.core.place(0), b = this.core.place(1), c = Math.cos(a.angle), s = Math.sin(a.angle);
    this.hold(1, a.x + c * x - s * y, a.y + s * x + c * y, b.angle);
  }
  update(shown) {
    this.button.hidden = !shown;
    if (!shown) return;
    const [x, y] = this.at(), [px, py] = this.picture.toScreen(x, y);
    this.button.style.left = `${px}px`;
    this.button.style.top = `${py}px`;
    this.button.setAttribute("aria-label", `Move x, at ${x.toFixed(2)}, ${y.toFixed(2)}. Arrow keys move it, [ and ] turn body B`);
  }
  key(event) {
    const step = event.shiftKey ? LARGE_STEP : STEP, [x, y] = this.at(), b = this.core.place(1);
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }, turns = { "[": 1, q: 1, "]": -1, e: -1 };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in ways) this.put(x + step * ways[event.key][0], y + step * ways[event.key][1]);
    else if (event.key in turns) this.hold(1, b.x, b.y, b.angle + turns[event.key] * TURN);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
