"""The files that make packages agree with each other and with the program."""

from __future__ import annotations

import configparser
import re
import xml.etree.ElementTree as ET
from pathlib import Path

from PySide6.QtGui import QImage
from PySide6.QtSvg import QSvgRenderer

ROOT = Path(__file__).parents[2]
PACKAGING, ICONS = ROOT / "packaging", ROOT / "resources" / "icons"
DEBIAN = PACKAGING / "debian"
MCAP_MAGIC = b"\x89MCAP0\r\n"


def desktop_entry() -> configparser.SectionProxy:
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    parser.read(DEBIAN / "glovetrack.desktop", "utf-8")
    return parser["Desktop Entry"]


def test_the_desktop_opens_the_declared_type() -> None:
    declared = ET.parse(DEBIAN / "glovetrack.xml").find("{*}mime-type")
    assert declared is not None
    assert desktop_entry()["MimeType"] == f"{declared.get('type')};"
    match = declared.find("{*}magic/{*}match")
    assert match is not None
    assert match.get("value", "").encode().decode("unicode_escape").encode("latin-1") == MCAP_MAGIC


def test_the_desktops_icon_is_one_of_ours() -> None:
    name = desktop_entry()["Icon"]
    assert QSvgRenderer(str(ICONS / f"{name}.svg")).isValid()
    image = QImage(str(ICONS / f"{name}.png"))
    assert (image.width(), image.height()) == (256, 256)
    assert image.pixelColor(0, 0).alpha() == 0 < image.pixelColor(128, 128).alpha()


def test_the_script_fills_every_field_of_control() -> None:
    fields = set(re.findall(r"@\w+@", (DEBIAN / "control").read_text("utf-8")))
    assert fields == set(re.findall(r"s/(@\w+@)/", (PACKAGING / "debian.sh").read_text("utf-8")))


def test_the_package_depends_on_the_required_system_libraries() -> None:
    """The bundle includes all other libraries, but never the drivers of OpenGL."""
    script = (PACKAGING / "system_libraries.sh").read_text("utf-8")
    drivers = set(re.findall(r"\s(lib(?:egl|gl)\S*)\s+essential", script))
    depends = re.search(r"^Depends: (.*)$", (DEBIAN / "control").read_text("utf-8"), re.MULTILINE)
    assert drivers
    assert depends is not None
    assert drivers - {"libglib2.0-0"} <= set(depends[1].split(", "))
