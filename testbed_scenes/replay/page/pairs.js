// The list of pairs, the pair that is chosen, and what is said of it.

const LIST_LIMIT = 200;

class Pairs {
  constructor(model, timeline, app) {
    Object.assign(this, { model, timeline, app });
    this.list = document.getElementById("pair-list");
    this.filter = document.getElementById("pair-filter");
    this.order = document.getElementById("pair-order");
    this.chosen = null;
    this.active = -1;
    this.filter.addEventListener("input", () => this.refill());
    this.order.addEventListener("change", () => this.refill());
    this.list.addEventListener("click", (event) => {
      const row = event.target.closest("li");
      if (row) this.choose(this.shown[Number(row.dataset.row)]);
    });
    this.list.addEventListener("keydown", (event) => this.onKey(event));
    document.getElementById("event-back").addEventListener("click", () => this.goToEvent(-1));
    document.getElementById("event-on").addEventListener("click", () => this.goToEvent(1));
    document.getElementById("pair-zoom").addEventListener("click", () => app.zoomTo(this.chosen));
    document.getElementById("pair-drop").addEventListener("click", () => { this.choose(null); this.list.focus(); });
    document.getElementById("event-list").addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button) app.seek(Number(button.dataset.step), true);
    });
    this.refill();
  }

  onKey(event) {
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8, Home: -Infinity, End: Infinity };
    if (event.key in steps && this.shown.length) {
      event.preventDefault();
      this.active = Math.min(this.shown.length - 1, Math.max(0, this.active + steps[event.key]));
      this.markActive(true);
    } else if ((event.key === "Enter" || event.key === " ") && this.active >= 0) {
      event.preventDefault();
      this.choose(this.shown[this.active]);
    } else return;
    event.stopPropagation();
  }

  nearness(group) {
    const step = this.app.step, pair = this.model.spanAt(group, step);
    if (pair === undefined) return Infinity;
    return this.model.slackAt(this.model.rowOf(pair, step)) ?? 1e9;
  }

  matching() {
    const numbers = (this.filter.value.match(/\d+/g) || []).map(Number);
    return this.model.groups.filter((group) => numbers.every((number) => group.a === number || group.b === number));
  }

  refill() {
    let groups = this.matching();
    const order = this.order.value;
    if (order === "near") {
      this.model.moveTo(this.app.step);
      const near = new Map(groups.map((group) => [group, this.nearness(group)]));
      groups = groups.filter((group) => near.get(group) < Infinity).sort((a, b) => near.get(a) - near.get(b));
    } else if (order !== "number") {
      const value = { events: (group) => group.events.length, tests: (group) => group.tests, saved: (group) => group.saved }[order];
      groups.sort((a, b) => value(b) - value(a) || a.a - b.a || a.b - b.b);
    } else groups.sort((a, b) => a.a - b.a || a.b - b.b);
    this.shown = groups.slice(0, LIST_LIMIT);
    this.list.replaceChildren(...this.shown.map((group, row) => this.rowFor(group, row)));
    this.active = this.shown.indexOf(this.chosen);
    this.markActive(false);
    const all = this.model.groups.length;
    document.getElementById("pair-count").textContent = groups.length === 0 ? "No such pair."
      : this.shown.length < groups.length ? "The first " + this.shown.length + " of " + groups.length.toLocaleString("en") + " pairs; a body's number narrows them."
      : groups.length < all ? groups.length + " of " + all.toLocaleString("en") + " pairs." : countText(all, "pair") + ".";
  }

  rowFor(group, row) {
    const item = document.createElement("li");
    item.id = "pair-row-" + row;
    item.dataset.row = row;
    item.setAttribute("role", "option");
    item.setAttribute("aria-selected", group === this.chosen);
    const facts = document.createElement("span");
    facts.textContent = group.events.length + " events" + (this.model.about.world ? "" : ", " + group.tests + " tests in " + this.model.stock);
    item.append(group.a + " – " + group.b, facts);
    return item;
  }

  markActive(scroll) {
    [...this.list.children].forEach((item, row) => item.classList.toggle("active", row === this.active));
    if (this.active < 0) { this.list.removeAttribute("aria-activedescendant"); return; }
    this.list.setAttribute("aria-activedescendant", "pair-row-" + this.active);
    if (!scroll) return;
    const item = this.list.children[this.active];
    if (item.offsetTop < this.list.scrollTop) this.list.scrollTop = item.offsetTop;
    const below = item.offsetTop + item.offsetHeight - this.list.clientHeight;
    if (below > this.list.scrollTop) this.list.scrollTop = below;
  }

  // A pair (a group of the model), a body ({ body: its number }), or null: nothing.
  choose(what) {
    const group = what?.body === undefined ? what : null;
    this.chosen = what;
    if (what?.body !== undefined || (!what && this.listsBody)) {
      this.listsBody = what !== null;
      this.filter.value = what ? what.body : "";
      this.refill();
    }
    [...this.list.children].forEach((item, row) => item.setAttribute("aria-selected", this.shown[row] === group));
    this.active = this.shown.indexOf(group);
    this.markActive(true);
    this.timeline.choose(group ?? this.sumOf(what));
    for (const id of ["event-back", "event-on", "pair-events"]) document.getElementById(id).hidden = !group;
    document.getElementById("timeline").hidden = this.timeline.events.length === 0;
    document.getElementById("pair-buttons").hidden = !what;
    document.getElementById("pair-zoom").textContent = group ? "Zoom to pair" : "Zoom to body";
    document.getElementById("pair-title").textContent = group ? "Bodies " + group.a + " and " + group.b : what ? "Body " + what.body : "All pairs";
    document.getElementById("timeline").setAttribute("aria-label", this.timeline.describe());
    this.fillEvents();
    this.app.redraw();
    if (what && !group) this.app.say("Body " + what.body + " chosen; its pairs are listed.");
    if (group) this.app.say("Bodies " + group.a + " and " + group.b + " chosen, " + group.events.length + " events.");
  }

  // The events of all pairs, or of a body's.
  sumOf(what) {
    const groups = this.model.groups.filter((group) => !what || group.a === what.body || group.b === what.body);
    return { events: groups.flatMap((group) => group.events) };
  }

  fillEvents() {
    const events = this.timeline.isSum() ? [] : this.timeline.events;
    document.getElementById("event-summary").textContent = "Events (" + events.length + ")";
    document.getElementById("event-list").replaceChildren(...events.slice(0, 1000).map((event) => {
      const item = document.createElement("li"), button = document.createElement("button");
      button.type = "button";
      button.dataset.step = event.step;
      button.textContent = event.step + "  " + event.kind + levelText(event) + (event.gap > 0 ? "  " + lengthText(event.gap) : "");
      item.append(button);
      return item;
    }));
  }

  goToEvent(direction) {
    if (this.timeline.isSum()) return;
    const steps = this.timeline.events.map((event) => event.step);
    const next = direction > 0 ? steps.find((step) => step > this.app.step) : steps.reverse().find((step) => step < this.app.step);
    if (next === undefined) this.app.say(direction > 0 ? "No later event." : "No earlier event.");
    else this.app.seek(Math.max(0, next), true);
  }

  // One sentence about the chosen pair at the present step.
  describeNow() {
    const m = this.model, group = this.chosen, step = this.app.step;
    if (!group) return "Events in each step. Click a body or a line between two bodies, or choose a pair in the list.";
    if (group.body !== undefined) return describeBody(m, group.body, step) + ". Its pairs stand in the list.";
    const pair = m.spanAt(group, step);
    if (pair === undefined) return m.about.world ? "Nobody watches them at this step: their cells are no neighbours." : "No contact between them at this step: their boxes are apart.";
    const row = m.rowOf(pair, step), slack = m.slackAt(row), answer = m.answerAt(row);
    if (m.about.pair && answer === MANIFOLD) return "In contact: nothing can prove them apart.";
    if (m.about.world && answer === MANIFOLD) return "A contact since the frame before.";
    const words = [ANSWERS[answer][0].toUpperCase() + ANSWERS[answer].slice(1)];
    if (slack > 0) {
      const [from, until] = m.proofsAt(pair, step);
      const kinds = new Set();
      for (let i = from; i < until; ++i)
        kinds.add(PROOF_KINDS[m.c["proof.kind"][i]] + (m.c["proof.kind"][i] === 1 ? " of level " + m.c["proof.level"][i] : ""));
      words.push("at least " + lengthText(slack) + (m.about.world ? "" : " m") + " apart" + (kinds.size ? " by " + [...kinds].join(", ") : ""));
    } else if (m.isTouchingAt(row)) words.push("they touch");
    else if (slack === 0) words.push("nothing is proved");
    const tests = [[m.c["step.polygon"][row], "polygon test"], [m.c["step.toi"][row], "time of impact"], [m.c["step.overlap"][row], "overlap test"]]
      .filter(([count]) => count > 0).map(([count, name]) => count + " × " + name);
    if (!m.about.world) words.push(m.stock + ": " + (tests.join(", ") || "no test"));
    return words.join("; ") + ".";
  }

  draw() {
    const now = document.getElementById("pair-now"), text = this.describeNow();
    if (now.textContent !== text) now.textContent = text;
    const details = document.getElementById("pair-events");
    if (details.hidden || !details.open) return;
    for (const button of document.querySelectorAll("#event-list button"))
      if (Number(button.dataset.step) === this.app.step) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
  }
}
