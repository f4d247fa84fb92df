"""Kills recording processes at random times and checks what is left.

    python -m tests.session.kill_drill --kills 200

The tests do the same with fewer kills.
"""

from __future__ import annotations

import argparse
import itertools
import multiprocessing
import random
import tempfile
import time
from ctypes import c_long
from dataclasses import dataclass
from pathlib import Path

from tests.session.conftest import ANCHOR, RESOURCES, MessageMaker
from tracker.messages import ImuSample
from tracker.session.description import describe
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery, recover
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.vision.rig import ideal_rig

PERIOD_MS = 10.0
IMAGES = ("none", "jpeg", "png")


@dataclass(frozen=True)
class Kill:
    """``lost_s`` of the session before the kill; ``gaps`` packets missing in between."""

    written: int
    lost_s: float
    gaps: int


def victim(path: Path, images: str, written: c_long) -> None:
    """Records endlessly, as fast as possible; ``written`` is the last packet passed on."""
    info = describe(
        (RESOURCES / "hands" / "reference-right.toml").read_text(),
        (RESOURCES / "gloves" / "vist-small.toml").read_text(),
        ANCHOR,
        rig=ideal_rig(64, 48),
    )
    maker = MessageMaker(info)
    with SessionRecorder(path, info, RecorderParams(images=images)) as recorder:
        for k in itertools.count():
            recorder.write(maker.imu(PERIOD_MS * k, seq=k))
            recorder.write(maker.estimate(PERIOD_MS * k))
            if k % 3 == 0:
                recorder.write(maker.blob_frame(PERIOD_MS * k, k))
                recorder.write(maker.image(PERIOD_MS * k, k))
            written.value = k


def drill(folder: Path, kills: int, seed: int) -> list[Kill]:
    """Kill ``kills`` recordings, each at a random time."""
    rng = random.Random(seed)
    # Children of a server that has imported everything start quickly.
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["tests.session.conftest"])
    out = []
    for n in range(kills):
        # Without a lock, which a process killed at the wrong time would hold forever.
        path, written = folder / f"{n}.mcap", context.Value(c_long, -1, lock=False)
        process = context.Process(target=victim, args=(path, IMAGES[n % 3], written))
        process.start()
        while written.value < 0 and process.is_alive():
            time.sleep(0.002)
        time.sleep(rng.uniform(0, 0.25))
        process.kill()
        process.join()
        out.append(inspect(path, written.value))
    return out


def inspect(path: Path, last: int) -> Kill:
    """The result of recovery. Raises AssertionError if the file is complete."""
    assert needs_recovery(path)
    with SessionReader(recover(path).path) as reader:
        found = [m.seq for m in reader.messages((ImuSample,)) if isinstance(m, ImuSample)]
    last_found = found[-1] if found else -1
    return Kill(last + 1, (last - last_found) * PERIOD_MS / 1000, last_found + 1 - len(found))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        found = drill(Path(folder), args.kills, args.seed)
    lost = sorted(k.lost_s for k in found)
    print(
        f"{len(found)} kills after {min(k.written for k in found)} to "
        f"{max(k.written for k in found)} packets: lost {lost[len(lost) // 2]:.2f} s in the "
        f"middle, {lost[-1]:.2f} s at most; {sum(k.gaps for k in found)} packets missing before."
    )


if __name__ == "__main__":
    main()
