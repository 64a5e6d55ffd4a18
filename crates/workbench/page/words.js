// Completion of keywords with Ctrl-Space, and the pages of keywords and codes with F1 or a resting pointer.
(function (W) {
  "use strict";
  let chosen = 0, words = [], rest = null;

  function close() {
    W.by("completions").hidden = true;
    words = [];
    if (W.text.area) { W.text.area.removeAttribute("aria-activedescendant"); }
  }

  function choose(k) {
    chosen = (k + words.length) % words.length;
    Array.from(W.by("completions").children).forEach((item, i) => item.setAttribute("aria-selected", String(i === chosen)));
    const list = W.by("completions"), own = list.children[chosen];
    list.scrollTop = Math.max(own.offsetTop + own.offsetHeight - list.clientHeight, Math.min(list.scrollTop, own.offsetTop));
    W.text.area.setAttribute("aria-activedescendant", own.id);
  }

  // Puts the word in the place of what is typed of it.
  function take(k) {
    const area = W.text.area, word = words[k].word, place = area.selectionStart;
    const line = area.value.slice(0, place).split("\n").pop();
    let typed = 0;
    for (let n = Math.min(word.length, line.length); n > 0; n--) if (line.slice(-n).toUpperCase() === word.slice(0, n).toUpperCase()) { typed = n; break; }
    close();
    area.focus();
    area.setSelectionRange(place - typed, place);
    // keeps the browser's own undo of the text
    if (!document.execCommand("insertText", false, word)) area.setRangeText(word, place - typed, place, "end");
    W.text.typed();
  }

  function complete() {
    const area = W.text.area, [line, column] = W.text.at(area.selectionStart);
    W.ask("complete", { line: area.value.split("\n")[line], column }, (message) => {
      close();
      if (message.say !== "completions" || !message.words.length) return true;
      words = message.words.slice(0, 60);
      const list = W.by("completions");
      list.textContent = "";
      words.forEach((one, k) => {
        const item = make(list, "li", { id: "word-" + k, role: "option" });
        make(item, "b", {}, one.word);
        if (one.about) make(item, "span", { class: "soft" }, " " + one.about);
        item.addEventListener("pointerdown", (event) => { event.preventDefault(); take(k); });
      });
      const [x, y] = W.text.pixel(line, column), room = list.parentNode.clientWidth;
      list.style.left = Math.max(0, Math.min(x, room - 260)) + "px";
      list.style.top = (y + W.text.line_height() + 2) + "px";
      list.hidden = false;
      choose(0);
      return true;
    });
  }

  // The keyword of a card, or the code, that stands at a place of the text.
  function word_at(line, column) {
    const text = W.text.area.value.split("\n")[line];
    if (text === undefined || column > text.length) return null;
    const code = (W.deck.diagnostics.find((one) => one.line === line + 1) || {}).code;
    const card = text.match(/^\s*\*([A-Za-z][^,]*)/);
    if (card && !text.startsWith("**")) return card[1].trim().toUpperCase();
    return code || null;
  }

  W.explain = (word, quiet) => {
    W.ask("explain", { word }, (message) => {
      if (message.say !== "page") { if (!quiet) page(word, null, message.why || "There is no page of this word."); return true; }
      page(word, message.html, null);
      return true;
    });
  };

  // A page of the documentation: its text, with nothing in it that acts.
  function page(word, html, why) {
    const box = W.by("page-text");
    box.textContent = "";
    W.by("page-title").textContent = word;
    if (why) make(box, "p", {}, why);
    else {
      const own = new DOMParser().parseFromString(html.replace(/ style="[^"]*"/g, ""), "text/html");
      own.querySelectorAll("script, style, link, iframe, object, embed, form, base, meta").forEach((node) => node.remove());
      own.querySelectorAll("*").forEach((node) => {
        for (const { name, value } of Array.from(node.attributes)) {
          if (name.startsWith("on") || name === "style" || name === "src" || name === "id" || name === "href" && !/^https?:/.test(value)) node.removeAttribute(name);
        }
        if (node.tagName === "A") { node.setAttribute("rel", "noopener"); node.setAttribute("target", "_blank"); }
      });
      box.append(...Array.from(own.body.childNodes, (node) => document.importNode(node, true)));
    }
    W.by("page").hidden = false;
    box.scrollTop = 0;
  }

  function key(event) {
    const open = words.length > 0;
    if (event.key === " " && event.ctrlKey) { event.preventDefault(); complete(); return; }
    if (event.key === "F1") {
      event.preventDefault();
      const word = word_at(...W.text.at(W.text.area.selectionStart));
      if (word) W.explain(word);
      return;
    }
    if (!open) return;
    const acts = { ArrowDown: () => choose(chosen + 1), ArrowUp: () => choose(chosen - 1), Enter: () => take(chosen), Tab: () => take(chosen), Escape: close };
    if (acts[event.key]) { event.preventDefault(); event.stopPropagation(); acts[event.key](); }
  }

  W.completion = {
    make() {
      const area = W.text.area;
      area.addEventListener("keydown", key);
      area.addEventListener("input", () => { if (words.length) { if (/[A-Za-z* -]$/.test(area.value.slice(0, area.selectionStart))) complete(); else close(); } });
      area.addEventListener("blur", close);
      area.addEventListener("click", close);
      area.addEventListener("pointermove", (event) => {
        clearTimeout(rest);
        if (event.pointerType === "touch") return;
        const [line, column] = W.text.under(event);
        rest = setTimeout(() => {
          const word = W.deck ? word_at(line, column) : null;
          const one = W.deck && W.deck.diagnostics.find((own) => own.line === line + 1);
          area.title = one ? one.code + ": " + one.message : "";
          if (word && word !== W.by("page-title").textContent) W.explain(word, true);
        }, 700);
      });
      area.addEventListener("pointerleave", () => clearTimeout(rest));
      W.by("page-close").addEventListener("click", () => { W.by("page").hidden = true; W.by("page-title").textContent = ""; });
    }
  };
})(window.Workbench = window.Workbench || {});
