"""The 3D hand: trail, references, axes, and which view draws it."""

import dataclasses
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from app.panels.hand.controls import PROVEN, ViewChooser
from app.platform.graphics import is_card
from app.platform.tasks import TaskOwner
from app.viewmodels.hand_scene import TRAIL_POINTS, followed
from app.widgets.view3d.view_3d import View3D
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, with_live
from tracker.base.errors import ConfigError
from tracker.engine.kinds import ENGINES
from tracker.kernels import are_compiled
from tracker.messages import Tracking

ROOT = Path(__file__).parents[2]


class Second(ScriptedEngine):
    """Tracks with a second engine too, whose hand is a decimetre to the side of the first one's."""

    def __init__(self, engine: ScriptedEngine) -> None:
        super().__init__()
        self.engine, self.names, self.is_lost = engine, [], False

    def set_reference(self, name) -> None:
        if name == "vist":
            raise ConfigError("This glove has too few IMUs.")
        self.names.append(name)

    def reference_estimate(self):
        if not self.names or self.names[-1] is None:
            return None
        estimate = self.engine.latest_estimate()
        tracking = Tracking.LOST if self.is_lost else estimate.tracking
        sideways = estimate.segment_p + [0.0, 0.1, 0.0]
        return dataclasses.replace(estimate, segment_p=sideways, tracking=tracking)


@pytest.fixture
def hand(window, engine, qtbot):
    window.host.adopt(with_live(scripted_setup(engine), hand=Second(engine)))
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    return window.hand


def choose(combo, data: str) -> None:
    combo.setCurrentIndex(combo.findData(data))


def see(hand):
    """One refresh; the scene that was drawn."""
    hand.refresh(hand.host.snapshot())
    return hand._scene


def test_a_trail_is_the_path_of_the_fingertip(hand, engine):
    choose(hand.controls.trail, "index")
    row = models()[1].keypoint_names(models()[0]).index("index_tip")
    way = []
    for frame in (31, 32, 33):
        engine.frame = frame
        scene = see(hand)
        way.append(engine.latest_estimate().keypoints[row])
    assert scene.trail.shape == (TRAIL_POINTS, 3)
    np.testing.assert_allclose(scene.trail[-1], way[-1])
    corners = {tuple(p) for p in scene.trail.round(9)}
    assert {tuple(p.round(9)) for p in way} <= corners
    assert hand._hands[0].bodies._trail.shown
    choose(hand.controls.trail, "")
    see(hand)
    assert not hand._hands[0].bodies._trail.shown


def test_axes_are_at_the_joints_along_their_segments(hand):
    hand.controls.boxes["axes"].click()
    scene = see(hand)
    i = models()[0].index["index_proximal"]
    rows, arrays = hand._hands[0].bodies._axes._rows, hand.view.scene
    x = rows.start + i  # those of y and z follow all of x
    np.testing.assert_allclose(arrays.p_GB[x], scene.segment_p[i])
    np.testing.assert_allclose(arrays.R_GB[x], scene.segment_R[i])
    start, end = arrays.points[arrays.ends[arrays.owner == x][0]]
    assert not start.any() and not end[1:].any() and end[0] > 0.01
    assert arrays.shown[rows].all()


def test_the_reference_is_the_truth_or_another_engine(hand, engine):
    second = hand.host.setup.comparable
    choose(hand.controls.reference, "other")
    scene = see(hand)
    np.testing.assert_allclose(scene.reference[1], scene.segment_p)  # the scripted hand is true
    choose(hand.controls.reference, "madgwick")
    assert second.names[-1] == "madgwick"
    scene = see(hand)
    np.testing.assert_allclose(scene.reference[1] - scene.segment_p, np.tile([0, 0.1, 0], (16, 1)))
    second.is_lost = True
    assert see(hand).reference is None
    choose(hand.controls.reference, "")
    assert second.names[-1] is None
    assert see(hand).reference is None


@pytest.mark.parametrize(
    ("name", "axis", "sign"), [("back", 2, 1), ("palm", 2, -1), ("side", 1, 1)]
)
def test_a_button_views_a_side_of_the_dorsum(hand, name, axis, sign):
    scene = see(hand)
    hand.controls.presets[name].click()
    along = scene.segment_R[0].T @ hand.view.orbit.direction  # in the dorsum's frame
    assert np.abs(along).argmax() == axis and np.sign(along[axis]) == sign


def test_the_camera_button_uses_the_cameras_position(hand):
    scene = see(hand)
    hand.controls.presets["camera"].click()
    to_camera = scene.p_GC - hand.view.orbit.target
    np.testing.assert_allclose(
        hand.view.orbit.direction, to_camera / np.linalg.norm(to_camera), atol=1e-9
    )


def test_the_view_follows_a_hand_and_jumps_to_one_far_away(hand):
    scene = see(hand)
    centre = scene.segment_p.mean(axis=0)
    near, far = centre + [0.1, 0.0, 0.0], centre + [1.0, 0.0, 0.0]
    assert 0 < np.linalg.norm(followed(near, [scene], True) - centre) < 0.1
    halves = followed(followed(near, [scene], True, 0.05), [scene], True, 0.05)
    np.testing.assert_allclose(followed(near, [scene], True, 0.1), halves)
    for target, found_before in ((far, True), (near, False)):
        np.testing.assert_allclose(followed(target, [scene], found_before), centre)


def test_an_engine_that_cannot_run_is_reported(hand):
    choose(hand.controls.reference, "vist")
    assert "too few IMUs" in hand.window().banner.text()


def test_a_replay_offers_no_second_engine(window):
    window.host.adopt(dataclasses.replace(scripted_setup(ScriptedEngine()), live=None))
    reference = window.hand.controls.reference
    able = [reference.model().item(i).isEnabled() for i in range(reference.count())]
    assert able == [True, True] + [False] * len(ENGINES.names())


@pytest.mark.parametrize(
    ("renderer", "card"),
    [
        ("llvmpipe (LLVM 15.0.6, 256 bits)", False),
        ("softpipe", False),
        ("Mesa Intel(R) UHD Graphics 620 (KBL GT2)", True),
        ("NVIDIA GeForce RTX 3060/PCIe/SSE2", True),
        ("GDI Generic", False),
        ("Google SwiftShader", False),
        ("", False),
    ],
)
def test_software_rendering_is_recognised_by_its_name(renderer, card):
    assert is_card(renderer) == card


@pytest.fixture
def chooser(qtbot, store):
    view, tasks = View3D(), TaskOwner()
    qtbot.addWidget(view)
    chooser = ViewChooser(view, store, tasks)
    chooser.refusals = []
    chooser.refused.connect(chooser.refusals.append)
    yield chooser
    chooser.shut_down()
    tasks.shut_down()
    view.shut_down()


def test_a_graphics_card_that_crashed_the_program_is_not_tried_again(chooser, store):
    store.update(card_trial=True)
    chooser.start()
    assert (store.value.card_trial, store.value.view_3d) == (False, "painted")
    assert "crashed the program last time" in chooser.refusals[0]


def test_a_graphics_card_is_trusted_after_some_images(chooser, store, monkeypatch):
    monkeypatch.setattr(View3D, "use_card", lambda _self: True)
    store.update(view_3d="card")
    monkeypatch.setattr(View3D, "on_card", False)
    chooser._use(True)
    assert store.value.card_trial
    monkeypatch.setattr(View3D, "on_card", True)
    for _ in range(PROVEN):
        assert store.value.card_trial
        chooser.drawn()
    assert not store.value.card_trial


@pytest.mark.parametrize("there", [True, False])
def test_an_unusable_graphics_card_is_reported_where_it_was_selected(
    chooser, store, monkeypatch, there
):
    monkeypatch.setattr(View3D, "use_card", lambda _self: False)
    store.update(view_3d="card")
    chooser._use(there)
    assert "cannot use the graphics card" in chooser.refusals[0]
    assert not store.value.card_trial
    store.update(view_3d="auto")
    chooser._use(there)
    assert len(chooser.refusals) == 1


def test_an_installation_without_the_gpu_view_reports_it(chooser, store, monkeypatch):
    monkeypatch.setattr("app.panels.hand.controls.is_there", lambda: False)
    chooser.start()  # "auto" uses the software renderer without a message
    assert chooser.refusals == [] and not chooser._tasks.tasks
    chooser.choose("card")
    assert "not part of this installation" in chooser.refusals[0]
    assert not chooser._view.on_card and not store.value.card_trial


SELDOM_NEEDED = ("vtkmodules", "pyvista", "scipy.stats", "scipy.signal")
COMPILER = ("numba", "llvmlite")  # of kernels that are newer than the library


def test_the_software_view_loads_neither_vtk_nor_numba():
    """A second and 200 MB; the packed program has no numba."""
    unwanted = (*SELDOM_NEEDED, *(COMPILER if are_compiled() else ()))
    code = (
        "import sys; from PySide6.QtWidgets import QApplication; import app.window.main_window; "
        "from app.widgets.view3d.view_3d import View3D; from tracker.session import arithmetic; "
        "app = QApplication([]); view = View3D(); view.resize(99, 99); view.render_scene(); "
        f"arithmetic.arithmetic(); print([m for m in {unwanted} if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )  # the environment has QT_QPA_PLATFORM
    assert done.stdout.strip() == "[]"


def test_the_menu_remembers_the_view(window, store, qtbot, no_leaks):
    window.run_command("view_painted")
    assert store.value.view_3d == "painted"
    again = MainWindow(store)
    qtbot.addWidget(again)
    assert again.hand.chooser._store.value.view_3d == "painted"
    again.close()


CARD = """
import sys
sys.path[:0] = [{root!r}, {root!r} + "/tests/gui"]
from pathlib import Path
import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from app.panels.hand.panel import HandPanel
from app.window.headless_report import wait_until
from app.engines.engine_host import EngineHost
from app.storage.settings import SettingsStore
from app.platform.tasks import TaskOwner
app = QApplication([])
store = SettingsStore(Path({folder!r}) / "window.json")
store.update(view_3d="card")
tasks = TaskOwner()
host = EngineHost(tasks)
panel = HandPanel(host, store, tasks)
panel.resize(420, 360)
host.adopt(scripted_setup(ScriptedEngine()))
panel.show()

def greenish():
    panel.refresh(host.snapshot())
    app.processEvents()
    image = panel.view.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    rgb = rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)
    return (rgb[..., 1] > rgb[..., 0] + 25).mean()

assert wait_until(lambda: panel.view.on_card, 60), "the card's view did not start"
wait_until(lambda: greenish() > 0.005, 60)
on_card = greenish()

def dead(*_):
    raise RuntimeError("driver lost")

panel.view._view.surface.render = dead
wait_until(lambda: greenish() > 0.005 and not panel.view.on_card, 60)
print(on_card, greenish(), panel.view.on_card)
host.shut_down()
panel.shut_down()
tasks.shut_down()
"""


@pytest.mark.skipif(shutil.which("xvfb-run") is None, reason="needs a virtual screen")
def test_the_gpu_view_shows_the_hand_and_is_replaced_when_the_driver_fails(tmp_path):
    """pyvistaqt's QtInteractor, forced by the setting, on a virtual screen."""
    pytest.importorskip("pyvistaqt")
    script = tmp_path / "card.py"
    script.write_text(CARD.format(root=str(ROOT), folder=str(tmp_path)))
    without = ("QT_QPA_PLATFORM", "DISPLAY", "VTK_DEFAULT_OPENGL_WINDOW")
    environment = {k: v for k, v in os.environ.items() if k not in without}
    done = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", sys.executable, str(script)],
        env={**environment, "LIBGL_ALWAYS_SOFTWARE": "1"},
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    on_card, painted, still = done.stdout.split()[-3:]
    assert float(on_card) > 0.005  # the colour of what is measured
    assert float(painted) > 0.005 and still == "False"
