// The verdict, the key figures, the formula's reason: what is said about a curve.
(function (W) {
  "use strict";
  const COLOURS = ["green", "amber", "red"];

  // Green is only what came to its end: whatever else the bench may say of it.
  function colour(end) {
    const own = end.verdict && COLOURS.includes(end.verdict.colour) ? end.verdict.colour : "amber";
    return end.status === "completed" ? own : "red";
  }

  const TITLES = { green: "Sound", amber: "Look again", red: "Not to be relied on" };
  const STATUS = { completed: "Completed", not_converged: "Not converged", stopped: "Stopped", failed: "Failed", input_error: "Not solved: the deck has errors with these values" };

  let said = "";
  function verdict(run) {
    const box = W.by("verdict"), current = W.current(), end = run && run.end;
    const now = W.lost || W.deck && !W.deck.sound ? "red" : current ? colour(end) : "waiting";
    box.className = "verdict " + now;
    box.dataset.current = String(current);
    W.by("chart").dataset.current = String(current);
    let title = "Solving \u2026", lines = null;
    const solving = W.solving();
    W.by("stop").hidden = !(solving > 0.7);
    if (solving > 0.7 && W.shown && !W.shown.end) title = "Solving \u2026 increment " + Math.max(0, W.shown.rows);
    if (W.lost) { title = "No connection"; lines = [W.lost]; }
    else if (W.deck && !W.deck.sound) { title = "The deck has errors"; lines = ["The curve is that of the last sound deck."]; }
    else if (W.stopped) { title = "Stopped"; lines = ["The curve is not whole. Move a slider to solve again."]; }
    else if (W.refusal) { title = "Not solved"; lines = [W.refusal]; }
    else if (current) {
      const own = end.verdict || {}, reasons = (own.reasons || []).map((one) => typeof one === "string" ? [one, colour(end)] : [one.text, one.colour]).flatMap((one) => spelt(one, end));
      title = own.headline || TITLES[colour(end)];
      if (end.status !== "completed" && !/red/i.test(title)) title = TITLES.red;
      // why it stopped is said once, with what can be done
      const because = end.diagnosis && end.diagnosis.message ? " because " + end.diagnosis.message : null;
      lines = reasons.concat((own.lines || []).map((line) => [because ? line.replace(because, "") : line, ""]));
      const status = STATUS[end.status] || end.status, told = lines.some(([line]) => line.startsWith(status));
      if (end.status !== "completed") lines = (told ? [] : [[status, "red"]]).concat(end.diagnosis ? [[text(end.diagnosis), "red"]] : [], lines);
    }
    lines = lines && lines.map((one) => typeof one === "string" ? [one, ""] : one);
    // said once is enough
    lines = lines && lines.filter(([line], k) => lines.findIndex(([own]) => own === line) === k);
    const key = JSON.stringify([title, lines]);
    W.by("verdict-title").textContent = title;
    // the words of the last verdict stay, grey, while a new one is made: nothing jumps
    if (lines && key !== said) {
      said = key;
      // what there is to object to, and how it went; the rest on demand
      const list = W.by("verdict-lines"), more = W.by("verdict-rest");
      list.textContent = "";
      more.textContent = "";
      const most = lines.filter(([, own]) => own).length + 1;
      lines.forEach(([line, own], k) => written(k < most ? list : more, line, own));
      W.by("verdict-more").hidden = lines.length <= most;
    }
  }

  // A reason that only names codes says what these are about.
  function spelt([line, own], end) {
    if (!/^warnings?: /.test(line)) return [[line, own]];
    const told = (line.match(/SL\d{4}/g) || []).map((code) => (end.said || []).find((one) => one.code === code));
    return told.every(Boolean) ? told.map((one) => [one.code + ": " + one.message, own]) : [[line, own]];
  }

  // A line of the verdict; its codes open their pages beside the deck.
  function written(list, line, own) {
    const item = make(list, "li", own ? { class: own } : {});
    line.split(/(SL\d{4})/).forEach((part, k) => {
      if (k % 2 === 0) { item.appendChild(document.createTextNode(part)); return; }
      const page = make(item, "button", { type: "button", class: "link", title: "What " + part + " means" }, part);
      page.addEventListener("click", () => { W.open_tab("deck"); W.explain(part); });
    });
  }

  // A sentence each: what is wrong, and what can be done.
  const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1) + (/[.?!]$/.test(text) ? "" : ".");
  const text = (diagnosis) => typeof diagnosis === "string" ? diagnosis : [diagnosis.message, diagnosis.help].filter(Boolean).map(sentence).join(" ");

  const rows = new Map();
  function figures(run) {
    const box = W.by("figures"), end = run && run.end, current = W.current();
    box.classList.toggle("waiting", !current);
    if (!end) return;
    const key = tiles(end), names = JSON.stringify(key.map((one) => [one.name, one.response]));
    if (box.dataset.names !== names) {
      box.dataset.names = names;
      box.textContent = "";
      rows.clear();
      for (const one of key) {
        const tile = make(box, "div", { class: "figure", "data-response": one.response || "" });
        make(tile, "dt", {}, one.name);
        const value = make(tile, "dd"), number = make(value, "b");
        if (one.response) {
          const button = make(value, "button", { type: "button", class: "small", title: "Solve for " + W.label(one.response), "aria-label": "solve for " + W.label(one.response) });
          W.icon(button, W.AIM);
          button.addEventListener("click", () => W.aim.choose(one.response));
        }
        rows.set(one.name, { number, about: make(tile, "small"), tile });
      }
    }
    for (const one of key) {
      const own = rows.get(one.name);
      own.number.textContent = one.text;
      own.about.textContent = one.about || "";
      own.tile.classList.toggle("fail", /FAIL$/.test(one.about || ""));
    }
  }

  // What can be solved for, by the words of the report's key figures.
  const WORDS = [[/^push-in/, "push_in"], [/^pull-out/, "pull_out"], [/^out \/ in/, "ratio"], [/^work in/, "work_in"], [/^largest deflection/, "deflection"], [/^largest strain/, "strain"]];
  function tiles(end) {
    const known = new Set(W.deck ? W.deck.responses.map((one) => one.name) : []);
    const out = (end.key || []).map((one) => {
      const found = one.response || (WORDS.find(([word]) => word.test(one.name)) || [])[1];
      return { name: one.name, text: one.text || W.figure(one.value), about: one.about, response: known.has(found) ? found : null };
    });
    const noise = end.figures ? end.figures.noise : null;
    if (Number.isFinite(noise)) out.push({ name: "noise of the mesh", text: show(100 * noise, 2) + " %", about: "roughness of the force, of its peak", response: null });
    return out;
  }
  W.tiles = tiles;

  // Names of key figures and responses for people.
  const LABELS = { push_in: "force in", pull_out: "force out", ratio: "ratio out / in", work_in: "work in", work_out: "work out", deflection: "deflection", strain: "strain", utilisation: "utilisation", margin: "strain margin", noise: "noise" };
  W.label = (name) => (LABELS[name] || name.replace(/_/g, " ")).replace("force", W.noun());

  function formula() {
    const own = W.formula(), box = W.by("formula");
    box.classList.toggle("waiting", !W.current());
    box.hidden = !(own && own.reason);
    if (box.hidden) return;
    const cut = own.reason.search(/\. [A-Z]/) + 1 || own.reason.length;
    box.querySelector("summary").textContent = (own.name || "Design guide") + (Number.isFinite(own.value) ? " gives " + W.figure(own.value) : "") + ". " + own.reason.slice(0, cut);
    const rest = [own.reason.slice(cut).trim()].concat(own.assumptions && own.assumptions.length ? "It assumes that " + own.assumptions.join("; ") + "." : []);
    box.querySelector("p").textContent = rest.filter(Boolean).join(" ");
  }

  // Who hears the page hears a verdict once a hand has let go, not every curve on the way.
  let hearing = null;
  function heard() {
    clearTimeout(hearing);
    hearing = setTimeout(() => {
      if (W.busy() || W.moving) return;
      const first = W.current() ? tiles(W.last.end).slice(0, 2).map((one) => one.name + " " + one.text) : [];
      const text = [W.by("verdict-title").textContent].concat(first).join(", ");
      if (W.by("heard").textContent !== text) W.by("heard").textContent = text;
    }, 400);
  }

  W.say = () => {
    const run = W.last;
    verdict(run);
    heard();
    figures(run);
    formula();
  };
  W.on("asked", () => { W.refusal = null; });
  // a solve that takes long says how far it is
  W.on("points", () => { if (W.solving() > 0.7) verdict(W.last); });
  W.on("stopped", W.say);
  W.on("refused", (why) => { W.refusal = why; W.say(); });
  for (const name of ["values", "end", "deck", "lost"]) W.on(name, W.say);
})(window.Workbench = window.Workbench || {});
