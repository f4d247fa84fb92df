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
    # ---- exports and the library
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
    # ---- imported files: IMU samples and motion
    "import.no_time": "{path} contains neither t nor a rate ({rates:list}).",
    "import.no_imu": "{path} does not contain acc and gyr of an IMU.",
    "import.imu_lengths": (
        "The IMUs in {path} have no samples, too many samples, or different numbers of samples."
    ),
    "import.pair_lengths": "{imu} in {path}: acc and gyr have different numbers of rows.",
    "import.many_numbers": "{path} contains more than {most} numbers.",
    "import.matlab_version": "{path} is a MATLAB file of version 7.3. Save it with -v7.",
    "import.not_matlab": "{path} is not a readable MATLAB file: {why}.",
    "import.time_length": "{path}: t has {times} rows, the IMUs have {samples}.",
    "import.rate": "{path}: {name} is {rate_hz:g} Hz, which is not between 1 and 100 000 Hz.",
    "import.not_table": "{what} is not a table of numbers of the expected shape.",
    "import.unknown_kind": "{path} is neither a .csv nor a .mat file.",
    "import.imus_unassigned": (
        "Assign the IMUs by --imu GLOVE=FILE. The files contain {found:list}; the glove has "
        "{imus:list}."
    ),
    "import.some_dated": (
        "Only some of the files contain the time of day, so they cannot be combined."
    ),
    "import.too_long": (
        "The files are longer than {limit_s:.0f} s, the longest that can be imported."
    ),
    "import.no_overlap": "The files do not overlap in time. Check that they use the same clock.",
    "import.imu_twice": "More than one file contains {imus:list}.",
    "import.folder_empty": "There is no {file} in {folder} or its folders.",
    "import.imu_unknown": (
        "{imu}={name} names an unknown IMU. The files contain {found:list}; the glove has "
        "{imus:list}."
    ),
    "import.no_times": "{file} does not contain two samples at different, possible times.",
    "import.unknown_unit": "{path}: the unit of {column} is unknown. Known units: {known:list}.",
    "import.no_time_column": "{path} has no time column with a unit, such as Time (s).",
    "import.no_imu_column": "{path} has no IMU column with a unit, such as Gyroscope X (deg/s).",
    "import.no_sample": "{path} contains no samples.",
    "import.not_time": "{path}: {value:g} is not a time.",
    "import.not_text": "{path} is not a text table: {why}.",
    "import.long_line": "{path}: line {line} is too long for a table.",
    "import.cells": "{path}: line {line} has {cells} cells, the header has {columns}.",
    "import.many_lines": "{path} has more than {most} lines.",
    "import.not_number": "{path}, line {line}: {cell} is not a number.",
    "motion.never_whole": "The recording contains no frame that shows the whole hand.",
    "motion.no_point": "The hand {hand} has no {point}, which the recording contains.",
    "motion.unknown_kind": (
        "{path} is not a motion file that can be read. Supported: .tsv (Qualisys), .npz "
        "(Leap) and .bvh."
    ),
    "motion.few_joints": "{path} names fewer than six joints of a hand's fingers.",
    "motion.not_qualisys": (
        "{path} has no MARKER_NAMES or FREQUENCY line, so it is not a Qualisys TSV file."
    ),
    "motion.columns": "{path} does not contain three columns for each of its markers.",
    "motion.fingers": "{path} does not contain five fingers of four joints of one hand.",
    "motion.not_bvh": "{path} is not a readable BVH file: {why}.",
    "motion.not_number": "{path} contains a value that is not a number: {why}.",
    "motion.not_leap": "{path} is not a decoded Leap recording: {why}.",
    "motion.few_frames": "{path} contains only {frames} frames of a hand; 20 are required.",
    "motion.times": "The times in {path} do not increase.",
    "motion.few_points": "{path} never shows six points of the hand at once.",
    "data.incomplete_record": "a record in it is incomplete",
    "data.compression": 'its compression "{name}" is unknown',
    "data.declared_size": "its header declares {size_bytes} bytes",
    "data.size": "its size differs from its header",
    "data.checksum": "its checksum is wrong",
    "data.many_messages": "it unpacks to more messages than a recording can contain",
    "data.offset": "its offset is invalid",
    "data.no_header": "there is no header",
    "data.long_text": "its text is too long",
    "data.array_type": "an array has an unknown type or shape",
    "data.array_size": "an array is longer than the data",
    "data.number_type": "a number has an unknown type",
    "data.not_record": '"{name}" is not a record',
    "data.no_array": "an array is missing",
    "data.bvh_parts": "it has no HIERARCHY and MOTION",
    "data.bvh_motion": "its MOTION part does not begin with Frames and Frame Time",
    "data.bvh_channels": "it does not have one number for each channel",
    # ---- tracking, filling, cropping and simulating sessions
    "track.out_is_file": "{path} is a file. Name a folder for the results of several sessions.",
    "track.no_side": "{file} does not contain the side of its hand.",
    "track.other_hand": (
        "{file} is for the hand {hand} with the glove {glove}, which the session does not contain."
    ),
    "track.same_hand": "{files:words} are for the same hand. Give one file for each hand.",
    "track.same_side": "{files:words} are for the same side. Give one file for each hand.",
    "track.one_hand": "{files:words}: the session contains one hand. Give one file.",
    "track.some_failed": "{failed} of {count} sessions could not be tracked.",
    "crop.range": "A part must start before it ends, within the {duration_s:.2f} s of {file}.",
    "gaps.none_filled": "No gap of {file} could be filled: {why:word}.",
    "gaps.max_gap": "The longest gap to fill must be greater than 0 s, not {max_gap_s:g} s.",
    "gaps.no_such_gap": (
        "{file} has no gap of the {side:word} {part} from {start_s:.3f} s to {stop_s:.3f} s. "
        "List its gaps again."
    ),
    "gaps.not_list": "{path} is not a list written by glovetrack gaps --json.",
    "noise.no_samples": "The recording contains no IMU samples.",
    "noise.short_rest": (
        "The longest rest in the recording is {rest_s:.0f} s; at least {least_s:.0f} s are "
        "required, 10 minutes are recommended. Put the glove on a table and do not touch it."
    ),
    "noise.imu_missing": "The IMU {imu} is missing in {missing_percent:.0f} % of the rest.",
    "noise.unknown_imu": "The glove file has no IMU {names:list}.",
    "fit_glove.few_postures": (
        "The recording shows {postures} different postures; at least {least} are required. Move "
        "all fingers freely in front of the camera for two minutes."
    ),
    "fit_glove.not_fitted": (
        "The glove file cannot be fitted to this recording: the postures contradict each other, or "
        "markers are more than {most_mm:.0f} mm from their positions. Check that the file is of "
        "this glove."
    ),
    "fit_glove.no_table": (
        "The glove file has no table with an id or name for {names:list}, so it cannot be changed."
    ),
    "fit_glove.two_hands": ("{path} contains two hands. Record the glove alone, then fit it."),
    "fit_glove.both_targets": "Give --set or --name, not both.",
    "fit_glove.no_camera": (
        "{path} has no stereo camera, which is required to measure the markers."
    ),
    "track.hand_length": "A profile contains the length of the hand. Leave out --hand-length.",
    "simulate.fixed_camera": "The scene {scene} requires a camera that does not move.",
    "simulate.two_hands": (
        "Both hands are simulated with random postures in front of a fixed camera. Leave out "
        "--motion, --guided, --hand, --camera and --lenses none."
    ),
    "track.smooth_engine": "Smoothing requires the engine chain, not {engine}.",
    "track.smooth_lenses": "Smoothing requires both lenses. Leave out --smooth or --lenses.",
    "track.smooth_calibration": (
        "{path} changes its camera calibration; --smooth requires a single one."
    ),
    "track.settings_not_usable": "{why} Use the default settings: --settings default.",
    "simulate.no_fabric": (
        'The simulator has no fabric of the hue "{hue}". Available: {known:list}.'
    ),
    "simulate.desk_camera": "The desk requires a camera on a stand, not on the head.",
    "simulate.light_scene": "--light requires the scene desk, not {scene}.",
    "simulate.photo_scene": "The scene photo requires an image (--photo); other scenes have none.",
    "simulate.unknown_show": 'There is no show "{name}". Available: {known:list}.',
    "simulate.two_hands_scene": (
        "Two hands can be simulated in the scenes plain, painted and photo."
    ),
    "gaps.none_of_kind": "{file} has no gap to fill ({kinds:list}).",
    "gaps.all_longer": (
        "All {count} gaps of {file} that could be filled are longer than {max_gap_s:g} s. "
        "Choose a longer --max-gap."
    ),
    "gaps.no_estimates": "No gap of {file} has estimates on both sides.",
    "track.no_images": "{path} contains no images, so other colours cannot be used.",
    "track.no_blobs": "{path} contains neither detected markers nor images.",
}
