"""The wearer's calibration by the chain filter: control, profile, rest bias."""
