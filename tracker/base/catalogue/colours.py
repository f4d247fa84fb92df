"""Texts about colours and light."""

TEXTS = {
    "colours.no_pixels": 'No pixels are marked for the hue "{hue:word}".',
    "colours.every_hue": 'The pixels marked for "{hue:word}" cover all hues. Mark only one cloth.',
    "colours.followed": "Colours adapted to the light.",
    "colours.no_glove_seen": (
        "Nothing was fitted: no glove was recognised with certainty. Hold your hand flat "
        "in front of the camera, in more or whiter light."
    ),
    "colours.points_missing": "Point at a marker of each hue first. Missing: {hues:words}.",
    "colours.only_points_learned": (
        "Only the pixels that you pointed at were learned: no glove was recognised around"
        " them. Hold your hand flat and point at the centre of a patch of each hue."
    ),
    "colours.learned_worse": (
        "The colours are unchanged: the learned ones find {found} of {picked} markers and"
        " {others} other objects, the current ones {found_before} and {others_before}. "
        "Point at markers of a flat hand, in more light."
    ),
    "colours.fitted_worse": (
        "The colours are unchanged: the fitted ones find {found} patches of the glove and"
        " {others} other objects, the current ones {found_before} and {others_before}."
    ),
    "colours.unfit": (
        "The colours find {patches} patches, none of which fit the glove. Fit the colours."
    ),
    "colours.fit_again": "The colours no longer find too many patches, or the hand was found.",
    "colours.too_many_hues": (
        "The colour profile {profile} has {hues} hues; at most {most} can be distinguished."
    ),
    "colours.fitted_themselves": "The colours showed no hand, so they were fitted automatically.",
    "colours.exchanged": (
        "The names of these hues are exchanged in the colour profile: {hues:words}. Fit the "
        "colours."
    ),
    "colours.exchanged_here": (
        "The names of these hues are exchanged in the colour profile: {hues:words}. Tracking uses "
        "the right ones; fit the colours to correct the profile."
    ),
    "colours.exchanged_corrected": (
        "The names of these hues were exchanged in the colour profile and are corrected: "
        "{hues:words}."
    ),
    "colours.no_hand": "No hand is visible. {why}",
    "light.too_bright": (
        "The {hues:words} markers are too bright. Shorten the exposure, or move the lamp away."
    ),
    "light.clipped": (
        "{share_percent:.0f} % of the image is white. Keep the window and the screen out "
        "of the image, or shorten the exposure."
    ),
    "light.dark": "The markers are dark. Put more light on the hand, or lengthen the exposure.",
    "light.noisy": "The image is noisy. Use more light and less gain.",
    "light.warm": (
        "The light is too warm. Use a daylight lamp or set the white balance, then fit the colours."
    ),
    "light.cold": "The light is too cold. Set the white balance, then fit the colours.",
    "light.hues_alike": (
        "The {hues:words} markers look alike in this light. Use another lamp, or other cloth."
    ),
    "light.room_has_hues": (
        "The room also contains {hues:words}, in {spots} {spots:spot|spots}. Lay a dark "
        "or grey cloth under the hand, or fit the colours."
    ),
    "light.markers_missed": (
        "{missed} of {expected} markers are not found with these colours. Fit them to the image."
    ),
    "light.show_hand": "Hold your gloved hand in front of the camera, its back up.",
    "light.no_images": "{path} contains no images whose light can be measured.",
    "colours.no_calibration": (
        "The session contains no camera calibration, so no hand can be found in its images."
    ),
    "colours.no_images": "{path} contains no images to fit colours to.",
    "colours.session_fit_worse": (
        "The colours are unchanged: the fitted ones find {found:.1f} markers and "
        "{others:.1f} other objects per image, the current ones {found_before:.1f} and "
        "{others_before:.1f}."
    ),
    "colours.no_hand_found": (
        "The colours could not be fitted: no hand was found with certainty, in any light and with "
        "any names of the hues. Hold the hand flat and still in view of {cameras:word}, in more or "
        "whiter light."
    ),
    "colours.live_needs": (
        "Fitting to live images needs the glove and a calibrated camera. Fit to one image instead."
    ),
}
