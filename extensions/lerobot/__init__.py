"""LeRobot's data sets, version 3: folders of Parquet, an episode for each session or part of one.

Source: huggingface/lerobot, src/lerobot/datasets. Positions and orientations are of OpenXR's 26
joints in OpenXR's world.
"""
