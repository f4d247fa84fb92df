"""Descriptors of the movement extension's export formats."""

from __future__ import annotations

from tracker.session.export.formats import COMMON, ExportFormat, Writer

_WITHOUT_UNITS = tuple(name for name in COMMON if name != "units")
_WHOLE_HAND = tuple(name for name in _WITHOUT_UNITS if name != "joints")


def _trc() -> Writer:
    from extensions.movement.opensim import export_trc

    return export_trc


def _mot() -> Writer:
    from extensions.movement.opensim import export_mot

    return export_mot


def _sto() -> Writer:
    from extensions.movement.osim import export_sto

    return export_sto


def _osim() -> Writer:
    from extensions.movement.osim import export_osim

    return export_osim


def _bids() -> Writer:
    from extensions.movement.bids import export_bids

    return export_bids


TRC = ExportFormat("trc", "OpenSim markers (TRC)", _trc, order=50)
MOT = ExportFormat("mot", "OpenSim joint angles (MOT)", _mot, options=_WITHOUT_UNITS, order=60)
STO = ExportFormat(
    "sto", "OpenSim orientations of the IMUs (STO)", _sto, options=_WHOLE_HAND, order=70
)
OSIM = ExportFormat(
    "osim", "OpenSim model of the hand as tracked (OSIM)", _osim, options=_WHOLE_HAND, order=80
)
BIDS = ExportFormat(
    "bids",
    "Data set for laboratories (Motion-BIDS, a folder)",
    _bids,
    folder=True,
    order=150,
)
