"""Texts of the notices of movement science."""

TEXTS = {
    "osim.no_model": "{path} is not an OpenSim model.",
    "osim.old_model": (
        "{path} has the format of OpenSim 3. Open it in OpenSim 4 and save it, then use that file."
    ),
    "osim.no_segment": "{path} has no body {name}. Available: {known:list}.",
    "osim.no_overlap": (
        "The motion of the body has no row between {start_s:.2f} and {end_s:.2f} s, where the "
        "session is. Specify another --offset."
    ),
}
