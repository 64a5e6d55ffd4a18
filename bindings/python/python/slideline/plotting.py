"""Curves with Matplotlib, which is imported here alone."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .result import Result


def plot(result: Result, node: int | str | None, y: str | None, x: str | None, ax: Any) -> Any:
    """Draws one history over time, or over another one of the same node."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as missing:
        raise ImportError("plot() needs Matplotlib: pip install 'slideline[plot]'") from missing
    if node is None:
        node, y = driving_reaction(result, y)
        x = x or motion_of(y)
    if y is None:
        raise ValueError("name the history to be drawn: plot(node, 'RF2')")
    across = result.time if x in (None, "time") else result.history(node, x)
    ax = plt.gca() if ax is None else ax
    ax.plot(across, result.history(node, y))
    ax.set_xlabel("time" if x in (None, "time") else f"{x} at {node}")
    ax.set_ylabel(f"{y} at {node}")
    ax.set_title(result.job.name)
    return ax


def driving_reaction(result: Result, name: str | None) -> tuple[int, str]:
    """The node and the reaction that does most work among the histories."""
    names = [own for own in result.table("history").columns if own.startswith(("RF", "RM"))]
    names = [name] if name else names
    nodes = result.history_nodes
    found = [(abs(work(result, node, own)), node, own) for node in nodes for own in names]
    if not found:
        raise ValueError("no node has a history: name one, as in plot(9999, 'RF2')")
    _, node, own = max(found)
    return node, own


def motion_of(reaction: str) -> str:
    """The motion that a reaction works on."""
    return reaction.replace("RF", "U").replace("RM", "UR")


def work(result: Result, node: int, reaction: str) -> float:
    """Work [F L] by the trapezoidal rule."""
    force, motion = result.history(node, reaction), result.history(node, motion_of(reaction))
    return float(np.sum((force[1:] + force[:-1]) / 2.0 * np.diff(motion)))
