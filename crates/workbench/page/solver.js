// Sends what a hand asks for: only the newest values wait, and a solve that runs has a little time
// before newer values end it, so that a curve is whole now and then while a slider moves.
(function (W) {
  "use strict";
  const PATIENCE = 60, STUCK = 300; // milliseconds
  let running = null, waiting = null, timer = null;
  W.shown = null;   // the run that is drawn: it has rows
  W.last = null;    // the last run that came to its end
  W.ghost = null;   // what was there before the hand began to move

  // Seconds since what runs was asked for.
  W.solving = () => running ? (performance.now() - running.asked) / 1000 : 0;
  W.stopped = false;
  // Ends what runs, and leaves its curve as it is.
  W.stop = () => {
    waiting = null;
    if (!running) return;
    W.stopped = true;
    if (W.overtakes) W.ask("stop", {}, null);
    else { W.forget(running.id); running = null; W.restart(); W.tell("stopped"); }
  };

  W.busy = () => Boolean(running || waiting);
  // Whether what is drawn is what the sliders say, to its end.
  W.current = () => Boolean(W.shown && W.shown.end && W.deck && W.deck.sound && !W.lost && W.shown.deck === W.deck && W.same(W.shown.values, W.values));

  function start() {
    clearTimeout(timer);
    timer = null;
    if (running) W.forget(running.id);
    const values = waiting;
    waiting = null;
    W.stopped = false;
    const run = new W.Run(values);
    running = run;
    run.id = W.ask("solve", { values }, (message) => hear(run, message));
    W.tell("asked", run);
  }

  // Ends what runs for what waits.
  function over() {
    if (!W.overtakes && running) { W.forget(running.id); running = null; W.restart(); }
    start();
  }

  function pump() {
    if (!waiting) return;
    if (!running) { start(); return; }
    if (timer !== null) return;
    const left = (W.overtakes ? PATIENCE : STUCK) - (performance.now() - running.asked);
    timer = setTimeout(() => { timer = null; if (waiting) over(); }, Math.max(0, left));
  }

  // Solves for the values there are now.
  W.solve = () => {
    if (!W.deck || !W.deck.sound || W.lost) return;
    waiting = Object.assign({}, W.values);
    pump();
  };

  function hear(run, message) {
    if (message.say === "begin") {
      run.begin(message.parts, message.curves);
      return false;
    }
    if (message.say === "points") {
      if (!run.data) run.begin(null, null);
      run.add(message.rows, message.frames);
      if (run === running) { W.shown = run; W.tell("points", run); }
      return false;
    }
    if (run === running) running = null;
    if (message.say === "end") {
      if (!run.data) run.begin(null, null);
      run.finish(message);
      W.stopped = false;
      W.shown = run;
      W.last = run;
      W.tell("end", run);
    } else if (message.say === "overtaken") {
      run.status = "overtaken";
      if (W.stopped && !waiting) { W.tell("stopped"); return true; }
      // ended by another question than a newer solve: these values are still wanted
      if (!waiting && W.same(run.values, W.values) && W.deck === run.deck) waiting = run.values;
    } else {
      run.status = "refused";
      W.tell("refused", message.why || "The program could not solve this deck.");
    }
    pump();
    if (!W.busy()) W.tell("idle");
    return true;
  }

  // A new deck ends what ran for the old one.
  W.on("deck", () => {
    haunt();
    waiting = null;
    clearTimeout(timer);
    timer = null;
    if (running) { W.forget(running.id); running = null; }
    W.solve();
  });
  W.on("lost", (why) => { W.lost = why; running = null; waiting = null; });

  // The ghost is the last whole curve before a hand began to move.
  function haunt() {
    if (W.last && W.last.whole) W.ghost = { travel: W.last.travel, force: W.last.force };
  }
  W.moving = false;
  W.on("values", (what) => {
    if (!W.moving) haunt();
    W.moving = what.gesture;
    W.solve();
  });
  W.on("settled", () => { W.moving = false; if (waiting && W.overtakes) start(); });
})(window.Workbench = window.Workbench || {});
