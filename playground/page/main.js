// SPDX-License-Identifier: MIT
// What is going on: the mode, the time, and one frame after the other for as long as something moves.

const HOLD_SECONDS = 3.2; // at an event, where the film stops
const HELD_AGEING = 0.1; // an event ages slower while it is looked at
const TEXT_SECONDS = 0.12; // between new words, at least
const CROWD_RATE = 0.6; // units of a world's time in a second
const CAMERA_SECONDS = 0.35; // in which the camera makes up most of its way
const ZOOM_COLUMN = 52; // dots that the buttons for zoom take
const PICTURES = { duel: 0, mixed: 1, crowd: 2, now: 3 };

class Playground {
  constructor(core) {
    this.core = core;
    this.panels = new Panels(core);
    this.place = placeOf(location.hash, core);
    const labelOf = (label) => core.text(core.plain("label", label));
    this.scene = new Picture(byId("scene"), labelOf, ZOOM_COLUMN);
    this.cells = new Picture(byId("mixed"), labelOf);
    const hold = (...args) => this.hold(...args);
    this.handles = new Handles(byId("main-view"), this.scene, core, hold);
    this.point = new PointHandle(byId("mixed-view"), this.cells, core, hold);
    this.timeline = new Timeline(byId("timeline"), core, (part) => this.seek(part * core.call("until")));
    this.growth = new Growth(core, byId("growth"));
    this.playing = false;
    this.held = 0;
    this.sketching = -1;
    this.framesDrawn = 0;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.wire();
    this.enter();
  }

  get mode() { return MODES[this.place.mode]; }

  // ---- modes ----

  enter() {
    const mode = this.mode;
    for (const button of byId("modes").children)
      if (button.dataset.mode === this.place.mode) button.setAttribute("aria-current", "page");
      else button.removeAttribute("aria-current");
    setText(byId("intro"), mode.intro);
    byId("mixed-view").hidden = !mode.mixed;
    document.querySelector(".views").classList.toggle("two", Boolean(mode.mixed));
    byId("transport").hidden = Boolean(mode.hand);
    for (const id of ["next-event", "stop-at-events"]) (id === "next-event" ? byId(id) : byId(id).parentElement).hidden = !mode.course;
    byId("scrub").parentElement.hidden = !mode.course;
    byId("kick").hidden = !mode.crowd;
    byId("timeline-box").hidden = !mode.timeline;
    byId("drawer").hidden = !mode.draws;
    for (const id of ["certificate", "rivals"]) byId(id).hidden = Boolean(mode.crowd);
    setText(byId("happens-title"), mode.crowd ? "What happens" : "What just happened");
    byId("badges").hidden = mode.badges.length === 0;
    byId("scene").setAttribute("aria-label", mode.crowd ? "Picture of many bodies" : "Picture of the two bodies");
    byId("stop-at-events").checked = Boolean(mode.stops);
    byId("legend").replaceChildren(...mode.legend.flatMap((name) => LEGEND[name]).map(([colour, text, line]) => {
      const swatch = element("i", { className: line || "" });
      swatch.style.borderColor = `var(${colour})`;
      return element("li", {}, swatch, text);
    }));
    buildFields(this.place.mode, this.core, this.place, (restart) => this.changed(restart));
    this.scene.zoom = 1;
    this.scene.focus = null;
    this.stopSketch();
    this.begin(!this.calm.matches);
  }

  /** From the start, with what is chosen. */
  begin(play) {
    const error = this.mode.use(this.core, this.place);
    byId("problem").hidden = error === 0;
    if (error !== 0) setText(byId("problem"), `That cannot be played with: ${this.core.errorText(error)}.`);
    this.playing = play && !this.mode.hand && error === 0;
    this.held = 0;
    this.panels.begin(this.mode.badges, Boolean(this.mode.mixed));
    setText(byId("intro"), this.mode.intro);
    this.scene.frame = this.core.frame(this.mode.crowd ? PICTURES.crowd : this.mode.follows ? PICTURES.now : PICTURES.duel);
    if (this.mode.hand) this.scene.frame = this.mode.mixed ? [-2.6, -3.1, 2.6, 1.9] : [-2.3, -2, 3.6, 2.6];
    if (this.mode.mixed) this.cells.frame = this.core.frame(PICTURES.mixed);
    if (this.mode.timeline) this.timeline.read();
    const motion = hashOf(this.place).replace(/&(ratio|levels)=[^&]*/g, "");
    if (motion !== this.motionMeasured) this.growth.stop(); // another D/sigma is on the same curves
    this.motionMeasured = motion;
    this.note();
    this.wordsDue = true;
    this.write();
    this.wake();
  }

  changed(restart) {
    if (restart) {
      const focus = document.activeElement;
      this.begin(this.playing || (!this.calm.matches && Boolean(this.mode.crowd)));
      if (focus && focus.isConnected) focus.focus();
    }
    this.write();
    this.wake();
  }

  note() {
    const diameter = this.core.call("diameter"), distance = this.core.call("distance");
    const ratio = (diameter / distance).toLocaleString("en", { maximumSignificantDigits: 3 });
    setText(byId("rivals-note"), this.mode.course ? "“In all”: in the whole motion, from its start to its end."
      : distance > 0 ? `D/σ is ${ratio} now: diameter over distance.` : "A and B touch.");
  }

  // ---- time ----

  seek(time) {
    this.core.call("seek", time);
    this.core.call("grow_old", 0);
    this.held = 0;
    this.playing = false;
    this.wordsDue = true;
    this.wake();
  }

  nextEvent() {
    this.playing = false;
    this.held = 0;
    if (this.core.call("time") >= this.core.call("until")) this.core.call("seek", 0);
    this.core.call("seek", this.core.call("next_event"));
    this.wordsDue = true;
    this.wake();
  }

  togglePlay() {
    if (this.mode.hand) return;
    if (!this.playing && this.mode.course && this.core.call("time") >= this.core.call("until")) this.core.call("seek", 0);
    this.playing = !this.playing;
    this.held = 0;
    this.wordsDue = true;
    this.wake();
  }

  step(seconds) {
    const core = this.core, speed = +byId("speed").value;
    if (this.mode.crowd) {
      if (this.playing && core.call("crowd_go", seconds * speed * CROWD_RATE, seconds) !== 0) this.playing = false;
      return;
    }
    core.call("grow_old", seconds * (this.held > 0 || (this.mode.course && !this.playing) ? HELD_AGEING : 1));
    if (!this.playing) return;
    this.held -= seconds;
    if (this.held > 0) return;
    const now = core.call("time"), until = core.call("until"), next = core.call("next_event"), events = core.call("event_count");
    const goal = Math.min(now + seconds * speed * this.mode.rate * (this.mode.rate < 1 ? until : 1), until);
    const stops = byId("stop-at-events").checked && next <= goal;
    core.call("seek", stops ? next : goal);
    if (stops && core.call("event_count") > events) this.held = HOLD_SECONDS;
    if (core.call("time") >= until) {
      this.playing = false;
      setText(byId("intro"), this.mode.last || this.mode.intro);
    }
  }

  // ---- hands ----

  hold(body, x, y, angle) {
    this.core.call("hold", body, x, y, angle);
    const key = this.mode.poses;
    if (key) this.place[key] = [0, 1].map((b) => { const at = this.core.place(b); return [at.x, at.y, at.angle]; });
    this.wordsDue = true;
    this.panels.sayLater(`${this.core.say(0)} ${this.core.say(2)}`);
    this.writeLater();
    this.wake();
  }

  startSketch(body) {
    this.sketching = body;
    this.core.call("sketch_clear");
    byId("main-view").classList.add("drawing");
    byId("drawing").hidden = false;
    setText(byId("drawing"), `Click corners of ${"AB"[body]}: none yet`);
    document.querySelector(".draw-row").hidden = false;
    this.sketch = [];
    byId("main-view").scrollIntoView({ block: "nearest" });
    this.wake();
  }
  stopSketch() {
    this.sketching = -1;
    this.core.call("sketch_clear");
    byId("main-view").classList.remove("drawing");
    byId("drawing").hidden = true;
    document.querySelector(".draw-row").hidden = true;
    this.wake();
  }
  useCorners(body, points) {
    const before = this.place.shapes[body];
    this.place.shapes[body] = { points };
    this.stopSketch();
    this.enter();
    if (byId("problem").hidden) return;
    this.place.shapes[body] = before;
    const text = byId("problem").textContent;
    this.enter();
    setText(byId("problem"), text);
    byId("problem").hidden = false;
  }
  typed(body) {
    const numbers = byId("corners").value.split(/[\s,;]+/).filter(Boolean).map(Number), points = [];
    for (let i = 0; i + 1 < numbers.length; i += 2) points.push([numbers[i], numbers[i + 1]]);
    if (points.length >= 3 && numbers.length % 2 === 0 && numbers.every((n) => Math.abs(n) < 100)) this.useCorners(body, points);
    else {
      setText(byId("problem"), "Corners are pairs of numbers, three pairs at least: -1 0, 1 -0.4, 0.6 0.9");
      byId("problem").hidden = false;
    }
  }
  clicked(event) {
    const box = byId("scene").getBoundingClientRect(), [x, y] = this.scene.toWorld(event.clientX - box.left, event.clientY - box.top);
    if (this.sketching >= 0) {
      this.sketch.push([x, y]);
      const count = this.core.call("sketch_add", x, y);
      setText(byId("drawing"), `Click corners of ${"AB"[this.sketching]}: ${count} so far${count < 3 ? "" : ", Done when it is enough"}`);
    } else if (this.mode.crowd) this.kick(x, y);
    this.wake();
  }
  kick(x, y) {
    const turn = Math.random() * 2 * Math.PI;
    this.core.call("crowd_kick", x, y, 4 * Math.cos(turn), 4 * Math.sin(turn));
    this.wake();
  }

  kickAny() {
    const [lx, ly, hx, hy] = this.scene.frame;
    this.kick(lx + Math.random() * (hx - lx), ly + Math.random() * (hy - ly));
  }

  // ---- frames ----

  wake() {
    if (!this.awake) {
      this.awake = true;
      requestAnimationFrame((now) => this.frame(now));
    }
  }

  frame(now) {
    const seconds = Math.min(0.1, Math.max(0, (now - (this.before ?? now)) / 1000));
    this.awake = false;
    this.step(seconds);
    if (this.mode.follows) this.follow(seconds);
    this.draw();
    if (this.wordsDue || now - (this.saidAt ?? 0) > 1000 * TEXT_SECONDS) {
      this.saidAt = now;
      this.wordsDue = false;
      this.write_words();
    }
    this.framesDrawn++;
    const moving = this.playing || this.fresh();
    this.before = moving ? now : undefined;
    if (moving) this.wake();
    else if (!this.rested) {
      this.rested = true; // one more, for the last words
      this.wordsDue = true;
      this.wake();
      return;
    }
    if (moving) this.rested = false;
  }

  /** The camera keeps both bodies in view, wherever they go. */
  follow(seconds) {
    const goal = this.core.frame(PICTURES.now), part = this.playing && seconds > 0 ? 1 - Math.exp(-seconds / CAMERA_SECONDS) : 1;
    this.scene.frame = this.scene.frame.map((value, i) => value + part * (goal[i] - value));
  }

  /** Is an event still fading? Not while it is being looked at. */
  fresh() {
    return Boolean(this.mode.hand) && this.core.call("event_count") > 0 && this.fadeUntil > performance.now();
  }

  draw() {
    const levels = LEVELS.indexOf(this.place.levels);
    const events = this.core.call("event_count");
    if (events !== this.eventsBefore) {
      this.fadeUntil = performance.now() + 2600;
      this.wordsDue = true; // words and picture tell of the same event
    }
    this.eventsBefore = events;
    if (this.mode.crowd) this.scene.draw(this.core.draw(PICTURES.crowd, this.place.shown));
    else {
      if (this.scene.zoom > 1 && this.scene.watched) this.scene.focus = this.scene.watched;
      this.scene.draw(this.core.draw(PICTURES.duel, levels));
      if (this.mode.mixed) this.cells.draw(this.core.draw(PICTURES.mixed, 0));
    }
    this.handles.update(Boolean(this.mode.hand) && this.sketching < 0);
    this.point.update(Boolean(this.mode.mixed));
    if (this.mode.timeline) this.timeline.draw();
  }

  write_words() {
    if (this.mode.crowd) this.panels.crowd();
    else {
      this.panels.update(Boolean(this.mode.course));
      this.note();
    }
    setText(byId("play"), this.playing ? "Pause" : "Play");
    if (this.mode.course) {
      const scrub = byId("scrub"), part = this.core.call("time") / this.core.call("until");
      if (document.activeElement !== scrub || this.playing) scrub.value = Math.round(1000 * part);
      scrub.setAttribute("aria-valuetext", `${Math.round(100 * part)} % of the motion`);
    }
  }

  write() { history.replaceState(null, "", hashOf(this.place)); }
  writeLater() {
    clearTimeout(this.writing);
    this.writing = setTimeout(() => this.write(), 300);
  }

  // ---- buttons and keys ----

  go(mode) {
    this.place.mode = mode;
    this.enter();
  }

  wire() {
    const on = (id, kind, action) => byId(id).addEventListener(kind, action);
    MODE_NAMES.forEach((name, i) => {
      const button = element("button", { type: "button", title: `Key ${i + 1}` }, MODES[name].title,
        ...(MODES[name].more ? [element("span", { className: "more", textContent: MODES[name].more })] : []));
      button.dataset.mode = name;
      button.addEventListener("click", () => this.go(name));
      byId("modes").append(button);
    });
    on("play", "click", () => this.togglePlay());
    on("next-event", "click", () => this.nextEvent());
    on("again", "click", () => this.begin(!this.calm.matches));
    on("grow", "click", () => this.growth.start(this.place, (words) => setText(byId("growth-words"), words)));
    on("kick", "click", () => this.kickAny());
    on("scrub", "input", () => this.seek((byId("scrub").value / 1000) * this.core.call("until")));
    for (const [id, factor] of [["zoom-in", 2], ["zoom-out", 0.5]]) on(id, "click", () => {
      this.scene.zoom = Math.min(4096, Math.max(1, this.scene.zoom * factor));
      this.wake();
    });
    on("draw-a", "click", () => this.startSketch(0));
    on("draw-b", "click", () => this.startSketch(1));
    on("draw-cancel", "click", () => this.stopSketch());
    on("draw-done", "click", () => this.useCorners(this.sketching, this.sketch));
    on("type-a", "click", () => this.typed(0));
    on("type-b", "click", () => this.typed(1));
    on("scene", "pointerdown", (event) => this.clicked(event));
    this.wireDialogs();
    on("theme", "change", () => this.theme());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.theme());
    this.theme();
    new ResizeObserver(() => {
      this.growth.draw();
      this.wake();
    }).observe(byId("main-view"));
    window.addEventListener("hashchange", () => {
      this.place = placeOf(location.hash, this.core);
      this.enter();
    });
    document.addEventListener("keydown", (event) => this.key(event));
  }

  wireDialogs() {
    for (const [button, dialog] of [["help-open", "help"], ["licenses-open", "licenses"]]) {
      byId(button).addEventListener("click", () => byId(dialog).showModal());
      byId(dialog).querySelector(".close").addEventListener("click", () => byId(dialog).close());
    }
    for (const name of ["push", "stab", "roll"])
      byId("event-words").append(element("dt", { textContent: name }), element("dd", { textContent: this.core.kinds.find((k) => k.name === name).meaning }));
    for (const [keys, what] of [["1 … 5", "the five ways to play"], ["P", "play and pause"], ["N", "to the next event"], ["K", "kick one of many bodies"], ["+ −", "zoom"],
      ["Tab", "to a body or its knob"], ["arrows", "move it (with Shift: farther), or turn it at its knob"], ["[ ]  Q E", "turn it"]])
      byId("keys").append(element("dt", {}, element("kbd", { textContent: keys })), element("dd", { textContent: what }));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
    if (event.target.matches("input[type=text], select")) return;
    const actions = {
      p: () => this.togglePlay(), n: () => this.mode.course && this.nextEvent(), k: () => this.mode.crowd && this.kickAny(), "+": () => byId("zoom-in").click(), "-": () => byId("zoom-out").click(),
      "?": () => byId("help-open").click(),
    };
    MODE_NAMES.forEach((name, i) => (actions[i + 1] = () => this.go(name)));
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    action();
    event.preventDefault();
  }

  theme() {
    const dark = byId("theme").value === "dark" || (byId("theme").value === "" && matchMedia("(prefers-color-scheme: dark)").matches);
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    for (const picture of [this.scene, this.cells]) picture.readColours();
    this.timeline.back = null;
    this.growth.draw();
    this.wake();
  }
}

Core.open().then((core) => {
  window.playground = new Playground(core);
  document.documentElement.dataset.ready = "yes";
}).catch((error) => {
  setText(byId("problem"), `The page cannot start: ${error.message}`);
  byId("problem").hidden = false;
});
