// The solver of a page without a server: what a worker of it runs. A message is written into the
// room that the module gives; answer() reads it, and says texts through bench.say.
(function (W) {
  "use strict";
  W.bench_worker = function () {
    let bench = null;
    const say = (place, length) => {
      // an empty text only asks whether to go on
      if (length) self.postMessage({ say: new TextDecoder().decode(new Uint8Array(bench.memory.buffer, place, length)) });
      return 1;
    };
    self.onmessage = (event) => {
      try {
        if (event.data.module) {
          bench = new WebAssembly.Instance(event.data.module, { bench: { say } }).exports;
          self.postMessage({ ready: true });
          return;
        }
        const own = new TextEncoder().encode(event.data.text), place = bench.room(own.length);
        new Uint8Array(bench.memory.buffer, place, own.length).set(own);
        bench.answer();
      } catch (error) {
        self.postMessage({ failed: String(error) });
      }
    };
  };
})(window.Workbench = window.Workbench || {});
