"""Texts of reference recordings' notices."""

TEXTS = {
    "reference.empty": "{file} does not contain two instants with a point.",
    "reference.not_readable": "{file} cannot be read: {why}.",
    "reference.cut_off": "{file} is shorter than its header states. Copy it from the source again.",
    "reference.no_rate": "{file} does not state its points' names and sample rate.",
    "reference.unknown_unit": "{file} has lengths in {unit!r}; known units: {known}.",
    "reference.unknown_format": (
        "{file} is not a C3D, TRC, BVH, Qualisys, OptiTrack or Vicon file. For another CSV, write a"
        " mapping file with [columns]."
    ),
    "reference.no_point": "{file} does not contain the point {point}. Its points: {known}.",
    "reference.no_column": "{file} does not contain the column {column}. Its columns: {known}.",
    "reference.few_points": (
        "{file}: {found} of its points are named like keypoints of the hand; at least 3 are needed."
        " Name them in a mapping file. Its points: {known}."
    ),
    "reference.no_clock": (
        "The reference of {session} does not contain the time of its first frame. State it"
        " (--start), or align by movement."
    ),
    "reference.bad_start": "{text!r} is not a time. Example: 2026-03-31T14:05:09.120+02:00.",
    "reference.no_overlap": "The reference and {session} do not overlap in time.",
    "reference.no_pulses": "The session does not contain events of the kind pulse.",
    "reference.no_pulses_in_file": (
        "The reference does not contain events of this name. State the name of its events or of an"
        " analogue channel (--pulse)."
    ),
    "reference.pulses_differ": (
        "The pulses of the reference ({theirs}) and of the session ({ours}) do not match at one"
        " offset."
    ),
    "reference.no_movement": (
        "The movement does not determine the time offset: {windows} parts of the recording agree."
        " Record larger movements, or align by clock or pulse."
    ),
    "reference.mirrored": (
        "{file} is mirrored: its points fit the session after a reflection ({mirrored_mm:.1f} mm)"
        " and not without ({residual_mm:.1f} mm). Export it with right-handed axes."
    ),
    "reference.few_instants": (
        "{file} and the session have {found} instants in common; at least {needed} are needed."
    ),
    "reference.no_keypoint": "The hand has no keypoint {name}. Its keypoints: {known}.",
    "reference.none": (
        "{session} does not contain a reference. Import one (Replay, Import reference…, or"
        " glovetrack import-reference)."
    ),
    "reference.partly_covered": (
        "The reference covers {share:.0f} % of the session. The remaining time is not evaluated."
    ),
    "reference.drift_unknown": (
        "The drift of the clocks cannot be determined to 100 ppm and is taken as 0."
    ),
    "reference.time_scatters": (
        "The time offset varies by {residual_ms:.1f} ms (rms) over the recording. Errors of fast"
        " movements contain this."
    ),
    "reference.large_residual": (
        "After the registration, reference and session are {residual_mm:.0f} mm apart (rms). Check"
        " the names of the points, the unit, and that both recorded the same hand."
    ),
    "reference.offsets_uncertain": (
        "The marker offsets of {keypoints:list} are known to {sd_mm:.0f} mm only. In the next"
        " recording, turn the hand about all axes."
    ),
    "reference.offsets_inferred": (
        "{keypoints:list}: never or hardly measured by the glove. Their marker offsets are medians"
        " over the recording."
    ),
    "reference.not_drawn": (
        "The replay draws the points of the reference instead of a hand, because of missing ones:"
        " {keypoints:list}."
    ),
    "reference.damaged": "{session}: the description of the reference cannot be read.",
    "reference.time_and_rate": "or else rate must be given, not both",
    "reference.three_columns": "must be a list of its three columns x, y and z",
}
