// SPDX-License-Identifier: MIT
// The words and numbers beside the picture.

/** Sets a text where it is another: what is read aloud is read once. */
function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

class Panels {
  constructor(core) {
    this.core = core;
    this.badges = new Map();
    this.said = 0;
  }

  /** Which kinds of events have a badge: those of the paper's lazy structures, or those of cells. */
  begin(kinds, cells) {
    const list = byId("badges");
    list.replaceChildren();
    this.badges.clear();
    for (const name of kinds) {
      const kind = this.core.kinds.find((k) => k.name === name), count = element("b", { textContent: "0" });
      const item = element("li", { title: this.core.text(this.core.plain("event_meaning", kind.kind, cells ? 1 : 0)) }, element("span", { textContent: name }), count);
      item.dataset.kind = name;
      list.append(item);
      this.badges.set(kind.kind, { item, count });
    }
    this.last = null;
    this.events = this.core.call("event_count");
    this.rowsFor = null;
  }

  sum(follower, which) {
    return this.core.kinds.reduce((sum, k) => sum + (k.counts ? this.core.call(which, follower, k.kind) : 0), 0);
  }

  /** Everything, after something has happened. */
  update(isCourse) {
    const core = this.core, latest = core.call("latest"), events = core.call("event_count");
    for (const [kind, { item, count }] of this.badges) {
      setText(count, String(core.call("events", 0, kind)));
      item.classList.toggle("latest", kind === latest);
    }
    setText(byId("happened"), core.say(1));
    setText(byId("proof"), core.say(0));
    this.ladder();
    this.rivals(isCourse);
    if (events !== this.events) {
      this.events = events;
      this.sayLater(`${core.say(1)} ${core.say(2)}`);
    }
  }

  ladder() {
    const level = this.core.call("level"), deepest = this.core.call("deepest"), key = `${level}/${deepest}`;
    if (this.last === key) return;
    this.last = key;
    const names = Array.from({ length: deepest + 1 }, (_, i) => (i === 0 ? "0 rectangle" : i === deepest ? `${i} polygon` : String(i)));
    byId("ladder").replaceChildren("level ", ...(deepest === 0 ? ["polygon"] : names).map((text, i) =>
      element("span", { textContent: text, className: i === level ? "now" : "" })));
  }

  rivals(isCourse) {
    const core = this.core, body = byId("rival-rows"), followers = core.plain("follower_count");
    if (body.children.length !== followers)
      body.replaceChildren(...Array.from({ length: followers }, (_, i) => element("tr", { className: i === 0 ? "chosen" : "" },
        element("th", { scope: "row" }), element("td", {}, element("span"), element("span", { className: "bar" })), element("td"))));
    const most = Math.max(1, ...Array.from({ length: followers }, (_, i) => this.sum(i, isCourse ? "events_in_all" : "events")));
    byId("all-head").hidden = !isCourse;
    for (let i = 0; i < followers; i++) {
      const [name, now, all] = body.children[i].children, count = this.sum(i, "events");
      setText(name, core.structures[core.call("follower_structure", i)].name);
      setText(now.firstChild, count.toLocaleString("en"));
      now.lastChild.style.width = `${(100 * count) / most}%`;
      all.hidden = !isCourse;
      setText(all, this.sum(i, "events_in_all").toLocaleString("en"));
    }
  }

  /** To be read aloud, when things have come to rest for a moment. */
  sayLater(text) {
    this.next = text;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => setText(byId("status"), this.next), 700);
  }

  crowd() {
    setText(byId("happened"), this.core.say(3));
  }
}
