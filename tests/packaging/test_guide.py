"""The user guide: commands run, links are valid, and its terms are those of the window."""

from __future__ import annotations

import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from tests.firmware.bootloader import Bootloader
from tests.notices import shows
from tracker.base.command import COMMANDS
from tracker.cli import build_parser, main
from tracker.messages import Event
from tracker.session.reader import SessionReader

ROOT = Path(__file__).parents[2]
GUIDE = ROOT / "docs" / "guide"
TUTORIALS = ROOT / "docs" / "tutorials"
PAGES = sorted([*GUIDE.glob("*.md"), *TUTORIALS.glob("*.md")])
OTHERS = sorted(
    {*(ROOT / "docs").rglob("*.md"), *ROOT.glob("extensions/*/docs/*.md"), ROOT / "README.md"}
    - set(PAGES)
)
"""Pages whose commands are only parsed: they need minutes, devices or other programs."""
BLOCK = re.compile(r"^```(?:sh)?\n(.*?)^```\n|((?:^    .*\n)+)", re.MULTILINE | re.DOTALL)
INLINE = re.compile(r"`(glovetrack [a-z][^`]*)`")
PYTHON = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?:)([^)#]+)")
PORT = "/dev/ttyUSB0"
ELSEWHERE = {
    "glovetrack conformance --simulate --hands both -o simulated.html": (
        *("packaging/smoke.sh", "conformance --simulate --hands both -o"),
    ),
    "glovetrack align tracked.mcap other.mcap -o aligned.json --figure aligned.png": (
        *(
            "tests/session/test_align.py",
            '"align", *map(str, takes), "-o", str(alignment), "--figure"',
        ),
    ),
    "glovetrack compare tracked.mcap other.mcap --align aligned.json": (
        *("tests/session/test_align.py", '"--align", str(alignment)'),
    ),
    **{
        f"glovetrack {words}": ("tests/offline/test_fill.py", words)
        for words in (
            "fill tracked.mcap -o filled.mcap --max-gap 0.2 --method cubic",
            'fill tracked.mcap -o some.mcap --gaps gaps.json --by "A. Miller"',
        )
    },
    "glovetrack pinches tracked.mcap": ("tests/packaging/test_examples.py", "pinches"),
    "sudo usermod -aG dialout $USER": ("packaging/debian_smoke.sh", "usermod -aG dialout"),
}
"""Commands that need a minute, longer recordings, gaps or their own system, and their tests."""
GROUPS = ("colours", "evaluate", "firmware", "openxr", "remote", "room", "study")
WITH = " --with-sensors"
HEAD = "Timestamp (us),Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s),"
HEAD += "Accelerometer X (g),Accelerometer Y (g),Accelerometer Z (g)"


def commands(page: Path) -> list[str]:
    """Lines of the page's code blocks without comments."""
    blocks = (a or b for a, b in BLOCK.findall(page.read_text("utf-8")))
    lines = [re.split(r"\s{3,}", line.strip())[0] for b in blocks for line in b.split("\n")]
    return [line for line in lines if re.match(r"(glovetrack|sudo|pip|pipx|apt|make)\b", line)]


def needs_a_window(line: str) -> bool:
    words = shlex.split(line)[1:]
    return (
        not words
        or words[0] in ("demo", "--demo", "devices", "remote")
        or words[0].endswith(".mcap")
    )


def run(line: str) -> int:
    """Exit status of a line that begins with ``glovetrack``."""
    program, *words = shlex.split(line)
    assert program == "glovetrack", f"{line!r} is no command of ours"
    try:
        return main(words)
    except SystemExit as end:  # argparse exits after --help and --version
        return int(end.code or 0)


SIMULATED = r"glovetrack simulate -o \S+ --duration 3 --blobs-only( --seed [123])?"
TRACKED = tuple(f"glovetrack track session.mcap -o tracked.mcap{more}" for more in ("", WITH))
"""Lines that the fixture `sessions` runs once for all pages, with two of the three seconds; other
seeds than these are run."""


class Sessions(NamedTuple):
    """Two seconds without images, as recorded and as tracked."""

    recorded: Path
    tracked: Path


@pytest.fixture(scope="module")
def sessions(tmp_path_factory: pytest.TempPathFactory) -> Sessions:
    folder = tmp_path_factory.mktemp("guide")
    made = Sessions(folder / "session.mcap", folder / "tracked.mcap")
    assert run(f"glovetrack simulate -o {made.recorded} --duration 2 --blobs-only") == 0
    assert run(f"glovetrack track {made.recorded} -o {made.tracked}{WITH}") == 0
    return made


@pytest.fixture
def ran(
    sessions: Sessions, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, workers_here: None
) -> Iterator[Callable[[str], None]]:
    """Runs a line in an empty folder, with the files a reader of the page has."""
    monkeypatch.chdir(tmp_path)

    def run_it(line: str) -> None:
        if re.fullmatch(SIMULATED, line):
            shutil.copy(sessions.recorded, shlex.split(line)[3])
        elif line in TRACKED:
            shutil.copy(sessions.tracked, "tracked.mcap")
        elif PORT in line:
            _write_firmware(line, monkeypatch)
        else:
            _provide(line, sessions)
            allowed = {0, 1} if " conformance " in line else {0}  # 1: a rule is violated
            assert run(line) in allowed, line
            made = re.findall(r"(?:-o|--figure) (\S+)", line)
            assert [name for name in made if not Path(name).exists()] == []

    yield run_it


def _provide(line: str, sessions: Sessions) -> None:
    """The reader's own takes that this line reads."""
    outputs = re.findall(r"-o (\S+)", line)
    for word in shlex.split(line)[2:]:
        if word.endswith(".mcap") and word not in outputs and not Path(word).exists():
            shutil.copy(sessions.tracked, word)
        elif word == "log/":
            for name in ("hand", "finger"):
                rows = "\n".join(f"{k * 10_000},0,0,{k % 90},0,0,1" for k in range(200))
                (Path(word) / name).mkdir(parents=True)
                (Path(word) / name / "Inertial.csv").write_text(f"{HEAD}\n{rows}\n")


def _write_firmware(line: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the real avrdude and a simulated bootloader."""
    if shutil.which("avrdude") is None:
        return
    monkeypatch.setattr("tracker.firmware.command_runs.greeting", lambda _port: None)
    board = Bootloader()
    try:
        assert run(line.replace(PORT, board.port)) == 0
    finally:
        board.close()


@pytest.mark.long
@pytest.mark.parametrize("page", [p for p in PAGES if commands(p)], ids=lambda p: p.stem)
def test_every_command_of_a_page_runs(page: Path, ran: Callable[[str], None]) -> None:
    lines = [line for line in commands(page) if line not in ELSEWHERE]
    for line in lines:
        if line.startswith("glovetrack") and not needs_a_window(line):
            ran(line)


def test_commands_that_are_not_run_here_are_run_elsewhere() -> None:
    documented = {line for page in PAGES for line in commands(page)}
    assert set(ELSEWHERE) <= documented
    for name, words in ELSEWHERE.values():
        assert words in (ROOT / name).read_text("utf-8")
    others = {line for line in documented - set(ELSEWHERE) if not line.startswith("glovetrack")}
    assert others == {
        'pip install ".[streams]"',
        'pip install "glovetrack[robot]"',
        "pip install -e glovetrack-pinch-command",
    }


def test_extras_that_pages_name_are_the_projects() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    texts = "".join(page.read_text("utf-8") for page in PAGES)
    named = set(re.findall(r"pip install \"(?:\.|glovetrack)\[(\w+)\]\"", texts))
    assert {"streams", "robot"} <= named <= set(project["optional-dependencies"])


@pytest.mark.parametrize("page", [p for p in OTHERS if commands(p)], ids=lambda p: p.stem)
def test_the_commands_of_other_pages_are_accepted(page: Path) -> None:
    for line in commands(page):
        program, *words = shlex.split(line, comments=True)
        words = [word for word in words if word not in ("...", "…")]
        if program == "glovetrack" and words:
            build_parser(words).parse_args(words)  # exits where an argument is not known


def test_every_option_that_the_text_names_exists(capsys: pytest.CaptureFixture[str]) -> None:
    installed = [p for p in (*PAGES, *OTHERS) if p.stem != "plug-in"]  # whose command is not
    lines = {line for page in installed for line in INLINE.findall(page.read_text("utf-8"))}
    assert len(lines) > 60
    helps: dict[str, str] = {}
    for line in sorted(lines):
        words = line.split()[1:]
        depth = 2 if words[0] in GROUPS and len(words) > 1 and words[1].isalpha() else 1
        command = " ".join(words[:depth])
        if command not in helps:
            assert run(f"glovetrack {command} --help") == 0, line
            helps[command] = capsys.readouterr().out
        assert [w for w in words if w.startswith("--") and w not in helps[command]] == [], line


def test_all_commands_are_listed() -> None:
    page = (GUIDE / "README.md").read_text("utf-8")
    listed = re.findall(r"^\| `glovetrack ([\w-]+)`", page, re.MULTILINE)
    assert {*listed, "window"} == {name for name in COMMANDS.names() if "." not in name}


@pytest.fixture
def own_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Separate settings, logs and recordings, here and in a subprocess."""
    for kind in ("CONFIG", "STATE", "DATA", "CACHE"):
        monkeypatch.setenv(f"XDG_{kind}_HOME", str(tmp_path / kind))
    for name, value in (("HOME", tmp_path), ("PYTHONPATH", ROOT)):
        monkeypatch.setenv(name, str(value))
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.long
def test_the_commands_that_open_a_window_or_talk_to_it(
    own_home: Path, sessions: Sessions, qapp: object, capsys: pytest.CaptureFixture[str]
) -> None:
    """The demo is opened, instructed to record, and then shows a session opened by a second
    start."""
    lines = {line for page in PAGES for line in commands(page) if needs_a_window(line)}
    remote = ["start", 'note "the cup is taken"', "stop"]
    opened = {"glovetrack demo", "glovetrack session.mcap"}
    parsed = lines - opened - {f"glovetrack remote {words}" for words in remote}
    assert opened <= lines and parsed == {"glovetrack demo --hands both"}
    assert build_parser(["demo"]).parse_args(["demo", "--hands", "both"]).hands == "both"
    shutil.copy(sessions.tracked, own_home / "session.mcap")
    program = [sys.executable, "-m", "app"]
    plain = ["--scene", "plain", "--fps", "10"]  # its usual images: packaging/smoke.sh
    with subprocess.Popen([*program, "demo", *plain], cwd=own_home) as window:
        try:
            _wait(lambda: run("glovetrack remote status") == 0, window)
            _wait(lambda: _runs(capsys), window)
            for words in remote:
                _wait(lambda words=words: _answered(f"glovetrack remote {words}", capsys), window)
            second = subprocess.run([*program, "session.mcap"], cwd=own_home, timeout=60)
            assert second.returncode == 0
            window.send_signal(signal.SIGTERM)
            assert window.wait(60) == 0
        finally:
            window.kill()
    (take,) = (p for p in own_home.rglob("*.mcap") if p.name != "session.mcap")
    with SessionReader(take) as reader:
        assert "the cup is taken" in [m.text for m in reader.messages([Event])]


def _runs(capsys: pytest.CaptureFixture[str]) -> bool:
    """Whether the demo has started, according to the window."""
    assert run("glovetrack remote status") == 0
    return "Nothing is running" not in capsys.readouterr().out


def _answered(line: str, capsys: pytest.CaptureFixture[str]) -> bool:
    """Whether it was received: a window that is starting on a loaded computer answers late."""
    return run(line) == 0 or not shows(capsys.readouterr().err, "window.none")


def _wait(done: Callable[[], bool], window: subprocess.Popen[bytes], timeout: float = 90) -> None:
    end = time.monotonic() + timeout
    while not done():
        assert window.poll() is None and time.monotonic() < end
        time.sleep(0.1)


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.stem)
def test_links_and_images_exist(page: Path) -> None:
    targets = LINK.findall(page.read_text("utf-8"))
    assert targets
    assert [t for t in targets if not (page.parent / t).exists()] == []


@pytest.mark.parametrize("folder", [GUIDE, TUTORIALS], ids=lambda p: p.name)
def test_every_page_is_listed(folder: Path) -> None:
    listed = LINK.findall((folder / "README.md").read_text("utf-8"))
    pages = {(folder / name).resolve() for name in listed if not name.startswith("../")}
    assert pages == set(folder.glob("*.md")) - {folder / "README.md"}


def test_the_python_of_the_first_tutorial_runs(
    sessions: Sessions, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(sessions.tracked, "tracked.mcap")
    (code,) = PYTHON.findall((TUTORIALS / "first-session.md").read_text("utf-8"))
    names: dict[str, Any] = {}
    exec(compile(code, "first-session.md", "exec"), names)
    assert names["aperture_mm"].shape == names["rec"].t.shape
    assert 5 < np.nanmedian(names["aperture_mm"]) < 200  # a hand's size


def test_the_plug_in_of_the_tutorial_is_the_example() -> None:
    """The example is installed and run by test_examples.py."""
    text = (TUTORIALS / "plug-in.md").read_text("utf-8")
    example = ROOT / "docs" / "examples" / "glovetrack-pinch-command"
    for name in ("pyproject.toml", "glovetrack_pinch_command.py"):
        assert f"\n{(example / name).read_text('utf-8')}```" in text


def test_shortcuts_are_the_windows() -> None:
    """Each key named in the guide exists in the window."""
    root = ROOT / "app"
    files = (
        *("window/window_commands.py", "panels/library/session_page.py"),
        "wizards/guided/dialog.py",
    )
    texts = [(root / name).read_text("utf-8") for name in files]
    known = {key for text in texts for key in re.findall(r'"([^"\n]{1,12})"', text)}
    known |= {key for text in texts for key in re.findall(r"Key_([A-Z])\b", text)}
    documented = {
        key
        for page in PAGES
        for key in re.findall(
            r"`((?:Ctrl|Shift)\+\w+|F\d+|Space|[A-Z0-9])`", page.read_text("utf-8")
        )
    }
    assert {"Ctrl+D", "Space"} <= documented
    assert documented <= known


def test_all_export_formats_are_documented() -> None:
    from tracker.session.export.formats import FORMATS

    text = (GUIDE / "exporting.md").read_text("utf-8")
    table = "\n".join(line.split("|")[1] for line in text.split("\n") if line.startswith("| `"))
    assert set(re.findall(r"`([\w.]+)`", table)) == set(FORMATS.names())
