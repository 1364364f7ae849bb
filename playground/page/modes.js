// SPDX-License-Identifier: MIT
// The five ways to play. `use` begins one (and returns an error number), `fields` is what may be chosen.

const LAZY_BADGES = ["push", "stab", "roll"], CELL_BADGES = ["stab", "cross", "page-turn"];

const LEGEND = {
  pair: [["--a", "A"], ["--b", "B"], ["--certificate", "the line that separates", "stroke"], ["--watched", "watched corner and its window", "stroke"],
    ["--event", "line before the event", "stroke"]],
  mixed: [["--a", "A, and its triangles"], ["--b", "B, and its triangles"], ["--cell", "parallelograms"], ["--certificate", "the line that separates", "stroke"], ["--soft", "A and B overlap"], ["--chosen", "the cell that x is in"]],
  many: [["--certificate", "pairs with a proof by a line", "stroke"], ["--faint", "candidates: disks are apart", "stroke"], ["--contact", "contacts"]],
};

const structureField = (key, label) => ({ kind: "structure", key, label, wide: true });
const levelField = { kind: "select", key: "levels", label: "Levels shown", wide: true,
  options: [["none", "none"], ["proof", "the certificate's level"], ["all", "all levels"]] };
const cornersField = (key, label, most) => ({ kind: "steps", key, label, steps: CORNERS.filter((n) => n <= most) });

const MODES = {
  learn: {
    title: "Learn", course: true, rate: 1, stops: true, badges: LAZY_BADGES, legend: ["pair"],
    intro: "B passes A while it turns. The film stops at each event and says what it was: a push, a roll, a stab.",
    last: "That was all of it. Take hold of B yourself in Hands on, or let the motions of the paper play in Motions.",
    use: (core, place) => core.call("use_lesson", core.structure(place.structure).index),
    fields: [structureField("structure", "Structure"), levelField],
  },
  hands: {
    title: "Hands on", hand: true, badges: LAZY_BADGES, legend: ["pair"], draws: true, poses: "poses",
    intro: "Drag A and B, turn them by their knobs. Bring B close to A: the nearer, the finer the level.",
    use(core, place) {
      for (const body of [0, 1]) {
        const error = setShape(core, body, place.shapes[body]);
        if (error) return error;
      }
      return core.call("use_hand", core.structure(place.structure).index, ...place.poses[0], ...place.poses[1]);
    },
    fields: [structureField("structure", "Structure"), levelField,
      ...[0, 1].flatMap((body) => [{ kind: "shape", body, label: `Shape of ${"AB"[body]}` }, { kind: "shapeCorners", body, label: `Corners of ${"AB"[body]}` }])],
  },
  motions: {
    title: "Motions", course: true, rate: 1 / 12, follows: true, badges: LAZY_BADGES, legend: ["pair"], timeline: true,
    intro: "The motions that the paper's table of bounds is about. Move D/σ and n: who gets more events, and who does not?",
    use(core, place) {
      const ngon = core.ngons.indexOf(place.ngon);
      return core.call("set_ngon", 0, ngon, place.n, place.seed) || core.call("set_ngon", 1, ngon, place.n, place.seed + 1) ||
        core.call("use_family", core.structure(place.structure).index, core.families.indexOf(place.family), 2 ** place.ratio, place.seed);
    },
    fields: [structureField("structure", "Structure"), { kind: "select", key: "family", label: "Motion", options: (core) => core.families.map((f) => [f, f]) },
      { kind: "select", key: "ngon", label: "Shape", options: (core) => core.ngons.map((o) => [o, o]) },
      { kind: "range", key: "ratio", label: "D/σ", low: 1, high: 20, show: (v) => (2 ** v).toLocaleString("en") }, cornersField("n", "Corners n", 256),
      { kind: "range", key: "seed", label: "Another one (seed)", low: 1, high: 50 }, levelField],
  },
  mixed: {
    title: "Mixed", more: " hierarchy", hand: true, badges: CELL_BADGES, legend: ["mixed"], mixed: true, poses: "mixedPoses",
    intro: "The second picture has all places that B can have, cut into cells. x is where B is now. Drag x through the cells; turn B, and they change.",
    use(core, place) {
      return setShape(core, 0, { points: roundish(place.small[0], 0.4) }) || setShape(core, 1, { points: roundish(place.small[1], 1.5) }) ||
        core.call("use_hand", core.structure(place.cells).index, ...place.mixedPoses[0], ...place.mixedPoses[1]);
    },
    fields: [{ kind: "select", key: "cells", label: "Hierarchies", wide: true, options: [["active-cell-dudley", "Dudley"], ["active-cell-compass", "compass"]] },
      { kind: "small", body: 0, label: "Corners of A" }, { kind: "small", body: 1, label: "Corners of B" }],
  },
  many: {
    title: "Many", more: " bodies", crowd: true, badges: [], legend: ["many"],
    intro: "A world without time steps: each contact is met at its own time. Click near a body, or press K, to kick one.",
    use: (core, place) => core.call("use_crowd", core.structure(place.pairs).index, place.bodies, place.corners, place.packing, place.seed),
    fields: [{ kind: "range", key: "bodies", label: "Bodies", low: 2, high: 400 }, cornersField("corners", "Corners of each", 64),
      { kind: "range", key: "packing", label: "Packing of disks", low: 0.02, high: 0.45, step: 0.01, show: (v) => (+v).toFixed(2) },
      { kind: "range", key: "seed", label: "Another one (seed)", low: 1, high: 50 }, structureField("pairs", "Structure of near pairs"),
      ...[[4, "pairs with a proof"], [2, "candidates"], [1, "cells of the grids"]].map(([bit, label]) => ({ kind: "bit", key: "shown", bit, label: `Show ${label}` }))],
  },
};

function setShape(core, body, shape) {
  if (!shape.points) return core.call("set_ngon", body, core.ngons.indexOf(shape.ngon), shape.n, shape.seed);
  core.call("sketch_clear");
  for (const [x, y] of shape.points) core.call("sketch_add", x, y);
  const error = core.call("sketch_take", body);
  core.call("sketch_clear");
  return error;
}

/** n corners without symmetry on an ellipse that is not too long. */
function roundish(n, phase) {
  return Array.from({ length: n }, (_, i) => {
    const angle = (2 * Math.PI * (i + 0.25 * Math.sin(2.4 * i + phase))) / n + phase;
    return [1.1 * Math.cos(angle), 0.75 * Math.sin(angle)];
  });
}

/** The inputs of a mode. `changed(restart)` is called after a choice; only looks change without a restart. */
function buildFields(mode, core, place, changed) {
  const box = byId("fields");
  box.replaceChildren(...MODES[mode].fields.map((field) => fieldElement(field, core, place, changed)));
}

function fieldElement(field, core, place, changed) {
  const className = field.wide ? "wide" : "";
  if (field.kind === "bit") {
    const input = element("input", { type: "checkbox", checked: (place[field.key] & field.bit) !== 0 });
    input.addEventListener("change", () => {
      place[field.key] ^= field.bit;
      changed(false);
    });
    return element("label", { className: "check wide" }, input, field.label);
  }
  if (field.kind === "structure") return labelled(field, className, structureSelect(core, place[field.key], (name) => {
    place[field.key] = name;
    changed(true);
  }));
  if (field.kind === "select" || field.kind === "shape") {
    const isShape = field.kind === "shape", shape = isShape && place.shapes[field.body];
    let options = isShape ? core.ngons.map((o) => [o, o]) : typeof field.options === "function" ? field.options(core) : field.options;
    if (isShape && shape.points) options = [["", "your own"], ...options];
    const select = element("select", {}, ...options.map(([value, text]) => element("option", { value, textContent: text })));
    select.value = isShape ? (shape.points ? "" : shape.ngon) : place[field.key];
    select.addEventListener("change", () => {
      if (isShape && select.value) place.shapes[field.body] = { ngon: select.value, n: shape.n || 12, seed: shape.seed || 1 };
      else if (!isShape) place[field.key] = select.value;
      changed(field.key !== "levels");
    });
    return labelled(field, className, select);
  }
  return rangeElement(field, place, changed);
}

function labelled(field, className, input, ...more) {
  return element("label", { className }, element("span", {}, field.label, ...more), input);
}

function structureSelect(core, chosen, choose) {
  const groups = ["take one of these", "to compare with", "rivals"].map((label, role) => element("optgroup", { label },
    ...core.structures.filter((s) => s.offered && s.role === role).map((s) => element("option", { value: s.name, textContent: s.name, title: s.title }))));
  const select = element("select", {}, ...groups);
  select.value = chosen;
  select.addEventListener("change", () => choose(select.value));
  return select;
}

function rangeElement(field, place, changed) {
  const steps = field.kind === "steps" ? field.steps : field.kind === "shapeCorners" ? CORNERS : null, shape = field.kind === "shapeCorners" && place.shapes[field.body];
  const get = () => field.kind === "small" ? place.small[field.body] : shape ? shape.n || 12 : place[field.key];
  const put = (value) => {
    if (field.kind === "small") place.small[field.body] = value;
    else if (shape) place.shapes[field.body].n = value;
    else place[field.key] = value;
  };
  const nearest = (value) => steps.reduce((best, n, i) => (Math.abs(n - value) < Math.abs(steps[best] - value) ? i : best), 0);
  const input = element("input", steps ? { type: "range", min: 0, max: steps.length - 1, step: 1 }
    : { type: "range", min: field.kind === "small" ? 3 : field.low, max: field.kind === "small" ? 12 : field.high, step: field.step || 1 });
  input.value = steps ? nearest(get()) : get();
  input.disabled = Boolean(shape && shape.points);
  const shown = element("span", { className: "value" }), text = () => (field.show ? field.show(get()) : String(get()));
  const show = () => {
    setText(shown, ` ${text()}`);
    input.setAttribute("aria-valuetext", text());
  };
  show();
  input.addEventListener("input", () => {
    put(steps ? steps[+input.value] : +input.value);
    show();
    changed(true);
  });
  return labelled(field, "", input, shown);
}
