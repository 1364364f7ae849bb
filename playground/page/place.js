// SPDX-License-Identifier: MIT
// What is chosen, and the address that says so: everything after # can be sent to somebody else.

// Corners that the slider for n goes through.
const CORNERS = [3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64, 96, 128, 192, 256];
const MODE_NAMES = ["learn", "hands", "motions", "mixed", "many"];
const LEVELS = ["none", "proof", "all"];

function firstPlace() {
  return {
    mode: "learn", structure: "lazy-dudley", levels: "proof",
    shapes: [{ ngon: "ellipse", n: 12, seed: 1 }, { ngon: "random", n: 10, seed: 3 }],
    poses: [[0, 0, 0], [2, 1, 0.6]],
    family: "tumble", ratio: 6, n: 32, ngon: "ellipse", seed: 1,
    cells: "active-cell-dudley", small: [6, 5], mixedPoses: [[0, 0, 0], [-0.45, -1.35, 0.4]],
    bodies: 60, corners: 8, packing: 0.25, pairs: "hybrid", shown: 4,
  };
}

const shapeText = (shape) => shape.points ? "p" + shape.points.map((p) => p.map((c) => +c.toFixed(3)).join("_")).join("~")
  : `${shape.ngon}*${shape.n}*${shape.seed}`;
function shapeOf(text) {
  if (text.startsWith("p")) {
    const points = text.slice(1).split("~").map((p) => p.split("_").map(Number));
    return points.length >= 3 && points.length <= 256 && points.every((p) => p.length === 2 && p.every(Number.isFinite)) ? { points } : null;
  }
  const [ngon, n, seed] = text.split("*");
  return +n >= 3 && +n <= 256 && +seed >= 0 ? { ngon, n: Math.round(+n), seed: Math.round(+seed) } : null;
}
const poseText = (poses) => poses.flat().map((c) => +c.toFixed(3)).join("_");
function posesOf(text) {
  const n = text.split("_").map(Number);
  return n.length === 6 && n.every((c) => Number.isFinite(c) && Math.abs(c) < 100) ? [n.slice(0, 3), n.slice(3)] : null;
}

/** What of a place a mode's address says. */
const PARTS = {
  learn: ["structure", "levels"], hands: ["structure", "levels", "a", "b", "poses"],
  motions: ["structure", "levels", "family", "ratio", "n", "ngon", "seed"],
  mixed: ["cells", "small", "at"], many: ["pairs", "bodies", "corners", "packing", "seed", "shown"],
};

function hashOf(place) {
  const said = {
    ...place, a: shapeText(place.shapes[0]), b: shapeText(place.shapes[1]), poses: poseText(place.poses),
    at: poseText(place.mixedPoses), small: place.small.join("_"),
  };
  return "#mode=" + place.mode + PARTS[place.mode].map((key) => `&${key}=${encodeURIComponent(said[key])}`).join("");
}

const within = (low, high) => (text) => text !== "" && +text >= low && +text <= high ? +text : null;
const wholeWithin = (low, high) => (text) => within(low, high)(text) === null ? null : Math.round(+text);
/** What makes no sense is left as it is. */
function placeOf(hash, core) {
  const place = firstPlace(), given = new URLSearchParams(hash.replace(/^#/, ""));
  const offered = (text) => core.structures.some((s) => s.name === text && s.offered) ? text : null;
  const oneOf = (names) => (text) => names.includes(text) ? text : null;
  const readers = {
    mode: oneOf(MODE_NAMES), structure: offered, pairs: offered, levels: oneOf(LEVELS), cells: oneOf(["active-cell-dudley", "active-cell-compass"]),
    family: oneOf(core.families), ngon: oneOf(core.ngons), ratio: wholeWithin(1, 20), n: wholeWithin(3, 256), seed: wholeWithin(0, 1e6),
    bodies: wholeWithin(2, 400), corners: wholeWithin(3, 64), packing: within(0.02, 0.45), shown: wholeWithin(0, 7), poses: posesOf,
  };
  for (const [key, read] of Object.entries(readers)) {
    const value = given.has(key) ? read(given.get(key)) : null;
    if (value !== null) place[key] = value;
  }
  const small = (given.get("small") || "").split("_").map(Number);
  if (small.length === 2 && small.every((n) => n >= 3 && n <= 12)) place.small = small.map(Math.round);
  if (given.has("at")) place.mixedPoses = posesOf(given.get("at")) || place.mixedPoses;
  ["a", "b"].forEach((key, body) => {
    const shape = given.has(key) ? shapeOf(given.get(key)) : null;
    if (shape && (shape.points || core.ngons.includes(shape.ngon))) place.shapes[body] = shape;
  });
  return place;
}
