"""The layer registered for one user: the loader adds it to each application of that user.

The library is copied into the user's data folder: the installation may be an archive that is
mounted only while the program runs, or a virtual environment that is removed. On Linux the loader
finds the manifest in a folder, on Windows by a value of the registry whose name is its path.
"""

from __future__ import annotations

import json
import os
import sys
from contextlib import suppress
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Protocol

import platformdirs

from extensions.openxr.library import LAYER, LIBRARY, manifest
from tracker.base.errors import FileError
from tracker.base.files import write_whole
from tracker.base.notices import notice

if sys.platform == "win32":
    import winreg

MANIFEST_NAME = f"{LAYER}.json"
REGISTRY_KEY = r"Software\Khronos\OpenXR\1\ApiLayers\Implicit"
ENABLED = 0  # value of an entry: anything else disables it


class Registered(Enum):
    """What an application of this user finds."""

    NO = "not registered"
    YES = "registered"
    OLD = "registered from another version"
    BROKEN = "registered, but its library is missing"


class UserRegistry(Protocol):
    """The values of `REGISTRY_KEY` of the current user."""

    def names(self) -> list[str]: ...

    def set(self, name: str, value: int) -> None: ...

    def remove(self, name: str) -> None: ...


@dataclass(frozen=True)
class LayerRegistration:
    """Where one user's layer is. ``library`` is the compiled one that is copied into ``folder``;
    ``manifest`` describes the copy; ``registry`` names the manifest where there is a registry."""

    library: Path
    folder: Path
    manifest: Path
    registry: UserRegistry | None = None

    @property
    def copy(self) -> Path:
        return self.folder / self.library.name

    def state(self) -> Registered:
        if not self.manifest.is_file() or not self._is_named():
            return Registered.NO
        try:
            described = json.loads(self.manifest.read_text("utf-8"))
        except (OSError, ValueError):
            return Registered.BROKEN
        if not self.copy.is_file():
            return Registered.BROKEN
        if described != manifest(self.copy):
            return Registered.OLD
        newer = self.library.is_file() and self.library.read_bytes() != self.copy.read_bytes()
        return Registered.OLD if newer else Registered.YES

    def register(self) -> None:
        """Copies the library and registers it with the loader. Raises FileError."""
        if not self.library.is_file():
            raise FileError(notice("openxr.no_layer"))
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self.manifest.parent.mkdir(parents=True, exist_ok=True)
            write_whole(self.copy, self.library.read_bytes())
            text = json.dumps(manifest(self.copy), indent=2) + "\n"
            write_whole(self.manifest, text)
            if self.registry is not None:
                self.registry.set(str(self.manifest), ENABLED)
        except OSError as error:
            raise FileError(notice("openxr.not_registered", why=error)) from error

    def unregister(self) -> None:
        """Applications that are running keep the layer. Raises FileError."""
        try:
            if self.registry is not None and self._is_named():
                self.registry.remove(str(self.manifest))
            self.manifest.unlink(missing_ok=True)
            self.copy.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(notice("openxr.not_unregistered", why=error)) from error

    def _is_named(self) -> bool:
        return self.registry is None or str(self.manifest) in self.registry.names()


def user_registration(library: Path = LIBRARY) -> LayerRegistration:
    """That of the current user. Raises FileError on a system without OpenXR layers."""
    folder = platformdirs.user_data_path("glovetrack", appauthor=False) / "openxr"
    if sys.platform == "win32":
        return LayerRegistration(library, folder, folder / MANIFEST_NAME, WindowsRegistry())
    if sys.platform != "linux":
        raise FileError(notice("openxr.system"))
    return LayerRegistration(library, folder, implicit_layers(os.environ) / MANIFEST_NAME)


def implicit_layers(environment: os._Environ[str] | dict[str, str]) -> Path:
    """The user's folder of manifests that the loader reads on Linux."""
    data = environment.get("XDG_DATA_HOME") or str(Path.home() / ".local" / "share")
    return Path(data) / "openxr" / "1" / "api_layers" / "implicit.d"


class WindowsRegistry:
    """The current user's part of the Windows registry."""

    def names(self) -> list[str]:
        if sys.platform == "win32":
            user = winreg.HKEY_CURRENT_USER
            with suppress(FileNotFoundError), winreg.OpenKey(user, REGISTRY_KEY) as key:
                return [winreg.EnumValue(key, i)[0] for i in range(winreg.QueryInfoKey(key)[1])]
        return []

    def set(self, name: str, value: int) -> None:
        if sys.platform == "win32":
            with winreg.CreateKey(winreg.HKEY_CURRENT_USER, REGISTRY_KEY) as key:
                winreg.SetValueEx(key, name, 0, winreg.REG_DWORD, value)

    def remove(self, name: str) -> None:
        if sys.platform == "win32":
            access = winreg.KEY_SET_VALUE
            with winreg.OpenKey(winreg.HKEY_CURRENT_USER, REGISTRY_KEY, 0, access) as key:
                winreg.DeleteValue(key, name)
