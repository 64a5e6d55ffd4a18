"""Drives the page of the workbench: standard library only.

    workbench.py PROGRAM PICTURES [--single] [--idle] [--minutes N | --hour]

Serves a copy of a deck with PROGRAM, opens its page in Chromium, acts on it
with the events of a mouse and a keyboard, and fails on anything that does not
do what it should and on any console error.
"""

import csv
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from chromium import Browser
from served import HOST, Served, drag_slider, rows, settled, value
from workbench_times import dragging_at_random, measuring
from workbench_troubles import impossible, losing, stopping


def same_as_the_command(browser, program, folder, tolerance):
    """The deck that is saved gives the same curve from the command line."""
    text = browser.evaluate("new Promise((done) => Workbench.ask('save', { what: 'deck', values: Workbench.values }, (m) => { done(m.text); return true; }))", wait=True)
    deck = folder / "saved" / "state.inp"
    deck.parent.mkdir(exist_ok=True)
    deck.write_text(text)
    done = subprocess.run([program, "run", deck, "--quiet"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    curve = browser.evaluate("Workbench.last.curves[Workbench.last.curve]")
    place = browser.evaluate("Workbench.last.curve")
    with open(deck.with_suffix(".history.csv"), newline="") as file:
        own = [row for row in csv.DictReader(file) if int(row["node"]) == curve["node"]]
    page = [row for row in rows(browser) if row[2] > 0]
    assert len(own) == len(page), f"{len(own)} rows of the command, {len(page)} of the page"
    largest = max(abs(float(row[curve["reaction"]])) for row in own)
    worst = 0.0
    for a, b in zip(own, page):
        for name, number in ((curve["motion"], b[3 + 2 * place]), (curve["reaction"], b[4 + 2 * place])):
            worst = max(worst, abs(float(a[name]) - number))
    assert worst <= tolerance * largest, f"the command differs by {worst} of {largest}"


def dragging(browser):
    """A hand on a slider: the curve follows, and is never shown as current where it is not."""
    settled(browser)
    before, curve = value(browser, "thickness"), rows(browser)
    browser.evaluate("""(() => {
      window.seen = { points: 0, ends: 0, wrong: 0 };
      Workbench.on('points', () => seen.points++);
      Workbench.on('end', () => seen.ends++);
      Workbench.on('painted', () => {
        const current = document.getElementById('chart').dataset.current === 'true', run = Workbench.shown;
        if (current && !(run.end && Workbench.same(run.values, Workbench.values))) seen.wrong++;
        if (document.getElementById('verdict').classList.contains('green') && !current) seen.wrong++;
      });
    })()""")
    drag_slider(browser, "thickness", 0.6)
    settled(browser)
    seen, after = browser.evaluate("seen"), value(browser, "thickness")
    assert after != before, f"the slider stands at {before}"
    assert rows(browser) != curve, "the curve stands still"
    assert seen["points"] > 2 and seen["ends"] > 0 and seen["wrong"] == 0, seen
    assert browser.evaluate("Workbench.ghost !== null"), "no ghost of the curve before"
    assert browser.evaluate("document.getElementById('lines').textContent").count("before") == 1
    browser.key("ArrowRight")
    settled(browser)
    assert value(browser, "thickness") > after, "the slider does not hear the keyboard"


def scrubbing(browser):
    """Shape and curve are moved together."""
    x, y, width, height = browser.place("#curve")
    place = "Workbench.chart.at()"
    browser.mouse("mousePressed", x + 0.3 * width, y + height / 2, True)
    browser.mouse("mouseReleased", x + 0.3 * width, y + height / 2)
    first, beam = browser.evaluate(place), browser.evaluate("document.querySelector('path.beam').getAttribute('d')")
    picture = browser.evaluate("document.getElementById('curve').toDataURL()")
    browser.evaluate("document.getElementById('curve').focus()")
    for _ in range(5):
        browser.key("ArrowRight")
    browser.until(f"{place} === {first + 5}")
    assert browser.evaluate("document.querySelector('path.beam').getAttribute('d')") != beam, "the shape stands still"
    assert browser.evaluate("Number(document.getElementById('frame').value)") == first + 5
    browser.until(f"document.getElementById('curve').toDataURL() !== {picture!r}")
    assert "force" in browser.evaluate("document.getElementById('readoff').textContent")


def solving_for(browser):
    """A typed force, and a peak that is dragged: the chosen parameter follows."""
    settled(browser)
    force = browser.evaluate("Workbench.last.figure('push_in')")
    before = value(browser, "thickness")
    browser.evaluate("document.getElementById('aim-parameter').value = 'thickness'; document.getElementById('aim-parameter').dispatchEvent(new Event('change'))")
    browser.click(".figure[data-response=push_in] button")
    browser.evaluate("document.getElementById('aim-wanted').select()")
    wanted = float(f"{1.2 * force:.4g}")
    browser.call("Input.insertText", text=str(wanted))
    browser.key("Enter")
    browser.until(f"Workbench.values.thickness !== {before}", 30)
    settled(browser)
    reached = browser.evaluate("Workbench.last.figure('push_in')")
    assert abs(reached - wanted) <= 1e-3 * wanted, f"{reached} instead of {wanted}"
    assert "gives" in browser.evaluate("document.getElementById('aim-said').textContent")
    thicker = value(browser, "thickness")
    x, y, width, height = browser.evaluate("(() => { const r = document.querySelector('.handle.push').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()")
    browser.drag([x + 9, y + height / 2], [x + 9, y + height / 2 + 25])
    browser.until(f"Workbench.values.thickness < {thicker}", 30)
    settled(browser)
    assert browser.evaluate("Workbench.last.figure('push_in')") < reached, "the dragged peak does not come down"


def pinning(browser):
    settled(browser)
    browser.click("#pin")
    assert browser.evaluate("document.querySelectorAll('#pins li').length") == 1
    kept = value(browser, "overlap")
    drag_slider(browser, "overlap", 0.45)
    settled(browser)
    moved = value(browser, "overlap")
    assert moved != kept
    browser.click("#undo")
    browser.until(f"Workbench.values.overlap === {kept}")
    browser.click("#redo")
    browser.until(f"Workbench.values.overlap === {moved}")
    control(browser, "z")
    browser.until(f"Workbench.values.overlap === {kept}")
    settled(browser)
    browser.until("document.getElementById('lines').textContent.includes('pin 1')")


def control(browser, name):
    for kind in ("rawKeyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=kind, key=name, code="Space" if name == " " else "", modifiers=2, windowsVirtualKeyCode=32 if name == " " else ord(name.upper()))


def tolerances(browser):
    field = ".parameter[data-name=thickness] .tolerance input"
    browser.click(field)
    browser.call("Input.insertText", text="5")
    browser.key("Enter")
    browser.until("Workbench.band !== null", 60)
    assert browser.evaluate("Workbench.band.low.length > 1 && Workbench.band.low.every((low, i) => low <= Workbench.band.high[i])")
    browser.until("document.getElementById('lines').textContent.includes('tolerances')")


def locking(browser):
    """A locked parameter moves for nobody; a peak hears the arrow keys."""
    row = ".parameter[data-name=thickness]"
    before = value(browser, "thickness")
    browser.evaluate("document.querySelector('.handle.push').focus()")
    browser.key("ArrowUp")
    browser.until(f"Workbench.values.thickness > {before}", 30)
    settled(browser)
    before = value(browser, "thickness")
    browser.click(row + " .tools button:last-child")
    assert browser.evaluate(f"document.querySelector('{row} input[type=range]').disabled")
    browser.evaluate("document.querySelector('.handle.push').focus()")
    browser.key("ArrowUp")
    browser.until("document.getElementById('aim-said').textContent.includes('locked')")
    assert value(browser, "thickness") == before, "a locked parameter has moved"
    browser.click(row + " .tools button:last-child")
    assert not browser.evaluate(f"document.querySelector('{row} input[type=range]').disabled")


def named(browser):
    """Whatever can be acted on has a name for who does not see it."""
    tree = browser.call("Accessibility.getFullAXTree")["nodes"]
    roles = {"button", "slider", "spinbutton", "textbox", "combobox", "checkbox", "tab", "listbox", "img"}
    nameless = []
    for node in tree:
        role = node.get("role", {}).get("value")
        if role in roles and not node.get("ignored") and not node.get("name", {}).get("value", "").strip():
            nameless.append(browser.call("DOM.describeNode", backendNodeId=node["backendDOMNodeId"])["node"].get("attributes"))
    assert not nameless, f"without a name: {nameless[:5]}"
    browser.until("document.getElementById('heard').textContent.startsWith(document.getElementById('verdict-title').textContent)")


def editing(browser, pictures):
    """An error is underlined and named; nothing is current until it is mended."""
    settled(browser)
    browser.click("#tab-deck")
    text = browser.evaluate("document.getElementById('text').value")
    place = text.index("*MATERIAL")
    browser.evaluate(f"(() => {{ const a = document.getElementById('text'); a.focus(); a.setSelectionRange({place}, {place + 9}); }})()")
    browser.call("Input.insertText", text="*MATERIEL")
    browser.until("document.querySelector('#marks mark.error') !== null")
    browser.until("document.getElementById('verdict').classList.contains('red')")
    assert browser.evaluate("document.getElementById('chart').dataset.current") == "false", "a stale curve is current"
    assert "SL" in browser.evaluate("document.querySelector('.problem.error').textContent")
    browser.picture(pictures / "error.png")
    moved = value(browser, "thickness")
    assert moved != 1.5, "the slider stands where the deck has it: nothing is shown by its staying"
    # the keyword is typed again and completed
    browser.evaluate(f"document.getElementById('text').setSelectionRange({place}, {place + 9})")
    browser.call("Input.insertText", text="*MATER")
    control(browser, " ")
    browser.until("!document.getElementById('completions').hidden")
    words = browser.evaluate("Array.from(document.querySelectorAll('#completions b'), (b) => b.textContent)")
    assert words and all("MATER" in word.upper() for word in words), words
    browser.key("Enter")
    browser.until("Workbench.deck.sound")
    assert browser.evaluate("document.getElementById('text').value") == text, "the completed text is another one"
    assert browser.evaluate("document.getElementById('completions').hidden"), "completion goes on"
    assert value(browser, "thickness") == moved, "an error has moved a slider"
    settled(browser)
    browser.evaluate("document.getElementById('text').focus()")
    browser.key("F1")
    browser.until("!document.getElementById('page').hidden")
    assert "MATERIAL" in browser.evaluate("document.getElementById('page').textContent").upper()
    browser.picture(pictures / "deck.png")
    # a resting pointer explains the keyword under it
    browser.click("#page-close")
    browser.evaluate("document.getElementById('text').scrollTop = 0")
    x, y, width, height = browser.place("#text")
    browser.mouse("mouseMoved", x + 40, y + 14)
    browser.until(f"document.getElementById('page-title').textContent === {text.splitlines()[0].lstrip('*')!r}")
    # a value that is edited moves its slider
    place = text.index("thickness = ") + len("thickness = ")
    browser.evaluate(f"(() => {{ const a = document.getElementById('text'); a.focus(); a.setSelectionRange({place}, {place + 3}); }})()")
    browser.call("Input.insertText", text="1.7")
    browser.until("Workbench.deck.parameters.find((one) => one.name === 'thickness').value === 1.7")
    browser.until("Workbench.values.thickness === 1.7")
    settled(browser)
    browser.click("#tab-sliders")


def saving(browser, program, folder):
    down = folder / "down"
    down.mkdir(exist_ok=True)
    browser.call("Page.setDownloadBehavior", behavior="allow", downloadPath=str(down))
    for what, ending in (("deck", ".inp"), ("python", ".py"), ("report", ".html")):
        browser.evaluate("document.getElementById('saves').open = true")
        browser.click("#save-" + what)
        deadline = time.time() + 60
        while not any(one.suffix == ending for one in down.iterdir()):
            assert time.time() < deadline, f"no {ending}: {browser.evaluate('document.getElementById(`saved`).textContent')}"
            time.sleep(0.05)
    browser.evaluate("document.getElementById('saves').open = false")
    deck = next(one for one in down.iterdir() if one.suffix == ".inp")
    done = subprocess.run([program, "check", deck], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def coming_back(browser):
    """The address alone brings the state back."""
    settled(browser)
    time.sleep(0.6)
    address = browser.evaluate("location.href")
    before = browser.evaluate("[Workbench.values, Workbench.pins.map((pin) => pin.values), Workbench.tolerances, Workbench.deck.text]")
    curve = rows(browser)
    faults = browser.faults()
    assert not faults, faults
    browser.go("about:blank")
    browser.go(address)
    browser.until("window.Workbench && Workbench.deck && Workbench.last !== null", 30)
    settled(browser)
    after = browser.evaluate("[Workbench.values, Workbench.pins.map((pin) => pin.values), Workbench.tolerances, Workbench.deck.text]")
    assert after == before, f"{before}\nbecame\n{after}"
    assert rows(browser) == curve, "the curve is another one"
    browser.until("Workbench.pins.every((pin) => pin.run)", 30)


def looks(browser, pictures, name):
    settled(browser)
    browser.size(1440, 900)
    time.sleep(0.3)
    browser.picture(pictures / f"{name}.png")
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    time.sleep(0.3)
    browser.picture(pictures / f"{name}-dark.png")
    browser.call("Emulation.setEmulatedMedia", features=[])
    browser.size(390, 844)
    time.sleep(0.4)
    width = browser.evaluate("document.documentElement.scrollWidth")
    assert width <= 390, f"a phone is {width} wide"
    browser.picture(pictures / f"{name}-phone.png")
    drag_slider(browser, "thickness", 0.4)
    settled(browser)
    top = browser.evaluate("document.getElementById('chart').getBoundingClientRect().top")
    assert -1 <= top < 844, "the curve is out of sight while its slider moves"
    browser.size(1200, 900)
    time.sleep(0.2)


def starting(browser, program, folder, pictures):
    """Without a deck there are kinds to start from."""
    served = Served(program, folder=folder)
    try:
        browser.go(served.address)
        browser.until("document.querySelectorAll('.kind').length >= 5")
        browser.until("Array.from(document.querySelectorAll('.kind img')).every((one) => one.complete && one.naturalWidth > 0)")
        browser.size(1440, 900)
        browser.picture(pictures / "start.png")
        browser.size(390, 844)
        assert browser.evaluate("document.documentElement.scrollWidth") <= 390
        browser.picture(pictures / "start-phone.png")
        browser.size(1440, 900)
        kinds = browser.evaluate("Array.from(document.querySelectorAll('.kind'), (one) => one.dataset.kind)")
        for kind in kinds:
            browser.evaluate("history.replaceState(null, '', location.pathname)")
            browser.go(browser.evaluate("location.href.split('#')[0]"))
            browser.until(f"document.querySelector('.kind[data-kind={kind}]') !== null")
            browser.click(f".kind[data-kind={kind}]")
            browser.until("window.Workbench && Workbench.deck && Workbench.last !== null", 60)
            settled(browser)
            time.sleep(0.3)
            browser.picture(pictures / f"kind-{kind}.png")
            assert not browser.faults(), f"{kind}: {browser.faults()}"
            print(f"workbench: {kind}: {browser.evaluate('Workbench.last.rows')} increments in {browser.evaluate('Workbench.last.took'):.0f} ms, {browser.evaluate('document.getElementById(`verdict-title`).textContent')}")
    finally:
        served.close()


def found(browser, program, folder, pictures):
    """Decks without parameters: what is found in them is dragged, saved and found again; one that loads drive."""
    for name, deck, slider, moved in [("found", "corpus/tutorial/snap_fit.inp", "angle", 0.7), ("loaded", "corpus/keywords/CLOAD.inp", "load", 0.8)]:
        own = folder / name
        own.mkdir()
        shutil.copy(deck, own)
        served = Served(program, own / Path(deck).name, folder=own)
        try:
            browser.go(served.address)
            browser.until("window.Workbench && Workbench.deck && Workbench.last !== null", 60)
            settled(browser)
            before, curve = value(browser, slider), rows(browser)
            drag_slider(browser, slider, moved)
            settled(browser)
            assert value(browser, slider) != before and rows(browser) != curve, f"{slider} moves nothing"
            assert browser.evaluate("Workbench.last.force.some((own) => own !== 0)"), "there is no curve"
            if name == "found":
                same_as_the_command(browser, program, own, 0.0)
            browser.size(1440, 900)
            browser.picture(pictures / f"{name}.png")
            there = value(browser, slider)
            browser.click("#undo")
            settled(browser)
            assert value(browser, slider) == before and rows(browser) == curve, "undo leaves something"
            browser.click("#redo")
            settled(browser)
            assert value(browser, slider) == there
            # what is no number changes nothing
            browser.evaluate(f"(() => {{ const field = document.getElementById('value-{slider}'); field.value = ''; field.dispatchEvent(new Event('input')); field.dispatchEvent(new Event('change')); }})()")
            assert value(browser, slider) == there
            assert not browser.faults(), f"{name}: {browser.faults()}"
        finally:
            served.close()
    print("workbench: what is found in a deck without parameters is dragged, saved with the same bits and undone")


def drive(browser, program, folder, pictures, name, tolerance, idle):
    browser.until("window.Workbench && Workbench.deck && Workbench.last !== null", 60)
    settled(browser)
    assert browser.evaluate("document.getElementById('verdict').textContent.trim().length") > 5
    measuring(browser, idle)
    dragging(browser)
    same_as_the_command(browser, program, folder, tolerance)
    scrubbing(browser)
    solving_for(browser)
    pinning(browser)
    tolerances(browser)
    locking(browser)
    stopping(browser)
    impossible(browser)
    named(browser)
    looks(browser, pictures, name)
    editing(browser, pictures)
    same_as_the_command(browser, program, folder, tolerance)
    saving(browser, program, folder)
    coming_back(browser)
    assert not browser.faults(), browser.faults()
    print(f"workbench: {name}: drags, solves for, pins, edits, saves and comes back; no console error")


def main():
    program, pictures, *options = sys.argv[1:]
    program, pictures = str(Path(program).resolve()), Path(pictures)
    pictures.mkdir(parents=True, exist_ok=True)
    minutes = 60.0 if "--hour" in options else float(options[options.index("--minutes") + 1]) if "--minutes" in options else None
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        folder = Path(place)
        deck = folder / "snap_fit.inp"
        shutil.copy("corpus/new/snap_fit.inp", deck)
        served = Served(program, deck, folder=folder)
        browser = Browser(folder / "profile", HOST)
        try:
            browser.go(served.address)
            if minutes is not None:
                browser.until("window.Workbench && Workbench.deck && Workbench.last !== null", 60)
                dragging_at_random(browser, served, minutes)
                return
            drive(browser, program, folder, pictures, "served", 0.0, "--idle" in options)
            losing(browser, served)
            starting(browser, program, folder, pictures)
            found(browser, program, folder, pictures)
        finally:
            browser.close()
            served.close()
        if "--single" in options:
            alone(program, folder, deck, pictures, "--idle" in options)


def alone(program, folder, deck, pictures, idle):
    """The page as one file, from disk, with the network off."""
    page = folder / "page.html"
    done = subprocess.run([program, "workbench", deck, "-o", page], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    print(f"workbench: the single page has {page.stat().st_size / 1e6:.2f} MB")
    browser = Browser(folder / "profile-of-one")
    try:
        browser.open(page)
        drive(browser, program, folder, pictures, "single", 1e-9, idle)
    finally:
        browser.close()


main()
