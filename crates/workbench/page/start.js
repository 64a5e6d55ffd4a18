// Without a deck: the kinds to start from, as pictures.
(function (W) {
  "use strict";
  W.choose = (kind) => {
    W.ask("new", { kind }, (message) => {
      if (message.say === "deck") {
        W.kind = kind;
        const own = W.pending;
        W.pending = null;
        W.start_deck(message, own);
      } else W.tell("refused", message.why || "This kind is not known.");
      return true;
    });
  };

  // A model as a small picture: bold lines and no legend, which nobody could read. It is changed as
  // a text: as a document it would be held against the page's own policy.
  const small = (text) => (text.includes("xmlns=") ? text : text.replace("<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\""))
    .replace(/<circle[^>]*\/>\s*<text[^>]*>[^<]*<\/text>/g, "")
    .replace(/<text[^>]*>[^<]*<\/text>/g, "")
    .replace(/stroke-width="([\d.]+)"/g, (_, width) => "stroke-width=\"" + 2.2 * Number(width) + "\"");

  W.start = (message) => {
    const list = W.by("kinds");
    list.textContent = "";
    document.body.classList.add("starting");
    W.by("start").hidden = false;
    for (const one of message.kinds) {
      const card = make(list, "button", { type: "button", class: "kind", "data-kind": one.kind });
      if (one.picture) make(card, "img", { alt: "", src: "data:image/svg+xml," + encodeURIComponent(small(one.picture)) });
      make(card, "b", {}, one.title);
      make(card, "span", {}, one.text);
      card.addEventListener("click", () => W.choose(one.kind));
    }
    const first = list.querySelector("button");
    if (first) first.focus();
  };
})(window.Workbench = window.Workbench || {});
