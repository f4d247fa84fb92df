<?xml version='1.0' encoding='utf-8'?>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>glovetrack</name>
    <message>
      <location filename="app/engines/camera_choice.py" />
      <source>No camera was found. Plug in the stereo camera, then choose Search again. If this system lists no cameras, enter the number of yours under Set-up, Camera, Or number, file (0 is the first one).</source>
      <translation>Keine Kamera gefunden. Schließen Sie die Stereokamera an und wählen Sie Erneut suchen. Wenn dieses System keine Kameras auflistet, geben Sie die Nummer unter Einrichtung, Kamera, Oder Nummer, Datei ein (0 ist die erste).</translation>
    </message>
    <message>
      <location filename="app/engines/camera_choice.py" />
      <source>The camera {} is not there; there are: {}. Plug it in, or choose another one under Set-up, Camera.</source>
      <translation>Die Kamera {} ist nicht da; da sind: {}. Anschließen oder unter Einrichtung, Kamera eine andere wählen.</translation>
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>a simulated wearer and camera</source>
      <translation>simulierte Person und Kamera</translation>
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>first image</source>
      <translation>erstes Bild</translation>
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>devices</source>
      <translation>Geräte</translation>
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>The simulated camera did not start.</source>
      <translation>Die simulierte Kamera ist nicht gestartet.</translation>
    </message>
    <message>
      <location filename="app/engines/demo.py" />
      <source>The hand is shown by its IMUs alone, without a place.</source>
      <translation>Die Hand wird allein nach ihren IMUs gezeigt, ohne Ort.</translation>
    </message>
    <message>
      <location filename="app/engines/engine_host.py" />
      <source>{}: not now, a recording has begun meanwhile.</source>
      <translation>{}: jetzt nicht, inzwischen hat eine Aufnahme begonnen.</translation>
    </message>
    <message>
      <location filename="app/engines/engine_host.py" />
      <source>Tracking has stopped. {} Start it again.</source>
      <translation>Das Tracking wurde beendet. {} Starten Sie es neu.</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>No glove was found: no USB serial port is there. Is it plugged in?</source>
      <translation>Kein Handschuh gefunden: Es gibt keinen seriellen USB-Anschluss. Ist er eingesteckt?</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>left</source>
      <translation>linken</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>right</source>
      <translation>rechten</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>No glove was found. {}</source>
      <translation>Kein Handschuh gefunden. {}</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>Glove {} at {} is new: choose its hand under Set-up, Glove.</source>
      <translation>Handschuh {} an {} ist neu: seine Hand unter Einrichtung, Handschuh wählen.</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>Glove {} at {} is of the {} hand too, of which there is one already.</source>
      <translation>Handschuh {} an {} ist auch für die Hand {}, von der es schon einen gibt.</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>engine</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>camera</source>
      <translation>Kamera</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>camera alone</source>
      <translation>nur Kamera</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>The camera has no calibration yet: make or import one under Set-up, Camera calibration.</source>
      <translation>Die Kamera ist noch nicht kalibriert: unter Einrichten, Kamera kalibrieren eine Kalibrierung machen oder einlesen.</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>gloves at {}</source>
      <translation>Handschuhe an {}</translation>
    </message>
    <message>
      <location filename="app/engines/hardware.py" />
      <source>glove at {}</source>
      <translation>Handschuh an {}</translation>
    </message>
    <message>
      <location filename="app/engines/recording.py" />
      <source>{} is still being written to its end; then another recording can begin.</source>
      <translation>{} wird noch zu Ende geschrieben; dann kann eine neue Aufnahme beginnen.</translation>
    </message>
    <message>
      <location filename="app/engines/recording.py" />
      <source>The recording could not be finished: {}</source>
      <translation>Die Aufnahme konnte nicht abgeschlossen werden: {}</translation>
    </message>
    <message>
      <location filename="app/jobs/calibration_commands.py" />
      <source>Only the engine chain keeps a wearer's calibration: choose it in the Tracking menu.</source>
      <translation>Nur das Verfahren chain behält die Kalibrierung einer Person: im Menü Tracking wählen.</translation>
    </message>
    <message>
      <location filename="app/jobs/device_changes.py" />
      <source>The glove cannot be set: {}.</source>
      <translation>Der Handschuh kann nicht eingestellt werden: {}.</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>waiting</source>
      <translation>wartet</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>under way</source>
      <translation>läuft</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>done</source>
      <translation>fertig</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>failed</source>
      <translation>gescheitert</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>cancelled</source>
      <translation>abgebrochen</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>Exporting {}</source>
      <translation>{} wird exportiert</translation>
    </message>
    <message>
      <location filename="app/jobs/library_scan.py" />
      <source>Reading the library</source>
      <translation>Bibliothek wird gelesen</translation>
    </message>
    <message>
      <location filename="app/jobs/library_scan.py" />
      <source>Looking into sessions</source>
      <translation>Sitzungen werden durchgesehen</translation>
    </message>
    <message>
      <location filename="app/jobs/offline_tracking.py" />
      <source>comparing</source>
      <translation>Vergleich</translation>
    </message>
    <message>
      <location filename="app/jobs/offline_tracking.py" />
      <source>The folder {} is not there any more.</source>
      <translation>Den Ordner {} gibt es nicht mehr.</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Closing {}</source>
      <translation>{} wird geschlossen</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Opening {}</source>
      <translation>{} wird geöffnet</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The index fingertip is not seen: there is no place.</source>
      <translation>Die Spitze des Zeigefingers ist nicht zu sehen: Es gibt keinen Ort.</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The stream {} runs.</source>
      <translation>Der Stream {} läuft.</translation>
    </message>
    <message>
      <location filename="app/jobs/plugged.py" />
      <source>Looking for devices</source>
      <translation>Geräte werden gesucht</translation>
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control by {}</source>
      <translation>Fernsteuerung über {}</translation>
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control by {} is open.</source>
      <translation>Die Fernsteuerung über {} ist offen.</translation>
    </message>
    <message>
      <location filename="app/jobs/take_motion.py" />
      <source>{} cannot be written: {}.</source>
      <translation>{} kann nicht geschrieben werden: {}.</translation>
    </message>
    <message>
      <location filename="app/jobs/two_takes.py" />
      <source>{} is not tracked: track it again first.</source>
      <translation>{} ist ohne Tracking: erst das Tracking wiederholen.</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>The file stays on this computer until you send it. It will hold:</source>
      <translation>Die Datei bleibt auf diesem Computer, bis Sie sie versenden. Sie wird enthalten:</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Save a bug report</source>
      <translation>Fehlerbericht speichern</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Change…</source>
      <translation>Ändern…</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Save</source>
      <translation>Speichern</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>An image of the window</source>
      <translation>Ein Bild des Fensters</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>The last seconds of the session</source>
      <translation>Die letzten Sekunden der Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Camera images of these seconds</source>
      <translation>Kamerabilder dieser Sekunden</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>Participant, task, notes and folder names</source>
      <translation>Versuchsperson, Aufgabe, Notizen und Ordnernamen</translation>
    </message>
    <message>
      <location filename="app/panels/bug_report_dialog.py" />
      <source>File</source>
      <translation>Datei</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>How late images are stamped, from the motion of the hand and its gyroscope</source>
      <translation>Wie verspätet Bilder gestempelt sind, aus der Bewegung der Hand und ihrem Gyroskop</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>settled: %p %</source>
      <translation>stabil: %p %</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Hand length</source>
      <translation>Handlänge</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Start tracking to see what is estimated.</source>
      <translation>Nach dem Start des Trackings steht hier, was geschätzt wird.</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Camera delay</source>
      <translation>Kameraverzug</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/profiles.py" />
      <source>The profile {} was removed.</source>
      <translation>Das Profil {} wurde entfernt.</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Segment</source>
      <translation>Segment</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Scale ± 2σ</source>
      <translation>Skala ± 2σ</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Mounting</source>
      <translation>Einbaulage</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Gyro bias</source>
      <translation>Gyro-Bias</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/table.py" />
      <source>Accel. bias</source>
      <translation>Beschl.-Bias</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>From the crease of the wrist to the tip of the middle finger, mm</source>
      <translation>Von der Falte des Handgelenks bis zur Spitze des Mittelfingers, mm</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Who wears the glove</source>
      <translation>Wer den Handschuh trägt</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Freeze</source>
      <translation>Einfrieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Hold the calibration as it is; tracking goes on</source>
      <translation>Die Kalibrierung festhalten, wie sie ist; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Compare</source>
      <translation>Vergleichen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Show what has changed since the last fit</source>
      <translation>Zeigen, was sich seit der letzten Anpassung geändert hat</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Keep what has been learned</source>
      <translation>Gelerntes behalten</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Reset</source>
      <translation>Zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Forget what has been learned</source>
      <translation>Gelerntes vergessen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Import…</source>
      <translation>Importieren…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Put on a profile from a file of another computer</source>
      <translation>Profil aus der Datei eines anderen Computers anlegen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Export…</source>
      <translation>Exportieren…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Write what has been learned of the wearer as text</source>
      <translation>Was über die Person gelernt wurde, als Text schreiben</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Guided poses…</source>
      <translation>Geführte Posen…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Half a minute of poses that show your fingertips</source>
      <translation>Eine halbe Minute Posen, die Ihre Fingerspitzen zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Hand length…</source>
      <translation>Handlänge…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Measured with a ruler: one camera cannot tell a small hand from a far one</source>
      <translation>Mit dem Lineal gemessen: eine Kamera allein unterscheidet eine kleine Hand nicht von einer fernen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Wearer</source>
      <translation>Person</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save as…</source>
      <translation>Speichern als…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Remove this profile</source>
      <translation>Dieses Profil entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save the calibration</source>
      <translation>Kalibrierung speichern</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Who wears the glove?</source>
      <translation>Wer trägt den Handschuh?</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Export the wearer's profile</source>
      <translation>Profil der Person exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Import a wearer's profile</source>
      <translation>Profil einer Person importieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Somebody new</source>
      <translation>Neue Person</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Everything</source>
      <translation>Alles</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>No image yet</source>
      <translation>Noch kein Bild</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Left</source>
      <translation>Links</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right</source>
      <translation>Rechts</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Layers</source>
      <translation>Ebenen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>What is drawn over the images</source>
      <translation>Was über die Bilder gezeichnet wird</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Masks</source>
      <translation>Masken</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Show what has the colours of the markers, each switched alone</source>
      <translation>Zeigen, was die Farben der Marker hat; jede einzeln zu schalten</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Follow hand</source>
      <translation>Hand folgen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Keep the hand large in both images</source>
      <translation>Die Hand in beiden Bildern groß halten</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Hold the images; tracking goes on</source>
      <translation>Die Bilder festhalten; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Which cameras</source>
      <translation>Welche Kameras</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Lock exposure, gain and white balance; choose the camera</source>
      <translation>Belichtung, Verstärkung und Weißabgleich sperren; Kamera wählen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>There is no camera</source>
      <translation>Es gibt keine Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Blobs</source>
      <translation>Blobs</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>A ring round each blob; dashed: of no marker</source>
      <translation>Ein Ring um jeden Blob; gestrichelt: gehört zu keinem Marker</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Pairs</source>
      <translation>Paare</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Filled rings: the marker is seen by both cameras</source>
      <translation>Gefüllte Ringe: Beide Kameras sehen den Marker</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Rejected</source>
      <translation>Verworfen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right colour, wrong shape, and why</source>
      <translation>Richtige Farbe, falsche Form, und warum</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Expected</source>
      <translation>Erwartet</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Markers where they should be, ids and 2σ</source>
      <translation>Marker, wo sie sein sollten, mit Kennung und 2σ</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Residuals</source>
      <translation>Residuen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>From the expected place to the blob</source>
      <translation>Vom erwarteten Ort zum Blob</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Skeleton</source>
      <translation>Skelett</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>The hand as it is tracked</source>
      <translation>Die Hand, wie sie verfolgt wird</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Both cameras</source>
      <translation>Beide Kameras</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Left only</source>
      <translation>Nur links</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Right only</source>
      <translation>Nur rechts</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Exposure…</source>
      <translation>Belichtung…</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Camera</source>
      <translation>Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Show the mask of {}</source>
      <translation>Maske von {} zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/checklist.py" />
      <source>Reading the light</source>
      <translation>Licht wird gemessen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/files.py" />
      <source>Colour profile</source>
      <translation>Farbprofil</translation>
    </message>
    <message>
      <location filename="app/panels/colours/files.py" />
      <source>Export the colours</source>
      <translation>Farben exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Fitting the colours</source>
      <translation>Farben werden angepasst</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Images are gathered: hold the hand in view, or let the replay run.</source>
      <translation>Bilder werden gesammelt: die Hand im Bild halten oder die Wiedergabe laufen lassen.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/image.py" />
      <source>Mask</source>
      <translation>Maske</translation>
    </message>
    <message>
      <location filename="app/panels/colours/image.py" />
      <source>Searching the image</source>
      <translation>Bild wird durchsucht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/image.py" />
      <source>Mask, image frozen</source>
      <translation>Maske, Bild angehalten</translation>
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>Show missed markers in the image</source>
      <translation>Übersehene Marker im Bild zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>Light</source>
      <translation>Licht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/light.py" />
      <source>What of the light costs markers, and what to change</source>
      <translation>Was am Licht Marker kostet und was zu ändern ist</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>These are the colours from the start.</source>
      <translation>Das sind die Farben vom Anfang.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>These are the factory colours.</source>
      <translation>Das sind die Werksfarben.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>The factory colours are not those of this glove.</source>
      <translation>Die Werksfarben sind nicht die dieses Handschuhs.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Hue</source>
      <translation>Farbton</translation>
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Saturation</source>
      <translation>Sättigung</translation>
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Value</source>
      <translation>Hellwert</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Image to tune on</source>
      <translation>Bild zum Abstimmen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Live image</source>
      <translation>Livebild</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Hold this image; tracking goes on</source>
      <translation>Dieses Bild festhalten; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keep</source>
      <translation>Behalten</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keep this image for later</source>
      <translation>Dieses Bild für später behalten</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>More about images</source>
      <translation>Mehr zu Bildern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Open an image…</source>
      <translation>Bild öffnen…</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Save this image…</source>
      <translation>Dieses Bild speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Remove this image</source>
      <translation>Dieses Bild entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Keeping an image</source>
      <translation>Bild wird behalten</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Open an image</source>
      <translation>Bild öffnen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Opening an image</source>
      <translation>Bild wird geöffnet</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Save this image</source>
      <translation>Dieses Bild speichern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Saving an image</source>
      <translation>Bild wird gespeichert</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be kept.</source>
      <translation>Es gibt noch kein Bild, das behalten werden könnte.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be saved.</source>
      <translation>Es gibt noch kein Bild, das gespeichert werden könnte.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Choose a kept image first: the live one stays.</source>
      <translation>Erst ein behaltenes Bild wählen: Das Livebild bleibt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>The image {} was removed.</source>
      <translation>Das Bild {} wurde entfernt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick =</source>
      <translation>Wählen =</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Set from pixel: an eyedropper; a click on a marker sets the ranges of the chosen hue to its colour</source>
      <translation>Aus Bildpunkt setzen: eine Pipette; ein Klick auf einen Marker setzt die Bereiche des gewählten Farbtons auf dessen Farbe</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick +</source>
      <translation>Pipette +</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: a click widens the ranges to take a pixel in, Ctrl+click leaves it out. With one marker of each colour clicked, the colours are learned.</source>
      <translation>Pipette: Ein Klick erweitert die Bereiche um einen Bildpunkt, Strg+Klick nimmt ihn heraus. Sobald ein Marker jeder Farbe angeklickt ist, werden die Farben gelernt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick −</source>
      <translation>Pipette −</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: a click leaves a pixel out</source>
      <translation>Pipette: Ein Klick lässt ein Pixel aus</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Fit</source>
      <translation>Anpassen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From what is seen now</source>
      <translation>Aus dem, was jetzt zu sehen ist</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Hold the hand in view: glove and cameras find it in any light</source>
      <translation>Die Hand ins Bild halten: Handschuh und Kameras finden sie bei jedem Licht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From the image alone</source>
      <translation>Allein aus dem Bild</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>A crowd of patches of the glove's colours is looked for</source>
      <translation>Gesucht wird eine Ansammlung von Flecken in den Farben des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From the tracked markers</source>
      <translation>Aus den verfolgten Markern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Each tracked marker shows what its colour looks like here</source>
      <translation>Jeder verfolgte Marker zeigt, wie seine Farbe hier aussieht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Check the room without the hand</source>
      <translation>Raum ohne Hand prüfen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Take the hand out of the image first</source>
      <translation>Vorher die Hand aus dem Bild nehmen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Profile</source>
      <translation>Profil</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Take over from</source>
      <translation>Übernehmen von</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Back to the colours from the start</source>
      <translation>Zurück zu den Farben vom Anfang</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Those that this session began with</source>
      <translation>Die, mit denen diese Sitzung begann</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Factory colours</source>
      <translation>Werksfarben</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Those that the program comes with</source>
      <translation>Die, mit denen das Programm kommt</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Undo</source>
      <translation>Rückgängig</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Redo</source>
      <translation>Wiederholen</translation>
    </message>
    <message>
      <location filename="app/panels/connection_table.py" />
      <source>Port of {}</source>
      <translation>Port von {}</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Cameras</source>
      <translation>Kameras</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Hand</source>
      <translation>Hand</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Sensors</source>
      <translation>Sensoren</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Motion</source>
      <translation>Bewegung</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Library</source>
      <translation>Bibliothek</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Log</source>
      <translation>Protokoll</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Set-up</source>
      <translation>Einrichtung</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Calibration</source>
      <translation>Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Colours</source>
      <translation>Farben</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Recording</source>
      <translation>Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Streams &amp;&amp; haptics</source>
      <translation>Streams &amp;&amp; Haptik</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Graphs</source>
      <translation>Diagramme</translation>
    </message>
    <message>
      <location filename="app/panels/core.py" />
      <source>Device settings</source>
      <translation>Geräteeinstellungen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Search settings</source>
      <translation>Einstellungen suchen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Apply</source>
      <translation>Anwenden</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Revert</source>
      <translation>Zurücknehmen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Save as file…</source>
      <translation>Als Datei speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Load…</source>
      <translation>Laden…</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>{}: {} is not possible ({}).</source>
      <translation>{}: {} ist nicht möglich ({}).</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Save the device settings</source>
      <translation>Geräteeinstellungen speichern</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>TOML (*.toml)</source>
      <translation>TOML (*.toml)</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Load device settings</source>
      <translation>Geräteeinstellungen laden</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>The motor was not run: the glove is disconnected.</source>
      <translation>Der Motor lief nicht: Der Handschuh ist getrennt.</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>changed, not applied</source>
      <translation>geändert, nicht angewendet</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>Setting</source>
      <translation>Einstellung</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>Current value</source>
      <translation>Aktueller Wert</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>State</source>
      <translation>Zustand</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>Run</source>
      <translation>Ausführen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>Run this motor for 0.3 s</source>
      <translation>Diesen Motor 0,3 s laufen lassen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/tree.py" />
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Fit both axes to the curves (double-click the graph)</source>
      <translation>Beide Achsen an die Kurven anpassen (Doppelklick auf das Diagramm)</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Time window</source>
      <translation>Zeitfenster</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Pause this graph; tracking goes on</source>
      <translation>Dieses Diagramm anhalten; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Copy what is shown as CSV</source>
      <translation>Dargestelltes als CSV kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Remove this graph</source>
      <translation>Dieses Diagramm entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/controls.py" />
      <source>Whole recording</source>
      <translation>Ganze Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Save these graphs…</source>
      <translation>Diese Diagramme speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Delete a layout…</source>
      <translation>Anordnung löschen…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Save these graphs</source>
      <translation>Diese Diagramme speichern</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Name of the layout</source>
      <translation>Name des Layouts</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Delete a layout</source>
      <translation>Layout löschen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/layouts.py" />
      <source>Layout</source>
      <translation>Layout</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Reading the recording's signals</source>
      <translation>Signale der Aufnahme werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Add graph</source>
      <translation>Diagramm hinzufügen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Pause all</source>
      <translation>Alle anhalten</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Signals</source>
      <translation>Signale</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Show the tree of signals</source>
      <translation>Signalbaum zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Layouts</source>
      <translation>Anordnungen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Reading the whole recording…</source>
      <translation>Ganze Aufnahme wird gelesen…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Copied {} lines of {} curves as CSV.</source>
      <translation>{} Zeilen von {} Kurven als CSV kopiert.</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>not available</source>
      <translation>nicht verfügbar</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Tick signals in the tree, or drag them here.</source>
      <translation>Signale im Baum ankreuzen oder hierher ziehen.</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/tree.py" />
      <source>Search signals</source>
      <translation>Signale suchen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Back</source>
      <translation>Rücken</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Palm</source>
      <translation>Innen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Side</source>
      <translation>Seite</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Hand to compare with</source>
      <translation>Vergleichshand</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The outline of another hand: the truth of a simulated one, the second tracking of a replay, or another engine on the same data</source>
      <translation>Der Umriss einer anderen Hand: die Wahrheit einer simulierten, das zweite Tracking einer Wiedergabe oder ein anderes Verfahren auf denselben Daten</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No reference</source>
      <translation>Keine Referenz</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Fingertip whose way is drawn</source>
      <translation>Fingerspitze, deren Weg gezeichnet wird</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The way of a fingertip over the last three seconds</source>
      <translation>Der Weg einer Fingerspitze in den letzten drei Sekunden</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No trail</source>
      <translation>Keine Spur</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No second tracking</source>
      <translation>Kein zweites Tracking</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Look from there</source>
      <translation>Von dort schauen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Markers</source>
      <translation>Marker</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Large: seen now. Small: lately. Ring: never</source>
      <translation>Groß: jetzt gesehen. Klein: kürzlich. Ring: nie</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>2σ</source>
      <translation>2σ</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>A ring round each fingertip, of two standard deviations; broken: more than its 15 mm</source>
      <translation>Ein Ring um jede Fingerspitze, zwei Standardabweichungen groß; unterbrochen: mehr als seine 15 mm</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The left camera's field of view</source>
      <translation>Das Sichtfeld der linken Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Axes</source>
      <translation>Achsen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The frame of each segment at its joint: x, y, z</source>
      <translation>Das Koordinatensystem jedes Segments an seinem Gelenk: x, y, z</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Reference: {}</source>
      <translation>Referenz: {}</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Trail: {}</source>
      <translation>Spur: {}</translation>
    </message>
    <message>
      <location filename="app/panels/hand/legend.py" />
      <source>measured</source>
      <translation>gemessen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/legend.py" />
      <source>inferred</source>
      <translation>erschlossen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/legend.py" />
      <source>lost</source>
      <translation>verloren</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Making the hand's skin</source>
      <translation>Haut der Hand wird gemacht</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>What the hand shows now, and how much of it</source>
      <translation>Was die Hand jetzt zeigt, und wie sehr</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>truth</source>
      <translation>Wahrheit</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Not tracked yet: Replay, Track again</source>
      <translation>Noch ohne Tracking: Wiedergabe, Tracking wiederholen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>No hand yet</source>
      <translation>Noch keine Hand</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>The hand's skin is being made…</source>
      <translation>Die Haut der Hand wird gemacht…</translation>
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>Preparing the 3D view</source>
      <translation>3D-Ansicht wird vorbereitet</translation>
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D driver of the graphics card ended the program last time, so the hand is painted without it. The View menu brings the card back.</source>
      <translation>Der 3D-Treiber der Grafikkarte hat das Programm letztes Mal beendet, deshalb wird die Hand ohne sie gezeichnet. Das Menü Ansicht holt die Karte zurück.</translation>
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D view of the graphics card is not part of this installation; the hand is painted without it.</source>
      <translation>Die 3D-Ansicht der Grafikkarte gehört nicht zu dieser Installation; die Hand wird ohne sie gezeichnet.</translation>
    </message>
    <message>
      <location filename="app/panels/hand/view_chooser.py" />
      <source>The 3D view cannot use the graphics card; it is painted.</source>
      <translation>Die 3D-Ansicht kann die Grafikkarte nicht nutzen; sie wird gezeichnet.</translation>
    </message>
    <message>
      <location filename="app/panels/hand_choice.py" />
      <source>Left hand</source>
      <translation>Linke Hand</translation>
    </message>
    <message>
      <location filename="app/panels/hand_choice.py" />
      <source>Right hand</source>
      <translation>Rechte Hand</translation>
    </message>
    <message>
      <location filename="app/panels/hand_choice.py" />
      <source>Which hand</source>
      <translation>Welche Hand</translation>
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Two trackings compared</source>
      <translation>Zwei Trackings im Vergleich</translation>
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Copy</source>
      <translation>Kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Difference</source>
      <translation>Unterschied</translation>
    </message>
    <message>
      <location filename="app/panels/library/compare_dialog.py" />
      <source>Error of {}</source>
      <translation>Fehler von {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Reading two takes</source>
      <translation>Zwei Aufnahmen werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Comparing</source>
      <translation>Vergleich läuft</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Tracking {} again</source>
      <translation>Tracking von {} wird wiederholt</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Formats</source>
      <translation>Formate</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>the whole session</source>
      <translation>die ganze Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source> Hz</source>
      <translation> Hz</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>as recorded</source>
      <translation>wie aufgenommen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>without participant and notes</source>
      <translation>ohne Versuchsperson und Notizen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>What is done, in a sentence; else the notes say it</source>
      <translation>Was getan wird, in einem Satz; sonst sagen es die Notizen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>The task of a data set's episodes, for robot learning</source>
      <translation>Die Aufgabe der Episoden eines Datensatzes, für das Lernen von Robotern</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>an episode from each note to the next</source>
      <translation>eine Episode von jeder Notiz zur nächsten</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>as usual for the format</source>
      <translation>wie für das Format üblich</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>F&amp;older</source>
      <translation>&amp;Ordner</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Formats</source>
      <translation>&amp;Formate</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Range</source>
      <translation>&amp;Bereich</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>R&amp;ate</source>
      <translation>&amp;Rate</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>A&amp;xes</source>
      <translation>&amp;Achsen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Units</source>
      <translation>&amp;Einheiten</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Privacy</source>
      <translation>&amp;Datenschutz</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Task</source>
      <translation>&amp;Aufgabe</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>&amp;Episodes</source>
      <translation>&amp;Episoden</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Folder for the export</source>
      <translation>Ordner für den Export</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>{} sessions</source>
      <translation>{} Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Export {}</source>
      <translation>{} exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>only {} to {} (in and out point)</source>
      <translation>nur {} bis {} (Anfang und Ende)</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Cancel the export</source>
      <translation>Export abbrechen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Clear finished</source>
      <translation>Fertige entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Open folder</source>
      <translation>Ordner öffnen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Progress</source>
      <translation>Fortschritt</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Preset</source>
      <translation>Vorgabe</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Keep as…</source>
      <translation>Behalten als…</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Keep these formats and options</source>
      <translation>Diese Formate und Optionen behalten</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Name of the preset</source>
      <translation>Name der Vorgabe</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>none: as below</source>
      <translation>keine: wie unten</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_presets.py" />
      <source>Put back the preset {}</source>
      <translation>Vorlage {} wiederherstellen</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Gaps of the recording</source>
      <translation>Lücken der Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Kind of gap</source>
      <translation>Art der Lücke</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>All kinds</source>
      <translation>Alle Arten</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Part of the hand</source>
      <translation>Teil der Hand</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Parts without a sensor</source>
      <translation>Teile ohne Sensor</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>With sensor</source>
      <translation>Mit Sensor</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>All parts</source>
      <translation>Alle Teile</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Inferred longer than</source>
      <translation>Länger erschlossen als</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Method</source>
      <translation>Methode</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Longest gap to fill</source>
      <translation>Längste zu füllende Lücke</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Fill…</source>
      <translation>Füllen…</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Interpolate the selected gaps in a new file, which marks them; the recording itself is not changed</source>
      <translation>Ausgewählte Lücken in einer neuen Datei interpolieren, die sie kennzeichnet; die Aufnahme selbst bleibt unverändert</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>All parts of the hand</source>
      <translation>Alle Teile der Hand</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Fill</source>
      <translation>Füllen</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Start</source>
      <translation>Start</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Part</source>
      <translation>Teil</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Kind</source>
      <translation>Art</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Cause</source>
      <translation>Ursache</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>up to</source>
      <translation>bis zu</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>inferred over</source>
      <translation>erschlossen über</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>The gaps of a recording are listed while it is replayed.</source>
      <translation>Die Lücken einer Aufnahme werden aufgelistet, während sie wiedergegeben wird.</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>No gap matches these filters.</source>
      <translation>Keine Lücke entspricht diesen Filtern.</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>This recording has no gaps.</source>
      <translation>Diese Aufnahme hat keine Lücken.</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Fill {} gaps</source>
      <translation>{} Lücken füllen</translation>
    </message>
    <message>
      <location filename="app/panels/library/gaps.py" />
      <source>Listing the gaps</source>
      <translation>Lücken werden aufgelistet</translation>
    </message>
    <message>
      <location filename="app/panels/library/gaps.py" />
      <source>Filling gaps of {}</source>
      <translation>Lücken von {} werden gefüllt</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Sessions</source>
      <translation>Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Exports</source>
      <translation>Exporte</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Gaps</source>
      <translation>Lücken</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Mark the part first: I where it begins, O where it ends.</source>
      <translation>Erst den Teil markieren: I, wo er beginnt, O, wo er endet.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose a session in the library to export it.</source>
      <translation>Zum Exportieren eine Sitzung in der Bibliothek wählen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose a session in the library to track it again.</source>
      <translation>Zum Wiederholen des Trackings eine Sitzung in der Bibliothek wählen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Choose two sessions in the library.</source>
      <translation>Zwei Sitzungen in der Bibliothek wählen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Exports ({})</source>
      <translation>Exporte ({})</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Gaps ({})</source>
      <translation>Lücken ({})</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags, with commas between</source>
      <translation>Schlagwörter, durch Kommas getrennt</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Name</source>
      <translation>Name</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Rename {}</source>
      <translation>{} umbenennen</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags of {}</source>
      <translation>Schlagwörter von {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Recovering {}</source>
      <translation>{} wird gerettet</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Cropping {}</source>
      <translation>{} wird zugeschnitten</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags of {} sessions</source>
      <translation>Schlagwörter von {} Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>Tags removed: {}.</source>
      <translation>Schlagwörter entfernt: {}.</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} holds the chosen {} of {}.</source>
      <translation>{} enthält die gewählten {} aus {}.</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} is being recorded.</source>
      <translation>{} wird gerade aufgenommen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_files.py" />
      <source>{} is open: close it first (Ctrl+W).</source>
      <translation>{} ist geöffnet: erst schließen (Strg+W).</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Search by name, tag, date or quality</source>
      <translation>Suche nach Name, Schlagwort, Datum oder Qualität</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Search</source>
      <translation>Suche</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Choose two sessions of one movement</source>
      <translation>Zwei Sitzungen einer Bewegung wählen</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>More</source>
      <translation>Mehr</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Replay</source>
      <translation>Wiedergeben</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Track again…</source>
      <translation>Tracking wiederholen…</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Recover</source>
      <translation>Retten</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Two takes side by side</source>
      <translation>Zwei Aufnahmen nebeneinander</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Rename…</source>
      <translation>Umbenennen…</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Tags…</source>
      <translation>Schlagwörter…</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_page.py" />
      <source>Move to the bin</source>
      <translation>In den Papierkorb</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Recorded sessions</source>
      <translation>Aufgenommene Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Session</source>
      <translation>Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Recorded</source>
      <translation>Aufgenommen</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Quality</source>
      <translation>Qualität</translation>
    </message>
    <message>
      <location filename="app/panels/library/session_table.py" />
      <source>Tags</source>
      <translation>Schlagwörter</translation>
    </message>
    <message>
      <location filename="app/panels/library/take_pair.py" />
      <source>No image here</source>
      <translation>Hier ist kein Bild</translation>
    </message>
    <message>
      <location filename="app/panels/library/take_pair.py" />
      <source>Reading images</source>
      <translation>Bilder werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>the usual ones</source>
      <translation>die üblichen</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>every estimate knows the whole session (chain)</source>
      <translation>jede Schätzung kennt die ganze Sitzung (chain)</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>The recorded sensor data go through tracking again. The result becomes a session of its own beside this one; both are then shown together and compared.</source>
      <translation>Die aufgenommenen Sensordaten durchlaufen das Tracking noch einmal. Das Ergebnis wird eine eigene Sitzung neben dieser; beide werden dann zusammen gezeigt und verglichen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Choose…</source>
      <translation>Wählen…</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Settings</source>
      <translation>&amp;Einstellungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Engine</source>
      <translation>&amp;Verfahren</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Hand</source>
      <translation>&amp;Hand</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Glove</source>
      <translation>Handsch&amp;uh</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>&amp;Colours</source>
      <translation>&amp;Farben</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>S&amp;mooth</source>
      <translation>&amp;Glätten</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Track</source>
      <translation>Berechnen</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Settings</source>
      <translation>Einstellungen</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Track {} again</source>
      <translation>Tracking von {} wiederholen</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The range {} – {} was removed.</source>
      <translation>Der Bereich {} – {} wurde entfernt.</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Position in the session</source>
      <translation>Stelle in der Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Live</source>
      <translation>Live</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Back to the live hand (Ctrl+L)</source>
      <translation>Zurück zur laufenden Hand (Strg+L)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>A gap that was filled: not measured</source>
      <translation>Eine gefüllte Lücke: nicht gemessen</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Speed</source>
      <translation>Tempo</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Pause</source>
      <translation>Pause</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Ctrl+Space</source>
      <translation>Strg+Leertaste</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The image before (,)</source>
      <translation>Das Bild davor (,)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The next image (.)</source>
      <translation>Das nächste Bild (.)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The note before (Ctrl+,)</source>
      <translation>Die Notiz davor (Strg+,)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>The next note (Ctrl+.)</source>
      <translation>Die nächste Notiz (Strg+.)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>In</source>
      <translation>Anfang</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Begin the range here (I)</source>
      <translation>Den Bereich hier beginnen (I)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Out</source>
      <translation>Ende</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>End the range here (O)</source>
      <translation>Den Bereich hier beenden (O)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Whole</source>
      <translation>Ganz</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>No range</source>
      <translation>Kein Bereich</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Loop</source>
      <translation>Schleife</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Play the range over (L)</source>
      <translation>Den Bereich immer wieder abspielen (L)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Play</source>
      <translation>Abspielen</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>{} Correlation {:.2f}, elsewhere {:.2f} at most.</source>
      <translation>{} Korrelation {:.2f}, anderswo höchstens {:.2f}.</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Joint angle</source>
      <translation>Gelenkwinkel</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source> s</source>
      <translation> s</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>The second begins at</source>
      <translation>Die zweite beginnt bei</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>By clock</source>
      <translation>Nach Uhrzeit</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>As the computers' clocks had it</source>
      <translation>Nach den Uhren der Computer</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Both from their start</source>
      <translation>Beide ab Beginn</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>By movement</source>
      <translation>Nach der Bewegung</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Where the angles of both fit best</source>
      <translation>Wo die Winkel beider am besten passen</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Begin there the next time; for compare --align too</source>
      <translation>Beim nächsten Mal dort beginnen; auch für compare --align</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>The takes have no joint angle in common.</source>
      <translation>Die Aufnahmen haben keinen gemeinsamen Gelenkwinkel.</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>{} beside {}</source>
      <translation>{} neben {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>s from the start of {}</source>
      <translation>s ab Beginn von {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Kept in {}.</source>
      <translation>Aufgehoben in {}.</translation>
    </message>
    <message>
      <location filename="app/panels/log.py" />
      <source>Filter</source>
      <translation>Filter</translation>
    </message>
    <message>
      <location filename="app/panels/log.py" />
      <source>Bug report…</source>
      <translation>Fehlerbericht…</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Distance from</source>
      <translation>Abstand von</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Distance to</source>
      <translation>Abstand zu</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Measure this distance</source>
      <translation>Diesen Abstand messen</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Measure the chosen distances no more</source>
      <translation>Die gewählten Abstände nicht mehr messen</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Unit of angles</source>
      <translation>Einheit der Winkel</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Degrees</source>
      <translation>Grad</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Radians</source>
      <translation>Radiant</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Copy the table</source>
      <translation>Tabelle kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/motion/controls.py" />
      <source>Save as CSV…</source>
      <translation>Als CSV speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Measuring the take</source>
      <translation>Aufnahme wird vermessen</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Save the table</source>
      <translation>Tabelle speichern</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>CSV (*.csv)</source>
      <translation>CSV (*.csv)</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Reading the whole take…</source>
      <translation>Die ganze Aufnahme wird gelesen…</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distances removed: {}.</source>
      <translation>Abstände entfernt: {}.</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Angles and distances</source>
      <translation>Winkel und Abstände</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Angle or distance</source>
      <translation>Winkel oder Abstand</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Now</source>
      <translation>Jetzt</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>In its range</source>
      <translation>Im Bereich</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Least</source>
      <translation>Kleinster</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Greatest</source>
      <translation>Größter</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Range</source>
      <translation>Umfang</translation>
    </message>
    <message>
      <location filename="app/panels/motion/table.py" />
      <source>Fastest / s</source>
      <translation>Schnellste / s</translation>
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Notes of this recording</source>
      <translation>Notizen dieser Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Double-click to change a note, Delete to take it back</source>
      <translation>Doppelklick ändert eine Notiz, Entf nimmt sie zurück</translation>
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>At</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>Note</source>
      <translation>Notiz</translation>
    </message>
    <message>
      <location filename="app/panels/note_list.py" />
      <source>The note “{}” was deleted.</source>
      <translation>Die Notiz „{}“ wurde gelöscht.</translation>
    </message>
    <message>
      <location filename="app/panels/record_file.py" />
      <source>File of {}</source>
      <translation>Datei für {}</translation>
    </message>
    <message>
      <location filename="app/panels/record_file.py" />
      <source>Hand records (*{})</source>
      <translation>Handaufzeichnungen (*{})</translation>
    </message>
    <message>
      <location filename="app/panels/record_file.py" />
      <source>{}; where that is there already a number is added</source>
      <translation>{}; gibt es sie schon, kommt eine Zahl dazu</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>for example P01</source>
      <translation>zum Beispiel P01</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>for example pinch</source>
      <translation>zum Beispiel Pinzettengriff</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>May hold {participant}, {task}, {date}, {time} and a counter: {n} or {n:03}</source>
      <translation>Darf {participant}, {task}, {date}, {time} und einen Zähler enthalten: {n} oder {n:03}</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Participant</source>
      <translation>Versuchsperson</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Task</source>
      <translation>Aufgabe</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>File name</source>
      <translation>Dateiname</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Folder</source>
      <translation>Ordner</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Countdown</source>
      <translation>Countdown</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>with a beep</source>
      <translation>mit Ton</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Record</source>
      <translation>Aufnehmen</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Note (Enter adds it)</source>
      <translation>Notiz (Eingabetaste fügt sie hinzu)</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Time</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Messages</source>
      <translation>Nachrichten</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Losses</source>
      <translation>Verluste</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Disk</source>
      <translation>Festplatte</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Folder for recordings</source>
      <translation>Ordner für Aufnahmen</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Stop</source>
      <translation>Stopp</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>none</source>
      <translation>keiner</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>The recording was ended: the disk is nearly full.</source>
      <translation>Die Aufnahme wurde beendet: Die Festplatte ist fast voll.</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Not now ({})</source>
      <translation>Nicht jetzt ({})</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>{} s</source>
      <translation>{} s</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Remote control: start, stop and note from other programs</source>
      <translation>Fernsteuerung: Start, Stopp und Notiz aus anderen Programmen</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Others in the network can start and stop recordings at this address: there is no password.</source>
      <translation>An dieser Adresse können andere im Netz Aufnahmen starten und stoppen: Es gibt kein Passwort.</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>127.0.0.1: this computer alone. 0.0.0.0: all networks it is in</source>
      <translation>127.0.0.1: nur dieser Computer. 0.0.0.0: alle Netze, in denen er ist</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Listens at</source>
      <translation>Lauscht an</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>By</source>
      <translation>Über</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Port</source>
      <translation>Port</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Clients</source>
      <translation>Gegenstellen</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Requests</source>
      <translation>Anfragen</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Refused</source>
      <translation>Abgelehnt</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Angular rate / °/s</source>
      <translation>Drehrate / °/s</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Acceleration / g</source>
      <translation>Beschleunigung / g</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Joint angle / °</source>
      <translation>Gelenkwinkel / °</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Curves</source>
      <translation>Kurven</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Hold the curves; tracking goes on</source>
      <translation>Die Kurven festhalten; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Show this curve</source>
      <translation>Diese Kurve zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>IMU: {}</source>
      <translation>IMU: {}</translation>
    </message>
    <message>
      <location filename="app/panels/sensors.py" />
      <source>Angles: {}</source>
      <translation>Winkel: {}</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>The recording {} was cut off. What it holds can be recovered.</source>
      <translation>Die Aufnahme {} ist abgebrochen. Was sie enthält, lässt sich retten.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Glovetrack</source>
      <translation>Glovetrack</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Recent sessions</source>
      <translation>Letzte Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>All recorded sessions</source>
      <translation>Alle aufgenommenen Sitzungen</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Demo</source>
      <translation>Demo</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>A simulated glove and camera: see everything move, no hardware needed.</source>
      <translation>Handschuh und Kamera simuliert: Alles bewegt sich, ganz ohne Geräte.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Glove and camera</source>
      <translation>Handschuh und Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Find your devices and go through the set-up, step by step.</source>
      <translation>Geräte finden und Schritt für Schritt einrichten.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Recorded session</source>
      <translation>Aufgenommene Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Replay a session file, look at it frame by frame, export it.</source>
      <translation>Eine Sitzungsdatei abspielen, Bild für Bild ansehen, exportieren.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>{} more stand in the library.</source>
      <translation>Weitere in der Bibliothek: {}.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>127.0.0.1 is this computer alone; UDP and VMC send there, servers listen there</source>
      <translation>127.0.0.1 ist nur dieser Computer; UDP und VMC senden dorthin, Server lauschen dort</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>&amp;Address</source>
      <translation>&amp;Adresse</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Joints</source>
      <translation>Gelenke</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>What streams carry: our 21 joints, or the 26 joints of OpenXR in its axes</source>
      <translation>Was Streams tragen: die eigenen 21 Gelenke oder die 26 von OpenXR in dessen Achsen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Vibration motors: press one to feel it</source>
      <translation>Vibrationsmotoren: drücken, um einen zu spüren</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Strength of the test</source>
      <translation>Stärke des Tests</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Vibrate when a fingertip enters a sphere of</source>
      <translation>Vibrieren, wenn eine Fingerspitze in eine Kugel tritt von</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source> mm</source>
      <translation> mm</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Radius of the sphere</source>
      <translation>Radius der Kugel</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Put it at the index fingertip</source>
      <translation>An die Zeigefingerspitze setzen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>The sphere has no place yet.</source>
      <translation>Die Kugel hat noch keinen Ort.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Our joints</source>
      <translation>Eigene Gelenke</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>OpenXR joints</source>
      <translation>Gelenke von OpenXR</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Stream</source>
      <translation>Stream</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Sent</source>
      <translation>Gesendet</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Dropped</source>
      <translation>Verworfen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Strength</source>
      <translation>Stärke</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>The sphere stands at {:.0f}, {:.0f}, {:.0f} mm.</source>
      <translation>Die Kugel liegt bei {:.0f}, {:.0f}, {:.0f} mm.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Motor {}</source>
      <translation>Motor {}</translation>
    </message>
    <message>
      <location filename="app/platform/subprocess_job.py" />
      <source>It ended in the middle: was there too little memory?</source>
      <translation>Es endete mittendrin: War zu wenig Arbeitsspeicher da?</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the log of the window and of the program, and of a crash if there was one</source>
      <translation>das Protokoll des Fensters und des Programms, und eines Absturzes, falls es einen gab</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>versions of Glovetrack, its packages and the operating system; size of the machine</source>
      <translation>Versionen von Glovetrack, seinen Paketen und dem Betriebssystem; Größe des Computers</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>rates, latencies and losses of now</source>
      <translation>Raten, Latenzen und Verluste von jetzt</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window as it is now</source>
      <translation>ein Bild des Fensters, wie es jetzt ist</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window as it is now, with the library, the recording panel and the log blacked out</source>
      <translation>ein Bild des Fensters, wie es jetzt ist, mit Bibliothek, Aufnahme und Protokoll geschwärzt</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last {} s of the session that is open: sensor data and tracking, without camera images</source>
      <translation>die letzten {} s der offenen Sitzung: Sensordaten und Tracking, ohne Kamerabilder</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>A bug report of Glovetrack. It holds:</source>
      <translation>Ein Fehlerbericht von Glovetrack. Er enthält:</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the window's settings</source>
      <translation>die Einstellungen des Fensters</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the window's settings, without participant, task and folders</source>
      <translation>die Einstellungen des Fensters, ohne Versuchsperson, Aufgabe und Ordner</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last {} s of the session that is open: sensor data and tracking, with camera images</source>
      <translation>die letzten {} s der offenen Sitzung: Sensordaten und Tracking, mit Kamerabildern</translation>
    </message>
    <message>
      <location filename="app/platform/compiling.py" />
      <source>Glovetrack – first start</source>
      <translation>Glovetrack – erster Start</translation>
    </message>
    <message>
      <location filename="app/platform/compiling.py" />
      <source>Compiling the numerical kernels for this computer. This happens once and takes a minute or two on two cores.</source>
      <translation>Die Rechenkerne werden für diesen Rechner übersetzt. Das geschieht einmal und dauert auf zwei Prozessorkernen ein bis zwei Minuten.</translation>
    </message>
    <message>
      <location filename="app/platform/compiling.py" />
      <source>Start without waiting</source>
      <translation>Ohne Warten beginnen</translation>
    </message>
    <message>
      <location filename="app/platform/compiling.py" />
      <source>What is not compiled yet is compiled when it is first needed: the window pauses.</source>
      <translation>Was noch nicht übersetzt ist, wird es, sobald es gebraucht wird: Das Fenster stockt dann.</translation>
    </message>
    <message>
      <location filename="app/platform/crash.py" />
      <source>Something went wrong inside Glovetrack ({}: {}).</source>
      <translation>In Glovetrack ist etwas schiefgegangen ({}: {}).</translation>
    </message>
    <message>
      <location filename="app/platform/engine_sentences.py" />
      <source>{} and {}</source>
      <translation>{} und {}</translation>
    </message>
    <message>
      <location filename="app/platform/tasks.py" />
      <source>{} failed: {}: {}</source>
      <translation>„{}“ ist gescheitert: {}: {}</translation>
    </message>
    <message>
      <location filename="app/storage/bound_gloves.py" />
      <source>This is glove {} of the {} hand: its own files {} and {} are used.</source>
      <translation>Das ist Handschuh {} der {} Hand: Seine eigenen Dateien {} und {} werden verwendet.</translation>
    </message>
    <message>
      <location filename="app/storage/image_folder.py" />
      <source>{} is no image that can be read.</source>
      <translation>{} ist kein lesbares Bild.</translation>
    </message>
    <message>
      <location filename="app/storage/image_folder.py" />
      <source>{}: the image could not be packed.</source>
      <translation>{}: Das Bild ließ sich nicht packen.</translation>
    </message>
    <message>
      <location filename="app/storage/removed_file.py" />
      <source>{} exists again; it is not replaced by the removed one.</source>
      <translation>{} gibt es wieder; die entfernte Datei ersetzt sie nicht.</translation>
    </message>
    <message>
      <location filename="app/storage/removed_file.py" />
      <source>{} was not removed: {}.</source>
      <translation>{} wurde nicht entfernt: {}.</translation>
    </message>
    <message>
      <location filename="app/storage/session_tags.py" />
      <source>it is too large</source>
      <translation>zu groß</translation>
    </message>
    <message>
      <location filename="app/storage/session_tags.py" />
      <source>The tags of {} were left behind: {}.</source>
      <translation>Die Schlagwörter von {} blieben zurück: {}.</translation>
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>they do not say which version they are of</source>
      <translation>sie sagen nicht, von welcher Version sie sind</translation>
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>a later version of Glovetrack wrote them</source>
      <translation>eine spätere Version von Glovetrack hat sie geschrieben</translation>
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>The window's settings could not be used ({}), so it starts with its own. They are kept in {}.</source>
      <translation>Die Einstellungen des Fensters sind nicht zu verwenden ({}), deshalb startet es mit eigenen. Sie bleiben erhalten in {}.</translation>
    </message>
    <message>
      <location filename="app/storage/system_bin.py" />
      <source>{} cannot be moved to the bin.</source>
      <translation>{} kann nicht in den Papierkorb verschoben werden.</translation>
    </message>
    <message>
      <location filename="app/storage/system_bin.py" />
      <source>{} exists again, so the one in the bin stays there.</source>
      <translation>{} gibt es wieder, daher bleibt die Datei im Papierkorb.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>One camera cannot tell how large the hand is: measure it with a ruler and enter it under Hand length…</source>
      <translation>Eine Kamera sieht nicht, wie groß die Hand ist: mit einem Lineal messen und unter Handlänge… eingeben</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Spread the fingers and turn the hand in front of the camera so that sizes settle (least certain: {}).</source>
      <translation>Spreizen Sie die Finger und drehen Sie die Hand vor der Kamera, damit sich die Größen festigen (am unsichersten: {}).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Bend and stretch the fingers and turn the wrist so that the mounting of IMUs settles (least certain: {}).</source>
      <translation>Beugen und strecken Sie die Finger und drehen Sie das Handgelenk, damit sich die Lage der IMUs festigt (am unsichersten: {}).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Hold the hand still for three seconds so that gyro biases settle (least certain: {}).</source>
      <translation>Halten Sie die Hand drei Sekunden still, damit sich die Gyroskop-Nullpunkte festigen (am unsichersten: {}).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Hold the hand at several slants so that accelerometer biases settle (least certain: {}).</source>
      <translation>Halten Sie die Hand in mehreren Neigungen, damit sich die Nullpunkte der Beschleunigungssensoren festigen (am unsichersten: {}).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>more than 2σ of both</source>
      <translation>mehr als 2σ von beiden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>within 2σ of both</source>
      <translation>innerhalb 2σ von beiden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>Everything has settled.</source>
      <translation>Alles ist stabil.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>not known yet: turn the hand</source>
      <translation>noch nicht bekannt: die Hand drehen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>late</source>
      <translation>zu spät</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>early</source>
      <translation>zu früh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>corrected</source>
      <translation>korrigiert</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>not corrected</source>
      <translation>nicht korrigiert</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>later</source>
      <translation>später</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>earlier</source>
      <translation>früher</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>now {}
change {}: {}</source>
      <translation>jetzt {}
Änderung {}: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>{:.1f} ± {:.1f} ms</source>
      <translation>{:.1f} ± {:.1f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>{} {}, {}</source>
      <translation>{} {}, {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>both images arrive, the right one {:.1f} ms {}, which is taken off</source>
      <translation>beide Bilder kommen, das rechte {:.1f} ms {}, was abgezogen wird</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>none (± {:.1f} ms)</source>
      <translation>keiner (± {:.1f} ms)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>wrong size</source>
      <translation>falsche Größe</translation>
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>not convex</source>
      <translation>nicht konvex</translation>
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>not round</source>
      <translation>nicht rund</translation>
    </message>
    <message>
      <location filename="app/viewmodels/camera_overlay.py" />
      <source>at the edge</source>
      <translation>am Rand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>exposure</source>
      <translation>Belichtung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>gain</source>
      <translation>Verstärkung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>white balance</source>
      <translation>Weißabgleich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Glove found</source>
      <translation>Handschuh gefunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No glove answers. Plug it in, or try the demo.</source>
      <translation>Kein Handschuh antwortet. Anschließen oder die Demo versuchen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>All IMUs answer</source>
      <translation>Alle IMUs antworten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Measured at rest</source>
      <translation>In Ruhe vermessen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Lay the hand flat on the table for two seconds.</source>
      <translation>Die Hand zwei Sekunden flach auf den Tisch legen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Camera found</source>
      <translation>Kamera gefunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Camera calibrated</source>
      <translation>Kamera kalibriert</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Exposure locked</source>
      <translation>Belichtung gesperrt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Colours tuned</source>
      <translation>Farben abgestimmt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Hand in view</source>
      <translation>Hand im Bild</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Calibration settled</source>
      <translation>Kalibrierung stabil</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The glove does not respond. Is it plugged in?</source>
      <translation>Der Handschuh antwortet nicht. Ist er angeschlossen?</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Search again</source>
      <translation>Erneut suchen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Measure</source>
      <translation>Messen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The camera does not respond. Is it plugged in?</source>
      <translation>Die Kamera antwortet nicht. Ist sie angeschlossen?</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No images arrive.</source>
      <translation>Es kommen keine Bilder an.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show a printed board to the camera.</source>
      <translation>Der Kamera eine gedruckte Tafel zeigen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Cannot be verified: this source has no exposure control. Fix the exposure at the source itself.</source>
      <translation>Nicht überprüfbar: Diese Quelle hat keine Belichtungssteuerung. Stellen Sie die Belichtung an der Quelle selbst fest ein.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Cannot be verified: this camera has no controls. Keep the light constant.</source>
      <translation>Nicht überprüfbar: Diese Kamera hat keine Regler. Halten Sie das Licht konstant.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Tune colours</source>
      <translation>Farben abstimmen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Hold the hand flat, about 35 cm before the camera, for two seconds.</source>
      <translation>Die Hand zwei Sekunden flach halten, etwa 35 cm vor der Kamera.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Not connected.</source>
      <translation>Nicht verbunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Look for it</source>
      <translation>Danach suchen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for the glove.</source>
      <translation>Wartet auf den Handschuh.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Set up the glove</source>
      <translation>Handschuh einrichten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Show sensors</source>
      <translation>Sensoren zeigen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>this engine estimates no biases</source>
      <translation>dieses Verfahren schätzt keinen Bias</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The left image is missing.</source>
      <translation>Das linke Bild fehlt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The right image is missing.</source>
      <translation>Das rechte Bild fehlt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Calibrate</source>
      <translation>Kalibrieren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>one camera: distances are as sure as the hand's size</source>
      <translation>eine Kamera: Abstände sind so sicher wie die Größe der Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for images.</source>
      <translation>Wartet auf Bilder.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>it does not change here</source>
      <translation>sie ändert sich hier nicht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Lock it now</source>
      <translation>Jetzt sperren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Reading the light…</source>
      <translation>Licht wird gemessen…</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>the markers are clear</source>
      <translation>die Marker sind deutlich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Searching for markers…</source>
      <translation>Marker werden gesucht…</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No marker is found.</source>
      <translation>Kein Marker gefunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for glove and camera.</source>
      <translation>Wartet auf Handschuh und Kamera.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>tracking</source>
      <translation>wird verfolgt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Needs glove and calibrated camera.</source>
      <translation>Braucht Handschuh und kalibrierte Kamera.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>It was tracked and is not in view now.</source>
      <translation>Sie wurde verfolgt und ist jetzt nicht im Bild.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waits for tracking.</source>
      <translation>Wartet auf das Tracking.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Hold poses</source>
      <translation>Posen halten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>{} of {}</source>
      <translation>{} von {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>images of one camera arrive</source>
      <translation>Bilder einer Kamera kommen an</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>baseline {:.1f} mm</source>
      <translation>Basislänge {:.1f} mm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The camera changes {} by itself.</source>
      <translation>Die Kamera ändert {} von selbst.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Cannot be verified: the camera does not confirm {}.</source>
      <translation>Nicht überprüfbar: Die Kamera bestätigt {} nicht.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The intervals of {} overlap.</source>
      <translation>Die Bereiche von {} überlappen sich.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Not seen: {}. Turn the hand, or tune the colours.</source>
      <translation>Nicht zu sehen: {}. Die Hand drehen oder die Farben abstimmen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>{} of {} markers are not found with these colours.</source>
      <translation>{} von {} Markern werden mit diesen Farben nicht gefunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>seen: {}</source>
      <translation>zu sehen: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Update it under Set-up, Glove firmware.</source>
      <translation>Aktualisieren Sie sie unter Einrichtung, Handschuh-Firmware.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Not responding: {}.</source>
      <translation>Keine Antwort: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>gyros known to {:.1f} °/s</source>
      <translation>Gyroskope auf {:.1f} °/s genau</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>both images arrive</source>
      <translation>beide Bilder kommen an</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>hand length {}</source>
      <translation>Handlänge {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Nothing was fitted: no patches of these colours were found.</source>
      <translation>Nichts angepasst: Es wurden keine Flecken dieser Farben gefunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>{} (1 patch)</source>
      <translation>{} (Flecken: 1)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>{} ({} patches)</source>
      <translation>{} (Flecken: {})</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>There is no image yet to fit the colours to.</source>
      <translation>Es gibt noch kein Bild, an das die Farben angepasst werden könnten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}. Kept {}: too few are seen.</source>
      <translation>Angepasst: {}. Belassen: {}, es sind zu wenige zu sehen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>No markers were tracked yet. Fit from the image alone first.</source>
      <translation>Noch wurden keine Marker verfolgt. Erst allein aus dem Bild anpassen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}.</source>
      <translation>Angepasst: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_live.py" />
      <source>Fitting to what is seen needs the glove and its camera, calibrated. Fit to one image instead.</source>
      <translation>Das Anpassen an das Gesehene braucht den Handschuh und seine Kamera, kalibriert. Stattdessen an ein Bild anpassen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>This pixel is too grey or too dark to have a hue (saturation {}, value {}). Click the middle of a {} marker.</source>
      <translation>Dieser Bildpunkt ist zu grau oder zu dunkel für einen Farbton (Sättigung {}, Helligkeit {}). Klicken Sie auf die Mitte eines Markers in {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>This looks like {0}, not {1}. Choose {0} first, or click again to take it.</source>
      <translation>Das sieht nach {0} aus, nicht nach {1}. Wählen Sie zuerst {0}, oder klicken Sie noch einmal, um es zu übernehmen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>Clicked: {}. Still to be clicked before the colours are learned: {}.</source>
      <translation>Angeklickt: {}. Noch anzuklicken, ehe die Farben gelernt werden: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>The colours follow the light.</source>
      <translation>Die Farben folgen dem Licht.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>The room has none of the colours.</source>
      <translation>Der Raum hat keine der Farben.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>Exported to {}</source>
      <translation>Exportiert nach {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>Colours of {}</source>
      <translation>Farben von {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>{} must have the hues {} for this glove.</source>
      <translation>{} muss für diesen Handschuh die Farbtöne {} haben.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>no image</source>
      <translation>kein Bild</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image, about {:.0f} expected</source>
      <translation>{:.0f} in einem Bild gefunden, etwa {:.0f} erwartet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image, none expected</source>
      <translation>{:.0f} in einem Bild gefunden, keine erwartet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} of about {:.0f}</source>
      <translation>{:.0f} von etwa {:.0f}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>overlaps {}</source>
      <translation>überlappt {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>the room has this colour too ({:.2g} % of it)</source>
      <translation>der Raum hat diese Farbe auch ({:.2g} % davon)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image</source>
      <translation>{:.0f} in einem Bild gefunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>{} is nearer to the truth: {} on average.</source>
      <translation>{} ist näher an der Wahrheit: {} im Mittel.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all keypoints, mean</source>
      <translation>alle Schlüsselpunkte, Mittel</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all keypoints, largest</source>
      <translation>alle Schlüsselpunkte, größter</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>all joints, rms</source>
      <translation>alle Gelenke, RMS</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>{} instants in common; keypoints differ by {} on average, joints by {} (rms).</source>
      <translation>Gemeinsame Zeitpunkte: {}; Schlüsselpunkte weichen im Mittel um {} ab, Gelenke um {} (RMS).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>Both are the same to the last bit ({} instants).</source>
      <translation>Beide sind bis aufs letzte Bit gleich (Zeitpunkte: {}).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>not reported</source>
      <translation>nicht gemeldet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Exposure</source>
      <translation>Belichtung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Gain</source>
      <translation>Verstärkung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>White balance</source>
      <translation>Weißabgleich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>unplugged</source>
      <translation>nicht angeschlossen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>waiting for the glove's description</source>
      <translation>wartet auf die Beschreibung des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>receiving packets</source>
      <translation>empfängt Pakete</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>no packets</source>
      <translation>keine Pakete</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>reported by the device</source>
      <translation>vom Gerät gemeldet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>from a file</source>
      <translation>aus einer Datei</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>confirmed by the device</source>
      <translation>vom Gerät bestätigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>not confirmed by the device</source>
      <translation>vom Gerät nicht bestätigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>not confirmed yet</source>
      <translation>noch nicht bestätigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Glove</source>
      <translation>Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Motors</source>
      <translation>Motoren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Left glove</source>
      <translation>Linker Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Right glove</source>
      <translation>Rechter Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Connection</source>
      <translation>Verbindung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Only FTDI adapters on Linux report it.</source>
      <translation>Nur FTDI-Adapter unter Linux melden ihn.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Sample rate</source>
      <translation>Abtastrate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Measured sample rate</source>
      <translation>Gemessene Abtastrate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Number</source>
      <translation>Nummer</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>IMUs</source>
      <translation>IMUs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>limits not reported</source>
      <translation>Grenzen nicht gemeldet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>{}: {} in the file, {} now ({})</source>
      <translation>{}: {} in der Datei, jetzt {} ({})</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>yes</source>
      <translation>ja</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>no</source>
      <translation>nein</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Glove file</source>
      <translation>Handschuhdatei</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>USB adapter</source>
      <translation>USB-Adapter</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Adapter's serial number</source>
      <translation>Seriennummer des Adapters</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Latency timer</source>
      <translation>Latenz-Timer</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Clock skew</source>
      <translation>Uhrenabweichung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Serial number</source>
      <translation>Seriennummer</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Firmware</source>
      <translation>Firmware</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Protocol version</source>
      <translation>Protokollversion</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Range of angular rate</source>
      <translation>Messbereich der Drehrate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Range of acceleration</source>
      <translation>Messbereich der Beschleunigung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Battery</source>
      <translation>Batterie</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Temperature</source>
      <translation>Temperatur</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Answers</source>
      <translation>Antwortet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Bias of angular rate</source>
      <translation>Nullpunkt der Drehrate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Bias of acceleration</source>
      <translation>Nullpunkt der Beschleunigung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>in the recording</source>
      <translation>in der Aufnahme</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Size of one image</source>
      <translation>Größe eines Bildes</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Rate granted</source>
      <translation>Gewährte Rate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Rate measured</source>
      <translation>Gemessene Rate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Controls</source>
      <translation>Regler</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>will be applied</source>
      <translation>wird angewendet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>cannot be changed</source>
      <translation>nicht änderbar</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>The protocol does not report whether a motor runs.</source>
      <translation>Das Protokoll meldet nicht, ob ein Motor läuft.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Path</source>
      <translation>Pfad</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Pixel format</source>
      <translation>Pixelformat</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Size granted</source>
      <translation>Gewährte Größe</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Driver</source>
      <translation>Treiber</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>{} to {}, default {}</source>
      <translation>{} bis {}, Vorgabe {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>{} has the values that the devices have.</source>
      <translation>{} enthält dieselben Werte wie die Geräte.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>{}: {} differences, {} to be applied.</source>
      <translation>{}: {} Unterschiede, {} anzuwenden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>measured {}</source>
      <translation>gemessen {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Device {}</source>
      <translation>Gerät {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>now {}</source>
      <translation>jetzt {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>interpolated</source>
      <translation>interpoliert</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>hidden from the camera</source>
      <translation>für die Kamera verdeckt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>images not searched</source>
      <translation>Bilder nicht durchsucht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>no images</source>
      <translation>keine Bilder</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>packets missing</source>
      <translation>Pakete fehlen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>an IMU did not answer</source>
      <translation>eine IMU hat nicht geantwortet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>no sensor on it</source>
      <translation>kein Sensor daran</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>nothing was recorded</source>
      <translation>nichts wurde aufgenommen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>no estimate was computed</source>
      <translation>keine Schätzung wurde berechnet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>unknown</source>
      <translation>unbekannt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>Linear</source>
      <translation>Linear</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>Cubic</source>
      <translation>Kubisch</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>Sensors, smoothed</source>
      <translation>Sensoren, geglättet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>hand</source>
      <translation>Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>It cannot be filled: nothing is known on one of its sides.</source>
      <translation>Sie kann nicht gefüllt werden: Auf einer Seite ist nichts bekannt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>Filled {} gaps of {} by interpolation in {}; the original is unchanged.</source>
      <translation>{} Lücken von {} durch Interpolation in {} gefüllt; das Original ist unverändert.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>hole</source>
      <translation>Loch</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>Not filled: {}.</source>
      <translation>Nicht gefüllt: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>pinch, index finger</source>
      <translation>Pinzettengriff, Zeigefinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>pinch, middle finger</source>
      <translation>Pinzettengriff, Mittelfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>pinch, ring finger</source>
      <translation>Pinzettengriff, Ringfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>pinch, little finger</source>
      <translation>Pinzettengriff, kleiner Finger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>thumb up</source>
      <translation>Daumen hoch</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>fist</source>
      <translation>Faust</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>point</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>open palm</source>
      <translation>offene Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>grasp</source>
      <translation>Greifen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>poke</source>
      <translation>Tippen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gestures.py" />
      <source>{} (low confidence)</source>
      <translation>{} (unsicher)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>go on…</source>
      <translation>weiter…</translation>
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Lay the hand flat on the table, palm down, and hold it still.</source>
      <translation>Die Hand flach auf den Tisch legen, Innenseite nach unten, und stillhalten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Measured.</source>
      <translation>Gemessen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>{} of {}: {}</source>
      <translation>{} von {}: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/glove_setup.py" />
      <source>Waiting for rest. {}</source>
      <translation>Warten auf Ruhe. {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/graphs.py" />
      <source>This graph shows {} and {} already. Add another graph for {}.</source>
      <translation>Dieses Diagramm zeigt schon {} und {}. Fügen Sie für {} ein weiteres hinzu.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/graphs.py" />
      <source>counts</source>
      <translation>Anzahlen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/graphs.py" />
      <source>A graph has at most {} curves. Add another graph.</source>
      <translation>Ein Diagramm hat höchstens {} Kurven. Fügen Sie ein weiteres hinzu.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>thumb</source>
      <translation>Daumen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>index finger</source>
      <translation>Zeigefinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>middle finger</source>
      <translation>Mittelfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>ring finger</source>
      <translation>Ringfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>little finger</source>
      <translation>kleiner Finger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>The end joint of your {} bends {:.0f}° more than was thought.</source>
      <translation>Endgelenk {}: beugt sich {:.0f}° mehr als angenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>The end joint of your {} bends {:.0f}° less than was thought.</source>
      <translation>Endgelenk {}: beugt sich {:.0f}° weniger als angenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>Your hand is {:.1f} mm longer than was thought.</source>
      <translation>Die Hand ist {:.1f} mm länger als angenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>Your hand is {:.1f} mm shorter than was thought.</source>
      <translation>Die Hand ist {:.1f} mm kürzer als angenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>Tip of the thumb, to the side</source>
      <translation>Daumenspitze, zur Seite</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>Length of the hand</source>
      <translation>Länge der Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>End joint of the {}, stretched</source>
      <translation>Endgelenk {}, gestreckt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_result.py" />
      <source>End joint of the {}, bent</source>
      <translation>Endgelenk {}, gebeugt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Hold it: no sensor tells of this finger</source>
      <translation>Halten: kein Sensor sieht diesen Finger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Hand flat on the table, fingers together</source>
      <translation>Hand flach auf dem Tisch, Finger geschlossen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Flat on the table, fingers and thumb spread</source>
      <translation>Flach auf dem Tisch, Finger und Daumen gespreizt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>A firm fist, the thumb over the fingers</source>
      <translation>Eine feste Faust, der Daumen über den Fingern</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>A fist with the thumb straight</source>
      <translation>Eine Faust mit gestrecktem Daumen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Thumb on the tip of the index finger</source>
      <translation>Daumen auf die Spitze des Zeigefingers</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Thumb on the tip of the middle finger</source>
      <translation>Daumen auf die Spitze des Mittelfingers</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Thumb on the tip of the ring finger</source>
      <translation>Daumen auf die Spitze des Ringfingers</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Thumb on the tip of the little finger</source>
      <translation>Daumen auf die Spitze des kleinen Fingers</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>flat</source>
      <translation>flach</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>spread</source>
      <translation>gespreizt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>thumb straight</source>
      <translation>Daumen gestreckt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>index</source>
      <translation>Zeigef.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>middle</source>
      <translation>Mittelf.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>ring</source>
      <translation>Ringf.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>little</source>
      <translation>kleiner F.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Straighten the thumb</source>
      <translation>Daumen strecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Straighten the index finger</source>
      <translation>Zeigefinger strecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Straighten the middle finger</source>
      <translation>Mittelfinger strecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Straighten the ring finger</source>
      <translation>Ringfinger strecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Straighten the little finger</source>
      <translation>Kleinen Finger strecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bend the thumb more</source>
      <translation>Daumen stärker beugen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bend the index finger more</source>
      <translation>Zeigefinger stärker beugen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bend the middle finger more</source>
      <translation>Mittelfinger stärker beugen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bend the ring finger more</source>
      <translation>Ringfinger stärker beugen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bend the little finger more</source>
      <translation>Kleinen Finger stärker beugen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Nothing arrives from the glove</source>
      <translation>Vom Handschuh kommt nichts an</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Show the hand to the camera</source>
      <translation>Der Kamera die Hand zeigen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Bring the tips together</source>
      <translation>Die Spitzen zusammenführen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Hold it</source>
      <translation>Halten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Next</source>
      <translation>Weiter</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Place unknown: orientation and finger angles by the IMUs alone</source>
      <translation>Ort unbekannt: Lage und Fingerwinkel allein nach den IMUs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Nothing arrives: the hand stands as it was last</source>
      <translation>Es kommt nichts an: Die Hand steht, wie sie zuletzt war</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>No estimates here: showing the last pose</source>
      <translation>Hier gibt es keine Schätzungen: letzte Haltung wird gezeigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Position lost: the hand stands where it was last seen</source>
      <translation>Ort verloren: Die Hand steht, wo sie zuletzt zu sehen war</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>being recorded</source>
      <translation>wird aufgenommen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>unreadable</source>
      <translation>unlesbar</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>not tracked</source>
      <translation>ohne Tracking</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>tracked {} %</source>
      <translation>verfolgt {} %</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>tracked left {}, right {} %</source>
      <translation>verfolgt links {}, rechts {} %</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>by its IMUs alone</source>
      <translation>allein durch ihre IMUs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>whole</source>
      <translation>vollständig</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>cut off</source>
      <translation>abgebrochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>too bright</source>
      <translation>zu hell</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>too dark</source>
      <translation>zu dunkel</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>noisy</source>
      <translation>verrauscht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>too warm</source>
      <translation>zu warm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>too cold</source>
      <translation>zu kalt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>hues alike</source>
      <translation>Farbtöne ähnlich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>colours in the room</source>
      <translation>Farben im Raum</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>markers missed</source>
      <translation>Marker übersehen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>good</source>
      <translation>gut</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>No image has been looked at yet.</source>
      <translation>Noch wurde kein Bild angesehen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>Nothing to change: the markers are clear.</source>
      <translation>Nichts zu ändern: Die Marker sind deutlich.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>noise {:.1f} levels</source>
      <translation>Rauschen {:.1f} Stufen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>{} of {} markers found</source>
      <translation>{} von {} Markern gefunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>brightness {:.0f} of 255</source>
      <translation>Helligkeit {:.0f} von 255</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>red to blue on the cloth {:.1f}</source>
      <translation>Rot zu Blau auf dem Stoff {:.1f}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Problems</source>
      <translation>Probleme</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Devices</source>
      <translation>Geräte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Tracking</source>
      <translation>Tracking</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Computer</source>
      <translation>Computer</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>Notes</source>
      <translation>Notizen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>a note was deleted</source>
      <translation>eine Notiz wurde gelöscht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/log.py" />
      <source>changed to: {}</source>
      <translation>geändert in: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>wrist</source>
      <translation>Handgelenk</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>dorsum</source>
      <translation>Handrücken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>palm</source>
      <translation>Handfläche</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>metacarpal</source>
      <translation>Mittelhand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>proximal</source>
      <translation>proximal</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>intermediate</source>
      <translation>medial</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>distal</source>
      <translation>distal</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>tip</source>
      <translation>Spitze</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>flexion</source>
      <translation>Beugung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>abduction</source>
      <translation>Abspreizung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>twist</source>
      <translation>Drehung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>red</source>
      <translation>Rot</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>green</source>
      <translation>Grün</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>blue</source>
      <translation>Blau</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>yellow</source>
      <translation>Gelb</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>thumb, first bone</source>
      <translation>Daumen, erster Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>thumb, second bone</source>
      <translation>Daumen, zweiter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>thumb, third bone</source>
      <translation>Daumen, dritter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>index finger, first bone</source>
      <translation>Zeigefinger, erster Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>index finger, second bone</source>
      <translation>Zeigefinger, zweiter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>index finger, third bone</source>
      <translation>Zeigefinger, dritter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>middle finger, first bone</source>
      <translation>Mittelfinger, erster Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>middle finger, second bone</source>
      <translation>Mittelfinger, zweiter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>middle finger, third bone</source>
      <translation>Mittelfinger, dritter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>ring finger, first bone</source>
      <translation>Ringfinger, erster Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>ring finger, second bone</source>
      <translation>Ringfinger, zweiter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>ring finger, third bone</source>
      <translation>Ringfinger, dritter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>little finger, first bone</source>
      <translation>kleiner Finger, erster Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>little finger, second bone</source>
      <translation>kleiner Finger, zweiter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>little finger, third bone</source>
      <translation>kleiner Finger, dritter Knochen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/names.py" />
      <source>back of the hand</source>
      <translation>Handrücken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>just now</source>
      <translation>gerade eben</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>1 minute ago</source>
      <translation>vor 1 Minute</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>today, {:%H:%M}</source>
      <translation>heute, {:%H:%M}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>yesterday, {:%H:%M}</source>
      <translation>gestern, {:%H:%M}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>{} days ago</source>
      <translation>vor {} Tagen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recent.py" />
      <source>{} minutes ago</source>
      <translation>vor {} Minuten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} free</source>
      <translation>{} frei</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Under 1 GB is left: recording is not possible on this disk.</source>
      <translation>Weniger als 1 GB ist frei: Auf dieser Festplatte ist keine Aufnahme möglich.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Under 5 GB is left on this disk.</source>
      <translation>Auf dieser Festplatte sind weniger als 5 GB frei.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} packets</source>
      <translation>Pakete: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} images not recorded</source>
      <translation>nicht aufgenommene Bilder: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} free, about {} of recording</source>
      <translation>{} frei, etwa {} Aufnahme</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>{} messages that the computer had no time for</source>
      <translation>Nachrichten, für die der Computer keine Zeit hatte: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Nothing can be recorded to {}: {}.</source>
      <translation>Nach {} lässt sich nichts aufnehmen: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>somebody is there</source>
      <translation>jemand ist da</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>nobody asks</source>
      <translation>niemand fragt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>not open</source>
      <translation>nicht offen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>off</source>
      <translation>aus</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>opening</source>
      <translation>öffnet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/remote.py" />
      <source>{}, {} s ago</source>
      <translation>{}, vor {} s</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames whose stuffing was broken (COBS)</source>
      <translation>Datenrahmen mit fehlerhafter Kodierung (COBS)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames whose check sum was wrong (CRC)</source>
      <translation>Datenrahmen mit falscher Prüfsumme (CRC)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of a wrong length</source>
      <translation>Datenrahmen falscher Länge</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of an unknown type, or far too long</source>
      <translation>Datenrahmen unbekannter Art oder viel zu lang</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Times that the port was opened again</source>
      <translation>Wie oft der Anschluss neu geöffnet wurde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Restarts of the glove</source>
      <translation>Neustarts des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Jumps of the glove's clock</source>
      <translation>Sprünge der Uhr des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Packets that the glove had no time to send</source>
      <translation>Pakete, für die der Handschuh keine Sendezeit hatte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>The host's time gained on the glove's clock, ppm</source>
      <translation>Vorgang der Computeruhr gegen die Uhr des Handschuhs, ppm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Time that the USB adapter holds bytes back, ms</source>
      <translation>Zeit, die der USB-Adapter Bytes zurückhält, ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>battery {:.2f} V</source>
      <translation>Akku {:.2f} V</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>adapter waits {:.0f} ms</source>
      <translation>Adapter wartet {:.0f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>silent</source>
      <translation>schweigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ battery low: {:.2f} V</source>
      <translation>⚠ Akku schwach: {:.2f} V</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ adapter waits {:.0f} ms</source>
      <translation>⚠ Adapter wartet {:.0f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>answers</source>
      <translation>antwortet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>jitter {:.1f} ms</source>
      <translation>Jitter {:.1f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 frame damaged</source>
      <translation>1 Datenrahmen beschädigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} frames damaged</source>
      <translation>{} Datenrahmen beschädigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 packet dropped by the glove</source>
      <translation>1 Paket vom Handschuh verworfen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} packets dropped by the glove</source>
      <translation>{} Pakete vom Handschuh verworfen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 restart</source>
      <translation>1 Neustart</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} restarts</source>
      <translation>{} Neustarts</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 reconnection</source>
      <translation>1 Neuverbindung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} reconnections</source>
      <translation>{} Neuverbindungen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>1 jump of its clock</source>
      <translation>1 Sprung seiner Uhr</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} jumps of its clock</source>
      <translation>{} Sprünge seiner Uhr</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>clock {:+.0f} ppm</source>
      <translation>Uhr {:+.0f} ppm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>no samples</source>
      <translation>keine Messwerte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} packet lost</source>
      <translation>{:.0f} Paket verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} packets lost</source>
      <translation>{:.0f} Pakete verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{:.0f} % missing</source>
      <translation>{:.0f} % fehlen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/set_up_steps.py" />
      <source>Ready</source>
      <translation>Bereit</translation>
    </message>
    <message>
      <location filename="app/viewmodels/set_up_steps.py" />
      <source>{} of {} done</source>
      <translation>{} von {} erledigt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/set_up_steps.py" />
      <source>Ready, {} to check</source>
      <translation>Bereit, {} zu prüfen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>packets each second</source>
      <translation>Pakete pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>images each second</source>
      <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>estimates each second</source>
      <translation>Schätzungen pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>latency, image to estimate</source>
      <translation>Latenz, Bild bis Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>latency, packet to estimate</source>
      <translation>Latenz, Paket bis Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>search of both images</source>
      <translation>Suche in beiden Bildern</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>engine's step</source>
      <translation>Rechenschritt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>packets lost</source>
      <translation>verlorene Pakete</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>images dropped</source>
      <translation>ausgelassene Bilder</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>share of images missed</source>
      <translation>Anteil verpasster Bilder</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>degree of overload</source>
      <translation>Grad der Überlastung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>battery voltage</source>
      <translation>Batteriespannung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>temperature of the glove</source>
      <translation>Temperatur des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>delay of the camera</source>
      <translation>Verzögerung der Kamera</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>clock skew of the glove</source>
      <translation>Uhrenabweichung des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>latency timer of the USB adapter</source>
      <translation>Latenz-Timer des USB-Adapters</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>markers in both images</source>
      <translation>Marker in beiden Bildern</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>uncertainty of the heading</source>
      <translation>Unsicherheit der Richtung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>state of tracking (0 to 3)</source>
      <translation>Zustand des Trackings (0 bis 3)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Joint speeds</source>
      <translation>Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Joint angles</source>
      <translation>Gelenkwinkel</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>of the estimate</source>
      <translation>der Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>of the prediction</source>
      <translation>der Vorhersage</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Rates, latency and battery</source>
      <translation>Raten, Latenz und Batterie</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>angular rate</source>
      <translation>Drehrate</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>acceleration</source>
      <translation>Beschleunigung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>blobs, left</source>
      <translation>Farbflecken, links</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>blobs, right</source>
      <translation>Farbflecken, rechts</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>matched markers, left</source>
      <translation>zugeordnete Marker, links</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>matched markers, right</source>
      <translation>zugeordnete Marker, rechts</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>matched markers, both images</source>
      <translation>zugeordnete Marker, beide Bilder</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>norm</source>
      <translation>Betrag</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>speed</source>
      <translation>Geschwindigkeit</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>standard deviation</source>
      <translation>Standardabweichung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Images</source>
      <translation>Bilder</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Gestures</source>
      <translation>Gesten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>residual {}, left (RMS)</source>
      <translation>Residuum {}, links (RMS)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>residual {}, right (RMS)</source>
      <translation>Residuum {}, rechts (RMS)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>Keypoints</source>
      <translation>Punkte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>attention</source>
      <translation>Achtung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>problem</source>
      <translation>Problem</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>idle</source>
      <translation>ruht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Searching for the hand</source>
      <translation>Suche nach der Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Coasting on the glove alone</source>
      <translation>Nur noch nach dem Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/states.py" />
      <source>Position lost</source>
      <translation>Ort verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Search of both images</source>
      <translation>Suche in beiden Bildern</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>The engine's step for a message</source>
      <translation>Der Schritt des Verfahrens für eine Nachricht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>A packet's arrival to its estimate</source>
      <translation>Von der Ankunft eines Pakets bis zu seiner Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>An image's arrival to the estimate made of it</source>
      <translation>Von der Ankunft eines Bildes bis zur Schätzung daraus</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>3D view slower</source>
      <translation>3D-Ansicht langsamer</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>overlays off</source>
      <translation>Einblendungen aus</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>full-frame search off</source>
      <translation>Suche im ganzen Bild aus</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>fewer images searched</source>
      <translation>weniger Bilder durchsucht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>As it was recorded</source>
      <translation>Wie aufgenommen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Estimates of the hand each second</source>
      <translation>Schätzungen der Hand pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Packets of the glove that never arrived; images that came faster than they were read</source>
      <translation>Pakete des Handschuhs, die nie ankamen; Bilder, die schneller kamen, als sie gelesen wurden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Place unknown</source>
      <translation>Ort unbekannt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>System overloaded:</source>
      <translation>System überlastet:</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Overloaded</source>
      <translation>Überlastet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Packets of the glove each second</source>
      <translation>Pakete des Handschuhs pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Latency</source>
      <translation>Latenz</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Lost</source>
      <translation>Verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Stopped</source>
      <translation>Gestoppt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Nothing arrives</source>
      <translation>Es kommt nichts an</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>No glove sends</source>
      <translation>Kein Handschuh sendet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{}, heading within {:.0f}°</source>
      <translation>{}, Richtung auf {:.0f}° genau</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Stereo images each second</source>
      <translation>Stereobilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Its battery is low ({} V): charge it soon</source>
      <translation>Sein Akku ist schwach ({} V): bald laden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Of each stage, median (99th percentile):</source>
      <translation>Je Stufe, Median (99. Perzentil):</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{} packets, {} images</source>
      <translation>{} Pak., {} Bild.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Replay: {}</source>
      <translation>Wiedergabe: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{}, battery low</source>
      <translation>{}, Akku schwach</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Taken.</source>
      <translation>Aufgenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Hold the board still.</source>
      <translation>Die Tafel stillhalten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There is a view like this already: move on.</source>
      <translation>So eine Ansicht gibt es schon: weiterbewegen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There are enough views.</source>
      <translation>Es gibt genug Ansichten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>That is enough: press Calibrate.</source>
      <translation>Das genügt: auf Kalibrieren drücken.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Error of all corners</source>
      <translation>Fehler aller Ecken</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Views</source>
      <translation>Ansichten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Image area</source>
      <translation>Bildfläche</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Tilted views</source>
      <translation>Geneigte Ansichten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Distance range</source>
      <translation>Abstandsbereich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{}: {} corners, tilted {:.0f}°</source>
      <translation>{}: {} Ecken, geneigt {:.0f}°</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{}, off by {:.2f} px</source>
      <translation>{}, daneben um {:.2f} px</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{} used, {} dropped</source>
      <translation>{} verwendet, {} verworfen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Distance of the lenses</source>
      <translation>Objektivabstand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Turned against each other</source>
      <translation>Gegeneinander verdreht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Focal length, left</source>
      <translation>Brennweite, links</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Focal length, right</source>
      <translation>Brennweite, rechts</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Image</source>
      <translation>Bild</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Worst corner</source>
      <translation>Schlechteste Ecke</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>All rows shifted by</source>
      <translation>Alle Zeilen verschoben um</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>used</source>
      <translation>verwendet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>dropped: it does not fit the others</source>
      <translation>verworfen: passt nicht zu den anderen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Focal length</source>
      <translation>Brennweite</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{:.0f} of {:.0f} %</source>
      <translation>{:.0f} von {:.0f} %</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{:.2f} ({:.2f} required)</source>
      <translation>{:.2f} ({:.2f} erforderlich)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{} by {} px</source>
      <translation>{} × {} px</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>nobody listens</source>
      <translation>niemand hört zu</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>waits for tracking</source>
      <translation>wartet auf Tracking</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>failing</source>
      <translation>gestört</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>sending</source>
      <translation>sendet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>clients that have left</source>
      <translation>getrennte Empfänger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>{} discarded: this computer is overloaded</source>
      <translation>{} verworfen: dieser Rechner ist überlastet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>{} could not be sent</source>
      <translation>{} konnten nicht gesendet werden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>{} missed by {}</source>
      <translation>{} verpasst von {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/take_names.py" />
      <source>The name {!r} is not complete; it can hold text and {}.</source>
      <translation>Der Name {!r} ist nicht vollständig; er kann Text enthalten und {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/take_names.py" />
      <source>A name can hold {}, not {}.</source>
      <translation>Ein Name kann {} enthalten, nicht {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} was cut off after {}. What it contains can be recovered.</source>
      <translation>Die Aufnahme {} ist nach {} abgebrochen. Was sie enthält, lässt sich retten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>left hand: {}</source>
      <translation>linke Hand: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>right hand: {}</source>
      <translation>rechte Hand: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no packets lost</source>
      <translation>keine Pakete verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>1 packet lost</source>
      <translation>1 Paket verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{:.0f} of {:.0f} images per second from the camera</source>
      <translation>{:.0f} von {:.0f} Bildern pro Sekunde von der Kamera</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} is whole: {}.</source>
      <translation>{} ist vollständig: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>This recording is incomplete: {}.</source>
      <translation>Diese Aufnahme ist unvollständig: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no images from the camera</source>
      <translation>keine Bilder von der Kamera</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no data from the glove</source>
      <translation>keine Daten vom Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} is not whole: {}</source>
      <translation>{} ist nicht vollständig: {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} packets lost</source>
      <translation>{} Pakete verloren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no data from the IMUs {}</source>
      <translation>keine Daten von den IMUs {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no image for {:.1f} s</source>
      <translation>{:.1f} s lang kein Bild</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>nothing from the glove for {:.1f} s</source>
      <translation>{:.1f} s lang nichts vom Handschuh</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>no data from the IMU {}</source>
      <translation>keine Daten von der IMU {}</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} needs a name with a letter or a digit in it.</source>
      <translation>{} braucht einen Namen mit einem Buchstaben oder einer Ziffer.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} is there already, so {} keeps its name.</source>
      <translation>{} gibt es schon, deshalb behält {} seinen Namen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>tracked {:.0f} % of the time</source>
      <translation>{:.0f} % der Zeit verfolgt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} cannot be named {}: {}.</source>
      <translation>{} kann nicht in {} umbenannt werden: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/two_recordings.py" />
      <source>The takes have no tracked instant in common here.</source>
      <translation>Die Aufnahmen haben hier keinen verfolgten Zeitpunkt gemeinsam.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/two_recordings.py" />
      <source>differ by {:.1f}° (rms), {:.1f}° at most, over {:.1f} s</source>
      <translation>Unterschied {:.1f}° (RMS), höchstens {:.1f}°, über {:.1f} s</translation>
    </message>
    <message>
      <location filename="app/viewmodels/wearer_profiles.py" />
      <source>There is nothing to compare with yet: save a profile, or reset.</source>
      <translation>Noch gibt es nichts zum Vergleichen: Profil speichern oder zurücksetzen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/wearer_profiles.py" />
      <source>Frozen: nothing is learned until you unfreeze it.</source>
      <translation>Eingefroren: Bis zum Auftauen wird nichts gelernt.</translation>
    </message>
    <message>
      <location filename="app/widgets/banner.py" />
      <source>Dismiss</source>
      <translation>Schließen</translation>
    </message>
    <message>
      <location filename="app/widgets/command_palette.py" />
      <source>Type a command</source>
      <translation>Befehl eingeben</translation>
    </message>
    <message>
      <location filename="app/widgets/coverage_map.py" />
      <source>{} empty cells</source>
      <translation>Leere Felder: {}</translation>
    </message>
    <message>
      <location filename="app/widgets/hold_ring.py" />
      <source>held to {} %</source>
      <translation>zu {} % gehalten</translation>
    </message>
    <message>
      <location filename="app/widgets/hue_range.py" />
      <source>Drag a handle, or the bar. Keys: ↓ ↑ choose a handle, ← → move it.</source>
      <translation>Einen Griff oder den Balken ziehen. Tasten: ↓ ↑ wählen einen Griff, ← → bewegen ihn.</translation>
    </message>
    <message>
      <location filename="app/widgets/hue_strip.py" />
      <source>Histogram of hues</source>
      <translation>Histogramm der Farbtöne</translation>
    </message>
    <message>
      <location filename="app/widgets/image_view.py" />
      <source>Wheel or + −: zoom. Drag or arrows: move. Double click or 0: all.</source>
      <translation>Rad oder + −: Zoom. Ziehen oder Pfeile: verschieben. Doppelklick oder 0: alles.</translation>
    </message>
    <message>
      <location filename="app/widgets/range_row.py" />
      <source>{}, first</source>
      <translation>{}, Anfang</translation>
    </message>
    <message>
      <location filename="app/widgets/range_row.py" />
      <source>{}, last</source>
      <translation>{}, Ende</translation>
    </message>
    <message>
      <location filename="app/widgets/view3d/view_3d.py" />
      <source>The hand in 3D</source>
      <translation>Die Hand in 3D</translation>
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>About Glovetrack</source>
      <translation>Über Glovetrack</translation>
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Parts and their licences</source>
      <translation>Bestandteile und ihre Lizenzen</translation>
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Apache-2.0</source>
      <translation>Apache-2.0</translation>
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Hand tracking with a sensor glove and a stereo camera. Free software under the Apache Licence 2.0, without any warranty.</source>
      <translation>Hand-Tracking mit einem Sensorhandschuh und einer Stereokamera. Freie Software unter der Apache-Lizenz 2.0, ohne jede Gewähr.</translation>
    </message>
    <message>
      <location filename="app/window/about.py" />
      <source>Glovetrack {}</source>
      <translation>Glovetrack {}</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Glovetrack ended unexpectedly the last time.</source>
      <translation>Glovetrack wurde letztes Mal unerwartet beendet.</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Save a bug report…</source>
      <translation>Fehlerbericht speichern…</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Saving the bug report</source>
      <translation>Fehlerbericht wird gespeichert</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>The bug report is saved: {}.</source>
      <translation>Der Fehlerbericht ist gespeichert: {}.</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source> Not in it: {}.</source>
      <translation> Nicht darin: {}.</translation>
    </message>
    <message>
      <location filename="app/window/colours_told.py" />
      <source>The colours find many patches, none fit the glove: fit the colours.</source>
      <translation>Die Farben finden viele Flecken, keine passen zum Handschuh: Farben anpassen.</translation>
    </message>
    <message>
      <location filename="app/window/colours_told.py" />
      <source>Fit them now</source>
      <translation>Jetzt anpassen</translation>
    </message>
    <message>
      <location filename="app/window/colours_told.py" />
      <source>Show the colours</source>
      <translation>Farben zeigen</translation>
    </message>
    <message>
      <location filename="app/window/contributions.py" />
      <source>The panel {} cannot be shown: {}. Install it with pip install '{}'.</source>
      <translation>Das Feld {} kann nicht gezeigt werden: {}. Installieren mit pip install '{}'.</translation>
    </message>
    <message>
      <location filename="app/window/contributions.py" />
      <source>The panel {} cannot be shown: {}.</source>
      <translation>Das Feld {} kann nicht gezeigt werden: {}.</translation>
    </message>
    <message>
      <location filename="app/window/contributions.py" />
      <source>{} failed: {}.</source>
      <translation>{} ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
      <location filename="app/window/countdown.py" />
      <source>Esc: not now</source>
      <translation>Esc: nicht jetzt</translation>
    </message>
    <message>
      <location filename="app/window/docks.py" />
      <source>&amp;View</source>
      <translation>&amp;Ansicht</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Guide</source>
      <translation>Anleitung</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Search the guide</source>
      <translation>Anleitung durchsuchen</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Keys</source>
      <translation>Tasten</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Key</source>
      <translation>Taste</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Does</source>
      <translation>Bewirkt</translation>
    </message>
    <message>
      <location filename="app/window/help.py" />
      <source>Menu</source>
      <translation>Menü</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Layout</source>
      <translation>&amp;Layout</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Keep this layout</source>
      <translation>Dieses Layout behalten</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Kept layouts</source>
      <translation>Behaltene Layouts</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Rename a layout</source>
      <translation>Layout umbenennen</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Keep this layout…</source>
      <translation>Dieses Layout &amp;behalten…</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Rename a layout…</source>
      <translation>Layout &amp;umbenennen…</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Delete a layout…</source>
      <translation>Layout &amp;löschen…</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>The layout {} was deleted.</source>
      <translation>Die Anordnung {} wurde gelöscht.</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Set up</source>
      <translation>Einrichten</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Watch</source>
      <translation>Beobachten</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Capture</source>
      <translation>Aufnehmen</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Review</source>
      <translation>Auswerten</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>All panels</source>
      <translation>Alle Felder</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>The language changes after a restart.</source>
      <translation>Die Sprache wechselt nach einem Neustart.</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Recording begins in {} s</source>
      <translation>Aufnahme beginnt in {} s</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Pose reset in {} s</source>
      <translation>Haltung wird in {} s zurückgesetzt</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Hold the hand flat, fingers ahead</source>
      <translation>Hand flach halten, Finger nach vorn</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>It is kept while this session runs.</source>
      <translation>Es bleibt, solange diese Sitzung läuft.</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>{} – Glovetrack</source>
      <translation>{} – Glovetrack</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Replay of {} – Glovetrack</source>
      <translation>Wiedergabe von {} – Glovetrack</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Save it for the next time…</source>
      <translation>Für nächstes Mal speichern…</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>Looking for earlier sessions</source>
      <translation>Frühere Sitzungen werden gesucht</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>The recording {} was cut off. What it holds is whole in {}.</source>
      <translation>Die Aufnahme {} ist abgebrochen. Was sie enthält, ist heil in {}.</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>Show it</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>Checking {}</source>
      <translation>{} wird geprüft</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>What could be read of the recording is in {}.</source>
      <translation>Was von der Aufnahme zu lesen war, steht in {}.</translation>
    </message>
    <message>
      <location filename="app/window/recent.py" />
      <source>{} Your recording {} is complete.</source>
      <translation>{} Ihre Aufnahme {} ist vollständig.</translation>
    </message>
    <message>
      <location filename="app/window/refresher.py" />
      <source>The panel {} failed and rests ({}: {}); the rest goes on.</source>
      <translation>Das Feld {} ist ausgefallen und ruht ({}: {}); der Rest läuft weiter.</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Looking for cameras</source>
      <translation>Kameras werden gesucht</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Only the engine chain learns from poses: choose it in the Tracking menu.</source>
      <translation>Nur das Verfahren chain lernt aus Posen: im Menü Tracking wählen.</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Looking for glove and camera</source>
      <translation>Handschuh und Kamera werden gesucht</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>The search for glove and camera</source>
      <translation>Die Suche nach Handschuh und Kamera</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Open a session</source>
      <translation>Sitzung öffnen</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Show the set-up</source>
      <translation>Einrichtung zeigen</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>The demo</source>
      <translation>Die Demo</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Starting the demo</source>
      <translation>Demo wird gestartet</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Plugged in now: {}.</source>
      <translation>Jetzt eingesteckt: {}.</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Use it</source>
      <translation>Verwenden</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>End it and open</source>
      <translation>Beenden und öffnen</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>{} waits: a recording is under way.</source>
      <translation>{} wartet: Eine Aufnahme läuft.</translation>
    </message>
    <message>
      <location filename="app/window/status_bar.py" />
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="app/window/status_bar.py" />
      <source>The window is refreshed {} times a second</source>
      <translation>Das Fenster wird {}-mal pro Sekunde aufgefrischt</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Name of the recording</source>
      <translation>Name der Aufnahme</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>What happened?</source>
      <translation>Was ist geschehen?</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>{} is in the bin.</source>
      <translation>{} ist im Papierkorb.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>{} recordings are in the bin.</source>
      <translation>{} Aufnahmen sind im Papierkorb.</translation>
    </message>
    <message>
      <location filename="app/window/ticker.py" />
      <source>Paused</source>
      <translation>Pause</translation>
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Commands</source>
      <translation>Befehle</translation>
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Open</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Find</source>
      <translation>Suchen</translation>
    </message>
    <message>
      <location filename="app/window/tool_bar.py" />
      <source>Stop recording</source>
      <translation>Aufnahme stoppen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;File</source>
      <translation>&amp;Datei</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Set-up</source>
      <translation>&amp;Einrichtung</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Tracking</source>
      <translation>&amp;Tracking</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Replay</source>
      <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Images</source>
      <translation>&amp;Bilder</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Help</source>
      <translation>&amp;Hilfe</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: chosen b&amp;y itself</source>
      <translation>3D-Ansich&amp;t: von selbst gewählt</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: by the &amp;graphics card</source>
      <translation>3D-Ansicht: mit der &amp;Grafikkarte</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: &amp;painted</source>
      <translation>3D-Ansicht: g&amp;ezeichnet</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Light</source>
      <translation>&amp;Hell</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Dark</source>
      <translation>&amp;Dunkel</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>As the &amp;system</source>
      <translation>&amp;Wie das System</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Show the left &amp;hand</source>
      <translation>Die &amp;linke Hand zeigen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Show the r&amp;ight hand</source>
      <translation>&amp;Rechte Hand zeigen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Documentation in the browser</source>
      <translation>&amp;Dokumentation im Browser</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Stop &amp;recording</source>
      <translation>Aufnahme s&amp;toppen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Record</source>
      <translation>&amp;Aufnehmen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Language: as the system</source>
      <translation>Sprache: wie das System</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Start the &amp;demo</source>
      <translation>&amp;Demo starten</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Glove and camera</source>
      <translation>&amp;Handschuh und Kamera</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Open a session…</source>
      <translation>Sitzung &amp;öffnen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Export…</source>
      <translation>&amp;Exportieren…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Close the session</source>
      <translation>Sitzung s&amp;chließen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Quit</source>
      <translation>&amp;Beenden</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Glove…</source>
      <translation>&amp;Handschuh…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Glove &amp;firmware…</source>
      <translation>&amp;Firmware des Handschuhs…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Both hands</source>
      <translation>Beide Hän&amp;de</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Camera…</source>
      <translation>&amp;Kamera…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Camera c&amp;alibration…</source>
      <translation>K&amp;amera kalibrieren…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Guided &amp;poses…</source>
      <translation>Geführte &amp;Posen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Save the &amp;wearer…</source>
      <translation>Person spe&amp;ichern…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Lock the exposure as it is</source>
      <translation>&amp;Belichtung sperren, wie sie ist</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Start tracking</source>
      <translation>Tracking &amp;starten</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>S&amp;top tracking</source>
      <translation>Tracking st&amp;oppen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Pause the recording</source>
      <translation>Aufnahme &amp;pausieren</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Add a &amp;note…</source>
      <translation>&amp;Notiz hinzufügen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>R&amp;eset the pose</source>
      <translation>Haltung &amp;zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Pose reset sett&amp;ings…</source>
      <translation>&amp;Haltung zurücksetzen: Einstellungen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Back to the li&amp;ve hand</source>
      <translation>Zu&amp;rück zur laufenden Hand</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Play or pause</source>
      <translation>Ab&amp;spielen oder Pause</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The image &amp;before</source>
      <translation>Das Bild &amp;davor</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The &amp;next image</source>
      <translation>Das &amp;nächste Bild</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The note &amp;earlier</source>
      <translation>Die Notiz da&amp;vor</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>The note la&amp;ter</source>
      <translation>Die Notiz dana&amp;ch</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;In point here</source>
      <translation>Hier &amp;Anfang setzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Out point here</source>
      <translation>Hier &amp;Ende setzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Whole session</source>
      <translation>&amp;Ganze Sitzung</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Crop to a new session</source>
      <translation>In neue Sitzung &amp;zuschneiden</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Loop on or off</source>
      <translation>Sch&amp;leife ein oder aus</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Track &amp;again…</source>
      <translation>&amp;Tracking wiederholen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Co&amp;mpare two sessions</source>
      <translation>Z&amp;wei Aufnahmen vergleichen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Two takes side by si&amp;de</source>
      <translation>Zwei Aufnahmen ne&amp;beneinander</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Freeze the images</source>
      <translation>Bilder &amp;einfrieren</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Whole image</source>
      <translation>&amp;Ganzes Bild</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;back</source>
      <translation>Hand vom &amp;Rücken</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;palm</source>
      <translation>Hand von &amp;innen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;side</source>
      <translation>Hand von der &amp;Seite</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Hand from the &amp;camera</source>
      <translation>Hand von der &amp;Kamera</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Undo the colour change</source>
      <translation>Farbänderung rückgängig &amp;machen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Redo the colour change</source>
      <translation>Farbänderung &amp;wiederholen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Command palette…</source>
      <translation>&amp;Befehle suchen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Latency of &amp;each stage</source>
      <translation>Latenz &amp;jeder Stufe</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Reset the layout</source>
      <translation>Layout &amp;zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Full screen</source>
      <translation>&amp;Vollbild</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Guide</source>
      <translation>&amp;Anleitung</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Keys</source>
      <translation>&amp;Tasten</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Save a &amp;bug report…</source>
      <translation>&amp;Fehlerbericht speichern…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;About Glovetrack</source>
      <translation>&amp;Über Glovetrack</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Engine: {}</source>
      <translation>Verfahren: {}</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>E&amp;xtensions</source>
      <translation>Er&amp;weiterungen</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>A video with both images side by side</source>
      <translation>Ein Video mit beiden Bildern nebeneinander</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>this camera has none</source>
      <translation>hat diese Kamera nicht</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>▲ the camera does not take it</source>
      <translation>▲ die Kamera nimmt es nicht an</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Camera set-up</source>
      <translation>Kamera einrichten</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Exchange left and right</source>
      <translation>&amp;Links und rechts tauschen</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Where a stereo calibration finds the cameras exchanged</source>
      <translation>Falls eine Stereokalibrierung die Kameras vertauscht findet</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Use this camera</source>
      <translation>Kamera &amp;verwenden</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>0 (the first camera), a video file or an address</source>
      <translation>0 (die erste Kamera), eine Videodatei oder eine Adresse</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Browse…</source>
      <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Right images from</source>
      <translation>&amp;Rechte Bilder von</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>nothing, or another number or address for the right images</source>
      <translation>nichts, oder eine andere Nummer oder Adresse für die rechten Bilder</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;And from</source>
      <translation>&amp;Und von</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>The first one found</source>
      <translation>Die erste gefundene</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>the same image, if it is wide enough for two</source>
      <translation>dasselbe Bild, falls es breit genug für zwei ist</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>none: this is one camera</source>
      <translation>keine: dies ist eine einzelne Kamera</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>the same image, side by side</source>
      <translation>dasselbe Bild, nebeneinander</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Arriving: {} by {} px of one camera, {} images a second</source>
      <translation>Es kommen an: {} mal {} px einer Kamera, {} Bilder in der Sekunde</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Arriving: {} by {} px for each eye, {} images a second</source>
      <translation>Es kommt an: {} × {} px je Auge, {} Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Locks</source>
      <translation>Sperren</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>A camera that exposes by itself changes the colours with every move.</source>
      <translation>Eine Kamera, die selbst belichtet, ändert die Farben mit jeder Bewegung.</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>○ by itself, now {}</source>
      <translation>○ von selbst, jetzt {}</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Camera</source>
      <translation>&amp;Kamera</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;Or number, file</source>
      <translation>&amp;Oder Nummer, Datei</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>The simulated camera's exposure is fixed.</source>
      <translation>Die Belichtung der simulierten Kamera ist fest.</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Start glove and camera: what the camera can do is shown then.</source>
      <translation>Handschuh und Kamera starten: Dann steht hier, was die Kamera kann.</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>◐ cannot be verified: the camera reads {}</source>
      <translation>◐ nicht überprüfbar: die Kamera meldet {}</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>● locked at {}</source>
      <translation>● gesperrt bei {}</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>{} (simulated camera)</source>
      <translation>{} (simulierte Kamera)</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>{} (not connected)</source>
      <translation>{} (nicht verbunden)</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Glove firmware</source>
      <translation>Firmware des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Tells this glove from others: give each its own</source>
      <translation>Unterscheidet diesen Handschuh von anderen: jedem eine eigene geben</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>115200 for USB adapters that know no better</source>
      <translation>115200 für USB-Adapter, die nicht mehr können</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Arduino, Optiboot</source>
      <translation>Arduino, Optiboot</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>early Nano, old bootloader</source>
      <translation>früher Nano, alter Bootloader</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>&amp;Write and verify</source>
      <translation>&amp;Schreiben und prüfen</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>&amp;Number of the glove</source>
      <translation>&amp;Nummer des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>&amp;Speed</source>
      <translation>&amp;Geschwindigkeit</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>&amp;Board</source>
      <translation>&amp;Tafel</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Looking for gloves…</source>
      <translation>Handschuhe werden gesucht…</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Looking for gloves</source>
      <translation>Handschuhe werden gesucht</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Writing. Leave the cable plugged in, for about ten seconds.</source>
      <translation>Es wird geschrieben. Das Kabel etwa zehn Sekunden eingesteckt lassen.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Writing the glove's firmware</source>
      <translation>Die Firmware des Handschuhs wird geschrieben</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Written and read back. It does not answer yet: plug it in again.</source>
      <translation>Geschrieben und zurückgelesen. Er antwortet noch nicht: neu einstecken.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>The glove is in use. Writing stops tracking first.</source>
      <translation>Der Handschuh ist in Gebrauch. Das Schreiben beendet erst das Tracking.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>No serial port is there. Plug it in.</source>
      <translation>Kein serieller Anschluss ist da. Den Handschuh einstecken.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>With this program comes firmware {}.</source>
      <translation>Mit diesem Programm kommt Firmware {}.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>It needs no newer one.</source>
      <translation>Er braucht keine neuere.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Written and read back; glove {} answers with firmware {}.</source>
      <translation>Geschrieben und zurückgelesen; Handschuh {} antwortet mit Firmware {}.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>{} baud</source>
      <translation>{} Baud</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>The glove at this port is number {}, its firmware {}.</source>
      <translation>Der Handschuh an diesem Anschluss hat Nummer {}, seine Firmware ist {}.</translation>
    </message>
    <message>
      <location filename="app/wizards/form_dialog.py" />
      <source>&amp;Search again</source>
      <translation>&amp;Erneut suchen</translation>
    </message>
    <message>
      <location filename="app/wizards/form_dialog.py" />
      <source>Close</source>
      <translation>Schließen</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: glove {}, {} IMUs, {} baud</source>
      <translation>{}: Handschuh {}, {} IMUs, {} Baud</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>A port that is not on USB, such as /dev/rfcomm0 or COM7:</source>
      <translation>Ein Anschluss, der nicht an USB ist, etwa /dev/rfcomm0 oder COM7:</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Other port…</source>
      <translation>Anderer &amp;Anschluss…</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Whichever it answers at</source>
      <translation>Die, bei der er antwortet</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Port</source>
      <translation>Ans&amp;chluss</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>S&amp;peed</source>
      <translation>&amp;Baudrate</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Side</source>
      <translation>&amp;Seite</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Glove file</source>
      <translation>&amp;Handschuhdatei</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Hand file</source>
      <translation>Hand&amp;datei</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>&amp;Wearer</source>
      <translation>&amp;Person</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Simulated glove</source>
      <translation>Simulierter Handschuh</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Other port</source>
      <translation>Anderer Anschluss</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Simulated glove (plays along)</source>
      <translation>Simulierter Handschuh (spielt mit)</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>No glove was found on any USB port. Plug the glove in, then choose Search again. Without one, the simulated glove lets you try these pages.</source>
      <translation>An keinem USB-Anschluss wurde ein Handschuh gefunden. Schließen Sie ihn an und wählen Sie Erneut suchen. Ohne Handschuh können Sie diese Seiten mit dem simulierten ausprobieren.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>No other glove was found on any USB port.</source>
      <translation>An keinem USB-Anschluss wurde ein weiterer Handschuh gefunden.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Glove in use</source>
      <translation>Handschuh in Gebrauch</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Glove at {}</source>
      <translation>Handschuh an {}</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>The glove in use</source>
      <translation>Der Handschuh in Gebrauch</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: a glove that is sending</source>
      <translation>{}: ein Handschuh, der sendet</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>{}: glove {}, {} IMUs</source>
      <translation>{}: Handschuh {}, {} IMUs</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Glove {} at {}</source>
      <translation>Handschuh {} an {}</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/choice.py" />
      <source>Glove {} in use</source>
      <translation>Handschuh {} in Gebrauch</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/feed.py" />
      <source>The session was closed.</source>
      <translation>Die Sitzung wurde geschlossen.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Lay the hand flat on the table, palm down.</source>
      <translation>Die Hand flach auf den Tisch legen, Innenseite nach unten.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>&amp;Measure</source>
      <translation>&amp;Messen</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>&amp;Start the test</source>
      <translation>Test &amp;starten</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Press Start, then move each part as asked.</source>
      <translation>Drücken Sie Start und bewegen Sie dann jeden Teil wie angegeben.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>nothing</source>
      <translation>nichts</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>IMU</source>
      <translation>IMU</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Gyro bias x y z, °/s</source>
      <translation>Gyro-Bias x y z, °/s</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>± °/s</source>
      <translation>± °/s</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Noise, m°/s/√Hz</source>
      <translation>Rauschen, m°/s/√Hz</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Gravity, m/s²</source>
      <translation>Schwere, m/s²</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>What was found</source>
      <translation>Befund</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>No samples come.</source>
      <translation>Es kommen keine Messwerte.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Moves now: {}</source>
      <translation>Bewegt sich jetzt: {}</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>Glove set-up</source>
      <translation>Handschuh einrichten</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;1 Glove</source>
      <translation>&amp;1 Handschuh</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;2 At rest</source>
      <translation>&amp;2 In Ruhe</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;3 Wiggle test</source>
      <translation>&amp;3 Wackeltest</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;Use this glove</source>
      <translation>Handschuh &amp;verwenden</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>Freeing the glove's port</source>
      <translation>Anschluss des Handschuhs wird freigegeben</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>&amp;Use these files</source>
      <translation>Diese Dateien &amp;verwenden</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>{}: {} packets per second.</source>
      <translation>{}: {} Pakete pro Sekunde.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>{}: waiting for packets…</source>
      <translation>{}: wartet auf Pakete…</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/wizard.py" />
      <source>{}: packets arrive.</source>
      <translation>{}: Pakete kommen an.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Guided calibration, right hand</source>
      <translation>Geführte Kalibrierung, rechte Hand</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Guided calibration</source>
      <translation>Geführte Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Guided calibration, left hand</source>
      <translation>Geführte Kalibrierung, linke Hand</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>The calibration is frozen: unfreeze it, then hold the poses.</source>
      <translation>Die Kalibrierung ist eingefroren: erst freigeben, dann die Posen halten.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>No pose was held.</source>
      <translation>Keine Pose wurde gehalten.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>A beep when a pose has been held</source>
      <translation>Ein Ton, wenn eine Pose gehalten wurde</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>I &amp;hold it (Enter)</source>
      <translation>&amp;Halte ich (Eingabe)</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>Where the pose is held and the ring does not believe it</source>
      <translation>Falls die Pose gehalten wird und der Ring es nicht glaubt</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>Skip (S)</source>
      <translation>Auslassen (S)</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>Repeat (R)</source>
      <translation>Noch einmal (R)</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>Hold eight poses, each for two seconds</source>
      <translation>Acht Posen halten, jede zwei Sekunden</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/lead.py" />
      <source>They show the tracking how your fingers and your thumb bend. It takes half a minute. Do with the glove what the hand on the left does.</source>
      <translation>Sie zeigen dem Tracking, wie sich Finger und Daumen beugen. Es dauert eine halbe Minute. Mit dem Handschuh tun, was die Hand links tut.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Your fingers bend as expected.</source>
      <translation>Ihre Finger beugen sich wie erwartet.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Measured</source>
      <translation>Gemessen</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Before</source>
      <translation>Vorher</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>After</source>
      <translation>Nachher</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Change</source>
      <translation>Änderung</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>What was learned</source>
      <translation>Was gelernt wurde</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>&amp;Keep</source>
      <translation>&amp;Behalten</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>&amp;Undo</source>
      <translation>&amp;Rückgängig</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Forget what these poses have taught</source>
      <translation>Vergessen, was diese Posen gelehrt haben</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Evaluating the poses…</source>
      <translation>Haltungen werden ausgewertet…</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>Nothing was learned</source>
      <translation>Nichts wurde gelernt</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/result.py" />
      <source>{} of {} poses held</source>
      <translation>{} von {} Posen gehalten</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/outcome.py" />
      <source>&amp;Once more</source>
      <translation>&amp;Noch einmal</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/page.py" />
      <source>Soun&amp;d</source>
      <translation>&amp;Ton</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/page.py" />
      <source>&amp;Start</source>
      <translation>&amp;Start</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/page.py" />
      <source>End (Esc)</source>
      <translation>Ende (Esc)</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/stage.py" />
      <source>The pose to be held</source>
      <translation>Die zu haltende Pose</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>Pose reset</source>
      <translation>Haltung zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>&amp;Beep when it is done</source>
      <translation>&amp;Signalton danach</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>&amp;Double tap on the back of the glove</source>
      <translation>&amp;Doppeltes Tippen auf den Handrücken</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>Two quick taps, with the hand at rest before and after</source>
      <translation>Zwei schnelle Tipper, die Hand davor und danach in Ruhe</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>Hold the hand flat and level, fingers straight ahead. The reset aligns the finger joints with that pose, and without a camera the heading, too.</source>
      <translation>Halten Sie die Hand flach und waagerecht, die Finger gerade nach vorn. Das Zurücksetzen richtet die Fingergelenke nach dieser Haltung aus, ohne Kamera auch die Richtung.</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>&amp;Save</source>
      <translation>&amp;Speichern</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>{} is the key of “{}”. Choose another one.</source>
      <translation>{} ist die Taste von „{}“. Wählen Sie eine andere.</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>&amp;Key</source>
      <translation>&amp;Taste</translation>
    </message>
    <message>
      <location filename="app/wizards/pose_reset.py" />
      <source>&amp;Countdown</source>
      <translation>&amp;Countdown</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>ChArUco (may be partly hidden)</source>
      <translation>ChArUco (darf teilweise verdeckt sein)</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Chessboard (always whole)</source>
      <translation>Schachbrett (immer ganz)</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>From the camera's data sheet; a ZED Mini has 63 mm</source>
      <translation>Aus dem Datenblatt der Kamera; eine ZED Mini hat 63 mm</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Squares a&amp;cross</source>
      <translation>Felder &amp;quer</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Squares &amp;down</source>
      <translation>Felder &amp;hoch</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Side of a &amp;square, measured</source>
      <translation>Feld&amp;seite, gemessen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Lenses &amp;apart, if known</source>
      <translation>&amp;Objektivabstand, falls bekannt</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>&amp;Images from</source>
      <translation>&amp;Bilder von</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Save the board for printing…</source>
      <translation>Tafel zum Drucken speichern…</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>A calibration is there already</source>
      <translation>Es gibt schon eine Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>It is checked as strictly as one made here, and can be tried on the board.</source>
      <translation>Sie wird so streng geprüft wie eine hier gemachte und lässt sich an der Tafel erproben.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>ZED factory file…</source>
      <translation>ZED-Werksdatei…</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>OpenCV file…</source>
      <translation>OpenCV-Datei…</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>The page is {} by {} mm: print it without scaling.</source>
      <translation>Die Seite misst {} × {} mm: ohne Skalierung drucken.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Save the board</source>
      <translation>Tafel speichern</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>Board</source>
      <translation>Tafel</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>{} cannot be written.</source>
      <translation>{} lässt sich nicht schreiben.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Simulated board (demo)</source>
      <translation>Simulierte Tafel (Demo)</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>camera in use</source>
      <translation>Kamera in Gebrauch</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>The camera in use was closed: start glove and camera again.</source>
      <translation>Die Kamera in Gebrauch wurde geschlossen: Handschuh und Kamera neu starten.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Camera in use</source>
      <translation>Kamera in Gebrauch</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Folder {}</source>
      <translation>Ordner {}</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/image_choices.py" />
      <source>Chosen camera: {}</source>
      <translation>Gewählte Kamera: {}</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>ZED factory file</source>
      <translation>ZED-Werksdatei</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>OpenCV calibration</source>
      <translation>OpenCV-Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Folder with left and right images</source>
      <translation>Ordner mit linken und rechten Bildern</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>squares of the board</source>
      <translation>Felder der Tafel</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Image's &amp;width, px</source>
      <translation>Bild&amp;breite, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Image's &amp;height, px</source>
      <translation>Bild&amp;höhe, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>&amp;Unit of T in the file</source>
      <translation>&amp;Einheit von T in der Datei</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Side of a &amp;square</source>
      <translation>&amp;Seite eines Feldes</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/import_form.py" />
      <source>Import {}</source>
      <translation>{} importieren</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrated: now check it on fresh views</source>
      <translation>Kalibriert: jetzt an neuen Ansichten prüfen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Error, px</source>
      <translation>Fehler, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Left, px</source>
      <translation>Links, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Right, px</source>
      <translation>Rechts, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrating</source>
      <translation>Kalibrierung läuft</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>No calibration</source>
      <translation>Keine Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrating: {}</source>
      <translation>Kalibrierung läuft: {}</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/solving.py" />
      <source>Camera calibration</source>
      <translation>Kamerakalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Waiting for the camera</source>
      <translation>Warten auf die Kamera</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Views taken</source>
      <translation>Aufgenommene Ansichten</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Remove the view</source>
      <translation>Ansicht entfernen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Corners are off by</source>
      <translation>Abweichung der Ecken</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Rows differ by</source>
      <translation>Zeilenversatz</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Left image</source>
      <translation>Linkes Bild</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Right image</source>
      <translation>Rechtes Bild</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Show the board once more.</source>
      <translation>Die Tafel noch einmal zeigen.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>The image has another size.</source>
      <translation>Das Bild hat eine andere Größe.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Closing the camera</source>
      <translation>Kamera wird geschlossen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Steps</source>
      <translation>Schritte</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Images from a folder…</source>
      <translation>Bilder aus einem Ordner…</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Result</source>
      <translation>Ergebnis</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Check</source>
      <translation>Prüfen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>&amp;Back</source>
      <translation>&amp;Zurück</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Save and use</source>
      <translation>Speichern und nutzen</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Checked on every third image of the folder.</source>
      <translation>An jedem dritten Bild des Ordners geprüft.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>checked: {:.3f} px</source>
      <translation>geprüft: {:.3f} px</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Application</source>
      <translation>Anwendung</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Restart</source>
      <translation>Neu beginnen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Show all</source>
      <translation>Alles zeigen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Move the eye until all that is drawn is in sight</source>
      <translation>Den Blick bewegen, bis alles Gezeichnete zu sehen ist</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Page</source>
      <translation>Seite</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>Show it in browsers of this machine, a headset's too</source>
      <translation>In Browsern dieses Rechners zeigen, auch in dem einer Brille</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/controls.py" />
      <source>No application</source>
      <translation>Keine Anwendung</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/extension.py" />
      <source>Applications</source>
      <translation>Anwendungen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Applications run on a tracked hand: open the demo, devices or a session.</source>
      <translation>Anwendungen laufen mit einer verfolgten Hand: Demo, Geräte oder eine Sitzung öffnen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Nothing has happened yet.</source>
      <translation>Noch ist nichts geschehen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>For browsers of this machine, a headset's too: {}</source>
      <translation>Für Browser dieses Rechners, auch den einer Brille: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>It failed and rests: {}</source>
      <translation>Sie ist ausgefallen und ruht: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>The page needs a package that is not installed: pip install "{}"</source>
      <translation>Die Seite braucht ein Paket, das nicht installiert ist: pip install "{}"</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/extension.py" />
      <source>C&amp;onformance…</source>
      <translation>K&amp;onformität…</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/dialog.py" />
      <source>Conformance</source>
      <translation>Konformität</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/dialog.py" />
      <source>End the recording that is under way first.</source>
      <translation>Erst die laufende Aufnahme beenden.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/dialog.py" />
      <source>Judging {}</source>
      <translation>{} wird beurteilt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/lead.py" />
      <source>A beep at each beat before a step</source>
      <translation>Ein Ton bei jedem Takt vor einem Schritt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/lead.py" />
      <source>Ten gestures, judged by the rules of robot labs</source>
      <translation>Zehn Gesten, nach den Regeln von Roboterlabors beurteilt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/lead.py" />
      <source>The simulated wearers of this demo do not follow these gestures, so rules on gestures will not be met. The demo of one hand follows them.</source>
      <translation>Die simulierten Personen dieser Demo zeigen diese Gesten nicht, daher werden die Regeln zu Gesten nicht erfüllt. Die Demo mit einer Hand zeigt sie.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/lead.py" />
      <source>Open the hand and close it a few times first, so that its size is known. Then do what the hand on the left does: three beats to come to each gesture, and hold it until the ring is full. It takes {} seconds and is recorded.</source>
      <translation>Die Hand erst einige Male öffnen und schließen, damit ihre Größe bekannt ist. Dann tun, was die Hand links tut: drei Takte, um zu jeder Geste zu kommen, und sie halten, bis der Ring voll ist. Es dauert {} Sekunden und wird aufgenommen.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Verdict</source>
      <translation>Urteil</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Rule</source>
      <translation>Regel</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Figure</source>
      <translation>Wert</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Limit</source>
      <translation>Grenze</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Rules</source>
      <translation>Regeln</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Open the &amp;page</source>
      <translation>&amp;Seite öffnen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>With a plot for each rule, to be kept and sent</source>
      <translation>Mit einem Schaubild zu jeder Regel, zum Aufheben und Verschicken</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>The take is judged…</source>
      <translation>Die Aufnahme wird beurteilt…</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>The take cannot be judged</source>
      <translation>Die Aufnahme kann nicht beurteilt werden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>All rules passed</source>
      <translation>Alle Regeln bestanden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>Not all rules passed</source>
      <translation>Nicht alle Regeln bestanden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/guide/result.py" />
      <source>{} of {} rules, on {}</source>
      <translation>{} von {} Regeln, bei {}</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Hand open, fingers straight</source>
      <translation>Hand offen, Finger gerade</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>A fist, in the grip of the other hand</source>
      <translation>Eine Faust, im Griff der anderen Hand</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Grip the fist of the other hand</source>
      <translation>Die Faust der anderen Hand umgreifen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Turn the open hand from side to side about the forearm</source>
      <translation>Die offene Hand um den Unterarm hin und her drehen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>open</source>
      <translation>offen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>right grips left</source>
      <translation>rechts umgreift links</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>left grips right</source>
      <translation>links umgreift rechts</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>turn</source>
      <translation>drehen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Signal</source>
      <translation>Signal</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Shape of the hand</source>
      <translation>Form der Hand</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Placement in the room</source>
      <translation>Lage im Raum</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Scripted steps</source>
      <translation>Vorgegebene Schritte</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>All positions are numbers</source>
      <translation>Alle Positionen sind Zahlen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Rotations have length 1</source>
      <translation>Drehungen haben Länge 1</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>A hand is tracked</source>
      <translation>Eine Hand wird verfolgt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Time never goes back</source>
      <translation>Die Zeit läuft nie zurück</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>No record is earlier than its measurement</source>
      <translation>Kein Eintrag ist früher als seine Messung</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Regular sampling intervals</source>
      <translation>Gleichmäßige Abtastung</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>No gaps</source>
      <translation>Keine Lücken</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Plausible joint speeds</source>
      <translation>Plausible Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>All 21 joints are present</source>
      <translation>Alle 21 Gelenke sind vorhanden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>The same joints throughout</source>
      <translation>Durchgehend dieselben Gelenke</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Plausible joint radii</source>
      <translation>Plausible Gelenkradien</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Hand length, wrist to middle fingertip</source>
      <translation>Handlänge, Handgelenk bis Mittelfingerspitze</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Constant bone lengths</source>
      <translation>Konstante Knochenlängen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Knuckles in order</source>
      <translation>Knöchel in der richtigen Reihenfolge</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Joints in order, from knuckle to tip</source>
      <translation>Gelenke in der richtigen Reihenfolge, vom Knöchel zur Spitze</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Fingers bend towards the palm</source>
      <translation>Finger beugen sich zur Handfläche</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>The wrist is away from the origin</source>
      <translation>Das Handgelenk ist vom Ursprung entfernt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>The wrist position is not frozen</source>
      <translation>Die Position des Handgelenks ist nicht eingefroren</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Rotations: −z along the bones, order xyzw</source>
      <translation>Drehungen: −z entlang der Knochen, Reihenfolge xyzw</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Wrist and joints turn together</source>
      <translation>Handgelenk und Gelenke drehen sich gemeinsam</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Steps are labelled</source>
      <translation>Schritte sind gekennzeichnet</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Steps are complete and in order</source>
      <translation>Schritte sind vollständig und in Reihenfolge</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Every step is recorded</source>
      <translation>Jeder Schritt ist aufgenommen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Hand open, at the start</source>
      <translation>Offene Hand, am Anfang</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Fist</source>
      <translation>Faust</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Right hand grips the left fist</source>
      <translation>Rechte Hand umfasst die linke Faust</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Left hand grips the right fist</source>
      <translation>Linke Hand umfasst die rechte Faust</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Pinch, thumb and index finger</source>
      <translation>Kneifen, Daumen und Zeigefinger</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Pinch, thumb and middle finger</source>
      <translation>Kneifen, Daumen und Mittelfinger</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Pinch, thumb and ring finger</source>
      <translation>Kneifen, Daumen und Ringfinger</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Pinch, thumb and little finger</source>
      <translation>Kneifen, Daumen und kleiner Finger</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Wrist turned from side to side</source>
      <translation>Handgelenk hin und her gedreht</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/view_model.py" />
      <source>Hand open, at the end</source>
      <translation>Offene Hand, am Ende</translation>
    </message>
    <message>
      <location filename="extensions/movement/window/extension.py" />
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <location filename="extensions/movement/window/extension.py" />
      <source>Report of {}</source>
      <translation>Bericht über {}</translation>
    </message>
    <message>
      <location filename="extensions/movement/window/extension.py" />
      <source>Report of {} recordings</source>
      <translation>Bericht über {} Aufnahmen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Connect</source>
      <translation>Verbinden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Let a simulated robot hand follow the wearer's</source>
      <translation>Eine simulierte Roboterhand der Hand der Person folgen lassen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Clutch</source>
      <translation>Kupplung</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Robot and things go to where they began</source>
      <translation>Roboter und Dinge gehen an ihren Anfang zurück</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Robot hand</source>
      <translation>Roboterhand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>From a file…</source>
      <translation>Aus einer Datei…</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Scale of the motion</source>
      <translation>Maßstab der Bewegung</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>How far the robot's palm goes for each way of the wearer's</source>
      <translation>Wie weit die Handfläche des Roboters für jeden Weg der Hand geht</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Motion ×</source>
      <translation>Bewegung ×</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Gesture of the clutch</source>
      <translation>Geste der Kupplung</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Clutch by</source>
      <translation>Kupplung durch</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>UDP port of the robot's states</source>
      <translation>UDP-Anschluss für die Zustände des Roboters</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>The robot's joints go there as JSON, on this computer</source>
      <translation>Die Gelenke des Roboters gehen als JSON dorthin, auf diesem Rechner</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Send by UDP</source>
      <translation>Per UDP senden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>A hand as MJCF</source>
      <translation>Eine Hand als MJCF</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>MuJoCo models (*.xml)</source>
      <translation>MuJoCo-Modelle (*.xml)</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/controls.py" />
      <source>Pressed, the robot follows; else it holds as it is ({})</source>
      <translation>Gedrückt folgt der Roboter; sonst hält er, wie er ist ({})</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Shadow hand</source>
      <translation>Shadow-Hand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>its button alone</source>
      <translation>nur seinen Knopf</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>pointing</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Follows</source>
      <translation>Folgt</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Hands that were overtaken by a newer one: {}</source>
      <translation>Hände, die von einer neueren überholt wurden: {}</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>No robot follows</source>
      <translation>Kein Roboter folgt</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>The robot is being made ready</source>
      <translation>Der Roboter wird vorbereitet</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>The robot waits for a hand</source>
      <translation>Der Roboter wartet auf eine Hand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>The robot as it was recorded</source>
      <translation>Der Roboter, wie er aufgenommen wurde</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Released: the robot holds</source>
      <translation>Losgelassen: der Roboter hält</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>The hand is lost: the robot holds</source>
      <translation>Die Hand ist verloren: der Roboter hält</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>fingertips {} mm off</source>
      <translation>Fingerspitzen {} mm daneben</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>{} ms behind (99 %)</source>
      <translation>{} ms zurück (99 %)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>chain (cameras and IMUs, our own)</source>
      <translation>chain (Kameras und IMUs, das eigene)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>Chain</source>
      <translation>Chain</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>vist (Lee et al. 2021)</source>
      <translation>vist (Lee et al. 2021)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>VIST</source>
      <translation>VIST</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>switching (fingers by their IMUs alone)</source>
      <translation>switching (Finger allein nach ihren IMUs)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>Switching</source>
      <translation>Switching</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>Madgwick (fingers by their IMUs alone)</source>
      <translation>Madgwick (Finger allein nach ihren IMUs)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>Madgwick</source>
      <translation>Madgwick</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>inertial (IMUs alone, no place)</source>
      <translation>inertial (nur IMUs, ohne Ort)</translation>
    </message>
    <message>
      <location filename="glovetrack.engines" />
      <source>IMUs only</source>
      <translation>nur IMUs</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>UDP (JSON)</source>
      <translation>UDP (JSON)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>WebSocket (JSON)</source>
      <translation>WebSocket (JSON)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>VMC (OSC, avatars)</source>
      <translation>VMC (OSC, Avatare)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Lab Streaming Layer</source>
      <translation>Lab Streaming Layer</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>its library listens on all addresses of this computer, so others in the same network can read it, unless a firewall keeps them out</source>
      <translation>seine Bibliothek lauscht an allen Adressen dieses Computers; andere im selben Netz können mitlesen, wenn keine Firewall sie abhält</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Foxglove</source>
      <translation>Foxglove</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Isaac record (MCAP)</source>
      <translation>Isaac-Handdaten (MCAP)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>UDP (JSON, words)</source>
      <translation>UDP (JSON, Wörter)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>OSC</source>
      <translation>OSC</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>LSL (markers become notes)</source>
      <translation>LSL (Marker werden Notizen)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Table for spreadsheets and everything else (CSV)</source>
      <translation>Tabelle für Tabellenkalkulation und alles andere (CSV)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Table for Python and R (Parquet)</source>
      <translation>Tabelle für Python und R (Parquet)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Arrays for MATLAB and Python (HDF5)</source>
      <translation>Felder für MATLAB und Python (HDF5)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Motion capture (C3D)</source>
      <translation>Bewegungserfassung (C3D)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>OpenSim markers (TRC)</source>
      <translation>OpenSim-Marker (TRC)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>OpenSim joint angles (MOT)</source>
      <translation>OpenSim-Gelenkwinkel (MOT)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>OpenSim orientations of the IMUs (STO)</source>
      <translation>OpenSim-Lagen der IMUs (STO)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>OpenSim model of the hand as tracked (OSIM)</source>
      <translation>OpenSim-Modell der verfolgten Hand (OSIM)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Animation skeleton (BVH)</source>
      <translation>Animationsskelett (BVH)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Animated hand in 3D (glTF)</source>
      <translation>Animierte Hand in 3D (glTF)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Robot model of the hand (URDF)</source>
      <translation>Robotermodell der Hand (URDF)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Film with the hand drawn in (MP4)</source>
      <translation>Film mit eingezeichneter Hand (MP4)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Folder of images with the hand drawn in (PNG)</source>
      <translation>Ordner mit Bildern, Hand eingezeichnet (PNG)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Session, whole or the chosen part (MCAP)</source>
      <translation>Sitzung, ganz oder der gewählte Teil (MCAP)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Data set for laboratories (Motion-BIDS, a folder)</source>
      <translation>Datensatz für Labore (Motion-BIDS, ein Ordner)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Raw samples of the IMUs (CSV)</source>
      <translation>Rohe Messwerte der IMUs (CSV)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Raw samples of the IMUs (Parquet)</source>
      <translation>Rohe Messwerte der IMUs (Parquet)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Hand record of NVIDIA's Isaac tools (MCAP)</source>
      <translation>Handdaten für Isaac von NVIDIA (MCAP)</translation>
    </message>
    <message>
      <location filename="glovetrack.formats" />
      <source>Data set for robot learning (LeRobot, a folder)</source>
      <translation>Datensatz für das Lernen von Robotern (LeRobot, ein Ordner)</translation>
    </message>
    <message>
      <location filename="tracker/base/damage.py" />
      <source>Damaged messages in {} were left out: {}.</source>
      <translation>Beschädigte Nachrichten in {} wurden ausgelassen: {}.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} is not a regular file.</source>
      <translation>{} ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} is larger than {} bytes: not {}.</source>
      <translation>{} ist größer als {} Byte: keine {}.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} exists already and {}; choose another name.</source>
      <translation>{} gibt es schon und {}; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} exists already; choose another name, or --force to replace it.</source>
      <translation>{} gibt es schon; einen anderen Namen wählen, oder --force ersetzt es.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>The folder {} is not empty; choose another one, or --force to replace files in it.</source>
      <translation>Der Ordner {} ist nicht leer; wählen Sie einen anderen, oder --force, um Dateien darin zu ersetzen.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} exists already; choose another name.</source>
      <translation>{} gibt es schon; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <location filename="tracker/base/files.py" />
      <source>{} is what is read; choose another name.</source>
      <translation>{} wird gerade gelesen; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <location filename="tracker/base/registry.py" />
      <source>There is no {} {}; available: {}.</source>
      <translation>{} {} gibt es nicht; vorhanden: {}.</translation>
    </message>
    <message>
      <location filename="tracker/base/registry.py" />
      <source>The {} {} cannot be loaded: {} is not a {}.</source>
      <translation>{} {} kann nicht geladen werden: {} ist kein {}.</translation>
    </message>
    <message>
      <location filename="tracker/base/shared_memory.py" />
      <source>The system has no {} MB of shared memory left, in which images are handed from one process to the other.</source>
      <translation>Das System hat keine {} MB gemeinsamen Speicher mehr, in dem Bilder von einem Prozess zum anderen gehen.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} is larger than {} bytes: not a configuration file.</source>
      <translation>{} ist größer als {} Bytes: keine Konfigurationsdatei.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} is not valid TOML: {}.</source>
      <translation>{} ist kein gültiges TOML: {}.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} is not valid TOML: it is nested too deeply.</source>
      <translation>{} ist kein gültiges TOML: zu tief verschachtelt.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} is not valid TOML: line {} has a text without its end.</source>
      <translation>{} ist kein gültiges TOML: In Zeile {} fehlt das Ende eines Textes.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} is not a UTF-8 text file.</source>
      <translation>{} ist keine UTF-8-Textdatei.</translation>
    </message>
    <message>
      <location filename="tracker/base/toml_reader.py" />
      <source>{} cannot be read: {}.</source>
      <translation>{} kann nicht gelesen werden: {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_fit.py" />
      <source>No pixels were marked for the hue {}.</source>
      <translation>Für den Farbton {} wurden keine Bildpunkte markiert.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_fit.py" />
      <source>The pixels marked for {} have every hue: mark one cloth only.</source>
      <translation>Die für {} markierten Bildpunkte haben jeden Farbton: nur einen Stoff markieren.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_follow.py" />
      <source>The light has changed; adapting the colours.</source>
      <translation>Das Licht hat sich geändert; die Farben werden angepasst.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_image.py" />
      <source>Nothing was fitted: no glove with its patches is seen for sure. Hold the hand flat before the camera, in more or whiter light.</source>
      <translation>Nichts wurde angepasst: kein Handschuh mit seinen Flecken ist sicher zu sehen. Die Hand flach vor die Kamera halten, in mehr oder weißerem Licht.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_image.py" />
      <source>Point at a marker of each hue first: {} missing.</source>
      <translation>Erst auf einen Marker jedes Farbtons zeigen: {} fehlt.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_image.py" />
      <source>Nothing was learned beyond what was pointed at: no glove with its patches is seen around it. Point at the middle of a patch of each hue, the hand flat.</source>
      <translation>Gelernt wurde nur, worauf gezeigt wurde: ringsum ist kein Handschuh mit seinen Flecken zu sehen. Auf die Mitte eines Flecks jedes Farbtons zeigen, die Hand flach.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_image.py" />
      <source>The colours stay as they are: learned ones show {} of {} markers and {} other things, these {} and {}. Point at markers of a flat hand, in more light.</source>
      <translation>Die Farben bleiben, wie sie sind: gelernte zeigen {} von {} Markern und {} andere Dinge, diese {} und {}. Auf Marker einer flachen Hand zeigen, bei mehr Licht.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/colours_image.py" />
      <source>The colours stay as they are: fitted ones show {} patches of the glove and {} other things, these {} and {}.</source>
      <translation>Die Farben bleiben, wie sie sind: angepasste zeigen {} Flecken des Handschuhs und {} andere Dinge, diese {} und {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The {} markers are too bright: shorten the exposure, or move the lamp away.</source>
      <translation>Die Marker in {} sind zu hell: die Belichtung verkürzen oder die Lampe wegrücken.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The markers are dark: more light on the hand, or a longer exposure.</source>
      <translation>Die Marker sind dunkel: mehr Licht auf die Hand oder länger belichten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The image is noisy: more light, and less gain.</source>
      <translation>Das Bild rauscht: mehr Licht und weniger Verstärkung.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The light is too warm: take a daylight lamp or set the white balance, then fit the colours.</source>
      <translation>Das Licht ist zu warm: eine Tageslichtlampe nehmen oder den Weißabgleich stellen, dann die Farben anpassen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The light is too cold: set the white balance, then fit the colours.</source>
      <translation>Das Licht ist zu kalt: den Weißabgleich stellen, dann die Farben anpassen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>The {} markers look alike in this light: another lamp, or other cloth.</source>
      <translation>Die Marker in {} sehen in diesem Licht gleich aus: eine andere Lampe oder anderer Stoff.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>{} of {} markers are not found with these colours: fit them to the image.</source>
      <translation>{} von {} Markern werden mit diesen Farben nicht gefunden: an das Bild anpassen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>Hold the gloved hand before the camera, its back up.</source>
      <translation>Die Hand im Handschuh vor die Kamera halten, den Handrücken nach oben.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/light_meter.py" />
      <source>{} % of the image is white: keep window and screen out of it, or shorten the exposure.</source>
      <translation>{} % des Bildes sind weiß: Fenster und Bildschirm heraushalten oder kürzer belichten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/board.py" />
      <source>A board is one of {}, not {}.</source>
      <translation>Eine Tafel ist eine von {}, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/board.py" />
      <source>A board has {} to {} squares each way, not {} by {}.</source>
      <translation>Eine Tafel hat {} bis {} Felder je Richtung, nicht {} mal {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/board.py" />
      <source>A square of {} mm cannot be right: measure one on the paper.</source>
      <translation>Ein Feld von {} mm kann nicht stimmen: eines auf dem Papier messen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/board.py" />
      <source>A chessboard of {} by {} squares looks the same upside down: one number must be even and the other odd.</source>
      <translation>Ein Schachbrett von {} mal {} Feldern sieht auf dem Kopf gleich aus: eine Zahl muss gerade sein, die andere ungerade.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The lenses would stand {} mm apart, but {} mm are known: measure a square of the board again.</source>
      <translation>Die Objektive stünden {} mm auseinander, bekannt sind aber {} mm: ein Feld der Tafel noch einmal messen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The cameras would look {} degrees apart: they must look the same way.</source>
      <translation>Die Kameras sähen {} Grad auseinander: sie müssen in dieselbe Richtung sehen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The views do not fit one camera: corners are off by {} px. Check the numbers of squares, hold the board flat and still, and turn off autofocus.</source>
      <translation>Die Ansichten passen zu keiner Kamera: Ecken weichen um {} px ab. Die Zahlen der Felder prüfen, die Tafel flach und still halten und den Autofokus abschalten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The views cover only {} % of the images: show the board at the edges too.</source>
      <translation>Die Ansichten decken nur {} % der Bilder ab: die Tafel auch am Rand zeigen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The views are too alike: only {} show the board tilted, and the focal length is uncertain by {} %.</source>
      <translation>Die Ansichten sind zu ähnlich: nur {} zeigen die Tafel geneigt, und die Brennweite ist um {} % unsicher.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The calibration holds values that are no numbers.</source>
      <translation>Die Kalibrierung enthält Werte, die keine Zahlen sind.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>One camera is mirrored against the other: turn off its mirror setting.</source>
      <translation>Eine Kamera ist gegen die andere gespiegelt: ihre Spiegelung abschalten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The cameras stand above or behind each other, not side by side: turn the rig, or the images, by 90 degrees.</source>
      <translation>Die Kameras stehen über- oder hintereinander statt nebeneinander: das Gestell oder die Bilder um 90 Grad drehen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>Left and right are exchanged: what is called the left camera stands on the right. Exchange the two images in the camera's set-up, or turn off mirroring, which looks the same.</source>
      <translation>Links und rechts sind vertauscht: was linke Kamera heißt, steht rechts. Die beiden Bilder in der Einrichtung der Kamera vertauschen oder die Spiegelung abschalten, die gleich aussieht.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The cameras would stand {} mm apart; between {} and {} mm is possible. Is the size of a square, or the unit of the file, right?</source>
      <translation>Die Kameras stünden {} mm auseinander; möglich sind {} bis {} mm. Stimmt die Größe eines Feldes oder die Einheit der Datei?</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>One camera would stand {} mm above and {} mm before the other: they must be side by side.</source>
      <translation>Eine Kamera stünde {} mm über und {} mm vor der anderen: sie müssen nebeneinander stehen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The right lens would magnify {} times as much as the left one: are the squares the same for both, and is one of them zoomed?</source>
      <translation>Das rechte Objektiv würde {}-mal so stark vergrößern wie das linke: sind die Felder für beide gleich, und ist eines gezoomt?</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The {}lens would have a focal length of {} px for an image {} px wide, which no usual lens has.</source>
      <translation>Objektiv {}: die Brennweite wäre {} px bei einem {} px breiten Bild; das hat kein übliches Objektiv.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The middle of the {}lens would lie {} px from the middle of the image: is the image cropped, or of another size?</source>
      <translation>Objektiv {}: seine Mitte läge {} px neben der Bildmitte: ist das Bild beschnitten oder von anderer Größe?</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The {}lens would bend the image's corners beyond recognition: show the board in the corners too, or use a lens that is no fisheye.</source>
      <translation>Objektiv {}: die Bildecken wären bis zur Unkenntlichkeit verzerrt: die Tafel auch in den Ecken zeigen oder ein Objektiv nehmen, das kein Fischauge ist.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/checks.py" />
      <source>The {}lens would have pixels that are not square ({} by {}).</source>
      <translation>Objektiv {}: die Bildpunkte wären nicht quadratisch ({} mal {}).</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/coverage.py" />
      <source>Hold the board where the images are empty: {}.</source>
      <translation>Die Tafel dorthin halten, wo die Bilder leer sind: {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/coverage.py" />
      <source>Tilt the board: by 30 degrees to the left, right, towards you and away.</source>
      <translation>Die Tafel neigen: um 30 Grad nach links, rechts, zu sich hin und von sich weg.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/coverage.py" />
      <source>Hold the board nearer, then farther away.</source>
      <translation>Die Tafel näher halten, dann weiter weg.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/coverage.py" />
      <source>A few more views, each different from the others.</source>
      <translation>Noch einige Ansichten, jede anders als die anderen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/files.py" />
      <source>{} is no stereo calibration: a ZED's file ends in .conf, OpenCV's in .yml.</source>
      <translation>{} ist keine Stereo-Kalibrierung: die Datei einer ZED endet auf .conf, die von OpenCV auf .yml.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/files.py" />
      <source>{} is no calibration that OpenCV can read.</source>
      <translation>{} ist keine Kalibrierung, die OpenCV lesen kann.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/solve.py" />
      <source>{} usable views are too few: at least {} are needed.</source>
      <translation>{} brauchbare Ansichten sind zu wenig: mindestens {} sind nötig.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/solve.py" />
      <source>The views do not fit any camera: check the board's kind and its numbers of squares.</source>
      <translation>Die Ansichten passen zu keiner Kamera: die Art der Tafel und die Zahlen ihrer Felder prüfen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Rows agree to {} px and sizes to {} %.</source>
      <translation>Zeilen stimmen auf {} px und Größen auf {} % überein.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Corners are where they should be within {} px.</source>
      <translation>Die Ecken liegen auf {} px genau da, wo sie sollen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>{} more fresh views are needed.</source>
      <translation>{} weitere frische Ansichten sind nötig.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Rows disagree by {} px and sizes by {} %: calibrate again with more, and more different, views.</source>
      <translation>Zeilen weichen um {} px und Größen um {} % ab: mit mehr und verschiedeneren Ansichten neu kalibrieren.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Rows disagree by {} px, sizes by {} %. It can be used; a new calibration would place the hand better.</source>
      <translation>Zeilen weichen um {} px ab, Größen um {} %. Das ist brauchbar; eine neue Kalibrierung fände die Hand genauer.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Corners are off by {} px: calibrate again with more, and more different, views.</source>
      <translation>Die Ecken weichen um {} px ab: noch einmal mit mehr und verschiedeneren Ansichten kalibrieren.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/verify.py" />
      <source>Corners are off by {} px. It can be used; a new calibration would place the hand better.</source>
      <translation>Die Ecken weichen um {} px ab. Das ist brauchbar; eine neue Kalibrierung legte die Hand genauer fest.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/views.py" />
      <source>The board is not seen{}{}.</source>
      <translation>Die Tafel ist nicht zu sehen{}{}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/views.py" />
      <source>Both images must show the same part of the board.</source>
      <translation>Beide Bilder müssen denselben Teil der Tafel zeigen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/stereo/views.py" />
      <source>{} is mirrored: turn off the camera's mirror setting.</source>
      <translation>{} ist gespiegelt: das Spiegeln in der Kamera abschalten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/still.py" />
      <source>The hand moved ({}): lay it flat on the table, palm down, and wait.</source>
      <translation>Die Hand hat sich bewegt ({}): flach auf den Tisch legen, Handfläche nach unten, und warten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/still.py" />
      <source>Only {} s of samples came; {} s are needed.</source>
      <translation>Nur {} s an Messwerten kamen; {} s sind nötig.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Rest the forearm and tip the whole hand up and down, fingers stretched.</source>
      <translation>Den Unterarm auflegen und die ganze Hand auf und ab kippen, die Finger gestreckt.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Bend and stretch the thumb a few times; hold the rest still.</source>
      <translation>Den Daumen einige Male beugen und strecken; alles andere still halten.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Look at {}.</source>
      <translation>{} ansehen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Every IMU is where the glove file says.</source>
      <translation>Jede IMU ist dort, wo die Handschuhdatei sagt.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Bend and stretch the {} finger a few times, in all its joints.</source>
      <translation>Den Finger ({}) einige Male in allen Gelenken beugen und strecken.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It sits on the {}; the glove file says {}.</source>
      <translation>Sie sitzt auf {}; die Handschuhdatei sagt {}.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It is in its place, but turned by about {}°: remount it.</source>
      <translation>Sie ist an ihrem Platz, aber um etwa {}° verdreht: neu anbringen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It is where the glove file says.</source>
      <translation>Sie ist dort, wo die Handschuhdatei sagt.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>Nothing moved. </source>
      <translation>Nichts hat sich bewegt. </translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It did not answer in any step.</source>
      <translation>Sie hat in keinem Schritt geantwortet.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It moved in several steps: do them again.</source>
      <translation>Sie hat sich in mehreren Schritten bewegt: diese wiederholen.</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>It never moved: is it loose, or broken?</source>
      <translation>Sie hat sich nie bewegt: ist sie lose oder defekt?</translation>
    </message>
    <message>
      <location filename="tracker/calibration/wiggle.py" />
      <source>{} and {} are exchanged: exchange their plugs, or choose a glove file with that order.</source>
      <translation>{} und {} sind vertauscht: die Stecker tauschen oder eine Handschuhdatei mit dieser Reihenfolge wählen.</translation>
    </message>
    <message>
      <location filename="tracker/engine/hands.py" />
      <source>The glove {} is made for the {} hand and cannot track the {} one.</source>
      <translation>Der Handschuh {} ist für die Hand {} gemacht und kann die Hand {} nicht tracken.</translation>
    </message>
    <message>
      <location filename="tracker/engine/kinds.py" />
      <source>The engine {} needs a camera with a stereo calibration; without one the engine {} shows the hand by its IMUs.</source>
      <translation>Das Verfahren {} braucht eine Kamera mit Stereokalibrierung; ohne sie zeigt das Verfahren {} die Hand anhand ihrer IMUs.</translation>
    </message>
    <message>
      <location filename="tracker/engine/kinds.py" />
      <source>The engine {} needs both lenses; with one, use the engine chain.</source>
      <translation>Das Verfahren {} braucht beide Objektive; mit einem ist das Verfahren chain zu verwenden.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>No packets from the {} glove: the hand follows the images alone.</source>
      <translation>Keine Pakete vom Handschuh ({}): Die Hand folgt nur den Bildern.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>Packets from the {} glove arrive again.</source>
      <translation>Pakete vom Handschuh ({}) kommen wieder an.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>More than {} coloured patches in an image: {} were ignored so far.</source>
      <translation>Mehr als {} farbige Flecken in einem Bild: {} wurden bisher ignoriert.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>The hand was given up: patches on it are not where the glove's markers of their hues would be. Fit the colours, or look whether two of their hues are exchanged.</source>
      <translation>Die Hand wurde aufgegeben: Flecken auf ihr liegen nicht dort, wo die Marker des Handschuhs in ihren Farben wären. Die Farben anpassen, oder nachsehen, ob zwei von ihnen vertauscht sind.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>{}: engine {} has none. Choose engine chain or inertial.</source>
      <translation>{}: Das Verfahren {} hat das nicht. Wählen Sie chain oder inertial.</translation>
    </message>
    <message>
      <location filename="tracker/engine/pipeline.py" />
      <source>The engine {} learns nothing from guided poses.</source>
      <translation>Das Verfahren {} lernt nichts aus angeleiteten Haltungen.</translation>
    </message>
    <message>
      <location filename="tracker/engine/side_watch.py" />
      <source>This looks like a glove of the {} hand: its patches are mirrored. The file {} is of the {} hand; choose a {} one.</source>
      <translation>Das sieht nach einem Handschuh für {} aus: seine Flecken sind gespiegelt. Die Datei {} ist für {}; eine für {} wählen.</translation>
    </message>
    <message>
      <location filename="tracker/firmware/command.py" />
      <source>The glove does not respond yet. Unplug it, then plug it in again.</source>
      <translation>Der Handschuh antwortet noch nicht. Ziehen Sie ihn ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
      <location filename="tracker/firmware/image.py" />
      <source>A glove's number is from 1 to {}; {} is not. Two gloves need different ones.</source>
      <translation>Die Nummer eines Handschuhs liegt zwischen 1 und {}; {} nicht. Zwei Handschuhe brauchen verschiedene.</translation>
    </message>
    <message>
      <location filename="tracker/firmware/versions.py" />
      <source>Firmware {} is available (installed: {}).</source>
      <translation>Firmware {} ist verfügbar (installiert: {}).</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/calibration/control.py" />
      <source>There is no segment {} whose calibration is estimated.</source>
      <translation>Es gibt kein Glied {}, dessen Kalibrierung geschätzt wird.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/calibration/measured.py" />
      <source>A hand is {} to {} mm long, from the crease of the wrist to the tip of the middle finger; {} mm is no hand's.</source>
      <translation>Eine Hand ist von der Falte des Handgelenks bis zur Spitze des Mittelfingers {} bis {} mm lang; {} mm hat keine Hand.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/calibration/profile_file.py" />
      <source>{} is of hand {} with glove {}; this is hand {} with glove {}.</source>
      <translation>{} gehört zur Hand {} mit dem Handschuh {}; dies ist die Hand {} mit dem Handschuh {}.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/calibration/profile_file.py" />
      <source>{} is no profile of a wearer, or it is damaged.</source>
      <translation>{} ist kein Profil einer Person oder ist beschädigt.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/engine.py" />
      <source>The camera measures the heading.</source>
      <translation>Die Kamera misst die Richtung.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/engine.py" />
      <source>{}not possible before the hand is tracked.</source>
      <translation>{}nicht möglich, bevor die Hand verfolgt wird.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/guided/events.py" />
      <source>There is no guided pose {}: it is passed over.</source>
      <translation>Es gibt keine angeleitete Haltung {}: sie wird übergangen.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/guided/events.py" />
      <source>The guided pose {} neither begins nor ends: it is passed over.</source>
      <translation>Die angeleitete Haltung {} beginnt weder noch endet sie: sie wird übergangen.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/inertial.py" />
      <source>Heading corrected by {}°.</source>
      <translation>Richtung um {}° korrigiert.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/chain/pose_reset.py" />
      <source>Pose reset: hand flat, fingers straight ahead.</source>
      <translation>Haltung zurückgesetzt: Hand flach, Finger gerade nach vorn.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/hybrid.py" />
      <source>The engine {} needs an IMU and markers on the {}.</source>
      <translation>Das Verfahren {} braucht eine IMU und Marker auf {}.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/vist/layout.py" />
      <source>The engine vist needs an IMU on every segment of a chain; the glove {} has none on {}.</source>
      <translation>Das Verfahren vist braucht eine IMU auf jedem Glied einer Kette; der Handschuh {} hat keine auf {}.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/vist/layout.py" />
      <source>The engine vist takes one IMU per segment; the glove {} has more.</source>
      <translation>Das Verfahren vist nimmt eine IMU je Glied; der Handschuh {} hat mehr.</translation>
    </message>
    <message>
      <location filename="tracker/fusion/worn.py" />
      <source>This engine does not take or learn a wearer's profile; chain does.</source>
      <translation>Dieses Verfahren verwendet und lernt kein Profil der Person; chain kann das.</translation>
    </message>
    <message>
      <location filename="tracker/glove/library.py" />
      <source>There is no {} among the {}; there are {}, or give the path of a file.</source>
      <translation>{1}: {0} gibt es nicht; es gibt {2}, oder den Pfad einer Datei angeben.</translation>
    </message>
    <message>
      <location filename="tracker/inertial/finger3d.py" />
      <source>There is no finger estimator {}; there are {}.</source>
      <translation>Es gibt keinen Fingerschätzer {}; es gibt {}.</translation>
    </message>
    <message>
      <location filename="tracker/inertial/finger3d.py" />
      <source>The glove {} has no IMU on {}.</source>
      <translation>Der Handschuh {} hat keine IMU auf {}.</translation>
    </message>
    <message>
      <location filename="tracker/live/exchange_watch.py" />
      <source>The two gloves are exchanged: each has the files of the other hand. Choose the hand of each in the set-up of the gloves.</source>
      <translation>Die beiden Handschuhe sind vertauscht: jeder hat die Dateien der anderen Hand. Beim Einrichten der Handschuhe die Hand eines jeden wählen.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>Looking for the hand.</source>
      <translation>Die Hand wird gesucht.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The hand is tracked.</source>
      <translation>Die Hand wird verfolgt.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The hand is out of sight; its place is extrapolated.</source>
      <translation>Die Hand ist außer Sicht; ihr Ort wird fortgeschrieben.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The hand's place is lost; finger angles go on.</source>
      <translation>Der Ort der Hand ist verloren; die Fingerwinkel laufen weiter.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>Looking for the {} hand.</source>
      <translation>Die Hand {} wird gesucht.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The {} hand is tracked.</source>
      <translation>Die Hand {} wird verfolgt.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The {} hand is out of sight; its place is extrapolated.</source>
      <translation>Die Hand {} ist außer Sicht; ihr Ort wird fortgeschrieben.</translation>
    </message>
    <message>
      <location filename="tracker/live/hand.py" />
      <source>The {} hand's place is lost; finger angles go on.</source>
      <translation>Der Ort der Hand {} ist verloren; die Fingerwinkel laufen weiter.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>The computer is too slow: the 3D view is drawn less often.</source>
      <translation>Der Rechner ist zu langsam: die 3D-Ansicht wird seltener gezeichnet.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>The computer is too slow: camera images are shown without overlays.</source>
      <translation>Der Rechner ist zu langsam: Kamerabilder werden ohne Einblendungen gezeigt.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>The computer is too slow: images are searched only where markers are expected.</source>
      <translation>Der Rechner ist zu langsam: Bilder werden nur dort durchsucht, wo Marker erwartet werden.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>The computer is too slow: fewer images are searched. No packet of the glove is left out.</source>
      <translation>Der Rechner ist zu langsam: weniger Bilder werden durchsucht. Kein Paket des Handschuhs wird ausgelassen.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>The computer keeps up again: nothing is left out any more.</source>
      <translation>Der Rechner kommt wieder mit: nichts wird mehr ausgelassen.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>Camera images have their overlays again.</source>
      <translation>Kamerabilder haben wieder ihre Einblendungen.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>Images are searched as a whole again.</source>
      <translation>Bilder werden wieder ganz durchsucht.</translation>
    </message>
    <message>
      <location filename="tracker/live/load.py" />
      <source>All images are searched again.</source>
      <translation>Alle Bilder werden wieder durchsucht.</translation>
    </message>
    <message>
      <location filename="tracker/live/loop.py" />
      <source>The engine is now {}.</source>
      <translation>Das Verfahren ist jetzt {}.</translation>
    </message>
    <message>
      <location filename="tracker/live/loop.py" />
      <source>The recording has begun.</source>
      <translation>Die Aufnahme hat begonnen.</translation>
    </message>
    <message>
      <location filename="tracker/live/recording.py" />
      <source>The recording is finished.</source>
      <translation>Die Aufnahme ist fertig.</translation>
    </message>
    <message>
      <location filename="tracker/live/threads.py" />
      <source>The {} thread failed: {}: {}.</source>
      <translation>Der Strang {} ist ausgefallen: {}: {}.</translation>
    </message>
    <message>
      <location filename="tracker/online/colour_watch.py" />
      <source>The colours find {} patches, none fit the glove: fit the colours.</source>
      <translation>Die Farben finden {} Flecken, keine passen zum Handschuh: die Farben anpassen.</translation>
    </message>
    <message>
      <location filename="tracker/online/colour_watch.py" />
      <source>The colours find no more patches than they should, or the hand.</source>
      <translation>Die Farben finden nicht mehr Flecken, als sie sollen, oder die Hand.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>The images have moved against each other by {} pixels at once: a lens was knocked. Calibrate the camera again if this stays.</source>
      <translation>Die Bilder haben sich auf einmal um {} Bildpunkte gegeneinander verschoben: ein Objektiv wurde angestoßen. Die Kamera neu kalibrieren, wenn das so bleibt.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>All markers have jumped by {} pixels at once: the camera was moved. Places are measured from where it stands now.</source>
      <translation>Alle Marker sind auf einmal um {} Bildpunkte gesprungen: die Kamera wurde bewegt. Orte werden von dort gemessen, wo sie jetzt steht.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>The left and the right image are swapped; they are not used. Exchange the two cameras.</source>
      <translation>Linkes und rechtes Bild sind vertauscht; sie werden nicht benutzt. Die beiden Kameras tauschen.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>The two images are {} pixels apart in height: a lens has moved since the stereo calibration. Calibrate the camera again.</source>
      <translation>Die beiden Bilder liegen in der Höhe {} Bildpunkte auseinander: ein Objektiv hat sich seit der Stereo-Kalibrierung verschoben. Die Kamera neu kalibrieren.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>The left and the right image are in order again.</source>
      <translation>Linkes und rechtes Bild sind wieder in Ordnung.</translation>
    </message>
    <message>
      <location filename="tracker/online/rig_watch.py" />
      <source>The two images fit the stereo calibration again.</source>
      <translation>Die beiden Bilder passen wieder zur Stereo-Kalibrierung.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera gives one image, but the calibration is for two: calibrate it as one camera.</source>
      <translation>Die Kamera liefert ein Bild, die Kalibrierung gilt aber für zwei: sie als eine Kamera kalibrieren.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera gives two images, but the calibration is for one camera: calibrate both, or choose one camera in its set-up.</source>
      <translation>Die Kamera liefert zwei Bilder, die Kalibrierung gilt aber für eine Kamera: beide kalibrieren oder beim Einrichten eine Kamera wählen.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera {} is connected.</source>
      <translation>Die Kamera {} ist verbunden.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera {} gives no images; waiting for it.</source>
      <translation>Die Kamera {} gibt keine Bilder; es wird auf sie gewartet.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The end of {} is reached.</source>
      <translation>Das Ende von {} ist erreicht.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The {} camera gives images of {} by {} pixels, but the calibration is for {} by {}.</source>
      <translation>Die Kamera {} gibt Bilder von {} mal {} Bildpunkten, die Kalibrierung gilt aber für {} mal {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The {} camera's image is black: is the lens covered?</source>
      <translation>Das Bild der Kamera {} ist schwarz: ist das Objektiv verdeckt?</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera gives {} images a second instead of {}: a long exposure in poor light, or a slow USB port.</source>
      <translation>Die Kamera gibt {} Bilder je Sekunde statt {}: lange Belichtung in schwachem Licht oder ein langsamer USB-Anschluss.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The camera gives images of {} by {} pixels, but its calibration is for {} by {}.</source>
      <translation>Die Kamera liefert Bilder von {} mal {} Pixeln, ihre Kalibrierung ist aber für {} mal {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The {} camera's image is frozen; it is not used.</source>
      <translation>Das Bild der Kamera {} steht still; es wird nicht benutzt.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The {} camera's image is torn: a part of it did not arrive.</source>
      <translation>Das Bild der Kamera {} ist zerrissen: ein Teil kam nicht an.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera.py" />
      <source>The {} camera's image is back.</source>
      <translation>Das Bild der Kamera {} ist wieder da.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera_plugins.py" />
      <source>There is no camera plug-in {}: install its package.</source>
      <translation>Es gibt keine Kamera-Erweiterung {}: ihr Paket installieren.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/camera_systems.py" />
      <source>This system's cameras cannot be listed by name ({}). Enter the camera's number under Set-up, Camera, Or number, file: 0 is the first one.</source>
      <translation>Die Kameras dieses Systems lassen sich nicht mit Namen auflisten ({}). Geben Sie die Nummer der Kamera unter Einrichtung, Kamera, Oder Nummer, Datei ein: 0 ist die erste.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/discovery.py" />
      <source>Nothing answers at {}.</source>
      <translation>An {} antwortet nichts.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/discovery.py" />
      <source>The USB adapter at {} may hold bytes back for up to 16 ms. For quicker tracking set 1 ms in the Device Manager: Ports, {}, Port Settings, Advanced, Latency Timer.</source>
      <translation>Der USB-Adapter an {} hält Bytes bis zu 16 ms zurück. Für schnelleres Tracking im Geräte-Manager 1 ms einstellen: Anschlüsse, {}, Anschlusseinstellungen, Erweitert, Wartezeit.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/discovery.py" />
      <source>{} sends {} bytes that are no glove's: another device, or one that does not speak at {} baud.</source>
      <translation>{} sendet {} Bytes, die von keinem Handschuh sind: ein anderes Gerät oder eines, das nicht mit {} Baud spricht.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/discovery.py" />
      <source>{} cannot be opened: {}.</source>
      <translation>{} lässt sich nicht öffnen: {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/discovery.py" />
      <source>{} went away: {}.</source>
      <translation>{} ist verschwunden: {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove has not said its ranges, so its values are not used yet: hold the hand still for a second, then gravity tells them.</source>
      <translation>Der Handschuh hat seine Messbereiche nicht genannt, seine Werte werden daher noch nicht benutzt: die Hand eine Sekunde still halten, dann sagt sie die Schwerkraft.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>At rest the glove's acceleration fits a range of {} g, which is used now; for turning {} deg/s is assumed and may be wrong.</source>
      <translation>In Ruhe passt die Beschleunigung des Handschuhs zu einem Messbereich von {} g, der jetzt benutzt wird; für Drehungen werden {} Grad/s angenommen, was falsch sein kann.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove was unplugged ({}); it is taken up when it returns.</source>
      <translation>Der Handschuh wurde abgezogen ({}); er wird wieder aufgenommen, wenn er zurück ist.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>At {} is {}: glove {} is looked for. To use another one, choose it under Set-up, Glove.</source>
      <translation>An {} ist {}: Handschuh {} wird gesucht. Um einen anderen zu benutzen, ihn unter Einrichten, Handschuh wählen.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove has restarted; it is told to go on.</source>
      <translation>Der Handschuh hat neu gestartet; er wird angewiesen weiterzumachen.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove sends {} packets a second, not the {} it was asked for; their times are right all the same.</source>
      <translation>Der Handschuh sendet {} Pakete je Sekunde, nicht die verlangten {}; ihre Zeiten stimmen trotzdem.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>This glove has {} IMUs but the glove file says {}: choose the right glove file.</source>
      <translation>Dieser Handschuh hat {} IMUs, die Handschuhdatei sagt aber {}: die richtige Handschuhdatei wählen.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove sends again.</source>
      <translation>Der Handschuh sendet wieder.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>Packets hold {} IMUs but the glove file says {}.</source>
      <translation>Pakete enthalten {} IMUs, die Handschuhdatei sagt aber {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove's clock jumped by {} s; its packets are timed anew.</source>
      <translation>Die Uhr des Handschuhs ist um {} s gesprungen; seine Pakete werden neu datiert.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove is back, at {}.</source>
      <translation>Der Handschuh ist wieder da, an {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>IMU {} of the glove {}.</source>
      <translation>IMU {} des Handschuhs {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove has not said what it is; it is told to start anyway.</source>
      <translation>Der Handschuh hat nicht gesagt, was er ist; er wird trotzdem gestartet.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/glove_link.py" />
      <source>The glove has been silent for {} s.</source>
      <translation>Der Handschuh schweigt seit {} s.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_input.py" />
      <source>The stereo image is {} pixels wide and has no two halves.</source>
      <translation>Das Stereobild ist {} Bildpunkte breit und hat keine zwei Hälften.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_input.py" />
      <source>The camera {} cannot be opened: it is not there.</source>
      <translation>Die Kamera {} lässt sich nicht öffnen: Sie ist nicht da.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_input.py" />
      <source>The camera {} cannot be opened: it is not there, or another program uses it.</source>
      <translation>Die Kamera {} lässt sich nicht öffnen: sie ist nicht da, oder ein anderes Programm benutzt sie.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_input.py" />
      <source>There are {} left and {} right images; a sequence needs as many of one as of the other.</source>
      <translation>Es gibt {} linke und {} rechte Bilder; eine Folge braucht von beiden gleich viele.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_watch.py" />
      <source>The {} gives images again.</source>
      <translation>{} gibt wieder Bilder.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/image_watch.py" />
      <source>The {} has given no usable image for {} s.</source>
      <translation>{} hat seit {} s kein brauchbares Bild gegeben.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/link_figures.py" />
      <source>The glove's battery is low ({} V): charge it soon.</source>
      <translation>Der Akku des Handschuhs ist schwach ({} V): bald laden.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/rig_files.py" />
      <source>{}: R is no rotation.</source>
      <translation>{}: R ist keine Drehung.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/rig_files.py" />
      <source>{}: {} must be {} finite numbers.</source>
      <translation>{}: {} muss aus {} endlichen Zahlen bestehen.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/rig_files.py" />
      <source>{}: the {} camera has {} distortion coefficients; only k1 k2 p1 p2 k3 are understood.</source>
      <translation>{}: die Kamera {} hat {} Verzeichnungskoeffizienten; verstanden werden nur k1 k2 p1 p2 k3.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/rig_files.py" />
      <source>{} does not hold {} ({}).</source>
      <translation>{} enthält {} nicht ({}).</translation>
    </message>
    <message>
      <location filename="tracker/sensors/rig_files.py" />
      <source>{} holds something that is no matrix.</source>
      <translation>{} enthält etwas, das keine Matrix ist.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/zed_files.py" />
      <source>A ZED has no images {} pixels high; there are {}.</source>
      <translation>Eine ZED hat keine {} Bildpunkte hohen Bilder; es gibt {}.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/zed_files.py" />
      <source>{} does not say {} in [{}]: the file is cut short, or belongs to another camera.</source>
      <translation>{} nennt {} in [{}] nicht: die Datei ist abgeschnitten oder gehört zu einer anderen Kamera.</translation>
    </message>
    <message>
      <location filename="tracker/sensors/zed_files.py" />
      <source>{}: {} in [{}] is {}, which is no number.</source>
      <translation>{}: {} in [{}] ist {}, also keine Zahl.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>Recordings are aligned by {}, not by {}.</source>
      <translation>Aufnahmen werden nach {} ausgerichtet, nicht nach {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>The recordings have no {} s of movement that could be the same.</source>
      <translation>Die Aufnahmen haben keine {} s Bewegung, die dieselbe sein könnte.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>The movements do not fit each other (correlation {}).</source>
      <translation>Die Bewegungen passen nicht zueinander (Korrelation {}).</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>The movements fit at more than one place (correlations {} and {}): they repeat themselves too evenly.</source>
      <translation>Die Bewegungen passen an mehr als einer Stelle (Korrelationen {} und {}): sie wiederholen sich zu gleichmäßig.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>A recording holds too little movement to be aligned by it.</source>
      <translation>Eine Aufnahme enthält zu wenig Bewegung, um nach ihr auszurichten.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>Neither IMUs nor tracked angles are in both recordings.</source>
      <translation>Weder IMUs noch Winkel aus dem Tracking sind in beiden Aufnahmen.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>{} is no alignment of two recordings.</source>
      <translation>{} ist keine Ausrichtung zweier Aufnahmen.</translation>
    </message>
    <message>
      <location filename="tracker/session/align.py" />
      <source>By their clocks the recordings were not made at the same time.</source>
      <translation>Nach ihren Uhren wurden die Aufnahmen nicht zur selben Zeit gemacht.</translation>
    </message>
    <message>
      <location filename="tracker/session/compare.py" />
      <source>{} and {} have no hand in common.</source>
      <translation>{} und {} haben keine gemeinsame Hand.</translation>
    </message>
    <message>
      <location filename="tracker/session/compare.py" />
      <source>{} and {} have no instant in common.</source>
      <translation>{} und {} haben keinen gemeinsamen Zeitpunkt.</translation>
    </message>
    <message>
      <location filename="tracker/session/decode_robot.py" />
      <source>{} does not say what the robot {} is.</source>
      <translation>{} sagt nicht, was der Roboter {} ist.</translation>
    </message>
    <message>
      <location filename="tracker/session/decode_robot.py" />
      <source>What the session says of its robot is no JSON object.</source>
      <translation>Was die Sitzung über ihren Roboter sagt, ist kein JSON-Objekt.</translation>
    </message>
    <message>
      <location filename="tracker/session/decode_robot.py" />
      <source>What the session says of its robot is no JSON.</source>
      <translation>Was die Sitzung über ihren Roboter sagt, ist kein JSON.</translation>
    </message>
    <message>
      <location filename="tracker/session/edits.py" />
      <source>{} lists {} filled gaps; at most {} are read.</source>
      <translation>{} enthält {} gefüllte Lücken; höchstens {} werden gelesen.</translation>
    </message>
    <message>
      <location filename="tracker/session/edits.py" />
      <source>{} has schema {}, not {}.</source>
      <translation>{} hat Schema {}, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/edits.py" />
      <source>{} is not a record of edits: {}.</source>
      <translation>{} ist kein Protokoll von Bearbeitungen: {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/engine_state.py" />
      <source>The state of tracking in the recording is damaged.</source>
      <translation>Der Zustand des Trackings in der Aufnahme ist beschädigt.</translation>
    </message>
    <message>
      <location filename="tracker/session/engine_state.py" />
      <source>The state of tracking in the recording is of another version.</source>
      <translation>Der Zustand des Trackings in der Aufnahme ist von einer anderen Version.</translation>
    </message>
    <message>
      <location filename="tracker/session/engine_state.py" />
      <source>The state of tracking in the recording is damaged: {}.</source>
      <translation>Der Zustand des Trackings in der Aufnahme ist beschädigt: {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/formats.py" />
      <source>{} is a data set of many sessions.</source>
      <translation>{} ist ein Datensatz aus vielen Aufzeichnungen.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/formats.py" />
      <source>{} contains one session; {} can contain several.</source>
      <translation>{} enthält eine Aufzeichnung; {} kann mehrere enthalten.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/formats.py" />
      <source>The format {} does not support {}.</source>
      <translation>Das Format {} unterstützt {} nicht.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/mcap.py" />
      <source>A session cannot do without its {}; leave out participant and notes by name.</source>
      <translation>Eine Sitzung kommt ohne ihre {} nicht aus; Person und Notizen mit Namen weglassen.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Images can be {}, not {}.</source>
      <translation>Bilder können {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>A rate of {} Hz is not between {} and {} Hz.</source>
      <translation>Eine Rate von {} Hz liegt nicht zwischen {} und {} Hz.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Every image or every n-th, not every {}.</source>
      <translation>Jedes Bild oder jedes n-te, nicht jedes {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Views can be {}, not {}.</source>
      <translation>Ansichten können {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Axes can be {}, not {}.</source>
      <translation>Achsen können {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Joints are openxr or names of ours, not both.</source>
      <translation>Gelenke sind openxr oder Namen von uns, nicht beides.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/options.py" />
      <source>Units can be {}, not {}.</source>
      <translation>Einheiten können {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/resample.py" />
      <source>{} estimates over {} s would be {} rows at {} Hz; export a part of them.</source>
      <translation>{} Schätzungen über {} s wären {} Zeilen bei {} Hz; einen Teil davon exportieren.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/series.py" />
      <source>{} holds no estimates; track it first.</source>
      <translation>{} enthält keine Schätzungen; erst tracken.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/series.py" />
      <source>There is no estimate between {} s and {} s.</source>
      <translation>Zwischen {} s und {} s gibt es keine Schätzung.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/series.py" />
      <source>There is no keypoint or joint {} in this session.</source>
      <translation>In dieser Sitzung gibt es keinen Punkt und kein Gelenk {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/export/tables.py" />
      <source>Parquet needs Arrow: install glovetrack[parquet].</source>
      <translation>Parquet braucht Arrow: glovetrack[parquet] installieren.</translation>
    </message>
    <message>
      <location filename="tracker/session/glance.py" />
      <source>There is no session in {}.</source>
      <translation>In {} ist keine Sitzung.</translation>
    </message>
    <message>
      <location filename="tracker/session/images.py" />
      <source>An image of {} is damaged.</source>
      <translation>Ein Bild von {} ist beschädigt.</translation>
    </message>
    <message>
      <location filename="tracker/session/images.py" />
      <source>An image of {} is neither JPEG nor PNG.</source>
      <translation>Ein Bild von {} ist weder JPEG noch PNG.</translation>
    </message>
    <message>
      <location filename="tracker/session/images.py" />
      <source>An image of {} claims {} by {} pixels.</source>
      <translation>Ein Bild von {} behauptet {} mal {} Bildpunkte.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/container.py" />
      <source>A session has at most {} types of messages.</source>
      <translation>Eine Sitzung hat höchstens {} Nachrichtentypen.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/container.py" />
      <source>A session has at most {} channels.</source>
      <translation>Eine Sitzung hat höchstens {} Kanäle.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/disk.py" />
      <source>{} exists already; a recording never overwrites.</source>
      <translation>{} gibt es schon; eine Aufnahme überschreibt nie.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/index.py" />
      <source>{} is not an MCAP file: its header is damaged.</source>
      <translation>{} ist keine MCAP-Datei: ihr Kopf ist beschädigt.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/ordering.py" />
      <source>{} cannot be read in order: its chunks all overlap.</source>
      <translation>{} lässt sich nicht der Reihe nach lesen: alle Stücke überlappen.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/records.py" />
      <source>{} is not an MCAP file.</source>
      <translation>{} ist keine MCAP-Datei.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/records.py" />
      <source>{} holds a record of {} bytes: it is damaged.</source>
      <translation>{} enthält einen Eintrag von {} Bytes: sie ist beschädigt.</translation>
    </message>
    <message>
      <location filename="tracker/session/mcap/records.py" />
      <source>There is no file {}.</source>
      <translation>Es gibt keine Datei {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/raw_imu.py" />
      <source>{} holds no samples of IMUs.</source>
      <translation>{} enthält keine Messwerte von IMUs.</translation>
    </message>
    <message>
      <location filename="tracker/session/reader.py" />
      <source>{} tells no stereo camera: {} missing.</source>
      <translation>{} beschreibt keine Stereokamera: {} fehlt.</translation>
    </message>
    <message>
      <location filename="tracker/session/reader.py" />
      <source>{} holds no {}: it was not recorded by Glovetrack, or only in part.</source>
      <translation>{} enthält kein {}: es wurde nicht von Glovetrack aufgenommen, oder nur zum Teil.</translation>
    </message>
    <message>
      <location filename="tracker/session/reader.py" />
      <source>{} says it began at an instant that no clock shows: its wall_clock_ns, its monotonic_ns or its first log time is out of range.</source>
      <translation>{} will zu einem Zeitpunkt begonnen haben, den keine Uhr zeigt: wall_clock_ns, monotonic_ns oder die erste Zeit liegen außerhalb.</translation>
    </message>
    <message>
      <location filename="tracker/session/reader.py" />
      <source>{} is a {} glove's.</source>
      <translation>{} gehört zu einem Handschuh für {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/reader.py" />
      <source>{} holds no {} of at most {} bytes.</source>
      <translation>{} enthält kein {} von höchstens {} Bytes.</translation>
    </message>
    <message>
      <location filename="tracker/session/recording/process.py" />
      <source>The recorder's process {}.{} You can record again at once.</source>
      <translation>Der Prozess des Aufnehmens {}.{} Es kann gleich wieder aufgenommen werden.</translation>
    </message>
    <message>
      <location filename="tracker/session/recover.py" />
      <source>{} holds nothing that can be recovered.</source>
      <translation>{} enthält nichts, was sich retten lässt.</translation>
    </message>
    <message>
      <location filename="tracker/session/ros/cdr.py" />
      <source>An instant lies outside the years 1901 to 2038, which ROS 2 can tell.</source>
      <translation>Ein Zeitpunkt liegt außerhalb der Jahre 1901 bis 2038, die ROS 2 nennen kann.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>Only {} GB are left on the disk of {}.</source>
      <translation>Auf der Festplatte von {1} sind nur noch {0} GB frei.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>The disk of {} is nearly full ({} are left), so nothing is recorded.</source>
      <translation>Die Festplatte von {} ist fast voll ({} sind frei), daher wird nichts aufgenommen.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>Compression can be {}, not {}.</source>
      <translation>Die Kompression kann {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>The JPEG quality is {}; it must lie in 1 to 100.</source>
      <translation>Die JPEG-Qualität ist {}; sie muss in 1 bis 100 liegen.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>The disk of {} is nearly full ({} are left), so nothing more is recorded; what was recorded is safe.</source>
      <translation>Die Festplatte von {} ist fast voll ({} sind frei), daher wird nichts mehr aufgenommen; was aufgenommen wurde, ist sicher.</translation>
    </message>
    <message>
      <location filename="tracker/session/writer.py" />
      <source>The recording {} has ended already.</source>
      <translation>Die Aufnahme {} ist schon zu Ende.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/connection.py" />
      <source>The {} {} has no port: clients find it by its name.</source>
      <translation>{} {} hat keinen Port: Programme finden es über seinen Namen.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/connection.py" />
      <source>{} is not a port for the {} {}: ports are 1 to 65535.</source>
      <translation>{} ist kein Port für {} {}: Ports sind 1 bis 65535.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/datagram.py" />
      <source>{}: ports are 1 to 65535.</source>
      <translation>{}: Anschlüsse sind 1 bis 65535.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/publisher.py" />
      <source>Joints can be {}, not {}.</source>
      <translation>Gelenke können {} sein, nicht {}.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/registry.py" />
      <source>{}: streams must be a table.</source>
      <translation>{}: streams muss eine Tabelle sein.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/registry.py" />
      <source>{}: streams.{} {}.</source>
      <translation>{}: streams.{} {}.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/registry.py" />
      <source>The {} stream made {} publishers for {} hands.</source>
      <translation>Der Stream {} hat {} Sender für {} Hände erstellt.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/remote/doors.py" />
      <source>The window did not answer, so nothing was done.</source>
      <translation>Das Fenster hat nicht geantwortet, es geschah also nichts.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/remote/doors.py" />
      <source>No remote control by {} at {}:{}: {}.</source>
      <translation>Keine Fernsteuerung über {} an {}:{}: {}.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/server_thread.py" />
      <source>No {} server at {}:{}: {}.</source>
      <translation>Kein {}-Server an {}:{}: {}.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/streams.py" />
      <source>The stream {} fails: {}.</source>
      <translation>Der Strom {} fällt aus: {}.</translation>
    </message>
    <message>
      <location filename="tracker/streaming/streams.py" />
      <source>The stream {} works again.</source>
      <translation>Der Strom {} geht wieder.</translation>
    </message>
    <message>
      <location filename="tracker/vision/detector.py" />
      <source>An image must be colour with 8 bits a channel; this one has shape {} and type {}.</source>
      <translation>Ein Bild muss farbig sein, mit 8 Bit je Kanal; dieses hat die Form {} und den Typ {}.</translation>
    </message>
    <message>
      <location filename="tracker/vision/hue_table.py" />
      <source>The colour profile {} has {} hues; at most {} can be told apart.</source>
      <translation>Das Farbprofil {} hat {} Farbtöne; höchstens {} lassen sich unterscheiden.</translation>
    </message>
    <message>
      <location filename="tracker/vision/lenses.py" />
      <source>There is only one camera, which counts as the left one.</source>
      <translation>Es gibt nur eine Kamera; sie gilt als die linke.</translation>
    </message>
    <message>
      <location filename="tracker/vision/rig.py" />
      <source>The stereo calibration has a baseline of {} mm: left and right are swapped, or this is no stereo pair.</source>
      <translation>Die Stereo-Kalibrierung hat eine Basis von {} mm: links und rechts sind vertauscht, oder dies ist kein Stereopaar.</translation>
    </message>
    <message>
      <location filename="tracker/vision/rig.py" />
      <source>The two rectified cameras must share one matrix P[:, :3].</source>
      <translation>Die beiden rektifizierten Kameras müssen eine Matrix P[:, :3] teilen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/arm/stream.py" />
      <source>That is no command for an arm: {}.</source>
      <translation>Das ist kein Befehl für einen Arm: {}.</translation>
    </message>
    <message>
      <location filename="extensions/applications/arm/stream.py" />
      <source>A robot is at host:port, not {}.</source>
      <translation>Ein Roboter ist unter host:port, nicht {}.</translation>
    </message>
    <message>
      <location filename="extensions/applications/swarm/vehicles.py" />
      <source>Vehicles are at host:port, such as 127.0.0.1:14550, not {}.</source>
      <translation>Fahrzeuge sind unter host:port, etwa 127.0.0.1:14550, nicht {}.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>{} is no mesh that can be read: .obj or .stl.</source>
      <translation>{} ist kein lesbares Netz: .obj oder .stl.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>{} holds no mesh: it takes four triangles to enclose anything.</source>
      <translation>{} enthält kein Netz: um etwas zu umschließen, braucht es vier Dreiecke.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>{} names points that it does not have, or that are nowhere.</source>
      <translation>{} nennt Punkte, die es nicht hat oder die nirgends sind.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>There is no mesh {}; a file is told with its ending.</source>
      <translation>Es gibt kein Netz {}; eine Datei wird mit ihrer Endung genannt.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>{} is no OBJ file: {}.</source>
      <translation>{} ist keine OBJ-Datei: {}.</translation>
    </message>
    <message>
      <location filename="extensions/applications/touch/meshes.py" />
      <source>{} is no STL file: {}.</source>
      <translation>{} ist keine STL-Datei: {}.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/c3d.py" />
      <source>{} could not be written as a whole: the disk may be full.</source>
      <translation>{} konnte nicht ganz geschrieben werden: die Festplatte ist vielleicht voll.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/film.py" />
      <source>There is no ffmpeg with H.264 on this computer: the film is MPEG-4 part 2, which browsers and some players do not show.</source>
      <translation>Auf diesem Rechner gibt es kein ffmpeg mit H.264: der Film ist MPEG-4 Teil 2, den Browser und manche Abspieler nicht zeigen.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/film.py" />
      <source>OpenCV on this computer cannot write {}.</source>
      <translation>OpenCV kann auf diesem Rechner {} nicht schreiben.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/film.py" />
      <source>{} could not be written by ffmpeg.</source>
      <translation>{} konnte von ffmpeg nicht geschrieben werden.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/overlay.py" />
      <source>{} holds no images of the tracked time.</source>
      <translation>{} enthält keine Bilder der getrackten Zeit.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/skeleton.py" />
      <source>A bone was never seen with both its ends, so there is no skeleton.</source>
      <translation>Ein Knochen wurde nie mit beiden Enden gesehen, also gibt es kein Skelett.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/skeleton.py" />
      <source>A skeleton needs the wrist; export all joints.</source>
      <translation>Ein Skelett braucht das Handgelenk; alle Gelenke exportieren.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/skeleton.py" />
      <source>{} was never tracked, so there is no skeleton.</source>
      <translation>{} wurde nie getrackt, also gibt es kein Skelett.</translation>
    </message>
    <message>
      <location filename="extensions/interchange/urdf.py" />
      <source>A URDF has right-handed axes; {} has left-handed ones.</source>
      <translation>Eine URDF-Datei hat rechtshändige Achsen; {} hat linkshändige.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/film.py" />
      <source>Films need {}, which this computer has not; take the images as recorded.</source>
      <translation>Filme brauchen {}, das dieser Rechner nicht hat; die Bilder nehmen, wie sie aufgenommen sind.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/film.py" />
      <source>{} could not be made by {}: {}.</source>
      <translation>{} konnte von {} nicht erzeugt werden: {}.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/images.py" />
      <source>The images of camera {} are not all of one size: a data set wants that. Export it with --images none.</source>
      <translation>Die Bilder der Kamera {} sind nicht alle gleich groß: ein Datensatz verlangt das. Mit --images none exportieren.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/images.py" />
      <source>{} has a part without images of camera {}.</source>
      <translation>{} hat einen Teil ohne Bilder der Kamera {}.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/plan.py" />
      <source>Move the hand.</source>
      <translation>Die Hand bewegen.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/plan.py" />
      <source>There is no episode: parts between notes need two frames at least.</source>
      <translation>Es gibt keine Episode: Teile zwischen Notizen brauchen mindestens zwei Zeitschritte.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/plan.py" />
      <source>LeRobot counts whole frames a second; {} Hz is none.</source>
      <translation>LeRobot zählt ganze Zeitschritte je Sekunde; {} Hz ist kein solcher Wert.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/plan.py" />
      <source>{} has images of camera {} that are no JPEG or PNG.</source>
      <translation>{} hat Bilder der Kamera {}, die weder JPEG noch PNG sind.</translation>
    </message>
    <message>
      <location filename="extensions/lerobot/stats.py" />
      <source>An image is damaged.</source>
      <translation>Ein Bild ist beschädigt.</translation>
    </message>
    <message>
      <location filename="extensions/robot/anatomy.py" />
      <source>The robot hand's fingers are not found: their bodies are to be named thumb (or th), index (ff), middle (mf), ring (rf) and little (lf).</source>
      <translation>Die Finger der Roboterhand wurden nicht gefunden: ihre Körper sollen thumb (oder th), index (ff), middle (mf), ring (rf) und little (lf) heißen.</translation>
    </message>
    <message>
      <location filename="extensions/robot/anatomy.py" />
      <source>The robot hand's fingers have no palm in common.</source>
      <translation>Die Finger der Roboterhand haben keine gemeinsame Handfläche.</translation>
    </message>
    <message>
      <location filename="extensions/robot/anatomy.py" />
      <source>The robot hand's {} has no tip: a site named tip, or a geom.</source>
      <translation>{} der Roboterhand hat keine Spitze: eine site namens tip oder ein geom.</translation>
    </message>
    <message>
      <location filename="extensions/robot/command.py" />
      <source>A robot is asked {}, not {}.</source>
      <translation>Ein Roboter wird um {} gebeten, nicht um {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/hand.py" />
      <source>The robot hand {} is larger than {} bytes.</source>
      <translation>Die Roboterhand {} ist größer als {} Byte.</translation>
    </message>
    <message>
      <location filename="extensions/robot/library.py" />
      <source>There is no robot hand {}: it is {} or a file of MJCF.</source>
      <translation>Es gibt keine Roboterhand {}: es ist {} oder eine MJCF-Datei.</translation>
    </message>
    <message>
      <location filename="extensions/robot/mirror.py" />
      <source>The robot hand cannot be mirrored: it has {}.</source>
      <translation>Die Roboterhand lässt sich nicht spiegeln: sie hat {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/process.py" />
      <source>The recorded robot is another one than its model says.</source>
      <translation>Der aufgenommene Roboter ist ein anderer, als sein Modell sagt.</translation>
    </message>
    <message>
      <location filename="extensions/robot/process.py" />
      <source>The robot's process has ended.</source>
      <translation>Der Prozess des Roboters ist zu Ende.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>A hand is right or left, not {}.</source>
      <translation>Eine Hand ist rechts oder links, nicht {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>The clutch is {}, not {}.</source>
      <translation>Die Kupplung ist {}, nicht {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>Objects are {}, not {}.</source>
      <translation>Gegenstände sind {}, nicht {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>The motion is scaled by 0.1 to 10, the reach by 0.5 to 2.</source>
      <translation>Die Bewegung wird mit 0.1 bis 10 skaliert, die Reichweite mit 0.5 bis 2.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>A robot's speeds are greater than zero.</source>
      <translation>Die Geschwindigkeiten eines Roboters sind größer als null.</translation>
    </message>
    <message>
      <location filename="extensions/robot/settings.py" />
      <source>What the session says of its robot is damaged.</source>
      <translation>Was die Sitzung über ihren Roboter sagt, ist beschädigt.</translation>
    </message>
    <message>
      <location filename="extensions/robot/teleop.py" />
      <source>The recorded robot is another one: {}.</source>
      <translation>Der aufgenommene Roboter ist ein anderer: {}.</translation>
    </message>
  </context>
</TS>