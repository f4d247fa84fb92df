"""Texts of the notices of studies, by code."""

TEXTS = {
    "study.no_participant": "The protocol has no participant {name}. It has: {known:list}.",
    "study.other_protocol": (
        "The folder {folder} contains a study by another protocol. Continue with the protocol in "
        "{stored}, or choose another folder."
    ),
    "study.no_study": "{folder} contains no study. Start one with: glovetrack study run.",
    "study.progress_damaged": "The progress file {path} is damaged: {why}.",
    "study.in_use": "Another program is running the trials of {participant} in {folder}.",
    "study.no_trials": "The study in {folder} has no accepted trial yet.",
    "study.no_truth": (
        "No accepted trial has a reference. Add motion-capture recordings with glovetrack "
        "import-reference; only simulated trials contain their truth."
    ),
    "study.unknown_variant": "Unknown variant {name}. Available: {known:list}.",
    "study.needs_extension": "This requires the extension {name}, which is not installed.",
    "study.no_engine": "Nothing is tracked. Connect the glove and the camera, then start again.",
    "study.no_recording": "Another recording is running. Stop it, then start again.",
    "study.unfinished": "The recording was interrupted before its end.",
    "study.unreadable": "The recording cannot be read: {why}",
    "study.short": (
        "The recording lasts {duration_s:.1f} s; the protocol requires {least_s:.1f} s."
    ),
    "study.untracked": (
        "The hand was tracked for {found_percent:.0f} % of the time; the protocol requires "
        "{least_percent:.0f} %."
    ),
    "study.unmeasured": (
        "Keypoints were measured for {found_percent:.0f} % of the time; the protocol requires "
        "{least_percent:.0f} %."
    ),
    "study.packets_lost": (
        "{found_percent:.1f} % of the packets were lost; the protocol allows {most_percent:.1f} %."
    ),
    "study.packet_rate": (
        "{found_hz:.0f} packets per second arrived; the protocol requires {least_hz:.0f}."
    ),
    "study.images_missed": (
        "{found_percent:.0f} % of the images were not searched; the protocol allows "
        "{most_percent:.0f} %."
    ),
    "study.image_rate": (
        "{found_hz:.1f} images per second arrived; the protocol requires {least_hz:.1f}."
    ),
    "study.no_condition": "is missing: a study has at least one condition",
    "study.task_unused": "is not part of any condition",
    "study.participants": "is missing: give a number or a list of labels",
    "study.task_twice": "contains a task twice; use trials instead",
    "study.things_drawn": "is {drawn}, but there are {count} things",
    "study.things_undrawn": "requires things_drawn: how many things a trial uses",
    "study.no_duration": "requires a duration",
    "study.no_time": "leaves no time for cues",
    "study.picture_outside": 'contains the picture "{picture}", which is outside its folder',
    "study.picture_missing": 'contains the picture "{picture}", which does not exist',
    "study.unknown_task": 'contains "{task}", which is not a task. Known tasks: {known}',
    "study.label": 'contains "{label}", which is not a label: use 1 to 32 letters and digits',
}
