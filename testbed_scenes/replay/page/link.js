// The state of the page in its address, so that a link shows what its sender saw; and the view as a PNG.

const VIEW_DIGITS = 6;

class Link {
  constructor(app) {
    this.app = app;
    this.initial = Object.fromEntries(OVERLAYS.map((overlay) => [overlay.name, app.options[overlay.name]]));
    window.addEventListener("hashchange", () => { if (location.hash !== this.written) this.read(); });
  }

  // Step, choice, overlays that are not as at first, the view where a hand has moved it, the theme.
  text() {
    const app = this.app, words = ["step=" + app.step], chosen = app.pairs.chosen, theme = document.getElementById("theme").value;
    if (chosen) words.push(chosen.body === undefined ? "pair=" + chosen.a + "," + chosen.b : "body=" + chosen.body);
    const changed = OVERLAYS.filter(({ name }) => app.options[name] !== this.initial[name]).map(({ name }) => (app.options[name] ? "" : "-") + name);
    if (changed.length) words.push("show=" + changed.join(","));
    if (app.view.moved) {
      const { x, y, scale } = app.view.camera;
      words.push("view=" + [x, y, scale].map((value) => Number(value.toPrecision(VIEW_DIGITS))).join(","));
    }
    if (theme) words.push("theme=" + theme);
    return "#" + words.join("&");
  }

  // Soon, and not sixty times a second.
  changed() {
    if (this.app.playing || this.waiting) return;
    this.waiting = setTimeout(() => {
      this.waiting = null;
      const text = this.text();
      if (this.app.playing || text === location.hash) return;
      this.written = text;
      try { history.replaceState(null, "", text); } catch { /* a page in a frame may not */ }
    }, 250);
  }

  // What makes no sense is passed over.
  read() {
    const app = this.app, words = new URLSearchParams(location.hash.slice(1)), m = app.model;
    const numbers = (name) => (words.get(name) ?? "").split(",").map(Number);
    const [step] = numbers("step"), [a, b] = numbers("pair"), [body] = numbers("body"), [x, y, scale] = numbers("view");
    const shown = new Set((words.get("show") ?? "").split(","));
    for (const { name } of OVERLAYS) {
      const on = shown.has(name) ? true : shown.has("-" + name) ? false : this.initial[name];
      app.options[name] = document.getElementById("show-" + name).checked = on;
    }
    const theme = document.getElementById("theme");
    theme.value = ["light", "dark"].includes(words.get("theme")) ? words.get("theme") : "";
    theme.dispatchEvent(new Event("change"));
    if (words.has("step") && Number.isInteger(step)) app.seek(step, false);
    if (words.has("pair")) app.pairs.choose(m.groupOf(a, b) ?? null);
    else if (m.about.pair && !words.has("body")) app.pairs.choose(m.groups[0] ?? null);
    else app.pairs.choose(words.has("body") && m.c["body.number"].includes(body) ? { body } : null);
    if (words.has("view") && [x, y].every(Number.isFinite) && scale > 0) app.view.look(x, y, scale);
    app.redraw();
  }
}

// The canvas as it is, in a file that says what it shows.
function savePng(app) {
  app.draw();
  app.view.canvas.toBlob((blob) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = app.model.about.scene.replace(/[^A-Za-z0-9_-]+/g, "-") + "-step-" + app.step + ".png";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    app.say("Saved as " + link.download + ".");
  });
}
