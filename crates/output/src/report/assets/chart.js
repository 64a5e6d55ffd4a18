// A line chart in SVG: zoom by dragging, read-off by pointer and keyboard.
// options: title, x, y (axis titles), log, describe(series, place) -> text
// series: [{name, x, y, colour, dash, dots, half}]; one with half is a band
// of y plus and minus half, to be looked at and not read off
const RIGHT = 18, TOP = 14, BOTTOM = 46;
let charts = 0;

class Chart {
  constructor(parent, options, series) {
    this.options = options;
    this.series = series.map((one) => Object.assign({ shown: true }, one));
    this.active = 0;
    this.place = -1;
    this.now = -1;
    const figure = make(parent, "figure", { class: "chart" });
    if (options.id) figure.id = options.id;
    make(figure, "figcaption", {}, options.title);
    this.clip = "clip" + (charts++);
    this.svg = draw(figure, "svg", {
      tabindex: 0, role: "img",
      "aria-label": options.title + ". Arrow keys read values off."
    });
    this.readoff = make(figure, "p", { class: "readoff", role: "status", "aria-live": "polite" });
    this.legend(figure);
    this.listen();
    this.box = null;
    fitted(figure, (width) => this.resize(width));
  }

  // The drawing is as wide as the screen allows, and as high as that is good for.
  resize(width) {
    this.W = Math.max(280, width - 2);
    this.H = Math.round(Math.max(230, Math.min(380, 0.44 * this.W)));
    this.L = this.W < 560 ? 62 : 84;
    this.svg.setAttribute("viewBox", "0 0 " + this.W + " " + this.H);
    if (this.box) this.render(); else this.whole();
  }

  // New values in the same axes.
  update() { this.render(); }

  legend(figure) {
    const legend = make(figure, "div", { class: "legend" });
    this.series.forEach((one) => {
      const entry = make(legend, "button", { type: "button", class: "entry", "aria-pressed": "true" });
      const swatch = make(entry, "span", { class: "swatch" });
      swatch.style.background = one.dash ? "repeating-linear-gradient(90deg, var(" + one.colour + ") 0 .35em, transparent .35em .6em)" : "var(" + one.colour + ")";
      if (one.half) swatch.classList.add("band");
      entry.appendChild(document.createTextNode(one.name));
      entry.addEventListener("click", () => {
        one.shown = !one.shown;
        entry.setAttribute("aria-pressed", String(one.shown));
        this.whole();
      });
    });
    const tools = make(legend, "span", { class: "tools" });
    for (const [text, label, act] of [["+", "Zoom in", () => this.zoom(0.5)], ["\u2212", "Zoom out", () => this.zoom(2)], ["whole", "Whole curve", () => this.whole()]]) {
      make(tools, "button", { type: "button", class: "entry", "aria-label": label }, text).addEventListener("click", act);
    }
  }

  value(y) { return this.options.log ? Math.log10(y) : y; }

  whole() {
    let box = [Infinity, -Infinity, Infinity, -Infinity];
    for (const one of this.series) {
      if (!one.shown) continue;
      for (let i = 0; i < one.x.length; i++) {
        const x = one.x[i], y = this.value(one.y[i]);
        if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
        const half = one.half && Number.isFinite(one.half[i]) ? one.half[i] : 0;
        if (one.base) box[2] = Math.min(box[2], 0);
        box = [Math.min(box[0], x), Math.max(box[1], x), Math.min(box[2], y - half), Math.max(box[3], y + half)];
      }
    }
    if (this.options.range) box = box.slice(0, 2).concat(this.options.range);
    if (!(box[0] <= box[1])) box = [0, 1, 0, 1];
    const pad = (low, high) => {
      const span = high - low;
      return span > 0 ? 0.04 * span : Math.abs(high) > 0 ? 0.1 * Math.abs(high) : 1;
    };
    const px = pad(box[0], box[1]), py = pad(box[2], box[3]);
    this.box = [box[0] - px, box[1] + px, box[2] - py, box[3] + py];
    this.render();
  }

  zoom(factor) {
    const centre = this.cursor() || [(this.box[0] + this.box[1]) / 2, (this.box[2] + this.box[3]) / 2];
    const at = (low, high, c) => [c + (low - c) * factor, c + (high - c) * factor];
    this.box = at(this.box[0], this.box[1], centre[0]).concat(at(this.box[2], this.box[3], centre[1]));
    this.render();
  }

  cursor() {
    const one = this.series[this.active];
    if (this.place < 0 || !one) return null;
    const point = [one.x[this.place], this.value(one.y[this.place])];
    return point.every(Number.isFinite) ? point : null;
  }

  px(x) { return this.L + (x - this.box[0]) / (this.box[1] - this.box[0]) * (this.W - this.L - RIGHT); }
  py(y) { return this.H - BOTTOM - (y - this.box[2]) / (this.box[3] - this.box[2]) * (this.H - TOP - BOTTOM); }

  render() {
    const svg = this.svg;
    svg.textContent = "";
    const clip = draw(draw(svg, "defs"), "clipPath", { id: this.clip });
    draw(clip, "rect", { x: this.L, y: TOP, width: this.W - this.L - RIGHT, height: this.H - TOP - BOTTOM });
    this.axes(svg);
    const layer = draw(svg, "g", { "clip-path": "url(#" + this.clip + ")" });
    for (const one of this.series) if (one.shown && one.half) this.band(layer, one);
    for (const one of this.series) if (one.shown && !one.half) this.curve(layer, one);
    this.labels(svg);
    this.nowMark = draw(layer, "circle", { class: "now", r: 4.5, visibility: "hidden" });
    this.mark = draw(layer, "circle", { class: "mark", r: 5, visibility: "hidden" });
    this.boxMark = draw(layer, "rect", { class: "box", visibility: "hidden" });
    this.point(this.place, true);
    this.follow(this.now);
  }

  axes(svg) {
    const [x0, x1, y0, y1] = this.box;
    const ticks = (low, high, count, whole) => {
      let step = niceStep(high - low, count);
      if (whole) step = Math.max(1, Math.round(step));
      const out = [];
      for (let k = Math.ceil(low / step); k * step <= high && out.length < 40; k++) out.push(k * step);
      return out;
    };
    for (const x of ticks(x0, x1, Math.max(3, Math.min(8, this.W / 110)), this.options.whole)) {
      const at = this.px(x);
      draw(svg, "line", { class: "grid", x1: at, x2: at, y1: TOP, y2: this.H - BOTTOM });
      draw(svg, "text", { x: at, y: this.H - BOTTOM + 17, "text-anchor": "middle" }, show(x));
    }
    for (const y of ticks(y0, y1, 6, this.options.log || this.options.counts)) {
      const at = this.py(y);
      draw(svg, "line", { class: "grid", y1: at, y2: at, x1: this.L, x2: this.W - RIGHT });
      draw(svg, "text", { x: this.L - 7, y: at + 4, "text-anchor": "end" }, this.options.log ? "1e" + String(y).replace("-", "\u2212") : show(y));
    }
    if (!this.options.log && y0 < 0 && y1 > 0) draw(svg, "line", { class: "axis", x1: this.L, x2: this.W - RIGHT, y1: this.py(0), y2: this.py(0) });
    draw(svg, "rect", { class: "axis", fill: "none", x: this.L, y: TOP, width: this.W - this.L - RIGHT, height: this.H - TOP - BOTTOM });
    draw(svg, "text", { class: "soft", x: (this.L + this.W - RIGHT) / 2, y: this.H - 8, "text-anchor": "middle" }, this.options.x);
    draw(svg, "text", { class: "soft", transform: "translate(14 " + (TOP + this.H - BOTTOM) / 2 + ") rotate(-90)", "text-anchor": "middle" }, this.options.y);
  }

  // Points of the first curve that have a name.
  labels(svg) {
    const one = this.series[0];
    if (!one || !one.shown) return;
    for (const label of this.options.labels || []) {
      const x = one.x[label.place], y = this.value(one.y[label.place]);
      if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
      const px = this.px(x), py = this.py(y);
      if (px < this.L || px > this.W - RIGHT || py < TOP || py > this.H - BOTTOM) continue;
      const ring = draw(svg, "circle", { class: "peakmark", cx: px, cy: py, r: 5 });
      ring.style.stroke = "var(" + label.colour + ")";
      const right = px > this.L + 0.6 * (this.W - this.L), below = y < 0;
      const at = Math.max(TOP + 14, Math.min(this.H - BOTTOM - 8, py + (below ? 18 : -10)));
      draw(svg, "text", { class: "peaktext", x: px + (right ? -8 : 8), y: at, "text-anchor": right ? "end" : "start" }, label.text);
    }
  }

  bars(layer, one) {
    const half = 0.36 * (this.px(1) - this.px(0));
    for (let i = 0; i < one.x.length; i++) {
      if (!(one.y[i] > one.base[i])) continue;
      const top = this.py(one.y[i]), bar = draw(layer, "rect", { x: this.px(one.x[i]) - half, width: 2 * half, y: top, height: this.py(one.base[i]) - top });
      bar.style.fill = "var(" + one.colour + ")";
    }
  }

  band(layer, one) {
    const upper = [], lower = [];
    for (let i = 0; i < one.x.length; i++) {
      if (![one.x[i], one.y[i], one.half[i]].every(Number.isFinite)) continue;
      const at = (y) => this.px(one.x[i]).toFixed(2) + " " + Math.max(-1e5, Math.min(1e5, this.py(y))).toFixed(2);
      upper.push(at(one.y[i] + one.half[i]));
      lower.push(at(one.y[i] - one.half[i]));
    }
    const path = draw(layer, "path", { class: "error", d: upper.length ? "M" + upper.concat(lower.reverse()).join("L") + "Z" : "" });
    path.style.fill = "var(" + one.colour + ")";
  }

  curve(layer, one) {
    if (one.base) { this.bars(layer, one); return; }
    // a piece of the curve belongs to the way on which it ends
    const ways = one.ways ? one.wayColours : [one.colour], paths = ways.map(() => []), pens = ways.map(() => -2);
    const point = (i) => {
      const x = one.x[i], y = this.value(one.y[i]);
      if (!Number.isFinite(x) || !Number.isFinite(y)) return null;
      return [Math.max(-1e5, Math.min(1e5, this.px(x))).toFixed(1), Math.max(-1e5, Math.min(1e5, this.py(y))).toFixed(1)];
    };
    for (let i = 0; i < one.x.length; i++) {
      const at = point(i), way = one.ways ? one.ways[i] : 0;
      if (!at) continue;
      const before = i > 0 ? point(i - 1) : null;
      if (before && pens[way] !== i - 1) paths[way].push("M" + before[0] + " " + before[1]);
      paths[way].push((before ? "L" : "M") + at[0] + " " + at[1]);
      pens[way] = i;
      if (one.dots && one.x.length <= 200) {
        const dot = draw(layer, "circle", { cx: at[0], cy: at[1], r: one.apart ? 4 : 2.2 });
        dot.style.fill = "var(" + ways[way] + ")";
        if (one.apart) dot.style.stroke = "var(--paper)";
      }
    }
    if (one.apart) return;
    ways.forEach((colour, way) => {
      const line = draw(layer, "path", { class: "curve", d: paths[way].join("") });
      line.style.stroke = "var(" + colour + ")";
      if (one.dash) line.setAttribute("stroke-dasharray", "7 4");
    });
  }

  // Reads the point at `place` of the active curve off.
  point(place, silent) {
    this.place = place;
    const one = this.series[this.active];
    const at = one && one.shown ? this.cursor() : null;
    if (!at) { this.mark.setAttribute("visibility", "hidden"); return; }
    this.mark.setAttribute("visibility", "visible");
    this.mark.setAttribute("cx", this.px(at[0]));
    this.mark.setAttribute("cy", this.py(at[1]));
    if (!silent) this.readoff.textContent = this.options.describe(one, place);
  }

  // Shows where the animation stands.
  follow(place) {
    this.now = place;
    const one = this.series[0];
    const seen = one && one.shown && place >= 0 && place < one.x.length && !this.options.apart;
    this.nowMark.setAttribute("visibility", seen ? "visible" : "hidden");
    if (seen) {
      this.nowMark.setAttribute("cx", this.px(one.x[place]));
      this.nowMark.setAttribute("cy", this.py(this.value(one.y[place])));
    }
  }

  spot(event) {
    const frame = this.svg.getBoundingClientRect();
    return [(event.clientX - frame.left) / frame.width * this.W, (event.clientY - frame.top) / frame.height * this.H];
  }

  nearest([sx, sy]) {
    let best = Infinity, found = null;
    this.series.forEach((one, k) => {
      if (!one.shown || one.half) return;
      for (let i = 0; i < one.x.length; i++) {
        const d = Math.hypot(this.px(one.x[i]) - sx, this.py(this.value(one.y[i])) - sy);
        if (d < best) { best = d; found = [k, i]; }
      }
    });
    return found;
  }

  listen() {
    const svg = this.svg;
    let from = null;
    svg.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      from = this.spot(event);
      try { svg.setPointerCapture(event.pointerId); } catch (e) { from = null; }
    });
    svg.addEventListener("pointermove", (event) => {
      const at = this.spot(event);
      if (from) { this.stretch(from, at); return; }
      const found = this.nearest(at);
      if (found) { this.active = found[0]; this.point(found[1]); }
    });
    svg.addEventListener("pointerup", (event) => {
      if (!from) return;
      const to = this.spot(event), begin = from;
      from = null;
      this.boxMark.setAttribute("visibility", "hidden");
      if (Math.abs(to[0] - begin[0]) > 6 && Math.abs(to[1] - begin[1]) > 6) this.into(begin, to);
    });
    svg.addEventListener("pointercancel", () => { from = null; this.boxMark.setAttribute("visibility", "hidden"); });
    svg.addEventListener("dblclick", () => this.whole());
    svg.addEventListener("keydown", (event) => this.key(event));
  }

  stretch(from, to) {
    const box = { x: Math.min(from[0], to[0]), y: Math.min(from[1], to[1]), width: Math.abs(to[0] - from[0]), height: Math.abs(to[1] - from[1]), visibility: "visible" };
    for (const key of Object.keys(box)) this.boxMark.setAttribute(key, box[key]);
  }

  into(a, b) {
    const [x0, x1, y0, y1] = this.box;
    const x = (p) => x0 + (p - this.L) / (this.W - this.L - RIGHT) * (x1 - x0);
    const y = (p) => y0 + (this.H - BOTTOM - p) / (this.H - TOP - BOTTOM) * (y1 - y0);
    this.box = [x(Math.min(a[0], b[0])), x(Math.max(a[0], b[0])), y(Math.max(a[1], b[1])), y(Math.min(a[1], b[1]))];
    this.render();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const one = this.series[this.active], last = one ? one.x.length - 1 : -1;
    const shown = this.series.map((s, k) => s.shown && !s.half ? k : -1).filter((k) => k >= 0);
    const other = (by) => {
      if (!shown.length) return;
      const at = shown.indexOf(this.active);
      this.active = shown[(at + by + shown.length) % shown.length];
      this.point(Math.max(0, Math.min(this.place, this.series[this.active].x.length - 1)));
    };
    const acts = {
      ArrowRight: () => this.point(Math.min(last, this.place + 1)),
      ArrowLeft: () => this.point(Math.max(0, this.place - 1)),
      ArrowUp: () => other(-1), ArrowDown: () => other(1),
      Home: () => this.point(0), End: () => this.point(last),
      "+": () => this.zoom(0.5), "=": () => this.zoom(0.5), "-": () => this.zoom(2),
      "0": () => this.whole(), Escape: () => this.whole()
    };
    if (acts[event.key]) { event.preventDefault(); acts[event.key](); }
  }
}
