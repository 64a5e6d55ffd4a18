// Reads the numbers of the page.
const data = JSON.parse(document.getElementById("data").textContent);

function bytes(code) {
  const text = atob(code), out = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) out[i] = text.charCodeAt(i);
  return out.buffer;
}
const doubles = (code) => new Float64Array(bytes(code));
const singles = (code) => new Float32Array(bytes(code));
const columns = (object) => {
  const out = {};
  for (const name of Object.keys(object)) out[name] = doubles(object[name]);
  return out;
};

// A number for people, five digits unless said otherwise.
function show(value, digits) {
  if (!Number.isFinite(value)) return "-";
  if (value === 0) return "0";
  const size = Math.abs(value), n = digits || 5;
  const text = size >= 1e-3 && size < 1e6 ? String(Number(value.toPrecision(n))) : value.toExponential(n - 1).replace(/\.?0+e/, "e");
  return text.replace("-", "\u2212").replace("e+", "e").replace("e-", "e\u2212");
}

const NS = "http://www.w3.org/2000/svg";
function draw(parent, name, attributes, text) {
  const node = document.createElementNS(NS, name);
  for (const key of Object.keys(attributes || {})) node.setAttribute(key, attributes[key]);
  if (text !== undefined) node.textContent = text;
  if (parent) parent.appendChild(node);
  return node;
}
function make(parent, name, attributes, text) {
  const node = document.createElement(name);
  for (const key of Object.keys(attributes || {})) node.setAttribute(key, attributes[key]);
  if (text !== undefined) node.textContent = text;
  if (parent) parent.appendChild(node);
  return node;
}

const times = doubles(data.times), steps = doubles(data.step), increments = doubles(data.increment);
const where = (i) => i === 0 ? "start" : "step " + steps[i] + ", increment " + increments[i] + ", time " + show(times[i]);

// Slave points: a letter of status and friction at every increment; numbers at
// every stride-th, counted from the last.
const spread = (text) => text.replace(/([a-z])(\d+)/g, (_, letter, length) => letter.repeat(Number(length)));
const contact = data.contact.map((point) => Object.assign({}, point, {
  status: spread(point.status), friction: spread(point.friction), start: point.first + (times.length - 2 - point.first) % data.stride,
  p: singles(point.pressure), t: singles(point.shear), g: singles(point.opening), u: singles(point.slip), n: singles(point.angle)
}));
// Which of its numbers belong to the increment at `place` of the list, or stand nearest to it.
const nearest = (point, place) => Math.max(0, Math.min(point.p.length - 1, Math.round((place - point.start) / data.stride)));
const placed = (point, index) => point.start + index * data.stride;
