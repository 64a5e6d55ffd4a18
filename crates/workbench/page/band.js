// The band of forces that given tolerances allow.
(function (W) {
  "use strict";
  W.band = null;
  let asked = null;
  const drop = () => {
    if (asked !== null) { W.forget(asked); asked = null; }
    if (W.band) { W.band = null; W.draw(); }
  };
  for (const name of ["values", "deck", "tolerances", "lost"]) W.on(name, drop);

  const look = () => {
    if (W.moving || W.busy() || asked !== null || W.band || !W.current() || !W.last.whole || !Object.keys(W.tolerances).length) return;
    const id = W.ask("band", { values: W.values, tolerances: W.tolerances }, (message) => {
      asked = null;
      const box = W.by("band-said");
      box.textContent = "";
      if (message.say === "band") {
        const s = W.last.sense(message.travel), turned = (list) => list.map((value) => s * value);
        const [low, high] = s > 0 ? [message.low, message.high] : [turned(message.high), turned(message.low)];
        if ((message.differences || []).length) box.textContent = "Slopes by " + message.differences.join(", ") + " are differences: there is no exact one.";
        W.band = { travel: turned(message.travel), low, high, share: message.share || "5 to 95 %" };
        W.draw();
      } else if (message.say === "refused") box.textContent = message.why;
      else if (message.say === "overtaken") setTimeout(look, 50);
      return true;
    });
    asked = id;
  };
  for (const name of ["idle", "settled", "tolerances"]) W.on(name, look);
})(window.Workbench = window.Workbench || {});
