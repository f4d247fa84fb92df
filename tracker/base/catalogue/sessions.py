"""Texts about recordings."""

TEXTS = {
    "session.messages_damaged": "Damaged messages in {file} were ignored: {topics:list}.",
    "session.line_time": "{path}: the camera's line time is not a whole number of nanoseconds.",
    "session.robot_unknown": "{path} does not describe the robot {robot}.",
    "session.robot_not_json": "The session's robot description is not JSON.",
    "session.robot_not_object": "The session's robot description is not a JSON object.",
    "session.state_damaged": "The tracking state in the recording is damaged.",
    "session.state_version": "The tracking state in the recording is of another version.",
    "session.state_invalid": "The tracking state in the recording is damaged: {why}.",
    "session.none_between": "There is no estimate between {start_s:g} s and {end_s:g} s.",
    "session.no_joint": 'There is no keypoint or joint "{name}" in this session.',
    "session.not_tracked": "{path} contains no estimates. Track it first.",
    "session.none_in": "There is no session in {path}.",
    "session.image_damaged": "An image of {camera} is damaged.",
    "session.image_kind": "An image of {camera} is neither JPEG nor PNG.",
    "session.image_size": "An image of {camera} claims a size of {width} by {height} pixels.",
    "session.many_types": "A session has at most {most} types of messages.",
    "session.many_channels": "A session has at most {most} channels.",
    "session.header_damaged": "{path} is not an MCAP file: its header is damaged.",
    "session.not_orderable": "{path} cannot be read in order: its chunks all overlap.",
    "session.not_mcap": "{path} is not an MCAP file.",
    "session.record_size": "{path} contains a record of {size_bytes} bytes: it is damaged.",
    "session.no_imu": "{path} contains no IMU samples.",
    "session.part_too_large": "{path} contains no {part} of at most {limit_bytes} bytes.",
    "session.part_missing": (
        "{path} contains no {part}: it was not recorded by Glovetrack, or only in part."
    ),
    "session.start_time": (
        "{path} has an impossible start time: its wall_clock_ns, its monotonic_ns or its "
        "first log time is out of range."
    ),
    "session.glove_side": "{path} is for the {side:word} hand.",
    "session.no_stereo": "{path} does not describe a stereo camera. Missing: {missing:list}.",
    "session.nothing_recovered": "{path} contains nothing that can be recovered.",
    "session.instant_range": (
        "An instant is outside the years 1901 to 2038, which ROS 2 can represent."
    ),
    "session.state_misfit": (
        "The start state of this recording does not match the engine {engine} with this "
        "hand and glove, so it cannot be tracked again. ({where})"
    ),
    "session.damaged_topic": "{count} on {topic}",
    "session.damaged_more": "others on {count} more {count:topic|topics}",
    "check.silent": "No messages for {silent_s:.1f} s.",
    "check.unfinished": (
        "The recording was not finished. `glovetrack recover` makes a complete file of it."
    ),
    "check.profile": 'The profile is "{profile}", not "ros2".',
    "check.foreign": "The file was not recorded by Glovetrack.",
    "check.no_rig": "The stereo calibration or the pose of the camera is missing.",
    "check.damaged_messages": "Damaged messages: {count} ({at} after the start).",
    "check.repeated": "Repeated messages: {count}. Tracking uses each once.",
    "check.backward": "Time stamps that run backwards: {count}.",
    "check.jumps": "Jumps of the clock: {count}.",
    "check.late": (
        "Messages arrived up to {late_s:.1f} s late (in all {count} times): the computer was "
        "overloaded."
    ),
    "check.gaps": "Gaps: {count}, the longest {longest_s:.3f} s after {after_s:.1f} s.",
    "check.interpolated": "Interpolated positions that are marked as measured: {count}.",
    "check.no_imu": "The file contains no messages of this IMU.",
    "check.no_camera": "The file contains neither images nor blobs of a camera.",
    "check.data_end": "The data section does not end where the summary begins.",
    "check.checksum": "The checksum of the data section is wrong.",
    "check.summary_differs": "The summary and the file differ: {records}.",
    "check.message_index": "The message index differs from the messages of the chunk.",
    "check.summary_damaged": "The summary is damaged.",
    "check.breaks_off": "The file ends within a record.",
    "check.definition": "A definition is damaged.",
    "check.short_chunk": "A chunk is too short.",
    "check.future_chunk": "A chunk has an impossible log time.",
    "check.chunk": "A chunk cannot be read ({why}).",
    "align.unknown_method": 'Recordings are aligned by {known:or}, not by "{method}".',
    "align.no_overlap": "According to their clocks the recordings were not made at the same time.",
    "align.too_short": "The recordings do not share {needed_s:g} s of movement.",
    "align.no_fit": "The movements do not match (correlation {correlation:.2f}).",
    "align.ambiguous": (
        "The movements match at more than one offset (correlations {correlation:.2f} and "
        "{elsewhere:.2f}): they are too regular."
    ),
    "align.no_movement": "A recording contains too little movement to be aligned by it.",
    "align.nothing_common": "The recordings have neither IMUs nor tracked angles in common.",
    "align.not_alignment": "{path} is not an alignment of two recordings.",
    "compare.no_hand": "{first} and {second} have no hand in common.",
    "compare.no_instant": "{first} and {second} do not overlap in time.",
    "edits.schema": '{file} has schema "{schema}", not {expected}.',
    "edits.invalid": "{file} is not a record of edits: {why}.",
    "edits.too_many": "{file} lists {fills} filled gaps; at most {most} are read.",
    "recording.started": "Recording started.",
    "recording.finished": "The recording is complete.",
    "recording.ended": "The recording has ended: {why}",
    "recording.not_finished": "The recording could not be completed: {why}",
    "recording.exists": "{path} already exists. A recording never overwrites a file.",
    "recording.process_ended": (
        "The recorder's process {why}.{there} You can start another recording."
    ),
    "recording.disk_low": "Only {free_gb:.1f} GB are left on the disk of {folder}.",
    "recording.disk_full_stopped": (
        "The disk of {folder} is nearly full ({left} left), so recording has stopped. "
        "What was recorded is safe. Free some space."
    ),
    "recording.disk_full": (
        "The disk of {folder} is nearly full ({left} left), so recording is not possible."
        " Free some space."
    ),
    "recording.has_ended": "The recording {path} has already ended.",
    "recording.images": 'Images can be {known:or}, not "{value}".',
    "recording.compression": 'Compression can be {known:or}, not "{value}".',
    "recording.jpeg_quality": "The JPEG quality is {quality}; it must be 1 to 100.",
    "session.attachment_damaged": (
        "{path} is damaged: the attachment at byte {offset} is incomplete. Save what can be "
        "read with glovetrack recover."
    ),
    "session.chunk_damaged": (
        "{path} is damaged in the chunk at byte {offset}: {why}. Save what can be read with "
        "glovetrack recover."
    ),
    "session.rig_invalid": "{path}: {why}",
    "api.needs_calibration": (
        "The camera requires a calibration. Pass the path of its calibration file, which the "
        "window creates under Set-up, Camera calibration."
    ),
    "api.two_hands": 'Two hands are tracked. Specify side="left" or side="right".',
    "api.both_recorded": (
        '{file} is a recording of both hands. Choose hands["left"] or hands["right"]; for an IMU, '
        'side="left" or side="right".'
    ),
    "api.other_side": "{file} is a recording of the {side:word} hand.",
    "session.damaged_at": (
        "{path} is damaged at byte {offset}. Save what can be read with glovetrack recover."
    ),
    "session.damaged_why": (
        "{path} is damaged at byte {offset}: {why}. Save what can be read with glovetrack recover."
    ),
    "session.no_chunk": "there is no chunk",
    "session.far_future": "a message has a log time in the far future",
    "rename.no_name": "{file} needs a name with a letter or a digit in it.",
    "rename.exists": "{other} already exists, so {file} was not renamed.",
    "rename.failed": "{file} cannot be named {other}: {why}.",
}
