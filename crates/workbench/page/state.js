// What the page knows: the deck, the values of its parameters, and who wants to hear of a change.
// Every file of the page adds to this one object.
(function (W) {
  "use strict";
  const heard = {};
  // on(name, act) hears of what tell(name, what) says.
  W.on = (name, act) => { (heard[name] = heard[name] || []).push(act); };
  W.tell = (name, what) => { (heard[name] || []).forEach((act) => act(what)); };

  W.by = (id) => document.getElementById(id);
  W.deck = null;      // as the bench has it: name, text, parameters, responses, diagnostics
  W.opened = null;    // the text that the bench was started with, or of the kind that was chosen
  W.kind = null;      // kind of the start page, where the deck comes from there
  W.values = {};      // of all parameters
  W.locked = {};      // names of parameters that stay
  W.tolerances = {};  // name: part of the value, 0.05 is 5 %
  W.follows = null;   // the parameter that "solve for" changes
  W.wanted = null;    // values that an address asks for before its deck is there

  W.parameter = (name) => W.deck ? W.deck.parameters.find((one) => one.name === name) : undefined;

  // Values for people: no more digits than they need.
  W.figure = (value, digits) => Number.isFinite(value) ? show(value, digits || 4) : "\u2013";

  const clean = (value) => Number(value.toPrecision(12));

  // The step that a slider has: about a four hundredth of its range, and round.
  W.step = (parameter) => {
    const span = parameter.maximum - parameter.minimum;
    if (parameter.integer) return 1;
    return span > 0 ? niceStep(span, 400) : 1;
  };

  // Sets one value. gesture: a hand is still moving it.
  W.set = (name, value, gesture) => {
    const parameter = W.parameter(name);
    if (!parameter || !Number.isFinite(value)) return;
    const own = clean(parameter.integer ? Math.round(value) : value);
    if (W.values[name] === own) {
      if (!gesture) W.tell("settled");
      // what was stopped is asked for again
      if (!gesture && W.stopped && !W.busy()) W.solve();
      return;
    }
    W.values = Object.assign({}, W.values, { [name]: own });
    W.tell("values", { name, gesture: Boolean(gesture) });
    if (!gesture) W.tell("settled");
  };

  // Sets many values at once.
  W.take = (values) => {
    const own = {};
    for (const parameter of W.deck ? W.deck.parameters : []) {
      const value = values[parameter.name];
      own[parameter.name] = Number.isFinite(value) ? value : W.values[parameter.name];
    }
    W.values = own;
    W.tell("values", { name: null, gesture: false });
    W.tell("settled");
  };

  // Those values that are not the deck's.
  W.changed = () => {
    const out = {};
    for (const parameter of W.deck ? W.deck.parameters : []) {
      if (W.values[parameter.name] !== parameter.value) out[parameter.name] = W.values[parameter.name];
    }
    return out;
  };

  W.same = (a, b) => {
    const names = Object.keys(a);
    return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
  };

  // A deck has come. Values that a hand has set stay where the text did not change them; while the
  // text has errors the sliders stay those of the last sound one.
  let sound = null;
  W.receive = (deck) => {
    const old = {};
    for (const parameter of sound ? sound.parameters : []) old[parameter.name] = parameter.value;
    if (!deck.sound && sound) deck.parameters = sound.parameters;
    else {
      const kept = {};
      for (const parameter of deck.parameters) {
        const mine = W.values[parameter.name];
        kept[parameter.name] = Number.isFinite(mine) && old[parameter.name] === parameter.value ? mine : parameter.value;
      }
      W.values = kept;
    }
    if (deck.sound) sound = deck;
    W.deck = deck;
    if (W.wanted) {
      const wanted = W.wanted;
      W.wanted = null;
      for (const parameter of deck.parameters) {
        if (Number.isFinite(wanted[parameter.name])) W.values[parameter.name] = wanted[parameter.name];
      }
    }
    if (!W.parameter(W.follows)) {
      const first = deck.parameters.find((one) => /thick|height/i.test(one.name)) || deck.parameters.find((one) => !one.integer) || deck.parameters[0];
      W.follows = first ? first.name : null;
    }
    W.tell("deck", deck);
  };
})(window.Workbench = window.Workbench || {});
