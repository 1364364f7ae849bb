// SPDX-License-Identifier: MIT
// The program behind the page: the functions of playground/page.h, by their names without "play_".

const byId = (id) => document.getElementById(id);

/** An element with attributes, and children that are elements or texts. */
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key in made && key !== "list") made[key] = value;
    else made.setAttribute(key, value);
  made.append(...children);
  return made;
}

class Core {
  static async open() {
    const base64 = byId("wasm").textContent, text = atob(base64);
    const wasmBinary = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) wasmBinary[i] = text.charCodeAt(i);
    const module = await createPlayground({ wasmBinary });
    const page = module._play_open();
    if (!page) throw new Error("there is no memory for the playground");
    return new Core(module, page);
  }

  constructor(module, page) {
    this.module = module;
    this.page = page;
    const names = (count, name) => Array.from({ length: this.plain(count) }, (_, i) => this.text(this.plain(name, i)));
    this.structures = names("structure_count", "structure_name").map((name, index) => ({
      name, index, title: this.text(this.plain("structure_title", index)),
      offered: this.plain("structure_is_offered", index) === 1, role: this.plain("structure_role", index),
    }));
    this.families = names("family_count", "family_name");
    this.ngons = names("ngon_count", "ngon_name");
    this.kinds = [];
    for (let kind = 0, name; (name = this.text(this.plain("event_name", kind))); kind++)
      this.kinds.push({ kind, name, meaning: this.text(this.plain("event_meaning", kind, 0)), counts: this.plain("counts", kind) === 1 });
  }

  /** A function that takes the page first. */
  call(name, ...args) { return this.module["_play_" + name](this.page, ...args); }
  plain(name, ...args) { return this.module["_play_" + name](...args); }
  text(pointer) { return pointer ? this.module.UTF8ToString(pointer) : ""; }
  /** A sentence: 0 proof, 1 event, 2 counts, 3 crowd. */
  say(which) { return this.text(this.call("text", which)); }
  structure(name) { return this.structures.find((s) => s.name === name && s.offered) || this.structures.find((s) => s.name === "lazy-dudley"); }
  errorText(error) { return this.text(this.plain("error_text", error)); }

  /** Draws; the numbers of display.h. */
  draw(picture, option) {
    const count = this.call("draw", picture, option), at = this.call("numbers") >> 2;
    return this.module.HEAPF32.subarray(at, at + count);
  }
  /** [low x, low y, high x, high y] */
  frame(picture) {
    const at = this.call("frame_of", picture) >> 3;
    return Array.from(this.module.HEAPF64.subarray(at, at + 4));
  }
  marks(follower) {
    const count = this.call("mark_count", follower), at = this.call("marks", follower) >> 3;
    return Array.from(this.module.HEAPF64.subarray(at, at + 2 * count));
  }
  place(body) {
    const [x, y, angle, radius, corners] = [0, 1, 2, 3, 4].map((which) => this.call("place", body, which));
    return { x, y, angle, radius, corners };
  }
}
