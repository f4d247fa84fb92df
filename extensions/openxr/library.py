"""The compiled API layer: where it is, and its name for the loader."""

from __future__ import annotations

import sys
from pathlib import Path

LAYER = "XR_APILAYER_GLOVETRACK_hands"
SOURCES = Path(__file__).parent / "layer"
LIBRARY_NAME = "glovetrack_openxr.dll" if sys.platform == "win32" else "libglovetrack_openxr.so"
LIBRARY = SOURCES / LIBRARY_NAME
"""Made by ``make openxr-layer``; absent where it was not compiled."""
DISABLE = "GLOVETRACK_OPENXR_DISABLE"
"""Environment variable with which an application is started without the layer."""
EXTENSIONS = {"XR_EXT_hand_tracking": 4, "XR_EXT_hand_tracking_data_source": 1}
"""What the layer adds, with the version of each."""


def manifest(library: Path) -> dict[str, object]:
    """The loader's description of an implicit layer whose library is at ``library``."""
    return {
        "file_format_version": "1.0.0",
        "api_layer": {
            "name": LAYER,
            "library_path": str(library),
            "api_version": "1.0",
            "implementation_version": "1",
            "description": "Hands of a running Glovetrack for XR_EXT_hand_tracking",
            "disable_environment": DISABLE,
            "instance_extensions": [
                {"name": name, "extension_version": str(version), "entrypoints": []}
                for name, version in EXTENSIONS.items()
            ],
        },
    }
