"""Changes of device settings, which are sent to the devices and stored; and settings files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from app.engines.engine import EngineSetup
from app.storage.settings import SettingsStore
from app.viewmodels.device_settings import CONTROLS, DeviceValue, Value, locks_of
from tracker.base.errors import DeviceError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.sensors.camera_controls import locks_text


def apply_changes(
    setup: EngineSetup,
    store: SettingsStore,
    values: Sequence[DeviceValue],
    edits: Mapping[str, Value],
) -> None:
    """Send ``edits`` to the devices of ``setup``; those of simulated devices are not stored.

    Raises DeviceError for a rate that exceeds the glove's line speed.
    """
    for key, wanted in edits.items():
        device, _, name = key.partition(".")
        if name == "rate_hz" and isinstance(wanted, int):
            _set_rate(setup.seen_from(device.removeprefix("glove_")), wanted)
            if not setup.simulated:
                store.update(glove_rate=wanted)
    controls = setup.camera.controls
    if controls is not None and any(f"camera.{name}" in edits for name in CONTROLS):
        locks = locks_of(values, edits)
        controls.want(locks)
        store.update(camera_locks=locks_text(locks))


def _set_rate(setup: EngineSetup, rate_hz: int) -> None:
    if setup.connection.device is None:
        return
    try:
        setup.connection.device.want_rate(rate_hz)
    except ValueError as error:
        raise DeviceError(notice("window.glove_settings", why=str(error))) from error


def save_settings(text: str, path: Path) -> None:
    """Write a file of settings. Raises FileError."""
    write_with_folder(path, text)


def read_settings(path: Path) -> str:
    """The text of a file of settings. Raises FileError."""
    return read_text(path)
