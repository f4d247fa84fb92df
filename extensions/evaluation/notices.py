"""Texts of the evaluation's notices."""

TEXTS = {
    "evaluation.hands_options": (
        "--pairs must be at least 1, --seconds at least 4, and --fps between 5 and 240."
    ),
    "evaluation.no_broad": "{folder} contains no BROAD recordings (*.mat).",
    "evaluation.not_broad": "{path} is not a recording of the BROAD data set: {why}.",
    "evaluation.no_robot": "This protocol requires the extension extensions/robot.",
    "evaluation.shutter_options": (
        "--participants must be at least 1, --seconds at least 5, and --readout-ms greater "
        "than 0 and at most 50."
    ),
    "vist.unknown": 'Unknown {what}: "{name}". Available: {known:list}.',
    "vist.sessions_of_points": (
        "Other sessions need a camera and --level points. Leave out --sessions."
    ),
    "vist.needs_camera": "Only the engine inertial can be evaluated without a camera.",
    "vist.no_images": "The engine inertial does not use images. Add --lenses none.",
    "vist.both_lenses": "The engine {engine} requires both lenses. Add --engines chain.",
    "vist.profile_engine": "Only the engine chain uses a wearer's profile. Add --engines chain.",
    "evaluation.report_not_written": "The report could not be written: {why}.",
    "vist.other_version": (
        "{folder} contains trials of another version of the program, which cannot be "
        "combined with new ones. Choose another folder, or empty it."
    ),
    "vist.damaged_trial": "The stored trial {path} is damaged. Delete it to compute it again.",
    "evaluation.effects_options": "--participants must be at least 1, and --seconds at least 5.",
    "evaluation.no_truth": (
        "{file} does not contain a true hand. Choose a simulated session that was recorded with it."
    ),
    "evaluation.gaps_options": "--participants must be at least 1, and --gaps between 0.1 and 60.",
}
