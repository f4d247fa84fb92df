"""What panels show, computed from messages of which everything is known."""

import dataclasses
import tomllib

import cv2
import numpy as np
import pytest

from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.platform.tasks import TaskOwner
from app.viewmodels import names
from app.viewmodels.calibration import RANGES, calibration_view, convergence
from app.viewmodels.camera_overlay import Layers, overlay
from app.viewmodels.checklist import steps
from app.viewmodels.colour_images import hue_histogram, pixel_hsv
from app.viewmodels.colour_tuning import ProfileHistory, Tuned, with_range
from app.viewmodels.colours import hue_rows, seen_rows
from app.viewmodels.hand_scene import HandSceneModel, segment_states
from app.viewmodels.recording import duration_text, position_text
from app.viewmodels.sensors import imu_states
from app.viewmodels.states import BAD, WARN
from app.viewmodels.status import fields, tracking_look
from app.widgets.image_shapes import Crosses, Ellipses, ImageLines, Rings
from app.widgets.view3d.orbit import Orbit
from resources import folder
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, models, scripted_setup, with_camera
from tracker.engine.kinds import engine_kinds
from tracker.glove import library
from tracker.messages import Status, Tracking, Validity
from tracker.sensors.link_figures import LinkFigures
from tracker.vision.lenses import with_one_camera


@pytest.fixture
def view(qapp):
    host = EngineHost(TaskOwner())
    host.adopt(scripted_setup(ScriptedEngine()))
    yield host.snapshot()
    host.shut_down()


def test_every_blob_has_a_ring_which_is_solid_if_matched(view):
    shapes = overlay(view, Layers(skeleton=False, residuals=False), {}, right=False)
    (rings,) = (s for s in shapes if isinstance(s, Rings))
    assert len(rings.uv) == len(rings.colours) == len(view.blobs.left)
    matched = set(view.result.match_left[view.result.match_left >= 0].tolist())
    assert set(np.flatnonzero(~rings.dashed).tolist()) == matched
    np.testing.assert_array_equal(rings.uv, view.blobs.left.uv)


def test_the_ellipse_is_two_sigma_of_the_covariance(view):
    shapes = overlay(view, Layers(blobs=False, skeleton=False), {}, right=False)
    (ellipses,) = (s for s in shapes if isinstance(s, Ellipses))
    assert len(ellipses.uv)
    np.testing.assert_allclose(ellipses.axes, np.tile([8.0, 4.0], (len(ellipses.uv), 1)))
    # cov is diag(16, 4) px²
    np.testing.assert_allclose(np.sin(ellipses.angle), 0.0, atol=1e-9)


def test_the_right_image_has_no_ellipses_since_none_is_known(view):
    shapes = overlay(view, Layers(), {}, right=True)
    assert not any(isinstance(s, Ellipses) for s in shapes)


def test_residuals_join_prediction_and_blob(view):
    only = Layers(blobs=False, rejected=False, predicted=False, skeleton=False)
    (lines,) = overlay(view, only, {}, right=False)
    assert isinstance(lines, ImageLines)
    marker = int(np.flatnonzero(view.result.match_left >= 0)[0])
    blob = view.blobs.left.uv[view.result.match_left[marker]]
    np.testing.assert_allclose(lines.ends[0], [*view.result.predicted_left[marker], *blob])


def test_unlikely_markers_are_dimmed(view):
    shapes = overlay(view, Layers(blobs=False, rejected=False, skeleton=False), {}, right=False)
    crosses = [s for s in shapes if isinstance(s, Crosses)]
    full = sum(len(s.uv) for s in crosses if s.opacity == 1.0)
    assert full == int((view.result.visible >= 0.5).sum())
    assert full < sum(len(s.uv) for s in crosses)


def test_a_lost_keypoint_takes_its_bones_away(view):
    nothing = dataclasses.replace(
        view.estimate_at_frame, keypoints=np.full_like(view.estimate.keypoints, np.nan)
    )
    blind = dataclasses.replace(view, estimate_at_frame=nothing)
    only = Layers(blobs=False, rejected=False, predicted=False, residuals=False)
    assert overlay(view, only, {}, right=False)
    assert overlay(blind, only, {}, right=False) == []


def test_segments_show_the_worst_state_of_their_joint(view):
    hand = view.setup.hand
    states = segment_states(hand, view.estimate, located=True)
    assert states[hand.index["ring_proximal"]] == Validity.INFERRED
    assert states[hand.index["index_proximal"]] == Validity.MEASURED
    lost = segment_states(hand, view.estimate, located=False)
    assert lost[0] == Validity.LOST
    assert lost[hand.index["index_proximal"]] == Validity.MEASURED, "bent as its IMUs say"


def test_a_hand_whose_position_is_lost_stays_where_it_was(view):
    model = HandSceneModel(view.setup)
    seen = model.scene(view)
    gone = dataclasses.replace(
        view.estimate,
        tracking=Tracking.LOST,
        segment_p=np.full_like(view.estimate.segment_p, np.nan),
    )
    scene = model.scene(dataclasses.replace(view, estimate=gone))
    assert np.array_equal(scene.segment_p, seen.segment_p)
    assert "lost" in scene.caption and not seen.caption


def test_two_hands_without_positions_are_drawn_apart(view):
    """Gloves alone: each on its own side, as hands are held."""
    placeless = dataclasses.replace(
        view, estimate=dataclasses.replace(view.estimate, tracking=Tracking.LOST)
    )
    alone, right = HandSceneModel(view.setup), HandSceneModel(view.setup, of_two=True)
    assert not alone.scene(placeless).segment_p[0].any()
    left_glove = dataclasses.replace(view.setup.glove, side="left")
    left = HandSceneModel(dataclasses.replace(view.setup, glove=left_glove), of_two=True)
    roots = [model.scene(placeless).segment_p[0] for model in (left, right)]
    assert (roots[0] - roots[1]).tolist() == pytest.approx([0.0, 0.18, 0.0])
    assert right.scene(view).segment_p[0].tolist() == view.estimate.segment_p[0].tolist()


def test_no_hand_is_drawn_before_there_is_one(view):
    unknown = dataclasses.replace(
        view.estimate, segment_p=np.full_like(view.estimate.segment_p, np.nan)
    )
    assert HandSceneModel(view.setup).scene(dataclasses.replace(view, estimate=unknown)) is None


def test_undo_and_redo_walk_the_same_steps():
    profile = models()[2]
    history = ProfileHistory(Tuned(profile))
    second = with_range(profile, dataclasses.replace(profile.hues[0], value=(10, 255)))
    third = with_range(second, dataclasses.replace(second.hues[1], value=(20, 255)))
    history.change(Tuned(second))
    history.change(Tuned(third))
    assert history.undo() and history.profile == second
    assert history.undo() and history.profile == profile
    assert not history.undo()
    assert history.redo() and history.redo() and history.profile == third
    history.undo()
    history.change(Tuned(profile))
    assert not history.redo()


def test_a_dragged_slider_is_one_step_back():
    profile = models()[2]
    history = ProfileHistory(Tuned(profile))
    for i, low in enumerate((50, 60, 70)):
        changed = dataclasses.replace(profile.hues[0], value=(low, 255))
        history.change(Tuned(with_range(profile, changed)), merge=i > 0)
    history.undo()
    assert history.profile == profile


def test_overlapping_hues_are_named_with_how_much():
    profile = models()[2]
    wide = with_range(profile, dataclasses.replace(profile.hues[1], hue=(5, 39)))
    rows = {r.name: r.clash for r in hue_rows(wide)}
    assert rows["red"] == "overlaps yellow (30 %)"  # 5..11 of the 23 hues 169..11
    assert rows["yellow"] == "overlaps red (30 %)"
    assert rows["blue"] == ""
    assert not any(r.clash for r in hue_rows(profile))


def test_blob_counts_per_hue_are_means_over_both_images(view):
    rows = {r.name: r for r in seen_rows(view, view.setup.profile)}
    index = view.blobs.hue_names.index("red")
    both = (view.blobs.left.hue == index).sum() + (view.blobs.right.hue == index).sum()
    assert rows["red"].count.startswith(f"{both / 2:g} of ")
    red = [m.id for m in view.setup.glove.markers if m.hue == "red"]
    assert rows["red"].tip.endswith(f"{view.result.visible[red].sum():.0f} expected")


@pytest.mark.parametrize(
    ("found", "expected", "count", "warns"),
    [
        (4.0, 5.2, "4 of about 5", False),
        (4.5, 4.4, "4 of about 4", False),  # halves are of two images: no half marker is shown
        (3.0, 2.0, "3 of about 2", False),  # one more than expected is not an error
        (11.0, 4.0, "11 of about 4", True),
        (1.0, 4.0, "1 of about 4", True),
        (4.0, 0.2, "4", True),  # never "4 of 0"
        (4.0, None, "4", False),  # nothing is expected while nothing is tracked
        (None, None, "–", False),
    ],
)
def test_counts_can_be_understood(found, expected, count, warns):
    profile = models()[2]
    row = hue_rows(
        profile,
        {"red": found} if found is not None else None,
        {"red": expected} if expected is not None else None,
    )[[h.name for h in profile.hues].index("red")]
    assert row.count == count
    assert (row.look == WARN) is warns


def test_histogram_peaks_at_the_hue_that_is_there():
    hsv = np.zeros((80, 80, 3), np.uint8)
    hsv[..., 2] = 200
    hsv[:40] = (65, 220, 200)
    histogram = hue_histogram(cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR))
    assert abs(int(histogram.argmax()) - 65) <= 1
    assert histogram[100:].max() == 0


def test_eyedropper_reads_the_colour_under_it():
    image = frame_and_blobs(30)[0].left
    hsv = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
    v, u = np.unravel_index(int(hsv[..., 1].argmax()), hsv.shape[:2])
    h, _, _ = pixel_hsv(image, float(u), float(v))
    assert min((h - int(hsv[v, u, 0])) % 180, (int(hsv[v, u, 0]) - h) % 180) < 8


def test_convergence_runs_from_prior_to_settled():
    start, end = RANGES["scale"]
    assert convergence(np.array([start]), "scale") == pytest.approx(0.0)
    assert convergence(np.array([end]), "scale") == pytest.approx(1.0)
    middle = np.sqrt(start * end)
    assert convergence(np.array([middle, end]), "scale") == pytest.approx(0.5)
    assert np.isnan(convergence(np.array([np.nan]), "scale"))


def test_calibration_in_peoples_units():
    shown = calibration_view(ScriptedEngine().calibration())
    assert shown.hand_length == "187.4 ± 3.0 mm"
    scale, mounting, gyro, accel = shown.rows[0].cells
    assert scale.text == "1.030 ± 0.02"
    assert mounting.text.startswith(f"{np.rad2deg(0.05 * np.sqrt(3)):.1f} ± 8")
    assert gyro.text.endswith("°/s")
    assert accel.text == "" and np.isnan(accel.convergence)
    assert "Bend" in shown.advice  # the mounting is what is farthest from settled


def test_a_camera_alone_reports_no_hand():
    values = {"frame_rate_hz": 15.0, "estimate_rate_hz": 15.0, "imu_rate_hz": 0.0}
    hand = {f.key: f for f in fields(Status(0.0, Tracking.SEARCHING, values))}["estimate_rate_hz"]
    assert hand.text == "–"
    both = {f.key: f for f in fields(Status(0.0, Tracking.TRACKING, values))}["estimate_rate_hz"]
    assert both.text == "15 Hz"


def test_with_one_camera_the_hands_length_is_asked_for_and_not_motion():
    engine = ScriptedEngine()
    stranger = dataclasses.replace(engine.calibration(), hand_length_sd=0.05 * 0.187)
    stranger = dataclasses.replace(stranger, scale_sd=np.full_like(stranger.scale_sd, 0.05))
    assert "Spread" in calibration_view(stranger).advice
    assert "Hand length…" in calibration_view(stranger, one_camera=True).advice
    setup = scripted_setup(engine)
    setup = with_camera(setup, rig=with_one_camera(setup.camera.rig))
    view = Snapshot(setup, running=True, calibration=stranger)
    step = next(s for s in steps(view) if s.name == "Calibration settled")
    assert "ruler" in step.reason and step.command == "show_calibration"
    # an infrared camera beside the colour one is none for markers
    for in_both, words in ((0.0, "ruler"), (12.0, "Spread")):
        now = Status(1.0, Tracking.TRACKING, {"stereo_points": in_both})
        beside = Snapshot(scripted_setup(engine), running=True, calibration=stranger, status=now)
        assert words in next(s for s in steps(beside) if s.name == "Calibration settled").reason
    ruler = dataclasses.replace(stranger, hand_length_sd=0.015 * 0.187)
    ruler = dataclasses.replace(ruler, scale_sd=np.full_like(stranger.scale_sd, 0.015))
    assert "Bend" in calibration_view(ruler, one_camera=True).advice


def test_a_silent_imu_is_found():
    samples = list(ScriptedEngine().recent_imu())
    valid = samples[0].valid.copy()
    valid[3] = False
    silent = [dataclasses.replace(s, valid=valid) for s in samples]
    states = imu_states(models()[1].imu_names, silent, running=True)
    assert [s.text for s in states].count("not responding") == 1
    assert states[3].text == "not responding"


def test_lost_packets_are_a_problem_and_nothing_known_is_a_dash():
    values = {"imu_lost": 3.0, "frames_dropped": 0.0, "imu_rate_hz": 99.6}
    shown = {f.key: f for f in fields(Status(0.0, Tracking.TRACKING, values))}
    assert shown["losses"].look.word == "problem"
    assert shown["imu_rate_hz"].text == "100 Hz"
    assert shown["latency"].text == "–"


@pytest.mark.parametrize(("millivolt", "low"), [(3499, True), (3500, False)])
def test_a_low_battery_is_a_warning_by_the_links_own_threshold(millivolt, low):
    values = {"imu_rate_hz": 100.0, **LinkFigures(battery_mV=millivolt).values()}
    shown = fields(Status(0.0, Tracking.TRACKING, values))[0]
    assert (shown.look.word, shown.text) == (
        ("attention", "100 Hz, battery low") if low else ("good", "100 Hz")
    )
    assert ("3.50 V" in shown.tip) == low


def test_omitted_work_on_a_slow_computer_is_reported():
    def shown(level: float):
        return fields(Status(0.0, Tracking.TRACKING, {"load_shed": level}))[-1]

    assert shown(0.0).text == shown(0.0).name == ""
    assert (shown(1.0).name, shown(1.0).text) == ("System overloaded:", "3D view slower")
    assert shown(4.0).text == (
        "3D view slower, overlays off, full-frame search off, fewer images searched"
    )
    assert shown(4.0).short == "Overloaded"
    assert shown(3.0).look.word == "attention" and len(shown(3.0).tip.splitlines()) == 3


@pytest.mark.parametrize("seconds", [0.0, 0.994, 0.996, 23.994, 23.996, 59.999, 3599.996, 3661.2])
def test_a_length_and_a_position_agree_on_the_second(seconds):
    assert position_text(seconds).rpartition(".")[0] == duration_text(seconds)


def test_engines_and_bones_have_names_for_people():
    assert names.engine_name("vist") == "VIST"
    assert names.engine_name("not-installed") == "not-installed"
    assert all(kind.short for kind in engine_kinds().values())
    segments = {imu for glove in library.names("gloves") for imu in imus_of(glove)}
    assert segments and segments <= set(names.BONES)


def imus_of(glove: str) -> set[str]:
    text = (folder("gloves") / f"{glove}.toml").read_text("utf-8")
    return {imu["segment"] for imu in tomllib.loads(text)["imu"]}


def test_each_stage_has_its_latency():
    values = {"latency_total_ms": 7.8, "latency_total_p99_ms": 24.3, "latency_detect_ms": 1.01}
    shown = {f.key: f for f in fields(Status(0.0, Tracking.TRACKING, values))}["latency"]
    assert shown.text == "8 ms (99 %: 24)"
    assert "Search of both images: 1.0 ms (–)" in shown.tip
    assert "Arrival of an image to its estimate: 7.8 ms (24.3 ms)" in shown.tip


def test_orbit_keeps_its_distance_and_looks_at_its_target():
    orbit = Orbit()
    orbit.target = np.array([0.2, 0.0, 0.1])
    orbit.turn(0.7, -0.4)
    assert np.linalg.norm(orbit.eye - orbit.target) == pytest.approx(orbit.distance)
    assert orbit.up @ orbit.direction == pytest.approx(0.0, abs=1e-12)
    orbit.look_from(np.array([1.0, 2.0, 0.5]))
    assert np.cross(orbit.direction, [1.0, 2.0, 0.5]) == pytest.approx(np.zeros(3), abs=1e-12)


def test_tracking_is_not_reported_without_data():
    """The state is that of the last message."""
    silent = {"imu_rate_hz": 0.0, "frame_rate_hz": 0.0}
    shown_look = tracking_look(Status(5.0, Tracking.TRACKING, silent), True)
    assert (shown_look.word, shown_look.sign) == ("No data", BAD.sign)
    half = Status(5.0, Tracking.TRACKING, {**silent, "imu_rate_hz": 100.0})
    assert tracking_look(half, True).word == "Tracking"
    assert tracking_look(Status(0.0, Tracking.SEARCHING, {}), True).word != "No data"


def test_a_camera_alone_searches_for_no_hand():
    alone = {"frame_rate_hz": 30.0}
    assert (
        tracking_look(Status(5.0, Tracking.SEARCHING, alone), True).word == "No data from the glove"
    )
    silent = {**alone, "imu_rate_hz": 0.0}
    assert (
        tracking_look(Status(5.0, Tracking.SEARCHING, silent), True).word
        == "No data from the glove"
    )
    both = {**alone, "imu_rate_hz": 100.0}
    assert tracking_look(Status(5.0, Tracking.SEARCHING, both), True).word.startswith("Searching")
