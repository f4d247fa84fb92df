"""A running program, an OpenXR application and our test runtime, on the Khronos loader."""

from __future__ import annotations

import ctypes.util
import fcntl
import importlib.util
import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from extensions.openxr.build import build, compile_library
from extensions.openxr.library import LIBRARY_NAME, manifest
from extensions.openxr.memory import ELSEWHERE
from extensions.openxr.publisher import WorldPlacement
from tracker.base.errors import ConfigError
from tracker.messages import Array

HERE = Path(__file__).parent
VALIDATION = Path("/usr/share/openxr/1/api_layers/explicit.d")
CHECK = "XR_APILAYER_LUNARG_core_validation"
HANDS, SOURCES = "XR_EXT_hand_tracking", "XR_EXT_hand_tracking_data_source"
TIME = "XR_KHR_convert_timespec_time"
LOADERS = ("debian", "own")


@dataclass(frozen=True)
class Libraries:
    """The compiled layer and test runtime."""

    layer: Path
    runtime: Path


def compiled(folder: Path) -> Libraries:
    """Both, compiled once for all processes of a run; else the test is skipped with what lacks."""
    folder.mkdir(exist_ok=True)
    made = Libraries(folder / LIBRARY_NAME, folder / "libruntime.so")
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        try:
            if not made.layer.exists():
                build(made.layer)
            if not made.runtime.exists():
                compile_library([HERE / "runtime" / "runtime.cpp"], made.runtime)
        except ConfigError as error:
            pytest.skip(f"The OpenXR layer was not tested. {error}")
    return made


def need_application(loader: str) -> None:
    """Skip the test where pyopenxr or the system's loader is missing."""
    if importlib.util.find_spec("xr") is None:
        pytest.skip("The OpenXR layer was not tested. pyopenxr is not installed.")
    if loader == "debian" and ctypes.util.find_library("openxr_loader") is None:
        pytest.skip(
            "The OpenXR layer was not tested. The OpenXR loader was not found. On Debian: "
            "apt-get install libopenxr-loader1"
        )


class Application:
    """The application in its process."""

    def __init__(self, environment: dict[str, str], loader: str) -> None:
        need_application(loader)
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("XR_", "XDG_"))}
        self._log = Path(environment["HOME"]) / f"application-{loader}.log"
        with self._log.open("a") as log:
            self.process = subprocess.Popen(
                [sys.executable, str(HERE / "application.py"), loader],
                env={**kept, **environment},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
            )

    def ask(self, do: str, **arguments: object) -> Any:
        """The answer. Raises RuntimeError with an error that the application reports."""
        assert self.process.stdin is not None and self.process.stdout is not None
        print(json.dumps({"do": do, **arguments}), file=self.process.stdin, flush=True)
        while line := self.process.stdout.readline():
            if line.startswith("{"):
                answer = json.loads(line)
                if "error" in answer:
                    raise RuntimeError(answer["error"])
                return answer["answer"]
        raise AssertionError(f"the application ended: {self._log.read_text()}")

    def start(self, *extensions: str, hands: tuple[str, ...] = ("right",)) -> None:
        """A session with trackers of these hands."""
        assert self.ask("open", extensions=[HANDS, *extensions])["supports"]
        self.ask("begin")
        for hand in hands:
            self.ask("track", hand=hand)

    def locate(self, hand: str = "right", **arguments: object) -> dict[str, Any]:
        """What the application reads; lists as arrays."""
        found = self.ask("locate", hand=hand, **arguments)
        return {k: np.array(v) if isinstance(v, list) else v for k, v in found.items()}

    def end(self) -> None:
        assert self.process.stdin is not None
        self.process.stdin.close()
        self.process.wait(60)


class Scene:
    """A user's home folder with the layer registered in it, and applications of that user."""

    def __init__(self, folder: Path, libraries: Libraries) -> None:
        self.memory = folder / "memory"
        layers = folder / ".local" / "share" / "openxr" / "1" / "api_layers" / "implicit.d"
        layers.mkdir(parents=True)
        (layers / "glovetrack.json").write_text(json.dumps(manifest(libraries.layer)))
        runtime = {"library_path": str(libraries.runtime)}
        described = {"file_format_version": "1.0.0", "runtime": runtime}
        (folder / "runtime.json").write_text(json.dumps(described))
        self._folder, self._layers = folder, layers
        self._applications: list[Application] = []

    def application(
        self, loader: str = "debian", runtime: str = "", **environment: str
    ) -> Application:
        """A new one, with words for the test runtime."""
        settings = {
            "HOME": str(self._folder),
            "XR_RUNTIME_JSON": str(self._folder / "runtime.json"),
            "GLOVETRACK_TEST_RUNTIME": runtime,
            ELSEWHERE: str(self.memory),
            **environment,
        }
        made = Application(settings, loader)
        self._applications.append(made)
        return made

    def checked(self, above: bool) -> Application:
        """An application with Debian's validation layer above ours, or between ours and the
        runtime; complaints are in `complaints`."""
        if not VALIDATION.is_dir():
            pytest.skip(
                "The OpenXR layer was not validated. On Debian: apt-get install "
                "openxr-layer-corevalidation"
            )
        settings = {
            "XR_CORE_VALIDATION_EXPORT_TYPE": "text",
            "XR_CORE_VALIDATION_FILE_NAME": str(self._folder / "complaints"),
            "XR_ENABLE_API_LAYERS": CHECK,
        }
        if above:  # explicit layers are loaded in the order of their list
            explicit = self._folder / "explicit"
            explicit.mkdir()
            for path in (*self._layers.iterdir(), *VALIDATION.glob("*core_validation*")):
                (explicit / path.name).write_text(path.read_text())
            settings["XR_API_LAYER_PATH"] = str(explicit)
            settings["XR_ENABLE_API_LAYERS"] += ":XR_APILAYER_GLOVETRACK_hands"
            for path in self._layers.iterdir():
                path.unlink()
        return self.application(**settings)

    def complaints(self) -> str:
        found = self._folder / "complaints"
        return found.read_text() if found.exists() else ""

    def close(self) -> None:
        for application in self._applications:
            application.end()


def runtime_origin(space: str, t: float) -> tuple[Rotation, Array]:
    """A reference space's axes and origin (m) in LOCAL at ``t`` s, as the test runtime has them."""
    if space == "stage":
        return Rotation.from_rotvec([0, 0.5, 0]), np.array([0.3, -1.6, 0.2])
    if space == "local":
        return Rotation.identity(), np.zeros(3)
    s = np.sin(2 * t)
    return Rotation.from_rotvec([0, 0.4 * s, 0]), np.array([0.1 + 0.2 * s, 0.05, 0.02])


def world_in(space: str, placement: WorldPlacement, t: float) -> tuple[Rotation, Array]:
    """Glovetrack's axes and origin (m) in a reference space at ``t`` s."""
    R_in, p_in = runtime_origin(placement.space.name.lower(), t)
    R_L = R_in * Rotation.from_euler("y", placement.yaw_deg, degrees=True)
    p_L = R_in.apply(placement.position) + p_in
    R_base, p_base = runtime_origin(space, t)
    return R_base.inv() * R_L, R_base.inv().apply(p_L - p_base)
