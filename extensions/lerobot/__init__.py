"""Export of LeRobot data sets, version 3: Parquet folders with an episode per session or part of
one.

Source: huggingface/lerobot, src/lerobot/datasets. Positions and orientations are those of OpenXR's
26 joints in OpenXR's world.
"""
