"""Texts about exports and the library."""

TEXTS = {
    "export.data_set": (
        "{format} is a data set of many sessions. Give more than one session, or choose "
        "another format."
    ),
    "export.one_session": "{format} contains one session; {others:list} can contain several.",
    "export.format_missing": "The format {format} cannot be used: {why}.{install}",
    "export.not_supported": "The format {format} does not support {options:list}.",
    "export.session_needs": (
        "A session requires its {parts:list}. Leave out participant and notes by name."
    ),
    "export.images": 'Images can be {known:or}, not "{value}".',
    "export.rate": "A rate of {rate_hz:g} Hz is not between {least_hz:g} and {most_hz:g} Hz.",
    "export.every": "--every must be at least 1, not {every}.",
    "export.views": 'Views can be {known:or}, not "{value}".',
    "export.axes": 'Axes can be {known:or}, not "{value}".',
    "export.joints": "Joints are either openxr or names of Glovetrack, not both.",
    "export.units": 'Units can be {known:or}, not "{value}".',
    "export.too_many_rows": (
        "{estimates} estimates over {seconds:.0f} s would be {rows} rows at {rate_hz:g} "
        "Hz. Export a part of them."
    ),
    "export.needs_arrow": "Parquet requires Arrow. Install glovetrack[parquet].",
    "export.incomplete": "{file} could not be written completely. The disk may be full.",
    "library.unknown": (
        'There is no "{name}" among the {kind:word}. Available: {known:list}; or enter '
        "the path of a file."
    ),
}
