"""An accuracy report states the errors that were put in."""

from __future__ import annotations

import html.parser
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from extensions.reference.accuracy import ALL, MULTIPLES, expected, headline, measure, summary
from extensions.reference.angles import angles_of
from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.pairs import Pairs, anonymized, read_pairs
from extensions.reference.tests.conftest import Wearer
from extensions.reference.tests.laboratory import Laboratory, write_c3d
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.hand.names import FINGERS
from tracker.messages import Array, Validity

pytestmark = pytest.mark.long

NOISE = 0.002  # m per coordinate


@pytest.fixture(scope="module")
def referenced(wearer: Wearer, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """20 s with noise of 2 mm, and a perfect reference in the session's own frame and time."""
    folder = tmp_path_factory.mktemp("accuracy")
    session = wearer.session(folder / "s.mcap", NOISE, duration=20.0, person="Ann & co")
    _, x_L = Laboratory().record(wearer, 20.0)
    path = write_c3d(folder / "lab.c3d", wearer.info.keypoint_names, x_L)
    start = "2025-01-01T00:00:00.500+00:00"
    options = ReferenceImportOptions(by="clock", start=start, register="none")
    import_reference(path, session, folder / "with.mcap", options)
    return folder / "with.mcap"


@pytest.fixture(scope="module")
def pairs(referenced: Path) -> Pairs:
    return read_pairs(referenced)[0]


def test_the_noise_is_the_rmse_and_the_claimed_sd_is_right(pairs: Pairs) -> None:
    """2000 instants of 21 points: the rms of a coordinate is known to 1/√(2·126000) ≈ 0.2 %, a
    share of 42 000 distances to 0.24 %, a keypoint's rms to 0.9 %; four of each."""
    found = measure(pairs)
    assert found.whole.rmse == pytest.approx(np.sqrt(3) * NOISE, rel=0.008)
    assert found.whole.rmse_ci[0] < np.sqrt(3) * NOISE < found.whole.rmse_ci[1]
    for row in found.points:
        assert row.rmse == pytest.approx(np.sqrt(3) * NOISE, rel=0.04), row.name
        assert row.rmse == row.rmse_rigid  # no offsets were estimated
    assert_allclose(found.calibration, expected(), atol=0.01)
    assert found.nees == pytest.approx(1.0, abs=0.02)
    assert expected([1.0])[0] == pytest.approx(0.6084, abs=1e-4)  # χ²₃(3)
    index = found.point("index_tip")
    assert index.n_effective > 0.8 * index.n  # noise without correlation
    assert index.axes[0].high == pytest.approx(1.96 * NOISE, rel=0.1)
    assert index.icc.value > 0.99


def test_a_bias_in_the_hand_s_axes_is_that_bias(pairs: Pairs) -> None:
    """2000 instants: 2 mm / √2000 ≈ 0.045 mm; four of them."""
    d_H = np.array([0.001, -0.004, 0.002])
    shifted = pairs.ours + np.einsum("nij,j->ni", pairs.R_GH, d_H)[:, None]
    found = measure(replace(pairs, ours=shifted))
    for row in found.points:
        assert_allclose([a.bias for a in row.axes], d_H, atol=1.8e-4)
    within = [a.bias_ci[0] < v < a.bias_ci[1] for r in found.points[:-1]
              for a, v in zip(r.axes, d_H, strict=True)]  # fmt: skip
    assert np.mean(within) > 0.85  # of 63 intervals of 95 %
    assert found.nees > 2.0 and found.calibration[MULTIPLES.index(1.0)] < 0.4


def test_errors_by_speed_state_and_the_worst_instants(pairs: Pairs) -> None:
    """Errors that grow with the speed, five times as large where inferred, and one of 80 mm."""
    rng = np.random.default_rng(6)
    unit = rng.normal(size=pairs.ours.shape)
    unit /= np.linalg.norm(unit, axis=2, keepdims=True)
    occluded = np.arange(len(pairs.t))[:, None] % 10 < 3
    state = np.where(occluded, int(Validity.INFERRED), int(Validity.MEASURED))
    state = np.broadcast_to(state, pairs.state.shape)
    size = 0.001 + 0.01 * np.nan_to_num(pairs.speed)
    size = np.where(state == Validity.INFERRED, 5 * size, size)
    k, row = pairs.names.index("ring_tip"), 777
    size[row, k] = 0.08
    ours = pairs.theirs + size[:, :, None] * unit
    found = measure(replace(pairs, ours=ours, state=state))
    worst = found.worst[0]
    assert (worst.keypoint, worst.t) == ("ring_tip", pairs.t[row])
    assert worst.error == pytest.approx(0.08) and len(found.worst) == 10
    times = sorted(w.t for w in found.worst)
    assert np.diff(times).min() >= 0.5 - 1e-9
    states = {b.name: b for b in found.states}
    assert states["inferred"].share == pytest.approx(0.3, abs=0.01)
    assert states["inferred"].rmse == pytest.approx(5 * states["measured"].rmse, rel=0.1)
    rms = [b.rmse for b in found.speeds]
    assert len(rms) >= 4 and np.all(np.diff(rms) > 0)
    assert sum(b.share for b in found.speeds) == pytest.approx(1.0, abs=0.01)


def test_joint_angles_of_the_truth_are_the_session_s(wearer: Wearer) -> None:
    """With one angle moved and the fingers' rest axes parallel to the hand's, PIP and DIP flexion
    are exactly those of the model; MCP angles differ by the tilt of the plane of the MCP joints."""
    hand = wearer.info.hand
    rng = np.random.default_rng(2)
    for _ in range(20):
        angles = rng.uniform(*(hand.angle_limits.T * 0.6))
        R, p = hand.forward(angles, np.eye(3), np.zeros(3))
        x = hand.keypoints(R, p)[None]
        found = angles_of(hand.keypoint_names, x, "right")
        for finger in FINGERS:
            for joint in ("pip", "dip"):
                name = f"{finger}_{joint}_flexion"
                true = angles[hand.angle_index[name]]
                assert found[name][0] == pytest.approx(true, abs=np.deg2rad(1.5)), name
            name = f"{finger}_mcp_flexion"
            true = angles[hand.angle_index[name]]
            assert found[name][0] == pytest.approx(true, abs=np.deg2rad(8.0)), name
        moved = so3_random(rng)
        again = angles_of(hand.keypoint_names, x @ moved.T + 1.0, "right")
        for name, value in found.items():
            assert_allclose(again[name], value, atol=1e-9)


def so3_random(rng: np.random.Generator) -> Array:
    from tracker.geometry import so3

    return so3.exp(rng.normal(size=3))


def test_a_left_hand_has_the_angles_of_its_mirror_image(wearer: Wearer) -> None:
    hand = wearer.info.hand
    angles = 0.5 * hand.angle_limits.max(axis=1)
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    x = hand.keypoints(R, p)[None]
    right = angles_of(hand.keypoint_names, x, "right")
    left = angles_of(hand.keypoint_names, x * [1.0, -1.0, 1.0], "left")
    for name in right:
        sign = -1.0 if name.endswith("abduction") else 1.0
        assert_allclose(left[name], sign * right[name], atol=1e-12)


def test_several_people_are_pooled(pairs: Pairs) -> None:
    """Three people with two recordings each, whose constant errors differ by construction."""
    measured = []
    for person, size in (("a", 0.001), ("b", 0.003), ("c", 0.005)):
        for more in (-0.0002, 0.0002):
            e = np.zeros_like(pairs.ours)
            e[:, :, 0] = size + more
            measured.append(measure(replace(pairs, person=person, ours=pairs.theirs + e)))
    row = next(r for r in summary(measured) if r.name == f"RMSE {ALL}").pooled
    assert (row.people, row.recordings) == (3, 6)
    assert row.mean == pytest.approx(3.0, abs=1e-6)
    assert row.within == pytest.approx(0.4 / np.sqrt(2), rel=1e-6)
    assert row.between == pytest.approx(np.sqrt(4.0 - 0.08 / 2), rel=1e-6)
    assert "6 simulated recordings of 3 people" in headline(measured)
    assert "3.0 mm" in headline(measured)
    hidden = anonymized([m.pairs for m in measured])
    assert {p.person for p in hidden} == {"person 1", "person 2", "person 3"}


class Page(html.parser.HTMLParser):
    """Collects cells and texts."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def test_the_command_writes_page_and_numbers(
    referenced: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, numbers = tmp_path / "r.html", tmp_path / "r.json"
    assert main(["accuracy", str(referenced), "-o", str(out), "--json", str(numbers)]) == 0
    said = capsys.readouterr().out
    found = json.loads(numbers.read_text())
    assert found["headline"] in said
    rmse = found["recordings"][0]["keypoints"][ALL]["rmse_mm"]
    assert rmse == pytest.approx(1e3 * np.sqrt(3) * NOISE, rel=0.01)
    page = Page()
    page.feed(out.read_text("utf-8"))
    assert f"{rmse:.2f}" in page.texts and found["headline"] in page.texts
    assert "Ann & co" in page.texts
    assert out.read_text("utf-8").count("<svg") == 2
    assert main(["accuracy", str(referenced), "-o", str(out)]) == 1  # it exists
    words = ["--anonymous", "--without-offsets", "--force"]
    assert main(["accuracy", str(referenced), "-o", str(out), *words]) == 0
    assert "Ann &" not in out.read_text("utf-8") and "with right" not in out.read_text("utf-8")


def test_a_session_without_a_reference_is_refused(short: Path, tmp_path: Path) -> None:
    with pytest.raises(FileError) as error:
        read_pairs(short)
    assert error.value.notice.code == "reference.none"
