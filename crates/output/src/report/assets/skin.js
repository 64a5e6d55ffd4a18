// The surface of solids, painted below the lines of the shape in bands of a nodal value. Solids in
// space are painted from back to front and turn with the pointer.
class Skin {
  constructor(shape, parent) {
    this.shape = shape;
    this.field = 0;
    this.turn = [-0.6, 0.45];
    this.canvas = make(parent, "canvas", { "aria-hidden": "true" });
    document.getElementById("field").addEventListener("change", (event) => { this.field = Number(event.target.value); this.shape.fit(); this.shape.go(this.shape.frame); });
    this.load();
  }

  // Takes what the shape has.
  load() {
    const f = this.shape.data.frames;
    // all solids, then what is left of them while something is absent
    this.skins = [f.skin, ...f.changes.map((own) => own.skin)].map(singles);
    this.show(0);
    this.space = f.space;
    this.fields = f.fields.map((field) => ({ name: field.name, values: singles(field.values) }));
    this.fields.forEach((field) => {
      let most = 0;
      for (const value of field.values) if (value > most) most = value;
      field.most = most;
    });
    this.depths();
    this.choice();
  }

  // The surface that a frame is drawn by.
  show(frame) {
    this.corners = this.skins[this.shape.data.frames.changed[frame] || 0];
    this.triangles = this.corners.length / 4;
  }

  depths() {
    if (!this.space) return;
    const f = this.shape.data.frames;
    this.depth = singles(f.depth);
    this.moved = singles(f.depth_moved);
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], s = this.shape;
    for (let p = 0; p < this.depth.length; p++) {
      [s.reference[2 * p], s.reference[2 * p + 1], this.depth[p]].forEach((x, k) => { low[k] = Math.min(low[k], x); high[k] = Math.max(high[k], x); });
    }
    this.middle = low.map((x, k) => 0.5 * (x + high[k]));
  }

  choice() {
    const label = document.getElementById("fields"), select = document.getElementById("field");
    this.field = Math.min(this.field, Math.max(0, this.fields.length - 1));
    select.textContent = "";
    this.fields.forEach((field, k) => make(select, "option", { value: k }, field.name));
    select.value = this.field;
    label.hidden = this.fields.length < 2;
  }

  // A direction of space as the viewer has it: right, up, towards.
  seen([x, y, z]) {
    const [a, b] = this.turn, c = Math.cos(a), s = Math.sin(a), d = Math.cos(b), e = Math.sin(b);
    const right = c * x + s * z, back = c * z - s * x;
    return [right, d * y - e * back, e * y + d * back];
  }

  // A point that stands at x, y as the shape has it, turned.
  at(point, frame, scale, [x, y]) {
    const z = this.depth[point] + scale * this.moved[frame * this.depth.length + point];
    return this.seen([x - this.middle[0], y - this.middle[1], z - this.middle[2]]);
  }

  resize(width, height) {
    const fine = Math.min(2, window.devicePixelRatio || 1);
    this.canvas.width = Math.round(width * fine);
    this.canvas.height = Math.round(height * fine);
    this.fine = fine;
  }

  // Whether there is a value to be coloured by, and the largest.
  most() { return this.fields.length ? this.fields[this.field].most : 0; }

  // A triangle in units of bands, cut into the bands: calls add(band, [x, y, x, y, ...]).
  bands(points, values, add) {
    const low = Math.min(...values), high = Math.max(...values), last = STRESS.length - 1;
    const band = (value) => Math.max(0, Math.min(last, Math.floor(value)));
    const first = band(low), end = band(high);
    if (!(first < end)) { add(first, points.flat()); return; }
    for (let k = first; k <= end; k++) {
      let polygon = points.map((point, i) => [point[0], point[1], values[i]]);
      if (k > first) polygon = this.cut(polygon, (p) => p[2] - k);
      if (k < end) polygon = this.cut(polygon, (p) => k + 1 - p[2]);
      if (polygon.length > 2) add(k, polygon.flatMap((p) => [p[0], p[1]]));
    }
  }

  // The part of a polygon where `inside` is positive.
  cut(polygon, inside) {
    const out = [];
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length], a = inside(p), b = inside(q);
      if (a >= 0) out.push(p);
      if ((a > 0 && b < 0) || (a < 0 && b > 0)) { const t = a / (a - b); out.push(p.map((x, k) => x + t * (q[k] - x))); }
    });
    return out;
  }

  paint(frame, scale) {
    const pen = this.canvas.getContext("2d"), shape = this.shape;
    pen.setTransform(this.fine, 0, 0, this.fine, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.show(frame);
    if (!this.triangles || !shape.states.length) return;
    const points = shape.size / 2, screen = new Float32Array(2 * points), depth = new Float32Array(points);
    for (let p = 0; p < points; p++) {
      const own = shape.at(p, frame, scale), [x, y] = shape.place(own);
      screen[2 * p] = x; screen[2 * p + 1] = y; depth[p] = own[2] || 0;
    }
    const most = this.most(), values = most > 0 ? this.fields[this.field].values.subarray(frame * points, (frame + 1) * points) : null;
    pen.lineJoin = "round";
    if (this.space) this.solid(pen, screen, depth, values, most); else this.flat(pen, screen, values, most);
  }

  corner(k, screen) { return [0, 1, 2].map((i) => { const p = this.corners[4 * k + i]; return [screen[2 * p], screen[2 * p + 1]]; }); }

  value(k, values, most) {
    return [0, 1, 2].map((i) => { const v = values[this.corners[4 * k + i]] / most * STRESS.length; return Number.isFinite(v) ? v : 0; });
  }

  // Plane solids: all parts of a band at once.
  flat(pen, screen, values, most) {
    const paths = STRESS.map(() => new Path2D());
    for (let k = 0; k < this.triangles; k++) {
      const add = (band, own) => {
        paths[band].moveTo(own[0], own[1]);
        for (let i = 2; i < own.length; i += 2) paths[band].lineTo(own[i], own[i + 1]);
        paths[band].closePath();
      };
      if (values) this.bands(this.corner(k, screen), this.value(k, values, most), add); else add(0, this.corner(k, screen).flat());
    }
    pen.lineWidth = 0.6;
    paths.forEach((path, band) => {
      pen.fillStyle = pen.strokeStyle = values ? STRESS[band] : "#c3c9d1";
      pen.fill(path); pen.stroke(path);
    });
  }

  // Solids in space: what looks away is hidden, the rest is painted from back to front.
  solid(pen, screen, depth, values, most) {
    const order = [], c = this.corners;
    for (let k = 0; k < this.triangles; k++) {
      const [a, b, d] = [c[4 * k], c[4 * k + 1], c[4 * k + 2]];
      const area = (screen[2 * b] - screen[2 * a]) * (screen[2 * d + 1] - screen[2 * a + 1]) - (screen[2 * b + 1] - screen[2 * a + 1]) * (screen[2 * d] - screen[2 * a]);
      // the screen's y points down: counter-clockwise is negative
      if (area < 0) order.push([depth[a] + depth[b] + depth[d], k]);
    }
    order.sort((p, q) => p[0] - q[0]);
    const lines = order.length < 12000, ink = getComputedStyle(document.documentElement).getPropertyValue("--ink");
    for (const [, k] of order) {
      const points = this.corner(k, screen);
      const add = (band, own) => {
        pen.beginPath();
        pen.moveTo(own[0], own[1]);
        for (let i = 2; i < own.length; i += 2) pen.lineTo(own[i], own[i + 1]);
        pen.closePath();
        pen.fillStyle = pen.strokeStyle = values ? STRESS[band] : "#c3c9d1";
        pen.lineWidth = 0.7; pen.globalAlpha = 1;
        pen.fill(); pen.stroke();
      };
      if (values) this.bands(points, this.value(k, values, most), add); else add(0, points.flat());
      if (!lines) continue;
      pen.beginPath();
      [[1, 0, 1], [2, 1, 2], [4, 2, 0]].forEach(([bit, i, j]) => {
        if (c[4 * k + 3] & bit) { pen.moveTo(points[i][0], points[i][1]); pen.lineTo(points[j][0], points[j][1]); }
      });
      pen.strokeStyle = ink; pen.lineWidth = 0.8; pen.globalAlpha = 0.45;
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  // Turns with the pointer and the arrow keys.
  listen(svg) {
    if (!this.space) return;
    svg.style.touchAction = "none";
    svg.setAttribute("tabindex", "0");
    svg.setAttribute("aria-label", "Deformed shape. Drag or use the arrow keys to turn it.");
    let last = null, waiting = false;
    const turned = (dx, dy) => {
      this.turn = [this.turn[0] + dx, Math.max(-1.57, Math.min(1.57, this.turn[1] + dy))];
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; this.shape.fit(); this.shape.go(this.shape.frame); });
    };
    svg.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; svg.setPointerCapture(event.pointerId); });
    svg.addEventListener("pointermove", (event) => {
      if (!last) return;
      turned(0.01 * (event.clientX - last[0]), 0.01 * (event.clientY - last[1]));
      last = [event.clientX, event.clientY];
    });
    for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, () => { last = null; });
    svg.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (way) { event.preventDefault(); turned(...way); }
    });
  }
}
