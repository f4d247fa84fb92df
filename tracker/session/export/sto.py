"""STO: OpenSim's name for the table that MOT is, too."""

from tracker.session.export.mot import export_mot as export_sto

__all__ = ["export_sto"]
