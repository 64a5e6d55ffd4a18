// Axes of a chart on a canvas: from values to pixels, grid, lines. Nothing of the workbench is known here.
(function (W) {
  "use strict";
  const RIGHT = 16, TOP = 12, BOTTOM = 38;

  class Plot {
    constructor(canvas) {
      this.canvas = canvas;
      this.pen = canvas.getContext("2d");
      this.box = [0, 1, 0, 1];
    }

    // The room that there is; true where it has changed.
    resize() {
      const w = Math.max(200, this.canvas.parentNode.clientWidth), h = Math.max(120, this.canvas.parentNode.clientHeight);
      const fine = Math.min(2, window.devicePixelRatio || 1);
      if (w === this.W && h === this.H && fine === this.fine) return false;
      this.W = w; this.H = h; this.fine = fine;
      this.L = w < 560 ? 52 : 64;
      this.canvas.width = Math.round(w * fine);
      this.canvas.height = Math.round(h * fine);
      return true;
    }

    colours() {
      const style = getComputedStyle(document.documentElement), out = {};
      for (const name of ["paper", "ink", "soft", "line", "panel", "c0", "c1", "c2", "c3", "c4", "c5", "c6", "bad", "ghost"]) out[name] = style.getPropertyValue("--" + name).trim();
      return out;
    }

    px(x) { return this.L + (x - this.box[0]) / (this.box[1] - this.box[0]) * (this.W - this.L - RIGHT); }
    py(y) { return this.H - BOTTOM - (y - this.box[2]) / (this.box[3] - this.box[2]) * (this.H - TOP - BOTTOM); }
    y(py) { return this.box[2] + (this.H - BOTTOM - py) / (this.H - TOP - BOTTOM) * (this.box[3] - this.box[2]); }

    // Takes everything in; where `still` it only grows.
    range(lists, still) {
      let box = [Infinity, -Infinity, 0, 0];
      for (const [x, y] of lists) {
        for (let i = 0; i < x.length; i++) {
          if (!Number.isFinite(x[i]) || !Number.isFinite(y[i])) continue;
          box = [Math.min(box[0], x[i]), Math.max(box[1], x[i]), Math.min(box[2], y[i]), Math.max(box[3], y[i])];
        }
      }
      if (!(box[0] <= box[1])) { if (!this.known) this.box = [0, 1, 0, 1]; return; }
      const wide = box[1] - box[0] || Math.abs(box[1]) || 1, high = box[3] - box[2] || 1;
      const padded = [box[0] - 0.02 * wide, box[1] + 0.03 * wide, box[2] - 0.08 * high, box[3] + 0.12 * high];
      const old = this.box;
      this.box = still && this.known ? [Math.min(old[0], padded[0]), Math.max(old[1], padded[1]), Math.min(old[2], box[2] < old[2] ? padded[2] : old[2]), Math.max(old[3], box[3] > old[3] ? padded[3] : old[3])] : padded;
      this.known = true;
    }

    clear() {
      this.pen.setTransform(this.fine, 0, 0, this.fine, 0, 0);
      this.pen.clearRect(0, 0, this.W, this.H);
      this.pen.globalAlpha = 1;
      this.pen.lineJoin = "round";
      this.pen.font = "12px system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif";
    }

    line(a, b, c, d) { this.pen.beginPath(); this.pen.moveTo(a, b); this.pen.lineTo(c, d); this.pen.stroke(); }

    text(text, x, y, align, colour) {
      this.pen.textAlign = align;
      this.pen.fillStyle = colour;
      this.pen.fillText(text, x, y);
    }

    axes(ink, titles) {
      // as short as the room beside the axis asks for
      const number = (value) => Math.abs(value) >= 1e5 ? value.toExponential(2).replace(/\.?0*e\+?/, "e").replace("-", "\u2212") : show(value, 4);
      const pen = this.pen, [x0, x1, y0, y1] = this.box, ends = [this.W - RIGHT, this.H - BOTTOM];
      const ticks = (low, high, count) => {
        const step = niceStep(high - low, count), out = [];
        for (let k = Math.ceil(low / step); k * step <= high && out.length < 40; k++) out.push(k * step);
        return out;
      };
      pen.lineWidth = 1;
      pen.strokeStyle = ink.line;
      for (const x of ticks(x0, x1, Math.max(3, Math.min(9, this.W / 90)))) {
        const at = Math.round(this.px(x)) + 0.5;
        this.line(at, TOP, at, ends[1]);
        this.text(number(x), at, ends[1] + 15, "center", ink.ink);
      }
      for (const y of ticks(y0, y1, Math.max(3, Math.min(7, this.H / 45)))) {
        const at = Math.round(this.py(y)) + 0.5;
        this.line(this.L, at, ends[0], at);
        this.text(number(y), this.L - 6, at + 4, "right", ink.ink);
      }
      pen.strokeStyle = ink.soft;
      if (y0 < 0 && y1 > 0) { const at = Math.round(this.py(0)) + 0.5; this.line(this.L, at, ends[0], at); }
      pen.strokeRect(this.L + 0.5, TOP + 0.5, ends[0] - this.L, ends[1] - TOP);
      this.text(titles[0], (this.L + ends[0]) / 2, this.H - 6, "center", ink.soft);
      pen.save();
      pen.translate(13, (TOP + ends[1]) / 2);
      pen.rotate(-Math.PI / 2);
      this.text(titles[1], 0, 0, "center", ink.soft);
      pen.restore();
    }

    // Draws inside of the axes only.
    inside(act) {
      const pen = this.pen;
      pen.save();
      pen.beginPath();
      pen.rect(this.L, TOP, this.W - this.L - RIGHT, this.H - TOP - BOTTOM);
      pen.clip();
      act();
      pen.restore();
    }

    // A curve from one of its points to another.
    curve(x, y, colour, { width = 2, dash = [], alpha = 1, from = 0, to = x.length - 1 } = {}) {
      const pen = this.pen;
      pen.strokeStyle = colour;
      pen.lineWidth = width;
      pen.globalAlpha = alpha;
      pen.setLineDash(dash);
      pen.beginPath();
      for (let i = from; i <= to; i++) {
        const a = this.px(x[i]), b = this.py(y[i]);
        if (i === from) pen.moveTo(a, b); else pen.lineTo(a, b);
      }
      pen.stroke();
      pen.setLineDash([]);
      pen.globalAlpha = 1;
    }

    band(x, low, high, colour) {
      const pen = this.pen;
      pen.fillStyle = colour;
      pen.globalAlpha = 0.2;
      // piece by piece: the way out lies over the way in
      for (let i = 1; i < x.length; i++) {
        pen.beginPath();
        pen.moveTo(this.px(x[i - 1]), this.py(low[i - 1]));
        pen.lineTo(this.px(x[i]), this.py(low[i]));
        pen.lineTo(this.px(x[i]), this.py(high[i]));
        pen.lineTo(this.px(x[i - 1]), this.py(high[i - 1]));
        pen.fill();
      }
      pen.globalAlpha = 1;
    }

    dot(x, y, colour, edge, size) {
      const pen = this.pen;
      pen.beginPath();
      pen.arc(this.px(x), this.py(y), size, 0, 7);
      pen.fillStyle = colour;
      pen.strokeStyle = edge;
      pen.lineWidth = 2;
      pen.fill();
      pen.stroke();
    }
  }
  W.Plot = Plot;
})(window.Workbench = window.Workbench || {});
