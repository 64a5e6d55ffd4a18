"""What the page of the workbench does where there is nothing to show: no model, a solve that is
stopped, a program that has ended."""

from served import settled, value


def impossible(browser):
    """Values that make no model: no curve, no green, and what was drawn before is pale."""
    settled(browser)
    before = value(browser, "modulus")
    browser.evaluate("Workbench.set('modulus', -1, false)")
    settled(browser)
    assert browser.evaluate("document.getElementById('verdict').className") == "verdict red"
    browser.until("document.getElementById('stage').classList.contains('pale')")
    assert browser.evaluate("Workbench.shown.rows < 1"), "there is a curve of nothing"
    browser.evaluate(f"Workbench.set('modulus', {before}, false)")
    settled(browser)
    browser.until("!document.getElementById('stage').classList.contains('pale')")


def stopping(browser):
    """A solve that is stopped leaves a curve that is not current; the next value solves again."""
    title = "document.getElementById('verdict-title').textContent"
    for attempt in range(10):
        settled(browser)
        browser.evaluate(f"""(() => {{
          let stopped = false;
          Workbench.on('points', () => {{ if (!stopped) {{ stopped = true; Workbench.stop(); }} }});
          Workbench.set('length', Workbench.values.length * {1.01 if attempt % 2 == 0 else 1 / 1.01}, false);
        }})()""")
        browser.until(f"!Workbench.busy() && !{title}.startsWith('Solving')")
        if browser.evaluate(title) == "Stopped":
            break
        # it had come to its end before it heard
        assert browser.evaluate("Workbench.current()")
    else:
        raise AssertionError("nothing can be stopped")
    assert browser.evaluate("document.getElementById('chart').dataset.current") == "false"
    browser.evaluate("Workbench.set('length', Workbench.parameter('length').value, false)")
    settled(browser)


def losing(browser, served):
    """Without its program the page says so, and nothing on it is current."""
    served.close()
    browser.until("!document.getElementById('lost').hidden")
    assert browser.evaluate("document.getElementById('verdict').className") == "verdict red"
    assert browser.evaluate("document.getElementById('chart').dataset.current") == "false"
    browser.evaluate("Workbench.set('thickness', 1.9, false)")
    assert not browser.faults(), browser.faults()
