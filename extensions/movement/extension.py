"""Descriptors of the movement extension's export formats."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.session.export.formats import COMMON, ExportFormat

_WITHOUT_UNITS = tuple(name for name in COMMON if name != "units")
_WHOLE_HAND = tuple(name for name in _WITHOUT_UNITS if name != "joints")


TRC = ExportFormat(
    "trc",
    "OpenSim markers (TRC)",
    deferred("extensions.movement.opensim:export_trc").load,
    order=50,
)
MOT = ExportFormat(
    "mot",
    "OpenSim joint angles (MOT)",
    deferred("extensions.movement.opensim:export_mot").load,
    options=_WITHOUT_UNITS,
    order=60,
)
STO = ExportFormat(
    "sto",
    "OpenSim orientations of the IMUs (STO)",
    deferred("extensions.movement.osim:export_sto").load,
    options=_WHOLE_HAND,
    order=70,
)
OSIM = ExportFormat(
    "osim",
    "OpenSim model of the hand as tracked (OSIM)",
    deferred("extensions.movement.osim:export_osim").load,
    options=_WHOLE_HAND,
    order=80,
)
BIDS = ExportFormat(
    "bids",
    "Data set for laboratories (Motion-BIDS, a folder)",
    deferred("extensions.movement.bids:export_bids").load,
    folder=True,
    order=150,
)
