// The report's drawing of the shape, fed by a solve that is still running.
(function (W) {
  "use strict";
  const scene = () => {
    const run = new W.Run({});
    run.begin(null, null);
    return run;
  };

  class LiveShape extends Shape {
    constructor() {
      super(scene().scene);
      this.run = null;
      this.at_time = null;  // the time that is looked at; none: the largest push
      new ResizeObserver(() => this.resize(this.svg.parentNode.clientWidth)).observe(this.svg.parentNode);
      for (const id of ["scale", "view", "field"]) W.by(id).addEventListener("change", () => this.see());
    }

    // As high as the page leaves room.
    height() { return Math.max(140, this.svg.parentNode.clientHeight - 2); }

    names() {
      const key = JSON.stringify([this.data.pairs, this.data.frames.strained]);
      if (key === this.named && this.had === this.contact.length > 0) return;
      this.named = key;
      this.had = this.contact.length > 0;
      super.names();
    }

    stress() { }

    // The numbers of a run, which may have grown.
    link(run) {
      const before = this.now && this.now.whole ? this.now : null;
      if (this.run !== run) { this.run = run; this.take(run.scene); }
      this.moved = run.moved.list;
      this.sections = run.sections.list;
      this.states = run.data.frames.states;
      this.slider.max = Math.max(0, this.states.length - 1);
      if (this.skin.space) this.skin.moved = run.depth.list;
      const still = !run.end && before;
      this.most = Math.max(run.most, still ? before.most : 0);
      this.strongest = Math.max(run.strongest, still ? before.strongest : 0);
      this.skin.fields.forEach((field, k) => {
        field.values = run.fields[k].list;
        field.most = Math.max(run.mosts[k], still && before.mosts[k] || 0);
      });
      if (this.skin.fields.length) this.most = this.skin.fields[0].most = Math.max(this.most, this.skin.fields[0].most);
    }

    // Looks at the whole stroke again.
    settle() { this.seek = true; }

    // As if nothing had been drawn.
    see() { this.seen = null; if (this.run) { this.fit(); this.go(this.frame); } }

    // The view stands still while a curve comes in, unless something leaves it.
    bounds() {
      if (this.view === "contact") return super.bounds();
      const key = this.W + " " + this.H + " " + this.scale + " " + this.skin.turn;
      if (this.seen && this.seen_for === key && !this.seek) return this.seen;
      this.seen = super.bounds();
      this.seen_for = key;
      this.seek = false;
      return this.seen;
    }

    // The frame that is looked at, or the last one on the way there.
    wanted() {
      const run = this.run, last = this.states.length - 1;
      let time = this.at_time;
      if (time === null) {
        const whole = run.end ? run : this.now;
        const peak = whole ? whole.peak("push") : null;
        if (peak === null || !whole) return last;
        time = whole.time[peak];
      }
      let best = 0;
      for (let k = 1; k <= last; k++) if (Math.abs(run.time[this.states[k]] - time) <= Math.abs(run.time[this.states[best]] - time)) best = k;
      return best;
    }

    // Draws what has come of a run.
    show(run) {
      this.link(run);
      if (run.end) {
        if (run !== this.now) { this.now = run; this.names(); if (!W.moving) this.seek = true; }
      } else if (!this.seen || !this.now) this.seek = true;
      this.fit();
      super.go(this.wanted());
    }

    // Somebody goes to a frame; to the same one again where only the drawing has changed.
    go(frame) {
      if (!this.run) return;
      const before = this.frame;
      super.go(frame);
      if (this.frame !== before) this.hold();
    }

    // Later curves are looked at at the same time.
    hold() {
      this.at_time = this.run.time[this.states[this.frame]];
      W.tell("scrub", this.states[this.frame]);
    }

    // The state of the curve that is looked at; large models have frames for some of them only.
    looked() {
      const run = this.run, drawn = this.states[this.frame] || 0;
      if (this.at_time === null) {
        const peak = run && run.end ? run.peak("push") : null;
        return peak === null ? drawn : peak;
      }
      if (!run || run.time[run.rows] < this.at_time) return drawn;
      let best = 0;
      for (let k = 1; k <= run.rows; k++) if (Math.abs(run.time[k] - this.at_time) <= Math.abs(run.time[best] - this.at_time)) best = k;
      return best;
    }

    // Goes to a state of the curve.
    state(state) {
      this.stop();
      if (!this.run) return;
      super.go(this.near(state));
      this.at_time = this.run.time[state];
      W.tell("scrub", state);
    }
  }
  W.LiveShape = LiveShape;
})(window.Workbench = window.Workbench || {});
