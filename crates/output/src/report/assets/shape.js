// From no stress to the largest one.
const STRESS = ["#4a74b0", "#5a90bd", "#74adb9", "#95c1a1", "#bccb81", "#dfca60", "#ecb048", "#e88c3b", "#dc6231", "#c6322c"];

// The deformed shape: play, slider, scale, contact points and their forces.
// scene: {data, contact, where(state) -> text, stroke(driven) -> values after every increment}
class Shape {
  constructor(scene) {
    this.take(scene);
    this.stage();
  }

  // What is drawn from now on.
  take(scene) {
    const data = scene.data, f = data.frames;
    this.scene = scene;
    this.data = data;
    this.hidden = null;
    this.reference = singles(f.reference);
    this.moved = singles(f.displacement);
    this.states = f.states;
    this.size = this.reference.length;
    this.points = {};
    f.labels.forEach((label, k) => { if (label > 0) this.points[label] = k; });
    this.sections = singles(f.sections);
    this.heights = singles(data.heights);
    this.beams = [];
    f.kinds.forEach((kind, k) => { if (kind === 0) this.beams.push(k); });
    this.contact = scene.contact;
    this.frame = 0;
    this.strongest = 0;
    for (const point of this.contact) for (let i = 0; i < point.p.length; i++) this.strongest = Math.max(this.strongest, point.p[i] * (point.area || 1));
    if (this.skin) this.skin.load(); else this.skin = new Skin(this, document.getElementById("stage"));
    this.masters();
    this.names();
    this.stress();
    this.measure();
  }

  // Largest side of a box around the undeformed points.
  measure() {
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (let p = 0; p < this.size; p++) { low[p % 2] = Math.min(low[p % 2], this.reference[p]); high[p % 2] = Math.max(high[p % 2], this.reference[p]); }
    this.extent = Math.max(high[0] - low[0], high[1] - low[1], 1e-30);
  }

  // Cells whose both ends are masters of one slide line.
  masters() {
    this.lines = { beam: [], spring: [], slaves: [], masters: [], peak: [], mesh: [], rim: [] };
    const f = this.data.frames, of = [], sides = new Map();
    for (const pair of this.data.pairs) if (pair.master === "slide line") of.push(new Set(pair.nodes));
    f.kinds.forEach((kind, k) => {
      const ends = [f.cells[2 * k], f.cells[2 * k + 1]];
      ends.pair = k;
      const labels = ends.map((end) => f.labels[end]);
      if (kind === 3) this.lines.masters.push(ends);
      else if (kind === 2) this.lines.slaves.push(ends);
      else if (kind === 1) this.lines.spring.push(ends);
      else if (kind === 4) {
        this.lines.mesh.push(ends);
        const key = Math.min(...ends) + " " + Math.max(...ends);
        sides.set(key, sides.has(key) ? null : ends);
      } else {
        this.lines.beam.push(ends);
        if (of.some((set) => set.has(labels[0]) && set.has(labels[1]))) this.lines.masters.push(ends);
        if (f.elements[k] === f.strained) this.lines.peak.push(ends);
      }
    });
    // the rim of plane solids; fine meshes are not drawn
    for (const ends of sides.values()) if (ends) this.lines.rim.push(ends);
    if (this.lines.mesh.length > 12000) this.lines.mesh = [];
  }

  // Largest stress of all, which the colours end at.
  stress() {
    this.most = 0;
    for (let k = 1; k < this.sections.length; k += 2) this.most = Math.max(this.most, Math.abs(this.sections[k]));
    // beams and solids have one scale of stress
    if (this.skin && this.skin.fields.length) this.most = this.skin.fields[0].most = Math.max(this.most, this.skin.fields[0].most);
  }

  // Moment (0) or outer stress (1) of the beam cell in place `k`.
  section(k, frame, which) { return this.sections[2 * (frame * this.beams.length + k) + which]; }

  names() {
    const legend = document.getElementById("names");
    legend.textContent = "";
    const range = (list) => {
      const out = [];
      for (let i = 0; i < list.length; i++) {
        let j = i;
        while (j + 1 < list.length && list[j + 1] === list[j] + 1) j++;
        out.push(j > i + 1 ? list[i] + "\u2013" + list[j] : list.slice(i, j + 1).join(", "));
        i = j;
      }
      return out.length > 6 ? out.slice(0, 6).join(", ") + " \u2026" : out.join(", ");
    };
    const key = (colour, text) => {
      const entry = make(legend, "span", { class: "key" });
      make(entry, "i").style.background = "var(" + colour + ")";
      entry.appendChild(document.createTextNode(text));
    };
    for (const pair of this.data.pairs) {
      key("--c3", "slave of " + pair.name + ": nodes " + range(pair.slave));
      key("--c2", "master of " + pair.name + ": " + pair.master + (pair.master === "slide line" ? ", nodes " + range(pair.nodes) : ", moves with node " + pair.nodes.join(", ")));
    }
    if (this.contact.length) {
      key("--stick", "sticking point"); key("--slip", "sliding point (without friction too)");
      key("--c0", "normal force on the slave"); key("--c1", "friction force on the slave");
    }
    if (this.lines.peak.length) key("--c4", "largest fibre strain: element " + this.data.frames.strained);
  }

  at(point, frame, scale) {
    const k = frame * this.size + 2 * point;
    const own = [this.reference[2 * point] + scale * this.moved[k], this.reference[2 * point + 1] + scale * this.moved[k + 1]];
    return this.skin.space ? this.skin.at(point, frame, scale, own) : own;
  }

  // Height of the whole stroke over its width.
  aspect() {
    if (this.skin.space) return 0.8;
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (let frame = 0; frame < this.states.length; frame++) {
      for (let p = 0; p < this.size / 2; p++) {
        const point = this.at(p, frame, 1);
        for (const k of [0, 1]) { low[k] = Math.min(low[k], point[k]); high[k] = Math.max(high[k], point[k]); }
      }
    }
    const ratio = (high[1] - low[1]) / (high[0] - low[0]);
    return Number.isFinite(ratio) ? ratio : 1;
  }

  // What is seen: the whole stroke, or where it touches.
  bounds() {
    let box = [Infinity, -Infinity, Infinity, -Infinity];
    const add = ([x, y]) => { box = [Math.min(box[0], x), Math.max(box[1], x), Math.min(box[2], y), Math.max(box[3], y)]; };
    if (this.view === "contact") {
      for (const point of this.contact) {
        const place = this.points[point.node];
        if (place !== undefined && this.status(point, this.states[this.frame]) !== "o") add(this.at(place, this.frame, this.scale));
      }
    }
    const near = Number.isFinite(box[0]);
    if (!near) {
      // in space, where every turn asks anew, the ends of the stroke are enough
      const stride = this.skin.space ? Math.max(1, this.states.length - 1) : 1;
      for (let frame = 0; frame < this.states.length; frame += stride) for (let p = 0; p < this.size / 2; p++) add(this.at(p, frame, this.scale));
    }
    if (!Number.isFinite(box[0])) box = [0, 1, 0, 1];
    let [w, h] = [box[1] - box[0], box[3] - box[2]];
    const least = near ? 0.12 * this.extent : 1e-30;
    [w, h] = [Math.max(w, least), Math.max(h, least)];
    const middle = [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
    const per = Math.min((this.W - 2 * Math.min(70, 0.1 * this.W)) / w, (this.H - 110) / h);
    return { middle, per: Number.isFinite(per) ? per : 1 };
  }

  // As high as the whole stroke asks for.
  height() { return Math.round(Math.max(210, Math.min(460, 0.6 * this.W, 0.9 * this.W * this.aspect() + 130))); }

  // Takes the room that there is.
  resize(width) {
    this.W = Math.max(280, width - 2);
    this.H = this.height();
    this.svg.setAttribute("viewBox", "0 0 " + this.W + " " + this.H);
    this.skin.resize(this.W, this.H);
    this.fit();
    if (this.ready) this.go(this.frame);
  }

  stage() {
    this.scale = 1;
    this.view = "all";
    this.arrows = true;
    this.svg = draw(document.getElementById("stage"), "svg", { role: "img", "aria-label": "Deformed shape" });
    this.parts = {};
    this.parts.rest = draw(this.svg, "path", { class: "part rest" });
    this.thick = STRESS.map((colour) => draw(this.svg, "path", { fill: colour, stroke: colour, "stroke-width": 0.6 }));
    for (const name of ["mesh", "rim", "peak", "beam", "spring", "slaves", "masters"]) this.parts[name] = draw(this.svg, "path", { class: "part " + name });
    this.held = draw(this.svg, "g", { class: "held" });
    this.forces = draw(this.svg, "g");
    this.motion = draw(this.svg, "g", { class: "motion" });
    this.rule = draw(this.svg, "g");
    this.slider = document.getElementById("frame");
    this.slider.max = Math.max(0, this.states.length - 1);
    fitted(document.getElementById("stage"), (width) => this.resize(width));
    this.ready = true;
    this.skin.listen(this.svg);
    this.controls();
    if (!this.states.length) document.getElementById("state").textContent = "There are no states to draw.";
  }

  controls() {
    const play = document.getElementById("play"), scale = document.getElementById("scale");
    this.slider.addEventListener("input", () => { this.stop(); this.go(Number(this.slider.value)); });
    play.addEventListener("click", () => this.timer ? this.stop() : this.start());
    scale.addEventListener("input", () => {
      const value = Number(scale.value);
      if (scale.value !== "" && Number.isFinite(value) && value >= 0) { this.scale = value; this.fit(); this.go(this.frame); }
    });
    const view = document.getElementById("view");
    view.addEventListener("change", () => { this.view = view.value; this.fit(); this.go(this.frame); });
    const arrows = document.getElementById("arrows");
    arrows.addEventListener("click", () => {
      this.arrows = !this.arrows;
      arrows.setAttribute("aria-pressed", String(this.arrows));
      this.go(this.frame);
    });
  }

  start() {
    const play = document.getElementById("play"), last = this.states.length - 1;
    if (last < 1) return;
    play.textContent = "Pause"; play.setAttribute("aria-pressed", "true");
    if (this.frame >= last) this.go(0);
    const beat = Math.max(16, Math.min(150, 6000 / last));
    this.timer = setInterval(() => { this.go(this.frame + 1); if (this.frame >= last) this.stop(); }, beat);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    const play = document.getElementById("play");
    play.textContent = "Play"; play.setAttribute("aria-pressed", "false");
  }

  fit() {
    const view = this.bounds();
    this.place = ([x, y]) => [this.W / 2 + view.per * (x - view.middle[0]), this.H / 2 - 8 - view.per * (y - view.middle[1])];
    this.per = view.per;
    this.parts.rest.setAttribute("d", this.path(this.lines.beam.concat(this.lines.rim, this.lines.masters, this.lines.slaves), 0, 0));
    this.ruler(view.per);
  }

  ruler(per) {
    this.rule.textContent = "";
    const length = niceStep(Math.min(150, 0.22 * this.W) / per * 3, 3), width = length * per;
    draw(this.rule, "path", { class: "axis", fill: "none", d: "M14 " + (this.H - 20) + "v6h" + width.toFixed(1) + "v-6" });
    draw(this.rule, "text", { class: "soft", x: 20 + width, y: this.H - 11 }, show(length) + " (length)");
    const field = this.skin.fields[this.skin.field], most = field ? field.most : this.most;
    if (!(most > 0)) return;
    const wide = this.W < 560 ? 10 : 16, from = this.W - 14 - wide * STRESS.length;
    STRESS.forEach((colour, k) => draw(this.rule, "rect", { x: from + k * wide, y: this.H - 20, width: wide, height: 8, fill: colour }));
    draw(this.rule, "text", { class: "soft", x: from - 5, y: this.H - 12, "text-anchor": "end" }, "0");
    draw(this.rule, "text", { class: "soft", x: this.W - 14, y: this.H - 26, "text-anchor": "end" }, (field ? field.name : "|stress|") + " " + show(most, 3));
  }

  // Pairs of points whose element is absent in a frame, if any is.
  gone(frame) {
    const own = this.data.frames.changed[frame];
    if (!own) return null;
    this.hidden = this.hidden || this.data.frames.changes.map((one) => new Set(one.gone));
    return this.hidden[own - 1];
  }

  path(lines, frame, scale) {
    const out = [];
    let last = -1;
    const gone = this.gone(frame);
    for (const ends of lines) {
      if (gone && gone.has(ends.pair)) continue;
      const [a, b] = ends;
      if (a !== last) { const p = this.place(this.at(a, frame, scale)); out.push("M" + p[0].toFixed(2) + " " + p[1].toFixed(2)); }
      const q = this.place(this.at(b, frame, scale));
      out.push("L" + q[0].toFixed(2) + " " + q[1].toFixed(2));
      last = b;
    }
    return out.join("");
  }

  // Beams as thick as they are, at least two pixels, coloured by their stress.
  body(frame) {
    const paths = STRESS.map(() => []), gone = this.gone(frame);
    this.beams.forEach((cell, k) => {
      if (gone && gone.has(cell)) return;
      const a = this.place(this.at(this.data.frames.cells[2 * cell], frame, this.scale)), b = this.place(this.at(this.data.frames.cells[2 * cell + 1], frame, this.scale));
      const d = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(d[0], d[1]);
      if (!(length > 0)) return;
      const half = Math.max(1, 0.5 * this.heights[cell] * this.per), n = [-d[1] / length * half, d[0] / length * half];
      const part = this.most > 0 ? Math.abs(this.section(k, frame, 1)) / this.most : 0;
      const bin = Math.max(0, Math.min(STRESS.length - 1, Math.floor(part * STRESS.length))) || 0;
      const corner = (p, s) => (p[0] + s * n[0]).toFixed(1) + " " + (p[1] + s * n[1]).toFixed(1);
      paths[bin].push("M" + corner(a, 1) + "L" + corner(b, 1) + "L" + corner(b, -1) + "L" + corner(a, -1) + "Z");
    });
    paths.forEach((path, bin) => this.thick[bin].setAttribute("d", path.join("")));
  }

  // What holds the model: a clamp is a wall, a pin a triangle, a guide a triangle on a line.
  supports(frame) {
    this.held.textContent = "";
    const driven = new Set(this.data.driven.map((one) => one.node)), many = this.data.supports.length > 40 || this.skin.space;
    for (const support of this.data.supports) {
      const place = this.points[support.node];
      if (place === undefined || driven.has(support.node)) continue;
      const [x, y] = this.place(this.at(place, frame, this.scale)), has = (dof) => support.dofs.includes(dof);
      const u = this.along(support.node), wall = has(1) && has(2) && has(6);
      const d = wall ? u : has(2) ? [0, -1] : [-1, 0];
      const point = (along, across) => (x - along * d[0] - across * d[1]).toFixed(1) + " " + (y - along * d[1] + across * d[0]).toFixed(1);
      let path = "";
      if (many) path = "M" + (x - 2.5).toFixed(1) + " " + (y + 2.5).toFixed(1) + "h5l-2.5 -5z";
      else if (wall) {
        const half = Math.max(13, 0.5 * Math.max(0, ...this.heights) * this.per + 7);
        path = "M" + point(0, -half) + "L" + point(0, half);
        for (let k = -half; k < half - 1; k += 6) path += "M" + point(0, k + 6) + "L" + point(7, k);
      } else if (has(1) || has(2)) {
        path = "M" + point(0, 0) + "L" + point(11, -7) + "L" + point(11, 7) + "Z";
        if (!(has(1) && has(2))) path += "M" + point(14, -9) + "L" + point(14, 9);
      } else path = "M" + point(-5, -5) + "L" + point(-5, 5) + "L" + point(5, 5) + "L" + point(5, -5) + "Z";
      const mark = draw(this.held, "path", { d: path });
      draw(mark, "title", {}, "node " + support.node + " is held in " + support.dofs.join(", "));
    }
  }

  // Direction on the screen from a node into its beam.
  along(label) {
    const f = this.data.frames;
    for (const k of this.beams) {
      for (const [a, b] of [[0, 1], [1, 0]]) {
        if (f.labels[f.cells[2 * k + a]] !== label) continue;
        const p = this.place(this.at(f.cells[2 * k + a], 0, 0)), q = this.place(this.at(f.cells[2 * k + b], 0, 0)), size = Math.hypot(q[0] - p[0], q[1] - p[1]);
        if (size > 0) return [(q[0] - p[0]) / size, (q[1] - p[1]) / size];
      }
    }
    return [0, -1];
  }

  // Which way the driven nodes go.
  moving(frame) {
    this.motion.textContent = "";
    const state = this.states[frame];
    this.data.driven.forEach((driven) => {
      const place = this.points[driven.node], u = this.scene.stroke(driven);
      if (place === undefined || !u) return;
      const step = state > 0 ? u[state - 1] - (state > 1 ? u[state - 2] : 0) : driven.inward;
      if (!step) return;
      const s = Math.sign(step), [x, y] = this.place(this.at(place, frame, this.scale)), way = s === driven.inward ? "in" : "out";
      const axes = this.skin.space ? ["U1", "U2", "U3"].map((name, k) => [name, this.skin.seen([0, 1, 2].map((i) => i === k ? 1 : 0))]).map(([name, way]) => [name, [way[0], -way[1]]]) : [["U1", [1, 0]], ["U2", [0, -1]]];
      const axis = Object.fromEntries(axes)[driven.motion];
      const size = Math.min(64, 0.12 * this.W);
      let text;
      if (axis) {
        const tip = [x + s * axis[0] * size, y + s * axis[1] * size], n = [-axis[1], axis[0]];
        const wing = (k) => "L" + (tip[0] - s * axis[0] * 10 + k * n[0] * 6).toFixed(1) + " " + (tip[1] - s * axis[1] * 10 + k * n[1] * 6).toFixed(1);
        draw(this.motion, "path", { class: way, d: "M" + x.toFixed(1) + " " + y.toFixed(1) + "L" + tip[0].toFixed(1) + " " + tip[1].toFixed(1) + wing(1) + "M" + tip[0].toFixed(1) + " " + tip[1].toFixed(1) + wing(-1) });
        text = [tip[0] + (axis[0] ? 0 : 8), tip[1] - (axis[0] ? 9 : 0)];
      } else if (driven.motion === "UR3") {
        const r = 0.6 * size, end = [x + r * Math.cos(0.6), y + s * r * Math.sin(0.6) * -1];
        draw(this.motion, "path", { class: way, d: "M" + (x - r) + " " + y + "A" + r + " " + r + " 0 0 " + (s > 0 ? 0 : 1) + " " + end[0].toFixed(1) + " " + end[1].toFixed(1) });
        text = [x + r, y - 8];
      } else return;
      draw(this.motion, "circle", { class: way, cx: x, cy: y, r: 3 });
      const right = text[0] > this.W - 60;
      draw(this.motion, "text", { class: way, x: text[0], y: text[1], "text-anchor": right ? "end" : "middle" }, way);
    });
  }

  status(point, state) {
    const k = state - 1 - point.first;
    return k >= 0 && k < point.status.length ? point.status[k] : "o";
  }

  arrow(from, direction, length, kind) {
    if (!(Math.abs(length) > 1)) return;
    const d = [direction[0] * length, direction[1] * length], size = Math.hypot(d[0], d[1]);
    // the tip stands at the point: the force pushes there
    const tip = from, tail = [from[0] - d[0], from[1] + d[1]];
    const u = [(tip[0] - tail[0]) / size, (tip[1] - tail[1]) / size], head = Math.min(9, 0.5 * size);
    const back = [tip[0] - head * u[0], tip[1] - head * u[1]];
    const wing = (s) => (back[0] - s * 0.5 * head * u[1]).toFixed(1) + " " + (back[1] + s * 0.5 * head * u[0]).toFixed(1);
    draw(this.forces, "path", { class: "arrow " + kind, d: "M" + tail[0].toFixed(1) + " " + tail[1].toFixed(1) + "L" + tip[0].toFixed(1) + " " + tip[1].toFixed(1) + "M" + wing(1) + "L" + tip[0].toFixed(1) + " " + tip[1].toFixed(1) + "L" + wing(-1) });
  }

  touch() {
    this.forces.textContent = "";
    const state = this.states[this.frame];
    let closed = 0;
    for (const point of this.contact) {
      const status = this.status(point, state), place = this.points[point.node];
      if (status === "o" || place === undefined) continue;
      closed++;
      const k = nearest(point, state - 1), at = this.place(this.at(place, this.frame, this.scale));
      const n = [Math.cos(point.n[k]), Math.sin(point.n[k])];
      const unit = 85 / (this.strongest || 1) * (point.area || 1);
      if (this.arrows && Number.isFinite(n[0])) {
        // pressure pushes the slave along the master's outward normal; the
        // master's direction of travel is the normal turned clockwise, and
        // friction on the slave acts against the sign of the shear there
        this.arrow(at, n, point.p[k] * unit, "normal");
        // beside the surface, where it can be seen
        this.arrow([at[0] + 10 * n[0], at[1] - 10 * n[1]], [-n[1], n[0]], point.t[k] * unit, "shear");
      }
      const dot = draw(this.forces, "circle", { class: "touch " + status, cx: at[0].toFixed(1), cy: at[1].toFixed(1), r: 4.5 });
      draw(dot, "title", {}, "node " + point.node + ": " + (status === "t" ? "stick" : "slip") + ", pressure " + show(point.p[k]) + ", shear " + show(point.t[k]));
    }
    return closed;
  }

  // The frame that stands nearest to a state.
  near(state) {
    let best = 0;
    this.states.forEach((own, k) => { if (Math.abs(own - state) < Math.abs(this.states[best] - state)) best = k; });
    return best;
  }

  go(frame) {
    if (!this.states.length) return;
    this.frame = Math.max(0, Math.min(this.states.length - 1, frame));
    this.slider.value = this.frame;
    if (this.view === "contact") this.fit();
    for (const name of Object.keys(this.lines)) this.parts[name].setAttribute("d", this.path(this.lines[name], this.frame, this.scale));
    this.body(this.frame);
    this.skin.paint(this.frame, this.scale);
    this.supports(this.frame);
    this.moving(this.frame);
    const closed = this.touch(), state = this.states[this.frame];
    const text = this.scene.where(state) + "; " + (state === 0 ? "undeformed" : !this.data.pairs.length ? "deformed" : closed + (closed === 1 ? " point touches" : " points touch")) + (this.scale === 1 ? "" : "; displacements times " + show(this.scale));
    document.getElementById("state").textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
    if (this.moves) this.moves(state, this.frame);
  }
}
