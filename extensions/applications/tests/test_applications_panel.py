"""Applications in the real window: drawn around the hand, changed and restarted."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from extensions.applications.drawing import Line, Mesh, Points, Text
from extensions.applications.hand import HandSample
from extensions.applications.interface import Happening, Step
from extensions.applications.live import ReplayedApplication
from extensions.applications.stage import ApplicationStage
from extensions.applications.window.drawing import DrawingForms, bounds
from extensions.applications.window.view_model import ApplicationProgress, instruction, results
from tests.base.test_registry import install
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup
from tracker.geometry import so3
from tracker.glove import library
from tracker.messages import Estimate, Event, Tracking
from tracker.simulation import scripted
from tracker.simulation.motion import pose_at

OURS = ("touch", "arm", "place", "swarm")
TETRA = np.array([[0, 0, 0], [1.0, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@dataclass(frozen=True)
class CompassSettings:
    size: float = 0.05
    loud: bool = True
    place: tuple[float, ...] = ()
    word: str = "north"


class Compass:
    """All primitives at the index fingertip; counts samples."""

    name, title, between = "compass", "Compass", 0

    def __init__(self, settings: CompassSettings) -> None:
        self.settings = settings
        self.samples = 0

    def step(self, hand: HandSample) -> Step:
        self.samples += 1
        tip = hand.point("index_tip")
        assert tip is not None
        R = self.settings.size * np.eye(3)
        drawing = (
            Mesh("needle", TETRA, FACES, "#D55E00", R, tip),
            Line("way", np.array([tip, tip + [0.0, 0.05, 0.0]])),
            Points("dots", tip + np.eye(3) * 0.03),
            Text("word", self.settings.word, tip),
        )
        events = [Happening("sample")] if self.samples == 1 else []
        return Step(drawing, events)


@pytest.fixture
def staged(window, qtbot, tmp_path, monkeypatch):
    """The window with an engine that has a stage, and the compass among the applications."""
    install(tmp_path, "compass", {"compass": f"{__name__}:Compass"}, "applications")
    monkeypatch.syspath_prepend(str(tmp_path))
    reported: list[Event] = []
    hand, glove, _ = models()
    stage = ApplicationStage(hand, glove, reported.append)
    engine = ScriptedEngine()
    window.host.adopt(replace(scripted_setup(engine), listeners=on(stage)))
    window.show_panel("applications")
    qtbot.waitUntil(window.panels["applications"].isVisible)
    window.ticker.stop()
    return window.panels["applications"], stage, engine, reported


def on(stage: ApplicationStage) -> dict[str, ReplayedApplication]:
    """The listeners of a hand with this stage."""
    return {"applications": ReplayedApplication(stage)}


def show(panel, stage, engine) -> None:
    for _ in stage.feed(engine.latest_estimate()):
        pass
    panel.refresh(panel.host.snapshot())


def painted(panel) -> np.ndarray:
    image = panel.view.grab().toImage()
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)[:, ::4].copy()


@pytest.mark.long
def test_the_chosen_application_is_drawn_and_its_events_are_reported(staged, qtbot):
    panel, stage, engine, reported = staged
    show(panel, stage, engine)
    before = painted(panel)
    panel.controls.choice.setCurrentIndex(panel.controls.choice.findData("compass"))
    show(panel, stage, engine)
    show(panel, stage, engine)
    assert stage.name == "compass"
    assert (painted(panel) != before).mean() > 0.01
    assert panel.result.text() == "sample 1"
    assert [e.data["what"] for e in reported] == ["begins", "sample"]
    panel.controls.again.click()
    show(panel, stage, engine)
    assert [e.data["what"] for e in reported[2:]] == ["begins", "sample"]
    panel.controls.choice.setCurrentIndex(0)
    show(panel, stage, engine)
    assert reported[-1].data["what"] == "ends"
    assert panel.model.drawing == ()
    for _ in range(2):  # the end of the one before is not the next one's
        panel.choose("compass")
        show(panel, stage, engine)
        assert panel.result.text() == "sample 1"


@pytest.mark.long
def test_a_hand_without_an_application_is_and_stays_in_the_middle_of_the_view(staged):
    panel, stage, engine, _ = staged
    show(panel, stage, engine)
    p = engine.latest_estimate().keypoints
    assert np.linalg.norm(panel.view.orbit.target - p.mean(axis=0)) < 0.08  # half a hand
    assert panel.view.orbit.distance < 1.0
    panel.view.orbit.target = panel.view.orbit.target + 0.2  # as if it had moved away
    for _ in range(60):
        show(panel, stage, engine)
    assert np.linalg.norm(panel.view.orbit.target - p.mean(axis=0)) < 0.08


def test_the_hand_is_drawn_after_the_colours_have_changed(staged, window, qtbot):
    """After the colours were adapted to the light, an open application is described again for the
    same hand."""
    panel, stage, engine, _ = staged
    setup, profile = window.host.setup, models()[2]
    window.host.adopt(replace(setup, listeners=on(stage), profile=profile))
    window.host.set_profile(replace(profile, name="of another light"))
    panel.choose("compass")

    def drawn() -> bool:
        show(panel, stage, engine)
        return panel.view.skin is not None and panel.view.caption == ""

    qtbot.waitUntil(drawn)
    assert panel.view._bodies[0]._skin is panel.view.skin


def progress(**counts) -> ApplicationProgress:
    return ApplicationProgress(counts, {})


def test_each_application_shows_its_current_instruction():
    for name in OURS:
        waits = instruction(name, progress(placed=1), located=False)
        begins = instruction(name, progress(placed=1), located=True)
        assert waits == "Hold the hand in view of the cameras." and begins != waits
    assert "fingertip" in instruction("touch", progress(placed=1), True)
    assert "Press deeper" in instruction("touch", progress(placed=1, touch=2, release=1), True)
    assert "thumb up" in instruction("arm", progress(placed=1, stop=1), True)
    assert "carry" in instruction("arm", progress(placed=1, clutch=1, grab=1), True)
    assert "palm open" in instruction("place", progress(placed=1, choose=2, back=1), True)
    assert "Pinch inside" in instruction("swarm", progress(placed=1, nudge=1), True)
    assert "fist" in instruction(
        "swarm", progress(placed=1, nudge=1, dragged=1, stretched=1, split=1), True
    )
    assert instruction("air-drawing", progress(placed=1), True) == ""


def test_the_instruction_follows_a_touch_and_its_result_has_units(staged, qtbot):
    panel, stage, engine, _ = staged
    show(panel, stage, engine)
    tip = engine.latest_estimate().keypoints[models()[0].keypoint_names.index("index_tip")]
    stage.show("touch", {"place": tip.tolist()})
    show(panel, stage, engine)
    assert panel.instruction.text().startswith("Press deeper") and panel.instruction.isVisible()
    assert panel.result.text().startswith("Touches: ") and " mm deep" in panel.result.text()
    stage.show("")
    show(panel, stage, engine)
    assert not panel.instruction.isVisible()


@pytest.mark.long
@pytest.mark.parametrize("name", OURS)
def test_a_show_describes_what_the_simulated_wearer_does(name):
    """Run on the show that each application has, with the true hand."""
    hand, glove, _ = models()
    stage, motion = ApplicationStage(hand, glove), scripted.show(name, hand)
    stage.show(name)
    said = []
    for t in np.arange(0.0, motion.duration, 0.02):
        angles, R, p = pose_at(motion, t)
        R_GB, p_GB = hand.forward(angles, R, p)
        for _ in stage.feed(true_estimate(float(t), R_GB, p_GB, angles)):
            pass
        made = ApplicationProgress(dict(stage.counts), {w: e.data for w, e in stage.latest.items()})
        said.append((instruction(name, made, True), results(name, made)))
    assert stage.problem == ""
    assert len({step for step, _ in said}) > 1, "the instruction goes on with what was done"
    assert any(ch.isdigit() for ch in said[-1][1]) and "_" not in said[-1][1]


def true_estimate(t: float, R_GB, p_GB, angles) -> Estimate:
    hand, glove, _ = models()
    names = glove.keypoint_names(hand)
    points = glove.keypoint_positions(hand, R_GB, p_GB, np.ones((len(R_GB), 3)))
    q = so3.quat_from_matrix(R_GB[glove.keypoint_segments(hand)])
    sure, measured = np.full(len(names), 1e-3), np.full(len(names), 2)
    return Estimate(
        t, Tracking.TRACKING, points, q, measured, sure, angles, np.full(len(angles), 2), R_GB, p_GB
    )


def test_settings_are_changed_in_the_form(staged):
    panel, stage, engine, reported = staged
    panel.choose("compass")
    show(panel, stage, engine)
    panel.controls.settings.click()
    assert set(panel.form.fields) == {"size", "loud", "place", "word"}
    panel.form.fields["size"].setValue(0.1)
    panel.form.fields["loud"].click()
    panel.form.fields["place"].setText("1, 2; 3")
    panel.form.fields["place"].editingFinished.emit()
    show(panel, stage, engine)
    assert stage.settings == CompassSettings(0.1, False, (1.0, 2.0, 3.0), "north")
    panel.form.fields["place"].setText("far away")
    panel.form.fields["place"].editingFinished.emit()
    assert panel.form.fields["place"].text() == ""
    changed = [e.data["key"] for e in reported if e.data["what"] == "setting"]
    assert changed == ["size", "loud", "place"]


@pytest.mark.long
def test_the_running_application_moves_to_the_selected_hand(staged, window):
    panel, right, engine, reported = staged
    hand, glove = library.load("vist-small-left")
    left = ApplicationStage(hand, glove)
    there = replace(scripted_setup(engine), hand=hand, glove=glove, listeners=on(left))
    window.host.adopt(replace(window.host.setup, others=(there,)))
    panel.choose("compass", {"size": 0.2, "place": [1.0, 2.0, 3.0]})
    show(panel, right, engine)
    window.host.show_hand("left")
    assert (right.name, left.name) == ("", "compass")
    assert left.settings == CompassSettings(0.2, True, (1.0, 2.0, 3.0), "north")
    assert panel.controls.choice.currentData() == "compass" and panel.model.stage is left
    show(panel, right, engine)
    assert reported[-1].data == {"application": "compass", "hand": "right", "what": "ends"}
    window.host.show_hand("right")
    assert (right.name, left.name) == ("compass", "")


def test_shapes_are_drawn_at_their_positions():
    turn = 0.5 * np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    drawing = (
        Mesh("m", TETRA, FACES, R=turn, p=np.array([1.0, 0, 0])),
        Line("l", np.array([[0.0, 0, 0], [0, 0, 2.0]])),
        Points("p", np.array([[0.0, -1, 0]]), 0.1),
    )
    forms = DrawingForms()
    mesh, balls = forms.surfaces(drawing)
    assert mesh.points[1] == pytest.approx([1.0, 0.5, 0.0])
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1.0)
    outwards = np.einsum("vk,vk->v", mesh.normals, mesh.points - mesh.points.mean(axis=0))
    assert outwards.min() > 0
    radius = np.linalg.norm(balls.points - [0.0, -1, 0], axis=1)
    assert radius == pytest.approx(0.1, rel=1e-5)
    (line,) = forms.lines(drawing)
    assert (line.points[1:] == [0.0, 0.0, 2.0]).all()
    low, high = bounds(drawing)
    assert low == pytest.approx([0.0, -1.0, 0.0])
    assert high == pytest.approx([1.0, 0.5, 2.0])
