"""Texts of the notices of the touch test, by code."""

TEXTS = {
    "touch.no_sheet": (
        "No image shows the sheet of the touch test. Print it with: glovetrack print touch. "
        "Record with images, with the whole sheet in view."
    ),
    "touch.print_scale": (
        "The printed squares measure {found_mm:.2f} mm instead of 20.00 mm ({percent:+.1f} %). "
        "Print at 100 %, not fitted to the page."
    ),
    "touch.camera_scale": (
        "The stereo camera measures the sheet {percent:+.1f} % off its size. Calibrate the camera."
    ),
    "touch.sheet_fit": (
        "The sheet's corners differ by {fit_px:.1f} px from a flat sheet. Flatten the sheet, or "
        "calibrate the camera."
    ),
    "touch.sheet_moved": (
        "The sheet moved by {moved_mm:.1f} mm during the test. Tape it to the table and repeat."
    ),
    "touch.no_ruler": (
        "The printed line of 260 mm was not measured. The scale of the camera is therefore taken "
        "to be right."
    ),
    "touch.moving_camera": "The touch test requires a camera that does not move.",
    "touch.no_estimates": "The session contains no tracked hand. Track it first: glovetrack track.",
    "touch.too_few": (
        "{count} touches were found; the touch test requires {least} of at least one finger."
    ),
    "touch.several_people": (
        "The sessions belong to several people or hands ({found}). Repeatability is that of one "
        "hand."
    ),
    "touch.no_common_finger": "No finger was tested in all of these sessions.",
    "touch.missed": "No touch was found for {count} cues: {numbers}.",
    "touch.pulp_far": (
        "The contact of the {finger:word} is {off_mm:.1f} mm from the hand file's. Check the "
        "lengths in the hand file and the glove file."
    ),
    "touch.other_cross": "Touch {number}: cross {touched} was touched instead of cross {asked}.",
    "touch.cue": "Touch cross {target} with the {finger:word}: {how}.",
    "touch.cue_pinch": "Pinch thumb and index finger 20 times.",
    "touch.cue_still": "Hold the hand still for 10 seconds.",
    "touch.ruler": "The printed line of 260 mm measures {length_mm:.1f} mm.",
    "touch.ruler_range": "--ruler must be 240 to 280 mm. Measure the printed line of 260 mm.",
}
