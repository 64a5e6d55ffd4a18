// The deck's text: line numbers, errors underlined where they are, edits that apply at once.
(function (W) {
  "use strict";
  const PAUSE = 120; // milliseconds after the last key
  let timer = null, asked = null, area = null;

  // Hands a text to the bench. `then` acts once its deck has come.
  W.edit = (text, then) => {
    if (asked !== null) W.forget(asked);
    asked = W.ask("deck", { text }, (message) => {
      asked = null;
      if (message.say === "deck") {
        if (area.value !== message.text && !W.typing()) fill(message.text);
        W.receive(message);
        if (then) then();
      } else if (message.say === "refused") W.by("problems-said").textContent = message.why;
      return true;
    });
  };
  W.typing = () => document.activeElement === area && timer !== null;

  function fill(text) { area.value = text; lines(); scroll(); }

  let count = 0;
  function lines() {
    const now = area.value.split("\n").length;
    if (now !== count) {
      count = now;
      W.by("numbers").textContent = Array.from({ length: now }, (_, k) => k + 1).join("\n");
    }
    marks();
  }

  // Underlines: the text once more behind the area, with marks around what is wrong.
  function marks() {
    const back = W.by("marks"), found = new Map();
    for (const one of W.deck ? W.deck.diagnostics : []) {
      if (one.severity !== "error" && one.severity !== "warning") continue;
      if (!found.has(one.line)) found.set(one.line, one);
    }
    back.textContent = "";
    scroll();
    if (W.deck && area.value !== W.deck.text) return;
    area.value.split("\n").forEach((line, k) => {
      const one = found.get(k + 1);
      if (!one) { back.appendChild(document.createTextNode(line + "\n")); return; }
      let [from, to] = one.columns || [1, line.length + 1];
      from = Math.max(0, Math.min(line.length, from - 1));
      to = Math.max(from, Math.min(line.length, to - 1));
      if (to === from) { from = 0; to = line.length; }
      back.appendChild(document.createTextNode(line.slice(0, from)));
      make(back, "mark", { class: one.severity }, line.slice(from, to) || " ");
      back.appendChild(document.createTextNode(line.slice(to) + "\n"));
    });
  }

  function scroll() {
    W.by("marks").style.transform = "translate(" + -area.scrollLeft + "px," + -area.scrollTop + "px)";
    W.by("numbers").style.transform = "translateY(" + -area.scrollTop + "px)";
  }

  function problems() {
    const list = W.by("problems"), all = W.deck ? W.deck.diagnostics : [];
    const rank = (one) => ["error", "warning", "advice"].indexOf(one.severity) >= 0 ? ["error", "warning", "advice"].indexOf(one.severity) : 3;
    const shown = all.slice().sort((a, b) => rank(a) - rank(b)).slice(0, 40), notes = shown.filter((one) => rank(one) === 3).length;
    let folded = null;
    list.textContent = "";
    const errors = all.filter((one) => one.severity === "error").length, warnings = all.filter((one) => one.severity === "warning").length;
    const many = (n, word) => n + " " + word + (n === 1 ? "" : "s");
    W.by("problems-said").textContent = errors || warnings ? [errors ? many(errors, "error") : "", warnings ? many(warnings, "warning") : ""].filter(Boolean).join(", ") : "No error, no warning.";
    const badge = W.by("badge");
    badge.hidden = !errors;
    badge.textContent = String(errors);
    for (const one of shown) {
      if (rank(one) === 3 && !folded) {
        const fold = make(make(list, "li"), "details");
        make(fold, "summary", { class: "soft" }, many(notes, "note"));
        folded = make(fold, "ul");
      }
      const item = make(folded || list, "li", { class: "problem " + one.severity });
      const go = make(item, "button", { type: "button", class: "link" }, (one.line ? "line " + one.line + " " : "") + one.code);
      go.addEventListener("click", () => goto(one.line, (one.columns || [1])[0]));
      make(item, "span", {}, " " + one.message);
      if (one.help) make(item, "p", { class: "soft" }, one.help);
      const page = make(item, "button", { type: "button", class: "link soft" }, "explain " + one.code);
      page.addEventListener("click", () => W.explain(one.code));
    }
  }

  function goto(line, column) {
    const lines = area.value.split("\n");
    let place = 0;
    for (let k = 0; k < Math.min(line - 1, lines.length); k++) place += lines[k].length + 1;
    area.focus();
    area.setSelectionRange(place + Math.max(0, column - 1), place + Math.max(0, column - 1));
    area.scrollTop = Math.max(0, (line - 4) * W.text.line_height());
    scroll();
  }

  // Where things are in a text of one letter width.
  let sizes = null;
  const measured = () => {
    if (sizes) return sizes;
    const style = getComputedStyle(area), pen = document.createElement("canvas").getContext("2d");
    pen.font = style.font;
    sizes = { high: parseFloat(style.lineHeight), wide: pen.measureText("0".repeat(100)).width / 100, left: parseFloat(style.paddingLeft), top: parseFloat(style.paddingTop) };
    return sizes;
  };
  W.text = {
    line_height: () => measured().high,
    get area() { return area; },
    // Line and column, both from 0, of a place in the text.
    at(place) {
      const before = area.value.slice(0, place).split("\n");
      return [before.length - 1, before[before.length - 1].length];
    },
    // Pixels of a line and column, relative to the area.
    pixel(line, column) {
      const own = measured();
      return [own.left + column * own.wide - area.scrollLeft, own.top + line * own.high - area.scrollTop];
    },
    under(event) {
      const own = measured(), r = area.getBoundingClientRect();
      return [Math.floor((event.clientY - r.top - own.top + area.scrollTop) / own.high), Math.floor((event.clientX - r.left - own.left + area.scrollLeft) / own.wide)];
    },
    typed() {
      lines();
      W.typed_at = performance.now();
      clearTimeout(timer);
      timer = setTimeout(() => { timer = null; W.edit(area.value, () => W.tell("settled")); }, PAUSE);
    },
    make() {
      area = W.by("text");
      area.addEventListener("input", () => W.text.typed());
      area.addEventListener("scroll", scroll);
      W.by("into-text").addEventListener("click", () => {
        W.ask("save", { what: "deck", values: W.values }, (message) => {
          if (message.say === "file") { fill(message.text); W.edit(message.text, () => W.tell("settled")); }
          return true;
        });
      });
    }
  };
  W.on("deck", () => {
    if (timer === null && area.value !== W.deck.text) fill(W.deck.text);
    lines();
    problems();
  });
})(window.Workbench = window.Workbench || {});
