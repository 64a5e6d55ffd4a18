// The solver of a page without a server: what a worker of it runs. The module is told a text with
// bench_open and bench_answer, each the address and length of bytes that bench_room gave, and says
// texts through say(address, length) of the module "page".
(function (W) {
  "use strict";
  W.bench_worker = function () {
    let bench = null;
    const told = (text) => {
      const own = new TextEncoder().encode(text), place = bench.bench_room(own.length);
      new Uint8Array(bench.memory.buffer, place, own.length).set(own);
      return [place, own.length];
    };
    const say = (place, length) => {
      self.postMessage({ say: new TextDecoder().decode(new Uint8Array(bench.memory.buffer, place, length)) });
      return 1;
    };
    self.onmessage = (event) => {
      if (typeof event.data === "string") {
        try { bench.bench_answer(...told(event.data)); } catch (error) { self.postMessage({ failed: String(error) }); }
        return;
      }
      WebAssembly.instantiate(event.data.module, { page: { say } }).then(({ instance }) => {
        bench = instance.exports;
        bench.bench_open(...told(event.data.opened));
        self.postMessage({ ready: true });
      }).catch((error) => self.postMessage({ failed: String(error) }));
    };
  };
})(window.Workbench = window.Workbench || {});
