// The way to the bench: a WebSocket to the program that serves the page, or a worker with the
// program as WebAssembly inside the page. The rest of the page does not know which.
(function (W) {
  "use strict";
  let number = 0, send = null;
  const waiting = new Map();

  // What came: an answer to a question that waits, or a word of a solve.
  function receive(text) {
    const message = JSON.parse(text), ask = waiting.get(message.id);
    if (ask) {
      const over = ask(message);
      if (over !== false) waiting.delete(message.id);
    }
  }

  // Asks, and calls `answer` with everything that is said to it until it returns something else
  // than false. Returns the number of the question.
  W.ask = (kind, what, answer) => {
    const id = ++number;
    if (answer) waiting.set(id, answer);
    if (send) send(JSON.stringify(Object.assign({ ask: kind, id }, what)));
    return id;
  };
  W.forget = (id) => waiting.delete(id);
  W.single = Boolean(W.by("module"));
  // Whether a newer solve ends an older one: a worker hears nothing while it computes.
  W.overtakes = !W.single;

  function lost(why) {
    send = null;
    waiting.clear();
    W.tell("lost", why);
  }

  function socket() {
    const place = new URL("socket", location.href);
    place.protocol = place.protocol === "https:" ? "wss:" : "ws:";
    place.hash = "";
    place.search = "";
    const line = new WebSocket(place.href);
    line.onopen = () => { send = (text) => line.send(text); W.tell("connected"); };
    line.onmessage = (event) => receive(event.data);
    line.onclose = () => lost("The program that computes has ended. Start it again with slideline workbench, and open the address it says.");
    window.addEventListener("pagehide", () => { line.onclose = null; line.close(); });
  }

  function worker() {
    const place = URL.createObjectURL(new Blob(["(" + W.bench_worker + ")();"], { type: "text/javascript" }));
    const own = new Worker(place);
    own.onmessage = (event) => {
      if (event.data.ready) { send = (message) => own.postMessage(message); W.tell("connected"); }
      else if (event.data.failed) lost("The solver inside this page does not start: " + event.data.failed);
      else receive(event.data.say);
    };
    own.onerror = (event) => { event.preventDefault(); lost("The solver inside this page has stopped: " + event.message); };
    own.postMessage({ module: bytes(W.by("module").textContent.trim()), opened: W.by("opened") ? W.by("opened").textContent.trim() : "null" });
    W.by("module").textContent = "";
  }

  W.connect = () => { if (W.single) worker(); else socket(); };
})(window.Workbench = window.Workbench || {});
