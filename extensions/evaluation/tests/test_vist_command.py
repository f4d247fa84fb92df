"""`evaluate vist` from the command line on a small scale, and its parts."""

import argparse
import io
import json
from dataclasses import replace

import numpy as np
import pytest

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.sessions import blobs_of, people_of
from extensions.evaluation.vist.cases import (
    ABLATIONS,
    GUIDED,
    Case,
    in_outage,
    judged_in_outage,
    without_images,
    without_imus,
)
from extensions.evaluation.vist.command import cases_of, line_of, row_of
from extensions.evaluation.vist.metrics import Trial, summarise
from extensions.evaluation.vist.report import write_report
from extensions.evaluation.vist.run import ProgressBar, run_cases
from extensions.evaluation.vist.scenes import motion_of, simulation_of
from extensions.evaluation.vist.trial import meet_again, models, owners, run_trial
from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.cli import build_parser
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.hand.poses import POSES
from tracker.messages import BlobFrame, Blobs, ImuSample

ROW_KEYS = {
    "experiment", "engine", "ablation", "level", "participants", "mean_mm", "sd_mm",
    "within_sd_mm", "between_sd_mm", "ci95_mm", "pck20", "pck35", "keypoints", "matched_mean",
    "wrong_match_rate", "nees_per_dof", "core_s_per_s", "paper",
}  # fmt: skip


def parse(*words: str) -> argparse.Namespace:
    line = ["evaluate", "vist", *words]
    return build_parser(line).parse_args(line)


@pytest.mark.long
def test_a_small_run_writes_rows_figures_and_a_page(tmp_path, capsys):
    target, out = tmp_path / "rows.json", tmp_path / "report"
    args = parse(
        "--engines", "chain,vist", "--experiments", "free", "--participants", "1",
        "--minutes", "0.12", "--fps", "15", "--json", str(target), "--out", str(out),
    )  # fmt: skip
    assert args.command.start(args) == 0
    rows = json.loads(target.read_text())["rows"]
    assert [r["engine"] for r in rows] == ["chain", "vist"]
    for row in rows:
        assert set(row) >= ROW_KEYS
        assert 0 < row["mean_mm"] < 15
        assert row["paper"]["mean_mm"] == 10.69
        assert row["between_sd_mm"] is None  # there is none for one person
    page = (out / "report.html").read_text()
    assert "simulated" in page
    assert f"{rows[0]['mean_mm']:.2f}" in page
    assert (out / "free-pck.png").read_bytes().startswith(b"\x89PNG")
    assert "paper" in capsys.readouterr().out


def test_json_on_standard_output_is_json_alone(monkeypatch, capsys):
    monkeypatch.setattr("extensions.evaluation.vist.run.run_cases", lambda *a, **k: [])
    monkeypatch.setattr("extensions.evaluation.vist.command.cases_of", lambda args: [])
    args = parse("--json", "-")
    assert args.command.start(args) == 0
    assert json.loads(capsys.readouterr().out) == {"rows": []}


def test_ctrl_c_keeps_what_is_finished(monkeypatch, capsys, tmp_path):
    def interrupted(jobs, processes):
        index = jobs[0][0]
        yield index, a_trial(0)
        raise KeyboardInterrupt

    monkeypatch.setattr("extensions.evaluation.vist.run._results", interrupted)
    target = tmp_path / "rows.json"
    args = parse("--participants", "3", "--json", str(target), "--out", str(tmp_path))
    assert args.command.start(args) == 1
    (row,) = json.loads(target.read_text())["rows"]
    assert row["participants"] == 1
    assert row["mean_mm"] == pytest.approx(4.0)
    assert "Stopped after 1 of 18 trials" in capsys.readouterr().out
    assert (tmp_path / "report.html").is_file()


@pytest.mark.long
def test_variants_have_a_table_and_a_figure_of_their_own(tmp_path):
    cases = cases_of(parse("--experiments", "free", "--ablations", "loose,camera-imu"))
    results = [(case, [a_trial(0), a_trial(1)]) for case in cases]
    page = write_report(tmp_path, results, [row_of(*result) for result in results]).read_text()
    assert [c.experiment for c in cases] == ["free"] * 4 + ["head"] * 2
    assert "Variants, free motion" in page
    assert "Variants, camera on the head" in page
    assert page.count("segment poses from vision alone") == 2
    assert (tmp_path / "free-variants.png").is_file()
    assert (tmp_path / "head-variants.png").is_file()


def test_what_is_not_known_is_a_dash_in_the_table():
    unknown = replace(a_trial(0), sd=np.full((200, 4), np.nan), matches=0)
    line = line_of(Case("free", "vist", ablation="imu-only-5s"), summarise([unknown]))
    assert "nan" not in line
    assert line.count("–") == 3
    assert "–" not in line_of(Case("free", "vist"), summarise([a_trial(0)]))


def test_the_default_engine_supports_the_number_of_lenses(capsys):
    one, none = (cases_of(parse("--lenses", n, "--experiments", "free")) for n in ("one", "none"))
    assert [(c.engine, c.lenses) for c in one + none] == [("chain", "one"), ("inertial", "none")]
    for words, code in (
        (("--lenses", "one", "--engines", "vist"), "vist.both_lenses"),
        (("--lenses", "none", "--engines", "chain"), "vist.needs_camera"),
        (("--engines", "inertial"), "vist.no_images"),
    ):
        with raises(ConfigError, code):
            cases_of(parse(*words))


def test_a_glove_without_a_camera_is_judged_by_its_joints(capsys):
    words = (
        "--lenses",
        "none",
        "--experiments",
        "free",
        "--participants",
        "1",
        "--minutes",
        "0.12",
    )
    args = parse(*words, "--json", "-")
    assert args.command.start(args) == 0
    (row,) = json.loads(capsys.readouterr().out)["rows"]
    assert 0.5 < row["angles_deg"] < 10 and row["lost"] == 0.0
    assert row["nees_per_dof"] is None  # there is no position, so it has no uncertainty


def a_trial(participant: int) -> Trial:
    """Two seconds with an error of 4 mm."""
    n = 200
    return Trial(
        participant=participant, hand_length=0.18, t=np.arange(n) / 100,
        error=np.full((n, 4), 0.004), sd=np.full((n, 4), 0.004),
        joints=np.full((n, 9), 0.002), seen=np.full(n, 11),
        matches=10, wrong_matches=0, core_s=0.1, duration=2.0, angles=np.full((n, 5), 0.05),
    )  # fmt: skip


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_the_bar_shows_the_remaining_time():
    now = iter([0.0, 30.0, 60.0])
    screen = Terminal()
    bar = ProgressBar(screen, clock=lambda: next(now))
    for done in (0, 1, 2, 10):
        bar.show(done, 10)
    lines = screen.getvalue().split("\r")
    assert "0/10 trials" in lines[1]
    assert "1/10 trials, 4 min left" in lines[2]  # nine more of 30 s
    assert "2/10 trials, 4 min left" in lines[3]
    assert lines[4].rstrip(" \n").endswith("10/10 trials")
    assert lines[4].endswith("\n")


def test_the_defaults_are_the_papers():
    args = parse()
    cases = cases_of(args)
    assert args.participants == 15
    assert {(c.experiment, c.minutes) for c in cases} == {
        ("free", 3.0), ("object", 2.0), ("device", 2.0),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("words", "code", "values"),
    [
        (["--engines", "nonsense"], "vist.unknown", {"name": "nonsense"}),
        (["--experiments", "juggling"], "vist.unknown", {"name": "juggling"}),
        (["--ablations", "no-hand"], "vist.unknown", {"name": "no-hand"}),
        (["--motion", "absent.tsv"], "file.missing", {"path": "absent.tsv"}),
    ],
)
def test_a_missing_file_is_named(words, code, values):
    with raises(ConfigError, code, **values):
        cases_of(parse(*words))


def test_a_wearers_profile_is_for_the_engine_that_takes_it(tmp_path):
    absent = str(tmp_path / "anna.toml")
    with raises(ConfigError, "vist.profile_engine"):
        cases_of(parse("--wearer", absent))
    with raises(FileError, "wearer.invalid"):
        cases_of(parse("--wearer", absent, "--engines", "chain"))


def test_guided_rows_are_listed_side_by_side():
    cases = cases_of(parse("--guided", "--experiments", "free", "--engines", "chain"))
    assert [c.guided for c in cases] == ["", *GUIDED, "unannounced"]
    assert [c.is_led for c in cases] == [False, True, True, True, False, True]


@pytest.mark.long
def test_a_known_wearer_starts_with_the_profile_of_another_session(monkeypatch):
    """The same free motion with the same fitting of the glove: the wearer's bones are known."""
    monkeypatch.setattr("extensions.evaluation.vist.trial.FIRST_SESSION", 0.02)
    monkeypatch.setattr("tracker.simulation.guided.POSES", {"flat": POSES["flat"]})
    case = Case("free", "chain", minutes=0.1, fps=20, seed=11)
    hand, glove = models()
    sim = simulation_of(case, hand, glove, motion_of(case, hand, 11_000, None), 11_000, None)
    pipeline = Pipeline(hand, glove, sim.rig, Settings())
    anybody = pipeline.engine.profile()
    meet_again(pipeline, case, 11_000)
    known = pipeline.engine.profile()
    true = sim.wearer.scale[[hand.index[n] for n in pipeline.engine.layout.names], 0]
    assert np.abs(known.scale[:, 0] - true).mean() < 0.5 * np.abs(anybody.scale[:, 0] - true).mean()
    np.testing.assert_array_equal(known.R_IB, anybody.R_IB)


@pytest.mark.parametrize("words", [["--participants", "0"], ["--minutes", "x"], ["--level", "3d"]])
def test_a_usage_error_exits_with_two(words):
    with pytest.raises(SystemExit) as stop:
        parse(*words)
    assert stop.value.code == 2


@pytest.mark.long
def test_a_trial_is_the_same_whoever_runs_it():
    case = Case("device", "vist", minutes=0.1, fps=15)
    (here,) = run_cases([case], 1, processes=1)[0]
    (elsewhere,) = run_cases([case], 1, processes=2)[0]
    np.testing.assert_array_equal(here.error, elsewhere.error)
    assert here.matches == elsewhere.matches


def test_ablations_change_the_named_part():
    for name, ablation in ABLATIONS.items():
        changed = ablation.settings(Settings()) != Settings()
        moved = ablation.fps is not None or ablation.speed != 1 or ablation.outage > 0
        assert changed or moved or ablation.camera != "pose" or name == "vision-only"


def imu(t: float) -> ImuSample:
    return ImuSample(t, t, t, 0, np.zeros((2, 3)), np.zeros((2, 3)), np.ones(2, bool))


def image(t: float) -> BlobFrame:
    return BlobFrame(t, t, (), None, None)


def test_outages_withhold_images_and_are_judged_at_their_end():
    feed = [m for k in range(400) for m in (imu(k / 10), image(k / 10))]
    stored = [m.t for m in without_images(5.0)(iter(feed)) if isinstance(m, BlobFrame)]
    assert not [t for t in stored if 10 <= t < 15 or 25 <= t < 30]
    assert 9.9 in stored
    assert 15.0 in stored
    judged = [t for t in np.arange(0, 30, 0.5) if judged_in_outage(t, 5.0)]
    assert judged == [14.0, 14.5, 29.0, 29.5]
    assert all(in_outage(t, 5.0) for t in judged)


def test_disabled_imus_send_nothing_and_images_pass():
    out = list(without_imus(iter([imu(1.0), imu(9.0), image(9.0)])))
    assert out[0].valid.all()
    assert not out[1].valid.any()
    assert out[2].t == 9.0


def test_a_blob_belongs_to_the_nearest_marker_or_to_none():
    true_uv = np.array([[100.0, 100.0], [120.0, 100.0], [np.nan, np.nan]])
    blobs = np.array([[101.0, 99.0], [119.0, 101.0], [160.0, 100.0]])
    np.testing.assert_array_equal(owners(blobs, true_uv), [0, 1, -1])


def test_other_sessions_and_smoothing_are_added_as_rows():
    words = "--experiments", "free", "--sessions", "all", "--smoothed", "--lenses", "one"
    cases = cases_of(parse(*words))
    assert [(c.session, c.smoothed) for c in cases] == [
        (name, smoothed) for smoothed in (False, True) for name in ("", *SESSIONS)
    ]
    known = cases_of(parse("--guided", "--smoothed", "--experiments", "free"))
    assert {c.guided for c in known if c.smoothed} == {"", "unannounced", "guided", "badly"}
    with raises(ConfigError, "vist.unknown"):
        cases_of(parse("--sessions", "none"))
    with raises(ConfigError, "vist.sessions_of_points"):
        cases_of(parse("--sessions", "away", "--level", "images"))


def test_sessions_differ_in_what_they_are_named_after():
    one = Blobs(np.ones((1, 2)), np.ones((1, 2)), np.zeros(1, np.int64), np.ones(1))
    seen = BlobFrame(2.0, 2.0, ("red", "green", "blue"), one, None)
    assert blobs_of("", seen) is seen and blobs_of("unusual", seen) is seen
    assert blobs_of("exchanged", seen).hue_names == ("blue", "green", "red")
    assert blobs_of("away", seen) is seen
    away = blobs_of("away", replace(seen, t=12.0))
    assert away.left is not None and len(away.left) == 0 and away.right is None
    assert people_of("unusual").marker_place == 2 * people_of("").marker_place


@pytest.mark.long
def test_smoothing_uses_what_comes_later():
    """The same person and the same instants."""
    live = Case("free", "chain", minutes=0.12, fps=15, seed=3)
    before, after = run_trial(live, 0), run_trial(replace(live, smoothed=True), 0)
    np.testing.assert_array_equal(before.t, after.t)
    assert np.isfinite(after.error).all()
    assert not np.allclose(before.error[:50], after.error[:50], atol=1e-4)
