"""A recorded tracking state can be read regardless of earlier imports."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from tests.simulated_sessions import SimulatedSessions
from tracker.offline.crop import crop

ROOT = Path(__file__).resolve().parents[2]
DECORATED = re.compile(r"^@record\(|^\w+ = record\(", re.MULTILINE)

READ = """
import sys
from pathlib import Path
from tracker.session.reader import SessionReader
assert "tracker.engine.pipeline" not in sys.modules, "it was imported without being asked for"
with SessionReader(Path(sys.argv[1])) as session:
    print([state.engine for state in session.engine_states()])
"""
REGISTERED = """
import sys
from importlib import import_module
for name in sys.argv[1:]:
    import_module(name)
from tracker.session.mcap_session import register_states
register_states()
from tracker.base.records import RECORDS
print(*RECORDS)
"""


def output(script: str, *arguments: str) -> str:
    """The output of a new Python process that runs ``script``."""
    command = [sys.executable, "-c", script, *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_all_records_of_the_source_are_registered() -> None:
    modules = [
        ".".join(path.relative_to(ROOT).with_suffix("").parts)
        for path in (ROOT / "tracker").rglob("*.py")
        if DECORATED.search(path.read_text("utf-8"))
    ]
    assert len(modules) > 20 and "tracker.fusion.chain.state" in modules
    alone, with_all = (set(output(REGISTERED, *m).split()) for m in ((), modules))
    assert {"chain.state", "vist.state", "two_hands"} <= alone
    assert with_all - alone == set()


def test_a_script_that_imports_only_the_reader_reads_states(
    tmp_path: Path, simulated_sessions: SimulatedSessions
) -> None:
    whole, part = simulated_sessions.simulated(), tmp_path / "part.mcap"
    assert crop(whole, part, 1.0, None)["engine_state"], "the state at 1 s is in it"
    assert output(READ, str(part)) == "['chain']"
