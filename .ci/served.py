"""A page of the workbench that the program serves, and its sliders."""

import re
import subprocess
import time
from pathlib import Path

HOST = "127.0.0.1"
CURRENT = "document.getElementById('verdict').dataset.current === 'true' && !Workbench.busy() && !Workbench.aim.busy()"


class Served:
    """The program that serves a page."""

    def __init__(self, program, *arguments, folder):
        command = [program, "workbench", *map(str, arguments), "--no-browser"]
        self.said = open(folder / "served.txt", "w+b")
        self.process = subprocess.Popen(command, stdout=self.said, stderr=subprocess.STDOUT, cwd=folder)
        deadline = time.time() + 30
        self.address = None
        while self.address is None and time.time() < deadline:
            text = (folder / "served.txt").read_text()
            found = re.search(r"http://127\.0\.0\.1:\d+/\S*", text)
            self.address = found.group(0) if found else None
            assert self.process.poll() is None, f"the program has ended: {text}"
            time.sleep(0.02)
        assert self.address, "no address is said"

    def memory(self):
        """Resident memory in bytes."""
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        return 1024 * int(re.search(r"VmRSS:\s+(\d+)", status).group(1))

    def close(self):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(20)
        self.said.close()


def value(browser, name):
    return browser.evaluate(f"Workbench.values[{name!r}]")


def slider(name):
    return f".parameter[data-name={name}] input[type=range]"


def drag_slider(browser, name, to, parts=12):
    """Takes a slider by its thumb to a part of its range."""
    x, y, width, height = browser.place(slider(name))
    low, high, now = browser.evaluate(f"(() => {{ const s = document.querySelector({slider(name)!r}); return [Number(s.min), Number(s.max), Number(s.value)]; }})()")
    thumb = 16
    at = lambda part: x + thumb / 2 + part * (width - thumb)
    begin, end, middle = at((now - low) / (high - low)), at(to), y + height / 2
    browser.mouse("mouseMoved", begin, middle)
    browser.mouse("mousePressed", begin, middle, True)
    for k in range(1, parts + 1):
        browser.mouse("mouseMoved", begin + k / parts * (end - begin), middle, True)
        time.sleep(0.02)
    browser.mouse("mouseReleased", end, middle)


def settled(browser):
    browser.until(CURRENT, 30)


def rows(browser):
    return browser.evaluate("Workbench.last.raw")
