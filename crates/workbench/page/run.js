// One solve as it comes in: rows of the curve and the states of the shape.
(function (W) {
  "use strict";

  // Numbers that grow at the end.
  class Growing {
    constructor() { this.list = new Float32Array(4096); this.length = 0; }
    add(values) {
      if (this.length + values.length > this.list.length) {
        const more = new Float32Array(Math.max(2 * this.list.length, this.length + values.length));
        more.set(this.list.subarray(0, this.length));
        this.list = more;
      }
      this.list.set(values, this.length);
      this.length += values.length;
    }
  }

  // Numbers of a state; zeros where nothing is said.
  const parsed = (code, size) => code ? singles(code) : new Float32Array(size);
  const NONE = { driven: [], supports: [], pairs: [], heights: "", frames: null };
  const EMPTY = { labels: [], cells: [], kinds: [], elements: [], reference: "", skin: "", changes: [], depth: "", space: false, fields: [], strained: null };

  // What the last whole run told: which of the curves does most work, and which way is in.
  let likely = { curve: 0, inward: 0 };

  W.Run = class {
    constructor(values) {
      this.id = 0;
      this.values = values;
      this.deck = W.deck;
      this.asked = performance.now();
      this.status = "asked";
      this.raw = [];
      this.time = [];
      this.travel = [];
      this.force = [];
      this.step = [];
      this.increment = [];
      this.curves = [];
      this.curve = likely.curve;
      this.inward = 0;
      this.end = null;
      this.formula = null;
      this.data = null;
    }

    get rows() { return this.time.length - 1; }
    get whole() { return this.status === "completed"; }

    begin(parts, curves) {
      const own = Object.assign({}, NONE, parts || {}), f = Object.assign({}, EMPTY, own.frames || {});
      this.names = f.fields.map((field) => field.name || field);
      this.curves = curves || [];
      if (this.curve >= this.curves.length) this.curve = 0;
      this.data = Object.assign(own, { frames: Object.assign(f, { states: [], changed: [], displacement: "", sections: "", depth_moved: "", fields: this.names.map((name) => ({ name, values: "" })) }) });
      this.size = 2 * f.labels.length;
      this.beams = 2 * f.kinds.filter((kind) => kind === 0).length;
      this.moved = new Growing();
      this.sections = new Growing();
      this.depth = new Growing();
      this.fields = this.names.map(() => new Growing());
      this.most = 0;
      this.mosts = this.names.map(() => 0);
      this.strongest = 0;
      this.points = new Map();
      this.contact = [];
      this.scene = { data: this.data, contact: this.contact, where: (state) => this.where(state), stroke: (driven) => this.stroke(driven) };
      this.status = "running";
      this.state({ state: 0 });
    }

    // Which way is in: as the first motion goes, until the end tells.
    add(rows, frames) {
      for (const row of rows || []) {
        const travel = row[3 + 2 * this.curve] || 0, force = row[4 + 2 * this.curve] || 0;
        // a pressure has no direction
        if (!this.inward && this.curves[this.curve] && this.curves[this.curve].reaction === "P") this.inward = 1;
        if (!this.inward && travel) { this.inward = Math.sign(travel); this.point_inwards(); }
        const s = this.inward || 1;
        this.raw.push(row);
        this.time.push(row[0]);
        this.step.push(row[1]);
        this.increment.push(row[2]);
        this.travel.push(s * travel + 0);
        this.force.push(s * force + 0);
      }
      if (this.data) for (const frame of frames || []) if (frame.state > 0) this.state(frame);
      if (!this.first && this.rows > 0) this.first = performance.now();
    }

    // The arrow of the shape tells in from out.
    point_inwards() {
      const own = this.curves[this.curve], driven = own && this.data && this.data.driven.find((one) => one.node === own.node && one.motion === own.motion);
      if (driven) driven.inward = this.inward;
    }

    // The curve and its direction as the end has them.
    turn(places) {
      if (!places || places.curve === this.curve && places.inward === (this.inward || 1)) return;
      this.curve = places.curve;
      this.inward = places.inward;
      this.point_inwards();
      this.travel = this.raw.map((row) => places.inward * (row[3 + 2 * places.curve] || 0));
      this.force = this.raw.map((row) => places.inward * (row[4 + 2 * places.curve] || 0));
    }

    state(frame) {
      const f = this.data.frames, points = this.size / 2, sections = parsed(frame.sections, this.beams);
      f.states.push(frame.state);
      f.changed.push(frame.changed || 0);
      this.moved.add(parsed(frame.displacement, this.size));
      this.sections.add(sections);
      for (let k = 1; k < sections.length; k += 2) this.most = Math.max(this.most, Math.abs(sections[k]));
      if (f.space) this.depth.add(parsed(frame.depth_moved, points));
      this.fields.forEach((field, k) => {
        const own = parsed(frame.fields && frame.fields[k], points);
        for (const value of own) if (value > this.mosts[k]) this.mosts[k] = value;
        field.add(own);
      });
      this.touch(frame);
    }

    // Contact points as the report has them: of each a list with one entry a state.
    touch(frame) {
      const last = frame.state - 1;
      const fill = (point, until) => {
        while (point.status.length < until) { point.status.push("o"); point.p.push(0); point.t.push(0); point.n.push(NaN); }
      };
      for (const { pair, node, status, area, values } of frame.contact || []) {
        const key = pair + ":" + node;
        let point = this.points.get(key);
        if (!point) {
          point = { pair, node, area, first: 0, start: 0, stride: 1, status: [], p: [], t: [], n: [] };
          this.points.set(key, point);
          this.contact.push(point);
        }
        const [, pressure, shear, , angle] = values;
        fill(point, last);
        point.status.push(status);
        point.p.push(pressure || 0);
        point.t.push(shear || 0);
        point.n.push(angle === null ? NaN : angle);
        if (status !== "o") this.strongest = Math.max(this.strongest, pressure * (area || 1));
      }
      this.contact.forEach((point) => fill(point, frame.state));
    }

    finish(end) {
      this.end = end;
      this.status = end.status || "unknown";
      if (end.places) { this.turn(end.places); likely = end.places; }
      this.formula = end.formula || null;
      if (this.formula && this.formula.curve) {
        const curve = this.formula.curve, s = this.sense(curve.map((point) => point[0]));
        this.formula.travel = curve.map((point) => s * point[0]);
        this.formula.force = curve.map((point) => s * point[1]);
      }
      this.took = performance.now() - this.asked;
    }

    where(state) {
      if (!(state > 0)) return "start";
      return "step " + this.step[state] + ", increment " + this.increment[state] + ", time " + show(this.time[state]);
    }

    // The way of a driven node, as its coordinate has it.
    stroke(driven) {
      const k = this.curves.findIndex((own) => own.node === driven.node && own.motion === driven.motion);
      return k < 0 ? null : this.raw.slice(1).map((row) => row[3 + 2 * k]);
    }

    // State of the peak: push or pull.
    peak(which) {
      const place = this.end && this.end.places ? this.end.places[which] : null;
      return Number.isInteger(place) && place > 0 && place < this.force.length ? place : null;
    }

    // 1 where travels count the way in as positive, as the chart does; -1 where they have the signs of the deck.
    sense(travels) {
      const sum = (list) => list.reduce((a, b) => a + b, 0);
      return sum(travels) * sum(this.travel) < 0 ? -1 : 1;
    }

    // A key figure by its name.
    figure(name) {
      const own = this.end && this.end.figures ? this.end.figures[name] : null;
      return Number.isFinite(own) ? own : undefined;
    }
  };
})(window.Workbench = window.Workbench || {});
