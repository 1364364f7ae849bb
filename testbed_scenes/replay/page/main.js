// Puts the parts together, and keeps the time.

class App {
  constructor(about, columns) {
    this.model = new Model(about, columns);
    this.options = {};
    this.step = 0;
    this.speed = 1;
    this.playing = false;
    this.dirty = true;
    this.view = new View(document.getElementById("scene"), this.model, this.options);
    const seek = (step) => this.seek(step, true);
    this.timeline = new Timeline(document.getElementById("timeline"), this.model, this.view, seek);
    this.figures = new Figures(document.getElementById("totals"), document.getElementById("load"), document.getElementById("load-text"), this.model, this.view, seek);
    this.pairs = new Pairs(this.model, this.timeline, this);
    buildSwitches(this);
    buildLegend(this);
    connectTransport(this);
    connectPointer(this);
    connectKeys(this);
    connectHover(this);
    this.nameIt(about);
    this.view.resize();
    this.view.fit(0, true);
    this.link = new Link(this);
    this.link.read();
    new ResizeObserver(() => this.resized()).observe(this.view.canvas);
    requestAnimationFrame((now) => this.tick(now));
  }

  nameIt(about) {
    document.title = about.scene + " – Boomerang replay";
    document.getElementById("title").textContent = about.scene;
    const words = [about.description, this.model.stepCount + (about.world ? " frames" : " steps"), (about.world ? about.size : this.model.c["body.number"].length) + " bodies",
      about.structure && "structure " + about.structure];
    if (about.difference !== undefined) {
      const problem = document.getElementById("problem");
      problem.hidden = false;
      problem.textContent = "The runs with and without the plugin differ after step " + about.difference + ".";
    }
    if (about.world)
      for (const value of ["tests", "saved"]) document.querySelector("#pair-order option[value=" + value + "]").remove();
    if (this.model.stock === "off") {
      words.push("stock Box2D does not have these polygons: “off”, in its place, is the plugin told to be off (BOOMERANG=off)");
      for (const option of document.querySelectorAll("#pair-order option")) option.textContent = option.textContent.replace("in stock", "with it off");
    }
    document.getElementById("subtitle").textContent = words.filter(Boolean).join(" · ");
  }

  // Colours are read anew.
  themed() {
    this.view.readColours();
    this.timeline.strip.forget();
    this.figures.strip?.forget();
    this.redraw();
  }

  resized() {
    const { width, height } = this.view;
    this.view.resize();
    // A view that got its first size, or another one: the same middle stays, at the same share of the view.
    if (width > 0 && height > 0) this.view.camera.scale *= Math.min(this.view.width / width, this.view.height / height);
    this.redraw();
  }

  redraw() {
    this.dirty = true;
    this.link?.changed();
  }

  say(text) { document.getElementById("status").textContent = text; }

  seek(step, byHand) {
    this.step = Math.min(this.model.stepCount - 1, Math.max(0, step));
    if (byHand) {
      this.pause(false);
      clearTimeout(this.saying);
      this.saying = setTimeout(() => this.say(this.describe()), 400);
    }
    this.redraw();
  }

  describe() {
    this.model.moveTo(this.step);
    let handed = 0;
    for (const pair of this.model.pairsHere) if (this.model.answerAt(this.model.rowOf(pair, this.step)) === HANDED_OVER) ++handed;
    return "Step " + this.step + " of " + (this.model.stepCount - 1) + ": " + this.model.pairsHere.length + " pairs" + (this.model.about.world ? "." : ", " + handed + " handed to Box2D.");
  }

  toggle() {
    if (this.playing) { this.pause(true); return; }
    if (this.step >= this.model.stepCount - 1) this.step = 0;
    this.playing = true;
    this.clock = null;
    this.markPlaying();
    this.say("Playing.");
  }

  pause(aloud) {
    if (!this.playing) return;
    this.playing = false;
    this.markPlaying();
    if (aloud) this.say("Paused. " + this.describe());
  }

  markPlaying() {
    document.getElementById("play").textContent = this.playing ? "Pause" : "Play";
    this.link?.changed();
  }

  zoomTo(group) {
    if (!group) return;
    if (group.body !== undefined) group = { a: group.body, b: group.body, spans: [] };
    const m = this.model, box = [Infinity, Infinity, -Infinity, -Infinity];
    m.moveTo(this.step);
    const pair = m.spanAt(group, this.step), links = this.view.links;
    const add = (x, y) => {
      box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], y);
    };
    const bodies = this.view.bodiesOf(group).filter((body) => body >= 0);
    if (!bodies.length) { this.say("Neither body is there at this step."); return; }
    // Both whole; of one that is far larger (a ground), what is near.
    const farLarger = 10;
    const small = bodies.reduce((a, b) => (m.reach[b] < m.reach[a] ? b : a));
    for (const body of bodies) {
      const reach = m.reach[body];
      if (reach > farLarger * m.reach[small]) continue;
      add(m.x[body] - reach, m.y[body] - reach);
      add(m.x[body] + reach, m.y[body] + reach);
    }
    if (pair !== undefined && m.linkOf(pair, links)) { add(links[0], links[1]); add(links[2], links[3]); }
    this.view.frame(box, m.reach[small]);
    this.view.moved = true;
    this.redraw();
  }

  // At speed 1 a second is a second, whatever the screen's rate: where drawing is slow, steps are left out.
  tick(now) {
    if (this.playing) {
      this.clock ??= { now, step: this.step, speed: this.speed };
      if (this.clock.speed !== this.speed) this.clock = { now, step: this.step, speed: this.speed };
      const step = this.clock.step + Math.floor(((now - this.clock.now) / 1000) * this.speed / this.model.about.timeStep);
      if (step !== this.step) this.seek(step, false);
      if (this.step >= this.model.stepCount - 1) { this.playing = false; this.markPlaying(); this.say("The end. " + this.describe()); }
    }
    if (this.dirty) {
      this.dirty = false;
      this.draw();
    }
    requestAnimationFrame((next) => this.tick(next));
  }

  draw() {
    this.view.draw(this.step, this.pairs.chosen);
    this.timeline.draw(this.step);
    this.figures.draw(this.step);
    this.pairs.draw();
    const scrub = document.getElementById("scrub"), seconds = (this.step * this.model.about.timeStep).toFixed(2);
    scrub.value = this.step;
    scrub.setAttribute("aria-valuetext", "step " + this.step + ", " + seconds + " seconds");
    document.getElementById("readout").textContent = "step " + this.step + " / " + (this.model.stepCount - 1) + " · " + seconds + " s";
  }
}

// For whoever wants the numbers: in a console, or in a test.
function exposeReplay(app) {
  const m = app.model;
  window.replay = {
    about: m.about,
    get step() { return app.step; },
    get playing() { return app.playing; },
    get framesDrawn() { return app.view.framesDrawn; },
    get chosen() { const its = app.pairs.chosen; return its && (its.body === undefined ? [its.a, its.b] : its.body); },
    get camera() { return { ...app.view.camera }; },
    totals: app.figures.total,
    seek: (step) => app.seek(step, false),
    play: () => app.playing || app.toggle(),
    pause: () => app.pause(false),
    choose: (a, b) => app.pairs.choose(m.groupOf(a, b) ?? null),
    chooseBody: (body) => app.pairs.choose({ body }),
    // Where a body's middle is in the view.
    placeOf: (body) => app.view.placeOfNumber(m.entryOf[body]),
    // What the last drawing showed.
    bodies: () => [...m.c["body.number"].keys()].filter((body) => m.present[body]).map((body) => ({
      number: m.c["body.number"][body], x: m.x[body], y: m.y[body], cos: m.cos[body], sin: m.sin[body],
      awake: (m.flags[body] & 1) !== 0,
    })),
    // The middle of the line between two bodies, in the view; null where there is none now.
    linkOf: (a, b) => {
      const group = m.groupOf(a, b), pair = group && m.spanAt(group, app.step), ends = app.view.links;
      return pair !== undefined && m.linkOf(pair, ends) ? app.view.toScreen((ends[0] + ends[2]) / 2, (ends[1] + ends[3]) / 2) : null;
    },
    pairs: () => m.groups.map((group) => ({ a: group.a, b: group.b, events: group.events.length, tests: group.tests })),
    pair: (a, b) => {
      const group = m.groupOf(a, b);
      return group && {
        events: group.events.map((i) => m.event(i)),
        steps: group.spans.flatMap((pair) => Array.from({ length: m.c["pair.steps"][pair] }, (_, at) => {
          const row = m.stepStart[pair] + at;
          return { step: m.c["pair.first"][pair] + at, slack: m.slackAt(row), answer: m.answerAt(row),
            touching: m.isTouchingAt(row), polygon: m.c["step.polygon"][row], toi: m.c["step.toi"][row], overlap: m.c["step.overlap"][row] };
        })),
      };
    },
  };
}

async function start() {
  const about = JSON.parse(document.getElementById("about").textContent);
  let app = null;
  connectTheme(() => app?.themed());
  app = new App(about, await decodePage());
  exposeReplay(app);
  document.documentElement.dataset.ready = "yes";
}

start().catch((error) => {
  const problem = document.getElementById("problem");
  problem.hidden = false;
  problem.textContent = "The replay cannot be shown: " + error.message;
  console.error(error);
});
