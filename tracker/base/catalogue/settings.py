"""Texts about files, settings, streams and remote control."""

TEXTS = {
    "config.not_toml": "{file} is not valid TOML: {why}.",
    "config.too_deep": "{file} is not valid TOML: it is nested too deeply.",
    "config.too_large": (
        "{file} is larger than {limit_bytes} bytes, so it is not a configuration file."
    ),
    "config.unclosed_text": "{file} is not valid TOML: a text in line {line} is not closed.",
    "config.invalid_value": "{file}, line {line}: {key} {why}.",
    "config.not_utf8": "{file} is not a UTF-8 text file.",
    "config.invalid_setting": "settings: {key} {why}.",
    "config.streams_table": "{file}: streams must be a table.",
    "config.unknown_stream": "{file}: streams.{key} {why}.",
    "file.not_writable": "{path} cannot be written: {why:word}.",
    "file.not_regular": "{path} is not a regular file.",
    "file.too_large": "{path} is larger than {limit_bytes} bytes, so it is not {what:word}.",
    "file.is_input": "{path} is an input. Choose another name for the output.",
    "file.occupied": "{path} already exists and is {what:word}. Choose another name.",
    "file.exists_force": (
        "{path} already exists. Choose another name, or use --force to replace it."
    ),
    "file.folder_not_empty": (
        "The folder {folder} is not empty. Choose another one, or use --force to replace "
        "files in it."
    ),
    "file.exists": "{path} already exists. Choose another name.",
    "file.not_readable": "{path} cannot be read: {why}.",
    "file.missing": "There is no file {path}.",
    "part.unknown": 'There is no {kind} "{name}". Available: {known:list}.',
    "part.not_loaded": "The {kind} {name} cannot be loaded: {why}",
    "part.wrong_type": "The {kind} {name} cannot be loaded: {entry} is not a {expected}.",
    "stream.needs_package": "{what} requires a package that is not installed ({why}).{install}",
    "stream.bad_port": '"{value}" is not a port for the {kind} {what}: ports are 1 to 65535.',
    "stream.no_port": "The {kind} {what} has no port: clients find it by its name.",
    "stream.no_route": "The {what} stream cannot go to {host}:{port}: {why}.",
    "stream.port_range": "The {what} stream cannot go to {host}:{port}: ports are 1 to 65535.",
    "stream.joints": 'Joints can be {known:or}, not "{value}".',
    "stream.publishers": "The {kind} stream made {made} publishers for {hands} hands.",
    "stream.server_not_started": "The {kind} server cannot start at {host}:{port}: {why}.",
    "stream.process_ended": "The process of the streams has ended. Switch the streams on again.",
    "stream.process_silent": "The process of the streams does not answer.",
    "stream.test_off": "{stream}: switch it on and start tracking, then test it.",
    "stream.test_clients": "{stream}: received by {count} connected programs.",
    "stream.test_read": "{stream}: received by at least one program.",
    "stream.test_no_client": "{stream}: no program is connected.",
    "stream.test_refused": (
        "{stream}: {size} bytes were sent and refused (port unreachable). No program receives at "
        "this address."
    ),
    "stream.test_udp": (
        "{stream}: {size} bytes were sent and not refused. UDP sends no answer, so whether a "
        "program received them is unknown."
    ),
    "stream.test_nothing": "{stream}: nothing has been sent yet, because no hand is tracked.",
    "stream.test_sent": (
        "{stream}: {count} messages were sent. The protocol does not report whether a program "
        "received them."
    ),
    "stream.to": "{stream} to {host}:{port}",
    "stream.at": "{stream} at {host}:{port}",
    "stream.outlet": "{stream} outlet {name}",
    "stream.failing": "The stream {stream} fails. {why}",
    "stream.works_again": "The stream {stream} works again.",
    "remote.not_started": "Remote control by {kind} cannot start at {host}:{port}: {why}.",
    "remote.closing": "The window is closing.",
    "remote.not_request": "The message is a reply, not a request.",
    "remote.recording_already": "{file} is already being recorded.",
    "remote.no_device": "Nothing can be recorded: no device is running.",
    "remote.replayed": "A replayed session cannot be recorded.",
    "remote.not_begun": "The recording did not start.",
    "remote.not_recording": "Nothing is being recorded.",
    "remote.nothing_open": "The note was not added: no device or session is open.",
    "remote.no_motors": "No glove with motors is running.",
    "remote.motor_limit": "A motor accepts at most {rate_hz:.0f} requests per second.",
    "remote.contact_limit": "A finger accepts at most {rate_hz:.0f} contacts per second.",
    "remote.queue_full": "The glove's send queue is full. The motor was not started.",
    "remote.not_running": "Nothing is being tracked, so contacts are not accepted.",
    "remote.no_side": "No glove for this side is running.",
    "remote.no_answer": "The window did not respond, so nothing was done.",
    "system.shared_memory_full": (
        "The system has less than {needed_mb:.0f} MB of shared memory left, which is "
        "required to pass images between processes. Close other programs."
    ),
    "request.too_long": "A request has at most {most} bytes.",
    "request.not_readable": "A request is JSON or plain text, in UTF-8.",
    "request.unknown": "The field do must be {known:or}.",
    "request.unknown_field": '{do} has no field "{field}".',
    "request.text": "The field text must be a text.",
    "request.note_empty": "A note requires a text.",
    "request.note_too_long": "A note has at most {most} characters.",
    "request.finger": "finger must be {fingers:or}.",
    "request.finger_missing": "{do} requires a finger: {fingers:or}.",
    "request.integer": "{field} must be an integer from {least} to {most}.",
    "request.strength": "strength is a number from 0 (no contact) to 1.",
    "request.object": "object is a name of at most {most} characters.",
    "request.id": "id is an integer or a text of at most {most} characters.",
    "request.too_many": "At most {rate_hz:.0f} requests per second are accepted.",
    "request.busy": "The window is loaded: too many requests are waiting. Try again later.",
    "file.unpacked_size": "{path} contains more than {limit_mb} MB.",
    "stream.no_option": 'The {kind} {what} has no option "{option}". Options: {known:list}.',
    "stream.bad_option": '"{value}" is not a value for {option} of the {kind} {what}.',
    "stream.schema": "The schema of JSON messages can be {known}, not {schema}.",
    "stream.other_hand": "The stream is of another hand or another version.",
    "stream.not_ours": "The stream contains a message that is not from Glovetrack: {why}.",
    "remote.no_window": (
        "No window responds at {host}:{port}: {why}. Check that remote control by UDP is on."
    ),
    "stream.closed": "The {what} is closed.",
    "window.foreign_pipe": (
        "The program at the other end of {address} does not belong to you. End it, or ask "
        "your administrator to, then start again."
    ),
    "window.foreign_socket": (
        "The program that listens at {address} belongs to another user (id {uid}). Remove "
        "that file, or set XDG_RUNTIME_DIR to a folder of your own, then start again."
    ),
    "window.socket_folder": (
        "{folder} is used for the window's socket and must be a folder of your own that no "
        "other user can enter (mode 0700). Remove it, or set XDG_RUNTIME_DIR to a folder of "
        "your own, then start again."
    ),
    "window.file_not_usable": "{path} cannot be used: {why}.",
    "window.other_program": (
        "The program that listens at the address of Glovetrack is not a Glovetrack window. "
        "Close it, then start Glovetrack again."
    ),
    "file.not_created": "{path} cannot be created: {why}.",
    "config.key": "{file}: {key} {why}.",
    "window.no_answer": (
        "The window does not answer within {seconds} s. It may still do what was requested."
    ),
    "window.none": "No window is open. Open one with glovetrack.",
    "stream.failed": "{stream}: {why}.",
    "stream.not_connected": "{stream}: not connected.",
    "stream.no_connection": "{stream}: no connection ({why}).",
    # ---- command-line options and commands
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
    # ---- the keys of TOML files; each continues the key, as `config.key` does
    "toml.missing": "is missing",
    "toml.text": "must be a text",
    "toml.choice": 'is "{value}"; it must be {known:or}',
    "toml.name": (
        'has the name "{name}"; a name is a letter, followed by at most 63 letters, digits, _ and -'
    ),
    "toml.label": 'is "{label}"; a label has at most 64 printable characters and no comma',
    "toml.integer": "must be an integer",
    "toml.too_large": "is too large",
    "toml.number": "must be a number",
    "toml.finite": "must be a finite number",
    "toml.range": "is {value:g}; it must be between {low:g} and {high:g}",
    "toml.numbers": "must be a list of {count} numbers",
    "toml.norm": "has length {norm:.4g}; it must be 1 within {tolerance:g}",
    "toml.names": "must be a list that contains only {known:or}",
    "toml.twice": "contains a value twice",
    "toml.table": "must be a table",
    "toml.table_list": "must be written as [[{key}]] tables",
    "toml.many_tables": "has {count} tables; at most {most} are allowed",
    "toml.unknown_key": "is not a known key",
    "toml.texts": "must be a text or a list of texts",
    "toml.schema": "is not {expected}; this version cannot read the file",
    "glove.file_side": "is {side:word}, but the hand {hand} is a {hand_side:word} hand",
    "toml.ids": "must have the ids 0 to {last}",
    "glove.file_name_taken": 'repeats the name "{name}" of the skeleton',
    "hand.unknown_segment": 'contains the unknown segment "{segment}"',
    "hand.no_root": "does not contain {root}",
    "hand.limits": "must be [lower, upper]",
    "hand.length_sum": "is {length_m:g} m, but {segments:words} add up to {sum_m:.4g} m",
    "hand.unknown_parent": 'gives {segment} the unknown parent "{parent}"',
    "hand.loop": "contains a loop through {names:list}",
    "hand.two_joints": "defines two joints for {segment}",
    "hand.abduction": "may contain abduction only where abduction is free and twist is not",
    "hand.unknown_angle": 'contains the unknown angle "{angle}"',
    "colours.file_no_hue": "must contain at least one hue",
    "colours.file_encoding": "is damaged: it must be base64 of zlib data",
    "colours.file_cells": "must contain {expected} bytes",
    "colours.file_hue": "refers to a hue beyond the {hues} hues of the file",
    "colours.file_integers": "must be two integers",
    "toml.between": "must be between {low:g} and {high:g}",
    "toml.order": "must contain the smaller number first",
    "colours.file_pair": "must be two numbers of at least 0, the smaller one first",
    "glove.file_twice": 'contains "{name}" twice',
    "glove.file_two_imus": "has two IMUs on {segment}",
    "toml.setting": "is not a setting",
    "toml.type": "must be of the type {type}",
    "toml.long_number": "is a number of {digits} digits",
    "toml.many_parts": "has more than {most} parts",
    "toml.deep": "is nested more than {most} deep",
    "glove.file_drift_sd": "and accel_sd must not be negative",
    "glove.file_axes": "must be within {limit:g} of the identity matrix",
}
