"""An engine takes a wearer's profile from a file, and writes what it has learned to one."""

from __future__ import annotations

from pathlib import Path

from tracker.base.errors import ConfigError
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.calibration.profile_file import WearerFile, read_wearer, write_wearer
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.engine import Engine


def put_on(engine: Engine, profile: Path) -> None:
    """Begin with what is known of the wearer. Raises ConfigError for an engine that takes no
    profile, FileError for a file that is none."""
    chain = _chain(engine)
    chain.put_on(read_wearer(profile, chain.layout).profile)


def measure(engine: Engine, length: float) -> None:
    """Begin with a hand that is ``length`` m long and anybody's otherwise. Raises as `put_on`."""
    chain = _chain(engine)
    chain.put_on(measured_profile(chain.layout, length))


def keep(engine: Engine, profile: Path) -> None:
    """Write what was learned of the wearer, and replace the file. Raises as `put_on`."""
    chain = _chain(engine)
    write_wearer(profile, WearerFile(chain.layout, chain.profile(), chain.calibration()))


def _chain(engine: Engine) -> ChainEngine:
    if not isinstance(engine, ChainEngine):
        raise ConfigError("Only the engine chain takes and learns a wearer's profile.")
    return engine
