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
    const series = [{ name: data.job, x: start(own[driven.motion]), y: start(own[driven.reaction]), colour: "--c0", dots: true }];
    const bars = [["_error", "error bars", "--c0", ""], ["_time_error", "error bars in time", "--c2", " (time)"]].flatMap(([ending, name, colour, note]) => {
      const column = own[driven.reaction + ending];
      return column ? [{ half: start(column), name, colour, note }] : [];
    });
    for (const { half, name, colour } of bars) {
      const most = half.reduce((a, b) => Math.max(a, b), 0), peak = series[0].y.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
      const share = peak > 0 ? " (" + show(100 * most / peak, 2) + " % of the peak)" : "";
      series.push({ name: name + ", at most \u00b1" + show(most, 3) + share, x: series[0].x, y: series[0].y, half, colour });
    }
    const read = (one, i) => show(one.y[i], 7) + (one.x === series[0].x ? bars.map((bar) => " \u00b1 " + show(bar.half[i], 3) + bar.note).join("") : "");
    if (overlay && overlay[driven.motion] && overlay[driven.reaction]) {
      const keep = overlay.node ? Array.from(overlay.node.keys()).filter((i) => overlay.node[i] === driven.node) : null;
      const pick = (column) => keep ? Float64Array.from(keep, (i) => column[i]) : column;
      if (!keep || keep.length) series.push({ name: data.overlay.name, x: pick(overlay[driven.motion]), y: pick(overlay[driven.reaction]), colour: "--c1", dash: true });
    }
    made.push(new Chart(parent, {
      id: "chart-" + driven.node + "-" + driven.motion,
      title: "Node " + driven.node + ": " + driven.reaction + " against " + driven.motion, x: driven.motion, y: driven.reaction,
      describe: (one, i) => one.name + ": " + driven.motion + " = " + show(one.x[i], 7) + ", " + driven.reaction + " = " + read(one, i) + (one === made.find((c) => c.series[0] === one)?.series[0] ? " (" + where(i) + ")" : "")
    }, series));
  });
  if (!made.length) make(parent, "p", {}, "No node is driven by a prescribed motion.");
  data.loaded.forEach((load) => {
    const history = data.history.find((one) => one.node === load.node);
    if (!history || !history.columns[load.motion]) return;
    new Chart(parent, { title: "Loaded node " + load.node + ": " + load.motion + " over time", x: "total time", y: load.motion, describe: (one, i) => load.motion + " = " + show(one.y[i], 7) + " (" + where(i) + ")" },
      [{ name: data.job, x: times, y: start(doubles(history.columns[load.motion])), colour: "--c0", dots: true }]);
  });
  if (overlay && !made.some((chart) => chart.series.some((one) => one.dash))) make(parent, "p", { class: "remark" }, "The columns of " + data.overlay.name + " fit no driven node.");
  return made;
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
  make(key, "span", {}, "line: pressure, one scale for all" + (data.stride > 1 ? ", at one increment in " + data.stride : "") + "; \u25c6 friction was not called");
  const points = contact.slice();
  points.sort((a, b) => a.pair < b.pair ? -1 : a.pair > b.pair ? 1 : a.node - b.node);
  const count = times.length - 1, row = 22, left = 150, width = 790, height = points.length * row + 34;
  let most = 0;
  for (const point of points) for (const p of point.p) most = Math.max(most, p);
  const scroll = make(parent, "div", { class: "scroll" });
  const svg = draw(scroll, "svg", { viewBox: "0 0 960 " + height, tabindex: 0, role: "img", "aria-label": "Contact status of every slave point. Arrow keys read values off." });
  const x = (i) => left + i / count * width;
  points.forEach((point, k) => {
    const top = k * row + 4, h = row - 4;
    draw(svg, "text", { x: left - 8, y: top + 13, "text-anchor": "end" }, (point.pair.length > 10 ? point.pair.slice(0, 9) + "\u2026" : point.pair) + " " + point.node);
    for (let i = 0; i < point.status.length;) {
      let j = i;
      while (j < point.status.length && point.status[j] === point.status[i]) j++;
      draw(svg, "rect", { class: "band-" + point.status[i], x: x(point.first + i), y: top, width: Math.max(0.5, x(point.first + j) - x(point.first + i)), height: h, "fill-opacity": point.status[i] === "o" ? 0.35 : 0.55 });
      i = j;
    }
    const rest = point.first + point.status.length;
    if (rest < count) draw(svg, "rect", { class: "band-o", x: x(rest), y: top, width: x(count) - x(rest), height: h, "fill-opacity": 0.35 });
    const d = Array.from(point.p, (p, i) => (i ? "L" : "M") + x(placed(point, i) + 0.5).toFixed(1) + " " + (top + h - (most > 0 ? p / most : 0) * (h - 2)).toFixed(1));
    draw(svg, "path", { class: "pressure", d: d.join("") });
    for (let i = 0; i < point.friction.length; i++) {
      if (point.friction[i] === "d") draw(svg, "path", { class: "dropped", d: "M" + x(point.first + i + 0.5).toFixed(1) + " " + (top + 3) + "l4 4l-4 4l-4-4z" });
    }
  });
  const foot = points.length * row + 20;
  for (let k = 0; k <= 10; k++) {
    const i = Math.round(k * count / 10);
    if (k === 0 || i !== Math.round((k - 1) * count / 10)) draw(svg, "text", { class: "soft", x: x(i), y: foot, "text-anchor": "middle" }, show(times[i], 4));
  }
  draw(svg, "text", { class: "soft", x: left - 8, y: foot, "text-anchor": "end" }, "time");
  const mark = draw(svg, "rect", { class: "axis", fill: "none", visibility: "hidden", height: row - 2 });
  const out = make(parent, "p", { class: "readoff", role: "status", "aria-live": "polite" });
  let at = [0, -1];
  const read = (k, i) => {
    at = [Math.max(0, Math.min(points.length - 1, k)), Math.max(0, Math.min(count - 1, i))];
    const point = points[at[0]], j = at[1] - point.first;
    const k0 = nearest(point, at[1]), elsewhere = placed(point, k0) === at[1] ? "" : "; numbers of " + where(placed(point, k0) + 1);
    const words = { o: "open", t: "stick", s: "slip" }, calls = { c: "called", d: "dropped", n: "none" };
    for (const [name, value] of [["visibility", "visible"], ["x", x(at[1])], ["y", at[0] * row + 3], ["width", width / count]]) mark.setAttribute(name, value);
    out.textContent = point.pair + " node " + point.node + ", " + where(at[1] + 1) + ": " + (j < 0 ? "not yet in contact" : j >= point.status.length ? "open again" : words[point.status[j]] + ", pressure " + show(point.p[k0]) + ", shear " + show(point.t[k0]) + ", gap " + show(point.g[k0]) + ", slip " + show(point.u[k0]) + ", friction " + calls[point.friction[j]] + elsewhere);
  };
  svg.addEventListener("pointermove", (event) => {
    const frame = svg.getBoundingClientRect();
    const px = (event.clientX - frame.left) / frame.width * 960, py = (event.clientY - frame.top) / frame.height * height;
    if (px >= left && px <= left + width && py < points.length * row) read(Math.floor(py / row), Math.floor((px - left) / width * count));
  });
  svg.addEventListener("keydown", (event) => {
    const moves = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
    if (moves) { event.preventDefault(); read(at[0] + moves[0], at[1] + moves[1]); }
  });
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

// The frame in which the first driven node is driven hardest.
function tightest() {
  const driven = data.driven[0], last = shape.states.length - 1;
  const history = driven && data.history.find((one) => one.node === driven.node);
  if (!history || !history.columns[driven.reaction]) return last;
  const force = doubles(history.columns[driven.reaction]);
  let best = -1, state = 0;
  force.forEach((value, i) => { if (Math.abs(value) > best) { best = Math.abs(value); state = i + 1; } });
  let frame = last;
  for (let k = last; k >= 0; k--) if (Math.abs(shape.states[k] - state) <= Math.abs(shape.states[frame] - state)) frame = k;
  return frame;
}

const shape = new Shape();
const followed = reactions();
shape.moves = (state) => followed.forEach((chart) => chart.follow(state));
shape.go(tightest());
bands();
energies();
iterations();

// On paper nothing can be unfolded.
window.addEventListener("beforeprint", () => document.querySelectorAll("#warnings details").forEach((one) => { one.open = true; }));
