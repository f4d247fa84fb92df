"""Errors that reach a user: the text is a whole sentence in the user's words."""


class GlovetrackError(Exception):
    """Something the user asked for could not be done; ``str(error)`` says what and why."""


class FileError(GlovetrackError):
    """A file is missing, damaged or not what it claims to be."""


class DeviceError(GlovetrackError):
    """A glove or camera is absent, busy or misbehaving."""


class ConfigError(GlovetrackError):
    """A setting has an unknown name, a wrong type or an impossible value."""
