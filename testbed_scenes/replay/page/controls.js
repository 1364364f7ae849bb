// Playback, overlays, camera, theme and keys: everything that a hand does.

const OVERLAYS = [
  { name: "slack", text: "Slack: near wide, far thin", on: true, sample: ["slack-1", 3, ""] },
  { name: "handed", text: "Handed to Box2D: crossed", on: true, sample: ["handed", 2, "", "cross"] },
  { name: "contacts", text: "Contacts (plugin’s if uncrossed)", on: true, sample: ["contact", 0, "", "diamond"] },
  { name: "certificates", text: "Certificates: line and gap", on: false, sample: ["certificate", 2, ""] },
  { name: "envelopes", text: "Envelopes at the certified level", on: false, sample: ["envelope", 1.6, "7 3"] },
  { name: "hulls", text: "Hulls", on: false, sample: ["hull", 1.6, "2 3"] },
  { name: "boxes", text: "Boxes of the broad phase", on: false, sample: ["box", 1.2, "1 2"] },
  { name: "joints", text: "Joints", on: true, sample: ["joint", 1.6, ""] },
  { name: "numbers", text: "Body numbers", on: false, sample: ["ink", 0, "", "number"] },
  { name: "trails", text: null, on: false, sample: ["trail", 1.4, ""] },
];

const BODY_LINES = [["dynamic", ""], ["sleeping", "4 2"], ["static", ""], ["kinematic", "9 2 2 2"], ["sensor", "1 3"]];

const KEYS = [
  ["Space", "play, pause"], [", .", "one step back, on"], ["Home End", "first, last step (outside of lists)"],
  ["[ ]", "the chosen pair's event before, after"], ["1 – 9", "overlays, in their order"],
  ["+ − 0", "zoom in, out, fit"], ["z", "zoom to the chosen pair"], ["Arrows", "move the view, when it has the focus"],
  ["p", "to the list of pairs; arrows and Enter choose"], ["Esc", "let the pair or body go"], ["s", "save the view as a PNG"], ["?", "these keys"],
];

// Of a kinetic world, where they are not the same: there is no Box2D in it, and cells take the place of boxes.
// What has no text has no switch.
const WORLD_TEXTS = {
  contacts: "Contacts since the frame before", certificates: "Certificates: lines, and disks (dashed)", boxes: "Cells of the bodies",
  hulls: "Disks of the bodies", handed: null, envelopes: null, joints: null,
  trails: "Trails of two units of time",
};

// Of one pair alone.
const PAIR_TEXTS = { ...WORLD_TEXTS, contacts: null, certificates: "Certificate: line and gap", hulls: null, boxes: null };
delete PAIR_TEXTS.envelopes;

function svgSample([colour, width, dash, glyph]) {
  const stroke = "stroke=\"var(--" + colour + ")\"";
  const inner = {
    diamond: "<path d=\"M7 7 L13 1 L19 7 L13 13 Z\" fill=\"var(--" + colour + ")\"/>",
    number: "<text x=\"6\" y=\"12\" font-size=\"12\" fill=\"var(--" + colour + ")\">12</text>",
    cross: "<path d=\"M1 7 H25 M9 3 L17 11 M9 11 L17 3\" fill=\"none\" " + stroke + " stroke-width=\"2\"/>",
  }[glyph] ?? "<path d=\"M1 7 H25\" " + stroke + " stroke-width=\"" + width + "\" stroke-dasharray=\"" + dash + "\"/>";
  return "<svg width=\"26\" height=\"14\" viewBox=\"0 0 26 14\" aria-hidden=\"true\">" + inner + "</svg>";
}

function buildSwitches(app) {
  const room = document.getElementById("switches");
  OVERLAYS.forEach((overlay, i) => {
    const label = document.createElement("label");
    label.innerHTML = "<input type=checkbox>" + svgSample(overlay.sample) + "<span></span>" + (i < 9 ? "<kbd aria-hidden=true>" + (i + 1) + "</kbd>" : "");
    const texts = app.model.about.pair ? PAIR_TEXTS : app.model.about.world ? WORLD_TEXTS : {};
    const text = overlay.name in texts ? texts[overlay.name] : overlay.text;
    label.querySelector("span").textContent = text ?? overlay.name;
    label.hidden = text === null;
    const box = label.querySelector("input");
    box.id = "show-" + overlay.name;
    box.checked = app.options[overlay.name] = overlay.on;
    box.addEventListener("change", () => { app.options[overlay.name] = box.checked; app.redraw(); });
    room.append(label);
  });
  if (app.model.about.boxes === false) document.getElementById("show-boxes").closest("label").hidden = true;
}

function buildLegend(app) {
  const entry = (sample, text) => "<span>" + svgSample(sample) + text + "</span>";
  const bounds = app.view.slackBounds, parts = ["<p>Slack: certified distance" + (app.model.about.world ? "" : ", in metres") + "</p>"];
  bounds.forEach((bound, i) => {
    const text = i + 1 < bounds.length ? "≤ " + lengthText(bound) : "more";
    parts.push(entry(["slack-" + i, SLACK_WIDTHS[i], ""], text));
  });
  parts.push(entry(["unproved", 1, "2 3"], "not proved"), "<p>Bodies</p>");
  for (const [look, dash] of BODY_LINES) parts.push(entry([look + "-edge", look === "static" ? 2.4 : 1.6, dash], look));
  document.getElementById("legend").innerHTML = parts.join("");
}

function connectTransport(app) {
  const on = (id, act) => document.getElementById(id).addEventListener("click", act);
  on("play", () => app.toggle());
  on("first", () => app.seek(0, true));
  on("last", () => app.seek(app.model.stepCount - 1, true));
  on("back", () => app.seek(app.step - 1, true));
  on("forward", () => app.seek(app.step + 1, true));
  const scrub = document.getElementById("scrub");
  scrub.max = app.model.stepCount - 1;
  scrub.addEventListener("input", () => app.seek(Number(scrub.value), true));
  const speed = document.getElementById("speed");
  speed.addEventListener("change", () => (app.speed = Number(speed.value)));
  on("zoom-in", () => { app.view.zoom(1.4); app.redraw(); });
  on("zoom-out", () => { app.view.zoom(1 / 1.4); app.redraw(); });
  on("zoom-fit", () => { app.view.fit(app.step); app.redraw(); });
  on("save", () => savePng(app));
}

// Drag moves, wheel and pinch zoom, a tap chooses: a body, or between bodies a pair.
function connectPointer(app) {
  const canvas = app.view.canvas, pointers = new Map();
  let moved = 0;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const spread = () => {
    const [[ax, ay], [bx, by]] = [...pointers.values()];
    return [Math.hypot(ax - bx, ay - by), (ax + bx) / 2, (ay + by) / 2];
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 0) moved = 0;
    pointers.set(event.pointerId, at(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = pointers.size === 2 ? spread() : null, [x0, y0] = pointers.get(event.pointerId);
    const [x, y] = at(event);
    pointers.set(event.pointerId, [x, y]);
    moved += Math.abs(x - x0) + Math.abs(y - y0);
    if (before) {
      const after = spread();
      app.view.pan(after[1] - before[1], after[2] - before[2]);
      if (before[0] > 0) app.view.zoom(after[0] / before[0], after[1], after[2]);
    } else if (pointers.size === 1) app.view.pan(x - x0, y - y0);
    app.redraw();
  });
  const lift = (event) => {
    if (!pointers.delete(event.pointerId) || event.type !== "pointerup" || moved > 6 || pointers.size > 0) return;
    const [x, y] = at(event), found = whatIsAt(app.view, x, y, app.step);
    app.pairs.choose(found);
    if (!found) app.say("Nothing there: let go.");
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    app.view.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)), ...at(event));
    app.redraw();
  }, { passive: false });
}

function connectKeys(app) {
  const help = document.getElementById("help"), list = document.getElementById("keys");
  for (const [keys, text] of KEYS) {
    const term = document.createElement("dt"), meaning = document.createElement("dd");
    for (const key of keys.split(" ")) {
      const cap = document.createElement(key === "–" ? "span" : "kbd");
      cap.textContent = key;
      term.append(cap, " ");
    }
    meaning.textContent = text;
    list.append(term, meaning);
  }
  document.getElementById("help-open").addEventListener("click", () => help.showModal());
  document.getElementById("help-close").addEventListener("click", () => help.close());
  const panning = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  app.view.canvas.addEventListener("keydown", (event) => {
    if (!(event.key in panning) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    app.view.pan(...panning[event.key].map((sign) => sign * 48));
    app.redraw();
  });
  document.addEventListener("keydown", (event) => {
    if (help.open || event.ctrlKey || event.altKey || event.metaKey) return;
    const tag = event.target.tagName, typing = tag === "SELECT" || (tag === "INPUT" && event.target.type === "text");
    if (typing || ((event.key === " " || event.key === "Home" || event.key === "End") && /^(BUTTON|INPUT|SUMMARY|A|UL)$/.test(tag))) return;
    const overlay = OVERLAYS[Number(event.key) - 1];
    const act = overlay ? () => document.getElementById("show-" + overlay.name).click() : {
      " ": () => app.toggle(), ",": () => app.seek(app.step - 1, true), ".": () => app.seek(app.step + 1, true),
      Home: () => app.seek(0, true), End: () => app.seek(app.model.stepCount - 1, true),
      "[": () => app.pairs.goToEvent(-1), "]": () => app.pairs.goToEvent(1),
      "+": () => { app.view.zoom(1.25); app.redraw(); }, "=": () => { app.view.zoom(1.25); app.redraw(); },
      "-": () => { app.view.zoom(0.8); app.redraw(); }, 0: () => { app.view.fit(app.step); app.redraw(); },
      z: () => app.zoomTo(app.pairs.chosen), p: () => app.pairs.list.focus(),
      Escape: () => app.pairs.chosen && app.pairs.choose(null), "?": () => help.showModal(),
      s: () => savePng(app),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

// "system" follows the preference, also when it changes.
function connectTheme(onChange) {
  const choice = document.getElementById("theme"), dark = window.matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    document.documentElement.dataset.theme = choice.value || (dark.matches ? "dark" : "light");
    onChange();
  };
  choice.addEventListener("change", apply);
  dark.addEventListener("change", apply);
  apply();
}
