"""Fuzz one target for any time: ``python -m tests.fuzz --minutes 60 records``.

Requires Atheris (``pip install atheris``), which measures branch coverage; it is not part of the
environment. An input that fails, takes over 2 s or over 1 GB ends the run and is stored in
``--found``: move it to ``tests/fuzz/found/<target>/`` to make it a test.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path

import atheris

import tracker

SECONDS, MEGABYTES = 2, 1000  # of the processor's time and of memory, for one input
NAMES = (
    *("container", "records", "messages", "state", "decoder", "link"),
    *("hand", "glove", "colours", "settings", "zed", "opencv", "table"),
)
HANGS = 120  # s of wall-clock time, which mean little on a loaded computer


class TooSlow(Exception):
    """An input took over `SECONDS`."""


def within_time(target: Callable[[bytes], None]) -> Callable[[bytes], None]:
    """The target, with a time limit."""

    def timed(data: bytes) -> None:
        began = time.process_time()
        target(data)
        if time.process_time() - began > SECONDS:
            raise TooSlow

    return timed


def followed(target: str) -> list[str]:
    """Modules with branch coverage: those relevant for the target, since coverage costs time."""
    if target in ("container", "records", "messages"):
        return ["tracker.session"]
    if target == "state":
        return ["tracker.session", "tracker.base.records", "json"]
    if target in ("decoder", "link"):
        return ["tracker.sensors"]
    return ["tracker", "tomllib"]


def compiled() -> list[str]:
    """Modules of the engine with kernels: numba cannot compile functions modified by Atheris."""
    root = Path(tracker.__file__).parent
    files = [path for path in root.rglob("*.py") if "@kernel" in path.read_text("utf-8")]
    return [".".join(path.relative_to(root.parent).with_suffix("").parts) for path in files]


def main() -> None:
    named = next((word for word in sys.argv[1:] if word in NAMES), "")
    with atheris.instrument_imports(include=followed(named), exclude=compiled()):
        from tests.fuzz.examples import examples
        from tests.fuzz.targets import INFO, TARGETS, topics
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz")
    parser.add_argument("target", choices=NAMES)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--longest", type=int, default=20_000, help="bytes of an input")
    parser.add_argument("--corpus", type=Path, default=Path("fuzz-corpus"), help="what was learnt")
    parser.add_argument("--found", type=Path, default=Path("fuzz-found"))
    args = parser.parse_args()
    corpus, found = args.corpus / args.target, args.found / args.target
    for folder in (corpus, found):
        folder.mkdir(parents=True, exist_ok=True)
    for k, example in enumerate(examples(args.target, INFO, topics())):
        (corpus / f"example-{k}").write_bytes(example)
    atheris.Setup(
        [
            sys.argv[0],
            str(corpus),
            f"-max_total_time={round(60 * args.minutes)}",
            f"-timeout={HANGS}",
            f"-rss_limit_mb={MEGABYTES}",
            f"-max_len={args.longest}",
            f"-artifact_prefix={found}/",
            "-print_final_stats=1",
        ],
        within_time(TARGETS[args.target]),
    )
    atheris.Fuzz()


if __name__ == "__main__":
    main()
