// Force over travel: the curve as it comes, the ghost of the last one, pins, formula, band, and
// the state that is looked at.
(function (W) {
  "use strict";
  let plot = null, ink = null, place = 0, hover = -1;
  const legend = [];

  // Which end of the way a piece of the curve belongs to: in or out.
  function pieces(run) {
    const out = [];
    let from = 0, way = 1;
    for (let i = 1; i < run.travel.length; i++) {
      const step = run.travel[i] - run.travel[i - 1], own = step < 0 ? -1 : step > 0 ? 1 : way;
      if (own !== way) { if (i - 1 > from) out.push([from, i - 1, way]); from = i - 1; way = own; }
    }
    out.push([from, run.travel.length - 1, way]);
    return out;
  }

  // What of the last whole curve has not come again yet.
  function remainder(run, last) {
    if (run.end || !last || last === run) return null;
    const time = run.time[run.rows];
    let from = last.time.findIndex((own) => own >= time);
    return from < 0 ? null : [Math.max(0, from - 1), last.rows];
  }

  function lists(run) {
    const out = [[run.travel, run.force]], f = W.formula();
    if (W.last && !run.end) out.push([W.last.travel, W.last.force]);
    if (W.ghost) out.push([W.ghost.travel, W.ghost.force]);
    for (const pin of W.pins) if (pin.run) out.push([pin.run.travel, pin.run.force]);
    if (f && f.travel) out.push([f.travel, f.force]);
    if (W.band) out.push([W.band.travel, W.band.low], [W.band.travel, W.band.high]);
    return out;
  }

  // The design guide's curve: that of the last end, pale until it is that of the sliders.
  W.formula = () => W.last && W.last.deck === W.deck ? W.last.formula : null;

  function paint() {
    const run = W.shown;
    plot.resize();
    ink = plot.colours();
    plot.clear();
    // a shape of other values is pale, as a curve of other values is
    W.by("stage").classList.toggle("pale", Boolean(run) && (run.rows < 1 || !W.busy() && !W.current()));
    if (!run || run.rows < 1) {
      plot.axes(ink, titles());
      if (run && run.end) {
        plot.text("No curve with these values.", (plot.L + plot.W) / 2, plot.H / 3, "center", ink.soft);
        legend[0] = W.by("lines").textContent = W.by("readoff").textContent = "";
        W.by("state").textContent = "No state with these values; the shape is an earlier one.";
      }
      W.tell("painted");
      return;
    }
    plot.range(lists(run), W.moving || W.busy());
    plot.axes(ink, titles());
    const current = W.current(), strong = current ? 1 : 0.55;
    plot.inside(() => {
      if (W.band) plot.band(W.band.travel, W.band.low, W.band.high, ink.c5);
      if (ghostly(run)) plot.curve(W.ghost.travel, W.ghost.force, ink.ghost, { width: 1.6 });
      for (const pin of W.pins) if (pin.run) plot.curve(pin.run.travel, pin.run.force, ink[pin.colour], { width: 1.5, alpha: 0.9 });
      const rest = remainder(run, W.last);
      if (rest) plot.curve(W.last.travel, W.last.force, ink.ghost, { width: 1.2, from: rest[0], to: rest[1] });
      for (const [from, to, way] of pieces(run)) plot.curve(run.travel, run.force, way > 0 ? ink.c0 : ink.c1, { width: 2.2, alpha: strong, from, to });
      const f = W.formula();
      if (f && f.travel) plot.curve(f.travel, f.force, ink.c2, { width: 1.8, dash: [7, 4], alpha: strong });
      if (hover >= 0 && hover <= run.rows) plot.dot(run.travel[hover], run.force[hover], ink.paper, ink.soft, 4);
      if (place >= 0 && place <= run.rows) {
        plot.pen.strokeStyle = ink.soft;
        plot.pen.setLineDash([2, 3]);
        plot.line(plot.px(run.travel[place]), 0, plot.px(run.travel[place]), plot.H);
        plot.pen.setLineDash([]);
        plot.dot(run.travel[place], run.force[place], ink.ink, ink.paper, 5);
      }
    });
    if (run.end && !run.curves.length) plot.text("Nothing is driven or loaded in this deck: there is no force over a travel.", (plot.L + plot.W) / 2, plot.H / 3, "center", ink.soft);
    keys(run);
    W.tell("painted");
  }

  // What is drawn over the travel: of a turning body its moment, where nothing is driven the load.
  const NOUNS = [["RM", "moment"], ["CM", "moment"], ["CF", "load"], ["P", "pressure"]];
  const curve = () => W.last && W.last.curves[W.last.curve];
  W.noun = () => {
    const own = curve(), found = own && NOUNS.find(([begin]) => own.reaction.startsWith(begin));
    return found ? found[1] : "force";
  };
  const loaded = () => { const own = curve(); return Boolean(own) && /^[CP]/.test(own.reaction); };
  const way = () => {
    const own = curve();
    if (!loaded()) return W.noun() === "moment" ? "turn" : "travel";
    return (own.motion.startsWith("UR") ? "turn" : "displacement") + " " + own.motion + " of " + own.who;
  };

  const titles = () => {
    const unit = (name) => W.deck && W.deck.units && W.deck.units[name] ? " [" + W.deck.units[name] + "]" : "";
    return [way() + unit("travel"), W.noun() + unit("force")];
  };

  // A ghost is seen beside another curve only.
  const ghostly = (run) => W.ghost && W.ghost.force !== run.force && (W.ghost.force.length !== run.force.length || W.ghost.force.some((own, i) => own !== run.force[i]));

  // What the lines are.
  function keys(run) {
    const f = W.formula(), own = [["c0", loaded() ? "loading" : "way in", ""]];
    if (run.travel.some((value, i) => i > 0 && value < run.travel[i - 1])) own.push(["c1", loaded() ? "unloading" : "way out", ""]);
    if (ghostly(run)) own.push(["ghost", "before", ""]);
    if (f && f.travel) own.push(["c2", "design guide", "dash"]);
    if (W.band) own.push(["c5", "tolerances, " + W.band.share, "band"]);
    W.pins.forEach((pin) => { if (pin.run) own.push([pin.colour, pin.name, ""]); });
    const text = JSON.stringify(own);
    if (text === legend[0]) return;
    legend[0] = text;
    const list = W.by("lines");
    list.textContent = "";
    for (const [colour, name, kind] of own) {
      const entry = make(list, "span", { class: "key" });
      make(entry, "i", { class: "stroke " + kind }).style.setProperty("--own", "var(--" + colour + ")");
      entry.appendChild(document.createTextNode(name));
    }
  }

  function read() {
    const run = W.shown, i = hover >= 0 && run && hover <= run.rows ? hover : place;
    if (!run || !(i >= 0 && i <= run.rows)) return;
    W.by("readoff").textContent = (loaded() ? "displacement " : "travel ") + show(run.travel[i], 4) + ", " + W.noun() + " " + show(run.force[i], 4) + " (" + run.where(i) + ")";
  }

  // The state nearest to a place on the screen: nearest travel first where the way is plain.
  function nearest(x, y) {
    const run = W.shown;
    let best = Infinity, found = -1;
    for (let i = 0; run && i <= run.rows; i++) {
      const d = Math.hypot(plot.px(run.travel[i]) - x, 0.35 * (plot.py(run.force[i]) - y));
      if (d < best) { best = d; found = i; }
    }
    return found;
  }

  // Reading off follows the pointer, pressing takes the shape along.
  function listen(canvas) {
    let held = false;
    const spot = (event) => { const r = canvas.getBoundingClientRect(); return nearest(event.clientX - r.left, event.clientY - r.top); };
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      held = true;
      canvas.setPointerCapture(event.pointerId);
      const state = spot(event);
      if (state >= 0) W.shape.state(state);
    });
    canvas.addEventListener("pointermove", (event) => {
      const state = spot(event);
      if (state < 0) return;
      if (held) W.shape.state(state);
      hover = state;
      read();
      W.draw();
    });
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { held = false; });
    canvas.addEventListener("pointerleave", () => { hover = -1; read(); W.draw(); });
    canvas.addEventListener("keydown", (event) => {
      const run = W.shown;
      if (!run || event.ctrlKey || event.metaKey || event.altKey) return;
      const to = { ArrowRight: place + 1, ArrowLeft: place - 1, Home: 0, End: run.rows }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      W.shape.state(Math.max(0, Math.min(run.rows, to)));
    });
  }

  W.chart = {
    make() {
      const canvas = W.by("curve");
      plot = new W.Plot(canvas);
      listen(canvas);
      new ResizeObserver(() => W.draw()).observe(canvas.parentNode);
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => W.draw());
    },
    paint,
    look(state) { place = state; read(); },
    at: () => place,
    get plot() { return plot; }
  };
})(window.Workbench = window.Workbench || {});
