"""Kills a recording window, its recorder, or both, at random times, in real time.

    python -m tests.session.recording.process_drill --kills 20

The tests do the same with fewer kills.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import random
import signal
import tempfile
import time
from ctypes import c_long
from pathlib import Path

from tests.session.recording.conftest import left_since, shared_names
from tests.session.recording.test_recorder_kills import has_ended, lost_s, victim
from tracker.session.recover import needs_recovery, recover


def killed(path: Path, what: str, wait: float) -> tuple[float, bool]:
    """s lost, and whether the file was finished nevertheless."""
    context = multiprocessing.get_context("spawn")
    last_put, pid = (context.Value(c_long, -1, lock=False) for _ in range(2))
    window = context.Process(target=victim, args=(path, last_put, pid))
    window.start()
    while last_put.value < 40 and window.is_alive():
        time.sleep(0.005)
    time.sleep(wait)
    if what != "window":
        os.kill(pid.value, signal.SIGKILL)
    last = last_put.value
    if what != "recorder":
        window.kill()
        last = last_put.value
    has_ended(pid.value, 30.0)
    window.kill()
    window.join()
    whole = not needs_recovery(path)
    return lost_s(path if whole else recover(path).path, last), whole


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=20, help="of each kind")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    rng, before = random.Random(args.seed), shared_names()
    for what in ("window", "recorder", "both"):
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / f"{n}.mcap" for n in range(args.kills)]
            found = [killed(path, what, rng.uniform(0, 0.5)) for path in paths]
        lost = sorted(s for s, _ in found)
        print(
            f"{what} killed {len(found)} times: lost {lost[len(lost) // 2]:.2f} s in the middle, "
            f"{lost[-1]:.2f} s at most; {sum(whole for _, whole in found)} files finished."
        )
    print(f"shared memory left: {sorted(left_since(before)) or 'none'}")


if __name__ == "__main__":
    main()
