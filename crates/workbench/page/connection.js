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

  // A worker hears nothing while it computes. What takes too long is ended with its worker, and
  // another one takes over, with the deck.
  let module = null, own = null;
  function spawn(begin) {
    const place = URL.createObjectURL(new Blob(["(" + W.bench_worker + ")();"], { type: "text/javascript" }));
    const mine = own = new Worker(place);
    const failed = (why) => { if (mine === own) lost("The solver inside this page has stopped: " + why); };
    own.onmessage = (event) => {
      if (mine !== own) return;
      if (event.data.ready) { URL.revokeObjectURL(place); send = (text) => mine.postMessage({ text }); begin(); }
      else if (event.data.failed) failed(event.data.failed);
      else receive(event.data.say);
    };
    own.onerror = (event) => { event.preventDefault(); failed(event.message); };
    own.postMessage({ module });
  }

  W.restart = () => {
    if (!W.single || !own) return;
    own.terminate();
    const before = Array.from(waiting);
    waiting.clear();
    const late = [];
    send = (text) => late.push(text);
    spawn(() => {
      W.ask("deck", { name: W.deck.name, text: W.deck.text }, () => true);
      late.forEach((text) => send(text));
    });
    before.forEach(([id, answer]) => answer({ say: "overtaken", id }));
  };

  // The module stands in the page as gzip in base64.
  function worker() {
    if (!window.DecompressionStream) { lost("This browser is too old for the solver inside this page. Browsers of 2023 and later have what it needs."); return; }
    const element = W.by("module"), packed = new Blob([bytes(element.textContent.trim())]);
    element.textContent = "";
    const code = new Response(packed.stream().pipeThrough(new DecompressionStream("gzip")), { headers: { "Content-Type": "application/wasm" } });
    WebAssembly.compileStreaming(code).then((made) => {
      module = made;
      spawn(() => W.tell("connected"));
    }).catch((error) => lost("The solver inside this page does not start: " + error));
  }

  // The deck that a single page carries, if any.
  W.carried = () => {
    const element = W.by("opened");
    return element ? JSON.parse(element.textContent) : null;
  };

  W.connect = () => { if (W.single) worker(); else socket(); };
})(window.Workbench = window.Workbench || {});
