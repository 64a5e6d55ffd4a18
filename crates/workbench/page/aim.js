// Solve for: a wanted force, and the parameter that follows. Typed, or a peak dragged on the curve.
(function (W) {
  "use strict";
  let asked = null, next = null, held = null, setting = false;
  const handles = {};
  // Which peak carries which response.
  const PEAKS = { push: "push_in", pull: "pull_out" };
  const response = (which) => {
    const own = (W.deck ? W.deck.responses : []).find((one) => one.name === PEAKS[which]);
    return own ? own.name : null;
  };

  const say = (text, bad) => { const box = W.by("aim-said"); box.textContent = text; box.classList.toggle("bad", Boolean(bad)); };

  // What can be done: a curve has peaks to drag where its deck has a motion in and out.
  const hint = () => Object.keys(PEAKS).some((which) => response(which)) ? "Type a value, or drag a peak of the curve." : "Type a value.";

  function options() {
    if (asked === null && !next && !W.by("aim-said").classList.contains("bad")) say(hint());
    const fill = (id, names, chosen) => {
      const select = W.by(id), key = JSON.stringify([names, W.noun()]);
      if (select.dataset.names !== key) {
        select.dataset.names = key;
        select.textContent = "";
        names.forEach((name) => make(select, "option", { value: name }, W.label(name)));
      }
      if (names.includes(chosen)) select.value = chosen;
    };
    fill("aim-response", W.deck.responses.map((one) => one.name), W.by("aim-response").value);
    fill("aim-parameter", W.deck.parameters.filter((one) => !one.integer && !W.locked[one.name]).map((one) => one.name), W.follows);
    W.by("aim").hidden = !W.deck.responses.length || !W.deck.parameters.length;
  }

  // Asks for the newest wanted value; one question at a time.
  function pump() {
    if (asked !== null || !next || !W.deck.sound || W.lost) return;
    if (W.locked[W.follows]) { say(W.follows + " is locked: choose another parameter.", true); next = null; return; }
    const { name, wanted, gesture } = next, parameter = W.follows;
    next = null;
    say("Looking for " + parameter + " \u2026");
    asked = W.ask("aim", { values: W.values, parameter, response: name, wanted }, (message) => {
      asked = null;
      if (message.say === "aimed") {
        say(parameter + " " + W.figure(message.value, 6) + " gives " + W.label(name) + " " + W.figure(message.reached, 5) + " (" + message.steps + (message.steps === 1 ? " step" : " steps") + (message.because ? ", slopes by differences: " + message.because : "") + ").");
        setting = true;
        W.set(parameter, message.value, gesture && held !== null);
        setting = false;
      } else if (message.say === "missed") {
        const near = Number.isFinite(message.nearest) ? " Nearest: " + W.figure(message.nearest, 5) + "." : "";
        say((message.why || W.label(name) + " does not reach this value.") + near, true);
      } else if (message.say === "refused") say(message.why, true);
      else if (message.say === "overtaken" && !next) next = { name, wanted, gesture };
      if (!W.busy()) pump();
      return true;
    });
  }
  W.on("idle", pump);
  // Values that a hand has set since are what it wants now.
  W.on("values", () => {
    if (setting || held !== null) return;
    next = null;
    if (asked === null) return;
    W.forget(asked);
    asked = null;
    say("");
  });
  // what was said of other values is over
  for (const name of ["marks", "values"]) W.on(name, () => { if (asked === null && !next && W.by("aim-said").classList.contains("bad")) say(hint()); });

  W.aim = {
    choose(name) {
      W.by("aim-response").value = name;
      const now = W.last ? W.last.figure(name) : undefined;
      if (Number.isFinite(now)) W.by("aim-wanted").value = String(Number(now.toPrecision(4)));
      W.by("aim-wanted").focus();
      W.by("aim-wanted").select();
    },
    want(name, wanted, gesture) { next = { name, wanted, gesture }; pump(); },
    busy: () => asked !== null || next !== null,
    make() {
      W.by("aim").addEventListener("submit", (event) => {
        event.preventDefault();
        const wanted = Number(W.by("aim-wanted").value);
        if (W.by("aim-wanted").value === "" || !Number.isFinite(wanted)) { say("Type the value that you want.", true); return; }
        W.aim.want(W.by("aim-response").value, wanted, false);
      });
      W.by("aim-parameter").addEventListener("change", () => { W.follows = W.by("aim-parameter").value; W.tell("marks"); W.tell("settled"); });
      for (const which of ["push", "pull"]) handles[which] = handle(which);
    },
    place
  };

  // A peak as a thing to be dragged up and down, or moved with the arrow keys.
  function handle(which) {
    const own = make(W.by("plot"), "button", { type: "button", class: "handle " + which, role: "slider", hidden: "", "aria-orientation": "vertical", "aria-valuemin": "0" });
    const canvas = W.by("curve");
    let grip = 0;
    own.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      own.focus();
      own.setPointerCapture(event.pointerId);
      const force = W.last.force[W.last.peak(which)];
      grip = W.chart.plot.py(force) - (event.clientY - canvas.getBoundingClientRect().top);
      held = { which, wanted: force };
    });
    own.addEventListener("pointermove", (event) => {
      if (!held || held.which !== which) return;
      const wanted = W.chart.plot.y(event.clientY - canvas.getBoundingClientRect().top + grip);
      // what the key figure says is a size
      held.wanted = wanted;
      W.aim.want(response(which), Math.abs(wanted), true);
      W.draw();
    });
    const drop = () => {
      if (!held || held.which !== which) return;
      const last = held;
      held = null;
      if (Math.abs(last.wanted - (W.last ? W.last.force[W.last.peak(which)] : 0)) > 0 && (next || asked !== null)) W.aim.want(response(which), Math.abs(last.wanted), false);
      else W.tell("settled");
      W.draw();
    };
    own.addEventListener("pointerup", drop);
    own.addEventListener("pointercancel", drop);
    own.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key], now = W.last && W.last.figure(response(which));
      if (!way || !Number.isFinite(now)) return;
      event.preventDefault();
      W.aim.want(response(which), now * (1 + 0.01 * way), false);
    });
    return own;
  }

  // Puts the handles where the peaks are.
  function place_one(which) {
    const own = handles[which], name = response(which), run = W.last;
    const state = run ? run.peak(which) : null;
    const seen = state !== null && name !== null && !W.lost && W.deck.sound;
    if (!seen) { if (!(held && held.which === which)) own.hidden = true; return; }
    const force = held && held.which === which ? held.wanted : run.force[state], plot = W.chart.plot;
    own.hidden = false;
    own.style.transform = "translate(" + plot.px(run.travel[state]).toFixed(1) + "px," + plot.py(force).toFixed(1) + "px)";
    own.classList.toggle("stale", !W.current());
    const now = run.figure(name);
    const said = W.label(name) + " " + W.figure(now);
    if (own.dataset.said !== said + W.follows) {
      own.dataset.said = said + W.follows;
      own.setAttribute("aria-label", W.label(name) + ", moves " + W.follows);
      own.setAttribute("aria-valuenow", String(Number.isFinite(now) ? now : 0));
      own.setAttribute("aria-valuetext", said);
      own.title = said + ": drag, and " + W.follows + " follows";
      own.textContent = W.figure(Math.abs(run.force[state]), 3);
    }
    own.classList.toggle("left", plot.px(run.travel[state]) > 0.75 * plot.W);
    own.classList.toggle("below", run.force[state] < 0);
  }
  function place() { for (const which of Object.keys(handles)) place_one(which); }

  for (const name of ["deck", "marks"]) W.on(name, options);
  let noun = "force";
  W.on("end", () => { if (W.noun() !== noun) { noun = W.noun(); options(); } });
})(window.Workbench = window.Workbench || {});
