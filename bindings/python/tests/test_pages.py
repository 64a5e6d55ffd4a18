"""Pages whose Python blocks are programs."""

import re

import pytest

from conftest import ROOT

#: page and what it needs besides the package
PAGES = {"python.md": ["pandas"], "optimisers.md": ["scipy", "SALib", "openmdao"]}


@pytest.mark.parametrize("page", PAGES)
def test_the_blocks_of_a_page_are_a_program(page, monkeypatch):
    for needed in PAGES[page]:
        pytest.importorskip(needed)
    monkeypatch.chdir(ROOT)
    path = ROOT / "docs" / page
    text = path.read_text(encoding="utf-8")
    # blank lines in place of prose, so that errors name the lines of the page
    kept, inside = [], False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = line == "```python"
            kept.append("")
        else:
            kept.append(line if inside else "")
    assert len(re.findall("^```python$", text, re.M)) >= 3
    exec(compile("\n".join(kept), str(path), "exec"), {"__name__": page})
