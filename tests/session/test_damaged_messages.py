"""One damaged message costs only that message: it is skipped, counted and named everywhere."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.damaged_sessions import Spoil, cut_message, spoilt
from tests.notices import shows
from tracker.cli import main
from tracker.messages import Estimate, ImuSample, StereoFrame
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.images import check_image, encode_image
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import sensors
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

RIGHT = "/camera/right/image/compressed"


def cut_image(m: RawMessage) -> bytes:
    image = sensors.unpack_image(m.data)
    return sensors.pack_image(image._replace(data=image.data[: len(image.data) // 2]))


def cut_png(m: RawMessage) -> bytes:
    image = sensors.unpack_image(m.data)
    pixels = cv2.imdecode(np.frombuffer(image.data, np.uint8), cv2.IMREAD_COLOR)
    data = encode_image(np.asarray(pixels, np.uint8), "png", 0)
    return sensors.pack_image(image._replace(format="png", data=data[:-1000]))


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Images, packets, blobs and estimates of a second and a half."""
    folder = tmp_path_factory.mktemp("damaged")
    simulate(folder / "in.mcap", SimulateOptions(seed=3, duration=1.5, fps=20, scene="plain"))
    track(folder / "in.mcap", folder / "all.mcap", TrackOptions("chain", with_sensors=True))
    return folder / "all.mcap"


@pytest.fixture(scope="module")
def images(session: Path) -> Path:
    """Images and packets alone."""
    return session.with_name("in.mcap")


@pytest.mark.parametrize("spoil", [cut_message, cut_image, cut_png])
def test_a_session_with_one_damaged_image_is_tracked_without_it(
    images: Path, tmp_path: Path, spoil: Spoil, capsys: pytest.CaptureFixture[str]
) -> None:
    path = spoilt(images, tmp_path / "a.mcap", [RIGHT], spoil, nth=20)
    out, report = tmp_path / "b.mcap", tmp_path / "track.json"
    assert main(["track", str(path), "-o", str(out), "--json", str(report)]) == 0
    assert shows(capsys.readouterr().err, "session.messages_damaged", topics=f"1 on {RIGHT}")
    assert json.loads(report.read_text())["left_out"] == {RIGHT: 1}
    with SessionReader(out) as tracked, SessionReader(path) as reader:
        assert sum(1 for _ in tracked.messages((Estimate,))) > 130
        frames = [m for m in reader.messages((StereoFrame,)) if isinstance(m, StereoFrame)]
        assert len(frames) == 30
        assert [i for i, f in enumerate(frames) if f.right is None] == [19]
        assert all(f.left is not None for f in frames)


@pytest.mark.parametrize(
    ("name", "roots"),
    [("all.mcap", {"glove", "camera", "hand"}), ("in.mcap", {"glove", "camera", "truth"})],
)
def test_every_topic_may_have_a_damaged_message(
    session: Path, tmp_path: Path, name: str, roots: set[str]
) -> None:
    source = session.with_name(name)
    with SessionReader(source) as reader:
        counts = Counter(m.topic for m in ordered(reader.source))
        plain = sum(1 for _ in reader.messages((Estimate,)))
    many = sorted(topic for topic, n in counts.items() if n >= 5)
    assert {t.split("/")[1] for t in many} >= roots
    path = spoilt(source, tmp_path / "a.mcap", many, cut_message)
    found = {f.where: f.what for f in verify(path) if f.severity == "error"}
    assert sorted(found) == many
    assert {(what.code, what.values["count"]) for what in found.values()} == {
        ("check.damaged_messages", 1)
    }
    with SessionReader(path) as reader:
        estimates = [m for m in reader.messages() if isinstance(m, Estimate)]
        list(reader.truth())
        assert sorted(reader.source.left_out.by_topic()) == many
    assert len(estimates) == max(plain - 1, 0)
    track(path, tmp_path / "b.mcap", TrackOptions("chain"))


def test_the_position_of_damage_is_reported(session: Path, tmp_path: Path) -> None:
    path = spoilt(session, tmp_path / "a.mcap", [RIGHT], cut_image, nth=21)
    (error,) = [f for f in verify(path) if f.severity == "error"]
    at = float(str(error.what.values["at"]).split()[0])
    assert error.where == RIGHT and at == pytest.approx(1.0, abs=0.1)


def test_a_packet_with_a_damaged_imu_lacks_that_imu(session: Path, tmp_path: Path) -> None:
    with SessionReader(session) as reader:
        topic = next(t for t in sorted(reader.topic_names) if "/imu/" in t)
        names = reader.info.glove.imu_names
    path = spoilt(session, tmp_path / "a.mcap", [topic], cut_message, nth=30)
    with SessionReader(path) as reader:
        samples = [m for m in reader.messages((ImuSample,)) if isinstance(m, ImuSample)]
    missing = [(i, names[k]) for i, s in enumerate(samples) for k in np.flatnonzero(~s.valid)]
    assert missing == [(29, topic.rsplit("/", 1)[1])]


@pytest.mark.parametrize(
    "words",
    [
        ["export", "--format", "csv", "-o", "{out}.csv"],
        ["export", "--format", "mp4", "-o", "{out}.mp4"],
        ["export", "--format", "mcap", "-o", "{out}.mcap"],
        ["light"],
        ["report", "-o", "{out}.html"],
        ["crop", "-o", "{out}.mcap", "--start", "0.5"],
        ["recover", "-o", "{out}.mcap"],
        ["colours", "check"],
    ],
    ids=lambda words: " ".join(words[:3]),
)
def test_commands_continue_and_report_skipped_messages(
    session: Path, tmp_path: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    damaged = ["/camera/left/image/compressed", RIGHT, "/hand/right/keypoints"]
    damaged += ["/hand/right/joint_states", "/tracker/status", "/camera/left/blobs"]
    path = spoilt(session, tmp_path / "a.mcap", damaged, cut_message, nth=2)
    out = tmp_path / "out"
    filled = [w.replace("{out}", str(out)) for w in words]
    at = 2 if words[0] == "colours" else 1
    assert main([*filled[:at], str(path), *filled[at:]]) == 0
    assert shows(capsys.readouterr().err, "session.messages_damaged", file="a.mcap")
    made = tmp_path / "out.mcap"
    if made.exists():
        assert is_ok(verify(made))


def test_undamaged_messages_are_not_reported() -> None:
    rng = np.random.default_rng(3)
    image = rng.integers(0, 255, (48, 64, 3), np.uint8)
    progressive = [cv2.IMWRITE_JPEG_PROGRESSIVE, 1, cv2.IMWRITE_JPEG_RST_INTERVAL, 2]
    _, several = cv2.imencode(".jpg", image, progressive)
    kinds = [encode_image(image, "jpeg", 90), encode_image(image, "png", 0), several.tobytes()]
    for data in kinds:
        check_image(data, "left")
        check_image(data + bytes(100), "left")  # some cameras fill their buffers up
