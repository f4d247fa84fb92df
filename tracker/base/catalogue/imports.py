"""Texts about imported files: IMU samples and motion."""

TEXTS = {
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
}
