// Curves that are kept beside the one that moves, with their values.
(function (W) {
  "use strict";
  const HUES = ["c3", "c4", "c2", "c5", "c6"];
  W.pins = [];

  // What a pin keeps of a run.
  const light = (run) => ({ travel: run.travel.slice(), force: run.force.slice(), key: W.tiles(run.end), status: run.status });

  function free() {
    for (let k = 0; ; k++) if (!W.pins.some((pin) => pin.number === k)) return k;
  }

  W.pin = () => {
    if (!W.current() || !W.last.whole) return;
    const number = free();
    W.pins.push({ number, name: "pin " + (number + 1), colour: HUES[number % HUES.length], values: Object.assign({}, W.values), text: W.deck.text, run: light(W.last) });
    W.tell("pins");
    W.tell("settled");
  };

  // A pin of an address has values only: its curve is computed when nothing else is.
  W.on("idle", () => {
    const pin = W.pins.find((one) => !one.run && !one.asked);
    if (!pin || !W.deck || !W.deck.sound || W.busy()) return;
    const run = new W.Run(pin.values);
    pin.asked = true;
    W.ask("solve", { values: pin.values }, (message) => {
      if (message.say === "begin") run.begin(null, message.curves);
      else if (message.say === "points") run.add(message.rows, []);
      else {
        if (message.say === "end") { run.finish(message); pin.run = light(run); } else pin.asked = message.say !== "overtaken";
        W.tell("pins");
        if (!W.busy()) W.tell("idle");
        return true;
      }
      return false;
    });
  });

  // Values in which a pin differs from the deck, or from another pin.
  function differing() {
    const out = [];
    for (const parameter of W.deck ? W.deck.parameters : []) {
      const own = new Set(W.pins.map((pin) => pin.values[parameter.name]));
      if (own.size > 1 || !own.has(parameter.value)) out.push(parameter.name);
    }
    return out.slice(0, 5);
  }

  W.on("pins", () => {
    const list = W.by("pins"), names = differing();
    list.textContent = "";
    W.by("no-pins").hidden = W.pins.length > 0;
    W.pins.forEach((pin) => {
      const item = make(list, "li", { class: "pin" });
      const head = make(item, "div", { class: "head" });
      make(head, "i", { class: "stroke" }).style.setProperty("--own", "var(--" + pin.colour + ")");
      make(head, "b", {}, pin.name);
      make(head, "button", { type: "button", class: "small", "aria-label": "go to the values of " + pin.name }, "go to").addEventListener("click", () => W.take(pin.values));
      make(head, "button", { type: "button", class: "small", "aria-label": "remove " + pin.name }, "\u00d7").addEventListener("click", () => {
        W.pins = W.pins.filter((one) => one !== pin);
        W.tell("pins");
        W.tell("settled");
      });
      const values = names.map((name) => name + " " + W.figure(pin.values[name]));
      make(item, "p", {}, values.length ? values.join(", ") : "values of the deck");
      if (pin.run && pin.run.key) {
        const found = pin.run.key.slice(0, 3);
        make(item, "p", { class: "soft" }, found.map((one) => one.name + " " + one.text).join(", "));
      } else if (!pin.run) make(item, "p", { class: "soft" }, "waits for its curve");
    });
    W.draw();
  });
})(window.Workbench = window.Workbench || {});
