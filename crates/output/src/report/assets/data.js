// Reads the numbers of the page.
const data = JSON.parse(document.getElementById("data").textContent);

const times = doubles(data.times), steps = doubles(data.step), increments = doubles(data.increment);
const where = (i) => i === 0 ? "start" : "step " + steps[i] + ", increment " + increments[i] + ", time " + show(times[i]);

// Slave points: a letter of status and friction at every increment; numbers at
// every stride-th, counted from the last.
const contact = data.contact.map((point) => Object.assign({}, point, {
  status: spread(point.status), friction: spread(point.friction), start: point.first + (times.length - 2 - point.first) % data.stride, stride: data.stride,
  p: singles(point.pressure), t: singles(point.shear), g: singles(point.opening), u: singles(point.slip), n: singles(point.angle)
}));
const placed = (point, index) => point.start + index * point.stride;

// Where a driven node has gone after every increment.
const strokes = new Map();
function stroke(driven) {
  if (!strokes.has(driven)) {
    const history = data.history.find((one) => one.node === driven.node);
    strokes.set(driven, driven.travel ? doubles(driven.travel) : history && history.columns[driven.motion] ? doubles(history.columns[driven.motion]) : null);
  }
  return strokes.get(driven);
}
