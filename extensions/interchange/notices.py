"""Texts of the notices of this extension, by code."""

TEXTS = {
    "film.mpeg4": (
        "There is no ffmpeg with H.264 on this computer: the film is MPEG-4 part 2, which"
        " browsers and some players do not show."
    ),
    "film.ffmpeg_failed": "{file} could not be written by ffmpeg.",
    "film.ffmpeg_failed_why": "{file} could not be written by ffmpeg: {why}",
    "film.opencv_cannot": "OpenCV on this computer cannot write {file}.",
    "film.no_images": "{path} contains no images of the tracked time.",
    "skeleton.bone_unseen": "A bone was never seen with both its ends, so there is no skeleton.",
    "skeleton.needs_wrist": "A skeleton requires the wrist. Export all joints.",
    "skeleton.untracked": "{keypoint:word} was never tracked, so there is no skeleton.",
    "urdf.left_handed": "A URDF has right-handed axes; {axes} has left-handed ones.",
}
