#!/usr/bin/env python3
"""How long a new user waits: each way to get the program, on a fresh Debian, by the clock.

    packaging/clocks.py [--work FOLDER] [--dist FOLDER] [clone] [wheel] [deb] [folder]

Needs root, debootstrap, bubblewrap, Xvfb and xdotool. A fresh machine is a minimal Debian 12 of
debootstrap's with what its row says beside it, seen through an overlay, so that each way begins on
a clean one; it shares the network with this machine, nothing else. What registries hold lies at
hand in FOLDER after the first run (Debian's packages as apt's archives, Python's as wheels), so
that no line to a registry is measured. ``dist`` has what ``make package`` and ``make wheel`` leave.

A window is there when the X server shows it; a hand is tracked when the first estimate that
measured the index finger arrives by UDP. Beside each clock stand the seconds of processor that
it took, of all processes on the fresh machine, and this machine's load when it began.
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
"""What a Debian with a desktop has; a minimal one that has a screen lacks it."""
BESIDE = {
    "clone": ["git", "make", "g++", "python3-dev", "python3-venv", *SCREEN],
    "clone-without-compiler": ["git", "make", "python3-venv", *SCREEN],
    "wheel": ["python3-venv", *SCREEN],
    "deb": [],
    "folder": DRIVERS,
}
"""Debian's packages that a fresh machine of each way has already."""


class Machine(NamedTuple):
    """A fresh root, and what of this machine is bound into it."""

    root: Path
    work: Path
    display: str

    def start(self, line: str, user: str = "root") -> subprocess.Popen[str]:
        """Run a shell's line there, in a process group of its own."""
        bound = {
            "/source": self.work / "source",
            "/dist": self.work / "dist",
            "/wheels": self.work / "wheels",
        }
        words = ["bwrap", "--bind", str(self.root), "/", "--dev", "/dev", "--proc", "/proc"]
        words += ["--bind", str(self.work / "archives"), "/var/cache/apt/archives"]
        for there, here in bound.items():
            words += ["--ro-bind", str(here), there]
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
        """Raises SystemExit where the line fails."""
        if self.start(line).wait(PATIENCE):
            raise SystemExit(f"failed: {line} (see {self.work}/log.txt)")


class Clock:
    """Seconds by the wall and of processor since it was made, of a process and all it started."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._began, self._process = time.monotonic(), process
        self._most: dict[int, float] = {}
        self._looked = 0.0
        self.load = os.getloadavg()[0]

    def read(self) -> tuple[float, float]:
        self.look(0.0)
        return time.monotonic() - self._began, sum(self._most.values())

    def look(self, pause: float = 0.1) -> None:
        """Processes are gone when they are waited for, so each one's own time is kept.

        Not more often than every ``pause`` s: to look takes its own share of a core.
        """
        if time.monotonic() < self._looked + pause:
            return
        self._looked = time.monotonic()
        family = {self._process.pid}
        for pid, (parent, used) in sorted(_processes().items()):
            if parent in family or pid in family:
                family.add(pid)
                self._most[pid] = used


def _processes() -> dict[int, tuple[int, float]]:
    """The parent of each process, and its own seconds of processor."""
    found = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended meanwhile
            continue
        found[int(path.parent.name)] = (int(fields[1]), (int(fields[11]) + int(fields[12])) / TICKS)
    return found


class Row(NamedTuple):
    way: str
    what: str
    seconds: float
    cpu: float
    load: float

    def line(self) -> str:
        return (
            f"| {self.way} | {self.what} | {self.seconds:.2f} | {self.cpu:.2f} | {self.load:.1f} |"
        )


class Rows:
    """The table, printed as it grows."""

    def __init__(self, way: str) -> None:
        self.way = way

    def add(self, what: str, clock: Clock) -> None:
        print(Row(self.way, what, *clock.read(), clock.load).line(), flush=True)


def timed(machine: Machine, rows: Rows, what: str, line: str) -> None:
    """How long a line takes to its end."""
    process = machine.start(line)
    clock = Clock(process)
    while process.poll() is None:
        clock.look()
        time.sleep(0.005)
    if process.returncode:
        raise SystemExit(f"failed: {line} (see {machine.work}/log.txt)")
    rows.add(what, clock)


def watched(
    machine: Machine,
    rows: Rows,
    line: str,
    what: str,
    *,
    hand: bool,
    then: Callable[[], bool] = lambda: True,
) -> None:
    """How long until the window is there and, of a demo, until a hand is tracked.

    It is closed once ``then`` is true.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ear:
        ear.bind(("127.0.0.1", UDP_PORT))
        search = ["xdotool", "search", "--onlyvisible", "--name", "Glovetrack"]
        there = {"stdout": subprocess.DEVNULL, "env": {"DISPLAY": machine.display}}
        while subprocess.run(search, check=False, **there).returncode == 0:
            time.sleep(0.05)  # the one before has not gone yet
        seen = subprocess.Popen([*search[:2], "--sync", *search[2:]], **there)
        process = machine.start(line)
        clock = Clock(process)
        until(lambda: seen.poll() is not None, process, clock)
        rows.add(f"{what}: the window", clock)
        if hand:
            until(lambda: tracked(ear), process, clock)
            rows.add(f"{what}: a tracked hand", clock)
        until(then, process, clock)
    os.killpg(process.pid, signal.SIGKILL)  # bubblewrap takes all of its processes along
    process.wait(60)


def until(done: Callable[[], bool], process: subprocess.Popen[str], clock: Clock) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        if process.poll() is not None or time.monotonic() > end:
            raise SystemExit("It ended before anything was to be seen.")
        clock.look()
        time.sleep(0.005)


def tracked(ear: socket.socket) -> bool:
    """Whether an estimate has come that measured a finger, as far as it has sensors."""
    while select.select([ear], [], [], 0)[0]:
        said = json.loads(ear.recv(65536))
        if said["keypoints"]["index_dip"]["state"] == "measured":
            return True
    return False


def starts(machine: Machine, rows: Rows, program: str) -> None:
    """What every way has in common once the program is there."""
    watched(machine, rows, f"{program} demo", "first demo", hand=True)
    watched(machine, rows, f"{program} demo", "second demo", hand=True)
    begin(machine, rows, program)


def begin(machine: Machine, rows: Rows, program: str) -> None:
    for _ in range(3):
        timed(machine, rows, "--help", f"{program} --help >/dev/null")
    for _ in range(3):
        watched(machine, rows, program, "start", hand=False)


def clone(machine: Machine, rows: Rows) -> None:
    timed(machine, rows, "git clone", "git clone -q /source glovetrack")
    demo = "cd glovetrack && make demo"
    kernels = machine.root / "root/glovetrack/tracker/kernels"

    def all_compiled() -> bool:  # those that the demo does without too
        return (kernels / "_compiled_tracker_fusion_vist.txt").exists()

    watched(machine, rows, demo, "make demo, first", hand=True, then=all_compiled)
    watched(machine, rows, demo, "make demo, second", hand=True)
    begin(machine, rows, "glovetrack/.venv/bin/glovetrack")
    size(machine, rows, "glovetrack/.venv")


def wheel(machine: Machine, rows: Rows) -> None:
    install = "python3 -m venv venv && venv/bin/pip install -q /dist/glovetrack-*-cp311-*.whl"
    timed(machine, rows, "pip install", install)
    starts(machine, rows, "venv/bin/glovetrack")
    size(machine, rows, "venv")


def deb(machine: Machine, rows: Rows) -> None:
    timed(machine, rows, "apt-get install", "apt-get install -qq -y /dist/glovetrack_*.deb")
    starts(machine, rows, "glovetrack")
    size(machine, rows, "../opt/glovetrack")


def folder(machine: Machine, rows: Rows) -> None:
    timed(machine, rows, "tar", "tar xf /dist/glovetrack_*.tar.gz")
    starts(machine, rows, "glovetrack/glovetrack")
    size(machine, rows, "glovetrack")


def size(machine: Machine, rows: Rows, path: str) -> None:
    said = subprocess.check_output(["du", "-sm", str(machine.root / "root" / path)], text=True)
    print(f"{rows.way}: {said.split()[0]} MB", flush=True)


WAYS = {
    "clone": clone, "clone-without-compiler": clone, "wheel": wheel, "deb": deb, "folder": folder,
}  # fmt: skip


def base(work: Path) -> Path:
    """A minimal Debian, made once; and what the ways install, once at hand."""
    root = work / "base"
    if not (root / ".ready").exists():
        shutil.rmtree(root, ignore_errors=True)
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", str(root)], check=True)
        shutil.copy("/etc/resolv.conf", root / "etc" / "resolv.conf")
        (root / ".ready").touch()
    return root


def wheels(work: Path) -> None:
    """The wheels of the lock, and what installs them."""
    there = work / "wheels"
    if not there.exists():
        words = [sys.executable, "-m", "pip", "download", "-q", "--dest", str(there)]
        lock = str(ROOT / "requirements.lock")
        for wanted in (["--require-hashes", "-r", lock], ["uv", "pip"]):  # these two have no hashes
            subprocess.run([*words, *wanted], check=True)


def source(work: Path) -> None:
    """What is cloned: the commit that is checked out here."""
    shutil.rmtree(work / "source", ignore_errors=True)
    subprocess.run(["git", "clone", "-q", "--bare", str(ROOT), str(work / "source")], check=True)


@contextmanager
def overlay(place: Path, lower: list[Path], upper: Path) -> Iterator[Path]:
    """Roots one above the other; what is written there lands in ``upper``."""
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


def prepared(work: Path, way: str) -> Path:
    """What stands beside a way, installed once: a layer above the minimal Debian."""
    layer, ready = work / "ready" / way, work / "ready" / f"{way}.done"
    packages = f"--no-install-recommends ca-certificates {' '.join(BESIDE[way])}"
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
def fresh(work: Path, way: str, display: str) -> Iterator[Machine]:
    """A clean machine with what stands beside its way, gone afterwards."""
    lower = [prepared(work, way), base(work)]
    with overlay(work / "now", lower, work / "now" / "upper") as root:
        yield Machine(root, work, display)


@contextmanager
def screen() -> Iterator[str]:
    """An X server at a number that is free."""
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
    parser.add_argument("ways", nargs="*", metavar="WAY", help=f"of {', '.join(WAYS)}; all")
    parser.add_argument("--work", type=Path, default=ROOT / "build" / "clocks")
    parser.add_argument("--dist", type=Path, default=ROOT / "dist")
    args = parser.parse_args()
    work = args.work.resolve()
    (work / "archives" / "partial").mkdir(parents=True, exist_ok=True)
    (work / "dist").unlink(missing_ok=True)
    (work / "dist").symlink_to(args.dist.resolve())
    base(work)
    wheels(work)
    source(work)
    for way in args.ways or WAYS:
        prepared(work, way)
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    print("| way | step | clock s | CPU s | load |\n|---|---|---|---|---|")
    with screen() as display:
        for way in args.ways or WAYS:
            with fresh(work, way, display) as machine:
                WAYS[way](machine, Rows(way))


if __name__ == "__main__":
    main()
