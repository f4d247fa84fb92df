"""Child processes, started from programs of users."""

from __future__ import annotations

import os
import subprocess
import sys
from multiprocessing.connection import Connection
from pathlib import Path

ROOT = Path(__file__).parents[2]
IMPORTED = """
print("imported", flush=True)
import sys
from tracker.base.child import start_child
from tests.base.test_child import report
"""
USED = """
pipe, process = start_child("child", report, {what})
print(pipe.recv(), sys.modules["__main__"].__file__ == __file__, flush=True)
process.join()
"""


def report(pipe: Connection, what: object) -> None:
    """For the child."""
    pipe.send(type(what).__name__)


def printed(script: Path, text: str) -> list[str]:
    script.write_text(text)
    env = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, script], capture_output=True, text=True, check=True, env=env
    )
    return done.stdout.splitlines()


def test_a_script_without_a_guard_runs_once(tmp_path: Path) -> None:
    """multiprocessing would run it again in the child, and end there with an error."""
    text = IMPORTED + USED.format(what="'known'")
    assert printed(tmp_path / "script.py", text) == ["imported", "str True"]


def test_a_child_finds_what_is_defined_in_the_script(tmp_path: Path) -> None:
    own = "class Own:\n    pass\nif __name__ == '__main__':\n"
    text = IMPORTED + own + USED.format(what="Own()").replace("\n", "\n    ")
    assert printed(tmp_path / "script.py", text) == ["imported", "imported", "Own True"]
