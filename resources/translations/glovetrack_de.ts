<?xml version='1.0' encoding='utf-8'?>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>glovetrack</name>
    <message>
      <location filename="app/engines/camera_choice.py" />
      <source>No camera was found. Plug in the stereo camera and look again, or, where the system lists no cameras, enter its number under Set-up, Camera (0 is the first one).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/camera_choice.py" />
      <source>The camera {} is not there; there are: {}. Plug it in, or choose another one under Set-up, Camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>a simulated wearer and camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>first image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>devices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>The simulated camera did not start.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>engine</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>camera alone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>The hand is shown by its IMUs alone, without a place.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>No glove was found: no USB serial port is there. Is it plugged in?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>The camera has no stereo calibration yet: make or import one under Set-up, Stereo calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>No glove was found. {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>glove at {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/engines/recording.py" />
      <source>{} is still being written to its end; then another recording can begin.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/calibration_commands.py" />
      <source>Only the engine chain keeps a wearer's calibration: choose it in the Tracking menu.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>waiting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>under way</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>done</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>failed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>cancelled</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>Exporting {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/library_scan.py" />
      <source>Reading the library</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/library_scan.py" />
      <source>Looking into sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/offline_tracking.py" />
      <source>comparing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/offline_tracking.py" />
      <source>The folder {} is not there any more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The index fingertip is not seen: there is no place.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Opening {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The stream {} runs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Closing {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control by {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control by {} is open.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/take_motion.py" />
      <source>{} cannot be written: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/jobs/two_takes.py" />
      <source>{} is not tracked: track it again first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>The file stays on this computer until you send it. It will hold:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Save a bug report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Change…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Save</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>An image of the window</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>The last seconds of the session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Camera images of these seconds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Participant, task, notes and folder names</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>File</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>How late images are stamped, from the motion of the hand and its gyroscope</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>settled: %p %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Start tracking to see what is estimated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Hand length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Segment</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Scale ± 2σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Mounting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Gyro bias</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Accel. bias</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Who wears the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Freeze</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Hold the calibration as it is; tracking goes on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Compare</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Show what has changed since the last fit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Keep what has been learned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Reset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Forget what has been learned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Wearer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save as…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Remove this profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save the calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Who wears the glove?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Somebody new</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Everything</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>No image yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Layers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>What is drawn over the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Masks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Show what has the colours of the markers, each switched alone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Follow hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Keep the hand large in both images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Hold the images; tracking goes on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Which cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Exposure…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Lock exposure, gain and white balance; choose the camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Blobs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>A ring round each blob; dashed: of no marker</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Pairs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Filled rings: the marker is seen by both cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Rejected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right colour, wrong shape, and why</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Expected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Markers where they should be, ids and 2σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Residuals</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>From the expected place to the blob</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Skeleton</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>The hand as it is tracked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Both cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Left only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Show the mask of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/checklist.py" />
      <source>Set-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/checklist.py" />
      <source>Reading the light</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/checklist.py" />
      <source>Ready</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/checklist.py" />
      <source>{} of {} done</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/files.py" />
      <source>Colour profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/files.py" />
      <source>Export the colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/image.py" />
      <source>Mask</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/image.py" />
      <source>Searching the image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>Show missed markers in the image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>Light</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>What of the light costs markers, and what to change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>These are the colours from the start.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>These are the factory colours.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Fitting the colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>The factory colours are not those of this glove.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Hue</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Saturation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Image to tune on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Live image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Hold this image; tracking goes on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keep</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keep this image for later</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>More about images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Open an image…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Save this image…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Remove this image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keeping an image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Open an image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Opening an image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Save this image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Saving an image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be saved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Choose a kept image first: the live one stays.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick +</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: a click takes a pixel in, Ctrl+click leaves it out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick −</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: a click leaves a pixel out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Fit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From the image alone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Round patches of like colour are looked for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From the tracked markers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Each tracked marker shows what its colour looks like here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Check the room without the hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Take the hand out of the image first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Import…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Export…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Take over from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Back to the colours from the start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Those that this session began with</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Factory colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Those that the program comes with</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Undo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Redo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Palm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Hand to compare with</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The outline of another hand: the truth of a simulated one, the second tracking of a replay, or another engine on the same data</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No reference</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Reference: truth or second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Fingertip whose way is drawn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The way of a fingertip over the last three seconds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No trail</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Look from there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Markers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Large: seen now. Small: lately. Ring: never</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>2σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>A ball round each fingertip</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The left camera's field of view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Axes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The frame of each segment at its joint: x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Reference: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Trail: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Making the hand's skin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>inferred</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>No hand yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>Preparing the 3D view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D driver of the graphics card ended the program last time, so the hand is painted without it. The View menu brings the card back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D view of the graphics card is not part of this installation; the hand is painted without it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D view cannot use the graphics card; it is painted.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Two trackings compared</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Copy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Difference</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Error of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Reading two takes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Comparing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Tracking {} again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Formats</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>the whole session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source> Hz</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>as recorded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>without participant and notes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>as usual for the format</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>F&amp;older</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Formats</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>R&amp;ate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>A&amp;xes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Units</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Privacy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Folder for the export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>{} sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Export {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>only {} to {} (in and out point)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Cancel the export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Forget what has ended</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Open folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>State</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Progress</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Preset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Keep as…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Remove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Keep these formats and options</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Name of the preset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>none: as below</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Library &amp;&amp; replay</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Exports</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Mark the part first: I where it begins, O where it ends.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose a session in the library to export it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose a session in the library to track it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose two sessions in the library.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Exports ({})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags, with commas between</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Recovering {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Cropping {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Rename {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags of {} sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} holds the chosen {} of {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} cannot be moved to the bin, so it stays where it is.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} is being recorded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} is open: close it first (Ctrl+W).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Search by name, tag, date or quality</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Search</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Choose two sessions of one movement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>More</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Replay</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Track again…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Recover</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Refresh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Two takes side by side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Rename…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Tags…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Move to the bin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Recorded sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Recorded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Quality</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Tags</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>the usual ones</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>every estimate knows the whole session (chain)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>The recorded sensor data go through tracking again. The result becomes a session of its own beside this one; both are then shown together and compared.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Choose…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Engine</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>S&amp;mooth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Track</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Track {} again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Position in the session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Speed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The image before (,)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Pause</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Ctrl+Space</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The next image (.)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The note before (Ctrl+,)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The next note (Ctrl+.)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>In</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Begin the range here (I)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>End the range here (O)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Whole</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>No range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Loop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Play the range over (L)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Play</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>Joint angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source> s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>The second begins at</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>By clock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>As the computers' clocks had it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>Both from their start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>The takes have no joint angle in common.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>{} beside {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/library/two_takes_dialog.py" />
      <source>s from the start of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/log.py" />
      <source>Log</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/log.py" />
      <source>Filter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/log.py" />
      <source>Bug report…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Motion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Measuring the take</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distance from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distance to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Measure this distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Measure the chosen distances no more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Unit of angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Degrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Radians</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Copy the table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Save as CSV…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Save the table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>CSV (*.csv)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Reading the whole take…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Angles and distances</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Angle or distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>In its range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Least</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Greatest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Fastest / s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Notes of this recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Double-click to change a note, Delete to take it back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>At</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Note</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>for example P01</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>for example pinch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>May hold {participant}, {task}, {date}, {time} and a counter: {n} or {n:03}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Participant</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Task</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>File name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Countdown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>with a beep</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Record</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Note (Enter adds it)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Messages</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Losses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Disk</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Folder for recordings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Stop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Not now ({})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>{} s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Remote control: start, stop and note from other programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Others in the network can start and stop recordings at this address: there is no password.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>127.0.0.1: this computer alone. 0.0.0.0: all networks it is in</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Listens at</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>By</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Port</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Clients</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Requests</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Refused</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Port of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Sensors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Angular rate / °/s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Acceleration / g</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Joint angle / °</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Curves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Hold the curves; tracking goes on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Show this curve</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>IMU: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Angles: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>The recording {} was cut off. What it holds can be recovered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Glovetrack</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Recent sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Library</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>All recorded sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Demo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>A simulated glove and camera: see everything move, no hardware needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Glove and camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Find your devices and go through the set-up, step by step.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Recorded session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Replay a session file, look at it frame by frame, export it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>{} more stand in the library.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Streams &amp;&amp; haptics</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>127.0.0.1 is this computer alone; UDP and VMC send there, servers listen there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>&amp;Address</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Joints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>What streams carry: our 21 joints, or the 26 joints of OpenXR in its axes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Stream</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Sent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Dropped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Vibration motors: press one to feel it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Strength of the test</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Vibrate when a fingertip enters a sphere of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source> mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Radius of the sphere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Put it at the index fingertip</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>The sphere has no place yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Our joints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>OpenXR joints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Strength</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>The sphere stands at {:.0f}, {:.0f}, {:.0f} mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Motor {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the log of the window and of the program, and of a crash if there was one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>versions of Glovetrack, its packages and the operating system; size of the machine</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>rates, latencies and losses of now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window as it is now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window as it is now, with the library, the recording panel and the log blacked out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last {} s of the session that is open: sensor data and tracking, without camera images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>A bug report of Glovetrack. It holds:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the window's settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the window's settings, without participant, task and folders</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last {} s of the session that is open: sensor data and tracking, with camera images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/crash.py" />
      <source>Something went wrong inside Glovetrack ({}: {}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/platform/tasks.py" />
      <source>{} failed: {}: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/image_folder.py" />
      <source>{} is no image that can be read.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/image_folder.py" />
      <source>{}: the image could not be packed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/session_tags.py" />
      <source>it is too large</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/session_tags.py" />
      <source>The tags of {} were left behind: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>they do not say which version they are of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>a later version of Glovetrack wrote them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>The window's settings could not be used ({}), so it starts with its own. They are kept in {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/storage/wearers.py" />
      <source>The profile {} was not removed: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Spread the fingers and turn the hand before the camera: sizes settle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Bend and stretch the fingers and turn the wrist: the mounting of IMUs settles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Hold the hand still for three seconds: gyro biases settle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Hold the hand at several slants: accelerometer biases settle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>more than 2σ of both</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>within 2σ of both</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Everything has settled.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>not known yet: turn the hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>late</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>early</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>corrected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>not corrected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>now {}
change {}: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>{} Least so far: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>{:.1f} ± {:.1f} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>{} {}, {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>wrong size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>not convex</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>not round</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>at the edge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Glove found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No glove answers. Plug it in, or try the demo.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>All IMUs answer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Measured at rest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Lay the hand flat on the table for two seconds.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Camera found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Camera calibrated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Exposure locked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Colours tuned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Hand in view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Calibration settled</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The glove was here and is silent. Is it plugged in?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Look again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The camera was here and is silent. Is it plugged in?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No images arrive.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show a printed board to both lenses.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Hold the hand flat, about 35 cm before the camera, for two seconds.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for the glove.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Set up the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show sensors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>this engine estimates no biases</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The left image is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The right image is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Calibrate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>it does not change here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>this source has no exposure to be set</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>this camera lets no program set it: keep the light as it is</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Lock it now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Tune colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No marker is found.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for glove and camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Needs glove and calibrated camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for tracking.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>{} of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>both images arrive</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>baseline {:.1f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The camera changes {} by itself.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The intervals of {} overlap.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Not seen: {}. Turn the hand, or tune the colours.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>seen: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Silent: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>gyros known to {:.1f} °/s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>hand length {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>{} ({} patches)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Nothing was fitted: no patches of these colours were found.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>There is no image yet to fit the colours to.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}. Kept {}: too few are seen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>No markers were tracked yet. Fit from the image alone first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>The room has none of the colours.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>Exported to {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>Colours of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>{} must have the hues {} for this glove.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>no image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image, about {:.0f} expected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} of about {:.0f}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>overlaps {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>the room has this colour too ({:.2g} % of it)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>{} is nearer to the truth: {} on average.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all keypoints, mean</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all keypoints, largest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all joints, rms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>{} instants in common; keypoints differ by {} on average, joints by {} (rms).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>Both are the same to the last bit ({} instants).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Table for spreadsheets and everything else (CSV)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Table for Python and R (Parquet)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Arrays for MATLAB and Python (HDF5)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Motion capture (C3D)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>OpenSim markers (TRC)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>OpenSim joint angles (MOT)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>OpenSim orientations of the IMUs (STO)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>OpenSim model of the hand as tracked (OSIM)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Animation skeleton (BVH)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Animated hand in 3D (glTF)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Robot model of the hand (URDF)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Film with the hand drawn in (MP4)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Folder of images with the hand drawn in (PNG)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Session, whole or the chosen part (MCAP)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/export_choice.py" />
      <source>Hand record of NVIDIA's Isaac tools (MCAP)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>go on…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Lay the hand flat on the table, palm down, and hold it still.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Measured.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>{} of {}: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Waiting for rest. {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Place unknown: orientation and finger angles by the IMUs alone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Nothing arrives: the hand stands as it was last</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Position lost: the hand stands where it was last seen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>being recorded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>unreadable</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>not tracked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>tracked {} %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>tracked {} %, {} packets lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>whole</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>cut off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Problems</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Devices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Tracking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Computer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Notes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>a note was deleted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>changed to: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>just now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>1 minute ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>today, {:%H:%M}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>yesterday, {:%H:%M}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>{} days ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>{} minutes ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Under 1 GB is left: recording is not possible on this disk.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Under 5 GB is left on this disk.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} packets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} images not recorded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} free, about {} of recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} messages that the computer had no time for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Nothing can be recorded to {}: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>UDP (JSON, words)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>somebody is there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>nobody asks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>not open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>opening</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>{}, {} s ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames whose stuffing was broken (COBS)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames whose check sum was wrong (CRC)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of a wrong length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of an unknown type, or far too long</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Times that the port was opened again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Restarts of the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Jumps of the glove's clock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Packets that the glove had no time to send</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>The host's time gained on the glove's clock, ppm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Time that the USB adapter holds bytes back, ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>battery {:.2f} V</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>adapter waits {:.0f} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>silent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ battery low: {:.2f} V</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ adapter waits {:.0f} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>answers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>jitter {:.1f} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 frame damaged</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} frames damaged</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 packet dropped by the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} packets dropped by the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 restart</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} restarts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 reconnection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} reconnections</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 jump of its clock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} jumps of its clock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>clock {:+.0f} ppm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>no samples</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} packet lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} packets lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} % missing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>good</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>attention</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>problem</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>idle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Searching for the hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Coasting on the glove alone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Position lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Search of both images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>The engine's step for a message</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>A packet's arrival to its estimate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>An image's arrival to the estimate made of it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>3D rate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>overlays</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>wide search</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Packets of the glove that never arrived; images that came faster than they were read</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Left out:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Packets of the glove each second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Latency</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Stopped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Place unknown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Stereo images each second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Estimates of the hand each second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Its battery is low ({} V): charge it soon</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Of each stage, median (99th percentile):</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{} packets, {} images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{}, battery low</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Hold the board still.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There is a view like this already: move on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There are enough views.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Image area</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Tilted views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Far over near</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{}: {} corners, tilted {:.0f}°</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{}, off by {:.2f} px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Error of all corners</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Distance of the lenses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Turned against each other</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Focal length, left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Focal length, right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Worst corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>All rows shifted by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>dropped: it does not fit the others</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{:.0f} of {:.0f} %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{:.2f} of {:.2f}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>That is enough: go on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{} used, {} dropped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{} by {} px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>VMC (OSC, avatars)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>its library listens on all addresses of this computer, so others in the same network can read it, unless a firewall keeps them out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>nobody listens</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>waits for tracking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>failing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>sending</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/take_names.py" />
      <source>The name {!r} is not complete; it can hold text and {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/take_names.py" />
      <source>A name can hold {}, not {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>no packets lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>1 packet lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} is whole: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>no image comes from the camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>no packet comes from the glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} is not whole: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} packets lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>This recording lacks something: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>the IMUs {} cannot be heard</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>tracked {:.0f} % of the time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{:.0f} images come a second instead of {:.0f}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>the IMU {} cannot be heard</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} needs a name with a letter or a digit in it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} is there already, so {} keeps its name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/takes.py" />
      <source>{} cannot be named {}: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/two_takes.py" />
      <source>The takes have no tracked instant in common here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/two_takes.py" />
      <source>differ by {:.1f}° (rms), {:.1f}° at most, over {:.1f} s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/worn_calibration.py" />
      <source>There is nothing to compare with yet: save a profile, or reset.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/viewmodels/worn_calibration.py" />
      <source>Frozen: nothing is learned until you unfreeze it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/banner.py" />
      <source>Dismiss</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/command_palette.py" />
      <source>Type a command</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/coverage_map.py" />
      <source>{} empty cells</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/hue_range.py" />
      <source>Drag a handle, or the bar. Keys: ↓ ↑ choose a handle, ← → move it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/hue_strip.py" />
      <source>Histogram of hues</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/image_view.py" />
      <source>Wheel or + −: zoom. Drag or arrows: move. Double click or 0: all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/range_row.py" />
      <source>{}, first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/range_row.py" />
      <source>{}, last</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/widgets/view3d/view_3d.py" />
      <source>The hand in 3D</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>About Glovetrack</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Parts and their licences</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Apache-2.0</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Hand tracking with a sensor glove and a stereo camera. Free software under the Apache Licence 2.0, without any warranty.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Glovetrack {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Saving the bug report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Glovetrack ended unexpectedly the last time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Save a bug report…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>The bug report is saved: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source> Not in it: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/countdown.py" />
      <source>Esc: not now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/countdown.py" />
      <source>Recording begins in {} s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/docks.py" />
      <source>&amp;View</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Search the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Key</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Does</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Menu</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Keep this layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Kept layouts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Name of the layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Rename a layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Delete a layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Keep this layout…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Rename a layout…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Delete a layout…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Set up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Watch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>All panels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Glovetrack speaks another language when it is started the next time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Glovetrack: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>Looking for earlier sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>Show it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>What could be read of the recording is in {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/refresher.py" />
      <source>The panel {} failed and rests ({}: {}); the rest goes on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Looking for cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Starting the demo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Looking for glove and camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Open a session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Show the set-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Open it now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>{} waits: a recording is under way.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/status_bar.py" />
      <source>Cancel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/status_bar.py" />
      <source>The window is refreshed {} times a second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/takes.py" />
      <source>What happened?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/takes.py" />
      <source>Name of the recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/takes.py" />
      <source>Checking {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/ticker.py" />
      <source>Paused</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Commands</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Find</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;File</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Set-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Tracking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Replay</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Help</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Stop &amp;recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Record</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Language: as the system</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Start the &amp;demo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Glove and camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Open a session…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Export…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Close the session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Quit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Glove…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Camera…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Stereo calibration…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Lock the exposure as it is</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Start tracking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>S&amp;top tracking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Pause the recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Add a &amp;note…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Play or pause</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The image &amp;before</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The &amp;next image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The note &amp;earlier</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The note &amp;later</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;In point here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Out point here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Whole session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Crop to a new session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Loop on or off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Track &amp;again…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Compare two sessions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Two takes side by si&amp;de</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Freeze the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Whole image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;palm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Undo the colour change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Redo the colour change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Command palette…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Latency of &amp;each stage</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Reset the layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Full screen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: &amp;chosen by itself</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: by the &amp;graphics card</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: &amp;painted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Light</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Dark</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>As the &amp;system</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Save a &amp;bug report…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;About Glovetrack</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Stop recording</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Engine: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Exposure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Gain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>White balance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>this camera has none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>▲ the camera does not take it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Camera set-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Exchange left and right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Where a stereo calibration finds the cameras exchanged</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Look again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>a video file, or rtsp:// or http:// of a stream</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Right images from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Or from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Use this camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Close</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>The first one found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>the same image, side by side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Locks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>A camera that exposes by itself changes the colours with every move.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>○ by itself, now {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>The simulated camera's exposure is fixed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Start glove and camera: what the camera can do is shown then.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>● locked at {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Lock {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: glove {}, {} IMUs, {} baud</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>A port that is not on USB, such as /dev/rfcomm0 or COM7:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Other port…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Whichever it answers at</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Right hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Left hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Port</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>S&amp;peed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Glove file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Hand file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Wearer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Other port</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Looking for gloves…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Simulated glove (plays along)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>No USB serial port is there. Plug the glove in and look again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>The glove in use</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: a glove that is sending</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: glove {}, {} IMUs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{} baud</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/feed.py" />
      <source>The session was closed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Lay the hand flat on the table, palm down.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>&amp;Measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>&amp;Start the test</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>You are asked to move one part after the other; no click is needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>nothing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>IMU</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Gyro bias x y z, °/s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>± °/s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Noise, m°/s/√Hz</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Gravity, m/s²</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>What was found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>No samples come.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Moves now: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>Glove set-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;1 Glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;2 At rest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;3 Wiggle test</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;Use this glove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>Looking for gloves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>Freeing the glove's port</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>ChArUco (may be partly hidden)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Chessboard (always whole)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>unknown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>From the camera's data sheet; a ZED Mini has 63 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>&amp;Board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Squares a&amp;cross</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Squares &amp;down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Side of a &amp;square, measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Lenses &amp;apart, if known</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>&amp;Images from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Save the board for printing…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>A calibration is there already</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>It is checked as strictly as one made here, and can be tried on the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>ZED factory file…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>OpenCV file…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>The page is {} by {} mm: print it without scaling.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Save the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>{} cannot be written.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Simulated board (demo)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Camera in use</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>camera in use</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>The camera in use was closed: start glove and camera again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Folder {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Chosen camera: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>ZED factory file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>OpenCV calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Folder with left and right images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>squares of the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Image's &amp;width, px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Image's &amp;height, px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>&amp;Unit of T in the file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Side of a &amp;square</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Import {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrated: now check it on fresh views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>View</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Left, px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Right, px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrating</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>No calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrating: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/solving.py" />
      <source>Stereo calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Waiting for the camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Views taken</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Remove the view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Left image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Right image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Rows differ by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Show the board once more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>The image has another size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Closing the camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Images from a folder…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Check</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Save and use</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Checked on every third image of the folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>checked: {:.3f} px</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>