// Numbers for the whole run: Box2D's own calls, stock beside the plugin, in total and step by step.

const CALLS = [
  ["polygon", "b2CollidePolygons"], ["toi", "b2TimeOfImpact"], ["distance", "b2Distance"], ["overlap", "b2TestOverlap"],
];

class Figures {
  constructor(table, chart, note, model, view, onSeek) {
    Object.assign(this, { table, chart, note, model, view });
    const c = model.c;
    this.hasStock = c["stock.polygon"].length > 0;
    this.hasPlugin = c["plugin.polygon"].length > 0;
    this.total = {};
    for (const side of ["stock", "plugin"])
      for (const [name] of CALLS) this.total[side + "." + name] = c[side + "." + name].reduce((sum, calls) => sum + calls, 0);
    if (!this.hasStock) {
      note.textContent = "Calls were not counted in this run.";
      table.hidden = chart.hidden = true;
      table.closest("details").hidden = model.about.world === true;
      return;
    }
    this.means = { stock: this.averages("stock"), plugin: this.averages("plugin") };
    this.highest = Math.max(1, ...this.means.stock, ...this.means.plugin);
    this.now = document.getElementById("totals-now");
    this.strip = new Strip(chart);
    this.build();
    chart.addEventListener("pointerdown", (event) => {
      const box = chart.getBoundingClientRect();
      onSeek(Math.round(((event.clientX - box.left) / box.width) * (model.stepCount - 1)));
    });
    const saved = this.total["stock.polygon"] - this.total["plugin.polygon"];
    const words = "Polygon tests in each step: " + model.stock + " " + this.total["stock.polygon"].toLocaleString("en") +
      " in all (line), with the plugin " + this.total["plugin.polygon"].toLocaleString("en") + " (filled).";
    note.textContent = words;
    chart.setAttribute("aria-label", words + (saved > 0 ? " " + saved + " saved." : ""));
  }

  // So that a chart of 300 pixels shows 600 steps and more: means of neighbours.
  averages(side) {
    const values = this.model.c[side + ".polygon"], count = Math.min(values.length, 300), means = [];
    for (let i = 0; i < count; ++i) {
      const from = Math.floor((i * values.length) / count), until = Math.floor(((i + 1) * values.length) / count);
      let sum = 0;
      for (let k = from; k < until; ++k) sum += values[k];
      means.push(sum / Math.max(1, until - from));
    }
    return means;
  }

  build() {
    this.table.innerHTML = "<caption class=unseen>Calls of Box2D's own functions in the whole run</caption><thead><tr><th scope=col>calls</th>" +
      "<th scope=col>" + this.model.stock + "</th><th scope=col>plugin</th><th scope=col>less</th></tr></thead><tbody></tbody>";
    const body = this.table.tBodies[0];
    for (const [name, title] of CALLS) {
      const row = body.insertRow(), head = document.createElement("th");
      head.scope = "row";
      head.textContent = title;
      row.append(head);
      const stock = this.total["stock." + name], plugin = this.total["plugin." + name];
      for (const text of [stock.toLocaleString("en"), this.hasPlugin ? plugin.toLocaleString("en") : "–",
        stock > 0 && this.hasPlugin ? (100 * (1 - plugin / stock)).toFixed(1) + " %" : "–"]) row.insertCell().textContent = text;
    }
  }

  textAt(x) {
    if (!this.hasStock || !this.strip.width) return "";
    const c = this.model.c, step = Math.min(this.model.stepCount - 1, Math.max(0, Math.round((x / this.strip.width) * (this.model.stepCount - 1))));
    return "step " + step + ": polygon tests " + c["stock.polygon"][step] + " by " + this.model.stock + (this.hasPlugin ? ", " + c["plugin.polygon"][step] + " with the plugin" : "");
  }

  draw(step) {
    if (!this.hasStock) return;
    const c = this.model.c;
    const both = (name) => c["stock." + name][step] + (this.hasPlugin ? " → " + c["plugin." + name][step] : "");
    this.now.textContent = "This step: polygon tests " + both("polygon") + ", times of impact " + both("toi") + ".";
    const { width, height } = this.strip.begin();
    if (width === 0) return;
    const colour = this.view.colour;
    this.strip.draw((g) => this.drawBackdrop(g, width, height), (g) => {
      g.fillStyle = colour.accent;
      g.fillRect((step / Math.max(1, this.model.stepCount - 1)) * width - 0.75, 6, 1.5, height - 10);
    });
  }

  drawBackdrop(g, width, height) {
    const colour = this.view.colour, bottom = height - 4;
    const yOf = (calls) => bottom - (calls / this.highest) * (height - 28); // below the number of the highest
    const trace = (means) => {
      g.beginPath();
      means.forEach((calls, i) => {
        const x = (i / Math.max(1, means.length - 1)) * width;
        if (i === 0) g.moveTo(x, yOf(calls));
        else g.lineTo(x, yOf(calls));
      });
    };
    if (this.hasPlugin) {
      trace(this.means.plugin);
      g.lineTo(width, bottom);
      g.lineTo(0, bottom);
      g.closePath();
      g.fillStyle = colour["slack-4"];
      g.globalAlpha = 0.6;
      g.fill();
      g.globalAlpha = 1;
    }
    trace(this.means.stock);
    g.strokeStyle = colour["slack-0"];
    g.lineWidth = 1.6;
    g.stroke();
    g.strokeStyle = colour.line;
    g.lineWidth = 1;
    g.strokeRect(0.5, 6, width - 1, bottom - 6);
    g.fillStyle = colour.soft;
    g.font = "11px system-ui, sans-serif";
    g.fillText(Math.round(this.highest).toLocaleString("en"), 4, 17);
  }
}
