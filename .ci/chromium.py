"""Headless Chromium over its debugging pipe: standard library only."""

import base64
import json
import os
import select
import subprocess
import tempfile
import time
from pathlib import Path

FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync
--hide-scrollbars --force-device-scale-factor=1 --remote-debugging-pipe""".split()
KEYS = {"ArrowRight": 39, "ArrowLeft": 37, "ArrowUp": 38, "ArrowDown": 40, "Home": 36, "End": 35, "0": 48, "+": 187, " ": 32,
        "Enter": 13, "Tab": 9, "Escape": 27, "F1": 112, "z": 90, "y": 89, "s": 83}


class Browser:
    """One browser with one page; commands go out and answers come in as JSON
    texts that end in a zero byte. `host`: the one address that it may reach, none by default."""

    def __init__(self, profile, host=None):
        self.host = host
        to_browser, self.out = os.pipe()
        self.input, from_browser = os.pipe()
        rules = "MAP * ~NOTFOUND" + (f", EXCLUDE {host}" if host else "")
        flags = [*FLAGS, f"--host-resolver-rules={rules}"]
        command = ["bash", "-c", f'exec "$@" 3<&{to_browser} 4>&{from_browser}', "-", "chromium",
                   *flags, f"--user-data-dir={profile}", "about:blank"]
        self.log = tempfile.TemporaryFile()
        self.process = subprocess.Popen(command, pass_fds=[to_browser, from_browser], stderr=self.log)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer, self.number, self.events, self.session = b"", 0, [], None
        deadline = time.time() + 30
        pages = []
        while not pages and time.time() < deadline:
            targets = self.call("Target.getTargets")["targetInfos"]
            pages = [one for one in targets if one["type"] == "page"]
        self.session = self.call("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log"]:
            self.call(domain + ".enable")
        # what goes over a socket would all be reported: a served page is asked what it has loaded
        if host is None:
            self.call("Network.enable")
            self.call("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        self.size(1200, 900)

    def message(self, deadline):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.input], [], [], max(0, deadline - time.time()))
            if not ready:
                return None
            read = os.read(self.input, 1 << 20)
            if not read:
                raise SystemExit("the browser is gone")
            self.buffer += read
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            command["sessionId"] = self.session
        os.write(self.out, json.dumps(command).encode() + b"\0")
        deadline = time.time() + 60
        while True:
            answer = self.message(deadline)
            if answer is None:
                raise SystemExit(f"no answer to {method}")
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise SystemExit(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def size(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def open(self, path):
        self.go(Path(path).resolve().as_uri())

    def go(self, path):
        self.events.clear()
        self.call("Page.navigate", url=path)
        deadline = time.time() + 30
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            event = self.message(deadline)
            assert event is not None, f"{path} does not load"
            self.events.append(event)

    def evaluate(self, expression, wait=False):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=wait)
        assert "exceptionDetails" not in result, f"{expression}: {result['exceptionDetails']}"
        return result["result"].get("value")

    def place(self, selector):
        self.evaluate(f"document.querySelector({selector!r}).scrollIntoView({{block: 'center'}})")
        return self.evaluate(f"(() => {{ const r = document.querySelector({selector!r}).getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; }})()")

    def mouse(self, kind, x, y, pressed=False):
        parameters = {"type": kind, "x": x, "y": y, "buttons": 1 if pressed else 0}
        if kind != "mouseMoved" or pressed:
            parameters.update(button="left", clickCount=1)
        self.call("Input.dispatchMouseEvent", **parameters)

    def click(self, selector):
        x, y, width, height = self.place(selector)
        self.mouse("mousePressed", x + width / 2, y + height / 2, True)
        self.mouse("mouseReleased", x + width / 2, y + height / 2)

    def drag(self, begin, end):
        self.mouse("mouseMoved", *begin)
        self.mouse("mousePressed", *begin, True)
        for part in (0.25, 0.5, 0.75, 1.0):
            self.mouse("mouseMoved", *[a + part * (b - a) for a, b in zip(begin, end)], True)
        self.mouse("mouseReleased", *end)

    def key(self, name):
        text = {"text": {"Enter": "\r"}.get(name, name)} if len(name) == 1 or name == "Enter" else {}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, windowsVirtualKeyCode=KEYS[name], **(text if kind == "keyDown" else {}))

    def until(self, expression, seconds=15):
        deadline = time.time() + seconds
        while time.time() < deadline:
            if self.evaluate(expression):
                return
            time.sleep(0.05)
        raise AssertionError(f"never became true: {expression}")

    def picture(self, path):
        metrics = self.call("Page.getLayoutMetrics")
        size, seen = metrics["cssContentSize"], metrics["cssLayoutViewport"]
        # a page that fits is taken as it stands: beyond the window, what is scrolled in it is not
        whole = {}
        if size["height"] > seen["clientHeight"]:
            clip = {"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], 9000), "scale": 1}
            whole = {"captureBeyondViewport": True, "clip": clip}
        shot = self.call("Page.captureScreenshot", format="png", **whole)
        Path(path).write_bytes(base64.b64decode(shot["data"]))

    def faults(self):
        """Everything the console or the network had to complain about."""
        loaded = self.evaluate("performance.getEntriesByType('resource').map((one) => one.name)")
        found = [one for one in loaded if not self.allowed(one)]
        for event in self.events:
            method, said = event.get("method"), event.get("params", {})
            if method == "Runtime.exceptionThrown":
                found.append(said["exceptionDetails"])
            elif method == "Log.entryAdded" and said["entry"]["level"] in ("error", "warning"):
                entry = said["entry"]
                found.append(f"{entry['text']} ({entry.get('url')}:{entry.get('lineNumber')})")
            elif method == "Runtime.consoleAPICalled" and said["type"] in ("error", "warning", "assert"):
                found.append(said)
            elif method == "Network.requestWillBeSent" and not self.allowed(said["request"]["url"]):
                found.append(said["request"]["url"])
        return found[:10]

    def allowed(self, address):
        own = self.host and address.startswith(f"http://{self.host}:")
        return own or address.startswith(("file:", "data:", "blob:"))

    def close(self):
        try:
            self.call("Browser.close")
        except SystemExit:
            pass
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
