"""Films: the chosen views side by side, encoded by the system's ffmpeg if there is one."""

import shutil
import stat
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from extensions.interchange import overlay
from extensions.interchange.overlay import PLAIN, H264Film, open_film
from extensions.interchange.views import CurvesView, HandView, side_by_side
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.base.files import DiskError
from tracker.messages import CameraPose, Estimate
from tracker.session.description import SessionInfo
from tracker.session.export.options import VIEWS, ExportOptions
from tracker.session.export.run import export
from tracker.session.export.series import series_of
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import ideal_rig

SIZE = 320, 240
IMAGES = 8
ENCODER = "libx264", ["-crf", "20"]


@pytest.fixture
def about(session_info: SessionInfo) -> SessionInfo:
    pose = CameraPose(np.diag([1.0, -1, -1]), np.array([0.08, 0, 0.45]))
    return replace(session_info, rig=replace(ideal_rig(*SIZE), pose=pose))


@pytest.fixture
def session(tmp_path: Path, about: SessionInfo, maker) -> Path:
    """A bending hand in front of grey images."""
    hand, grey = about.hand, np.full((SIZE[1], SIZE[0], 3), 90, np.uint8)
    path = tmp_path / "in.mcap"
    with SessionRecorder(path, about) as recorder:
        for k in range(IMAGES):
            angles = np.clip(0.1 * k, *hand.angle_limits.T)
            R, p = hand.forward(angles, np.eye(3), np.zeros(3))
            points = about.glove.keypoint_positions(hand, R, p)
            e: Estimate = maker.estimate(30.0 * k)
            recorder.write(replace(e, keypoints=points, angles=angles, segment_R=R, segment_p=p))
            recorder.write(replace(maker.image(30.0 * k, k), left=grey, right=grey.copy()))
    return path


@pytest.mark.long
def test_a_film_has_what_is_chosen_side_by_side(session: Path, about: SessionInfo) -> None:
    out = session.with_name("o.mp4")
    said = export(session, "mp4", out, ExportOptions(views=VIEWS))
    video = cv2.VideoCapture(str(out))
    assert video.get(cv2.CAP_PROP_FRAME_COUNT) == IMAGES and said["views"] == list(VIEWS)
    images = [video.read()[1] for _ in range(IMAGES)]
    w, h = SIZE
    assert images[0].shape == (2 * h, 2 * w, 3)
    left, right = images[-1][:h, :w], images[-1][:h, w:]
    rig = about.rig
    assert rig is not None
    with SessionReader(session) as reader:
        *_, last = (m for m in reader.messages((Estimate,)) if isinstance(m, Estimate))
    p_C = (last.keypoints[0] - rig.pose.p_GC) @ rig.pose.R_GC
    for image, side in ((left, False), (right, True)):
        u, v = np.round(rig.project(p_C[None], right=side)[0]).astype(int)
        assert image[v, u, 1] > 130, "the wrist is green where that camera sees it"
        assert abs(int(image[5, 5, 0]) - 90) < 12
    hand, curves = images[-1][h:, :w], images[-1][h:, w:]
    assert 0.02 < (hand[..., 2] > 100).mean() < 0.6
    assert not np.array_equal(images[0][h:, w:], curves)


def test_inferred_parts_of_the_hand_have_another_colour_and_a_lost_hand_is_not_drawn(
    about: SessionInfo, session: Path
) -> None:
    with SessionReader(session) as reader:
        estimates = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
        unsure = replace(estimates[0], keypoint_state=np.ones_like(estimates[0].keypoint_state))
        lost = replace(estimates[0], segment_p=np.full_like(estimates[0].segment_p, np.nan))
        m = series_of(about, [estimates[0], unsure, lost])
        view = HandView(reader, replace(m, notes={"axes": "z-up"}), SIZE)
        frame = None
        sure, inferred, gone = (view.draw(frame, k) for k in range(3))  # type: ignore[arg-type]
    assert sure is not None and inferred is not None and gone is not None
    drawn = inferred[..., 2] > 100
    assert (drawn & (inferred[..., 0] < 100)).sum() > 0.8 * drawn.sum()
    assert (drawn & (sure[..., 0] > inferred[..., 0])).sum() > 0.8 * drawn.sum()
    assert (gone[60:, :, 2] > 100).sum() == 0


def test_curves_stop_where_an_angle_is_lost(about: SessionInfo, session: Path) -> None:
    with SessionReader(session) as reader:
        estimates = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
    gone = replace(estimates[-1], angles=np.full_like(estimates[-1].angles, np.nan))
    view = CurvesView(series_of(about, [*estimates[:-1], gone]), SIZE)
    whole, cut = view.draw(None, IMAGES - 2), view.draw(None, IMAGES - 1)  # type: ignore[arg-type]
    assert whole is not None and cut is not None
    assert not np.array_equal(whole, cut)


def test_views_are_laid_out_in_rows_of_two_at_the_first_ones_size() -> None:
    cells = [np.full((20 + k, 30, 3), 40 * k + 40, np.uint8) for k in range(3)]
    both = side_by_side(cells[:2])
    assert both is not None and both.shape == (20, 60, 3)
    three = side_by_side([*cells])
    assert three is not None and three.shape == (40, 60, 3)
    assert three[25, 5, 0] == 120 and three[25, 45, 0] == 0
    assert side_by_side([None, cells[0]]) is None


def test_unknown_views_are_refused() -> None:
    with raises(ConfigError, "export.views"):
        ExportOptions(views=("behind",))


def program(folder: Path, script: str) -> None:
    path = folder / "ffmpeg"
    path.write_text(f"#!{sys.executable}\n{script}")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)


def test_images_are_passed_to_ffmpeg_unchanged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program(
        tmp_path,
        "import sys\n"
        "if '-encoders' in sys.argv: print(' V....D libopenh264 H.264'); sys.exit()\n"
        "open(sys.argv[-1], 'wb').write(sys.stdin.buffer.read())\n",
    )
    monkeypatch.setenv("PATH", str(tmp_path))
    rng = np.random.default_rng(1)
    images = rng.integers(0, 255, (5, 12, 16, 3), dtype=np.uint8)
    made = open_film(tmp_path / "a.mp4", 30.0, images[0])
    assert made.codec == "H.264 (libopenh264)"
    for image in images:
        made.write(image[:, ::-1])
    made.close()
    assert (tmp_path / "a.mp4").read_bytes() == images[:, :, ::-1].tobytes()


def test_the_message_of_an_ffmpeg_that_ends_early_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program(tmp_path, "import sys\nsys.exit('no space left')")
    monkeypatch.setenv("PATH", str(tmp_path))
    image = np.zeros((400, 400, 3), np.uint8)
    made = H264Film(tmp_path / "a.mp4", 30.0, image, ENCODER)
    with raises(DiskError, "film.ffmpeg_failed_why"):
        for _ in range(100):
            made.write(image)


def test_without_ffmpeg_the_film_is_mpeg4_and_this_is_reported(
    session: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(overlay.shutil, "which", lambda name: None)
    said = export(session, "mp4", session.with_name("o.mp4"))
    assert said["codec"] == PLAIN and "ffmpeg with H.264 is not installed" in said["said"][0]


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="no ffmpeg")
def test_a_real_ffmpeg_makes_h264(session: Path) -> None:
    said = export(session, "mp4", session.with_name("o.mp4"))
    assert said["codec"].startswith("H.264")
    video = cv2.VideoCapture(str(session.with_name("o.mp4")))
    fourcc = int(video.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little")
    assert fourcc in (b"h264", b"avc1")
