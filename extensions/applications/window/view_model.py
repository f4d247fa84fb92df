"""The state of the Applications panel: applications, settings, instructions and results."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any, NamedTuple

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.names import display_name
from app.words import error_text, local, tr
from extensions.applications.drawing import Drawing
from extensions.applications.live import stage_of
from extensions.applications.registry import titles
from extensions.applications.runner import BEGINS, ENDS, KIND
from extensions.applications.stage import ShownStage
from tracker.base.errors import GlovetrackError
from tracker.streaming.publisher import StreamError

PAGE_PORT = 9752
NO_EVENTS = frozenset({BEGINS, ENDS})


@dataclass(frozen=True)
class SettingRow:
    """One setting: its value is a number, a text, a boolean or a tuple of numbers."""

    key: str
    value: Any


class ApplicationsModel:
    """The applications of one open engine."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self.stage = stage_of(setup.listeners)
        self.titles = titles()

    @property
    def expected(self) -> tuple[str, dict[str, Any]]:
        """Name and settings of the application that was recorded with this hand, or that a
        simulated wearer uses; empty without one."""
        player, side = self._setup.player, self._setup.hand.side
        for _, event in player.events if player is not None else ():
            begins = event.kind == KIND and event.data.get("what") == BEGINS
            if begins and event.data.get("hand") == side:
                settings: Any = event.data.get("settings", {})
                return str(event.data["application"]), dict(settings)
        name, settings = self._setup.application
        return name, dict(settings)

    def show(self, name: str, settings: dict[str, Any] | None = None) -> str:
        """Run an application; returns why that is impossible, or empty."""
        if self.stage is None:
            return tr("Applications run on a tracked hand: open the demo, devices or a session.")
        try:
            self.stage.show(name, settings)
        except (GlovetrackError, ImportError) as error:
            return error_text(error)
        return ""

    @property
    def runs(self) -> bool:
        """Whether there is an application."""
        return self.stage is not None and bool(self.stage.name)

    def rows(self) -> list[SettingRow]:
        """The settings of the running application."""
        settings = self.stage.settings if self.stage is not None else None
        if settings is None:
            return []
        return [SettingRow(f.name, getattr(settings, f.name)) for f in fields(settings)]

    def set(self, key: str, value: Any) -> str:
        """Change a setting; returns why that is impossible, or empty."""
        try:
            if self.stage is not None:
                self.stage.set(key, value)
        except GlovetrackError as error:
            return error_text(error)
        return ""

    def leave(self) -> tuple[str, dict[str, Any]]:
        """End the application; returns its name and settings, to continue with another hand."""
        stage = self.stage
        if stage is None or not stage.name:
            return "", {}
        left = stage.name, json.loads(json.dumps(asdict(stage.settings)))  # rows as lists
        self.show_page(False)
        stage.show("")
        return left

    def show_page(self, on: bool) -> str:
        """Serve the page on this computer, or end that; returns its address, or why it failed."""
        stage = self.stage
        if stage is None:
            return ""
        for viewer in stage.viewers:
            viewer.close()
        stage.viewers.clear()
        if not on:
            return ""
        try:
            from extensions.applications.page import PageServer  # deferred: needs an extra

            page = PageServer(PAGE_PORT)
        except ImportError:
            return tr('The page needs a package that is not installed: pip install "{}"').format(
                "glovetrack[streams]"
            )
        except StreamError as error:
            return error_text(error)
        stage.viewers.append(page)
        return tr("For browsers on this computer, including a headset's: {}").format(page.url)

    @property
    def drawing(self) -> Drawing:
        """The latest drawing; empty before the first."""
        outcome = self.stage.outcome if self.stage is not None else None
        return outcome.drawing if outcome is not None else ()

    def instruction(self) -> str:
        """What the wearer should do now; empty if unknown."""
        stage = self.stage
        if stage is None or not stage.name or stage.problem:
            return ""
        located = stage.outcome is not None and stage.outcome.hand.located
        return instruction(stage.name, self._made(stage), located)

    @staticmethod
    def _made(stage: ShownStage) -> ApplicationProgress:
        last = {what: event.data for what, event in stage.latest.items()}
        return ApplicationProgress(Counter(dict(stage.counts)), last)

    def line(self) -> str:
        """The results in one line."""
        stage = self.stage
        if stage is None or not stage.name:
            return ""
        if stage.problem:
            return tr("The application failed and is paused: {}").format(stage.problem)
        found = results(stage.name, self._made(stage))
        if found:
            return found
        if is_known(stage.name):
            return tr("Nothing has happened yet.")
        counts = [(what, n) for what, n in stage.counts.items() if what not in NO_EVENTS]
        return ", ".join(f"{what} {n}" for what, n in counts) or tr("Nothing has happened yet.")


def parsed(text: str, like: Any) -> Any:
    """Parse the text of a user as a value of the type of ``like``. Raises ValueError."""
    if isinstance(like, tuple):
        return [float(part) for part in text.replace(";", ",").split(",") if part.strip()]
    return text


def written(value: Any) -> str:
    """Format a text or a tuple of numbers for the user."""
    if isinstance(value, Sequence) and not isinstance(value, str):
        return ", ".join(f"{local(float(v)):g}" for v in value)
    return str(value)


class ApplicationProgress(NamedTuple):
    """The number of events of each kind, and the data of the last one."""

    counts: Mapping[str, int]
    last: Mapping[str, Mapping[str, Any]]

    def count(self, what: str) -> int:
        return self.counts.get(what, 0)

    def is_active(self, begins: str, ends: str) -> bool:
        return self.count(begins) > self.count(ends)


def is_known(name: str) -> bool:
    """Whether `instruction` and `results` have texts for this application."""
    return name in _STEPS


def instruction(name: str, made: ApplicationProgress, located: bool) -> str:
    """What to do now; empty for third-party applications."""
    if not is_known(name):
        return ""
    if not located:
        return tr("Hold the hand in view of the cameras.")
    return _STEPS[name](made)


def results(name: str, made: ApplicationProgress) -> str:
    """The results with units; empty for third-party applications, or before there are any."""
    return " · ".join(_RESULTS[name](made)) if name in _RESULTS else ""


def _touch_step(made: ApplicationProgress) -> str:
    if made.is_active("touch", "release"):
        return tr("Press deeper to feel it more, or slide along the surface.")
    if made.count("touch"):
        return tr("Touch the object from another side, or with another finger.")
    return tr("Reach forward and touch the object with a fingertip.")


def _arm_step(made: ApplicationProgress) -> str:
    if made.is_active("stop", "go_on"):
        return tr("The arm is stopped. Show a thumb up to continue.")
    if made.is_active("grab", "release"):
        return tr("Move the closed hand to carry the block. Pinch again to open the gripper.")
    if made.is_active("clutch", "unclutch"):
        return tr("Move the hand: the arm follows. Pinch at the block to close the gripper.")
    return tr("Close the hand by a grasp or a pinch to move the arm. Open the palm to stop it.")


def _place_step(made: ApplicationProgress) -> str:
    if not made.is_active("choose", "back"):
        return tr("Point at a building with the index finger and hold still to open it.")
    return tr(
        "Grasp the building to move and turn it. Pinch with the middle finger and raise the hand "
        "to enlarge it, with the index finger and slide to fade the old plan. Hold the palm open "
        "to go back to the map."
    )


def _swarm_step(made: ApplicationProgress) -> str:
    if not made.count("nudge"):
        return tr("Point with the index finger and push into the swarm.")
    if not made.count("dragged"):
        return tr("Pinch inside the swarm and move the hand to drag it.")
    if not made.count("stretched"):
        return tr("Grasp inside the swarm and pull to stretch it.")
    if made.is_active("split", "merge"):
        return tr("Make a fist to join the groups.")
    if not made.count("split"):
        return tr("Cut through the swarm with the open palm to split it.")
    if not made.count("wall"):
        return tr("Sweep the open palm next to the swarm to leave a wall.")
    return tr("Show a thumb up to remove the walls.")


def _touch_results(made: ApplicationProgress) -> list[str]:
    out = []
    if made.count("touch"):
        last = made.last["touch"]
        finger, depth = display_name(str(last["tip"])), float(last["depth_mm"])
        out.append(tr("Touches: {}").format(made.count("touch")))
        out.append(tr("last: {}, {:.1f} mm deep").format(finger, local(depth)))
        now = made.count("touch") - made.count("release")
        out.append(tr("fingertips that touch now: {}").format(max(now, 0)))
    return out


def _arm_results(made: ApplicationProgress) -> list[str]:
    out = []
    if made.count("clutch"):
        out.append(tr("Moves: {}").format(made.count("clutch")))
        closed = made.is_active("grab", "release")
        out.append(tr("gripper closed") if closed else tr("gripper open"))
    if made.count("lifted"):
        out.append(tr("block lifted: {} ×").format(made.count("lifted")))
    if made.count("put_down"):
        x, y, _ = made.last["put_down"]["at"]
        text = tr("put down {:.0f} mm ahead and {:.0f} mm to the left of the arm's foot")
        out.append(text.format(1e3 * x, 1e3 * y))
    if made.count("confirm"):
        out.append(tr("marked positions: {}").format(made.count("confirm")))
    return out


def _place_results(made: ApplicationProgress) -> list[str]:
    out = []
    if made.is_active("choose", "back"):
        out.append(tr("Open: {}").format(made.last["choose"]["label"]))
    if made.count("moved"):
        last = made.last["moved"]
        far = 100 * float(np.linalg.norm(last["by"]))
        out.append(tr("moved by {:.0f} cm, turned by {:.0f}°").format(far, last["turned_deg"]))
    if made.count("scaled"):
        out.append(tr("size {:.1f} ×").format(local(float(made.last["scaled"]["size"]))))
    if made.count("faded"):
        out.append(tr("old plan {:.0f} % visible").format(100 * made.last["faded"]["source"]))
    return out


def _swarm_results(made: ApplicationProgress) -> list[str]:
    out = []
    if made.count("placed"):
        out.append(tr("Drones: {}").format(int(made.last["placed"]["drones"])))
    for what, text in (("nudge", tr("nudges: {}")), ("split", tr("splits: {}"))):
        if made.count(what):
            out.append(text.format(made.count(what)))
    if made.count("dragged"):
        far = 100 * float(np.linalg.norm(made.last["dragged"]["by"]))
        out.append(tr("dragged by {:.0f} cm").format(far))
    if made.count("stretched"):
        out.append(
            tr("stretched to {:.1f} ×").format(local(float(made.last["stretched"]["factor"])))
        )
    if made.count("wall"):
        area = float(made.last["wall"]["area_cm2"])
        out.append(tr("walls: {}, the last of {:.0f} cm²").format(made.count("wall"), area))
    return out


_STEPS: Mapping[str, Callable[[ApplicationProgress], str]] = {
    "touch": _touch_step,
    "arm": _arm_step,
    "place": _place_step,
    "swarm": _swarm_step,
}
_RESULTS: Mapping[str, Callable[[ApplicationProgress], list[str]]] = {
    "touch": _touch_results,
    "arm": _arm_results,
    "place": _place_results,
    "swarm": _swarm_results,
}
