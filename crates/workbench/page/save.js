// Takes the state out of the page: a deck, a script, a report.
(function (W) {
  "use strict";
  const say = (text) => { W.by("saved").textContent = text; };

  function offer(name, text) {
    const types = { html: "text/html", py: "text/x-python" };
    const place = URL.createObjectURL(new Blob([text], { type: (types[name.split(".").pop()] || "text/plain") + ";charset=utf-8" }));
    const link = make(document.body, "a", { href: place, download: name });
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(place), 10000);
    say(name + " is saved.");
  }

  W.save = (what) => {
    const write = !W.single && W.by("write").checked;
    say("Saving \u2026");
    W.ask("save", Object.assign({ what, values: W.values }, write ? { write: true } : {}), (message) => {
      if (message.say === "file") offer(message.name, message.text);
      else if (message.say === "written") say("Written: " + message.path);
      else say(message.why || "It could not be saved.");
      return true;
    });
  };

  W.saving = () => {
    for (const what of ["deck", "python", "report"]) W.by("save-" + what).addEventListener("click", () => W.save(what));
    W.by("write-label").hidden = W.single;
    const menu = W.by("saves");
    document.addEventListener("pointerdown", (event) => { if (menu.open && !menu.contains(event.target)) menu.open = false; });
    menu.addEventListener("keydown", (event) => { if (event.key === "Escape") { menu.open = false; menu.querySelector("summary").focus(); } });
  };
})(window.Workbench = window.Workbench || {});
