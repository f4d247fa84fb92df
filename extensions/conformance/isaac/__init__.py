"""NVIDIA's record of hands, `core.HandPoseRecord`: MCAP files of flatbuffers."""
