#!/usr/bin/env python3
"""Measures how long a new user waits: every method to install the program, on a fresh Debian.

    packaging/first_use_times.py [--work FOLDER] [--dist FOLDER] [clone] [wheel] [deb] [folder]

Needs root, debootstrap, bubblewrap, Xvfb and xdotool. A fresh machine is a minimal Debian 12 made
by debootstrap, plus the packages named in its row. It is an overlay, so that each method begins
with a clean one, and shares only the network with this machine. After the first run, FOLDER
contains the downloads (Debian's packages as apt's archives, Python's as wheels), so that the speed
of the network is not measured. ``dist`` contains the results of ``make package`` and ``make
wheel``.

The time of the window ends when the X server shows it, that of tracking when the first estimate
with a measured index finger arrives by UDP. Next to each time are the CPU seconds of all processes
on the fresh machine and this machine's load at the start.
"""

from __future__ import annotations

import argparse
import json
import os
import select
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
UDP_PORT = 9750
PATIENCE = 3600.0  # s
TICKS = os.sysconf("SC_CLK_TCK")
DRIVERS = ["libegl1", "libegl-mesa0", "libgl1", "libglx-mesa0", "fonts-dejavu-core"]
SCREEN = [
    *DRIVERS, "libdbus-1-3", "libfontconfig1", "libglib2.0-0", "libx11-6", "libx11-xcb1",
    "libxcb-cursor0", "libxcb-icccm4", "libxcb-image0", "libxcb-keysyms1", "libxcb-randr0",
    "libxcb-render-util0", "libxcb-shape0", "libxcb-xkb1", "libxkbcommon0", "libxkbcommon-x11-0",
]  # fmt: skip
"""Packages of a Debian with a desktop that a minimal one with an X server lacks."""
PREREQUISITES = {
    "clone": ["git", "make", "g++", "python3-dev", "python3-venv", *SCREEN],
    "clone-without-compiler": ["git", "make", "python3-venv", *SCREEN],
    "wheel": ["python3-venv", *SCREEN],
    "deb": [],
    "folder": DRIVERS,
}
"""Debian packages that are already installed on a fresh machine, for each method."""


class Machine(NamedTuple):
    """A fresh root directory, and the paths of this machine that are bound into it."""

    root: Path
    work: Path
    display: str

    def start(self, line: str, user: str = "root") -> subprocess.Popen[str]:
        """Start a shell command in it, in its own process group."""
        bound = {
            "/source": self.work / "source",
            "/dist": self.work / "dist",
            "/wheels": self.work / "wheels",
        }
        words = ["bwrap", "--bind", str(self.root), "/", "--dev", "/dev", "--proc", "/proc"]
        words += ["--bind", str(self.work / "archives"), "/var/cache/apt/archives"]
        for inside, outside in bound.items():
            words += ["--ro-bind", str(outside), inside]
        words += ["--unshare-pid", "--die-with-parent", "--clearenv", "--chdir", "/root"]
        environment = {
            "HOME": "/root", "PATH": "/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin",
            "DISPLAY": self.display, "LANG": "C.UTF-8", "PIP_FIND_LINKS": "/wheels",
            "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1",
            "PIP_ROOT_USER_ACTION": "ignore", "DEBIAN_FRONTEND": "noninteractive",
        }  # fmt: skip
        for name, value in environment.items():
            words += ["--setenv", name, value]
        log = (self.work / "log.txt").open("a")
        log.write(f"--- {line}\n")
        log.flush()
        return subprocess.Popen(
            [*words, "bash", "-c", line],
            stdout=log,
            stderr=subprocess.STDOUT,
            text=True,
            process_group=0,
        )

    def run(self, line: str) -> None:
        """Run a shell command; raises SystemExit if it fails."""
        if self.start(line).wait(PATIENCE):
            raise SystemExit(f"failed: {line} (see {self.work}/log.txt)")


class Stopwatch:
    """Wall-clock and CPU seconds of a process and its descendants since this was created."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._began, self._process = time.monotonic(), process
        self._most: dict[int, float] = {}
        self._updated = 0.0
        self.load = os.getloadavg()[0]

    def read(self) -> tuple[float, float]:
        self.update(0.0)
        return time.monotonic() - self._began, sum(self._most.values())

    def update(self, pause: float = 0.1) -> None:
        """Update the CPU times.

        A process that was waited for disappears, so each one's last time is stored. At most once
        every ``pause`` s, because this itself uses CPU time.
        """
        if time.monotonic() < self._updated + pause:
            return
        self._updated = time.monotonic()
        family = {self._process.pid}
        for pid, (parent, used) in sorted(_processes().items()):
            if parent in family or pid in family:
                family.add(pid)
                self._most[pid] = used


def _processes() -> dict[int, tuple[int, float]]:
    """The parent of each process, and its own CPU seconds."""
    found = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        found[int(path.parent.name)] = (int(fields[1]), (int(fields[11]) + int(fields[12])) / TICKS)
    return found


class Row(NamedTuple):
    method: str
    what: str
    seconds: float
    cpu: float
    load: float

    def line(self) -> str:
        figures = f"{self.seconds:.2f} | {self.cpu:.2f} | {self.load:.1f}"
        return f"| {self.method} | {self.what} | {figures} |"


class Rows:
    """The table of results; each row is printed when it is added."""

    def __init__(self, method: str) -> None:
        self.method = method

    def add(self, what: str, clock: Stopwatch) -> None:
        print(Row(self.method, what, *clock.read(), clock.load).line(), flush=True)


def time_command(machine: Machine, rows: Rows, what: str, line: str) -> None:
    """Measures how long a command takes."""
    process = machine.start(line)
    clock = Stopwatch(process)
    while process.poll() is None:
        clock.update()
        time.sleep(0.005)
    if process.returncode:
        raise SystemExit(f"failed: {line} (see {machine.work}/log.txt)")
    rows.add(what, clock)


def time_window(
    machine: Machine,
    rows: Rows,
    line: str,
    what: str,
    *,
    hand: bool,
    then: Callable[[], bool] = lambda: True,
) -> None:
    """Measures the time until the window is shown and, in a demo, until a hand is tracked.

    The program is ended once ``then`` is true.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", UDP_PORT))
        search = ["xdotool", "search", "--onlyvisible", "--name", "Glovetrack"]
        options = {"stdout": subprocess.DEVNULL, "env": {"DISPLAY": machine.display}}
        while subprocess.run(search, check=False, **options).returncode == 0:
            time.sleep(0.05)  # the previous one has not closed yet
        seen = subprocess.Popen([*search[:2], "--sync", *search[2:]], **options)
        process = machine.start(line)
        clock = Stopwatch(process)
        until(lambda: seen.poll() is not None, process, clock)
        rows.add(f"{what}: the window", clock)
        if hand:
            until(lambda: hand_is_tracked(receiver), process, clock)
            rows.add(f"{what}: a tracked hand", clock)
        until(then, process, clock)
    os.killpg(process.pid, signal.SIGKILL)  # bubblewrap ends all of its processes
    process.wait(60)


def until(done: Callable[[], bool], process: subprocess.Popen[str], clock: Stopwatch) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        if process.poll() is not None or time.monotonic() > end:
            raise SystemExit("The program ended before its window was shown.")
        clock.update()
        time.sleep(0.005)


def hand_is_tracked(receiver: socket.socket) -> bool:
    """Whether an estimate with a measured finger has arrived."""
    while select.select([receiver], [], [], 0)[0]:
        output = json.loads(receiver.recv(65536))
        if output["keypoints"]["index_dip"]["state"] == "measured":
            return True
    return False


def time_starts(machine: Machine, rows: Rows, program: str) -> None:
    """The measurements that every method has in common once the program is installed."""
    time_window(machine, rows, f"{program} demo", "first demo", hand=True)
    time_window(machine, rows, f"{program} demo", "second demo", hand=True)
    begin(machine, rows, program)


def begin(machine: Machine, rows: Rows, program: str) -> None:
    for _ in range(3):
        time_command(machine, rows, "--help", f"{program} --help >/dev/null")
    for _ in range(3):
        time_window(machine, rows, program, "start", hand=False)


def clone(machine: Machine, rows: Rows) -> None:
    time_command(machine, rows, "git clone", "git clone -q /source glovetrack")
    demo = "cd glovetrack && make demo"
    kernels = machine.root / "root/glovetrack/tracker/kernels"

    def all_compiled() -> bool:  # including those that the demo does not need
        return (kernels / "_compiled_tracker_fusion_vist.txt").exists()

    time_window(machine, rows, demo, "make demo, first", hand=True, then=all_compiled)
    time_window(machine, rows, demo, "make demo, second", hand=True)
    begin(machine, rows, "glovetrack/.venv/bin/glovetrack")
    size(machine, rows, "glovetrack/.venv")


def wheel(machine: Machine, rows: Rows) -> None:
    install = "python3 -m venv venv && venv/bin/pip install -q /dist/glovetrack-*-cp311-*.whl"
    time_command(machine, rows, "pip install", install)
    time_starts(machine, rows, "venv/bin/glovetrack")
    size(machine, rows, "venv")


def deb(machine: Machine, rows: Rows) -> None:
    time_command(machine, rows, "apt-get install", "apt-get install -qq -y /dist/glovetrack_*.deb")
    time_starts(machine, rows, "glovetrack")
    size(machine, rows, "../opt/glovetrack")


def folder(machine: Machine, rows: Rows) -> None:
    time_command(machine, rows, "tar", "tar xf /dist/glovetrack_*.tar.gz")
    time_starts(machine, rows, "glovetrack/glovetrack")
    size(machine, rows, "glovetrack")


def size(machine: Machine, rows: Rows, path: str) -> None:
    output = subprocess.check_output(["du", "-sm", str(machine.root / "root" / path)], text=True)
    print(f"{rows.method}: {output.split()[0]} MB", flush=True)


METHODS = {
    "clone": clone, "clone-without-compiler": clone, "wheel": wheel, "deb": deb, "folder": folder,
}  # fmt: skip


def base(work: Path) -> Path:
    """Create a minimal Debian, once, and download what the methods install."""
    root = work / "base"
    if not (root / ".ready").exists():
        shutil.rmtree(root, ignore_errors=True)
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", str(root)], check=True)
        shutil.copy("/etc/resolv.conf", root / "etc" / "resolv.conf")
        (root / ".ready").touch()
    return root


def wheels(work: Path) -> None:
    """The wheels of the lock file, and the tool that installs them."""
    folder = work / "wheels"
    if not folder.exists():
        words = [sys.executable, "-m", "pip", "download", "-q", "--dest", str(folder)]
        lock = str(ROOT / "requirements.lock")
        for wanted in (["--require-hashes", "-r", lock], ["uv", "pip"]):  # these two have no hashes
            subprocess.run([*words, *wanted], check=True)


def source(work: Path) -> None:
    """The repository to clone: the commit that is checked out here."""
    shutil.rmtree(work / "source", ignore_errors=True)
    subprocess.run(["git", "clone", "-q", "--bare", str(ROOT), str(work / "source")], check=True)


@contextmanager
def overlay(place: Path, lower: list[Path], upper: Path) -> Iterator[Path]:
    """Roots layered one above the other; changes are written to ``upper``."""
    shutil.rmtree(place, ignore_errors=True)
    for folder in (place / "root", place / "inner", upper):
        folder.mkdir(parents=True, exist_ok=True)
    layers = f"lowerdir={':'.join(map(str, lower))},upperdir={upper},workdir={place}/inner"
    root = place / "root"
    subprocess.run(["mount", "-t", "overlay", "-o", layers, "overlay", str(root)], check=True)
    try:
        yield root
    finally:
        subprocess.run(["umount", "--lazy", str(root)], check=False)


def prepared(work: Path, method: str) -> Path:
    """The prerequisites of a method, installed once: a layer above the minimal Debian."""
    layer, ready = work / "ready" / method, work / "ready" / f"{method}.done"
    packages = f"--no-install-recommends ca-certificates {' '.join(PREREQUISITES[method])}"
    if ready.exists() and ready.read_text() == packages:
        return layer
    shutil.rmtree(layer, ignore_errors=True)
    with overlay(work / "now", [base(work)], layer) as root:
        (root / "etc/apt/apt.conf.d/kept").write_text(
            'Binary::apt::APT::Keep-Downloaded-Packages "true";\nAPT::Sandbox::User "root";\n'
        )
        (root / "root/.config/glovetrack").mkdir(parents=True)
        streams = {"version": 3, "streams": {"udp": True, "udp_port": UDP_PORT}}
        (root / "root/.config/glovetrack/window.json").write_text(json.dumps(streams))
        install = (
            "apt-get -o Dpkg::Options::=--force-unsafe-io install -qq -y --no-install-recommends"
        )
        Machine(root, work, "").run(f"apt-get update -qq && {install} {packages}")
    ready.write_text(packages)
    return layer


@contextmanager
def fresh(work: Path, method: str, display: str) -> Iterator[Machine]:
    """A clean machine with the prerequisites of its method, deleted afterwards."""
    lower = [prepared(work, method), base(work)]
    with overlay(work / "now", lower, work / "now" / "upper") as root:
        yield Machine(root, work, display)


@contextmanager
def screen() -> Iterator[str]:
    """Starts an X server with a free display number."""
    words = [
        "Xvfb",
        "-displayfd",
        "1",
        "-noreset",
        "-screen",
        "0",
        "1440x900x24",
        "-nolisten",
        "tcp",
    ]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(words, text=True, **pipes) as server:
        try:
            assert server.stdout is not None
            yield f":{server.stdout.readline().strip()}"
        finally:
            server.terminate()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "methods", nargs="*", metavar="METHOD", help=f"of {', '.join(METHODS)}; all"
    )
    parser.add_argument("--work", type=Path, default=ROOT / "build" / "first_use")
    parser.add_argument("--dist", type=Path, default=ROOT / "dist")
    args = parser.parse_args()
    work = args.work.resolve()
    (work / "archives" / "partial").mkdir(parents=True, exist_ok=True)
    (work / "dist").unlink(missing_ok=True)
    (work / "dist").symlink_to(args.dist.resolve())
    base(work)
    wheels(work)
    source(work)
    for method in args.methods or METHODS:
        prepared(work, method)
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    print("| method | step | clock s | CPU s | load |\n|---|---|---|---|---|")
    with screen() as display:
        for method in args.methods or METHODS:
            with fresh(work, method, display) as machine:
                METHODS[method](machine, Rows(method))


if __name__ == "__main__":
    main()
