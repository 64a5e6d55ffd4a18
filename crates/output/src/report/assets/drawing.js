// What every drawing needs: numbers out of base64, numbers for people, elements of the page.
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

// Calls `redraw` with the width there is, now and whenever it changes: what is
// drawn keeps the size of its letters on every screen.
function fitted(element, redraw) {
  let last = 0;
  const look = () => {
    const width = Math.round(element.clientWidth);
    if (width > 0 && width !== last) { last = width; redraw(width); }
  };
  look();
  if (!last) redraw(last = 900);
  if (window.ResizeObserver) new ResizeObserver(look).observe(element);
  else window.addEventListener("resize", look);
}

function niceStep(span, count) {
  const raw = span / count, power = Math.pow(10, Math.floor(Math.log10(raw)));
  const lead = raw / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}

// A run of letters, as "s12t3" shortens it.
const spread = (text) => text.replace(/([a-z])(\d+)/g, (_, letter, length) => letter.repeat(Number(length)));

// Which numbers of a slave point belong to the increment at `place` of the list, or stand nearest to it.
const nearest = (point, place) => Math.max(0, Math.min(point.p.length - 1, Math.round((place - point.start) / point.stride)));
