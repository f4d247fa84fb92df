"""Checks hand records against the requirements of robot labs: signal, shape, placement, steps.

Rules and limits are those of NVIDIA's acceptance test of hand devices (NVIDIA/IsaacCapture,
acceptance/hand/checker), implemented on arrays.
"""
