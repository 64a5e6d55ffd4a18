// Puts the charts on the page.
const COLOURS = ["--c0", "--c1", "--c2", "--c3", "--c4", "--c5", "--c6"];
const start = (values) => { const out = new Float64Array(values.length + 1); out.set(values, 1); return out; };

function reactions() {
  const parent = document.getElementById("reactions"), made = [];
  const overlay = data.overlay ? columns(data.overlay.columns) : null;
  data.driven.forEach((driven) => {
    const history = data.history.find((one) => one.node === driven.node);
    if (!history) return;
    const own = columns(history.columns);
    if (!own[driven.motion] || !own[driven.reaction]) return;
    // along the motion: the way in is positive, and so is a push
    const s = driven.inward, turn = (values) => values.map((value) => s * value);
    const u = turn(start(driven.travel ? doubles(driven.travel) : own[driven.motion]));
    const ways = Uint8Array.from(u, (value, i) => i > 0 && value < u[i - 1] ? 1 : i > 0 && value === u[i - 1] ? 2 : 0);
    for (let i = 1; i < ways.length; i++) if (ways[i] === 2) ways[i] = ways[i - 1];
    const series = [{ name: data.job, x: u, y: turn(start(driven.force ? doubles(driven.force) : own[driven.reaction])), colour: "--c0", dots: true, ways, wayColours: ["--c0", "--c1"] }];
    const bars = [["_error", "error bars", "--c6", ""], ["_time_error", "error bars in time", "--c2", " (time)"]].flatMap(([ending, name, colour, note]) => {
      const column = own[driven.reaction + ending];
      return column && !driven.force && column.every(Number.isFinite) ? [{ half: start(column), name, colour, note }] : [];
    });
    for (const { half, name, colour } of bars) {
      const most = half.reduce((a, b) => Math.max(a, b), 0), peak = series[0].y.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
      const share = peak > 0 ? " (" + show(100 * most / peak, 2) + " % of the peak)" : "";
      series.push({ name: name + ", at most \u00b1" + show(most, 3) + share, x: series[0].x, y: series[0].y, half, colour });
    }
    const read = (one, i) => show(s * one.y[i], 7) + (one.x === series[0].x ? bars.map((bar) => " \u00b1 " + show(bar.half[i], 3) + bar.note).join("") : "");
    if (overlay && !driven.force && overlay[driven.motion] && overlay[driven.reaction]) {
      const keep = overlay.node ? Array.from(overlay.node.keys()).filter((i) => overlay.node[i] === driven.node) : null;
      const pick = (column) => keep ? Float64Array.from(keep, (i) => column[i]) : column;
      if (!keep || keep.length) series.push({ name: data.overlay.name, x: turn(pick(overlay[driven.motion])), y: turn(pick(overlay[driven.reaction])), colour: "--c2", dash: true });
    }
    const kind = driven.reaction.startsWith("RM") ? "moment" : "force", y = series[0].y;
    const labels = [["push", "push-in ", "--c0"], ["pull", "pull-out ", "--c1"]].filter(([key]) => driven[key] !== null).map(([key, word, colour]) => ({ place: driven[key], colour, text: word + show(Math.abs(y[driven[key]]), 4) }));
    made.push(new Chart(parent, {
      id: "chart-" + driven.node + "-" + driven.motion,
      title: driven.who[0].toUpperCase() + driven.who.slice(1) + ": " + kind + " along " + (driven.force ? "their" : "its") + " motion (" + (driven.force ? "sum of " : "") + driven.reaction + " against " + driven.motion + ")", x: "travel (way in positive)", y: kind + " (push positive)",
      labels,
      describe: (one, i) => one.name + ": " + driven.motion + " = " + show(s * one.x[i], 7) + ", " + driven.reaction + " = " + read(one, i) + (one === made.find((c) => c.series[0] === one)?.series[0] ? " (" + where(i) + ")" : "")
    }, series));
    if (ways.includes(1)) {
      const legend = made[made.length - 1].svg.parentNode.querySelector(".legend");
      for (const [colour, text] of [["--c0", "way in"], ["--c1", "way out"]]) {
        const entry = make(legend, "span", { class: "key" });
        make(entry, "i").style.background = "var(" + colour + ")";
        entry.appendChild(document.createTextNode(text));
      }
    }
  });
  if (!made.length) make(parent, "p", {}, "No node is driven by a prescribed motion.");
  data.loaded.forEach((load) => {
    const history = data.history.find((one) => one.node === load.node);
    if (!history || !history.columns[load.motion]) return;
    new Chart(parent, { title: "Loaded " + (load.name === String(load.node) ? "node " + load.node : "nodes " + load.name + ", of them node " + load.node) + ": " + load.motion + " over time", x: "total time", y: load.motion, describe: (one, i) => load.motion + " = " + show(one.y[i], 7) + " (" + where(i) + ")" },
      [{ name: data.job, x: times, y: start(doubles(history.columns[load.motion])), colour: "--c0", dots: true }]);
  });
  if (overlay && !made.some((chart) => chart.series.some((one) => one.dash))) make(parent, "p", { class: "remark" }, "The columns of " + data.overlay.name + " fit no driven node.");
  return made;
}

// Rows over time: {name, first, status, line: [[place, part]], marks: [place], tell(i)}
function bandRows(parent, rows, label) {
  const count = times.length - 1, row = 24;
  const scroll = make(parent, "div", { class: "scroll" });
  const svg = draw(scroll, "svg", { tabindex: 0, role: "img", "aria-label": label + " Arrow keys read values off." });
  const out = make(parent, "p", { class: "readoff", role: "status", "aria-live": "polite" });
  let left, width, mark, at = [0, -1], W = 0;
  const height = rows.length * row + 34, x = (i) => left + i / count * width;
  const read = (k, i) => {
    at = [Math.max(0, Math.min(rows.length - 1, k)), Math.max(0, Math.min(count - 1, i))];
    for (const [name, value] of [["visibility", "visible"], ["x", x(at[1])], ["y", at[0] * row + 3], ["width", width / count]]) mark.setAttribute(name, value);
    out.textContent = rows[at[0]].tell(at[1]);
  };
  const band = (one, k) => {
    const top = k * row + 4, h = row - 5, short = W < 560 ? 9 : 16;
    draw(svg, "text", { x: left - 8, y: top + 14, "text-anchor": "end" }, one.name.length > short ? one.name.slice(0, short - 1) + "\u2026" : one.name);
    const part = (letter, from, to) => draw(svg, "rect", { class: "band-" + letter, x: x(from), y: top, width: Math.max(0.5, x(to) - x(from)), height: h, "fill-opacity": letter === "o" ? 0.35 : 0.55 });
    for (let i = 0; i < one.status.length;) {
      let j = i;
      while (j < one.status.length && one.status[j] === one.status[i]) j++;
      part(one.status[i], one.first + i, one.first + j);
      i = j;
    }
    if (one.first + one.status.length < count) part("o", one.first + one.status.length, count);
    draw(svg, "path", { class: "pressure", d: one.line.map(([place, part], i) => (i ? "L" : "M") + x(place + 0.5).toFixed(1) + " " + (top + h - part * (h - 2)).toFixed(1)).join("") });
    for (const place of one.marks) draw(svg, "path", { class: "dropped", d: "M" + x(place + 0.5).toFixed(1) + " " + (top + 4) + "l4 4l-4 4l-4-4z" });
  };
  fitted(parent, (wide) => {
    W = Math.max(280, wide - 2);
    left = W < 560 ? 84 : 150;
    width = W - left - 20;
    svg.textContent = "";
    svg.setAttribute("viewBox", "0 0 " + W + " " + height);
    rows.forEach(band);
    const foot = rows.length * row + 20, parts = Math.max(2, Math.min(10, Math.round(width / 80)));
    for (let k = 0; k <= parts; k++) {
      const i = Math.round(k * count / parts);
      if (k === 0 || i !== Math.round((k - 1) * count / parts)) draw(svg, "text", { class: "soft", x: x(i), y: foot, "text-anchor": "middle" }, show(times[i], 4));
    }
    draw(svg, "text", { class: "soft", x: left - 14, y: foot, "text-anchor": "end" }, "time");
    mark = draw(svg, "rect", { class: "axis", fill: "none", visibility: "hidden", height: row - 2 });
    if (at[1] >= 0) read(at[0], at[1]);
  });
  svg.addEventListener("pointermove", (event) => {
    const frame = svg.getBoundingClientRect();
    const px = (event.clientX - frame.left) / frame.width * W, py = (event.clientY - frame.top) / frame.height * height;
    if (px >= left && px <= left + width && py < rows.length * row) read(Math.floor(py / row), Math.floor((px - left) / width * count));
  });
  svg.addEventListener("keydown", (event) => {
    const moves = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
    if (moves) { event.preventDefault(); read(at[0] + moves[0], at[1] + moves[1]); }
  });
}

// What the points of a pair do together: stuck where one sticks, the sum of
// their normal forces, and how many are closed.
function together(name) {
  const points = contact.filter((point) => point.pair === name), count = times.length - 1;
  const status = [], closed = new Array(count).fill(0), dropped = new Set();
  for (let i = 0; i < count; i++) {
    let letter = "o";
    for (const point of points) {
      const own = point.status[i - point.first];
      if (own === "t" || own === "s") closed[i]++;
      if (own === "t") letter = "t"; else if (own === "s" && letter === "o") letter = "s";
      if (point.friction[i - point.first] === "d") dropped.add(i);
    }
    status.push(letter);
  }
  const force = new Map();
  for (const point of points) {
    for (let k = 0; k < point.p.length; k++) {
      const place = placed(point, k);
      if (point.status[place - point.first] !== "o") force.set(place, (force.get(place) || 0) + point.p[k] * (point.area || 1));
    }
  }
  const most = Math.max(0, ...force.values()), places = [];
  for (let place = (count - 1) % data.stride; place < count; place += data.stride) places.push(place);
  const words = { o: "open", t: "some point sticks", s: "slips" };
  return {
    name, first: 0, status: status.join(""), marks: Array.from(dropped),
    line: places.map((place) => [place, most > 0 ? (force.get(place) || 0) / most : 0]),
    tell: (i) => name + ", " + where(i + 1) + ": " + words[status[i]] + ", " + closed[i] + (closed[i] === 1 ? " point" : " points") + " closed" + (places.includes(i) ? ", normal force " + show(force.get(i) || 0) : "")
  };
}

function single(point, most) {
  const words = { o: "open", t: "stick", s: "slip" }, calls = { c: "called", d: "dropped", n: "none" }, marks = [];
  for (let i = 0; i < point.friction.length; i++) if (point.friction[i] === "d") marks.push(point.first + i);
  return {
    name: point.pair + " " + point.node, first: point.first, status: point.status, marks,
    line: Array.from(point.p, (p, i) => [placed(point, i), most > 0 ? p / most : 0]),
    tell: (i) => {
      const j = i - point.first, k0 = nearest(point, i), elsewhere = placed(point, k0) === i ? "" : "; numbers of " + where(placed(point, k0) + 1);
      return point.pair + " node " + point.node + ", " + where(i + 1) + ": " + (j < 0 ? "not yet in contact" : j >= point.status.length ? "open again" : words[point.status[j]] + ", pressure " + show(point.p[k0]) + ", shear " + show(point.t[k0]) + ", gap " + show(point.g[k0]) + ", slip " + show(point.u[k0]) + ", friction " + calls[point.friction[j]] + elsewhere);
    }
  };
}

function bands() {
  const parent = document.getElementById("bands");
  if (!contact.length) { make(parent, "p", {}, "Nothing touched."); return; }
  const key = make(parent, "div", { class: "legend" });
  for (const [colour, text] of [["--stick", "stick"], ["--slip", "slip"], ["--open", "open again"]]) {
    const entry = make(key, "span", { class: "key" });
    make(entry, "i").style.background = "var(" + colour + ")";
    entry.appendChild(document.createTextNode(text));
  }
  make(key, "span", {}, "line: normal force of the pair, of a node its pressure" + (data.stride > 1 ? ", at one increment in " + data.stride : "") + "; \u25c6 friction was not called");
  const names = Array.from(new Set(contact.map((point) => point.pair))).sort();
  bandRows(make(parent, "div", { id: "pairs" }), names.map(together), "Contact status of every pair.");
  const points = contact.slice();
  points.sort((a, b) => a.pair < b.pair ? -1 : a.pair > b.pair ? 1 : a.node - b.node);
  let most = 0;
  for (const point of points) for (const p of point.p) most = Math.max(most, p);
  const details = make(parent, "details", { id: "nodes" });
  make(details, "summary", {}, "Node by node (" + points.length + (points.length === 1 ? " node" : " nodes") + " that closed; one scale of pressure for all)");
  const inside = make(details, "div");
  details.addEventListener("toggle", () => {
    if (details.open && !inside.firstChild) bandRows(inside, points.map((point) => single(point, most)), "Contact status of every slave point.");
  });
}

// Moment and outer stress along the beams, at the peaks and where the animation stands.
function alongBeams() {
  const parent = document.getElementById("beams"), f = data.frames;
  if (!parent) return () => {};
  if (!shape.beams.length || !shape.states.length) { make(parent, "p", {}, "There is no beam, or no state, to draw."); return () => {}; }
  const x = [], places = [];
  let along = 0, end = -1;
  shape.beams.forEach((cell, k) => {
    const a = f.cells[2 * cell], b = f.cells[2 * cell + 1], p = shape.at(a, 0, 0), q = shape.at(b, 0, 0), length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    if (end >= 0 && a !== end) { x.push(NaN); places.push(-1); }
    x.push(along + 0.5 * length); places.push(k);
    along += length;
    end = b;
  });
  const curve = (frame, which) => Float64Array.from(places, (k) => k < 0 ? NaN : which ? Math.abs(shape.section(k, frame, which)) : shape.section(k, frame, which));
  const first = data.driven[0] || {}, charts = [];
  [["bending moment", "moment", 0], ["size of the largest stress in the section", "stress", 1]].forEach(([title, y, which]) => {
    let low = 0, high = 0;
    for (let i = which; i < shape.sections.length; i += 2) { const value = which ? Math.abs(shape.sections[i]) : shape.sections[i]; low = Math.min(low, value); high = Math.max(high, value); }
    const series = [{ name: "now", x, y: curve(shape.frame, which), colour: "--ink" }];
    for (const [key, name, colour] of [["push", "at the push-in peak", "--c0"], ["pull", "at the pull-out peak", "--c1"]]) {
      if (first[key]) series.push({ name, x, y: curve(shape.near(first[key]), which), colour, dash: true });
    }
    const chart = new Chart(parent, { id: "chart-" + y, title: title[0].toUpperCase() + title.slice(1), x: "length along the beams", y, apart: true, range: [low, high],
      describe: (one, i) => one.name + ": " + y + " " + show(one.y[i]) + " in element " + (places[i] < 0 ? "-" : f.elements[shape.beams[places[i]]]) }, series);
    charts.push([chart, series, which]);
  });
  return (frame) => charts.forEach(([chart, , which]) => { chart.series[0].y = curve(frame, which); chart.update(); });
}

function energies() {
  const parent = document.getElementById("energies"), own = columns(data.energy);
  const names = Object.keys(own), label = (name) => name.replace(/_/g, " ");
  const describe = (one, i) => one.name + ": " + show(one.y[i], 7) + " at time " + show(one.x[i]);
  const series = names.filter((name) => name !== "balance").map((name, k) => ({ name: label(name), x: times, y: start(own[name]), colour: COLOURS[k % COLOURS.length], dash: k >= 4 }));
  if (!series.length) return;
  new Chart(parent, { id: "chart-energy", title: "Energies since the start", x: "total time", y: "energy (force times length)", describe }, series);
  if (own.balance) new Chart(parent, { id: "chart-balance", title: "Balance: external work minus the change of everything else since the first converged state", x: "total time", y: "balance", describe }, [{ name: "balance", x: times, y: start(own.balance), colour: "--c6", dots: true }]);
}

function iterations() {
  const parent = document.getElementById("iterations");
  if (!data.attempts.length) { make(parent, "p", {}, "JOB.msg lists no iterations."); return; }
  const bars = [], force = [[], [], []], moment = [[], []], rows = [];
  let total = 0;
  for (const attempt of data.attempts) {
    const severe = attempt.iterations.filter((it) => it[0] & 1).length, changes = attempt.iterations.reduce((sum, it) => sum + it[1], 0);
    const last = attempt.iterations[attempt.iterations.length - 1];
    for (const it of attempt.iterations) {
      total++;
      const floor = (value) => Math.max(value, 1e-12);
      force[0].push(total); force[1].push(it[4] > 0 ? floor(it[3] / it[4]) : NaN); force[2].push(attempt);
      moment[0].push(total); moment[1].push(it[6] > 0 ? floor(it[5] / it[6]) : NaN);
    }
    bars.push({ attempt, severe, equilibrium: attempt.iterations.length - severe });
    rows.push([attempt.step, attempt.increment, attempt.attempt, severe, attempt.iterations.length - severe, changes, last ? show(last[3], 3) : "-", last ? show(last[4], 3) : "-", attempt.reason || "converged"]);
  }
  const describe = (one, i) => one.name + " of iteration " + one.x[i] + " (step " + force[2][i].step + ", increment " + force[2][i].increment + ", attempt " + force[2][i].attempt + "): " + show(one.y[i], 4) + " times what is allowed";
  const x = Float64Array.from(bars, (_, k) => k + 1), number = (one) => Float64Array.from(bars, one);
  new Chart(parent, { id: "chart-iterations", title: "Iterations and contact changes per attempt", x: "attempt", y: "count", whole: true, counts: true, apart: true,
    describe: (one, i) => one.name + ": " + (one.base ? one.y[i] - one.base[i] : one.y[i]) + " in step " + bars[i].attempt.step + ", increment " + bars[i].attempt.increment + ", attempt " + bars[i].attempt.attempt + (bars[i].attempt.reason ? "; given up: " + bars[i].attempt.reason : "")
  }, [
    { name: "equilibrium iterations", x, y: number((b) => b.equilibrium), base: number(() => 0), colour: "--c0" },
    { name: "severe discontinuity iterations", x, y: number((b) => b.equilibrium + b.severe), base: number((b) => b.equilibrium), colour: "--c1" },
    { name: "contact changes", x, y: Float64Array.from(rows, (r) => r[5]), colour: "--ink", dots: true, apart: true },
    { name: "attempts given up", x, y: number((b) => b.attempt.reason ? b.equilibrium + b.severe : NaN), colour: "--bad", dots: true, apart: true }
  ].filter((one) => one.name !== "attempts given up" || one.y.some(Number.isFinite)));
  new Chart(parent, { id: "chart-residuals", title: "Largest residual over what is allowed, iteration by iteration", x: "iteration", y: "residual / allowed", log: true, whole: true, apart: true, describe }, [
    { name: "force residual", x: force[0], y: force[1], colour: "--c0", dots: true },
    { name: "moment residual", x: moment[0], y: moment[1], colour: "--c3", dash: true }
  ]);
  const details = make(parent, "details");
  make(details, "summary", {}, "Table of attempts");
  details.addEventListener("toggle", () => {
    if (!details.open || details.querySelector("table")) return;
    const table = make(make(details, "div", { class: "wide scroll" }), "table"), head = make(make(table, "thead"), "tr"), body = make(table, "tbody");
    for (const name of ["step", "increment", "attempt", "severe", "equilibrium", "contact changes", "force residual", "allowed", "outcome"]) make(head, "th", {}, name);
    for (const row of rows) { const line = make(body, "tr"); for (const cell of row) make(line, "td", {}, String(cell)); }
  });
}

// The frame with the largest push, or the last one.
function tightest() {
  const driven = data.driven[0];
  return driven && driven.push !== null ? shape.near(driven.push) : shape.states.length - 1;
}

// Ways to the peaks.
function peakButtons() {
  const parent = document.getElementById("peaks"), driven = data.driven[0];
  if (!driven || !shape.states.length) return;
  for (const [key, text] of [["push", "push-in peak"], ["pull", "pull-out peak"]]) {
    if (driven[key] !== null) make(parent, "button", { type: "button" }, text).addEventListener("click", () => { shape.stop(); shape.go(shape.near(driven[key])); });
  }
}

const shape = new Shape({ data, contact, where, stroke });
const followed = reactions(), along = alongBeams();
shape.moves = (state, frame) => { followed.forEach((chart) => chart.follow(state)); along(frame); };
shape.go(tightest());
peakButtons();
bands();
energies();
iterations();

// On paper nothing can be unfolded.
window.addEventListener("beforeprint", () => document.querySelectorAll("#warnings details, #computed > details").forEach((one) => { one.open = true; }));
