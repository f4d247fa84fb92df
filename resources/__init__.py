"""Files that travel with the program: hands, gloves, colour profiles, icons."""

from importlib.resources import files
from importlib.resources.abc import Traversable


def folder(kind: str) -> Traversable:
    """The folder ``kind``: hands, gloves, colours, icons, meshes, schemas, firmware or udev."""
    return files(__name__) / kind
