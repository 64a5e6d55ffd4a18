// Undo and redo, and the state in the address: both are one small object.
(function (W) {
  "use strict";
  const past = [], future = [];
  let taking = false, timer = null, written = null;

  function state() {
    const out = { v: W.changed() };
    if (Object.keys(W.tolerances).length) out.t = W.tolerances;
    const locked = Object.keys(W.locked).filter((name) => W.locked[name]);
    if (locked.length) out.l = locked;
    if (W.follows) out.f = W.follows;
    if (W.kind) out.k = W.kind;
    if (W.deck && W.deck.text !== W.opened) out.x = W.deck.text;
    return out;
  }

  function apply(own) {
    W.tolerances = own.t || {};
    W.locked = Object.fromEntries((own.l || []).map((name) => [name, true]));
    W.follows = own.f || W.follows;
    const text = own.x === undefined ? W.opened : own.x;
    const values = () => {
      const all = {};
      for (const parameter of W.deck.parameters) all[parameter.name] = parameter.value;
      W.take(Object.assign(all, own.v));
      W.tell("tolerances");
      W.tell("marks");
    };
    if (W.deck && text !== null && text !== W.deck.text) W.edit(text, values); else values();
  }

  // A hand has let go: what there is now can be come back to.
  W.on("settled", () => {
    if (taking || !W.deck) return;
    const now = JSON.stringify(state());
    if (now !== past[past.length - 1]) {
      past.push(now);
      if (past.length > 200) past.shift();
      future.length = 0;
    }
    buttons();
    remember();
  });
  W.on("deck", () => { if (!past.length) past.push(JSON.stringify(state())); buttons(); remember(); });
  W.on("pins", () => remember());

  function buttons() {
    W.by("undo").disabled = past.length < 2;
    W.by("redo").disabled = !future.length;
  }

  function go(to) {
    taking = true;
    apply(JSON.parse(to));
    taking = false;
    buttons();
    remember();
  }
  W.undo = () => { if (past.length > 1) { future.push(past.pop()); go(past[past.length - 1]); } };
  W.redo = () => { if (future.length) { const to = future.pop(); past.push(to); go(to); } };

  // Browsers allow few changes of an address a second.
  function remember() {
    if (timer) return;
    timer = setTimeout(() => {
      timer = null;
      if (!W.deck) return;
      const own = state();
      if (W.pins.length) own.p = W.pins.map((pin) => pin.values);
      const text = "#" + code(JSON.stringify(own));
      if (text !== location.hash) { written = text; history.replaceState(null, "", text); }
    }, 400);
  }

  const code = (text) => btoa(Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte)).join("")).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");

  // What an address says; nothing where it says nothing that can be read.
  W.address = () => {
    const text = location.hash.slice(1).replace(/-/g, "+").replace(/_/g, "/");
    if (!text) return null;
    try {
      const own = JSON.parse(new TextDecoder().decode(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))));
      return own && typeof own === "object" ? own : null;
    } catch (error) {
      return null;
    }
  };

  // Before its deck is there: what will be asked of it.
  W.expect = (own) => {
    W.wanted = own.v || null;
    W.tolerances = own.t || {};
    W.locked = Object.fromEntries((own.l || []).map((name) => [name, true]));
    W.follows = own.f || null;
  };
  W.restore_pins = (own) => {
    const list = Array.isArray(own.p) ? own.p : [];
    const hues = ["c3", "c4", "c2", "c5", "c6"];
    W.pins = list.map((values, number) => ({ number, name: "pin " + (number + 1), colour: hues[number % 5], values, run: null }));
    W.tell("pins");
  };

  window.addEventListener("hashchange", () => { if (location.hash !== written && W.address()) location.reload(); });
})(window.Workbench = window.Workbench || {});
