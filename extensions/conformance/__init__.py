"""Whether a hand record is what robot labs ask for: signal, shape, placement, scripted steps.

The rules and limits are those of NVIDIA's acceptance of hand devices (NVIDIA/IsaacCapture,
acceptance/hand/checker), written anew on arrays.
"""
