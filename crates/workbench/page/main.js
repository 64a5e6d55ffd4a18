// Puts the parts together: drawing, keys, tabs, the first deck.
(function (W) {
  "use strict";
  // One drawing a frame of the screen, of the newest state only.
  let asked = false, reshape = false;
  W.drawn = 0;
  W.draw = (shape) => {
    reshape = reshape || Boolean(shape);
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      if (reshape && W.shown && W.shown.data && W.shown.rows >= 0) { reshape = false; W.shape.show(W.shown); W.chart.look(W.shape.looked()); }
      W.chart.paint();
      W.aim.place();
      W.drawn++;
    });
  };

  function tabs() {
    const names = ["sliders", "deck"];
    const open = (name) => {
      for (const one of names) {
        W.by("tab-" + one).setAttribute("aria-selected", String(one === name));
        W.by("tab-" + one).tabIndex = one === name ? 0 : -1;
        W.by("panel-" + one).hidden = one !== name;
      }
      document.body.classList.toggle("reading", name === "deck");
    };
    names.forEach((name, k) => {
      W.by("tab-" + name).addEventListener("click", () => open(name));
      W.by("tab-" + name).addEventListener("keydown", (event) => {
        if (event.key !== "ArrowRight" && event.key !== "ArrowLeft") return;
        open(names[1 - k]);
        W.by("tab-" + names[1 - k]).focus();
      });
    });
    open("sliders");
    W.open_tab = open;
  }

  function keys() {
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
      const letter = event.key.toLowerCase();
      // a text field that is being typed in has its own undo
      const own = event.target === W.by("text");
      if (letter === "z" && !own) { event.preventDefault(); if (event.shiftKey) W.redo(); else W.undo(); }
      else if (letter === "y" && !own) { event.preventDefault(); W.redo(); }
      else if (letter === "s") { event.preventDefault(); W.save("deck"); }
    });
    W.by("undo").addEventListener("click", W.undo);
    W.by("redo").addEventListener("click", W.redo);
    W.by("pin").addEventListener("click", W.pin);
    W.by("stop").addEventListener("click", W.stop);
  }

  // The first deck of the page, with what its address asks for.
  W.start_deck = (message, own) => {
    document.body.classList.remove("starting");
    W.by("start").hidden = true;
    W.by("bench").hidden = false;
    if (own) W.expect(own);
    const text = own && typeof own.x === "string" ? own.x : null;
    // where the text of the address is there already, nothing else is known of the first one
    W.opened = text === message.text ? null : message.text;
    if (text !== null && text !== message.text) {
      W.deck = null;
      W.edit(text, () => W.restore_pins(own));
    } else {
      W.receive(message);
      if (own) W.restore_pins(own);
    }
    W.draw(true);
  };

  function open() {
    const own = W.address();
    const carried = W.single ? W.carried() : null;
    W.ask(carried ? "deck" : "open", carried || {}, (message) => {
      if (message.say === "start") {
        W.start(message);
        if (own && own.k) { W.pending = own; W.choose(own.k); }
      } else if (message.say === "deck") W.start_deck(message, own);
      else W.tell("refused", message.why);
      return true;
    });
  }

  W.on("deck", (deck) => {
    W.by("name").textContent = deck.name;
    document.title = deck.name + " \u2013 Slideline workbench";
  });
  W.on("points", () => W.draw(true));
  W.on("end", () => W.draw(true));
  W.on("asked", () => W.draw());
  W.on("values", () => W.draw());
  W.on("scrub", (state) => { W.chart.look(state); W.draw(); });
  W.on("settled", () => { if (W.shape) W.shape.settle(); W.draw(true); });
  W.on("end", () => { W.by("pin").disabled = !W.last.whole; });
  W.on("lost", (why) => { const box = W.by("lost"); box.hidden = false; box.textContent = why; W.draw(); });
  W.on("refused", (why) => { W.by("saved").textContent = why; });
  W.on("connected", open);

  W.shape = new W.LiveShape();
  W.chart.make();
  W.aim.make();
  W.text.make();
  W.completion.make();
  W.saving();
  tabs();
  keys();
  W.connect();
})(window.Workbench = window.Workbench || {});
