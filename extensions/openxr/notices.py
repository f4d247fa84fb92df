"""Texts of the OpenXR layer's notices."""

TEXTS = {
    "openxr.layer": "OpenXR layer",
    "openxr.no_compiler": "No C++ compiler was found. Install one; on Debian: apt-get install g++",
    "openxr.no_headers": (
        "The headers of OpenXR were not found. Install them; on Debian: apt-get install "
        "libopenxr-dev"
    ),
    "openxr.not_compiled": "{file} cannot be compiled: {why}",
    "openxr.joints_missing": "The hand lacks joints that OpenXR requires: {joints}.",
    "openxr.memory_removed": "{path} cannot be created: another program removes it repeatedly.",
    "openxr.system": "The OpenXR layer requires Linux or Windows.",
    "openxr.other_user": "{path} belongs to another user.",
    "openxr.occupied": "Another Glovetrack already sends its hand to OpenXR.",
    "openxr.one_hand": "OpenXR has only one {side:word} hand.",
    "openxr.no_layer": (
        "The OpenXR layer is not part of this installation. In a checkout, run make openxr-layer."
    ),
    "openxr.not_registered": "The OpenXR layer cannot be registered: {why}.",
    "openxr.not_unregistered": "The OpenXR layer cannot be unregistered: {why}.",
}
