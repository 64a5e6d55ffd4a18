// The sliders: one row a parameter, with its value, lock, tolerance, and whether "solve for" moves it.
(function (W) {
  "use strict";
  const rows = new Map();

  const icon = (parent, path) => {
    const svg = draw(parent, "svg", { viewBox: "0 0 16 16", "aria-hidden": "true", focusable: "false", class: "icon" });
    draw(svg, "path", { d: path });
    return svg;
  };
  const LOCK = "M4 7h8v6H4zM5.5 7V5a2.5 2.5 0 0 1 5 0v2";
  const AIM = "M8 2v3M8 11v3M2 8h3M11 8h3M8 5.5a2.5 2.5 0 1 0 0 5a2.5 2.5 0 0 0 0-5z";

  W.icon = icon;
  W.AIM = AIM;

  // A range of the slider that holds the value.
  function span(own) {
    const value = W.values[own.name], low = Math.min(own.minimum, value), high = Math.max(own.maximum, value);
    return [low, high];
  }

  // The unit and the words of a comment such as "height of the arm [mm]".
  function words(parameter) {
    const about = parameter.about || "", unit = parameter.unit || (about.match(/\[([^\]]+)\]\s*$/) || [])[1] || "";
    return [about.replace(/\s*\[[^\]]+\]\s*$/, ""), unit];
  }
  W.words = words;

  function row(parent, parameter) {
    const name = parameter.name, id = "value-" + name, [about, unit] = words(parameter);
    const box = make(parent, "div", { class: "parameter", "data-name": name, role: "group", "aria-label": name });
    const label = make(box, "label", { for: id, title: name + (about ? ": " + about : "") });
    make(label, "b", {}, name);
    if (unit) make(label, "span", { class: "unit" }, unit);
    make(label, "small", { id: "about-" + name }, about || (parameter.origin === "found" ? "found in the deck" : ""));
    const field = make(box, "input", { id, class: "value", type: "number", step: "any", "aria-describedby": "about-" + name });
    const step = W.step(parameter), slider = make(box, "input", { type: "range", step: String(step), "aria-label": name + (unit ? " in " + unit : "") });
    const tools = make(box, "div", { class: "tools" });
    const tolerance = make(tools, "label", { class: "tolerance", title: "Tolerance: the force is drawn as a band" });
    make(tolerance, "span", { "aria-hidden": "true" }, "\u00b1");
    const part = make(tolerance, "input", { type: "number", min: "0", step: "any", "aria-label": "tolerance of " + name + " in percent" });
    make(tolerance, "span", { "aria-hidden": "true" }, "%");
    const follows = make(tools, "button", { type: "button", class: "small", "aria-pressed": "false", title: "Solve for moves " + name, "aria-label": "solve for moves " + name });
    icon(follows, AIM);
    const lock = make(tools, "button", { type: "button", class: "small", "aria-pressed": "false", title: "Lock " + name, "aria-label": "lock " + name });
    icon(lock, LOCK);

    const own = { box, field, slider, part, follows, lock, parameter };
    const value = () => {
      const raw = Number(slider.value), low = Number(slider.min), high = Number(slider.max);
      // the ends of the range are the ends of the range, between them stand round values
      return raw <= low || raw >= high ? raw : Math.round(raw / step) * step;
    };
    slider.addEventListener("input", () => W.set(name, value(), true));
    slider.addEventListener("change", () => W.set(name, value(), false));
    field.addEventListener("input", () => {
      const typed = field.value === "" ? NaN : Number(field.value);
      field.setCustomValidity(Number.isFinite(typed) ? "" : "a number");
      if (Number.isFinite(typed)) { own.typed = true; W.set(name, typed, true); own.typed = false; }
    });
    field.addEventListener("change", () => { W.tell("settled"); fill(own); });
    field.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!way) return;
      event.preventDefault();
      W.set(name, W.values[name] + way * step, false);
    });
    part.addEventListener("change", () => {
      const typed = Number(part.value);
      const tolerances = Object.assign({}, W.tolerances);
      if (part.value !== "" && typed > 0) tolerances[name] = typed / 100; else delete tolerances[name];
      W.tolerances = tolerances;
      W.tell("tolerances");
      W.tell("settled");
    });
    follows.addEventListener("click", () => { W.follows = name; W.locked = Object.assign({}, W.locked, { [name]: false }); W.tell("marks"); W.tell("settled"); });
    lock.addEventListener("click", () => { W.locked = Object.assign({}, W.locked, { [name]: !W.locked[name] }); W.tell("marks"); W.tell("settled"); });
    label.addEventListener("dblclick", () => W.set(name, parameter.value, false));
    rows.set(name, own);
    fill(own);
  }

  function fill(own) {
    const name = own.parameter.name, value = W.values[name], [low, high] = span(own.parameter);
    own.slider.min = low;
    own.slider.max = high;
    // between the steps too: what was typed is what stands there
    const steps = (value - low) / W.step(own.parameter);
    own.slider.step = Math.abs(steps - Math.round(steps)) < 1e-9 ? String(W.step(own.parameter)) : "any";
    own.slider.value = value;
    if (!own.typed) { own.field.value = String(Number(value.toPrecision(7))); own.field.setCustomValidity(""); }
    const part = W.tolerances[name];
    if (document.activeElement !== own.part) own.part.value = part ? String(Number((100 * part).toPrecision(6))) : "";
    const locked = Boolean(W.locked[name]);
    own.slider.disabled = own.field.disabled = locked;
    own.lock.setAttribute("aria-pressed", String(locked));
    own.follows.setAttribute("aria-pressed", String(W.follows === name));
    own.box.classList.toggle("changed", value !== own.parameter.value);
    own.box.classList.toggle("locked", locked);
  }

  function all() {
    const parent = W.by("parameters"), shape = JSON.stringify(W.deck.parameters.map((one) => [one.name, one.about, one.unit, one.minimum, one.maximum, one.integer]));
    if (parent.dataset.shape !== shape) {
      parent.dataset.shape = shape;
      parent.textContent = "";
      rows.clear();
      W.deck.parameters.forEach((one) => row(parent, one));
      if (!W.deck.parameters.length) make(parent, "p", { class: "soft" }, "Nothing in this deck is a number that a slider may move. Give it a *PARAMETER.");
    } else W.deck.parameters.forEach((one) => { rows.get(one.name).parameter = one; });
    rows.forEach(fill);
  }

  W.on("deck", all);
  W.on("values", (what) => { if (what.name) { const own = rows.get(what.name); if (own) fill(own); } else rows.forEach(fill); });
  W.on("tolerances", () => rows.forEach(fill));
  W.on("marks", () => rows.forEach(fill));
})(window.Workbench = window.Workbench || {});
