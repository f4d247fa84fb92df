"""Texts about command-line options and commands."""

TEXTS = {
    "option.choice": '{option} can be {known:or}, not "{value}".',
    "option.range": "{option} must be between {low} and {high}.",
    "command.packages": (
        "The command {command} requires packages that are not installed ({why}). Install "
        'them: pip install "glovetrack[{extra}]".'
    ),
    "workers.no_dask": "A cluster requires Dask. Install glovetrack[cluster].",
    "workers.no_scheduler": "No Dask scheduler responds at {address}.",
    "workers.stopped": "The work was stopped.",
    "workers.ended": "The process that worked on it ended unexpectedly ({kind}: {why}).",
    "doctor.unknown_check": "There is no check {names:list}. Available: {known:list}.",
    "option.together": "{options:words} must be given together.",
    "option.requires": "{option} requires {needed}.",
    "option.least": "{option} must be at least {least}.",
    "option.exclusive": "{options:words} cannot be used together.",
    "option.positive": "{option} must be greater than 0.",
    "option.exactly_one": "Specify exactly one of {options:list}.",
    "option.packages": (
        "{option} requires packages that are not installed. Install them: pip install "
        '"glovetrack[{extra}]".'
    ),
    "option.html": "The report is an HTML page: {file} must end in .html.",
    "command.none": (
        "No commands are registered, because the installation is incomplete or older than "
        "the program. Install Glovetrack again."
    ),
}
