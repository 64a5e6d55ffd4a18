"""Drives headless Chromium (chromium.py): standard library only.

    browser.py PROGRAM PICTURES

Makes reports with PROGRAM, opens each from disk with the network off, acts on
it with the events of a mouse and a keyboard, and fails on anything that does
not do what it should, on any console error and on any request for a network.
"""

import base64
import csv
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from chromium import Browser


def run(program, *arguments, code=0):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == code, f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done


def history(path, node):
    with open(path, newline="") as file:
        return [row for row in csv.DictReader(file) if int(row["node"]) == node]


def number(text):
    return float(text.replace("\u2212", "-"))


def animation(browser):
    """Plays to the end, then drags the slider."""
    last = browser.evaluate("Number(document.getElementById('frame').max)")
    assert last >= 1, "there is nothing to play"
    value = "Number(document.getElementById('frame').value)"
    beam = "document.querySelector('path.beam').getAttribute('d')"
    browser.click("#play")
    browser.until("document.getElementById('play').textContent === 'Pause'")
    browser.until(f"{value} > 0 && {value} < {last}")
    browser.click("#play")
    browser.until("document.getElementById('play').textContent === 'Play'")
    stopped = browser.evaluate(value)
    time.sleep(0.3)
    assert browser.evaluate(value) == stopped, "it plays on after Pause"
    browser.click("#play")
    browser.until(f"{value} === {last} && document.getElementById('play').textContent === 'Play'", 30)
    at_end = browser.evaluate(beam)
    x, y, width, height = browser.place("#frame")
    browser.drag([x + width - 9, y + height / 2], [x + width / 2, y + height / 2])
    dragged = browser.evaluate(value)
    assert 0.3 * last < dragged < 0.7 * last, f"dragged to {dragged} of {last}"
    assert browser.evaluate(beam) != at_end, "the shape stands still"
    assert "increment" in browser.evaluate("document.getElementById('state').textContent")
    browser.evaluate("document.getElementById('frame').focus()")
    browser.key("ArrowRight")
    assert browser.evaluate(value) == dragged + 1, "the slider does not hear the keyboard"
    browser.key("End")


def reading(browser, chart, rows, motion, reaction):
    """Reads values off by keyboard and by pointer, zooms in and out."""
    off = f"document.querySelector('#{chart} .readoff').textContent"
    browser.place(f"#{chart} svg")
    browser.evaluate(f"document.querySelector('#{chart} svg').focus()")
    browser.key("End")
    said = browser.evaluate(off)
    values = [number(said.split(f"{name} = ")[1].split(",")[0].split(" ")[0]) for name in (motion, reaction)]
    expected = [float(rows[-1][name]) for name in (motion, reaction)]
    for found, wanted in zip(values, expected):
        assert abs(found - wanted) <= 1e-6 * max(abs(wanted), 1e-30), f"{said}: {expected}"
    browser.key("ArrowLeft")
    assert browser.evaluate(off) != said, "the arrow keys read nothing off"
    x, y, width, height = browser.place(f"#{chart} svg")
    browser.mouse("mouseMoved", x + 0.3 * width, y + 0.3 * height)
    hovered = browser.evaluate(off)
    assert f"{motion} = " in hovered, hovered
    ticks = f"Array.from(document.querySelectorAll('#{chart} svg text'), (t) => t.textContent).join('|')"
    whole = browser.evaluate(ticks)
    browser.drag([x + 0.2 * width, y + 0.2 * height], [x + 0.6 * width, y + 0.8 * height])
    zoomed = browser.evaluate(ticks)
    assert zoomed != whole, "dragging does not zoom"
    browser.evaluate(f"document.querySelector('#{chart} svg').focus()")
    browser.key("0")
    assert browser.evaluate(ticks) == whole, "0 does not show the whole"


def looks(browser, pictures, name):
    colours = []
    for scheme in ("light", "dark"):
        browser.call("Emulation.setEmulatedMedia", media="screen", features=[{"name": "prefers-color-scheme", "value": scheme}])
        colours.append(browser.evaluate("getComputedStyle(document.body).backgroundColor"))
        browser.picture(pictures / f"{name}-{scheme}.png")
    assert colours[0] != colours[1], "light and dark are the same"
    # on paper it is light whatever the screen is
    browser.call("Emulation.setEmulatedMedia", media="print", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    assert browser.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    browser.size(700, 900)
    browser.picture(pictures / f"{name}-print.png")
    pages = browser.call("Page.printToPDF", printBackground=True)["data"]
    (pictures / f"{name}.pdf").write_bytes(base64.b64decode(pages))
    browser.call("Emulation.setEmulatedMedia", media="screen", features=[])
    browser.size(390, 844)
    overflow = browser.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert overflow <= 0, f"a narrow screen must not scroll sideways: {overflow}"
    browser.size(1200, 900)


def strange_deck(folder):
    """A deck whose names and texts try to leave their places."""
    text = Path("corpus/diehl1995/isl_coarse.inp").read_text()
    heading = "</script><script>window.injected = 1</script><img src=x onerror=\"window.injected=2\"> {{job}} \u0444\u6f22"
    text = text.replace("*HEADING\n", f"*HEADING\n{heading}\n", 1)
    # the name of the pair stands in legends and bands, the title in the echo
    name = "\"</SCRIPT><IMG/SRC=X/ONERROR=WINDOW.INJECTED=3>\u0436\""
    text = text.replace("ELSET=ISL", f"ELSET={name}")
    text = text.replace("MOVE BEARING", "</title><script>window.injected = 4</script> MOVE BEARING")
    path = folder / "a 'q' \"p\" <b>&amp; \u0436\u6f22.inp"
    path.write_text(text)
    return path


def thinned_deck(folder, every):
    """A deck that asks for fewer states than increments."""
    text = Path("corpus/diehl1995/isl_coarse_mu03.inp").read_text()
    path = folder / f"every_{every}.inp"
    path.write_text(text.replace("*END STEP", f"*OUTPUT, FIELD, FREQUENCY={every}\n*END STEP"))
    return path


def many_increments(folder):
    text = Path("corpus/diehl1995/isl_coarse_mu03.inp").read_text()
    text = text.replace("0.05, 1.0, 1.0E-6, 0.05", "0.001, 1.0, 1.0E-6, 0.001").replace("INC=100", "INC=2000")
    path = folder / "many.inp"
    path.write_text(text)
    return path


def error_bars(browser, program, folder, pictures):
    """The band of the error bars: drawn at its true width, read off, switched
    off and on; and where the mesh cannot be halved, the warning in its place."""
    run(program, "run", "corpus/diehl1995/irs_coarse.inp", "--error-bars", "--out", folder, "--quiet", "--no-html")
    run(program, "report", folder / "irs_coarse")
    browser.open(folder / "irs_coarse.html")
    rows = history(folder / "irs_coarse.history.csv", 9999)
    chart, band = "chart-9999-U2", "document.querySelector('#chart-9999-U2 path.error')"
    browser.place(f"#{chart} svg")
    browser.evaluate(f"document.querySelector('#{chart} svg').focus()")
    browser.key("End")
    said = browser.evaluate(f"document.querySelector('#{chart} .readoff').textContent")
    force, bar, time = [number(part.split(" ")[0]) for part in said.split("RF2 = ")[1].split(" \u00b1 ")]
    assert abs(force - float(rows[-1]["RF2"])) <= 1e-6 * abs(force), said
    for shown, column in [(bar, "RF2_error"), (time, "RF2_time_error")]:
        assert abs(shown - float(rows[-1][column])) <= 5e-3 * shown, f"{said}: {rows[-1][column]}"
    # upper edge forwards, lower edge back: their distance in the last increment
    # is to twice the bar as the height of the curve is to the force; a push
    # down is drawn upwards
    edge = browser.evaluate(f"{band}.getAttribute('d')").strip("MZ").split("L")
    assert len(edge) == 2 * (len(rows) + 1), f"{len(edge)} points for {len(rows)} increments"
    y = [float(point.split(" ")[1]) for point in edge]
    mark = browser.evaluate(f"Number(document.querySelector('#{chart} circle.mark').getAttribute('cy'))")
    middle = len(rows) + 1
    drawn, expected = (y[middle] - y[middle - 1]) / (mark - y[0]), 2 * bar / force
    assert abs(drawn / expected - 1) < 0.02, f"drawn {drawn}, expected {expected}"
    legend = f"Array.from(document.querySelectorAll('#{chart} .entry')).find((e) => e.textContent.startsWith('error bars'))"
    assert "% of the peak" in browser.evaluate(f"{legend}.textContent")
    browser.picture(pictures / "error-bars.png")
    count = f"document.querySelectorAll('#{chart} path.error').length"
    assert browser.evaluate(count) == 2, "a band of the mesh and one of the increments"
    browser.evaluate(f"{legend}.click()")
    assert browser.evaluate(count) == 1, "the band cannot be switched off"
    browser.evaluate(f"{legend}.click()")
    assert not browser.faults(), browser.faults()
    run(program, "run", "corpus/tutorial/snap_fit.inp", "--error-bars", "--out", folder, "--quiet")
    browser.open(folder / "snap_fit.html")
    assert "SL0602" in browser.evaluate("document.getElementById('warnings').textContent")
    # no band of the mesh, whose halves are not known; that of the increments is there
    assert browser.evaluate("document.querySelectorAll('path.error').length") == 1
    assert not browser.faults(), browser.faults()


def snap_fit(browser, program, folder, pictures):
    """What a designer looks for: colour, big numbers, clamp, arrow, peaks at
    their own states, and charts that are as wide as the screen."""
    run(program, "run", "corpus/tutorial/snap_fit.inp", "--out", folder, "--quiet")
    browser.open(folder / "snap_fit.html")
    assert browser.evaluate("document.getElementById('verdict').className") == "verdict green"
    tiles = browser.evaluate("document.querySelector('.tiles').textContent")
    assert all(name in tiles for name in ("push-in force", "pull-out force", "out / in", "work in", "normal force", "strain")), tiles
    assert browser.evaluate("document.querySelectorAll('#stage .held path').length") == 1, "one clamp"
    for place, (button, way) in enumerate((("push", "in"), ("pull", "out"))):
        browser.click(f"#peaks button:nth-child({place + 1})")
        assert browser.evaluate(f"document.querySelectorAll('#stage .motion path.{way}').length") == 1, f"no arrow {way}"
        peak = browser.evaluate(f"document.querySelectorAll('#chart-100-U1 .peakmark')[{place}].getAttribute('cx')")
        now = browser.evaluate("document.querySelector('#chart-100-U1 .now').getAttribute('cx')")
        assert peak == now, f"the {button} peak stands at {peak}, its state at {now}"
    widths = []
    for width in (1200, 390):
        browser.size(width, 844)
        browser.until(f"Math.abs(document.querySelector('#chart-100-U1 svg').viewBox.baseVal.width - document.querySelector('#chart-100-U1 svg').clientWidth) < 4")
        widths.append(browser.evaluate("document.querySelector('#stage svg').viewBox.baseVal.width"))
    assert widths[0] > 2 * widths[1], f"shrunk, not drawn anew: {widths}"
    browser.picture(pictures / "snap_fit-phone.png")
    browser.size(1200, 900)
    assert not browser.faults(), browser.faults()


def many_points(folder, elements, increments):
    """Every node of a beam stays closed on a plane that slides along it."""
    path = folder / "points.inp"
    path.write_text(f"""*NODE, NSET=BEAM
1, 0.0, 0.0
{elements + 1}, 1.0, 0.0
*NGEN, NSET=BEAM
1, {elements + 1}, 1
*ELEMENT, TYPE=B21, ELSET=BEAM
1, 1, 2
*ELGEN, ELSET=BEAM
1, {elements}, 1, 1
*BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M
25.0E-3, 1.5E-3
*MATERIAL, NAME=M
*ELASTIC
6.9E9, 0.3
*NODE
9999, 0.5, -0.1
*SURFACE, NAME=PLANE, TYPE=SEGMENTS
START, -1.0, 0.0
LINE, 2.0, 0.0
*RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=PLANE
*SURFACE, NAME=BEAM, TYPE=ELEMENT
BEAM, SNEG
*SURFACE INTERACTION, NAME=S
25.0E-3
*FRICTION
0.3
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1.0E9
*CONTACT PAIR, INTERACTION=S, TYPE=NODE TO SURFACE, NO THICKNESS
BEAM, PLANE
*STEP, NLGEOM, INC=2000
SLIDE
*STATIC, DIRECT
{1 / increments}, 1.0
*BOUNDARY
1, 1, 6
BEAM, 1, 2
9999, 6
9999, 1, 1, 0.3
9999, 2, 2, 1.0E-5
*END STEP
""")
    return path


def thinned(browser, program, folder, pictures):
    """Many points over many increments: numbers are thinned and say where they
    are from, statuses and curves are whole, forces are drawn in every frame."""
    increments = 400
    deck = many_points(folder, 200, increments)
    run(program, "run", deck, "--quiet")
    page = deck.with_suffix(".html")
    assert page.stat().st_size <= 1_500_000, f"{page.stat().st_size} bytes"
    browser.open(page)
    legend = browser.evaluate("document.querySelector('#bands .legend').textContent")
    assert "at one increment in 4" in legend, legend
    points = browser.evaluate("document.querySelector('#chart-9999-U1 path.curve').getAttribute('d').split('L').length")
    assert points == increments + 1, f"a curve of {points} points"
    assert browser.evaluate("document.querySelectorAll('#pairs svg .pressure').length") == 1, "one band a pair"
    assert browser.evaluate("document.querySelector('#nodes svg')") is None, "nodes are drawn on demand"
    browser.click("#nodes summary")
    browser.until("document.querySelectorAll('#nodes svg .pressure').length === 201")
    off = "document.querySelector('#nodes .readoff').textContent"
    browser.place("#nodes svg")
    browser.evaluate("document.querySelector('#nodes svg').focus()")
    said = []
    for _ in range(9):
        browser.key("ArrowRight")
        said.append(browser.evaluate(off))
    assert all("slip, pressure" in one for one in said), said
    exact = [one for one in said if "numbers of" not in one]
    assert len(exact) in (2, 3), said
    with open(folder / "points.contact.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["node"] == "1"]
    for one in exact:
        place = int(one.split("increment ")[1].split(",")[0])
        pressure = number(one.split("pressure ")[1].split(",")[0])
        wanted = float(rows[place - 1]["CPRESS"])
        assert abs(pressure - wanted) <= 1e-4 * wanted, f"{one}: {wanted}"
    browser.evaluate("document.getElementById('frame').focus()")
    for key in ("End", "ArrowLeft"):
        browser.key(key)
        arrows = browser.evaluate("document.querySelectorAll('#stage .arrow.normal').length")
        assert arrows == 201, f"{arrows} arrows after {key}"
    browser.picture(pictures / "points.png")
    assert not browser.faults(), browser.faults()
    print(f"browser: 201 points over {increments} increments: {page.stat().st_size} bytes")


def main():
    program, pictures = sys.argv[1], Path(sys.argv[2])
    pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        folder = Path(place)
        browser = Browser(folder / "profile")
        try:
            check(browser, program, folder, pictures)
        finally:
            browser.close()
    print("browser: every report loads, plays, drags and reads off; no console error, no request")


def check(browser, program, folder, pictures):
    paper = [("isl_coarse", "U2", "RF2"), ("isl_coarse_push_pull_mu03", "U2", "RF2"),
             ("irs_fine_mu03", "U2", "RF2"), ("cam_isl_mu03", "UR3", "RM3")]
    for name, motion, reaction in paper:
        run(program, "run", f"corpus/diehl1995/{name}.inp", "--out", folder, "--quiet")
        page = folder / f"{name}.html"
        assert page.stat().st_size <= 1_500_000, f"{name}: {page.stat().st_size} bytes"
        browser.open(page)
        assert "Completed" in browser.evaluate("document.getElementById('verdict').textContent")
        animation(browser)
        reading(browser, f"chart-9999-{motion}", history(folder / f"{name}.history.csv", 9999), motion, reaction)
        looks(browser, pictures, name)
        assert not browser.faults(), f"{name}: {browser.faults()}"
        print(f"browser: {name}: {page.stat().st_size} bytes")

    run(program, "run", "corpus/diehl1995/cam_isl_mu03.inp", "--friction-onset", "matfru", "--out", folder, "--quiet")
    browser.open(folder / "cam_isl_mu03.html")
    browser.call("Page.printToPDF")
    page = browser.evaluate("document.querySelector('#warnings details[open]').textContent")
    assert "What to change" in page, "the page of a warning is printed with it"
    assert browser.evaluate("document.querySelectorAll('#bands .dropped').length") > 0
    assert not browser.faults(), browser.faults()

    snap_fit(browser, program, folder, pictures)
    error_bars(browser, program, folder, pictures)

    theory = subprocess.run([program, "theory", "diehl-1", "--mu", "0.3"], capture_output=True, text=True)
    if theory.returncode == 0:
        curve = folder / "theory.csv"
        curve.write_text(theory.stdout)
        run(program, "report", folder / "isl_coarse_push_pull_mu03", "--overlay", curve)
        browser.open(folder / "isl_coarse_push_pull_mu03.html")
        legend = browser.evaluate("document.querySelector('#chart-9999-U2 .legend').textContent")
        assert "theory.csv" in legend, legend
        browser.picture(pictures / "overlay.png")
        assert not browser.faults(), browser.faults()

    thinned(browser, program, folder, pictures)

    deck = strange_deck(folder)
    run(program, "run", deck, "--quiet")
    browser.open(deck.with_suffix(".html"))
    assert browser.evaluate("document.querySelector('.job').textContent") == deck.stem
    assert "onerror" in browser.evaluate("document.querySelector('h1').textContent"), "the title is the heading"
    assert browser.evaluate("typeof window.injected") == "undefined", "a script was injected"
    assert browser.evaluate("document.querySelectorAll('img, script[src], link').length") == 0
    assert "onerror" in browser.evaluate("document.querySelector('.echo').textContent")
    named = browser.evaluate("document.querySelector('#names').textContent")
    assert "</SCRIPT><IMG" in named and "\u0436" in named.lower(), f"the pair's name is shown: {named}"
    animation(browser)
    assert not browser.faults(), browser.faults()
    curve = folder / "</x> <img src=x onerror=\"window.injected=5\"> \u6f22.csv".replace("/", "\u2215")
    curve.write_text("increment,time,RF2,U2\n0,0,0,0\n1,1,-9,-0.03\n")
    run(program, "report", deck, "--overlay", curve)
    browser.open(deck.with_suffix(".html"))
    legend = browser.evaluate("document.querySelector('#chart-9999-U2 .legend').textContent")
    assert curve.name in legend, legend
    assert browser.evaluate("typeof window.injected") == "undefined", "a script was injected"
    assert not browser.faults(), browser.faults()

    deck = thinned_deck(folder, 4)
    run(program, "run", deck, "--quiet")
    browser.open(deck.with_suffix(".html"))
    animation(browser)
    assert browser.evaluate("document.getElementById('frame').max") == "5", "start and five states"
    said = browser.evaluate("document.querySelector('#shape .remark').textContent")
    assert "5 of 20" in said and "4, 8, 12, 16, 20" in said, said
    reading(browser, "chart-9999-U2", history(deck.with_suffix(".history.csv"), 9999), "U2", "RF2")
    assert not browser.faults(), browser.faults()
    deck = thinned_deck(folder, 0)
    run(program, "run", deck, "--quiet")
    browser.open(deck.with_suffix(".html"))
    browser.click("#play")
    assert "no states" in browser.evaluate("document.querySelector('#shape').textContent")
    reading(browser, "chart-9999-U2", history(deck.with_suffix(".history.csv"), 9999), "U2", "RF2")
    assert not browser.faults(), browser.faults()

    deck = many_increments(folder)
    run(program, "run", deck, "--quiet")
    began = time.time()
    browser.open(deck.with_suffix(".html"))
    points = browser.evaluate("document.querySelector('#chart-9999-U2 path.curve').getAttribute('d').split('L').length")
    assert points == 1001, f"a curve of 1000 increments has {points} points"
    animation(browser)
    browser.picture(pictures / "many.png")
    assert not browser.faults(), browser.faults()
    print(f"browser: 1000 increments: {deck.with_suffix('.html').stat().st_size} bytes, used in {time.time() - began:.1f} s")


main()
