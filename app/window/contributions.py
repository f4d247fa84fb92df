"""Makes the panels that packages have declared."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from typing import TypeVar

from app.panels.kind import PanelKind, PanelServices
from app.panels.panel import Panel
from app.words import tr
from tracker.base.registry import Registry

PANELS = Registry("panels", "panel", PanelKind)
P = TypeVar("P", bound=Panel)
_log = logging.getLogger(__name__)


def panel_kinds() -> dict[str, PanelKind]:
    """All kinds that can be loaded, by name, in the order of the View menu."""
    kinds = PANELS.all()
    return dict(sorted(kinds.items(), key=lambda item: item[1].number or len(kinds) + 100))


def make_panels(
    kinds: Mapping[str, PanelKind], services: PanelServices, failed: Callable[[str], None]
) -> dict[str, Panel]:
    """A panel of each kind, by name. ``failed`` gets a sentence for each that cannot be made."""
    panels = {}
    for name, kind in kinds.items():
        try:
            panel = kind.make(services)
        except Exception as error:  # noqa: BLE001  one panel's fault must not stop the window
            _log.exception("The panel %s cannot be made.", name)
            failed(_why_not(kind, error))
            continue
        panel.name = name
        panel.setObjectName(f"panel_{name}")
        panel.setWindowTitle(tr(kind.title))
        panels[name] = panel
    return panels


def _why_not(kind: PanelKind, error: Exception) -> str:
    title = tr(kind.title).replace("&&", "&")
    if isinstance(error, ImportError) and kind.extra:
        text = tr("The panel {} cannot be shown: {}. Install it with pip install '{}'.")
        return text.format(title, error, kind.extra)
    return tr("The panel {} cannot be shown: {}.").format(title, error)


def panel_of(panels: Mapping[str, Panel], kind: type[P]) -> P:
    """The panel of this class. Raises LookupError if there is none."""
    for panel in panels.values():
        if isinstance(panel, kind):
            return panel
    raise LookupError(f"The window has no {kind.__name__}: is the package installed completely?")
