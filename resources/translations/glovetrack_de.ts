<?xml version='1.0' encoding='utf-8'?>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>glovetrack</name>
    <message>
      <location filename="app/engines/demo.py" />
      <source>The hand is tracked by its IMUs alone, so its position is unknown.</source>
      <translation>Die Hand wird nur mit ihren IMUs getrackt, daher ist ihre Position unbekannt.</translation>
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
      <location filename="app/engines/engine_host.py" />
      <source>{} was not opened, because a recording has begun.</source>
      <translation>{} wurde nicht geöffnet, weil eine Aufnahme begonnen hat.</translation>
    </message>
    <message>
      <location filename="app/engines/engine_host.py" />
      <source>Tracking has stopped. {} Start it again.</source>
      <translation>Das Tracking wurde beendet. {} Starten Sie es neu.</translation>
    </message>
    <message>
      <location filename="app/engines/engine_host.py" />
      <source>Tracking has stopped. {} It starts again.</source>
      <translation>Das Tracking wurde beendet. {} Es startet erneut.</translation>
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
      <source>Glove {} at {} is new. Choose its hand under Set-up, Glove.</source>
      <translation>Handschuh {} an {} ist neu. Seine Hand unter Einrichtung, Handschuh wählen.</translation>
    </message>
    <message>
      <location filename="app/engines/found_gloves.py" />
      <source>Glove {} at {} is not used: there is already a glove for the {} hand.</source>
      <translation>Handschuh {} an {} wird nicht verwendet: Für diese Hand ({}) gibt es bereits einen Handschuh.</translation>
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
      <source>{} is still being written. Wait until it is finished, then record again.</source>
      <translation>{} wird noch geschrieben. Warten, bis das abgeschlossen ist, dann erneut aufnehmen.</translation>
    </message>
    <message>
      <location filename="app/engines/recording.py" />
      <source>The recording could not be finished: {}</source>
      <translation>Die Aufnahme konnte nicht abgeschlossen werden: {}</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>waiting</source>
      <translation>wartet</translation>
    </message>
    <message>
      <location filename="app/jobs/export.py" />
      <source>running</source>
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
      <translation>fehlgeschlagen</translation>
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
      <location filename="app/jobs/motor_test.py" />
      <source>Motor {} shakes the IMUs (standard deviation):</source>
      <translation>Motor {} erschüttert die IMUs (Standardabweichung):</translation>
    </message>
    <message>
      <location filename="app/jobs/motor_test.py" />
      <source>{}: {} g, {} °/s</source>
      <translation>{}: {} g, {} °/s</translation>
    </message>
    <message>
      <location filename="app/jobs/offline_tracking.py" />
      <source>comparing</source>
      <translation>Vergleich</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The sphere was not placed: the index fingertip is not visible.</source>
      <translation>Die Kugel wurde nicht gesetzt: Die Spitze des Zeigefingers ist nicht sichtbar.</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Testing {}</source>
      <translation>{} wird getestet</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>The stream {} is running.</source>
      <translation>Der Datenstrom {} läuft.</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Opening {}</source>
      <translation>{} wird geöffnet</translation>
    </message>
    <message>
      <location filename="app/jobs/outputs.py" />
      <source>Closing {}</source>
      <translation>{} wird geschlossen</translation>
    </message>
    <message>
      <location filename="app/jobs/plugged.py" />
      <source>Looking for devices</source>
      <translation>Geräte werden gesucht</translation>
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control over {}</source>
      <translation>Fernsteuerung über {}</translation>
    </message>
    <message>
      <location filename="app/jobs/remote.py" />
      <source>Remote control over {} is open.</source>
      <translation>Die Fernsteuerung über {} ist offen.</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Delay of the image time stamps, estimated from the motion of the hand and its gyroscope</source>
      <translation>Verzögerung der Bildzeitstempel, geschätzt aus der Bewegung der Hand und ihrem Gyroskop</translation>
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
      <source>Start tracking to see the estimated parameters.</source>
      <translation>Tracking starten, um die geschätzten Parameter zu sehen.</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Segment</source>
      <translation>Segment</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Scale ± 2σ</source>
      <translation>Skala ± 2σ</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Mounting</source>
      <translation>Einbaulage</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Gyro bias</source>
      <translation>Gyro-Bias</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/panel.py" />
      <source>Accel. bias</source>
      <translation>Beschl.-Bias</translation>
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
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>From the crease of the wrist to the tip of the middle finger, mm</source>
      <translation>Von der Falte des Handgelenks bis zur Spitze des Mittelfingers, mm</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Wearer of the glove</source>
      <translation>Träger des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Freeze</source>
      <translation>Einfrieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Stop updating the calibration; tracking continues</source>
      <translation>Kalibrierung nicht weiter anpassen; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Compare</source>
      <translation>Vergleichen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Show the changes since the last fit</source>
      <translation>Änderungen seit der letzten Anpassung zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save</source>
      <translation>Speichern</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Save the calibration</source>
      <translation>Kalibrierung speichern</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Reset</source>
      <translation>Zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Discard the calibration</source>
      <translation>Kalibrierung verwerfen</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Import…</source>
      <translation>Importieren…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Import a calibration profile from a file</source>
      <translation>Kalibrierungsprofil aus einer Datei importieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Export…</source>
      <translation>Exportieren…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Export the calibration as a text file</source>
      <translation>Kalibrierung als Textdatei exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Guided poses…</source>
      <translation>Geführte Posen…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Calibrate your fingers and thumb with half a minute of guided poses</source>
      <translation>Finger und Daumen mit einer halben Minute geführter Posen kalibrieren</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Hand length…</source>
      <translation>Handlänge…</translation>
    </message>
    <message>
      <location filename="app/panels/calibration/wearer_row.py" />
      <source>Enter the measured length: a single camera cannot determine the size of the hand</source>
      <translation>Gemessene Länge eingeben: Eine einzelne Kamera kann die Größe der Hand nicht bestimmen</translation>
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
      <source>New wearer</source>
      <translation>Neuer Träger</translation>
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
      <source>Choose what is drawn over the images</source>
      <translation>Wählen, was über die Bilder gezeichnet wird</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Masks</source>
      <translation>Masken</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Show the pixels of each marker colour; each colour has its own switch</source>
      <translation>Pixel jeder Markerfarbe zeigen; jede Farbe hat einen eigenen Schalter</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Follow hand</source>
      <translation>Hand folgen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Zoom both images to the hand</source>
      <translation>Beide Bilder auf die Hand vergrößern</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Freeze the images; tracking continues</source>
      <translation>Bilder einfrieren; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Cameras shown</source>
      <translation>Gezeigte Kameras</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Lock exposure, gain and white balance; choose the camera</source>
      <translation>Belichtung, Verstärkung und Weißabgleich sperren; Kamera wählen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>No camera</source>
      <translation>Keine Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Blobs</source>
      <translation>Flecken</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>A ring around each blob; dashed if no marker is assigned to it</source>
      <translation>Ein Ring um jeden Fleck; gestrichelt, wenn ihm kein Marker zugeordnet ist</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Pairs</source>
      <translation>Paare</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Filled rings: markers matched in both images</source>
      <translation>Gefüllte Ringe: in beiden Bildern zugeordnete Marker</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Rejected</source>
      <translation>Verworfen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Regions of the right colour but the wrong shape, with the reason</source>
      <translation>Bereiche mit richtiger Farbe, aber falscher Form, mit Begründung</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Predicted</source>
      <translation>Vorhersage</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Predicted marker positions, with ids and 2σ ellipses</source>
      <translation>Vorhergesagte Markerpositionen mit Nummern und 2σ-Ellipsen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Residuals</source>
      <translation>Residuen</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Lines from the predicted positions to the blobs</source>
      <translation>Linien von den vorhergesagten Positionen zu den Flecken</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>Skeleton</source>
      <translation>Skelett</translation>
    </message>
    <message>
      <location filename="app/panels/cameras.py" />
      <source>The tracked hand</source>
      <translation>Die getrackte Hand</translation>
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
      <source>Measuring the light</source>
      <translation>Licht wird gemessen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Fitting the colours</source>
      <translation>Farben werden angepasst</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Collecting images. Hold the hand in view, or play the replay.</source>
      <translation>Bilder werden gesammelt. Hand ins Bild halten oder die Wiedergabe abspielen.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Show missed markers in the image</source>
      <translation>Übersehene Marker im Bild zeigen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Light</source>
      <translation>Licht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/fitting.py" />
      <source>Lighting problems that hide markers, and how to fix them</source>
      <translation>Beleuchtungsprobleme, die Marker verbergen, und ihre Abhilfe</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Restored the initial colours of this session.</source>
      <translation>Die anfänglichen Farben dieser Sitzung sind wiederhergestellt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Restored the factory colours.</source>
      <translation>Die mitgelieferten Farben sind wiederhergestellt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Mask</source>
      <translation>Maske</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Searching the image</source>
      <translation>Bild wird durchsucht</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>The factory colours do not match this glove.</source>
      <translation>Die mitgelieferten Farben passen nicht zu diesem Handschuh.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/panel.py" />
      <source>Mask, image frozen</source>
      <translation>Maske, Bild angehalten</translation>
    </message>
    <message>
      <location filename="app/panels/colours/ranges.py" />
      <source>Histogram of hues</source>
      <translation>Histogramm der Farbtöne</translation>
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
      <source>Storing an image</source>
      <translation>Bild wird gespeichert</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Opening an image</source>
      <translation>Bild wird geöffnet</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Saving an image</source>
      <translation>Bild wird gespeichert</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Image used for tuning</source>
      <translation>Bild zum Einstellen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Live image</source>
      <translation>Livebild</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Freeze the image; tracking continues</source>
      <translation>Bild einfrieren; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Store</source>
      <translation>Speichern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Store this image for later</source>
      <translation>Dieses Bild für später speichern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>More image commands</source>
      <translation>Weitere Befehle für Bilder</translation>
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
      <source>Open an image</source>
      <translation>Bild öffnen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Save this image</source>
      <translation>Dieses Bild speichern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be stored.</source>
      <translation>Es gibt noch kein Bild, das gespeichert werden könnte.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>There is no image yet that could be saved.</source>
      <translation>Es gibt noch kein Bild, das gespeichert werden könnte.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>Select a stored image first. The live image cannot be removed.</source>
      <translation>Zuerst ein gespeichertes Bild auswählen. Das Livebild kann nicht entfernt werden.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/source.py" />
      <source>The image {} was removed.</source>
      <translation>Das Bild {} wurde entfernt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Colour profile</source>
      <translation>Farbprofil</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Export the colours</source>
      <translation>Farben exportieren</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick =</source>
      <translation>Wählen =</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: click a marker to set the ranges of the selected hue to its colour</source>
      <translation>Pipette: Marker anklicken, um die Bereiche des gewählten Farbtons auf seine Farbe zu setzen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick +</source>
      <translation>Pipette +</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: click a pixel to include it in the ranges, Ctrl+click to exclude it. Once a marker of each colour has been clicked, the colours are learned.</source>
      <translation>Pipette: Pixel anklicken, um es in die Bereiche aufzunehmen, Strg+Klick schließt es aus. Sobald ein Marker jeder Farbe angeklickt ist, werden die Farben gelernt.</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Pick −</source>
      <translation>Pipette −</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Eyedropper: click a pixel to exclude it from the ranges</source>
      <translation>Pipette: Pixel anklicken, um es aus den Bereichen auszuschließen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Fit</source>
      <translation>Anpassen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From live images</source>
      <translation>Aus Livebildern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Hold the hand in view: the IMUs help to find it in any light</source>
      <translation>Hand ins Bild halten: Die IMUs helfen, sie bei jedem Licht zu finden</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From this image only</source>
      <translation>Nur aus diesem Bild</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Searches the image for a group of patches in the glove's colours</source>
      <translation>Sucht im Bild eine Gruppe von Flicken in den Farben des Handschuhs</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>From the tracked markers</source>
      <translation>Aus den getrackten Markern</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Measures the colours of the markers that are tracked</source>
      <translation>Misst die Farben der getrackten Marker</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Check the background</source>
      <translation>Hintergrund prüfen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Move the hand out of the image first</source>
      <translation>Zuerst die Hand aus dem Bild nehmen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Profile</source>
      <translation>Profil</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Copy from another camera</source>
      <translation>Von anderer Kamera kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Restore the initial colours</source>
      <translation>Anfängliche Farben wiederherstellen</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>The colours at the start of this session</source>
      <translation>Die Farben zu Beginn dieser Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>Factory colours</source>
      <translation>Werksfarben</translation>
    </message>
    <message>
      <location filename="app/panels/colours/tools.py" />
      <source>The colours shipped with Glovetrack</source>
      <translation>Die mit Glovetrack gelieferten Farben</translation>
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
      <source>{}: the value {} is not possible ({}).</source>
      <translation>{}: Der Wert {} ist nicht möglich ({}).</translation>
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
      <source>changed, not applied</source>
      <translation>geändert, nicht angewendet</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>The motor was not run: the glove is disconnected.</source>
      <translation>Der Motor lief nicht: Der Handschuh ist getrennt.</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Setting</source>
      <translation>Einstellung</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Current value</source>
      <translation>Aktueller Wert</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>State</source>
      <translation>Zustand</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Run</source>
      <translation>Ausführen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>Run this motor for 0.8 s and measure its vibration</source>
      <translation>Diesen Motor 0,8 s laufen lassen und sein Vibrieren messen</translation>
    </message>
    <message>
      <location filename="app/panels/devices/panel.py" />
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Save these graphs…</source>
      <translation>Diese Diagramme speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Delete a layout…</source>
      <translation>Layout löschen…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Save these graphs</source>
      <translation>Diese Diagramme speichern</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Name of the layout</source>
      <translation>Name des Layouts</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Delete a layout</source>
      <translation>Layout löschen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Layout</source>
      <translation>Layout</translation>
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
      <translation>Layouts</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Reading the recording's signals</source>
      <translation>Signale der Aufnahme werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/panel.py" />
      <source>Reading the whole recording…</source>
      <translation>Ganze Aufnahme wird gelesen…</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Fit both axes to the curves (double-click the graph)</source>
      <translation>Beide Achsen an die Kurven anpassen (Doppelklick auf das Diagramm)</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Time window</source>
      <translation>Zeitfenster</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Pause this graph; tracking continues</source>
      <translation>Dieses Diagramm anhalten; das Tracking läuft weiter</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Copy the visible data as CSV</source>
      <translation>Sichtbare Daten als CSV kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Remove this graph</source>
      <translation>Dieses Diagramm entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>not available</source>
      <translation>nicht verfügbar</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Whole recording</source>
      <translation>Ganze Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/plot.py" />
      <source>Tick signals in the tree, or drag them here.</source>
      <translation>Signale im Baum ankreuzen oder hierher ziehen.</translation>
    </message>
    <message>
      <location filename="app/panels/graphs/stack.py" />
      <source>Copied {} rows of {} curves as CSV.</source>
      <translation>{} Zeilen von {} Kurven als CSV kopiert.</translation>
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
      <translation>Handfläche</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Side</source>
      <translation>Seite</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Reference hand</source>
      <translation>Referenzhand</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Outline of a reference hand: the true pose of the simulated hand, the second tracking of a replay, or another engine on the same data</source>
      <translation>Umriss einer Referenzhand: wahre Pose der simulierten Hand, zweites Tracking einer Wiedergabe oder ein anderes Verfahren mit denselben Daten</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>No reference</source>
      <translation>Keine Referenz</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Fingertip trail</source>
      <translation>Spur der Fingerspitze</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Path of a fingertip over the last three seconds</source>
      <translation>Weg einer Fingerspitze in den letzten drei Sekunden</translation>
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
      <source>Preparing the 3D view</source>
      <translation>3D-Ansicht wird vorbereitet</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>View from this side</source>
      <translation>Ansicht von dieser Seite</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Markers</source>
      <translation>Marker</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Large: visible now. Small: visible recently. Ring: never seen</source>
      <translation>Groß: jetzt sichtbar. Klein: kürzlich sichtbar. Ring: nie gesehen</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>2σ</source>
      <translation>2σ</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>A ring of two standard deviations around each fingertip; dashed at the maximum of 15 mm</source>
      <translation>Ein Ring von zwei Standardabweichungen um jede Fingerspitze; gestrichelt beim Höchstwert von 15 mm</translation>
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
      <source>The graphics driver crashed the program last time, so the 3D view uses software rendering. To try the graphics card again, choose it in the View menu.</source>
      <translation>Der Grafiktreiber hat das Programm beim letzten Mal zum Absturz gebracht, daher wird die 3D-Ansicht per Software gezeichnet. Um die Grafikkarte erneut zu versuchen, sie im Menü Ansicht wählen.</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>Rendering on the graphics card is not part of this installation. The 3D view uses software rendering.</source>
      <translation>Das Zeichnen auf der Grafikkarte gehört nicht zu dieser Installation. Die 3D-Ansicht wird per Software gezeichnet.</translation>
    </message>
    <message>
      <location filename="app/panels/hand/controls.py" />
      <source>The 3D view cannot use the graphics card and uses software rendering.</source>
      <translation>Die 3D-Ansicht kann die Grafikkarte nicht nutzen und wird per Software gezeichnet.</translation>
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
      <source>Generating the hand mesh</source>
      <translation>Handmodell wird erzeugt</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Current gestures and their strength</source>
      <translation>Aktuelle Gesten und ihre Ausprägung</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>laboratory</source>
      <translation>Labor</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>truth</source>
      <translation>Wahrheit</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Not tracked yet. Choose Replay, Track again.</source>
      <translation>Noch kein Tracking. Wiedergabe, Tracking wiederholen wählen.</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>No hand yet</source>
      <translation>Noch keine Hand</translation>
    </message>
    <message>
      <location filename="app/panels/hand/panel.py" />
      <source>Generating the hand mesh…</source>
      <translation>Handmodell wird erzeugt …</translation>
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
      <location filename="app/panels/library/comparing.py" />
      <source>Reading two recordings</source>
      <translation>Zwei Aufnahmen werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Comparison of two trackings</source>
      <translation>Vergleich zweier Trackings</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Copy</source>
      <translation>Kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Comparing</source>
      <translation>Vergleich läuft</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Difference</source>
      <translation>Unterschied</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Tracking {} again</source>
      <translation>Tracking von {} wird wiederholt</translation>
    </message>
    <message>
      <location filename="app/panels/library/comparing.py" />
      <source>Error of {}</source>
      <translation>Fehler von {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Preset</source>
      <translation>Vorgabe</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Save these formats and options</source>
      <translation>Diese Formate und Optionen speichern</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Name of the preset</source>
      <translation>Name der Vorgabe</translation>
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
      <source>One sentence that describes the task; default: the notes</source>
      <translation>Ein Satz, der die Aufgabe beschreibt; Vorgabe: die Notizen</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>The task of a data set's episodes, for robot learning</source>
      <translation>Die Aufgabe der Episoden eines Datensatzes, für das Lernen von Robotern</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>one episode per note</source>
      <translation>eine Episode je Notiz</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>default of the format</source>
      <translation>Vorgabe des Formats</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Change…</source>
      <translation>Ändern…</translation>
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
      <source>none (options below)</source>
      <translation>keine (Optionen unten)</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_dialog.py" />
      <source>Restore the preset {}</source>
      <translation>Voreinstellung {} wiederherstellen</translation>
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
      <source>File</source>
      <translation>Datei</translation>
    </message>
    <message>
      <location filename="app/panels/library/export_list.py" />
      <source>Progress</source>
      <translation>Fortschritt</translation>
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
      <source>Interpolate the selected gaps in a new file, in which they are marked; the original recording is not changed</source>
      <translation>Ausgewählte Lücken in einer neuen Datei interpolieren, in der sie gekennzeichnet sind; die Originalaufnahme bleibt unverändert</translation>
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
      <source>Finding gaps</source>
      <translation>Lücken werden gesucht</translation>
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
      <source>Replay a recording to list its gaps.</source>
      <translation>Eine Aufnahme wiedergeben, um ihre Lücken aufzulisten.</translation>
    </message>
    <message>
      <location filename="app/panels/library/gap_page.py" />
      <source>Filling gaps in {}</source>
      <translation>Lücken in {} werden gefüllt</translation>
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
      <source>Mark a range first: press I at its start and O at its end.</source>
      <translation>Zuerst einen Bereich markieren: I am Anfang und O am Ende drücken.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Reading the library</source>
      <translation>Bibliothek wird gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Reading session details</source>
      <translation>Angaben zur Sitzung werden gelesen</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Select a session in the library to export it.</source>
      <translation>Eine Sitzung in der Bibliothek auswählen, um sie zu exportieren.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Select a session in the library to track it again.</source>
      <translation>Eine Sitzung in der Bibliothek auswählen, um ihr Tracking zu wiederholen.</translation>
    </message>
    <message>
      <location filename="app/panels/library/panel.py" />
      <source>Select two sessions in the library.</source>
      <translation>Zwei Sitzungen in der Bibliothek auswählen.</translation>
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
      <source>Tags, separated by commas</source>
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
      <source>{} contains the selected {} of {}.</source>
      <translation>{} enthält die ausgewählten {} von {}.</translation>
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
      <source>Select two sessions of the same movement</source>
      <translation>Zwei Sitzungen derselben Bewegung auswählen</translation>
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
      <source>Two recordings side by side</source>
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
      <source>Move to trash</source>
      <translation>In den Papierkorb verschieben</translation>
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
      <location filename="app/panels/library/track_dialog.py" />
      <source>default</source>
      <translation>Vorgabe</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>use the whole session for every estimate (chain)</source>
      <translation>für jede Schätzung die ganze Sitzung verwenden (chain)</translation>
    </message>
    <message>
      <location filename="app/panels/library/track_dialog.py" />
      <source>Tracks the recorded sensor data again and saves the result as a new session in the same folder. Both sessions are then shown together and compared.</source>
      <translation>Wiederholt das Tracking mit den aufgezeichneten Sensordaten und speichert das Ergebnis als neue Sitzung im selben Ordner. Beide Sitzungen werden dann zusammen gezeigt und verglichen.</translation>
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
      <source>Return to live tracking (Ctrl+L)</source>
      <translation>Zurück zum Live-Tracking (Strg+L)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>A filled gap: interpolated, not measured</source>
      <translation>Gefüllte Lücke: interpoliert, nicht gemessen</translation>
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
      <source>Previous image (,)</source>
      <translation>Voriges Bild (,)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Next image (.)</source>
      <translation>Nächstes Bild (.)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Previous note (Ctrl+,)</source>
      <translation>Vorige Notiz (Strg+,)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Next note (Ctrl+.)</source>
      <translation>Nächste Notiz (Strg+.)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>In</source>
      <translation>Anfang</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Set the start of the range (I)</source>
      <translation>Anfang des Bereichs setzen (I)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Out</source>
      <translation>Ende</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Set the end of the range (O)</source>
      <translation>Ende des Bereichs setzen (O)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Whole</source>
      <translation>Ganz</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Clear the range</source>
      <translation>Bereich aufheben</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Loop</source>
      <translation>Schleife</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Repeat the range (L)</source>
      <translation>Bereich wiederholen (L)</translation>
    </message>
    <message>
      <location filename="app/panels/library/transport.py" />
      <source>Play</source>
      <translation>Abspielen</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>No image here</source>
      <translation>Hier ist kein Bild</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>{} Correlation {:.2f}; at most {:.2f} elsewhere.</source>
      <translation>{} Korrelation {:.2f}; sonst höchstens {:.2f}.</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Reading images</source>
      <translation>Bilder werden gelesen</translation>
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
      <source>Second recording starts at</source>
      <translation>Zweite Aufnahme beginnt bei</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>By clock</source>
      <translation>Nach Uhrzeit</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Align the recordings by the computers' clocks</source>
      <translation>Aufnahmen nach den Uhren der Rechner ausrichten</translation>
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
      <source>Align the recordings by the best match of their joint angles</source>
      <translation>Aufnahmen nach der besten Übereinstimmung ihrer Gelenkwinkel ausrichten</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Keep</source>
      <translation>Behalten</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Save this alignment; compare --align uses it, too</source>
      <translation>Diese Ausrichtung speichern; compare --align verwendet sie ebenfalls</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>The recordings have no joint angle in common.</source>
      <translation>Die Aufnahmen haben keinen Gelenkwinkel gemeinsam.</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>{} and {}</source>
      <translation>{} und {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>s from the start of {}</source>
      <translation>s ab Beginn von {}</translation>
    </message>
    <message>
      <location filename="app/panels/library/two_recordings_dialog.py" />
      <source>Saved to {}.</source>
      <translation>In {} gespeichert.</translation>
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
      <location filename="app/panels/motion/panel.py" />
      <source>Measuring the recording</source>
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
      <source>Angles and distances</source>
      <translation>Winkel und Abstände</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distance from</source>
      <translation>Abstand von</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distance to</source>
      <translation>Abstand zu</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Add this distance</source>
      <translation>Diesen Abstand hinzufügen</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Remove the selected distances</source>
      <translation>Ausgewählte Abstände entfernen</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Unit of angles</source>
      <translation>Einheit der Winkel</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Degrees</source>
      <translation>Grad</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Radians</source>
      <translation>Radiant</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Copy the table</source>
      <translation>Tabelle kopieren</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Save as CSV…</source>
      <translation>Als CSV speichern…</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Angle or distance</source>
      <translation>Winkel oder Abstand</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Now</source>
      <translation>Jetzt</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Position in range</source>
      <translation>Lage im Bereich</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Minimum</source>
      <translation>Minimum</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Maximum</source>
      <translation>Maximum</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Range</source>
      <translation>Umfang</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Peak speed / s</source>
      <translation>Höchstgeschwindigkeit / s</translation>
    </message>
    <message>
      <location filename="app/panels/motion/panel.py" />
      <source>Distances removed: {}.</source>
      <translation>Abstände entfernt: {}.</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Notes of this recording</source>
      <translation>Notizen dieser Aufnahme</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Double-click a note to edit it; press Delete to remove it</source>
      <translation>Notiz doppelklicken, um sie zu ändern; Entf löscht sie</translation>
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
      <source>May contain {participant}, {task}, {date}, {time} and a counter: {n} or {n:03}</source>
      <translation>Kann {participant}, {task}, {date}, {time} und einen Zähler enthalten: {n} oder {n:03}</translation>
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
      <source>At</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Note</source>
      <translation>Notiz</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>none</source>
      <translation>keines</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Recording stopped: the disk is nearly full.</source>
      <translation>Aufnahme beendet: Die Festplatte ist fast voll.</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>Not now ({})</source>
      <translation>Nicht jetzt ({})</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>The note “{}” was deleted.</source>
      <translation>Die Notiz „{}“ wurde gelöscht.</translation>
    </message>
    <message>
      <location filename="app/panels/recording.py" />
      <source>{} s</source>
      <translation>{} s</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Remote control: other programs start and stop recordings and add notes</source>
      <translation>Fernsteuerung: Andere Programme starten und beenden Aufnahmen und fügen Notizen hinzu</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Anyone on the network can start and stop recordings at this address. There is no password.</source>
      <translation>Jeder im Netzwerk kann an dieser Adresse Aufnahmen starten und beenden. Es gibt kein Passwort.</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>127.0.0.1: this computer only. 0.0.0.0: all networks of this computer</source>
      <translation>127.0.0.1: nur dieser Rechner. 0.0.0.0: alle Netzwerke dieses Rechners</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Listen on</source>
      <translation>Lauschen an</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Options…</source>
      <translation>Optionen…</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Protocol</source>
      <translation>Protokoll</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Port</source>
      <translation>Port</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Clients</source>
      <translation>Clients</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Requests</source>
      <translation>Anfragen</translation>
    </message>
    <message>
      <location filename="app/panels/remote.py" />
      <source>Options of {}</source>
      <translation>Optionen von {}</translation>
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
      <source>Pause the curves; tracking continues</source>
      <translation>Kurven anhalten; das Tracking läuft weiter</translation>
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
      <source>The recording {} was interrupted. Its contents can be recovered.</source>
      <translation>Die Aufnahme {} wurde unterbrochen. Ihr Inhalt lässt sich wiederherstellen.</translation>
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
      <source>Try Glovetrack with a simulated glove and camera. No hardware needed.</source>
      <translation>Glovetrack mit simuliertem Handschuh und simulierter Kamera ausprobieren. Ohne Hardware.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Glove and camera</source>
      <translation>Handschuh und Kamera</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Connect your devices and set them up step by step.</source>
      <translation>Geräte anschließen und Schritt für Schritt einrichten.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Recorded session</source>
      <translation>Aufgenommene Sitzung</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>Replay a session file, review it frame by frame, and export it.</source>
      <translation>Eine Sitzungsdatei wiedergeben, Bild für Bild sichten und exportieren.</translation>
    </message>
    <message>
      <location filename="app/panels/start_page.py" />
      <source>{} more are in the library.</source>
      <translation>{} weitere sind in der Bibliothek.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Thumb</source>
      <translation>Daumen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Index</source>
      <translation>Zeigefinger</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Middle</source>
      <translation>Mittelfinger</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Ring</source>
      <translation>Ringfinger</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Little</source>
      <translation>Kleiner Finger</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>UDP and VMC send to this address, servers listen on it; 127.0.0.1 is this computer only</source>
      <translation>UDP und VMC senden an diese Adresse, Server lauschen an ihr; 127.0.0.1 ist nur dieser Rechner</translation>
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
      <source>The joints in the streams: Glovetrack's 21, or the 26 of OpenXR in its axes</source>
      <translation>Gelenke in den Datenströmen: die 21 von Glovetrack oder die 26 von OpenXR in dessen Achsen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Test</source>
      <translation>Testen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Vibration motors: press one to test it</source>
      <translation>Vibrationsmotoren: zum Testen drücken</translation>
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
      <source>Place it at the index fingertip</source>
      <translation>An die Spitze des Zeigefingers setzen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>The sphere has not been placed yet.</source>
      <translation>Die Kugel ist noch nicht gesetzt.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>File of {}</source>
      <translation>Datei für {}</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Glovetrack joints</source>
      <translation>Gelenke von Glovetrack</translation>
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
      <source>The sphere is at {:.0f}, {:.0f}, {:.0f} mm.</source>
      <translation>Die Kugel ist bei {:.0f}, {:.0f}, {:.0f} mm.</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Hand records (*{})</source>
      <translation>Handaufzeichnungen (*{})</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>{}; a number is added if the file exists</source>
      <translation>{}; eine Nummer wird angehängt, wenn die Datei existiert</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Whether a program receives {}</source>
      <translation>Ob ein Programm {} empfängt</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Test {}</source>
      <translation>{} testen</translation>
    </message>
    <message>
      <location filename="app/panels/streams.py" />
      <source>Motor {}</source>
      <translation>Motor {}</translation>
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
      <source>current rates, latencies and losses</source>
      <translation>aktuelle Raten, Latenzen und Verluste</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last check of computer and devices, if one was run (Help menu)</source>
      <translation>die letzte Prüfung von Rechner und Geräten, falls eine lief (Menü Hilfe)</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window</source>
      <translation>ein Bild des Fensters</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>an image of the window, with the library, the recording panel and the log blacked out</source>
      <translation>ein Bild des Fensters, in dem Bibliothek, Aufnahmefeld und Protokoll geschwärzt sind</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>the last {} s of the session that is open: sensor data and tracking, without camera images</source>
      <translation>die letzten {} s der offenen Sitzung: Sensordaten und Tracking, ohne Kamerabilder</translation>
    </message>
    <message>
      <location filename="app/platform/bug_report.py" />
      <source>Glovetrack bug report. Contents:</source>
      <translation>Fehlerbericht von Glovetrack. Inhalt:</translation>
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
      <location filename="app/platform/crash.py" />
      <source>Something went wrong inside Glovetrack ({}: {}).</source>
      <translation>In Glovetrack ist etwas schiefgegangen ({}: {}).</translation>
    </message>
    <message>
      <location filename="app/platform/tasks.py" />
      <source>{} failed: {}: {}</source>
      <translation>„{}“ ist fehlgeschlagen: {}: {}</translation>
    </message>
    <message>
      <location filename="app/storage/bound_gloves.py" />
      <source>Glove {} ({} hand) was recognized. Its own files {} and {} are used.</source>
      <translation>Handschuh {} ({}) wurde erkannt. Seine eigenen Dateien {} und {} werden verwendet.</translation>
    </message>
    <message>
      <location filename="app/storage/settings.py" />
      <source>The settings could not be read: {}. The window uses its defaults; the old settings are saved in {}.</source>
      <translation>Die Einstellungen konnten nicht gelesen werden: {}. Das Fenster verwendet die Vorgaben; die alten Einstellungen sind in {} gesichert.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/calibration.py" />
      <source>A single camera cannot determine the size of the hand. Measure it with a ruler and enter it under Hand length…</source>
      <translation>Eine einzelne Kamera kann die Größe der Hand nicht bestimmen. Mit einem Lineal messen und unter Handlänge… eingeben.</translation>
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
      <source>Hold the hand at several tilts so that accelerometer biases settle (least certain: {}).</source>
      <translation>Hand in mehreren Neigungen halten, damit sich die Nullpunkte der Beschleunigungssensoren einstellen (am unsichersten: {}).</translation>
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
      <source>not known yet; turn the hand</source>
      <translation>noch unbekannt; Hand drehen</translation>
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
      <source>both images arrive, the right one {:.1f} ms {} (corrected)</source>
      <translation>beide Bilder kommen an, das rechte {:.1f} ms {} (korrigiert)</translation>
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
      <source>No glove found. Plug it in, or try the demo.</source>
      <translation>Kein Handschuh gefunden. Einstecken oder die Demo ausprobieren.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>All IMUs respond</source>
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
      <source>Cannot be verified: this camera has no exposure control and may change its exposure automatically. Keep the light constant.</source>
      <translation>Nicht überprüfbar: Diese Kamera hat keine Belichtungssteuerung und kann ihre Belichtung automatisch ändern. Halten Sie das Licht konstant.</translation>
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
      <source>Hold the hand flat, about 35 cm in front of the camera, for two seconds.</source>
      <translation>Hand zwei Sekunden lang flach etwa 35 cm vor die Kamera halten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Not connected.</source>
      <translation>Nicht verbunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waiting for the glove.</source>
      <translation>Warten auf den Handschuh.</translation>
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
      <source>this engine does not estimate biases</source>
      <translation>dieses Verfahren schätzt keine Nullpunkte</translation>
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
      <source>one camera: distances are only as accurate as the hand size</source>
      <translation>eine Kamera: Entfernungen sind nur so genau wie die Handgröße</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waiting for images.</source>
      <translation>Warten auf Bilder.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>fixed</source>
      <translation>fest</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Lock it now</source>
      <translation>Jetzt sperren</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Measuring the light…</source>
      <translation>Licht wird gemessen …</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>the markers are clearly visible</source>
      <translation>die Marker sind gut sichtbar</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Searching for markers…</source>
      <translation>Marker werden gesucht…</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>No markers found.</source>
      <translation>Keine Marker gefunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waiting for glove and camera.</source>
      <translation>Warten auf Handschuh und Kamera.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>tracking</source>
      <translation>wird getrackt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Needs glove and calibrated camera.</source>
      <translation>Braucht Handschuh und kalibrierte Kamera.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The hand was tracked but is not in view now.</source>
      <translation>Die Hand wurde getrackt, ist aber gerade nicht im Bild.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Waiting for tracking.</source>
      <translation>Warten auf das Tracking.</translation>
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
      <source>The camera changes {} automatically.</source>
      <translation>Die Kamera ändert {} automatisch.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>Cannot be verified: the camera does not confirm {}.</source>
      <translation>Nicht überprüfbar: Die Kamera bestätigt {} nicht.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/checklist.py" />
      <source>The ranges of {} overlap.</source>
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
      <source>gyroscope biases known to {:.1f} °/s</source>
      <translation>Nullpunkte der Gyroskope auf {:.1f} °/s bekannt</translation>
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
      <translation>Nichts angepasst: Es wurden keine Flicken dieser Farben gefunden.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>{} (1 patch)</source>
      <translation>{} (Flicken: 1)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>{} ({} patches)</source>
      <translation>{} (Flicken: {})</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}. Not changed: {} (too few patches visible).</source>
      <translation>Angepasst: {}. Nicht geändert: {} (zu wenige Flicken sichtbar).</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_fits.py" />
      <source>Fitted {}.</source>
      <translation>Angepasst: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_picks.py" />
      <source>Clicked: {}. To learn the colours, also click: {}.</source>
      <translation>Angeklickt: {}. Um die Farben zu lernen, auch anklicken: {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_picks.py" />
      <source>This looks like {0}, not {1}. Select {0} first, or click again to accept it.</source>
      <translation>Das sieht nach {0} aus, nicht nach {1}. Zuerst {0} auswählen oder zum Bestätigen erneut klicken.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_picks.py" />
      <source>This pixel is too grey or too dark to have a hue (saturation {}, value {}). Click the middle of a {} marker.</source>
      <translation>Dieses Pixel ist zu grau oder zu dunkel für einen Farbton (Sättigung {}, Helligkeit {}). Klicken Sie auf die Mitte eines Markers in {}.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>The colours were adapted to the light.</source>
      <translation>Die Farben wurden an das Licht angepasst.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colour_tuning.py" />
      <source>The background has none of these colours.</source>
      <translation>Der Hintergrund hat keine dieser Farben.</translation>
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
      <source>the background has this colour, too ({:.2g} % of the image)</source>
      <translation>der Hintergrund hat auch diese Farbe ({:.2g} % des Bildes)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/colours.py" />
      <source>{:.0f} found in an image</source>
      <translation>{:.0f} in einem Bild gefunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/compare.py" />
      <source>{} is closer to the truth: {} on average.</source>
      <translation>{} ist näher an der Wahrheit: im Mittel {}.</translation>
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
      <source>Both are bit-identical ({} instants).</source>
      <translation>Beide sind bitgenau gleich ({} Zeitpunkte).</translation>
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
      <source>passed</source>
      <translation>bestanden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>not run</source>
      <translation>nicht gelaufen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>accelerometer failed</source>
      <translation>Beschleunigungssensor nicht bestanden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>gyroscope failed</source>
      <translation>Drehratensensor nicht bestanden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>accelerometer and gyroscope failed</source>
      <translation>Beschleunigungs- und Drehratensensor nicht bestanden</translation>
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
      <source>Power-line frequency</source>
      <translation>Netzfrequenz</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Autofocus</source>
      <translation>Autofokus</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Digital zoom</source>
      <translation>Digitalzoom</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Mirrored</source>
      <translation>Gespiegelt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Upside down</source>
      <translation>Kopfüber</translation>
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
      <translation>Akku</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Temperature</source>
      <translation>Temperatur</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Responding</source>
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
      <source>Chip</source>
      <translation>Chip</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Self-test</source>
      <translation>Selbsttest</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Saturated samples</source>
      <translation>Gesättigte Messwerte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/device_settings.py" />
      <source>Stuck axes</source>
      <translation>Hängende Achsen</translation>
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
      <source>Negotiated rate</source>
      <translation>Vereinbarte Rate</translation>
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
      <source>Negotiated size</source>
      <translation>Vereinbarte Größe</translation>
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
      <source>{} matches the current device settings.</source>
      <translation>{} entspricht den aktuellen Geräteeinstellungen.</translation>
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
      <source>off</source>
      <translation>aus</translation>
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
      <source>an IMU did not respond</source>
      <translation>eine IMU hat nicht geantwortet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/gaps.py" />
      <source>no sensor on this part</source>
      <translation>kein Sensor an diesem Teil</translation>
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
      <source>It cannot be filled: there is no data on one side of the gap.</source>
      <translation>Nicht füllbar: Auf einer Seite der Lücke fehlen Daten.</translation>
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
      <source>continue…</source>
      <translation>weitermachen …</translation>
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
      <source>good</source>
      <translation>gut</translation>
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
      <location filename="app/viewmodels/guided_words.py" />
      <source>Hold it: this finger has no sensor</source>
      <translation>Halten: Dieser Finger hat keinen Sensor</translation>
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
      <source>thumb</source>
      <translation>Daumen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>index finger</source>
      <translation>Zeigefinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>middle finger</source>
      <translation>Mittelfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>ring finger</source>
      <translation>Ringfinger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>little finger</source>
      <translation>kleiner Finger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>The end joint of your {} bends {:.0f}° more than estimated before.</source>
      <translation>Das Endgelenk ({}) beugt sich {:.0f}° mehr als bisher geschätzt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>The end joint of your {} bends {:.0f}° less than estimated before.</source>
      <translation>Das Endgelenk ({}) beugt sich {:.0f}° weniger als bisher geschätzt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Your hand is {:.1f} mm longer than estimated before.</source>
      <translation>Ihre Hand ist {:.1f} mm länger als bisher geschätzt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Your hand is {:.1f} mm shorter than estimated before.</source>
      <translation>Ihre Hand ist {:.1f} mm kürzer als bisher geschätzt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>No data from the glove</source>
      <translation>Keine Daten vom Handschuh</translation>
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
      <location filename="app/viewmodels/guided_words.py" />
      <source>Tip of the thumb, to the side</source>
      <translation>Daumenspitze, zur Seite</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>Length of the hand</source>
      <translation>Länge der Hand</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>End joint of the {}, straight</source>
      <translation>Endgelenk ({}), gestreckt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/guided_words.py" />
      <source>End joint of the {}, bent</source>
      <translation>Endgelenk {}, gebeugt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Position unknown. Orientation and finger angles from the IMUs only.</source>
      <translation>Position unbekannt. Ausrichtung und Fingerwinkel nur aus den IMUs.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>No data. Showing the last pose.</source>
      <translation>Keine Daten. Letzte Pose wird gezeigt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>No estimates here. Showing the last pose.</source>
      <translation>Hier keine Schätzungen. Letzte Pose wird gezeigt.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/hand_scene.py" />
      <source>Position lost. Showing the last known position.</source>
      <translation>Position verloren. Letzte bekannte Position wird gezeigt.</translation>
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
      <translation>getrackt {} %</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>tracked left {}, right {} %</source>
      <translation>getrackt links {}, rechts {} %</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>IMUs only</source>
      <translation>nur IMUs</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>complete</source>
      <translation>vollständig</translation>
    </message>
    <message>
      <location filename="app/viewmodels/library.py" />
      <source>interrupted</source>
      <translation>unterbrochen</translation>
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
      <source>hues too similar</source>
      <translation>Farbtöne zu ähnlich</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>colours in background</source>
      <translation>Farben im Hintergrund</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>markers missed</source>
      <translation>Marker übersehen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>No image has been measured yet.</source>
      <translation>Noch kein Bild gemessen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/light.py" />
      <source>Nothing to change: the markers are clearly visible.</source>
      <translation>Nichts zu ändern: Die Marker sind gut sichtbar.</translation>
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
      <source>red-to-blue ratio on the cloth {:.1f}</source>
      <translation>Verhältnis von Rot zu Blau auf dem Stoff {:.1f}</translation>
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
      <source>Less than 1 GB is left: recording is not possible on this disk.</source>
      <translation>Weniger als 1 GB ist frei: Auf dieser Festplatte ist keine Aufnahme möglich.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording.py" />
      <source>Less than 5 GB is left on this disk.</source>
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
      <source>{} messages discarded (system overloaded)</source>
      <translation>{} Nachrichten verworfen (System überlastet)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/recording_report.py" />
      <source>{} was interrupted after {}. Its contents can be recovered.</source>
      <translation>{} wurde nach {} unterbrochen. Der Inhalt lässt sich wiederherstellen.</translation>
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
      <source>{} is complete: {}.</source>
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
      <source>{} is damaged: {}</source>
      <translation>{} ist beschädigt: {}</translation>
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
      <source>tracked {:.0f} % of the time</source>
      <translation>{:.0f} % der Zeit getrackt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames with invalid byte stuffing (COBS)</source>
      <translation>Rahmen mit ungültigem Byte-Stuffing (COBS)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames with a wrong checksum (CRC)</source>
      <translation>Rahmen mit falscher Prüfsumme (CRC)</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of the wrong length</source>
      <translation>Rahmen falscher Länge</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Frames of an unknown type or of excessive length</source>
      <translation>Rahmen unbekannter Art oder übermäßiger Länge</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Times the port was reopened</source>
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
      <source>Packets the glove had no time to send</source>
      <translation>Pakete, für die dem Handschuh die Zeit fehlte</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Skew of the host's clock against the glove's, ppm</source>
      <translation>Gangabweichung der Rechneruhr gegenüber der des Handschuhs, ppm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>Latency timer of the USB adapter, ms</source>
      <translation>Latenz-Timer des USB-Adapters, ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>battery {:.2f} V</source>
      <translation>Akku {:.2f} V</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>adapter latency {:.0f} ms</source>
      <translation>Adapterlatenz {:.0f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>not responding</source>
      <translation>antwortet nicht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ battery low: {:.2f} V</source>
      <translation>⚠ Akku schwach: {:.2f} V</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>⚠ adapter latency {:.0f} ms</source>
      <translation>⚠ Adapterlatenz {:.0f} ms</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>responding</source>
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
      <source>1 clock jump</source>
      <translation>1 Uhrsprung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/sensors.py" />
      <source>{} clock jumps</source>
      <translation>{} Uhrsprünge</translation>
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
      <source>packets per second</source>
      <translation>Pakete pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>images per second</source>
      <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>estimates per second</source>
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
      <source>engine step</source>
      <translation>Rechenschritt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>latency, sample to screen</source>
      <translation>Latenz, Messwert bis Bildschirm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>latency, sample to streams</source>
      <translation>Latenz, Messwert bis Streams</translation>
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
      <source>overload level</source>
      <translation>Überlastungsstufe</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>battery voltage</source>
      <translation>Akkuspannung</translation>
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
      <source>tracking state (0 to 3)</source>
      <translation>Tracking-Zustand (0 bis 3)</translation>
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
      <translation>Raten, Latenz und Akku</translation>
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
      <translation>Flecken, links</translation>
    </message>
    <message>
      <location filename="app/viewmodels/signals.py" />
      <source>blobs, right</source>
      <translation>Flecken, rechts</translation>
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
      <source>Coasting on the IMUs only</source>
      <translation>Nur mit IMUs fortgeschrieben</translation>
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
      <source>Engine step for a message</source>
      <translation>Rechenschritt für eine Nachricht</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Arrival of a packet to its estimate</source>
      <translation>Ankunft eines Pakets bis zu seiner Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Arrival of an image to its estimate</source>
      <translation>Ankunft eines Bildes bis zu seiner Schätzung</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Sample to the screen</source>
      <translation>Messwert bis zum Bildschirm</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Sample to the streams</source>
      <translation>Messwert bis zu den Streams</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Sample to a motor</source>
      <translation>Messwert bis zu einem Motor</translation>
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
      <source>As recorded</source>
      <translation>Wie aufgezeichnet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Estimates of the hand per second</source>
      <translation>Schätzungen der Hand pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Lost packets of the glove; images dropped because they arrived faster than they were read</source>
      <translation>Verlorene Pakete des Handschuhs; Bilder, die verworfen wurden, weil sie schneller ankamen als gelesen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Position unknown</source>
      <translation>Position unbekannt</translation>
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
      <source>Packets of the glove per second</source>
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
      <source>No data</source>
      <translation>Keine Daten</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>{}, heading within {:.0f}°</source>
      <translation>{}, Richtung auf {:.0f}° genau</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>Stereo images per second</source>
      <translation>Stereobilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/viewmodels/status.py" />
      <source>The glove's battery is low ({} V). Charge it soon.</source>
      <translation>Der Akku des Handschuhs ist schwach ({} V). Bald laden.</translation>
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
      <source>View taken.</source>
      <translation>Ansicht aufgenommen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Hold the board still.</source>
      <translation>Die Tafel stillhalten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There is already a similar view. Move the board.</source>
      <translation>Es gibt bereits eine ähnliche Ansicht. Tafel bewegen.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There are enough views.</source>
      <translation>Es gibt genug Ansichten.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>There are enough views. Press Calibrate.</source>
      <translation>Es gibt genug Ansichten. Kalibrieren drücken.</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Error over all corners</source>
      <translation>Fehler über alle Ecken</translation>
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
      <source>{}, error {:.2f} px</source>
      <translation>{}, Fehler {:.2f} px</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>{} used, {} rejected</source>
      <translation>{} verwendet, {} abgelehnt</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Baseline</source>
      <translation>Basislänge</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Relative rotation</source>
      <translation>Relative Drehung</translation>
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
      <source>Largest corner error</source>
      <translation>Größter Eckenfehler</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>Vertical offset</source>
      <translation>Senkrechter Versatz</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>used</source>
      <translation>verwendet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/stereo.py" />
      <source>rejected: inconsistent with the others</source>
      <translation>abgelehnt: passt nicht zu den anderen</translation>
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
      <source>no listeners</source>
      <translation>keine Empfänger</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>connected</source>
      <translation>verbunden</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>no clients</source>
      <translation>keine Clients</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>not open</source>
      <translation>nicht offen</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>opening</source>
      <translation>öffnet</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>waiting for tracking</source>
      <translation>wartet auf das Tracking</translation>
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
      <source>disconnected clients</source>
      <translation>getrennte Clients</translation>
    </message>
    <message>
      <location filename="app/viewmodels/streams.py" />
      <source>{}, {} s ago</source>
      <translation>{}, vor {} s</translation>
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
      <location filename="app/viewmodels/two_recordings.py" />
      <source>The recordings have no tracked instant in common here.</source>
      <translation>Die Aufnahmen haben hier keinen getrackten Zeitpunkt gemeinsam.</translation>
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
      <source>Frozen: the calibration does not change until you unfreeze it.</source>
      <translation>Eingefroren: Die Kalibrierung ändert sich erst wieder, wenn Sie sie freigeben.</translation>
    </message>
    <message>
      <location filename="app/widgets/banner.py" />
      <source>Dismiss</source>
      <translation>Schließen</translation>
    </message>
    <message>
      <location filename="app/widgets/image_view.py" />
      <source>Wheel or + −: zoom. Drag or arrows: move. Double-click or 0: whole image.</source>
      <translation>Mausrad oder + −: Zoom. Ziehen oder Pfeile: verschieben. Doppelklick oder 0: ganzes Bild.</translation>
    </message>
    <message>
      <location filename="app/widgets/options_dialog.py" />
      <source>Options: {}</source>
      <translation>Optionen: {}</translation>
    </message>
    <message>
      <location filename="app/widgets/range_row.py" />
      <source>Drag a handle, or the bar. Keys: ↓ ↑ choose a handle, ← → move it.</source>
      <translation>Einen Griff oder den Balken ziehen. Tasten: ↓ ↑ wählen einen Griff, ← → bewegen ihn.</translation>
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
      <location filename="app/window/bug_reports.py" />
      <source>The file stays on this computer until you send it. It will contain:</source>
      <translation>Die Datei bleibt auf diesem Rechner, bis Sie sie versenden. Sie wird enthalten:</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Save a bug report</source>
      <translation>Fehlerbericht speichern</translation>
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
      <source>An image of the window</source>
      <translation>Ein Bild des Fensters</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>The last seconds of the session</source>
      <translation>Die letzten Sekunden der Sitzung</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Camera images of these seconds</source>
      <translation>Kamerabilder dieser Sekunden</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Participant, task, notes and folder names</source>
      <translation>Versuchsperson, Aufgabe, Notizen und Ordnernamen</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source>Bug report saved: {}.</source>
      <translation>Fehlerbericht gespeichert: {}.</translation>
    </message>
    <message>
      <location filename="app/window/bug_reports.py" />
      <source> Not included: {}.</source>
      <translation> Nicht enthalten: {}.</translation>
    </message>
    <message>
      <location filename="app/window/commands.py" />
      <source>Commands</source>
      <translation>Befehle</translation>
    </message>
    <message>
      <location filename="app/window/commands.py" />
      <source>Open</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <location filename="app/window/commands.py" />
      <source>Find</source>
      <translation>Suchen</translation>
    </message>
    <message>
      <location filename="app/window/commands.py" />
      <source>Stop recording</source>
      <translation>Aufnahme stoppen</translation>
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
      <location filename="app/window/dialogs.py" />
      <source>Guide</source>
      <translation>Anleitung</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Search the guide</source>
      <translation>Anleitung durchsuchen</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Keyboard shortcuts</source>
      <translation>Tastenkürzel</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>About Glovetrack</source>
      <translation>Über Glovetrack</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Components and licences</source>
      <translation>Bestandteile und Lizenzen</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Apache-2.0</source>
      <translation>Apache-2.0</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Hand tracking with a sensor glove and a stereo camera. Free software under the Apache License 2.0, without any warranty.</source>
      <translation>Handtracking mit Sensorhandschuh und Stereokamera. Freie Software unter der Apache-Lizenz 2.0, ohne jede Gewähr.</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Type a command</source>
      <translation>Befehl eingeben</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Key</source>
      <translation>Taste</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Command</source>
      <translation>Befehl</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Menu</source>
      <translation>Menü</translation>
    </message>
    <message>
      <location filename="app/window/dialogs.py" />
      <source>Glovetrack {}</source>
      <translation>Glovetrack {}</translation>
    </message>
    <message>
      <location filename="app/window/docks.py" />
      <source>&amp;View</source>
      <translation>&amp;Ansicht</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Checking computer and devices</source>
      <translation>Rechner und Geräte werden geprüft</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Check computer and devices</source>
      <translation>Rechner und Geräte prüfen</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Check again</source>
      <translation>Erneut prüfen</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Save report…</source>
      <translation>Bericht speichern…</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Udev rule…</source>
      <translation>Udev-Regel …</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Show the rule that gives access to devices, and install it</source>
      <translation>Die Regel anzeigen, die Zugriff auf Geräte gibt, und installieren</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Checking… Devices in use by this window are not tested.</source>
      <translation>Prüfung läuft… Geräte, die dieses Fenster benutzt, werden nicht geprüft.</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>No problems found.</source>
      <translation>Keine Probleme gefunden.</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Save report</source>
      <translation>Bericht speichern</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Result</source>
      <translation>Ergebnis</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Found</source>
      <translation>Befund</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Remedy</source>
      <translation>Abhilfe</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>OK</source>
      <translation>OK</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Warning</source>
      <translation>Warnung</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Error</source>
      <translation>Fehler</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>{} errors, {} warnings.</source>
      <translation>{} Fehler, {} Warnungen.</translation>
    </message>
    <message>
      <location filename="app/window/doctor.py" />
      <source>Report saved: {}.</source>
      <translation>Bericht gespeichert: {}.</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Layout</source>
      <translation>&amp;Layout</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Save layout</source>
      <translation>Layout speichern</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Saved layouts</source>
      <translation>Gespeicherte Layouts</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Rename layout</source>
      <translation>Layout umbenennen</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Delete layout</source>
      <translation>Layout löschen</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Save layout…</source>
      <translation>Layout &amp;speichern …</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Rename layout…</source>
      <translation>Layout &amp;umbenennen …</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>&amp;Delete layout…</source>
      <translation>Layout &amp;löschen …</translation>
    </message>
    <message>
      <location filename="app/window/layout_keeper.py" />
      <source>Layout {} deleted.</source>
      <translation>Layout {} gelöscht.</translation>
    </message>
    <message>
      <location filename="app/window/layouts.py" />
      <source>Set up</source>
      <translation>Einrichten</translation>
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
      <translation>Pose wird in {} s zurückgesetzt</translation>
    </message>
    <message>
      <location filename="app/window/main_window.py" />
      <source>Hold the hand flat, fingers ahead</source>
      <translation>Hand flach halten, Finger nach vorn</translation>
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
      <location filename="app/window/message_bar.py" />
      <source>Many patches have the markers' colours, but none fit the glove. Fit the colours.</source>
      <translation>Viele Flicken haben die Farben der Marker, aber keine passen zum Handschuh. Farben anpassen.</translation>
    </message>
    <message>
      <location filename="app/window/message_bar.py" />
      <source>Esc: cancel</source>
      <translation>Esc: abbrechen</translation>
    </message>
    <message>
      <location filename="app/window/message_bar.py" />
      <source>Fit colours now</source>
      <translation>Farben jetzt anpassen</translation>
    </message>
    <message>
      <location filename="app/window/message_bar.py" />
      <source>Show the colours</source>
      <translation>Farben zeigen</translation>
    </message>
    <message>
      <location filename="app/window/message_bar.py" />
      <source>The calibration is used until this session ends.</source>
      <translation>Die Kalibrierung gilt bis zum Ende dieser Sitzung.</translation>
    </message>
    <message>
      <location filename="app/window/message_bar.py" />
      <source>Save it to a profile…</source>
      <translation>In einem Profil speichern …</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Name of the recording</source>
      <translation>Name der Aufnahme</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Text of the note</source>
      <translation>Text der Notiz</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Looking for earlier sessions</source>
      <translation>Frühere Sitzungen werden gesucht</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Recording {} was cut off. Its contents were recovered to {}.</source>
      <translation>Die Aufnahme {} wurde abgebrochen. Ihr Inhalt wurde in {} wiederhergestellt.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Recording {} was cut off. Its contents can be recovered.</source>
      <translation>Die Aufnahme {} wurde abgebrochen. Ihr Inhalt lässt sich wiederherstellen.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Checking {}</source>
      <translation>{} wird geprüft</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>{} moved to the trash.</source>
      <translation>{} in den Papierkorb verschoben.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>Recovered the recording to {}.</source>
      <translation>Aufnahme in {} wiederhergestellt.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>{} recordings moved to the trash.</source>
      <translation>{} Aufnahmen in den Papierkorb verschoben.</translation>
    </message>
    <message>
      <location filename="app/window/recordings.py" />
      <source>{} Your recording {} is complete.</source>
      <translation>{} Ihre Aufnahme {} ist vollständig.</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Pose reset</source>
      <translation>Pose zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>&amp;Beep when it is done</source>
      <translation>&amp;Signalton danach</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>&amp;Double tap on the back of the glove</source>
      <translation>&amp;Doppeltes Tippen auf den Handrücken</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Two quick taps, with the hand at rest before and after</source>
      <translation>Zwei schnelle Tipper, die Hand davor und danach in Ruhe</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Hold the hand flat and level, fingers straight ahead. The reset aligns the finger joints with that pose, and without a camera the heading, too.</source>
      <translation>Halten Sie die Hand flach und waagerecht, die Finger gerade nach vorn. Das Zurücksetzen richtet die Fingergelenke nach dieser Pose aus, ohne Kamera auch die Richtung.</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>&amp;Save</source>
      <translation>&amp;Speichern</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>{} is already assigned to “{}”. Choose another key.</source>
      <translation>{} ist bereits mit „{}“ belegt. Eine andere Taste wählen.</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Looking for cameras</source>
      <translation>Kameras werden gesucht</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>Only the engine chain learns from poses. Choose it in the Tracking menu.</source>
      <translation>Nur das Verfahren chain lernt aus Posen. Im Menü Tracking wählen.</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>&amp;Key</source>
      <translation>&amp;Taste</translation>
    </message>
    <message>
      <location filename="app/window/set_up_dialogs.py" />
      <source>&amp;Countdown</source>
      <translation>&amp;Countdown</translation>
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
      <source>Open recording</source>
      <translation>Aufnahme öffnen</translation>
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
      <source>Show checklist</source>
      <translation>Checkliste zeigen</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Plugged in: {}.</source>
      <translation>Angeschlossen: {}.</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Connect</source>
      <translation>Verbinden</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>Stop recording and open</source>
      <translation>Aufnahme beenden und öffnen</translation>
    </message>
    <message>
      <location filename="app/window/sources.py" />
      <source>{} cannot be opened during a recording.</source>
      <translation>{} lässt sich während einer Aufnahme nicht öffnen.</translation>
    </message>
    <message>
      <location filename="app/window/start.py" />
      <source>Glovetrack – compiling</source>
      <translation>Glovetrack – Kompilierung</translation>
    </message>
    <message>
      <location filename="app/window/start.py" />
      <source>Compiling the numerical kernels for this computer. This happens at the first start, where it takes a minute or two on two cores, and after updates.</source>
      <translation>Die numerischen Kernel werden für diesen Computer kompiliert. Das geschieht beim ersten Start, wo es auf zwei Kernen ein bis zwei Minuten dauert, und nach Aktualisierungen.</translation>
    </message>
    <message>
      <location filename="app/window/start.py" />
      <source>Start without waiting</source>
      <translation>Ohne Warten beginnen</translation>
    </message>
    <message>
      <location filename="app/window/start.py" />
      <source>Kernels that are not compiled yet are compiled on first use, and the window pauses.</source>
      <translation>Noch nicht übersetzte Rechenkerne werden bei der ersten Verwendung übersetzt; das Fenster hält dann an.</translation>
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
      <location filename="app/window/ticker.py" />
      <source>Paused</source>
      <translation>Pause</translation>
    </message>
    <message>
      <location filename="app/window/ticker.py" />
      <source>Panel {} failed and is paused ({}: {}). Everything else continues.</source>
      <translation>Das Feld {} ist fehlgeschlagen und angehalten ({}: {}). Alles andere läuft weiter.</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>Installing the udev rule</source>
      <translation>Udev-Regel wird installiert</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>Access to gloves and cameras</source>
      <translation>Zugriff auf Handschuhe und Kameras</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>The udev rule</source>
      <translation>Die udev-Regel</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>&amp;Copy</source>
      <translation>&amp;Kopieren</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>&amp;Install…</source>
      <translation>&amp;Installieren …</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>The system asks for an administrator's password</source>
      <translation>Das System fragt nach dem Passwort eines Administrators</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>The rule is in the clipboard.</source>
      <translation>Die Regel ist in der Zwischenablage.</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>Waiting for the administrator's password…</source>
      <translation>Warten auf das Passwort des Administrators …</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>The rule is installed. Unplug the devices, then plug them in again.</source>
      <translation>Die Regel ist installiert. Trennen Sie die Geräte, und schließen Sie sie wieder an.</translation>
    </message>
    <message>
      <location filename="app/window/udev_rule.py" />
      <source>With this udev rule, the person at the screen may use USB serial adapters and cameras. It belongs in {}.</source>
      <translation>Mit dieser udev-Regel darf die Person am Bildschirm serielle USB-Adapter und Kameras benutzen. Sie gehört nach {}.</translation>
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
      <source>&amp;Check computer and devices…</source>
      <translation>Rechner und Geräte &amp;prüfen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: &amp;automatic</source>
      <translation>3D-Ansicht: &amp;automatisch</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: &amp;graphics card</source>
      <translation>3D-Ansicht: &amp;Grafikkarte</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>3D view: soft&amp;ware</source>
      <translation>3D-Ansicht: Soft&amp;ware</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Theme: &amp;light</source>
      <translation>Design: &amp;hell</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Theme: &amp;dark</source>
      <translation>Design: &amp;dunkel</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Theme: s&amp;ystem</source>
      <translation>Design: S&amp;ystem</translation>
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
      <source>Open &amp;documentation in the browser</source>
      <translation>&amp;Dokumentation im Browser öffnen</translation>
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
      <source>Language: system default</source>
      <translation>Sprache: Systemvorgabe</translation>
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
      <source>&amp;Open recording…</source>
      <translation>Aufnahme &amp;öffnen …</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Export…</source>
      <translation>&amp;Exportieren…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Close</source>
      <translation>S&amp;chließen</translation>
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
      <source>&amp;IMU accuracy…</source>
      <translation>&amp;IMU-Genauigkeit …</translation>
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
      <source>Save &amp;wearer profile…</source>
      <translation>&amp;Trägerprofil speichern …</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Lock the current exposure</source>
      <translation>Aktuelle Belichtung sperr&amp;en</translation>
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
      <source>&amp;Pause recording</source>
      <translation>Aufnahme &amp;pausieren</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Add a &amp;note…</source>
      <translation>&amp;Notiz hinzufügen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>R&amp;eset pose</source>
      <translation>Pos&amp;e zurücksetzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Pose reset sett&amp;ings…</source>
      <translation>Pose zurücksetzen: Einste&amp;llungen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Track in a separate pro&amp;cess</source>
      <translation>Tracking in eigenem Pro&amp;zess</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Return to li&amp;ve tracking</source>
      <translation>Zurück zum Li&amp;ve-Tracking</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Play or pause</source>
      <translation>Wiedergabe oder &amp;Pause</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Previous &amp;image</source>
      <translation>Voriges B&amp;ild</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Next image</source>
      <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Previous no&amp;te</source>
      <translation>Vorige N&amp;otiz</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Next n&amp;ote</source>
      <translation>Nächste Noti&amp;z</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Set the &amp;start of the range</source>
      <translation>Anfan&amp;g des Bereichs setzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Set the &amp;end of the range</source>
      <translation>End&amp;e des Bereichs setzen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Clear the range</source>
      <translation>Bereich auf&amp;heben</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>C&amp;rop to a new session</source>
      <translation>In neue Sitzung z&amp;uschneiden</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Loop</source>
      <translation>Sch&amp;leife</translation>
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
      <source>Two recordings side by si&amp;de</source>
      <translation>Zwei Aufnahmen ne&amp;beneinander</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Freeze images</source>
      <translation>Bilder ein&amp;frieren</translation>
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
      <source>&amp;Undo colour change</source>
      <translation>Farbänderung &amp;zurücknehmen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Redo colour change</source>
      <translation>Farbänderung &amp;wiederholen</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Command palette…</source>
      <translation>&amp;Befehle suchen…</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>Latency p&amp;er stage</source>
      <translation>Latenz je Stuf&amp;e</translation>
    </message>
    <message>
      <location filename="app/window/window_commands.py" />
      <source>&amp;Reset layout</source>
      <translation>Layout zurückset&amp;zen</translation>
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
      <source>&amp;Keyboard shortcuts</source>
      <translation>Tasten&amp;kürzel</translation>
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
      <translation>Erweiter&amp;ungen</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>A video with both images side by side</source>
      <translation>Ein Video mit beiden Bildern nebeneinander</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>not available on this camera</source>
      <translation>bei dieser Kamera nicht verfügbar</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>▲ rejected by the camera</source>
      <translation>▲ von der Kamera abgelehnt</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Camera set-up</source>
      <translation>Kamera einrichten</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Swap l&amp;eft and right</source>
      <translation>&amp;Links und rechts tauschen</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>If a stereo calibration reports that the cameras are swapped</source>
      <translation>Wenn eine Stereokalibrierung meldet, dass die Kameras vertauscht sind</translation>
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
      <source>empty, or the number or address of the right camera</source>
      <translation>leer, oder Nummer oder Adresse der rechten Kamera</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>&amp;And from</source>
      <translation>&amp;Und von</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>First camera found</source>
      <translation>Erste gefundene Kamera</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>the same image, if it is wide enough for two</source>
      <translation>dasselbe Bild, falls es breit genug für zwei ist</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>none (single camera)</source>
      <translation>keine (einzelne Kamera)</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>the same image, side by side</source>
      <translation>dasselbe Bild, nebeneinander</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Receiving {} × {} px from one camera, {} images per second</source>
      <translation>Empfang von einer Kamera: {} × {} px, {} Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Receiving {} × {} px from each camera, {} images per second</source>
      <translation>Empfang von jeder Kamera: {} × {} px, {} Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Locks</source>
      <translation>Sperren</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>Automatic exposure changes the colours with every movement.</source>
      <translation>Die automatische Belichtung verändert die Farben bei jeder Bewegung.</translation>
    </message>
    <message>
      <location filename="app/wizards/camera.py" />
      <source>○ automatic, now {}</source>
      <translation>○ automatisch, jetzt {}</translation>
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
      <source>Start glove and camera to see the camera's controls.</source>
      <translation>Handschuh und Kamera starten, um die Regler der Kamera zu sehen.</translation>
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
      <source>Identifies this glove; give each glove its own number</source>
      <translation>Kennzeichnet diesen Handschuh; jedem Handschuh eine eigene Nummer geben</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>115200 for USB adapters without higher speeds</source>
      <translation>115200 für USB-Adapter ohne höhere Geschwindigkeiten</translation>
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
      <source>&amp;Type of board</source>
      <translation>&amp;Typ der Platine</translation>
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
      <source>Writing for about ten seconds. Leave the cable plugged in.</source>
      <translation>Es wird etwa zehn Sekunden lang geschrieben. Kabel nicht abziehen.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Writing the glove's firmware</source>
      <translation>Die Firmware des Handschuhs wird geschrieben</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Firmware written and verified. The glove does not respond yet: unplug it and plug it in again.</source>
      <translation>Firmware geschrieben und geprüft. Der Handschuh antwortet noch nicht: abziehen und wieder einstecken.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>The glove is in use. Writing stops tracking first.</source>
      <translation>Der Handschuh ist in Gebrauch. Das Schreiben beendet erst das Tracking.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>No serial port found. Plug the glove in.</source>
      <translation>Kein serieller Anschluss gefunden. Handschuh einstecken.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Firmware {} is included in this program.</source>
      <translation>Firmware {} ist in diesem Programm enthalten.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Its firmware is up to date.</source>
      <translation>Seine Firmware ist aktuell.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>Firmware written and verified. Glove {} responds with firmware {}.</source>
      <translation>Firmware geschrieben und geprüft. Handschuh {} antwortet mit Firmware {}.</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>{} baud</source>
      <translation>{} Baud</translation>
    </message>
    <message>
      <location filename="app/wizards/firmware.py" />
      <source>The glove at this port is number {} with firmware {}.</source>
      <translation>Der Handschuh an diesem Anschluss ist Nummer {} mit Firmware {}.</translation>
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
      <source>Automatic</source>
      <translation>Automatisch</translation>
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
      <source>Simulated glove (for practice)</source>
      <translation>Simulierter Handschuh (zum Üben)</translation>
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
      <source>{}: a glove that sends data</source>
      <translation>{}: ein Handschuh, der Daten sendet</translation>
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
      <source>No data received.</source>
      <translation>Keine Daten empfangen.</translation>
    </message>
    <message>
      <location filename="app/wizards/glove/pages.py" />
      <source>Moving: {}</source>
      <translation>In Bewegung: {}</translation>
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
      <source>Releasing the glove's port</source>
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
      <source>Your fingers bend as expected.</source>
      <translation>Ihre Finger beugen sich wie erwartet.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Guided calibration, right hand</source>
      <translation>Geführte Kalibrierung, rechte Hand</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Measured</source>
      <translation>Gemessen</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Before</source>
      <translation>Vorher</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>After</source>
      <translation>Nachher</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Change</source>
      <translation>Änderung</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>&amp;Keep</source>
      <translation>&amp;Behalten</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>&amp;Undo</source>
      <translation>&amp;Rückgängig</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Discard the result of these poses</source>
      <translation>Ergebnis dieser Posen verwerfen</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Evaluating the poses…</source>
      <translation>Posen werden ausgewertet…</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>The calibration has not changed</source>
      <translation>Die Kalibrierung hat sich nicht geändert</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Beep when a pose has been held</source>
      <translation>Ton, wenn eine Pose gehalten wurde</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Accept &amp;hold (Enter)</source>
      <translation>&amp;Halten bestätigen (Eingabe)</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Accept the pose although the ring has not detected it</source>
      <translation>Pose bestätigen, obwohl der Ring sie nicht erkannt hat</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Skip (S)</source>
      <translation>Auslassen (S)</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Repeat (R)</source>
      <translation>Noch einmal (R)</translation>
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
      <source>{} of {} poses held</source>
      <translation>{} von {} Posen gehalten</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>Hold eight poses, each for two seconds</source>
      <translation>Acht Posen halten, jede zwei Sekunden</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>The poses measure how your fingers and thumb bend. Copy the hand on the left. It takes half a minute.</source>
      <translation>Die Posen messen, wie sich Ihre Finger und Ihr Daumen beugen. Machen Sie die Hand links nach. Es dauert eine halbe Minute.</translation>
    </message>
    <message>
      <location filename="app/wizards/guided/dialog.py" />
      <source>No pose was held.</source>
      <translation>Keine Pose wurde gehalten.</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/outcome.py" />
      <source>Rep&amp;eat</source>
      <translation>Wied&amp;erholen</translation>
    </message>
    <message>
      <location filename="app/wizards/leading/page.py" />
      <source>The pose to be held</source>
      <translation>Die zu haltende Pose</translation>
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
      <location filename="app/wizards/leading/page.py" />
      <source>held for {} % of the time</source>
      <translation>{} % der Zeit gehalten</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm down, hand level</source>
      <translation>Handfläche nach unten, Hand waagerecht</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm down, fingers raised by 45°</source>
      <translation>Handfläche nach unten, Finger um 45° angehoben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Fingers straight up</source>
      <translation>Finger senkrecht nach oben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm up, fingers raised by 45°</source>
      <translation>Handfläche nach oben, Finger um 45° angehoben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm up, hand level</source>
      <translation>Handfläche nach oben, Hand waagerecht</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Hand on its edge, thumb up</source>
      <translation>Hand auf der Kante, Daumen nach oben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Hand on its edge, thumb up, fingers raised by 45°</source>
      <translation>Hand auf der Kante, Daumen nach oben, Finger um 45° angehoben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm down, thumb side raised by 45°</source>
      <translation>Handfläche nach unten, Daumenseite um 45° angehoben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm down, little finger side raised by 45°</source>
      <translation>Handfläche nach unten, Kleinfingerseite um 45° angehoben</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Hand on its edge, thumb down</source>
      <translation>Hand auf der Kante, Daumen nach unten</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Palm down, fingers lowered by 45°</source>
      <translation>Handfläche nach unten, Finger um 45° gesenkt</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Fingers straight down</source>
      <translation>Finger senkrecht nach unten</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Evaluating the positions</source>
      <translation>Lagen werden ausgewertet</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Repeat the positions, and hold each one still for two seconds.</source>
      <translation>Wiederholen Sie die Lagen, und halten Sie in jeder zwei Sekunden still.</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>The position of the hand</source>
      <translation>Die Lage der Hand</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Accelerometer</source>
      <translation>Beschleunigungssensor</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Gyroscope</source>
      <translation>Gyroskop</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>&amp;Discard</source>
      <translation>&amp;Verwerfen</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Evaluating the positions…</source>
      <translation>Lagen werden ausgewertet …</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Beep when a position has been measured</source>
      <translation>Signalton, wenn eine Lage gemessen ist</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>&amp;Finish</source>
      <translation>&amp;Fertig</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Evaluate the positions measured so far, at least six</source>
      <translation>Die bisher gemessenen Lagen auswerten, mindestens sechs</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Accuracy of the IMUs</source>
      <translation>Genauigkeit der IMUs</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>The result cannot be used</source>
      <translation>Das Ergebnis ist nicht verwendbar</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Move there, then hold still</source>
      <translation>Diese Lage einnehmen und stillhalten</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>{} of {} IMUs measured</source>
      <translation>{} von {} IMUs gemessen</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Scale and axes deviate by up to {} %. With the corrections {} % remain (standard deviation). Save writes them to the glove file {} and uses them at once.</source>
      <translation>Skalierung und Achsen weichen um bis zu {} % ab. Mit den Korrekturen bleiben {} % (Standardabweichung). „Speichern“ schreibt sie in die Handschuhdatei {} und wendet sie sofort an.</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>{} % ± {} %</source>
      <translation>{} % ± {} %</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>not accurate: it moved while at rest, or rested in too few positions</source>
      <translation>ungenau: Bewegung in Ruhe oder zu wenige Lagen</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Rest the glove in twelve positions</source>
      <translation>Den Handschuh in zwölf Lagen ruhen lassen</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Gravity shows how accurate scale and axes of the IMUs are. Wear the glove and support the hand on a table, or fasten the glove to a box. Hold each position still for two seconds. Any order is possible. It takes two minutes.</source>
      <translation>Die Schwerkraft zeigt, wie genau Skalierung und Achsen der IMUs sind. Tragen Sie den Handschuh und stützen Sie die Hand auf einen Tisch, oder befestigen Sie den Handschuh an einer Schachtel. Halten Sie jede Lage zwei Sekunden lang ruhig. Die Reihenfolge ist beliebig. Es dauert zwei Minuten.</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Hold still</source>
      <translation>Stillhalten</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>Measured. Next position</source>
      <translation>Gemessen. Nächste Lage</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>At rest in another position</source>
      <translation>Die Hand ruht in einer anderen Lage</translation>
    </message>
    <message>
      <location filename="app/wizards/positions.py" />
      <source>too few rests</source>
      <translation>zu wenige Ruhelagen</translation>
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
      <source>&amp;Board</source>
      <translation>&amp;Tafel</translation>
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
      <source>B&amp;aseline, if known</source>
      <translation>B&amp;asislänge, falls bekannt</translation>
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
      <source>Import an existing calibration</source>
      <translation>Vorhandene Kalibrierung importieren</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/board.py" />
      <source>It is checked as strictly as a new calibration, and can be tested with the board.</source>
      <translation>Sie wird so streng geprüft wie eine neue Kalibrierung und lässt sich mit der Tafel testen.</translation>
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
      <source>Selected camera: {}</source>
      <translation>Gewählte Kamera: {}</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/result.py" />
      <source>Calibrated. Now check it on new views.</source>
      <translation>Kalibriert. Jetzt an neuen Ansichten prüfen.</translation>
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
      <source>Camera calibration</source>
      <translation>Kamerakalibrierung</translation>
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
      <source>Corner error</source>
      <translation>Eckenfehler</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>Row difference</source>
      <translation>Zeilenabweichung</translation>
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
      <source>Show the board again.</source>
      <translation>Tafel erneut zeigen.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>The image has a different size.</source>
      <translation>Das Bild hat eine andere Größe.</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/views.py" />
      <source>{} empty cells</source>
      <translation>Leere Felder: {}</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>ZED factory file</source>
      <translation>ZED-Werksdatei</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>OpenCV calibration</source>
      <translation>OpenCV-Kalibrierung</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Folder with left and right images</source>
      <translation>Ordner mit linken und rechten Bildern</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>squares of the board</source>
      <translation>Felder der Tafel</translation>
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
      <source>Image's &amp;width, px</source>
      <translation>Bild&amp;breite, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Image's &amp;height, px</source>
      <translation>Bild&amp;höhe, px</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>&amp;Unit of T in the file</source>
      <translation>&amp;Einheit von T in der Datei</translation>
    </message>
    <message>
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Side of a &amp;square</source>
      <translation>&amp;Seite eines Feldes</translation>
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
      <location filename="app/wizards/stereo/wizard.py" />
      <source>Import {}</source>
      <translation>{} importieren</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/extension.py" />
      <source>Applications</source>
      <translation>Anwendungen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Application</source>
      <translation>Anwendung</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Restart</source>
      <translation>Neu beginnen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Show all</source>
      <translation>Alles zeigen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Move the viewpoint until the whole drawing is visible</source>
      <translation>Blickpunkt verschieben, bis die ganze Zeichnung sichtbar ist</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Page</source>
      <translation>Seite</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>Show it in browsers on this computer, including a headset's</source>
      <translation>In Browsern auf diesem Rechner zeigen, auch in dem eines Headsets</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/panel.py" />
      <source>No application</source>
      <translation>Keine Anwendung</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Reach forward and touch the object with a fingertip.</source>
      <translation>Nach vorn greifen und das Objekt mit einer Fingerspitze berühren.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Close the hand by a grasp or a pinch to move the arm. Open the palm to stop it.</source>
      <translation>Hand zum Greifen oder Kneifen schließen, um den Arm zu bewegen. Handfläche öffnen, um ihn anzuhalten.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Grasp the building to move and turn it. Pinch with the middle finger and raise the hand to enlarge it, with the index finger and slide to fade the old plan. Hold the palm open to go back to the map.</source>
      <translation>Das Gebäude greifen, um es zu bewegen und zu drehen. Mit dem Mittelfinger kneifen und die Hand heben, um es zu vergrößern; mit dem Zeigefinger kneifen und seitlich ziehen, um den alten Plan einzublenden. Handfläche offen halten, um zur Karte zurückzukehren.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Show a thumb up to remove the walls.</source>
      <translation>Daumen hoch zeigen, um die Wände zu entfernen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Hold the hand in view of the cameras.</source>
      <translation>Hand ins Blickfeld der Kameras halten.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Press deeper to feel it more, or slide along the surface.</source>
      <translation>Tiefer drücken, um es stärker zu spüren, oder an der Oberfläche entlangfahren.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Touch the object from another side, or with another finger.</source>
      <translation>Das Objekt von einer anderen Seite oder mit einem anderen Finger berühren.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>The arm is stopped. Show a thumb up to continue.</source>
      <translation>Der Arm ist angehalten. Daumen hoch zeigen, um fortzufahren.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Move the closed hand to carry the block. Pinch again to open the gripper.</source>
      <translation>Die geschlossene Hand bewegen, um den Klotz zu tragen. Erneut kneifen, um den Greifer zu öffnen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Move the hand: the arm follows. Pinch at the block to close the gripper.</source>
      <translation>Hand bewegen: Der Arm folgt. Am Klotz kneifen, um den Greifer zu schließen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Point at a building with the index finger and hold still to open it.</source>
      <translation>Mit dem Zeigefinger auf ein Gebäude zeigen und stillhalten, um es zu öffnen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Point with the index finger and push into the swarm.</source>
      <translation>Mit dem Zeigefinger zeigen und in den Schwarm stoßen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Pinch inside the swarm and move the hand to drag it.</source>
      <translation>Im Schwarm kneifen und die Hand bewegen, um ihn zu ziehen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Grasp inside the swarm and pull to stretch it.</source>
      <translation>In den Schwarm greifen und ziehen, um ihn zu strecken.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Make a fist to join the groups.</source>
      <translation>Eine Faust machen, um die Gruppen zu vereinen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Cut through the swarm with the open palm to split it.</source>
      <translation>Mit offener Hand durch den Schwarm fahren, um ihn zu teilen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Sweep the open palm next to the swarm to leave a wall.</source>
      <translation>Mit offener Hand neben dem Schwarm entlangfahren, um eine Wand zu ziehen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>put down {:.0f} mm ahead and {:.0f} mm to the left of the arm's foot</source>
      <translation>abgesetzt {:.0f} mm vor und {:.0f} mm links vom Fuß des Arms</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Applications run on a tracked hand: open the demo, devices or a session.</source>
      <translation>Anwendungen laufen mit einer getrackten Hand: Demo, Geräte oder eine Sitzung öffnen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Nothing has happened yet.</source>
      <translation>Noch ist nichts geschehen.</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>nudges: {}</source>
      <translation>Stöße: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>splits: {}</source>
      <translation>Teilungen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>For browsers on this computer, including a headset's: {}</source>
      <translation>Für Browser auf diesem Rechner, auch den eines Headsets: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>gripper closed</source>
      <translation>Greifer geschlossen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>gripper open</source>
      <translation>Greifer offen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>The application failed and is paused: {}</source>
      <translation>Die Anwendung ist fehlgeschlagen und angehalten: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Touches: {}</source>
      <translation>Berührungen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>last: {}, {:.1f} mm deep</source>
      <translation>letzte: {}, {:.1f} mm tief</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>fingertips that touch now: {}</source>
      <translation>jetzt berührende Fingerspitzen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Moves: {}</source>
      <translation>Bewegungen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>block lifted: {} ×</source>
      <translation>Klotz angehoben: {} ×</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>marked positions: {}</source>
      <translation>markierte Positionen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Open: {}</source>
      <translation>Offen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>moved by {:.0f} cm, turned by {:.0f}°</source>
      <translation>um {:.0f} cm bewegt, um {:.0f}° gedreht</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>size {:.1f} ×</source>
      <translation>Größe {:.1f} ×</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>old plan {:.0f} % visible</source>
      <translation>alter Plan zu {:.0f} % sichtbar</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>Drones: {}</source>
      <translation>Drohnen: {}</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>dragged by {:.0f} cm</source>
      <translation>um {:.0f} cm gezogen</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>stretched to {:.1f} ×</source>
      <translation>auf {:.1f} × gestreckt</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>walls: {}, the last of {:.0f} cm²</source>
      <translation>Wände: {}, die letzte mit {:.0f} cm²</translation>
    </message>
    <message>
      <location filename="extensions/applications/window/view_model.py" />
      <source>The page needs a package that is not installed: pip install "{}"</source>
      <translation>Die Seite braucht ein Paket, das nicht installiert ist: pip install "{}"</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Verdict</source>
      <translation>Urteil</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Rule</source>
      <translation>Regel</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Figure</source>
      <translation>Wert</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Limit</source>
      <translation>Grenze</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Rules</source>
      <translation>Regeln</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Open the &amp;page</source>
      <translation>&amp;Seite öffnen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Report with a plot for each rule</source>
      <translation>Bericht mit einem Diagramm für jede Regel</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Checking the recording…</source>
      <translation>Aufnahme wird geprüft …</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>The recording cannot be checked</source>
      <translation>Die Aufnahme lässt sich nicht prüfen</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>A beep at each beat before a step</source>
      <translation>Ein Ton bei jedem Takt vor einem Schritt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Ten gestures, judged by the rules of robot labs</source>
      <translation>Zehn Gesten, nach den Regeln von Roboterlabors beurteilt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Conformance</source>
      <translation>Konformität</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>All rules passed</source>
      <translation>Alle Regeln bestanden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Not all rules passed</source>
      <translation>Nicht alle Regeln bestanden</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>The simulated wearers of this demo do not follow the gestures, so the rules on gestures will fail. Use the demo of one hand instead.</source>
      <translation>Die simulierten Träger dieser Demo folgen den Gesten nicht, daher werden die Regeln zu Gesten nicht erfüllt. Stattdessen die Demo mit einer Hand verwenden.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Stop the current recording first.</source>
      <translation>Zuerst die laufende Aufnahme beenden.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>{} of {} rules, on {}</source>
      <translation>{} von {} Regeln, bei {}</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>First open and close the hand a few times so that its size is known. Then copy the hand on the left: move into each gesture during three beats and hold it until the ring is full. The recording takes {} seconds.</source>
      <translation>Zuerst die Hand einige Male öffnen und schließen, damit ihre Größe bekannt ist. Dann die Hand links nachmachen: während dreier Takte in jede Geste gehen und sie halten, bis der Ring voll ist. Die Aufnahme dauert {} Sekunden.</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/dialog.py" />
      <source>Judging {}</source>
      <translation>{} wird beurteilt</translation>
    </message>
    <message>
      <location filename="extensions/conformance/window/extension.py" />
      <source>C&amp;onformance…</source>
      <translation>K&amp;onformität…</translation>
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
      <translation>Eine Hand wird getrackt</translation>
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
      <location filename="extensions/loopback/window/flash.py" />
      <source>Point the left camera at this window and tap on the table with the glove, firmly and at irregular times. Esc ends the measurement.</source>
      <translation>Richten Sie die linke Kamera auf dieses Fenster und klopfen Sie mit dem Handschuh kräftig und in unregelmäßigen Abständen auf den Tisch. Esc beendet die Messung.</translation>
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
      <location filename="extensions/openxr/window/extension.py" />
      <source>OpenXR</source>
      <translation>OpenXR</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The layer is not registered. Applications do not find the hand.</source>
      <translation>Die Schicht ist nicht registriert. Anwendungen finden die Hand nicht.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The layer is registered. Applications find the hand when they start.</source>
      <translation>Die Schicht ist registriert. Anwendungen finden die Hand beim Start.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The layer of another version is registered. Register it again.</source>
      <translation>Die Schicht einer anderen Version ist registriert. Registrieren Sie sie erneut.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The registered layer is damaged. Register it again.</source>
      <translation>Die registrierte Schicht ist beschädigt. Registrieren Sie sie erneut.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>No application reads the hand now. The last one was {}, {:.0f} s ago.</source>
      <translation>Keine Anwendung liest die Hand gerade. Die letzte war {} vor {:.0f} s.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>No application has read the hand. Start an application with hand tracking; one that was running before the layer was registered must be started again.</source>
      <translation>Keine Anwendung hat die Hand gelesen. Starten Sie eine Anwendung mit Hand-Tracking; eine, die schon vor der Registrierung lief, muss neu gestartet werden.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>{} reads the hand {:.0f} times per second.</source>
      <translation>{} liest die Hand {:.0f}-mal pro Sekunde.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>{} asks for the hand {:.0f} times per second, but the hand is lost.</source>
      <translation>{} fragt {:.0f}-mal pro Sekunde nach der Hand, aber sie ist verloren.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Register</source>
      <translation>Registrieren</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Adds hand tracking to every OpenXR application of this user</source>
      <translation>Gibt jeder OpenXR-Anwendung dieses Benutzers Hand-Tracking</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Unregister</source>
      <translation>Registrierung entfernen</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Send the hand to OpenXR applications</source>
      <translation>Hand an OpenXR-Anwendungen senden</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Local: where the headset was at the start</source>
      <translation>Lokal: wo das Headset beim Start war</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Stage: the middle of the floor</source>
      <translation>Bühne (Stage): Mitte des Bodens</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Reference space</source>
      <translation>Bezugsraum</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Place the hand in front of the headset</source>
      <translation>Hand vor das Headset setzen</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Hold your hand in front of you, then press: it appears there in applications</source>
      <translation>Halten Sie die Hand vor sich und drücken Sie dann: In Anwendungen erscheint sie dort</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Whether an application reads the hand</source>
      <translation>Ob eine Anwendung die Hand liest</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Testing…</source>
      <translation>Test läuft …</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The hand is not sent.</source>
      <translation>Die Hand wird nicht gesendet.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The hand is sent as soon as tracking runs.</source>
      <translation>Die Hand wird gesendet, sobald das Tracking läuft.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>unnamed</source>
      <translation>ohne Namen</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The hand is sent. No application reads it now.</source>
      <translation>Die Hand wird gesendet. Keine Anwendung liest sie gerade.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Nothing is sent: tick the stream and start tracking, then test.</source>
      <translation>Es wird nichts gesendet: Schalten Sie den Datenstrom ein und starten Sie das Tracking, dann testen Sie.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>To the right</source>
      <translation>Nach rechts</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source> m</source>
      <translation> m</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Up</source>
      <translation>Nach oben</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Backwards</source>
      <translation>Nach hinten</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>Turned to the left</source>
      <translation>Nach links gedreht</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The hand is not tracked, so its position is unknown. Track it first.</source>
      <translation>Die Hand wird nicht getrackt, ihre Position ist daher unbekannt. Starten Sie zuerst das Tracking.</translation>
    </message>
    <message>
      <location filename="extensions/openxr/window/panel.py" />
      <source>The hand is sent and read by {}.</source>
      <translation>Die Hand wird gesendet und gelesen von {}.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Cancelled. No report was written.</source>
      <translation>Abgebrochen. Es wurde kein Bericht geschrieben.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Accuracy report</source>
      <translation>Genauigkeitsbericht</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Recordings</source>
      <translation>Aufnahmen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>&amp;Add…</source>
      <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>&amp;Remove</source>
      <translation>&amp;Entfernen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Correct the markers' &amp;positions (marker offsets)</source>
      <translation>Marker&amp;positionen korrigieren (Markerversatz)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Without &amp;names of recordings and participants</source>
      <translation>Ohne &amp;Namen von Aufnahmen und Teilnehmenden</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>The largest errors. Double-click or Enter pauses the replay at the instant.</source>
      <translation>Die größten Fehler. Doppelklick oder Eingabetaste hält die Wiedergabe an diesem Zeitpunkt an.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Largest errors</source>
      <translation>Größte Fehler</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Progress of the report</source>
      <translation>Fortschritt des Berichts</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>&amp;Open the report</source>
      <translation>Bericht ö&amp;ffnen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>&amp;Cancel</source>
      <translation>&amp;Abbrechen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>&amp;Write report</source>
      <translation>Bericht &amp;schreiben</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Add recordings</source>
      <translation>Aufnahmen hinzufügen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Writing the report…</source>
      <translation>Der Bericht wird geschrieben…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Keypoint</source>
      <translation>Schlüsselpunkt</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Error (mm)</source>
      <translation>Fehler (mm)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/accuracy_dialog.py" />
      <source>Reported sd (mm)</source>
      <translation>Angegebene Std.-Abw. (mm)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/extension.py" />
      <source>Import re&amp;ference…</source>
      <translation>Re&amp;ferenz importieren…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/extension.py" />
      <source>Accurac&amp;y report…</source>
      <translation>Genauig&amp;keitsbericht…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/extension.py" />
      <source>Accuracy report…</source>
      <translation>Genauigkeitsbericht…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Cancelled. Nothing was imported.</source>
      <translation>Abgebrochen. Es wurde nichts importiert.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Import a reference</source>
      <translation>Referenz importieren</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Residuals of the registration</source>
      <translation>Residuen der Registrierung</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Progress of the import</source>
      <translation>Fortschritt des Imports</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Import</source>
      <translation>&amp;Importieren</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Reading the file…</source>
      <translation>Die Datei wird gelesen…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Save the mapping file</source>
      <translation>Zuordnungsdatei speichern</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Importing…</source>
      <translation>Wird importiert…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>none: points are found by their names</source>
      <translation>keine: Punkte werden an ihren Namen erkannt</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Time alignment</source>
      <translation>Zeitabgleich</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>all events; or their name, or a C3D channel</source>
      <translation>alle Ereignisse; oder ihr Name oder ein C3D-Kanal</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Estimate the drift of the clocks</source>
      <translation>Drift der Uhren schätzen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Registration</source>
      <translation>Registrierung</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Template…</source>
      <translation>Vorlage…</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Write a mapping file with the points of this reference, and open it</source>
      <translation>Eine Zuordnungsdatei mit den Punkten dieser Referenz schreiben und öffnen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Recording:</source>
      <translation>Aufnahme:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Hand:</source>
      <translation>&amp;Hand:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Reference file:</source>
      <translation>&amp;Referenzdatei:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Mapping file:</source>
      <translation>Z&amp;uordnungsdatei:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Time alignment:</source>
      <translation>&amp;Zeitabgleich:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Pulses:</source>
      <translation>&amp;Pulse:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>&amp;Start of the reference:</source>
      <translation>&amp;Beginn der Referenz:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Re&amp;gistration:</source>
      <translation>Re&amp;gistrierung:</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Reference file</source>
      <translation>Referenzdatei</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Mapping file</source>
      <translation>Zuordnungsdatei</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Residual, rigid (mm)</source>
      <translation>Residuum, starr (mm)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>With marker offset (mm)</source>
      <translation>Mit Markerversatz (mm)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Marker offset (mm)</source>
      <translation>Markerversatz (mm)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>C3D, TRC, Qualisys TSV, OptiTrack, Vicon, BVH</source>
      <translation>C3D, TRC, Qualisys TSV, OptiTrack, Vicon, BVH</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Reading {}</source>
      <translation>{} wird gelesen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Importing {}</source>
      <translation>{} wird importiert</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>from the file; or {}</source>
      <translation>aus der Datei; oder {}</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Motion-capture recordings ({})</source>
      <translation>Motion-Capture-Aufnahmen ({})</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Mapping files ({})</source>
      <translation>Zuordnungsdateien ({})</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Writing {}</source>
      <translation>{} wird geschrieben</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>Imported into {}.</source>
      <translation>Importiert in {}.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/import_dialog.py" />
      <source>All files</source>
      <translation>Alle Dateien</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>By pulses</source>
      <translation>Nach Pulsen</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Rigid, with marker offsets</source>
      <translation>Starr, mit Markerversatz</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Rigid</source>
      <translation>Starr</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>None (coordinates of the session)</source>
      <translation>Keine (Koordinaten der Sitzung)</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Registration: residual {:.1f} mm rigid, {:.1f} mm with marker offsets.</source>
      <translation>Registrierung: Residuum starr {:.1f} mm, mit Markerversatz {:.1f} mm.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>With start time.</source>
      <translation>Mit Startzeit.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Without a start time.</source>
      <translation>Ohne Startzeit.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Time offset {:+.1f} ms</source>
      <translation>Zeitversatz {:+.1f} ms</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>{}: {:.1f} s at {:.6g} Hz, {} points, {} of {} keypoints.</source>
      <translation>{}: {:.1f} s bei {:.6g} Hz, {} Punkte, {} von {} Schlüsselpunkten.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>{} and {} more</source>
      <translation>{} und {} weitere</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>, drift {:+.1f} ± {:.1f} ppm</source>
      <translation>, Drift {:+.1f} ± {:.1f} ppm</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>, residual {:.1f} ms</source>
      <translation>, Residuum {:.1f} ms</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Assigned: {}.</source>
      <translation>Zugeordnet: {}.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Pulses: {}.</source>
      <translation>Pulse: {}.</translation>
    </message>
    <message>
      <location filename="extensions/reference/window/view_model.py" />
      <source>Without: {}.</source>
      <translation>Es fehlen: {}.</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/extension.py" />
      <source>Robot hand</source>
      <translation>Roboterhand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Read robot hand</source>
      <translation>Roboterhand lesen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Finger</source>
      <translation>Finger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Link of the fingertip</source>
      <translation>Glied der Fingerspitze</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Found by</source>
      <translation>Gefunden durch</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Find automatically</source>
      <translation>Automatisch finden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Discard your choices for this robot hand</source>
      <translation>Ihre Auswahl für diese Roboterhand verwerfen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Read links from a file</source>
      <translation>Glieder aus einer Datei lesen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Save…</source>
      <translation>Speichern…</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Write the links to a file, for other computers and teleop</source>
      <translation>Die Glieder in eine Datei schreiben, für andere Computer und teleop</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Reading the robot hand…</source>
      <translation>Die Roboterhand wird gelesen…</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Load links</source>
      <translation>Glieder laden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Links of fingers (*.toml)</source>
      <translation>Glieder der Finger (*.toml)</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>Save links</source>
      <translation>Glieder speichern</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/finger_table.py" />
      <source>{} mm</source>
      <translation>{} mm</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Drive a simulated robot hand with the tracked hand</source>
      <translation>Eine simulierte Roboterhand mit der getrackten Hand steuern</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Clutch</source>
      <translation>Kupplung</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Return the robot and the objects to their initial poses</source>
      <translation>Roboter und Gegenstände in die Anfangslage bringen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>From a file…</source>
      <translation>Aus einer Datei…</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Fingers</source>
      <translation>Finger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Show which links are the robot's fingertips</source>
      <translation>Zeigt, welche Glieder die Fingerspitzen des Roboters sind</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Motion scale</source>
      <translation>Bewegungsmaßstab</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Distance the robot's palm moves per distance of the hand</source>
      <translation>Weg der Roboterhand je Weg der Hand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Clutch gesture</source>
      <translation>Kupplungsgeste</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>UDP port for robot states</source>
      <translation>UDP-Port für Roboterzustände</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Send the robot's joint states as JSON to this local port</source>
      <translation>Gelenkzustände des Roboters als JSON an diesen lokalen Port senden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>UDP port</source>
      <translation>UDP-Port</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Open robot hand</source>
      <translation>Roboterhand öffnen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>Robot models (*.xml *.mjcf *.urdf)</source>
      <translation>Robotermodelle (*.xml *.mjcf *.urdf)</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/panel.py" />
      <source>On: the robot follows the hand. Off: it holds its pose ({})</source>
      <translation>Ein: Der Roboter folgt der Hand. Aus: Er hält seine Pose ({})</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Shadow hand</source>
      <translation>Shadow-Hand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>none (button only)</source>
      <translation>keine (nur die Taste)</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>pointing</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Index finger</source>
      <translation>Zeigefinger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Middle finger</source>
      <translation>Mittelfinger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Ring finger</source>
      <translation>Ringfinger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Little finger</source>
      <translation>Kleiner Finger</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>your choice</source>
      <translation>Ihre Auswahl</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>name</source>
      <translation>Name</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>position</source>
      <translation>Lage</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Following</source>
      <translation>Folgt</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Estimates skipped in favour of newer ones: {}</source>
      <translation>Zugunsten neuerer übersprungene Schätzungen: {}</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Not connected</source>
      <translation>Nicht verbunden</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Starting the robot…</source>
      <translation>Roboter startet …</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Waiting for the tracked hand</source>
      <translation>Warten auf die getrackte Hand</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Recorded robot</source>
      <translation>Aufgezeichneter Roboter</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Clutch released: the robot holds its pose</source>
      <translation>Kupplung gelöst: Der Roboter hält seine Pose</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>Hand lost: the robot holds its pose</source>
      <translation>Hand verloren: Der Roboter hält seine Pose</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>fingertip error {} mm</source>
      <translation>Fehler der Fingerspitzen {} mm</translation>
    </message>
    <message>
      <location filename="extensions/robot/window/view_model.py" />
      <source>latency {} ms (99 %)</source>
      <translation>Latenz {} ms (99 %)</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Aligning the tracker</source>
      <translation>Tracker ausrichten</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Alignment: where the tracker is on the hand</source>
      <translation>Ausrichtung: wo der Tracker auf der Hand sitzt</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>&amp;Start the movement</source>
      <translation>Bewegung &amp;beginnen</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Store the alignment and use it from now on</source>
      <translation>Die Ausrichtung speichern und ab jetzt verwenden</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Progress of the movement</source>
      <translation>Fortschritt der Bewegung</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>No alignment is in use.</source>
      <translation>Keine Ausrichtung wird verwendet.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Computing the alignment…</source>
      <translation>Ausrichtung wird berechnet …</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Rest the wrist on the edge of a table and hold the hand still.</source>
      <translation>Legen Sie das Handgelenk auf eine Tischkante und halten Sie die Hand ruhig.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Keep the wrist there. Turn the palm up and down.</source>
      <translation>Lassen Sie das Handgelenk dort. Drehen Sie die Handfläche nach oben und nach unten.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Keep the wrist there. Move the fingers up and down.</source>
      <translation>Lassen Sie das Handgelenk dort. Bewegen Sie die Finger auf und ab.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Keep the wrist there. Move the fingers left and right.</source>
      <translation>Lassen Sie das Handgelenk dort. Bewegen Sie die Finger nach links und rechts.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Connect the glove and start tracking first</source>
      <translation>Verbinden Sie zuerst den Handschuh und starten Sie das Tracking</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Choose the tracker on this hand first.</source>
      <translation>Wählen Sie zuerst den Tracker an dieser Hand.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>The tracker is {:.0f}, {:.0f}, {:.0f} mm from the wrist.</source>
      <translation>Der Tracker ist {:.0f}, {:.0f}, {:.0f} mm vom Handgelenk entfernt.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>The rotations agree within {:.1f}°, and the wrist was at rest within {:.1f} mm (rms).</source>
      <translation>Die Drehungen stimmen auf {:.1f}° überein, das Handgelenk ruhte auf {:.1f} mm genau (RMS).</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>The poses are {:.0f} ms late.</source>
      <translation>Die Posen kommen {:.0f} ms verspätet.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>In use: {}</source>
      <translation>Verwendet wird: {}</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>{} packets of the glove, {} poses</source>
      <translation>{} Pakete des Handschuhs, {} Posen</translation>
    </message>
    <message>
      <location filename="extensions/room/window/align_box.py" />
      <source>Saved, and in use: {}</source>
      <translation>Gespeichert und in Verwendung: {}</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Room tracker</source>
      <translation>Tracker im Raum</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Receive poses from this source</source>
      <translation>Posen von dieser Quelle empfangen</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Source</source>
      <translation>Quelle</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>&amp;Test</source>
      <translation>&amp;Testen</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Whether poses arrive, and of which trackers</source>
      <translation>Ob Posen ankommen, und von welchen Trackern</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Listening…</source>
      <translation>Warten auf Posen …</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>The source is being opened. Start again.</source>
      <translation>Die Quelle wird gerade geöffnet. Beginnen Sie noch einmal.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>Switch the source on and test it first.</source>
      <translation>Schalten Sie zuerst die Quelle ein und testen Sie sie.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/dialog.py" />
      <source>The source is being opened. Test it again.</source>
      <translation>Die Quelle wird gerade geöffnet. Testen Sie noch einmal.</translation>
    </message>
    <message>
      <location filename="extensions/room/window/extension.py" />
      <source>&amp;Room tracker…</source>
      <translation>Tracker im &amp;Raum …</translation>
    </message>
    <message>
      <location filename="extensions/room/window/listening.py" />
      <source>{}: {:.0f} poses per second</source>
      <translation>{}: {:.0f} Posen pro Sekunde</translation>
    </message>
    <message>
      <location filename="extensions/room/window/listening.py" />
      <source>{}: {:.0f} positions per second, without rotation</source>
      <translation>{}: {:.0f} Positionen pro Sekunde, ohne Drehung</translation>
    </message>
    <message>
      <location filename="extensions/room/window/listening.py" />
      <source>and {} more</source>
      <translation>und {} weitere</translation>
    </message>
    <message>
      <location filename="extensions/room/window/source_form.py" />
      <source>Name of the tracker on the hand; any: every tracker; empty: none</source>
      <translation>Name des Trackers an der Hand; any: jeder Tracker; leer: keiner</translation>
    </message>
    <message>
      <location filename="extensions/room/window/source_form.py" />
      <source>Tracker on the right hand</source>
      <translation>Tracker an der rechten Hand</translation>
    </message>
    <message>
      <location filename="extensions/room/window/source_form.py" />
      <source>Tracker on the left hand</source>
      <translation>Tracker an der linken Hand</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Report of the study</source>
      <translation>Bericht der Studie</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Time until the next cue</source>
      <translation>Zeit bis zur nächsten Anweisung</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Steps that are done</source>
      <translation>Erledigte Schritte</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Repo&amp;rt</source>
      <translation>Be&amp;richt</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>E&amp;xclude</source>
      <translation>A&amp;usschließen</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Keep the recording, but do not evaluate it</source>
      <translation>Aufnahme behalten, aber nicht auswerten</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>&amp;Repeat</source>
      <translation>&amp;Wiederholen</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Verdict on {}</source>
      <translation>Urteil über {}</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>&amp;Continue</source>
      <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>&amp;Pause</source>
      <translation>&amp;Pause</translation>
    </message>
    <message>
      <location filename="extensions/study/window/dialog.py" />
      <source>Study: {}</source>
      <translation>Studie: {}</translation>
    </message>
    <message>
      <location filename="extensions/study/window/extension.py" />
      <source>St&amp;udy…</source>
      <translation>St&amp;udie…</translation>
    </message>
    <message>
      <location filename="extensions/study/window/start.py" />
      <source>Protocol of a study</source>
      <translation>Protokoll einer Studie</translation>
    </message>
    <message>
      <location filename="extensions/study/window/start.py" />
      <source>Protocols (*.toml)</source>
      <translation>Protokolle (*.toml)</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>{:.1f} s, tracked {:.0f} % of the time, measured {:.0f} %, inferred {:.0f} %, {} packets lost, {:.0f} images per second</source>
      <translation>{:.1f} s, {:.0f} % der Zeit getrackt, {:.0f} % gemessen, {:.0f} % erschlossen, {} Pakete verloren, {:.0f} Bilder pro Sekunde</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Not good</source>
      <translation>Nicht gut</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>&amp;Accept anyway</source>
      <translation>Trotzdem &amp;annehmen</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Finished</source>
      <translation>Fertig</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Thank you!</source>
      <translation>Vielen Dank!</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>All trials are done.</source>
      <translation>Alle Durchgänge sind erledigt.</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>&amp;Finished</source>
      <translation>&amp;Fertig</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Good</source>
      <translation>Gut</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>&amp;Accept and continue</source>
      <translation>&amp;Annehmen und weiter</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>{}: {} of {} trials done</source>
      <translation>{}: {} von {} Durchgängen erledigt</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Get ready</source>
      <translation>Machen Sie sich bereit</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Rest</source>
      <translation>Pause</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Relax the hand.</source>
      <translation>Entspannen Sie die Hand.</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>&amp;Skip the rest</source>
      <translation>Pause über&amp;springen</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>{:.1f} s</source>
      <translation>{:.1f} s</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>Practice: {}</source>
      <translation>Übung: {}</translation>
    </message>
    <message>
      <location filename="extensions/study/window/view_model.py" />
      <source>{}, try {}</source>
      <translation>{}, Versuch {}</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Touch test</source>
      <translation>Berührungstest</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Printed line of 260 mm, measured with a ruler:</source>
      <translation>Gedruckte Linie von 260 mm, mit dem Lineal gemessen:</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Time on the cross</source>
      <translation>Zeit auf dem Kreuz</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Cues carried out</source>
      <translation>Ausgeführte Aufgaben</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>S&amp;ave the sheet…</source>
      <translation>Blatt &amp;speichern…</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>The sheet and its ridge as PDF, to be printed</source>
      <translation>Das Blatt und der Steg als PDF zum Drucken</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>&amp;Touched</source>
      <translation>&amp;Berührt</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Accept the touch although it was not detected</source>
      <translation>Die Berührung gelten lassen, obwohl sie nicht erkannt wurde</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>S&amp;kip</source>
      <translation>Ü&amp;berspringen</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>&amp;Repeat the last one</source>
      <translation>&amp;Letzte wiederholen</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Save the sheet</source>
      <translation>Blatt speichern</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>The report is ready</source>
      <translation>Der Bericht ist fertig</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>No report was written</source>
      <translation>Es wurde kein Bericht geschrieben</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Sheet of the touch test</source>
      <translation>Blatt des Berührungstests</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Touch the crosses of the printed sheet</source>
      <translation>Berühren Sie die Kreuze auf dem gedruckten Blatt</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Lay the sheet in front of the camera, and keep your hand out of its view. The test takes about five minutes.</source>
      <translation>Legen Sie das Blatt vor die Kamera; Ihre Hand darf nicht im Bild sein. Der Test dauert etwa fünf Minuten.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/dialog.py" />
      <source>Sheet saved: {}. Print it at 100 %.</source>
      <translation>Blatt gespeichert: {}. Drucken Sie es mit 100 %.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/extension.py" />
      <source>&amp;Touch test…</source>
      <translation>Ber&amp;ührungstest…</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Approach slowly.</source>
      <translation>Nähern Sie sich langsam.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Approach quickly.</source>
      <translation>Nähern Sie sich schnell.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Turn the hand to the left.</source>
      <translation>Drehen Sie die Hand nach links.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Turn the hand to the right.</source>
      <translation>Drehen Sie die Hand nach rechts.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Hold a finger of the other hand over the back of the hand.</source>
      <translation>Halten Sie einen Finger der anderen Hand über den Handrücken.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>First take the hand out of view for five seconds.</source>
      <translation>Nehmen Sie die Hand zuerst fünf Sekunden lang aus dem Bild.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Pinch thumb and index finger 20 times</source>
      <translation>Führen Sie Daumen und Zeigefinger 20-mal zusammen</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>About once a second.</source>
      <translation>Etwa einmal pro Sekunde.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Hold the hand still for ten seconds</source>
      <translation>Halten Sie die Hand zehn Sekunden lang still</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Rest it on the table.</source>
      <translation>Legen Sie sie auf den Tisch.</translation>
    </message>
    <message>
      <location filename="extensions/touch/window/view_model.py" />
      <source>Touch cross {} with the {}</source>
      <translation>Berühren Sie Kreuz {} mit dem {}</translation>
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
      <source>inertial (IMUs only, no position)</source>
      <translation>inertial (nur IMUs, ohne Position)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>UDP (JSON)</source>
      <translation>UDP (JSON)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>version of the JSON messages: 2, or 1 for programs that read only that</source>
      <translation>Version der JSON-Nachrichten: 2, oder 1 für Programme, die nur diese lesen</translation>
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
      <source>whether velocities follow each pose in a bundle of their own</source>
      <translation>ob auf jede Pose Geschwindigkeiten in einem eigenen Bündel folgen</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>OpenXR applications</source>
      <translation>OpenXR-Anwendungen</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>reference space of the placement: local or stage</source>
      <translation>Bezugsraum der Platzierung: local oder stage</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>position of Glovetrack's origin in that space, m to the right</source>
      <translation>Position des Glovetrack-Ursprungs in diesem Raum, m nach rechts</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>m up</source>
      <translation>m nach oben</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>m backwards</source>
      <translation>m nach hinten</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>how far Glovetrack's forward direction is turned to the left, deg</source>
      <translation>wie weit die Vorwärtsrichtung von Glovetrack nach links gedreht ist, Grad</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>how far poses are predicted beyond the newest sample at most, ms</source>
      <translation>wie weit Posen über den neuesten Messwert hinaus höchstens vorhergesagt werden, ms</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>SteamVR, VRChat (VMT)</source>
      <translation>SteamVR, VRChat (VMT)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>number of the right hand's device, 0 to 57</source>
      <translation>Nummer des Geräts der rechten Hand, 0 bis 57</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>number of the left hand's device, 0 to 57</source>
      <translation>Nummer des Geräts der linken Hand, 0 bis 57</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>whether the device is at the position of a controller in the hand instead of at the wrist</source>
      <translation>ob das Gerät dort ist, wo ein Controller in der Hand wäre, statt am Handgelenk</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>gesture for the trigger</source>
      <translation>Geste für den Trigger</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>gesture for the grip</source>
      <translation>Geste für den Griff</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>gesture for button A</source>
      <translation>Geste für Taste A</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>gesture for button B</source>
      <translation>Geste für Taste B</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Monado (serial line)</source>
      <translation>Monado (serielle Leitung)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>path of a link to the serial port, with {side} for left or right</source>
      <translation>Pfad einer Verknüpfung zur seriellen Schnittstelle, mit {side} für left oder right</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>SteamVR (OpenGloves)</source>
      <translation>SteamVR (OpenGloves)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>path of the driver's pipe; {side} stands for left or right</source>
      <translation>Pfad der Pipe des Treibers; {side} steht für left oder right</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Hand Tracking Streamer</source>
      <translation>Hand Tracking Streamer</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>udp; tcp: connect to a program that listens; server: wait for programs to connect</source>
      <translation>udp; tcp: mit einem wartenden Programm verbinden; server: auf Verbindungen von Programmen warten</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>whether lines have a frame number and a time</source>
      <translation>ob Zeilen eine Bildnummer und eine Zeit haben</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>MediaPipe (JSON)</source>
      <translation>MediaPipe (JSON)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>width (m) that the virtual camera's image shows</source>
      <translation>Breite (m), die das Bild der virtuellen Kamera zeigt</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Keyed poses (Isaac, retargeting)</source>
      <translation>Benannte Posen (Isaac, Retargeting)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>tips: wrist and fingertips; openxr: 26 joints; landmarks: 21, in MediaPipe's order</source>
      <translation>tips: Handgelenk und Fingerspitzen; openxr: 26 Gelenke; landmarks: 21, in der Reihenfolge von MediaPipe</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>world: z up; openxr: y up; wrist: relative to the wrist; operator: dex-retargeting's</source>
      <translation>world: z nach oben; openxr: y nach oben; wrist: relativ zum Handgelenk; operator: das von dex-retargeting</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>whether each pose also has a 4×4 matrix</source>
      <translation>ob jede Pose auch eine 4×4-Matrix hat</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Lab Streaming Layer</source>
      <translation>Lab Streaming Layer</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>its library listens on all addresses of this computer, so others in the same network can read it, unless a firewall blocks it</source>
      <translation>seine Bibliothek lauscht an allen Adressen dieses Computers; andere im selben Netz können mitlesen, wenn keine Firewall dies verhindert</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>whether other computers can discover the outlet</source>
      <translation>ob andere Computer den Ausgang finden können</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>2: with numbers and velocities in further channels; 1: without</source>
      <translation>2: mit Nummern und Geschwindigkeiten in weiteren Kanälen; 1: ohne</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Foxglove</source>
      <translation>Foxglove</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>further sites whose pages may connect, separated by commas</source>
      <translation>weitere Websites, deren Seiten sich verbinden dürfen, durch Kommas getrennt</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>Isaac record (MCAP)</source>
      <translation>Isaac-Handdaten (MCAP)</translation>
    </message>
    <message>
      <location filename="glovetrack.streams" />
      <source>whether wrist and fingertips are also trackers of their own</source>
      <translation>ob Handgelenk und Fingerspitzen auch eigene Tracker sind</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>UDP (JSON, words)</source>
      <translation>UDP (JSON, Wörter)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>listening address</source>
      <translation>Adresse, an der empfangen wird</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>listening port</source>
      <translation>Port, an dem empfangen wird</translation>
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
      <location filename="glovetrack.remote" />
      <source>127.0.0.1: markers of this computer only</source>
      <translation>127.0.0.1: nur Marker dieses Computers</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>SteamVR vibration (VMT)</source>
      <translation>SteamVR-Vibration (VMT)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>port to which VMT's driver sends</source>
      <translation>Port, an den der Treiber von VMT sendet</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>motors that vibrate: a list such as thumb,index, or all</source>
      <translation>Motoren, die vibrieren: eine Liste wie thumb,index oder all</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>Wrist pose (VMC, OSC)</source>
      <translation>Lage des Handgelenks (VMC, OSC)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>listening port; that of a VMC Marionette</source>
      <translation>Port, an dem empfangen wird; der einer VMC-Marionette</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name or serial number of the right hand's tracker; any: every tracker</source>
      <translation>Name oder Seriennummer des Trackers der rechten Hand; any: jeder Tracker</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name or serial number of the left hand's tracker; any: every tracker</source>
      <translation>Name oder Seriennummer des Trackers der linken Hand; any: jeder Tracker</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>file that glovetrack room align has written</source>
      <translation>Datei, die glovetrack room align geschrieben hat</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>degrees by which the room is turned about the vertical</source>
      <translation>Grad, um die der Raum um die Senkrechte gedreht wird</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>milliseconds between a measurement and its arrival</source>
      <translation>Millisekunden zwischen einer Messung und ihrer Ankunft</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>standard deviation of positions, mm</source>
      <translation>Standardabweichung der Positionen, mm</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>standard deviation of rotations, degrees</source>
      <translation>Standardabweichung der Drehungen, Grad</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>Wrist pose (OptiTrack)</source>
      <translation>Lage des Handgelenks (OptiTrack)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>address of this computer in Motive's network</source>
      <translation>Adresse dieses Computers im Netz von Motive</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>data port</source>
      <translation>Datenport</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>address of the computer that runs Motive; empty: only listen</source>
      <translation>Adresse des Computers, auf dem Motive läuft; leer: nur zuhören</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>multicast group; empty: unicast</source>
      <translation>Multicast-Gruppe; leer: Unicast</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>axis of Motive that points up</source>
      <translation>Achse von Motive, die nach oben zeigt</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>streaming ID of the right hand's rigid body; any: every body</source>
      <translation>Streaming-ID des Starrkörpers der rechten Hand; any: jeder Körper</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>streaming ID of the left hand's rigid body; any: every body</source>
      <translation>Streaming-ID des Starrkörpers der linken Hand; any: jeder Körper</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>Wrist pose (LSL)</source>
      <translation>Lage des Handgelenks (LSL)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>type of the stream: x y z qx qy qz qw, or x y z; m</source>
      <translation>Typ des Streams: x y z qx qy qz qw oder x y z; m</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>whether streams of other computers are read</source>
      <translation>ob Streams anderer Computer gelesen werden</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>axis of the stream that points up</source>
      <translation>Achse des Streams, die nach oben zeigt</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name of the right hand's stream; any: every stream</source>
      <translation>Name des Streams der rechten Hand; any: jeder Stream</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name of the left hand's stream; any: every stream</source>
      <translation>Name des Streams der linken Hand; any: jeder Stream</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>Wrist pose (VRPN)</source>
      <translation>Lage des Handgelenks (VRPN)</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>address of the computer that runs the VRPN server</source>
      <translation>Adresse des Computers, auf dem der VRPN-Server läuft</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>port of the server</source>
      <translation>Port des Servers</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>axis of the server that points up</source>
      <translation>Achse des Servers, die nach oben zeigt</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name of the right hand's tracker; any: every tracker</source>
      <translation>Name des Trackers der rechten Hand; any: jeder Tracker</translation>
    </message>
    <message>
      <location filename="glovetrack.remote" />
      <source>name of the left hand's tracker; any: every tracker</source>
      <translation>Name des Trackers der linken Hand; any: jeder Tracker</translation>
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
      <translation>OpenSim-Modell der getrackten Hand (OSIM)</translation>
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
      <source>Video with the hand drawn in (MP4)</source>
      <translation>Video mit eingezeichneter Hand (MP4)</translation>
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
      <location filename="glovetrack.notices" />
      <source>{text}</source>
      <translation>{text}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The left and right images are swapped and not used. Exchange the two cameras.</source>
      <translation>Linkes und rechtes Bild sind vertauscht und werden nicht verwendet. Tauschen Sie die beiden Kameras.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The left and right images are in order again.</source>
      <translation>Linkes und rechtes Bild sind wieder in Ordnung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The two images are offset vertically by {apart_px:.1f} pixels: a lens has moved since the stereo calibration. Calibrate the camera again.</source>
      <translation>Die beiden Bilder sind in der Höhe um {apart_px:.1f} Pixel versetzt: Seit der Stereo-Kalibrierung hat sich ein Objektiv verschoben. Kalibrieren Sie die Kamera neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The two images fit the stereo calibration again.</source>
      <translation>Die beiden Bilder passen wieder zur Stereo-Kalibrierung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The two images are offset vertically by {apart_px:.1f} pixels against the stereo calibration. Tracking corrects this, but distances may be wrong. Calibrate the camera again.</source>
      <translation>Die beiden Bilder sind gegenüber der Stereokalibrierung um {apart_px:.1f} Pixel in der Höhe versetzt. Das Tracking gleicht dies aus, Abstände können aber falsch sein. Kalibrieren Sie die Kamera neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The images have moved relative to each other by {jump_px:.0f} pixels at once: a lens was knocked. If this does not recover, calibrate the camera again.</source>
      <translation>Die Bilder haben sich auf einmal um {jump_px:.0f} Pixel gegeneinander verschoben: Ein Objektiv wurde angestoßen. Wenn das so bleibt, kalibrieren Sie die Kamera neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>All markers have jumped by {jump_px:.0f} pixels at once: the camera was moved. Positions now refer to its new location.</source>
      <translation>Alle Marker sind auf einmal um {jump_px:.0f} Pixel gesprungen: Die Kamera wurde bewegt. Positionen beziehen sich jetzt auf ihren neuen Standort.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The lamps flicker at {lamp_hz} Hz, and the brightness of images varies by ±{percent:.0f} %. Set the camera's power-line frequency to {mains_hz} Hz, or its exposure to a multiple of 1/{lamp_hz} s.</source>
      <translation>Die Lampen flimmern mit {lamp_hz} Hz, und die Helligkeit der Bilder schwankt um ±{percent:.0f} %. Stellen Sie die Netzfrequenz der Kamera auf {mains_hz} Hz oder ihre Belichtungszeit auf ein Vielfaches von 1/{lamp_hz} s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The brightness of images no longer flickers.</source>
      <translation>Die Helligkeit der Bilder flimmert nicht mehr.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} is connected.</source>
      <translation>Die Kamera {camera} ist verbunden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} delivers no images. Waiting for it.</source>
      <translation>Die Kamera {camera} liefert keine Bilder. Es wird auf sie gewartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The end of {camera} is reached.</source>
      <translation>Das Ende von {camera} ist erreicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera delivers images of {width} by {height} pixels, but its calibration is for {calibrated_width} by {calibrated_height}. Choose that size, or calibrate the camera again.</source>
      <translation>Die Kamera liefert Bilder von {width} × {height} Pixeln, ihre Kalibrierung gilt aber für {calibrated_width} × {calibrated_height}. Wählen Sie diese Größe, oder kalibrieren Sie die Kamera neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {side:word} camera delivers images of {width} by {height} pixels, but the calibration is for {calibrated_width} by {calibrated_height}. Choose that size, or calibrate the cameras again.</source>
      <translation>Die Kamera {side:word} liefert Bilder von {width} × {height} Pixeln, die Kalibrierung gilt aber für {calibrated_width} × {calibrated_height}. Wählen Sie diese Größe, oder kalibrieren Sie die Kameras neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image of the {side:word} camera is black. Check whether the lens is covered.</source>
      <translation>Das Bild der Kamera {side:word} ist schwarz. Prüfen Sie, ob das Objektiv verdeckt ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image of the {side:word} camera is frozen and not used.</source>
      <translation>Das Bild der Kamera {side:word} ist eingefroren und wird nicht verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image of the {side:word} camera is incomplete: a part of it did not arrive.</source>
      <translation>Das Bild der Kamera {side:word} ist unvollständig: Ein Teil ist nicht angekommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image of the {side:word} camera is back.</source>
      <translation>Das Bild der Kamera {side:word} ist wieder da.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera delivers {rate_hz:.0f} images per second instead of {asked_hz:.0f}. The exposure is too long in poor light, or the USB port is too slow.</source>
      <translation>Die Kamera liefert {rate_hz:.0f} statt {asked_hz:.0f} Bilder pro Sekunde. Entweder ist die Belichtung bei schwachem Licht zu lang, oder der USB-Anschluss ist zu langsam.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera grants only {rate_hz:.0f} images per second at {width} × {height} pixels ({format}) instead of {asked_hz:.0f}. Plug it into another USB port (USB 3, without a hub), or choose a smaller image size.</source>
      <translation>Die Kamera gewährt nur {rate_hz:.0f} Bilder pro Sekunde mit {width} × {height} Pixeln ({format}) statt {asked_hz:.0f}. Stecken Sie sie an einen anderen USB-Anschluss (USB 3, ohne Hub), oder wählen Sie eine kleinere Bildgröße.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera grants {rate_hz:.0f} images per second at {width} × {height} pixels ({format}); {asked_hz:.0f} were requested.</source>
      <translation>Die Kamera gewährt {rate_hz:.0f} Bilder pro Sekunde mit {width} × {height} Pixeln ({format}); {asked_hz:.0f} wurden angefordert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera grants images of {width} × {height} instead of {asked_width} × {asked_height} pixels. Choose a size that the camera has and calibrate for it, or use another camera.</source>
      <translation>Die Kamera gewährt Bilder mit {width} × {height} statt {asked_width} × {asked_height} Pixeln. Wählen Sie eine Größe, die die Kamera hat, und kalibrieren Sie dafür, oder verwenden Sie eine andere Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} does not confirm these settings: {settings:words}. Set them with the camera's own program.</source>
      <translation>Die Kamera {camera} bestätigt diese Einstellungen nicht: {settings:words}. Stellen Sie sie im Programm der Kamera ein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera delivers one image, but the calibration is for two. Calibrate it as one camera.</source>
      <translation>Die Kamera liefert ein Bild, die Kalibrierung gilt aber für zwei. Kalibrieren Sie sie als eine Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera delivers two images, but the calibration is for one camera. Calibrate both, or choose one camera in the camera's set-up.</source>
      <translation>Die Kamera liefert zwei Bilder, die Kalibrierung gilt aber für eine Kamera. Kalibrieren Sie beide, oder wählen Sie in der Einrichtung der Kamera eine Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no camera plug-in {name}. Install its package.</source>
      <translation>Es gibt keine Kamera-Erweiterung {name}. Installieren Sie ihr Paket.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera plug-in {name} does not work: {why}</source>
      <translation>Die Kamera-Erweiterung {name} funktioniert nicht: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The cameras of this system cannot be listed by name ({why}). Enter the camera's number under Set-up, Camera, Or number, file: 0 is the first one.</source>
      <translation>Die Kameras dieses Systems lassen sich nicht mit Namen auflisten ({why}). Geben Sie die Nummer der Kamera unter Einrichtung, Kamera, Oder Nummer, Datei ein: 0 ist die erste.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} cannot be opened: it is not connected.</source>
      <translation>Die Kamera {camera} lässt sich nicht öffnen: Sie ist nicht angeschlossen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} cannot be opened: it is not connected, or another program uses it.</source>
      <translation>Die Kamera {camera} lässt sich nicht öffnen: Sie ist nicht angeschlossen, oder ein anderes Programm verwendet sie.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>lenses is "{lenses}"; it may be {known:or}.</source>
      <translation>lenses ist „{lenses}“; möglich ist {known:or}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is only one camera, which counts as the left one.</source>
      <translation>Es gibt nur eine Kamera; sie gilt als die linke.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera delivers usable images again.</source>
      <translation>Die Kamera liefert wieder brauchbare Bilder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera has delivered no usable image for {silent_s:g} s.</source>
      <translation>Die Kamera hat seit {silent_s:g} s kein brauchbares Bild geliefert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove {glove} is made for the {made_for:word} hand and cannot track the {side:word} one.</source>
      <translation>Der Handschuh {glove} ist für die Hand {made_for:word} gemacht und kann die Hand {side:word} nicht tracken.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No packets from the {side:word} glove: the hand follows the images alone.</source>
      <translation>Keine Pakete vom Handschuh ({side:word}): Die Hand folgt nur den Bildern.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Packets from the {side:word} glove are arriving again.</source>
      <translation>Pakete vom Handschuh ({side:word}) kommen wieder an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This looks like a glove for the {other:word} hand: its patches are mirrored. The file {glove} is for the {side:word} hand. Choose one for the {other:word} hand.</source>
      <translation>Das sieht nach einem Handschuh für die andere Hand aus ({other:word}): Seine Flicken sind gespiegelt. Die Datei {glove} gilt für die Hand {side:word}. Wählen Sie eine für die Hand {other:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Markers {markers:list} of the {side:word} glove are about {offset_mm:.0f} mm from their positions in the glove file. Measure the glove again: record two minutes of free motion, then run glovetrack fit-glove.</source>
      <translation>Handschuh ({side:word}): Die Marker {markers:list} sind etwa {offset_mm:.0f} mm von ihren Positionen in der Handschuhdatei entfernt. Vermessen Sie den Handschuh neu: Nehmen Sie zwei Minuten freie Bewegung auf, dann führen Sie glovetrack fit-glove aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The IMU {imu:word} of the {side:word} glove is rotated by about {angle_deg:.0f}° from its mounting in the glove file. Measure the glove again: record two minutes of free motion, then run glovetrack fit-glove.</source>
      <translation>Handschuh ({side:word}): Die IMU {imu:word} ist gegenüber ihrer Lage in der Handschuhdatei um etwa {angle_deg:.0f}° verdreht. Vermessen Sie den Handschuh neu: Nehmen Sie zwei Minuten freie Bewegung auf, dann führen Sie glovetrack fit-glove aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove {glove} has no IMU on {segment:word}.</source>
      <translation>Der Handschuh {glove} hat keine IMU auf {segment:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's port cannot be opened: {why}</source>
      <translation>Der Anschluss des Handschuhs lässt sich nicht öffnen: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Another program has the glove's port open. Close it; the glove is then used automatically.</source>
      <translation>Ein anderes Programm belegt den Anschluss des Handschuhs. Schließen Sie es; der Handschuh wird dann automatisch verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Another USB adapter has the same serial number as the glove's at {port}. Gloves are then recognised by their own number: give each a different one (glovetrack firmware write PORT --glove-id N).</source>
      <translation>Ein weiterer USB-Adapter hat dieselbe Seriennummer wie der des Handschuhs an {port}. Handschuhe werden dann an ihrer eigenen Nummer erkannt: Geben Sie jedem eine andere (glovetrack firmware write PORT --glove-id N).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove restarted when a motor started: the motor draws more current than the supply delivers. Charge the battery, or give the motors a supply and a capacitor of their own.</source>
      <translation>Der Handschuh ist neu gestartet, als ein Motor anlief: Der Motor zieht mehr Strom, als die Versorgung liefert. Laden Sie den Akku, oder geben Sie den Motoren eine eigene Versorgung mit Kondensator.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove restarts because its supply voltage drops. Charge the battery, use a shorter or thicker USB cable, and avoid unpowered hubs.</source>
      <translation>Der Handschuh startet neu, weil seine Versorgungsspannung einbricht. Laden Sie den Akku, verwenden Sie ein kürzeres oder dickeres USB-Kabel, und vermeiden Sie Hubs ohne Netzteil.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Bursts of damaged data arrive from the glove: its cable or a plug has a bad contact. Move the cable less, check the plugs, or replace the cable.</source>
      <translation>Vom Handschuh treffen schubweise beschädigte Daten ein: Sein Kabel oder ein Stecker hat einen Wackelkontakt. Bewegen Sie das Kabel weniger, prüfen Sie die Stecker, oder tauschen Sie das Kabel aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove is lost again and again: its select line has a bad contact. Check the wires and solder joints of this IMU.</source>
      <translation>Die IMU {imu} des Handschuhs fällt immer wieder aus: Ihre Auswahlleitung hat einen Wackelkontakt. Prüfen Sie die Drähte und Lötstellen dieser IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The system has suspended the glove's USB adapter to save power. Install the udev rule of the package, or run: echo on | sudo tee /sys/bus/usb/devices/*/power/control</source>
      <translation>Das System hat den USB-Adapter des Handschuhs zum Stromsparen angehalten. Installieren Sie die udev-Regel des Pakets, oder führen Sie aus: echo on | sudo tee /sys/bus/usb/devices/*/power/control</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The data from the glove's port cannot be decoded at {baud} baud. Choose another speed under Set-up, Glove, or write the firmware for this speed.</source>
      <translation>Die Daten vom Anschluss des Handschuhs lassen sich mit {baud} Baud nicht dekodieren. Wählen Sie unter Einrichtung, Handschuh eine andere Geschwindigkeit, oder schreiben Sie die Firmware für diese Geschwindigkeit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove was unplugged ({why}). It is used again as soon as it returns.</source>
      <translation>Der Handschuh wurde abgezogen ({why}). Er wird wieder verwendet, sobald er zurück ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Message from the glove: {text}</source>
      <translation>Meldung des Handschuhs: {text}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This glove has {imus} IMUs but the glove file has {expected}. Choose the right glove file.</source>
      <translation>Dieser Handschuh hat {imus} IMUs, die Handschuhdatei aber {expected}. Wählen Sie die richtige Handschuhdatei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove is back, at {port}.</source>
      <translation>Der Handschuh ist wieder da, an {port}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has restarted. Streaming is started again.</source>
      <translation>Der Handschuh wurde neu gestartet. Die Übertragung beginnt erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove is sending again.</source>
      <translation>Der Handschuh sendet wieder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Packets contain {imus} IMUs but the glove file has {expected}. Choose the right glove file.</source>
      <translation>Pakete enthalten {imus} IMUs, die Handschuhdatei aber {expected}. Wählen Sie die richtige Handschuhdatei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's clock jumped by {jump_s:+.3f} s. Its packets are synchronised again.</source>
      <translation>Die Uhr des Handschuhs ist um {jump_s:+.3f} s gesprungen. Seine Pakete werden neu synchronisiert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has not identified itself. Streaming is started anyway.</source>
      <translation>Der Handschuh hat sich nicht zu erkennen gegeben. Die Übertragung wird trotzdem gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has sent nothing for {silent_s:g} s.</source>
      <translation>Der Handschuh hat seit {silent_s:g} s nichts gesendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pulse {number} on the glove</source>
      <translation>Impuls {number} am Handschuh</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove sends {rate_hz:.0f} packets per second instead of {asked_hz}. Their time stamps are still right.</source>
      <translation>Der Handschuh sendet {rate_hz:.0f} statt {asked_hz} Pakete pro Sekunde. Ihre Zeitstempel stimmen trotzdem.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has not reported its ranges, so its values are not used yet. Hold the hand still for a second, so that gravity reveals them.</source>
      <translation>Der Handschuh hat seine Messbereiche nicht gemeldet; seine Werte werden deshalb noch nicht verwendet. Halten Sie die Hand eine Sekunde still, damit die Schwerkraft sie verrät.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>At rest the glove's acceleration fits a range of {accel_g} g, which is used now. For rotation, {gyro_dps} °/s is assumed, which may be wrong.</source>
      <translation>In Ruhe passt die Beschleunigung des Handschuhs zu einem Messbereich von {accel_g} g, der jetzt verwendet wird. Für Drehungen werden {gyro_dps} °/s angenommen; das kann falsch sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's battery is low ({volts:.2f} V). Charge it soon.</source>
      <translation>Der Akku des Handschuhs ist schwach ({volts:.2f} V). Laden Sie ihn bald.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Left glove: {what}</source>
      <translation>Linker Handschuh: {what}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Right glove: {what}</source>
      <translation>Rechter Handschuh: {what}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove at {port} is number {found}, but number {glove_id} is expected. To use another glove, choose it under Set-up, Glove.</source>
      <translation>Der Handschuh an {port} hat die Nummer {found}, erwartet wird aber die Nummer {glove_id}. Um einen anderen Handschuh zu verwenden, wählen Sie ihn unter Einrichtung, Handschuh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The device at {port} is not a glove, but glove number {glove_id} is expected. To use another glove, choose it under Set-up, Glove.</source>
      <translation>Das Gerät an {port} ist kein Handschuh; erwartet wird der Handschuh Nummer {glove_id}. Um einen anderen Handschuh zu verwenden, wählen Sie ihn unter Einrichtung, Handschuh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove has a chip of an unknown kind ({chip}). It passed its self-test and is used.</source>
      <translation>IMU {imu} des Handschuhs hat einen Chip unbekannter Art ({chip}). Er hat seinen Selbsttest bestanden und wird verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove has a chip of an unknown kind ({chip}) that did not pass its self-test. It is not used: keep the glove still and restart it, or replace the IMU.</source>
      <translation>IMU {imu} des Handschuhs hat einen Chip unbekannter Art ({chip}), der seinen Selbsttest nicht bestanden hat. Er wird nicht verwendet: Halten Sie den Handschuh still und starten Sie ihn neu, oder ersetzen Sie die IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove is at the end of its range. These samples are not used; move more slowly, or protect the glove from impacts.</source>
      <translation>IMU {imu} des Handschuhs ist am Ende ihres Bereichs. Diese Messwerte werden nicht verwendet; bewegen Sie sich langsamer, oder schützen Sie den Handschuh vor Stößen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove is not responding.</source>
      <translation>IMU {imu} des Handschuhs antwortet nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove is responding again.</source>
      <translation>IMU {imu} des Handschuhs antwortet wieder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu} of the glove: axes that no longer change: {axes:list}. Restart the glove; if this persists, replace the IMU.</source>
      <translation>IMU {imu} des Handschuhs: Achsen, die sich nicht mehr ändern: {axes:list}. Starten Sie den Handschuh neu; bleibt das so, tauschen Sie die IMU aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording has {rests} rests; at least {fewest} in different positions are needed. Lay the glove still for two seconds on each side of a box.</source>
      <translation>Die Aufnahme enthält {rests} Ruhelagen; nötig sind mindestens {fewest} in verschiedenen Lagen. Legen Sie den Handschuh auf jeder Seite einer Schachtel zwei Sekunden lang ruhig hin.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no temperatures of IMUs. Firmware 1.3 of the glove reports them.</source>
      <translation>{path} enthält keine Temperaturen der IMUs. Die Firmware 1.3 des Handschuhs meldet sie.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is a recording of another glove: it has the IMU {imu}.</source>
      <translation>{path} ist die Aufnahme eines anderen Handschuhs: Sie enthält die IMU {imu}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recordings have no rest of three seconds. Lay the glove down at the beginning and at the end.</source>
      <translation>Die Aufnahmen enthalten keine Ruhe von drei Sekunden. Legen Sie den Handschuh am Anfang und am Ende ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Motor {motor} runs for {duration_ms} ms with amplitude {amplitude} of 255.</source>
      <translation>Motor {motor} läuft {duration_ms} ms lang mit Amplitude {amplitude} von 255.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The noise of a vibration cannot be negative.</source>
      <translation>Das Rauschen einer Vibration kann nicht negativ sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Glove {glove}: the change of the biases with the temperature was learned for {imus} IMUs; its uncertainty fell from {before:.3f} to {after:.3f} °/s per °C. {file} contains the result, which is used from the next start on.</source>
      <translation>Handschuh {glove}: Die Änderung der Nullpunktfehler mit der Temperatur wurde für {imus} IMUs gelernt; ihre Unsicherheit sank von {before:.3f} auf {after:.3f} °/s je °C. {file} enthält das Ergebnis, das ab dem nächsten Start verwendet wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Glove {glove}: the biases of the IMUs {imus} do not change with the temperature as its file states, so nothing was learned. Lay the glove down for ten seconds before and after the next recording; if this message returns, remove the key drift from the file.</source>
      <translation>Handschuh {glove}: Die Nullpunktfehler der IMUs {imus} ändern sich mit der Temperatur nicht so, wie es in seiner Datei steht; deshalb wurde nichts gelernt. Legen Sie den Handschuh vor und nach der nächsten Aufnahme zehn Sekunden lang ab; erscheint diese Meldung wieder, entfernen Sie den Schlüssel drift aus der Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The two gloves are exchanged: each uses the files of the other hand. Choose the hand of each in the gloves' set-up.</source>
      <translation>Die beiden Handschuhe sind vertauscht: Jeder verwendet die Dateien der anderen Hand. Wählen Sie in der Einrichtung der Handschuhe für jeden die Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port} cannot be opened: {why}.</source>
      <translation>{port} lässt sich nicht öffnen: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port} was disconnected: {why}.</source>
      <translation>{port} wurde getrennt: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port} sends {received_bytes} bytes that are not a glove's: it is another device, or its line is not set to {bauds:or} baud.</source>
      <translation>{port} sendet {received_bytes} Bytes, die nicht von einem Handschuh stammen: Es ist ein anderes Gerät, oder seine Leitung ist nicht auf {bauds:or} Baud eingestellt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The device at {port} is not responding.</source>
      <translation>Das Gerät an {port} antwortet nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The USB adapter at {port} holds bytes back for up to {latency_ms} ms. For faster tracking set it to 1 ms: echo 1 | sudo tee {setting}</source>
      <translation>Der USB-Adapter an {port} hält Bytes bis zu {latency_ms} ms zurück. Stellen Sie für schnelleres Tracking 1 ms ein: echo 1 | sudo tee {setting}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The USB adapter at {port} may hold bytes back for up to 16 ms. For faster tracking set 1 ms in the Device Manager: Ports, {port}, Port Settings, Advanced, Latency Timer.</source>
      <translation>Der USB-Adapter an {port} hält Bytes möglicherweise bis zu 16 ms zurück. Stellen Sie für schnelleres Tracking im Geräte-Manager 1 ms ein: Anschlüsse, {port}, Anschlusseinstellungen, Erweitert, Wartezeit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>More than {limit} coloured patches in an image; {ignored} ignored so far.</source>
      <translation>Mehr als {limit} farbige Flicken in einem Bild; bisher wurden {ignored} ignoriert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There are {left} left and {right} right images. A sequence requires as many of one as of the other.</source>
      <translation>Es gibt {left} linke und {right} rechte Bilder. Eine Folge braucht von beiden gleich viele.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stereo image is {width_px} pixels wide and cannot be split into two halves.</source>
      <translation>Das Stereobild ist {width_px} Pixel breit und lässt sich nicht in zwei Hälften teilen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an image that can be read.</source>
      <translation>{path} ist kein lesbares Bild.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove is not responding yet. Unplug it, then plug it in again.</source>
      <translation>Der Handschuh antwortet noch nicht. Ziehen Sie ihn ab und stecken Sie ihn wieder an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The number of a glove is 1 to {most}, not {number}. Two gloves need different numbers.</source>
      <translation>Die Nummer eines Handschuhs liegt zwischen 1 und {most}, nicht bei {number}. Zwei Handschuhe brauchen verschiedene Nummern.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is firmware for {bauds:or} baud, not for {baud}.</source>
      <translation>Es gibt Firmware für {bauds:or} Baud, nicht für {baud}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be read as firmware: {why}</source>
      <translation>{path} lässt sich nicht als Firmware lesen: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: line {line} is damaged, so the file is not used.</source>
      <translation>{path}: Zeile {line} ist beschädigt; die Datei wird nicht verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: line {line} has a gap or an unknown type of record.</source>
      <translation>{path}: Zeile {line} hat eine Lücke oder einen unbekannten Eintragstyp.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} ends before its last line: the file is incomplete.</source>
      <translation>{path} endet vor der letzten Zeile: Die Datei ist unvollständig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not firmware of a glove (version 1.1 or later).</source>
      <translation>{path} ist keine Firmware eines Handschuhs (ab Version 1.1).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has {size_bytes} bytes; the chip has {chip_bytes}.</source>
      <translation>{path} hat {size_bytes} Bytes, der Chip nur {chip_bytes}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>avrdude, which writes the firmware, is not installed. On Debian run: sudo apt-get install avrdude; for other systems see github.com/avrdudes/avrdude.</source>
      <translation>avrdude, das die Firmware schreibt, ist nicht installiert. Unter Debian: sudo apt-get install avrdude; für andere Systeme siehe github.com/avrdudes/avrdude.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Firmware {version} is available (installed: {installed}).</source>
      <translation>Firmware {version} ist verfügbar (installiert: {installed}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: avrdude failed. (avrdude: {output})</source>
      <translation>{port}: avrdude ist fehlgeschlagen. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: the board is not responding as a bootloader. Try the other kind ({others:list}), and press reset just before. (avrdude: {output})</source>
      <translation>{port}: Die Platine antwortet nicht als Bootloader. Versuchen Sie die andere Art ({others:list}), und drücken Sie unmittelbar vorher Reset. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: you are not allowed to open the port. On Linux, join the group dialout. (avrdude: {output})</source>
      <translation>{port}: Sie dürfen den Anschluss nicht öffnen. Treten Sie unter Linux der Gruppe dialout bei. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: another program uses the port. Close it. (avrdude: {output})</source>
      <translation>{port}: Ein anderes Programm verwendet den Anschluss. Schließen Sie es. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: no device is connected to the port. (avrdude: {output})</source>
      <translation>{port}: An diesem Anschluss ist kein Gerät. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: the chip's contents differ from what was written. Write the firmware again. (avrdude: {output})</source>
      <translation>{port}: Der Inhalt des Chips weicht vom Geschriebenen ab. Schreiben Sie die Firmware erneut. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port}: the chip is not an ATmega328P. (avrdude: {output})</source>
      <translation>{port}: Der Chip ist kein ATmega328P. (avrdude: {output})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A ZED has no images {height_px} pixels high. Possible heights: {known:list}.</source>
      <translation>Eine ZED hat keine {height_px} Pixel hohen Bilder. Mögliche Höhen: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a calibration file of a ZED camera: {why}</source>
      <translation>{path} ist keine Kalibrierdatei einer ZED-Kamera: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no {key} in [{section}]: the file is incomplete, or belongs to another camera.</source>
      <translation>{path} enthält {key} nicht in [{section}]: Die Datei ist unvollständig oder gehört zu einer anderen Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: {key} in [{section}] is "{text}", which is not a number.</source>
      <translation>{path}: {key} in [{section}] ist „{text}“, also keine Zahl.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated camera did not start.</source>
      <translation>Die simulierte Kamera ist nicht gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated glove requires a pseudo-terminal, which this system does not have.</source>
      <translation>Der simulierte Handschuh braucht ein Pseudoterminal, das es auf diesem System nicht gibt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated cameras require named pipes, which this system does not have.</source>
      <translation>Die simulierten Kameras brauchen benannte Pipes, die es auf diesem System nicht gibt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An image must be in colour with 8 bits per channel, not of shape {shape} and type {type}.</source>
      <translation>Ein Bild muss farbig sein und 8 Bit je Kanal haben, nicht Form {shape} und Typ {type}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated glove did not start.</source>
      <translation>Der simulierte Handschuh ist nicht gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove was found at {port}. {reasons}</source>
      <translation>An {port} wurde kein Handschuh gefunden. {reasons}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove was found on any USB port. {reasons}</source>
      <translation>An keinem USB-Anschluss wurde ein Handschuh gefunden. {reasons}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No camera was found. Plug in the stereo camera, then choose Search again. If this system lists no cameras, enter the number of yours under Set-up, Camera, Or number, file (0 is the first one).</source>
      <translation>Keine Kamera gefunden. Schließen Sie die Stereokamera an und wählen Sie Erneut suchen. Wenn dieses System keine Kameras auflistet, geben Sie die Nummer unter Einrichtung, Kamera, Oder Nummer, Datei ein (0 ist die erste).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera {camera} is not connected. Connected cameras: {connected:list}. Plug it in, or choose another one under Set-up, Camera.</source>
      <translation>Die Kamera {camera} ist nicht angeschlossen. Angeschlossene Kameras: {connected:list}. Schließen Sie sie an, oder wählen Sie unter Einrichtung, Kamera eine andere.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera was closed. Start glove and camera again.</source>
      <translation>Die Kamera wurde geschlossen. Starten Sie Handschuh und Kamera erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process ended unexpectedly. The computer may be out of memory.</source>
      <translation>Der Prozess endete unerwartet. Möglicherweise fehlt dem Rechner Speicher.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{problems}</source>
      <translation>{problems}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove was found on any USB serial port. Plug it in, then try again.</source>
      <translation>An keinem seriellen USB-Anschluss wurde ein Handschuh gefunden. Einstecken und erneut versuchen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove was found. {reasons}</source>
      <translation>Es wurde kein Handschuh gefunden. {reasons}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera has no calibration yet. Make or import one under Set-up, Camera calibration.</source>
      <translation>Die Kamera ist noch nicht kalibriert. Unter Einrichtung, Kamerakalibrierung eine Kalibrierung erstellen oder importieren.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's settings cannot be changed: {why}.</source>
      <translation>Die Einstellungen des Handschuhs lassen sich nicht ändern: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The folder {folder} no longer exists.</source>
      <translation>Der Ordner {folder} existiert nicht mehr.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has not been tracked. Choose Track again first.</source>
      <translation>Für {file} gibt es kein Tracking. Zuerst „Tracking wiederholen“ wählen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>they have no version number</source>
      <translation>sie haben keine Versionsnummer</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>they were written by a later version of Glovetrack</source>
      <translation>sie wurden von einer neueren Version von Glovetrack geschrieben</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>it is too large</source>
      <translation>zu groß</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is being recorded.</source>
      <translation>{file} wird gerade aufgenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is open. Close it first (Ctrl+W).</source>
      <translation>{file} ist geöffnet. Zuerst schließen (Strg+W).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a readable image.</source>
      <translation>{file} ist kein lesbares Bild.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}: the image could not be encoded.</source>
      <translation>{file}: Das Bild konnte nicht kodiert werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} exists again. It was not replaced by the removed file.</source>
      <translation>{file} existiert wieder und wurde nicht durch die entfernte Datei ersetzt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} was not removed: {why}.</source>
      <translation>{name} wurde nicht entfernt: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The tags of {file} were not moved with it: {why}.</source>
      <translation>Die Schlagwörter von {file} wurden nicht mit verschoben: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} cannot be moved to the trash.</source>
      <translation>{file} kann nicht in den Papierkorb verschoben werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} exists again, so it was not restored from the trash.</source>
      <translation>{file} existiert wieder und wurde daher nicht aus dem Papierkorb wiederhergestellt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no image yet to fit the colours to.</source>
      <translation>Es gibt noch kein Bild, an das die Farben angepasst werden könnten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No markers were tracked yet. Fit from the image alone first.</source>
      <translation>Noch wurden keine Marker getrackt. Erst allein aus dem Bild anpassen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} must have the hues {hues:words} for this glove.</source>
      <translation>{file} muss für diesen Handschuh die Farbtöne {hues:words} enthalten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Cannot record to {folder}: {why}.</source>
      <translation>Aufnahme nach {folder} nicht möglich: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A file name can contain {known}, not {field}.</source>
      <translation>Ein Dateiname kann {known} enthalten, nicht {field}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The file name "{template}" is incomplete. It can contain text and {known}.</source>
      <translation>Der Dateiname „{template}“ ist unvollständig. Er kann Text und {known} enthalten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The check itself failed: {why}.</source>
      <translation>Die Prüfung selbst ist fehlgeschlagen: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Attach this report to a bug report.</source>
      <translation>Hängen Sie diesen Bericht an einen Fehlerbericht an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{device} is in use by this window and was not tested.</source>
      <translation>{device} wird von diesem Fenster benutzt und wurde nicht geprüft.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Glovetrack {version}, Python {python}, {platform}.</source>
      <translation>Glovetrack {version}, Python {python}, {platform}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{cores} cores, {memory_gb:.1f} GB of memory.</source>
      <translation>{cores} Kerne, {memory_gb:.1f} GB Arbeitsspeicher.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Use a computer with at least {cores} cores and 4 GB.</source>
      <translation>Verwenden Sie einen Rechner mit mindestens {cores} Kernen und 4 GB.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The program's numerical code is compiled.</source>
      <translation>Der numerische Code des Programms ist kompiliert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The program's numerical code is compiled while it runs (by {compiler}).</source>
      <translation>Der numerische Code des Programms wird während des Laufs kompiliert (durch {compiler}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The first start takes minutes. Reinstall the package to avoid this.</source>
      <translation>Der erste Start dauert Minuten. Installieren Sie das Paket neu, um das zu vermeiden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Other programs use {load_percent:.0f} % of all cores.</source>
      <translation>Andere Programme belegen {load_percent:.0f} % aller Kerne.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Close other programs before you start tracking.</source>
      <translation>Schließen Sie andere Programme, bevor Sie das Tracking starten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Tracking at {fps:.0f} images per second takes {share_percent:.0f} % of a core at the present load: {detection_percent:.0f} % for the images, {filter_percent:.0f} % for the filter.</source>
      <translation>Das Tracking mit {fps:.0f} Bildern pro Sekunde belegt bei der jetzigen Last {share_percent:.0f} % eines Kerns: {detection_percent:.0f} % für die Bilder, {filter_percent:.0f} % für das Filter.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Tracking runs before other programs (real-time priority).</source>
      <translation>Das Tracking läuft vor anderen Programmen (Echtzeitpriorität).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Tracking waits for other programs: this user has no real-time priority.</source>
      <translation>Das Tracking wartet auf andere Programme: dieser Benutzer hat keine Echtzeitpriorität.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>If other programs run during recordings, add the line "USER - rtprio 1" with your user name to /etc/security/limits.d/glovetrack.conf, and log in again.</source>
      <translation>Wenn während Aufnahmen andere Programme laufen: die Zeile „USER - rtprio 1“ mit Ihrem Benutzernamen in /etc/security/limits.d/glovetrack.conf eintragen und neu anmelden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Close other programs, and choose 30 images per second.</source>
      <translation>Schließen Sie andere Programme und wählen Sie 30 Bilder pro Sekunde.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The disk of {folder} takes {disk_mb_s:.0f} MB/s; a recording needs up to {needed_mb_s:.0f} MB/s.</source>
      <translation>Der Datenträger von {folder} schafft {disk_mb_s:.0f} MB/s; eine Aufnahme braucht bis zu {needed_mb_s:.0f} MB/s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Record to another disk, or record without images.</source>
      <translation>Nehmen Sie auf einen anderen Datenträger auf, oder ohne Bilder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Choose another folder for recordings.</source>
      <translation>Wählen Sie einen anderen Ordner für Aufnahmen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{free_gb:.0f} GB are free: at least {minutes:.0f} minutes of recording with images.</source>
      <translation>{free_gb:.0f} GB sind frei: mindestens {minutes:.0f} Minuten Aufnahme mit Bildern.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Delete or move old recordings.</source>
      <translation>Löschen oder verschieben Sie alte Aufnahmen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no graphics card: the processor draws the 3D view.</source>
      <translation>Es gibt keine Grafikkarte: Der Prozessor zeichnet die 3D-Ansicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Install the card's driver. Tracking itself does not need one.</source>
      <translation>Installieren Sie den Treiber der Karte. Das Tracking selbst braucht keinen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Graphics card {name}.</source>
      <translation>Grafikkarte {name}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This user may not use the graphics card {name}.</source>
      <translation>Dieser Benutzer darf die Grafikkarte {name} nicht verwenden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Add yourself to its group (sudo usermod -aG render,video $USER) and log in again.</source>
      <translation>Nehmen Sie sich in ihre Gruppe auf (sudo usermod -aG render,video $USER) und melden Sie sich neu an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenGL uses the graphics card: {renderer}.</source>
      <translation>OpenGL verwendet die Grafikkarte: {renderer}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenGL uses the processor: {renderer}.</source>
      <translation>OpenGL verwendet den Prozessor: {renderer}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenGL does not work.</source>
      <translation>OpenGL funktioniert nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Install the graphics card's driver; until then the 3D view is simpler.</source>
      <translation>Installieren Sie den Treiber der Grafikkarte; bis dahin ist die 3D-Ansicht einfacher.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This user may not open {device}.</source>
      <translation>Dieser Benutzer darf {device} nicht öffnen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Add yourself to the group {group} (sudo usermod -aG {group} $USER) and log in again, or install the udev rule {rule} of the package.</source>
      <translation>Nehmen Sie sich in die Gruppe {group} auf (sudo usermod -aG {group} $USER) und melden Sie sich neu an, oder installieren Sie die udev-Regel {rule} des Pakets.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unplug the device, then plug it in again.</source>
      <translation>Ziehen Sie das Gerät ab und stecken Sie es wieder an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This user may open all {devices} device files.</source>
      <translation>Dieser Benutzer darf alle {devices} Gerätedateien öffnen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The udev rule {rule} is not installed.</source>
      <translation>Die udev-Regel {rule} ist nicht installiert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Install the package, or copy the rule to /etc/udev/rules.d: it gives access to new devices and sets the latency timer of USB adapters.</source>
      <translation>Installieren Sie das Paket, oder kopieren Sie die Regel nach /etc/udev/rules.d: Sie erlaubt den Zugriff auf neue Geräte und stellt die Wartezeit von USB-Adaptern ein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>pkexec is not installed. Copy the rule to {target} as an administrator, then run: udevadm control --reload</source>
      <translation>pkexec ist nicht installiert. Kopieren Sie die Regel als Administrator nach {target}, und führen Sie aus: udevadm control --reload</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The rule was not installed: the request was not authorized.</source>
      <translation>Die Regel wurde nicht installiert: Die Anfrage wurde nicht genehmigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The rule was not installed: {why}</source>
      <translation>Die Regel wurde nicht installiert: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no USB serial port.</source>
      <translation>Es gibt keinen seriellen USB-Anschluss.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Plug the glove in.</source>
      <translation>Stecken Sie den Handschuh an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove responds on any port.</source>
      <translation>An keinem Anschluss antwortet ein Handschuh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Check the cable, or write the firmware.</source>
      <translation>Prüfen Sie das Kabel, oder schreiben Sie die Firmware.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Close the other program, then check again.</source>
      <translation>Schließen Sie das andere Programm und prüfen Sie erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>If a glove is connected there, write its firmware.</source>
      <translation>Wenn dort ein Handschuh angeschlossen ist, schreiben Sie seine Firmware.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Two USB adapters have the same serial number.</source>
      <translation>Zwei USB-Adapter haben dieselbe Seriennummer.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Gloves are then recognised by their own number: give each a different one (glovetrack firmware write PORT --glove-id N).</source>
      <translation>Handschuhe werden dann an ihrer eigenen Nummer erkannt: Geben Sie jedem eine andere (glovetrack firmware write PORT --glove-id N).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove at {port} sends at {baud} baud, which Glovetrack does not use.</source>
      <translation>Der Handschuh an {port} sendet mit {baud} Baud, die Glovetrack nicht verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Write the firmware again: glovetrack firmware write {port} --baud {baud}.</source>
      <translation>Schreiben Sie die Firmware neu: glovetrack firmware write {port} --baud {baud}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{port} sends bytes that cannot be decoded at {bauds:or} baud.</source>
      <translation>{port} sendet Bytes, die mit {bauds:or} Baud nicht lesbar sind.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>If it is a glove, its firmware has another baud rate or the cable is damaged: write the firmware again. Otherwise ignore this line.</source>
      <translation>Wenn es ein Handschuh ist, hat seine Firmware eine andere Baudrate oder das Kabel ist beschädigt: Schreiben Sie die Firmware neu. Andernfalls beachten Sie diese Zeile nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove at {port} sends samples but does not answer.</source>
      <translation>Der Handschuh an {port} sendet Messwerte, antwortet aber nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Glove {glove} at {port}: {imus} IMUs, firmware {firmware}, {baud} baud.</source>
      <translation>Handschuh {glove} an {port}: {imus} IMUs, Firmware {firmware}, {baud} Baud.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Run glovetrack firmware write {port}.</source>
      <translation>Führen Sie glovetrack firmware write {port} aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove at {port} answers but sends no samples.</source>
      <translation>Der Handschuh an {port} antwortet, sendet aber keine Messwerte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unplug it, then plug it in again. If this does not help, write the firmware.</source>
      <translation>Ziehen Sie ihn ab und stecken Sie ihn wieder an. Wenn das nicht hilft, schreiben Sie die Firmware.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{rate_hz:.1f} packets per second, {lost_percent:.1f} % lost, {damaged} damaged.</source>
      <translation>{rate_hz:.1f} Pakete pro Sekunde, {lost_percent:.1f} % verloren, {damaged} beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Use a shorter cable and another USB port, without a hub, and check the plugs.</source>
      <translation>Verwenden Sie ein kürzeres Kabel und einen anderen USB-Anschluss ohne Hub, und prüfen Sie die Stecker.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{rate_hz} were requested: write the current firmware.</source>
      <translation>{rate_hz} wurden angefordert: Schreiben Sie die aktuelle Firmware.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's battery has {volts:.2f} V.</source>
      <translation>Der Akku des Handschuhs hat {volts:.2f} V.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Charge the glove.</source>
      <translation>Laden Sie den Handschuh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMUs that do not respond: {imus:list}.</source>
      <translation>IMUs, die nicht antworten: {imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Check the wires of these IMUs: supply, clock, data and select line.</source>
      <translation>Prüfen Sie die Leitungen dieser IMUs: Versorgung, Takt, Daten und Auswahl.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>All {imus} IMUs respond.</source>
      <translation>Alle {imus} IMUs antworten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Keep the glove still and restart it; otherwise replace the IMU.</source>
      <translation>Halten Sie den Handschuh still und starten Sie ihn neu; andernfalls ersetzen Sie die IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu}: {chip}, self-test {selftest:word}.</source>
      <translation>IMU {imu}: {chip}, Selbsttest {selftest:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu}: {chip}, self-test {selftest:word}, {temperature_c:.1f} °C.</source>
      <translation>IMU {imu}: {chip}, Selbsttest {selftest:word}, {temperature_c:.1f} °C.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu}: axes that do not change: {axes:list}.</source>
      <translation>IMU {imu}: Achsen, die sich nicht ändern: {axes:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Replace the IMU.</source>
      <translation>Ersetzen Sie die IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>IMU {imu}: {samples} samples at the end of the range.</source>
      <translation>IMU {imu}: {samples} Messwerte am Ende des Bereichs.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Move the glove more slowly. If it is at rest, replace the IMU.</source>
      <translation>Bewegen Sie den Handschuh langsamer. Wenn er ruht, ersetzen Sie die IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The delay of 90 % of the packets varies by {spread_ms:.1f} ms.</source>
      <translation>Die Verzögerung von 90 % der Pakete schwankt um {spread_ms:.1f} ms.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Set the adapter's latency timer to 1 ms, and avoid USB hubs.</source>
      <translation>Stellen Sie die Wartezeit des Adapters auf 1 ms, und meiden Sie USB-Hubs.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's clock differs by {skew_ppm:+.0f} ppm.</source>
      <translation>Die Uhr des Handschuhs weicht um {skew_ppm:+.0f} ppm ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Replace the board: its crystal is out of tolerance.</source>
      <translation>Ersetzen Sie die Platine: Ihr Quarz liegt außerhalb der Toleranz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no camera.</source>
      <translation>Es gibt keine Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Plug the camera in.</source>
      <translation>Stecken Sie die Kamera an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Close other programs that use it, or plug it in again.</source>
      <translation>Schließen Sie andere Programme, die sie verwenden, oder stecken Sie sie neu an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: {measured_fps:.1f} images per second of {width} × {height} pixels.</source>
      <translation>{camera}: {measured_fps:.1f} Bilder pro Sekunde mit {width} × {height} Pixeln.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: {what}</source>
      <translation>{camera}: {what}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: {measured_fps:.0f} images per second arrive instead of the {granted_fps:.0f} granted.</source>
      <translation>{camera}: {measured_fps:.0f} Bilder pro Sekunde kommen an statt der zugesagten {granted_fps:.0f}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Add light or shorten the exposure; otherwise use another USB port.</source>
      <translation>Mehr Licht oder kürzere Belichtung; andernfalls ein anderer USB-Anschluss.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera} opens but no images arrive.</source>
      <translation>{camera} lässt sich öffnen, liefert aber keine Bilder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Plug it into another USB port; another camera on the same hub may use its bandwidth.</source>
      <translation>Stecken Sie sie an einen anderen USB-Anschluss; eine andere Kamera am selben Hub kann seine Bandbreite belegen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: the image is black.</source>
      <translation>{camera}: Das Bild ist schwarz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Take the cover off the lens.</source>
      <translation>Nehmen Sie die Abdeckung vom Objektiv.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera} has no exposure control: its automatic exposure cannot be verified.</source>
      <translation>{camera} hat keine Belichtungssteuerung: Ihre Belichtungsautomatik ist nicht prüfbar.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Keep the light constant, or use a camera with a manual exposure.</source>
      <translation>Halten Sie das Licht konstant, oder verwenden Sie eine Kamera mit manueller Belichtung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera} does not confirm that its exposure is locked.</source>
      <translation>{camera} bestätigt nicht, dass die Belichtung fest ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Check the exposure in the camera's own program, and keep the light constant.</source>
      <translation>Prüfen Sie die Belichtung im Programm der Kamera, und halten Sie das Licht konstant.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: the exposure can be locked.</source>
      <translation>{camera}: Die Belichtung lässt sich festhalten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: the driver stamps images with {stamp_jitter_ms:.1f} ms of jitter; they arrive with {arrival_jitter_ms:.1f} ms.</source>
      <translation>{camera}: Der Treiber stempelt Bilder mit {stamp_jitter_ms:.1f} ms Schwankung; sie kommen mit {arrival_jitter_ms:.1f} ms an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{camera}: the driver does not stamp images; they arrive with {arrival_jitter_ms:.1f} ms of jitter.</source>
      <translation>{camera}: Der Treiber stempelt Bilder nicht; sie kommen mit {arrival_jitter_ms:.1f} ms Schwankung an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Use another USB port without a hub, and close other programs.</source>
      <translation>Verwenden Sie einen anderen USB-Anschluss ohne Hub, und schließen Sie andere Programme.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Tracking stopped: the detected markers do not match the glove file. Fit the colours, or check whether two of the hues are exchanged.</source>
      <translation>Tracking angehalten: Die erkannten Marker passen nicht zur Handschuhdatei. Passen Sie die Farben an, oder prüfen Sie, ob zwei Farbtöne vertauscht sind.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Looking for the hand.</source>
      <translation>Die Hand wird gesucht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand is tracked.</source>
      <translation>Die Hand wird getrackt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand is out of sight; its position is extrapolated.</source>
      <translation>Die Hand ist außer Sicht; ihre Position wird fortgeschrieben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The position of the hand is lost; finger angles are still measured.</source>
      <translation>Die Position der Hand ist verloren; die Fingerwinkel werden weiter gemessen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Looking for the {side:word} hand.</source>
      <translation>Die Hand {side:word} wird gesucht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {side:word} hand is tracked.</source>
      <translation>Die Hand {side:word} wird getrackt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {side:word} hand is out of sight; its position is extrapolated.</source>
      <translation>Die Hand {side:word} ist außer Sicht; ihre Position wird fortgeschrieben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The position of the {side:word} hand is lost; finger angles are still measured.</source>
      <translation>Die Position der Hand {side:word} ist verloren; die Fingerwinkel werden weiter gemessen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset: the engine {engine} does not support it. Choose the engine chain or inertial.</source>
      <translation>Pose zurücksetzen: Das Verfahren {engine} unterstützt das nicht. Wählen Sie das Verfahren chain oder inertial.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset, {side:word} hand: not possible before the hand is tracked.</source>
      <translation>Pose zurücksetzen, Hand {side:word}: nicht möglich, bevor die Hand getrackt wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset, {side:word} hand: not done, because fingers are bent. Hold the hand flat and try again.</source>
      <translation>Pose zurücksetzen, Hand {side:word}: nicht ausgeführt, weil Finger gebeugt sind. Halten Sie die Hand flach und versuchen Sie es erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset, {side:word} hand: not done, because the fingers point up or down. Hold the hand level and try again.</source>
      <translation>Pose zurücksetzen, Hand {side:word}: nicht ausgeführt, weil die Finger nach oben oder unten zeigen. Halten Sie die Hand waagerecht und versuchen Sie es erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset, {side:word} hand: joints corrected by up to {joints_deg:.0f}°. The heading is measured by the camera.</source>
      <translation>Pose zurückgesetzt, Hand {side:word}: Gelenke um bis zu {joints_deg:.0f}° berichtigt. Die Richtung misst die Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset, {side:word} hand: joints corrected by up to {joints_deg:.0f}°, heading by {heading_deg:.0f}°.</source>
      <translation>Pose zurückgesetzt, Hand {side:word}: Gelenke um bis zu {joints_deg:.0f}°, Richtung um {heading_deg:.0f}° berichtigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pose reset: hand flat, fingers straight ahead.</source>
      <translation>Pose zurückgesetzt: Hand flach, Finger gerade nach vorn.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The pose of the wrist from another tracking system is ignored: this engine uses the camera. Choose the engine inertial to use it.</source>
      <translation>Die Lage des Handgelenks aus einem anderen Trackingsystem wird ignoriert: Dieses Verfahren nutzt die Kamera. Wählen Sie das Verfahren inertial, um sie zu nutzen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{side:word} hand: the pose of the wrist from another tracking system disagrees with gravity by more than 30° and is ignored. Align the tracker with the hand.</source>
      <translation>Hand {side:word}: Die Lage des Handgelenks aus einem anderen Trackingsystem weicht um mehr als 30° von der Schwerkraft ab und wird ignoriert. Richten Sie den Tracker zur Hand aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine {engine} does not learn from guided poses.</source>
      <translation>Das Verfahren {engine} lernt nicht aus geführten Posen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no guided pose "{pose}". It is ignored.</source>
      <translation>Es gibt keine geführte Pose „{pose}“. Sie wird ignoriert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The guided pose "{pose}" neither begins nor ends. It is ignored.</source>
      <translation>Die geführte Pose „{pose}“ beginnt weder noch endet sie. Sie wird ignoriert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{instruction:word}</source>
      <translation>{instruction:word}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine {engine} requires a camera with a stereo calibration. Without one, choose the engine {other}, which shows the hand by its IMUs.</source>
      <translation>Das Verfahren {engine} braucht eine Kamera mit Stereokalibrierung. Wählen Sie ohne Kamera das Verfahren {other}, das die Hand anhand ihrer IMUs zeigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine {engine} requires both lenses. With one lens, choose the engine chain.</source>
      <translation>Das Verfahren {engine} braucht beide Objektive. Wählen Sie mit einem Objektiv das Verfahren chain.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine {engine} requires an IMU and markers on the {segment:word}.</source>
      <translation>Das Verfahren {engine} braucht eine IMU und Marker auf {segment:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine vist requires an IMU on every segment of a chain; the glove {glove} has none on {segments:list}.</source>
      <translation>Das Verfahren vist braucht eine IMU auf jedem Glied einer Kette; der Handschuh {glove} hat keine auf {segments:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine vist requires one IMU per segment; the glove {glove} has more.</source>
      <translation>Das Verfahren vist braucht genau eine IMU je Glied; der Handschuh {glove} hat mehr.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This engine does not use a wearer's profile. Choose the engine chain.</source>
      <translation>Dieses Verfahren verwendet kein Profil einer Person. Wählen Sie das Verfahren chain.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no finger estimator "{name}". Available: {known:list}.</source>
      <translation>Es gibt keinen Fingerschätzer „{name}“. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process that tracks has ended.</source>
      <translation>Der Tracking-Prozess wurde beendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process that tracks does not answer.</source>
      <translation>Der Tracking-Prozess antwortet nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine is now {engine}.</source>
      <translation>Das Verfahren ist jetzt {engine}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>System overloaded: 3D view frame rate reduced.</source>
      <translation>System überlastet: Bildrate der 3D-Ansicht verringert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>System overloaded: camera images are shown without overlays.</source>
      <translation>System überlastet: Kamerabilder werden ohne Einblendungen gezeigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>System overloaded: images are searched only where markers are expected.</source>
      <translation>System überlastet: Bilder werden nur dort durchsucht, wo Marker erwartet werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>System overloaded: fewer images are searched. All packets of the glove are still used.</source>
      <translation>System überlastet: Es werden weniger Bilder durchsucht. Alle Pakete des Handschuhs werden weiter verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The system is no longer overloaded: full 3D view frame rate.</source>
      <translation>Das System ist nicht mehr überlastet: volle Bildrate der 3D-Ansicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Camera images are shown with overlays again.</source>
      <translation>Kamerabilder werden wieder mit Einblendungen gezeigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Whole images are searched again.</source>
      <translation>Bilder werden wieder vollständig durchsucht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>All images are searched again.</source>
      <translation>Alle Bilder werden wieder durchsucht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {thread} thread failed: {type}: {why}.</source>
      <translation>Der Thread {thread} ist ausgefallen: {type}: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no segment "{segment}" whose calibration is estimated.</source>
      <translation>Es gibt kein Glied {segment}, dessen Kalibrierung geschätzt wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A hand is {least_mm:.0f} to {most_mm:.0f} mm long, from the crease of the wrist to the tip of the middle finger; {length_mm:.0f} mm is not plausible. Measure it again.</source>
      <translation>Eine Hand ist von der Falte des Handgelenks bis zur Spitze des Mittelfingers {least_mm:.0f} bis {most_mm:.0f} mm lang; {length_mm:.0f} mm ist nicht plausibel. Messen Sie noch einmal.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a profile of a wearer: {why}</source>
      <translation>{file} ist kein Profil einer Person: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is for the hand {hand} with the glove {glove}; this is the hand {our_hand} with the glove {our_glove}.</source>
      <translation>{file} gehört zur Hand {hand} mit dem Handschuh {glove}; dies ist die Hand {our_hand} mit dem Handschuh {our_glove}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a profile of a wearer, or it is damaged.</source>
      <translation>{file} ist kein Profil einer Person oder ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The listener {name} failed and was removed: {why}</source>
      <translation>Der Empfänger {name} ist ausgefallen und wurde entfernt: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only {seconds:.1f} s of samples arrived; {needed_s:g} s are required.</source>
      <translation>Es sind nur {seconds:.1f} s an Messwerten angekommen; {needed_s:g} s sind nötig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand moved ({moving:list}). Lay it flat on the table, palm down, and wait.</source>
      <translation>Die Hand hat sich bewegt ({moving:list}). Legen Sie sie flach auf den Tisch, Handfläche nach unten, und warten Sie.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is not responding</source>
      <translation>antwortet nicht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>moves ({rate_dps:.1f} °/s)</source>
      <translation>bewegt sich ({rate_dps:.1f} °/s)</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>turns, or its gyroscope is off by {bias_dps:.0f} °/s</source>
      <translation>dreht sich, oder ihr Gyroskop weicht um {bias_dps:.0f} °/s ab</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>measures {gravity:.1f} m/s² of gravity, so its accelerometer is inaccurate</source>
      <translation>misst {gravity:.1f} m/s² Schwerkraft, ihr Beschleunigungssensor ist also ungenau</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{imu:word} {what}</source>
      <translation>{imu:word} {what}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{imus:list}.</source>
      <translation>{imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Rest your forearm and tip your whole hand up and down, with the fingers stretched.</source>
      <translation>Legen Sie den Unterarm auf und kippen Sie die ganze Hand mit gestreckten Fingern auf und ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Bend and stretch your thumb a few times; keep everything else still.</source>
      <translation>Beugen und strecken Sie den Daumen einige Male; halten Sie alles andere still.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Bend and stretch your {finger:word} finger a few times, in all its joints.</source>
      <translation>Beugen und strecken Sie den Finger ({finger:word}) einige Male in allen Gelenken.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing moved. {instruction}</source>
      <translation>Nichts hat sich bewegt. {instruction}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>It did not respond in any step.</source>
      <translation>Sie hat in keinem Schritt geantwortet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>It never moved. Check whether it is loose or broken.</source>
      <translation>Sie hat sich nie bewegt. Prüfen Sie, ob sie lose oder defekt ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>It moved in several steps. Repeat them.</source>
      <translation>Sie hat sich in mehreren Schritten bewegt. Wiederholen Sie diese.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>It is on the {found:word}, but according to the glove file it belongs on the {expected:word}.</source>
      <translation>Sie ist an {found:word}, gehört laut Handschuhdatei aber an {expected:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>It is in its position, but rotated by about {angle_deg:.0f}°. Remount it.</source>
      <translation>Sie ist an ihrer Stelle, aber um etwa {angle_deg:.0f}° verdreht. Bringen Sie sie neu an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Its position matches the glove file.</source>
      <translation>Ihre Position stimmt mit der Handschuhdatei überein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The positions of all IMUs match the glove file.</source>
      <translation>Die Positionen aller IMUs stimmen mit der Handschuhdatei überein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Exchanged: {first:word} and {second:word}. Exchange their plugs, or choose a glove file with that order.</source>
      <translation>Vertauscht: {first:word} und {second:word}. Tauschen Sie ihre Stecker, oder wählen Sie eine Handschuhdatei mit dieser Reihenfolge.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Check {imus:list}.</source>
      <translation>Prüfen Sie {imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{imu:word} ({state:word})</source>
      <translation>{imu:word} ({state:word})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{count} repeated {count:packet|packets} of the {side:word} glove {count:was|were} ignored.</source>
      <translation>{count} {count:wiederholtes Paket|wiederholte Pakete} des Handschuhs {side:word} {count:wurde|wurden} ignoriert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{count} interpolated {count:gap|gaps} of {file} {count:was|were} not used: tracking starts from the sensors.</source>
      <translation>{count} {count:interpolierte Lücke|interpolierte Lücken} von {file} {count:wurde|wurden} nicht verwendet: Das Tracking beginnt bei den Sensoren.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This version cannot use these settings of {file}: {settings:list}. They were ignored; the other recorded settings were used.</source>
      <translation>Diese Version kann folgende Einstellungen von {file} nicht verwenden: {settings:list}. Sie wurden ignoriert, die übrigen aufgezeichneten Einstellungen wurden verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This version cannot use these settings of {file}: {settings:list} and {more} more. They were ignored; the other recorded settings were used.</source>
      <translation>Diese Version kann folgende Einstellungen von {file} nicht verwenden: {settings:list} und {more} weitere. Sie wurden ignoriert, die übrigen aufgezeichneten Einstellungen wurden verwendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} was recorded by version {version} in the middle of tracking. The recorded tracking state was not used, so the first seconds may differ.</source>
      <translation>{file} wurde von der Version {version} mitten im Tracking aufgenommen. Der aufgezeichnete Zustand wurde nicht verwendet; die ersten Sekunden können daher abweichen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} was recorded by version {version}. Tracking continues from its recorded state; the results may differ slightly from those of that version.</source>
      <translation>{file} wurde mit Version {version} aufgenommen. Das Tracking setzt beim aufgezeichneten Zustand fort; die Ergebnisse können geringfügig von denen jener Version abweichen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated camera has ended.</source>
      <translation>Die simulierte Kamera hat geendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated wearer is asked for the pose {pose:word}.</source>
      <translation>Von der simulierten Person wird die Pose {pose:word} verlangt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulated wearer is not asked for a pose any more.</source>
      <translation>Von der simulierten Person wird keine Pose mehr verlangt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No pixels are marked for the hue "{hue:word}".</source>
      <translation>Für den Farbton „{hue:word}“ sind keine Pixel markiert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The pixels marked for "{hue:word}" cover all hues. Mark only one cloth.</source>
      <translation>Die für „{hue:word}“ markierten Pixel umfassen alle Farbtöne. Markieren Sie nur einen Stoff.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Colours adapted to the light.</source>
      <translation>Die Farben wurden an das Licht angepasst.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing was fitted: no glove was recognised with certainty. Hold your hand flat in front of the camera, in more or whiter light.</source>
      <translation>Es wurde nichts angepasst: Kein Handschuh wurde sicher erkannt. Halten Sie die Hand flach vor die Kamera, in mehr oder weißerem Licht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Point at a marker of each hue first. Missing: {hues:words}.</source>
      <translation>Zeigen Sie zuerst auf einen Marker jedes Farbtons. Es fehlt: {hues:words}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only the pixels that you pointed at were learned: no glove was recognised around them. Hold your hand flat and point at the centre of a patch of each hue.</source>
      <translation>Nur die Pixel, auf die Sie gezeigt haben, wurden gelernt: Um sie herum wurde kein Handschuh erkannt. Halten Sie die Hand flach und zeigen Sie auf die Mitte eines Flickens jedes Farbtons.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours are unchanged: the learned ones find {found} of {picked} markers and {others} other objects, the current ones {found_before} and {others_before}. Point at markers of a flat hand, in more light.</source>
      <translation>Die Farben sind unverändert: Die gelernten finden {found} von {picked} Markern und {others} andere Objekte, die jetzigen {found_before} und {others_before}. Zeigen Sie bei mehr Licht auf Marker einer flachen Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours are unchanged: the fitted ones find {found} patches of the glove and {others} other objects, the current ones {found_before} and {others_before}.</source>
      <translation>Die Farben sind unverändert: Die angepassten finden {found} Flicken des Handschuhs und {others} andere Objekte, die jetzigen {found_before} und {others_before}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours find {patches} patches, none of which fit the glove. Fit the colours.</source>
      <translation>Die Farben finden {patches} Flicken, von denen keiner zum Handschuh passt. Passen Sie die Farben an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours no longer find too many patches, or the hand was found.</source>
      <translation>Die Farben finden nicht mehr zu viele Flicken, oder die Hand wurde gefunden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colour profile {profile} has {hues} hues; at most {most} can be distinguished.</source>
      <translation>Das Farbprofil {profile} hat {hues} Farbtöne; höchstens {most} lassen sich unterscheiden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours showed no hand, so they were fitted automatically.</source>
      <translation>Die Farben zeigten keine Hand und wurden deshalb automatisch angepasst.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The names of these hues are exchanged in the colour profile: {hues:words}. Fit the colours.</source>
      <translation>Die Namen dieser Farbtöne sind im Farbprofil vertauscht: {hues:words}. Passen Sie die Farben an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The names of these hues are exchanged in the colour profile: {hues:words}. Tracking uses the right ones; fit the colours to correct the profile.</source>
      <translation>Die Namen dieser Farbtöne sind im Farbprofil vertauscht: {hues:words}. Das Tracking verwendet die richtigen; passen Sie die Farben an, um das Profil zu berichtigen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The names of these hues were exchanged in the colour profile and are corrected: {hues:words}.</source>
      <translation>Die Namen dieser Farbtöne waren im Farbprofil vertauscht und sind korrigiert: {hues:words}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No hand is visible. {why}</source>
      <translation>Es ist keine Hand zu sehen. {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {hues:words} markers are too bright. Shorten the exposure, or move the lamp away.</source>
      <translation>Die Marker in {hues:words} sind zu hell. Verkürzen Sie die Belichtung, oder rücken Sie die Lampe weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{share_percent:.0f} % of the image is white. Keep the window and the screen out of the image, or shorten the exposure.</source>
      <translation>{share_percent:.0f} % des Bildes sind weiß. Halten Sie Fenster und Bildschirm aus dem Bild, oder verkürzen Sie die Belichtung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The markers are dark. Put more light on the hand, or lengthen the exposure.</source>
      <translation>Die Marker sind dunkel. Sorgen Sie für mehr Licht auf der Hand, oder verlängern Sie die Belichtung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image is noisy. Use more light and less gain.</source>
      <translation>Das Bild rauscht. Verwenden Sie mehr Licht und weniger Verstärkung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The light is too warm. Use a daylight lamp or set the white balance, then fit the colours.</source>
      <translation>Das Licht ist zu warm. Verwenden Sie eine Tageslichtlampe oder stellen Sie den Weißabgleich ein; passen Sie dann die Farben an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The light is too cold. Set the white balance, then fit the colours.</source>
      <translation>Das Licht ist zu kalt. Stellen Sie den Weißabgleich ein; passen Sie dann die Farben an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {hues:words} markers look alike in this light. Use another lamp, or other cloth.</source>
      <translation>Die Marker in {hues:words} sehen in diesem Licht gleich aus. Verwenden Sie eine andere Lampe oder anderen Stoff.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The room also contains {hues:words}, in {spots} {spots:spot|spots}. Lay a dark or grey cloth under the hand, or fit the colours.</source>
      <translation>Auch der Raum enthält {hues:words}, in {spots} {spots:Fleck|Flecken}. Legen Sie einen dunklen oder grauen Stoff unter die Hand, oder passen Sie die Farben an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{missed} of {expected} markers are not found with these colours. Fit them to the image.</source>
      <translation>{missed} von {expected} Markern werden mit diesen Farben nicht gefunden. Passen Sie die Farben an das Bild an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Hold your gloved hand in front of the camera, its back up.</source>
      <translation>Halten Sie die Hand im Handschuh vor die Kamera, den Handrücken nach oben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no images whose light can be measured.</source>
      <translation>{path} enthält keine Bilder, deren Licht sich messen lässt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session contains no camera calibration, so no hand can be found in its images.</source>
      <translation>Die Sitzung enthält keine Kamerakalibrierung; in ihren Bildern lässt sich daher keine Hand finden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no images to fit colours to.</source>
      <translation>{path} enthält keine Bilder, an die sich Farben anpassen lassen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours are unchanged: the fitted ones find {found:.1f} markers and {others:.1f} other objects per image, the current ones {found_before:.1f} and {others_before:.1f}.</source>
      <translation>Die Farben sind unverändert: Die angepassten finden je Bild {found:.1f} Marker und {others:.1f} andere Dinge, die bisherigen {found_before:.1f} und {others_before:.1f}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The colours could not be fitted: no hand was found with certainty, in any light and with any names of the hues. Hold the hand flat and still in view of {cameras:word}, in more or whiter light.</source>
      <translation>Die Farben konnten nicht angepasst werden: Bei keiner Beleuchtung und mit keinen Namen der Farbtöne wurde sicher eine Hand gefunden. Halten Sie die Hand flach und ruhig ins Bild ({cameras:word}), bei mehr oder weißerem Licht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Fitting to live images needs the glove and a calibrated camera. Fit to one image instead.</source>
      <translation>Das Anpassen an Livebilder braucht den Handschuh und eine kalibrierte Kamera. Passen Sie stattdessen an ein Bild an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The result places the lenses {found_mm:.1f} mm apart, but the known distance is {known_mm:.1f} mm. Measure a square of the board again.</source>
      <translation>Das Ergebnis ergibt einen Abstand der Objektive von {found_mm:.1f} mm, bekannt sind aber {known_mm:.1f} mm. Messen Sie ein Feld der Tafel noch einmal.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The views do not fit one camera: corners are off by {rms_px:.1f} px. Check the numbers of squares, hold the board flat and still, and turn off autofocus.</source>
      <translation>Die Ansichten passen nicht zu einer Kamera: Ecken weichen um {rms_px:.1f} px ab. Prüfen Sie die Zahlen der Felder, halten Sie die Tafel flach und still, und schalten Sie den Autofokus ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The views cover only {covered_percent:.0f} % of the images. Show the board at the edges, too.</source>
      <translation>Die Ansichten decken nur {covered_percent:.0f} % der Bilder ab. Zeigen Sie die Tafel auch am Rand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The views are too similar: only {tilted} {tilted:shows|show} a tilted board, and the focal length is uncertain by {focal_percent:.1f} %. Tilt the board more.</source>
      <translation>Die Ansichten sind zu ähnlich: Nur {tilted} {tilted:zeigt|zeigen} die Tafel geneigt, und die Brennweite ist um {focal_percent:.1f} % unsicher. Neigen Sie die Tafel stärker.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} is not usable. {problems}</source>
      <translation>{name} ist nicht brauchbar. {problems}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The calibration contains values that are not numbers.</source>
      <translation>Die Kalibrierung enthält Werte, die keine Zahlen sind.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>One camera is mirrored relative to the other. Turn off its mirror setting.</source>
      <translation>Eine Kamera ist gegenüber der anderen gespiegelt. Schalten Sie ihre Spiegelung ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The cameras are above or behind each other, not side by side. Rotate the rig, or the images, by 90 degrees.</source>
      <translation>Die Kameras sind über- oder hintereinander statt nebeneinander. Drehen Sie das Gestell oder die Bilder um 90 Grad.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Left and right are exchanged: the camera called left is on the right. Exchange the two images in the camera's set-up, or turn off mirroring, which looks the same.</source>
      <translation>Links und rechts sind vertauscht: Die linke Kamera ist rechts. Vertauschen Sie in der Einrichtung der Kamera die beiden Bilder, oder schalten Sie die Spiegelung ab, die genauso aussieht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The result places the cameras {found_mm:.1f} mm apart; {least_mm:.0f} to {most_mm:.0f} mm is possible. Check the size of a square, or the unit of the file.</source>
      <translation>Das Ergebnis ergibt einen Abstand der Kameras von {found_mm:.1f} mm; möglich sind {least_mm:.0f} bis {most_mm:.0f} mm. Prüfen Sie die Größe eines Feldes oder die Einheit der Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The result places one camera {above_mm:.0f} mm above and {before_mm:.0f} mm in front of the other. They must be side by side.</source>
      <translation>Nach dem Ergebnis ist eine Kamera {above_mm:.0f} mm über und {before_mm:.0f} mm vor der anderen. Sie müssen nebeneinander sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The result has an angle of {angle_deg:.0f} degrees between the cameras. They must point in the same direction.</source>
      <translation>Nach dem Ergebnis beträgt der Winkel zwischen den Kameras {angle_deg:.0f} Grad. Sie müssen in dieselbe Richtung blicken.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {lens:word} has a focal length of {focal_px:.0f} px for an image {width_px} px wide, which is not plausible.</source>
      <translation>{lens:word}: Die Brennweite von {focal_px:.0f} px bei einem {width_px} px breiten Bild ist nicht plausibel.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The pixels of the {lens:word} are not square ({x_px:.0f} by {y_px:.0f}).</source>
      <translation>{lens:word}: Die Pixel sind nicht quadratisch ({x_px:.0f} × {y_px:.0f}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The right lens magnifies {ratio:.2f} times as much as the left one. Check that the squares are the same for both and that neither lens is zoomed.</source>
      <translation>Das rechte Objektiv vergrößert {ratio:.2f}-mal so stark wie das linke. Prüfen Sie, ob die Felder für beide gleich sind und keines gezoomt ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The centre of the {lens:word} is {off_px:.0f} px from the middle of the image. Check whether the image is cropped or of another size.</source>
      <translation>{lens:word}: Die Mitte liegt {off_px:.0f} px neben der Bildmitte. Prüfen Sie, ob das Bild beschnitten ist oder eine andere Größe hat.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {lens:word} distorts the image's corners beyond recognition. Show the board in the corners too, or use a lens that is not a fisheye.</source>
      <translation>{lens:word}: Die Bildecken sind bis zur Unkenntlichkeit verzerrt. Zeigen Sie die Tafel auch in den Ecken, oder verwenden Sie ein Objektiv, das kein Fischauge ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Hold the board where the images are empty: {regions:word}.</source>
      <translation>Halten Sie die Tafel dorthin, wo die Bilder leer sind: {regions:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Tilt the board by 30 degrees: to the left, right, towards you and away.</source>
      <translation>Neigen Sie die Tafel um 30 Grad: nach links, nach rechts, zu sich hin und von sich weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Hold the board closer, then farther away.</source>
      <translation>Halten Sie die Tafel näher, dann weiter weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Show a few more views, each different from the others.</source>
      <translation>Zeigen Sie noch einige Ansichten, jede anders als die anderen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a stereo calibration: the file of a ZED ends in .conf, those of OpenCV and Kalibr in .yml or .yaml, and those of Anipose, FreeMoCap and Caliscope in .toml.</source>
      <translation>{path} ist keine Stereokalibrierung: Die Datei einer ZED endet auf .conf, die von OpenCV und Kalibr auf .yml oder .yaml, die von Anipose, FreeMoCap und Caliscope auf .toml.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not usable. {why}</source>
      <translation>{path} ist nicht brauchbar. {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a calibration that OpenCV can read.</source>
      <translation>{path} ist keine Kalibrierung, die OpenCV lesen kann.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There are only {usable} usable views; at least {needed} are required.</source>
      <translation>Es gibt nur {usable} brauchbare Ansichten; mindestens {needed} sind nötig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The views do not fit any camera. Check the board's kind and its numbers of squares.</source>
      <translation>Die Ansichten passen zu keiner Kamera. Prüfen Sie die Art der Tafel und die Zahlen ihrer Felder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain {key} ({names:or}).</source>
      <translation>{path} enthält {key} nicht ({names:or}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: R is not a rotation.</source>
      <translation>{path}: R ist keine Drehung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains a value that is not a matrix.</source>
      <translation>{path} enthält einen Wert, der keine Matrix ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: {key} must be {shape} finite numbers.</source>
      <translation>{path}: {key} muss aus {shape} endlichen Zahlen bestehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: the {side:word} camera has {count} distortion coefficients. OpenCV's models have 5, 8, 12 or 14, a fisheye 4.</source>
      <translation>{path}: Die {side:word} Kamera hat {count} Verzeichnungskoeffizienten. Die Modelle von OpenCV haben 5, 8, 12 oder 14, ein Fischauge 4.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: the lens model of {camera} is {model}. Pinhole lenses with OpenCV's coefficients and equidistant fisheyes are supported.</source>
      <translation>{path}: Das Objektivmodell von {camera} ist {model}. Unterstützt werden Lochkameraobjektive mit den Koeffizienten von OpenCV und äquidistante Fischaugen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>One lens is a fisheye and the other is not. Both must be of the same kind.</source>
      <translation>Ein Objektiv ist ein Fischauge und das andere nicht. Beide müssen von gleicher Art sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stereo calibration has a baseline of {baseline_mm:.1f} mm: left and right are swapped, or this is not a stereo pair.</source>
      <translation>Die Stereo-Kalibrierung hat eine Basis von {baseline_mm:.1f} mm: links und rechts sind vertauscht, oder dies ist kein Stereopaar.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A line time of {line_time_us:g} µs is not plausible: an image is read within 0.1 s.</source>
      <translation>Eine Zeilenzeit von {line_time_us:g} µs ist nicht plausibel: Ein Bild wird innerhalb von 0,1 s ausgelesen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording does not show the line time. Swing the hand faster, in all directions.</source>
      <translation>Die Aufnahme lässt die Zeilenzeit nicht erkennen. Schwingen Sie die Hand schneller und in alle Richtungen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Too few markers are visible to estimate the line time. Record a swinging hand for 20 s.</source>
      <translation>Es sind zu wenige Marker sichtbar, um die Zeilenzeit zu schätzen. Nehmen Sie 20 s lang eine schwingende Hand auf.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The two rectified cameras must share one matrix P[:, :3].</source>
      <translation>Die beiden rektifizierten Kameras müssen eine Matrix P[:, :3] teilen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A board is {kinds:or}, not "{kind}".</source>
      <translation>Eine Tafel ist {kinds:or}, nicht „{kind}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A board has {least} to {most} squares in each direction, not {columns} by {rows}.</source>
      <translation>Eine Tafel hat {least} bis {most} Felder je Richtung, nicht {columns} mal {rows}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A square of {square_mm:g} mm is not plausible. Measure one on the paper.</source>
      <translation>Ein Feld von {square_mm:g} mm ist nicht plausibel. Messen Sie eines auf dem Papier.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A chessboard of {columns} by {rows} squares looks the same upside down. One number must be even and the other odd.</source>
      <translation>Ein Schachbrett von {columns} × {rows} Feldern sieht auf dem Kopf gleich aus. Eine Zahl muss gerade sein, die andere ungerade.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Both images must show the same part of the board.</source>
      <translation>Beide Bilder müssen denselben Teil der Tafel zeigen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {side:word} image is mirrored. Turn off the camera's mirror setting.</source>
      <translation>Das Bild {side:word} ist gespiegelt. Schalten Sie die Spiegelung der Kamera ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The board is not visible in the {side:word} image.</source>
      <translation>Die Tafel ist im Bild {side:word} nicht zu sehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The whole board is not visible.</source>
      <translation>Die Tafel ist nicht ganz zu sehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The whole board is not visible in the {side:word} image.</source>
      <translation>Die Tafel ist im Bild {side:word} nicht ganz zu sehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The image is mirrored. Turn off the camera's mirror setting.</source>
      <translation>Das Bild ist gespiegelt. Schalten Sie die Spiegelung der Kamera ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The board is not visible.</source>
      <translation>Die Tafel ist nicht zu sehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{missing} more new {missing:view is|views are} required.</source>
      <translation>{missing} {missing:weitere neue Ansicht ist|weitere neue Ansichten sind} nötig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Rows differ by {rms_px:.2f} px and sizes by {size_percent:.1f} %. Calibrate again with more, and more varied, views.</source>
      <translation>Zeilen weichen um {rms_px:.2f} px und Größen um {size_percent:.1f} % ab. Kalibrieren Sie neu, mit mehr und verschiedeneren Ansichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Rows differ by {rms_px:.2f} px and sizes by {size_percent:.1f} %. The calibration is usable; a new one would locate the hand more accurately.</source>
      <translation>Zeilen weichen um {rms_px:.2f} px und Größen um {size_percent:.1f} % ab. Die Kalibrierung ist brauchbar; eine neue würde die Hand genauer orten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Rows agree to {rms_px:.2f} px and sizes to {size_percent:.2f} %.</source>
      <translation>Zeilen stimmen auf {rms_px:.2f} px und Größen auf {size_percent:.2f} % überein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Corners are off by {rms_px:.2f} px. Calibrate again with more, and more varied, views.</source>
      <translation>Die Ecken weichen um {rms_px:.2f} px ab. Kalibrieren Sie neu, mit mehr und verschiedeneren Ansichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Corners are off by {rms_px:.2f} px. The calibration is usable; a new one would locate the hand more accurately.</source>
      <translation>Die Ecken weichen um {rms_px:.2f} px ab. Die Kalibrierung ist brauchbar; eine neue würde die Hand genauer orten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Corners are accurate to {rms_px:.2f} px.</source>
      <translation>Die Ecken sind auf {rms_px:.2f} px genau.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Damaged messages in {file} were ignored: {topics:list}.</source>
      <translation>Beschädigte Nachrichten in {file} wurden ignoriert: {topics:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: the camera's line time is not a whole number of nanoseconds.</source>
      <translation>{path}: Die Zeilenzeit der Kamera ist keine ganze Zahl von Nanosekunden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not describe the robot {robot}.</source>
      <translation>{path} beschreibt den Roboter {robot} nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session's robot description is not JSON.</source>
      <translation>Die Roboterbeschreibung der Sitzung ist kein JSON.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session's robot description is not a JSON object.</source>
      <translation>Die Roboterbeschreibung der Sitzung ist kein JSON-Objekt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The tracking state in the recording is damaged.</source>
      <translation>Der Tracking-Zustand in der Aufnahme ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The tracking state in the recording is of another version.</source>
      <translation>Der Tracking-Zustand in der Aufnahme ist von einer anderen Version.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The tracking state in the recording is damaged: {why}.</source>
      <translation>Der Tracking-Zustand in der Aufnahme ist beschädigt: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no estimate between {start_s:g} s and {end_s:g} s.</source>
      <translation>Zwischen {start_s:g} s und {end_s:g} s gibt es keine Schätzung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no keypoint or joint "{name}" in this session.</source>
      <translation>In dieser Sitzung gibt es weder Punkt noch Gelenk „{name}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no estimates. Track it first.</source>
      <translation>{path} enthält keine Schätzungen. Tracken Sie die Sitzung zuerst.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no session in {path}.</source>
      <translation>In {path} ist keine Sitzung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An image of {camera} is damaged.</source>
      <translation>Ein Bild von {camera} ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An image of {camera} is neither JPEG nor PNG.</source>
      <translation>Ein Bild von {camera} ist weder JPEG noch PNG.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An image of {camera} claims a size of {width} by {height} pixels.</source>
      <translation>Ein Bild von {camera} gibt eine Größe von {width} × {height} Pixeln an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A session has at most {most} types of messages.</source>
      <translation>Eine Sitzung hat höchstens {most} Nachrichtentypen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A session has at most {most} channels.</source>
      <translation>Eine Sitzung hat höchstens {most} Kanäle.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an MCAP file: its header is damaged.</source>
      <translation>{path} ist keine MCAP-Datei: ihr Kopf ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be read in order: its chunks all overlap.</source>
      <translation>{path} lässt sich nicht der Reihe nach lesen: alle Stücke überlappen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an MCAP file.</source>
      <translation>{path} ist keine MCAP-Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains a record of {size_bytes} bytes: it is damaged.</source>
      <translation>{path} enthält einen Eintrag von {size_bytes} Bytes: sie ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no IMU samples.</source>
      <translation>{path} enthält keine Messwerte von IMUs.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no {part} of at most {limit_bytes} bytes.</source>
      <translation>{path} enthält kein {part} von höchstens {limit_bytes} Bytes.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no {part}: it was not recorded by Glovetrack, or only in part.</source>
      <translation>{path} enthält kein {part}: es wurde nicht von Glovetrack aufgenommen, oder nur zum Teil.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has an impossible start time: its wall_clock_ns, its monotonic_ns or its first log time is out of range.</source>
      <translation>{path} hat eine unmögliche Startzeit: wall_clock_ns, monotonic_ns oder die erste Log-Zeit liegt außerhalb des Bereichs.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is for the {side:word} hand.</source>
      <translation>{path} gilt für die Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not describe a stereo camera. Missing: {missing:list}.</source>
      <translation>{path} beschreibt keine Stereokamera. Es fehlt: {missing:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains nothing that can be recovered.</source>
      <translation>{path} enthält nichts, was sich retten lässt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An instant is outside the years 1901 to 2038, which ROS 2 can represent.</source>
      <translation>Ein Zeitpunkt liegt außerhalb der Jahre 1901 bis 2038, die ROS 2 darstellen kann.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The start state of this recording does not match the engine {engine} with this hand and glove, so it cannot be tracked again. ({where})</source>
      <translation>Der Anfangszustand dieser Aufnahme passt nicht zum Verfahren {engine} mit dieser Hand und diesem Handschuh; sie kann nicht erneut getrackt werden. ({where})</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{count} on {topic}</source>
      <translation>{count} auf {topic}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>others on {count} more {count:topic|topics}</source>
      <translation>weitere auf {count} {count:anderen Thema|anderen Themen}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No messages for {silent_s:.1f} s.</source>
      <translation>Keine Nachrichten während {silent_s:.1f} s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording was not finished. `glovetrack recover` makes a complete file of it.</source>
      <translation>Die Aufzeichnung wurde nicht abgeschlossen. `glovetrack recover` macht daraus eine vollständige Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The profile is "{profile}", not "ros2".</source>
      <translation>Das Profil ist „{profile}“ statt „ros2“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The file was not recorded by Glovetrack.</source>
      <translation>Die Datei wurde nicht von Glovetrack aufgezeichnet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stereo calibration or the pose of the camera is missing.</source>
      <translation>Die Stereokalibrierung oder die Lage der Kamera fehlt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Damaged messages: {count} ({at} after the start).</source>
      <translation>Beschädigte Nachrichten: {count} ({at} nach dem Beginn).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Repeated messages: {count}. Tracking uses each once.</source>
      <translation>Wiederholte Nachrichten: {count}. Die Auswertung verwendet jede nur einmal.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Time stamps that run backwards: {count}.</source>
      <translation>Rückwärts laufende Zeitstempel: {count}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Jumps of the clock: {count}.</source>
      <translation>Sprünge der Uhr: {count}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Messages arrived up to {late_s:.1f} s late (in all {count} times): the computer was overloaded.</source>
      <translation>Nachrichten kamen bis zu {late_s:.1f} s zu spät an (insgesamt {count}-mal): Der Computer war überlastet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Gaps: {count}, the longest {longest_s:.3f} s after {after_s:.1f} s.</source>
      <translation>Lücken: {count}, die längste {longest_s:.3f} s nach {after_s:.1f} s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Interpolated positions that are marked as measured: {count}.</source>
      <translation>Interpolierte Positionen, die als gemessen markiert sind: {count}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The file contains no messages of this IMU.</source>
      <translation>Die Datei enthält keine Nachrichten dieser IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The file contains neither images nor blobs of a camera.</source>
      <translation>Die Datei enthält weder Bilder noch Markierungen einer Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The data section does not end where the summary begins.</source>
      <translation>Der Datenteil endet nicht dort, wo die Zusammenfassung beginnt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The checksum of the data section is wrong.</source>
      <translation>Die Prüfsumme des Datenteils ist falsch.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The summary and the file differ: {records}.</source>
      <translation>Zusammenfassung und Datei weichen voneinander ab: {records}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The message index differs from the messages of the chunk.</source>
      <translation>Das Nachrichtenverzeichnis weicht von den Nachrichten des Blocks ab.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The summary is damaged.</source>
      <translation>Die Zusammenfassung ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The file ends within a record.</source>
      <translation>Die Datei endet mitten in einem Datensatz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A definition is damaged.</source>
      <translation>Eine Definition ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A chunk is too short.</source>
      <translation>Ein Block ist zu kurz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A chunk has an impossible log time.</source>
      <translation>Ein Block hat eine unmögliche Aufzeichnungszeit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A chunk cannot be read ({why}).</source>
      <translation>Ein Block kann nicht gelesen werden ({why}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Recordings are aligned by {known:or}, not by "{method}".</source>
      <translation>Aufnahmen werden nach {known:or} ausgerichtet, nicht nach {method}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>According to their clocks the recordings were not made at the same time.</source>
      <translation>Nach ihren Uhren wurden die Aufnahmen nicht zur selben Zeit gemacht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recordings do not share {needed_s:g} s of movement.</source>
      <translation>Die Aufnahmen haben keine {needed_s:g} s Bewegung gemeinsam.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The movements do not match (correlation {correlation:.2f}).</source>
      <translation>Die Bewegungen passen nicht zueinander (Korrelation {correlation:.2f}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The movements match at more than one offset (correlations {correlation:.2f} and {elsewhere:.2f}): they are too regular.</source>
      <translation>Die Bewegungen passen an mehr als einer Stelle (Korrelationen {correlation:.2f} und {elsewhere:.2f}): sie wiederholen sich zu gleichmäßig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A recording contains too little movement to be aligned by it.</source>
      <translation>Eine Aufnahme enthält zu wenig Bewegung, um danach auszurichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recordings have neither IMUs nor tracked angles in common.</source>
      <translation>Die Aufnahmen haben weder IMUs noch getrackte Winkel gemeinsam.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an alignment of two recordings.</source>
      <translation>{path} ist keine Ausrichtung zweier Aufnahmen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{first} and {second} have no hand in common.</source>
      <translation>{first} und {second} haben keine gemeinsame Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{first} and {second} do not overlap in time.</source>
      <translation>{first} und {second} überschneiden sich zeitlich nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has schema "{schema}", not {expected}.</source>
      <translation>{file} hat Schema {schema}, nicht {expected}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a record of edits: {why}.</source>
      <translation>{file} ist kein Protokoll von Bearbeitungen: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} lists {fills} filled gaps; at most {most} are read.</source>
      <translation>{file} enthält {fills} gefüllte Lücken; höchstens {most} werden gelesen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Recording started.</source>
      <translation>Aufnahme gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording is complete.</source>
      <translation>Die Aufnahme ist vollständig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording has ended: {why}</source>
      <translation>Die Aufnahme wurde beendet: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording could not be completed: {why}</source>
      <translation>Die Aufnahme konnte nicht abgeschlossen werden: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} already exists. A recording never overwrites a file.</source>
      <translation>{path} gibt es schon. Eine Aufnahme überschreibt nie eine Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recorder's process {why}.{there} You can start another recording.</source>
      <translation>Der Aufnahmeprozess {why}.{there} Sie können eine neue Aufnahme starten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only {free_gb:.1f} GB are left on the disk of {folder}.</source>
      <translation>Auf der Festplatte von {folder} sind nur noch {free_gb:.1f} GB frei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The disk of {folder} is nearly full ({left} left), so recording has stopped. What was recorded is safe. Free some space.</source>
      <translation>Die Festplatte von {folder} ist fast voll ({left} frei), deshalb wurde die Aufnahme beendet. Was aufgenommen wurde, ist sicher. Geben Sie Speicherplatz frei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The disk of {folder} is nearly full ({left} left), so recording is not possible. Free some space.</source>
      <translation>Die Festplatte von {folder} ist fast voll ({left} frei), deshalb ist keine Aufnahme möglich. Geben Sie Speicherplatz frei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording {path} has already ended.</source>
      <translation>Die Aufnahme {path} ist bereits beendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Images can be {known:or}, not "{value}".</source>
      <translation>Bilder können {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Compression can be {known:or}, not "{value}".</source>
      <translation>Die Kompression kann {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The JPEG quality is {quality}; it must be 1 to 100.</source>
      <translation>Die JPEG-Qualität ist {quality}; sie muss zwischen 1 und 100 liegen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is damaged: the attachment at byte {offset} is incomplete. Save what can be read with glovetrack recover.</source>
      <translation>{path} ist beschädigt: Der Anhang bei Byte {offset} ist unvollständig. Retten Sie mit glovetrack recover, was lesbar ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is damaged in the chunk at byte {offset}: {why}. Save what can be read with glovetrack recover.</source>
      <translation>{path} ist im Block bei Byte {offset} beschädigt: {why}. Retten Sie mit glovetrack recover, was lesbar ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: {why}</source>
      <translation>{path}: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera requires a calibration. Pass the path of its calibration file, which the window creates under Set-up, Camera calibration.</source>
      <translation>Die Kamera braucht eine Kalibrierung. Übergeben Sie den Pfad ihrer Kalibrierdatei; das Fenster erzeugt sie unter Einrichtung, Kamerakalibrierung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Two hands are tracked. Specify side="left" or side="right".</source>
      <translation>Zwei Hände werden verfolgt. Geben Sie side="left" oder side="right" an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is a recording of both hands. Choose hands["left"] or hands["right"]; for an IMU, side="left" or side="right".</source>
      <translation>{file} ist eine Aufnahme beider Hände. Wählen Sie hands["left"] oder hands["right"], für eine IMU side="left" oder side="right".</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is a recording of the {side:word} hand.</source>
      <translation>{file} ist eine Aufnahme der Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is damaged at byte {offset}. Save what can be read with glovetrack recover.</source>
      <translation>{path} ist bei Byte {offset} beschädigt. Retten Sie mit glovetrack recover, was lesbar ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is damaged at byte {offset}: {why}. Save what can be read with glovetrack recover.</source>
      <translation>{path} ist bei Byte {offset} beschädigt: {why}. Retten Sie mit glovetrack recover, was lesbar ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>there is no chunk</source>
      <translation>dort ist kein Block</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a message has a log time in the far future</source>
      <translation>eine Nachricht hat eine Log-Zeit in ferner Zukunft</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} needs a name with a letter or a digit in it.</source>
      <translation>{file} braucht einen Namen mit einem Buchstaben oder einer Ziffer.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{other} already exists, so {file} was not renamed.</source>
      <translation>{other} existiert bereits, daher wurde {file} nicht umbenannt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} cannot be named {other}: {why}.</source>
      <translation>{file} kann nicht in {other} umbenannt werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{format} is a data set of many sessions. Give more than one session, or choose another format.</source>
      <translation>{format} ist ein Datensatz aus vielen Sitzungen. Geben Sie mehr als eine Sitzung an, oder wählen Sie ein anderes Format.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{format} contains one session; {others:list} can contain several.</source>
      <translation>{format} enthält eine Sitzung; {others:list} kann mehrere enthalten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The format {format} cannot be used: {why}.{install}</source>
      <translation>Das Format {format} kann nicht verwendet werden: {why}.{install}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The format {format} does not support {options:list}.</source>
      <translation>Das Format {format} unterstützt {options:list} nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A session requires its {parts:list}. Leave out participant and notes by name.</source>
      <translation>Eine Sitzung braucht {parts:list}. Lassen Sie Person und Notizen mit Namen weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A rate of {rate_hz:g} Hz is not between {least_hz:g} and {most_hz:g} Hz.</source>
      <translation>Eine Rate von {rate_hz:g} Hz liegt nicht zwischen {least_hz:g} und {most_hz:g} Hz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--every must be at least 1, not {every}.</source>
      <translation>--every muss mindestens 1 sein, nicht {every}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Views can be {known:or}, not "{value}".</source>
      <translation>Ansichten können {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Axes can be {known:or}, not "{value}".</source>
      <translation>Achsen können {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Joints are either openxr or names of Glovetrack, not both.</source>
      <translation>Gelenke sind entweder openxr oder Namen von Glovetrack, nicht beides.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Units can be {known:or}, not "{value}".</source>
      <translation>Einheiten können {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{estimates} estimates over {seconds:.0f} s would be {rows} rows at {rate_hz:g} Hz. Export a part of them.</source>
      <translation>{estimates} Schätzungen über {seconds:.0f} s wären {rows} Zeilen bei {rate_hz:g} Hz. Exportieren Sie einen Teil davon.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Parquet requires Arrow. Install glovetrack[parquet].</source>
      <translation>Parquet braucht Arrow. Installieren Sie glovetrack[parquet].</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} could not be written completely. The disk may be full.</source>
      <translation>{file} konnte nicht vollständig geschrieben werden. Die Festplatte ist möglicherweise voll.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no "{name}" among the {kind:word}. Available: {known:list}; or enter the path of a file.</source>
      <translation>„{name}“ gibt es nicht ({kind:word}). Vorhanden: {known:list}; oder geben Sie den Pfad einer Datei an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains neither t nor a rate ({rates:list}).</source>
      <translation>{path} enthält weder t noch eine Rate ({rates:list}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain acc and gyr of an IMU.</source>
      <translation>{path} enthält nicht acc und gyr einer IMU.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The IMUs in {path} have no samples, too many samples, or different numbers of samples.</source>
      <translation>Die IMUs in {path} haben keine, zu viele oder unterschiedlich viele Messwerte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{imu} in {path}: acc and gyr have different numbers of rows.</source>
      <translation>{imu} in {path}: acc und gyr haben unterschiedlich viele Zeilen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains more than {most} numbers.</source>
      <translation>{path} enthält mehr als {most} Zahlen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is a MATLAB file of version 7.3. Save it with -v7.</source>
      <translation>{path} ist eine MATLAB-Datei der Version 7.3. Speichern Sie sie mit -v7.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a readable MATLAB file: {why}.</source>
      <translation>{path} ist keine lesbare MATLAB-Datei: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: t has {times} rows, the IMUs have {samples}.</source>
      <translation>{path}: t hat {times} Zeilen, die IMUs haben {samples}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: {name} is {rate_hz:g} Hz, which is not between 1 and 100 000 Hz.</source>
      <translation>{path}: {name} ist {rate_hz:g} Hz und liegt nicht zwischen 1 und 100 000 Hz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{what} is not a table of numbers of the expected shape.</source>
      <translation>{what} ist keine Zahlentabelle der erwarteten Form.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is neither a .csv nor a .mat file.</source>
      <translation>{path} ist weder eine .csv- noch eine .mat-Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Assign the IMUs by --imu GLOVE=FILE. The files contain {found:list}; the glove has {imus:list}.</source>
      <translation>Ordnen Sie die IMUs mit --imu GLOVE=FILE zu. Die Dateien enthalten {found:list}; der Handschuh hat {imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only some of the files contain the time of day, so they cannot be combined.</source>
      <translation>Nur manche der Dateien enthalten die Uhrzeit; sie lassen sich nicht zusammenführen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The files are longer than {limit_s:.0f} s, the longest that can be imported.</source>
      <translation>Die Dateien sind länger als {limit_s:.0f} s, mehr lässt sich nicht importieren.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The files do not overlap in time. Check that they use the same clock.</source>
      <translation>Die Dateien überlappen sich zeitlich nicht. Prüfen Sie, ob sie dieselbe Uhr verwenden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>More than one file contains {imus:list}.</source>
      <translation>Mehr als eine Datei enthält {imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no {file} in {folder} or its folders.</source>
      <translation>In {folder} und ihren Unterordnern gibt es kein {file}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{imu}={name} names an unknown IMU. The files contain {found:list}; the glove has {imus:list}.</source>
      <translation>{imu}={name} nennt eine unbekannte IMU. Die Dateien enthalten {found:list}; der Handschuh hat {imus:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain two samples at different, possible times.</source>
      <translation>{file} enthält keine zwei Messwerte zu verschiedenen, möglichen Zeiten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: the unit of {column} is unknown. Known units: {known:list}.</source>
      <translation>{path}: Die Einheit von {column} ist unbekannt. Bekannte Einheiten: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no time column with a unit, such as Time (s).</source>
      <translation>{path} hat keine Zeitspalte mit Einheit, etwa Time (s).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no IMU column with a unit, such as Gyroscope X (deg/s).</source>
      <translation>{path} hat keine Spalte einer IMU mit Einheit, etwa Gyroscope X (deg/s).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no samples.</source>
      <translation>{path} enthält keine Messwerte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: {value:g} is not a time.</source>
      <translation>{path}: {value:g} ist keine Zeit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a text table: {why}.</source>
      <translation>{path} ist keine Texttabelle: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: line {line} is too long for a table.</source>
      <translation>{path}: Zeile {line} ist zu lang für eine Tabelle.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}: line {line} has {cells} cells, the header has {columns}.</source>
      <translation>{path}: Zeile {line} hat {cells} Zellen, die Kopfzeile hat {columns}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has more than {most} lines.</source>
      <translation>{path} hat mehr als {most} Zeilen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path}, line {line}: {cell} is not a number.</source>
      <translation>{path}, Zeile {line}: {cell} ist keine Zahl.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording contains no frame that shows the whole hand.</source>
      <translation>Die Aufnahme enthält kein Bild, das die ganze Hand zeigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand {hand} has no {point}, which the recording contains.</source>
      <translation>Die Hand {hand} hat kein {point}, das die Aufnahme enthält.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a motion file that can be read. Supported: .tsv (Qualisys), .npz (Leap) and .bvh.</source>
      <translation>{path} ist keine lesbare Bewegungsdatei. Unterstützt werden .tsv (Qualisys), .npz (Leap) und .bvh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} names fewer than six joints of a hand's fingers.</source>
      <translation>{path} nennt weniger als sechs Fingergelenke einer Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no MARKER_NAMES or FREQUENCY line, so it is not a Qualisys TSV file.</source>
      <translation>{path} hat keine Zeile MARKER_NAMES oder FREQUENCY, ist also keine TSV-Datei von Qualisys.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain three columns for each of its markers.</source>
      <translation>{path} enthält nicht drei Spalten je Marker.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain five fingers of four joints of one hand.</source>
      <translation>{path} enthält nicht fünf Finger mit vier Gelenken einer Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a readable BVH file: {why}.</source>
      <translation>{path} ist keine lesbare BVH-Datei: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains a value that is not a number: {why}.</source>
      <translation>{path} enthält einen Wert, der keine Zahl ist: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a decoded Leap recording: {why}.</source>
      <translation>{path} ist keine dekodierte Leap-Aufnahme: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains only {frames} frames of a hand; 20 are required.</source>
      <translation>{path} enthält nur {frames} Bilder einer Hand; nötig sind 20.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The times in {path} do not increase.</source>
      <translation>Die Zeiten in {path} nehmen nicht zu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} never shows six points of the hand at once.</source>
      <translation>{path} zeigt nie sechs Punkte der Hand zugleich.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a record in it is incomplete</source>
      <translation>ein Datensatz darin ist unvollständig</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its compression "{name}" is unknown</source>
      <translation>seine Kompression „{name}“ ist unbekannt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its header declares {size_bytes} bytes</source>
      <translation>sein Kopf gibt {size_bytes} Bytes an</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its size differs from its header</source>
      <translation>seine Größe weicht vom Kopf ab</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its checksum is wrong</source>
      <translation>seine Prüfsumme ist falsch</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>it unpacks to more messages than a recording can contain</source>
      <translation>er entpackt sich zu mehr Nachrichten, als eine Aufnahme enthalten kann</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its offset is invalid</source>
      <translation>seine Position ist ungültig</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>there is no header</source>
      <translation>ein Kopf fehlt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its text is too long</source>
      <translation>sein Text ist zu lang</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an array has an unknown type or shape</source>
      <translation>ein Feld hat einen unbekannten Typ oder eine unbekannte Form</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an array is longer than the data</source>
      <translation>ein Feld ist länger als die Daten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a number has an unknown type</source>
      <translation>eine Zahl hat einen unbekannten Typ</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>"{name}" is not a record</source>
      <translation>„{name}“ ist kein Datensatz</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an array is missing</source>
      <translation>ein Feld fehlt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>it has no HIERARCHY and MOTION</source>
      <translation>es fehlen HIERARCHY und MOTION</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its MOTION part does not begin with Frames and Frame Time</source>
      <translation>der Teil MOTION beginnt nicht mit Frames und Frame Time</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>it does not have one number for each channel</source>
      <translation>es gibt nicht eine Zahl je Kanal</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is a file. Name a folder for the results of several sessions.</source>
      <translation>{path} ist eine Datei. Geben Sie für die Ergebnisse mehrerer Sitzungen einen Ordner an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain the side of its hand.</source>
      <translation>{file} enthält die Seite der Hand nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is for the hand {hand} with the glove {glove}, which the session does not contain.</source>
      <translation>{file} gilt für die Hand {hand} mit dem Handschuh {glove}, die die Sitzung nicht enthält.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{files:words} are for the same hand. Give one file for each hand.</source>
      <translation>{files:words} gelten für dieselbe Hand. Geben Sie für jede Hand eine Datei an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{files:words} are for the same side. Give one file for each hand.</source>
      <translation>{files:words} gelten für dieselbe Seite. Geben Sie für jede Hand eine Datei an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{files:words}: the session contains one hand. Give one file.</source>
      <translation>{files:words}: Die Sitzung enthält nur eine Hand. Geben Sie eine Datei an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{failed} of {count} sessions could not be tracked.</source>
      <translation>{failed} von {count} Sitzungen konnten nicht getrackt werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A part must start before it ends, within the {duration_s:.2f} s of {file}.</source>
      <translation>Ein Ausschnitt muss beginnen, bevor er endet, und innerhalb der {duration_s:.2f} s von {file} liegen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No gap of {file} could be filled: {why:word}.</source>
      <translation>In {file} ließ sich keine Lücke füllen: {why:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The longest gap to fill must be greater than 0 s, not {max_gap_s:g} s.</source>
      <translation>Die längste zu füllende Lücke muss größer als 0 s sein, nicht {max_gap_s:g} s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has no gap of the {side:word} {part} from {start_s:.3f} s to {stop_s:.3f} s. List its gaps again.</source>
      <translation>{file} hat keine Lücke von {part} ({side:word}) von {start_s:.3f} s bis {stop_s:.3f} s. Listen Sie die Lücken neu auf.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a list written by glovetrack gaps --json.</source>
      <translation>{path} ist keine Liste, die glovetrack gaps --json geschrieben hat.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording contains no IMU samples.</source>
      <translation>Die Aufnahme enthält keine Messwerte von IMUs.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The longest rest in the recording is {rest_s:.0f} s; at least {least_s:.0f} s are required, 10 minutes are recommended. Put the glove on a table and do not touch it.</source>
      <translation>Die längste Ruhe in der Aufnahme dauert {rest_s:.0f} s; nötig sind mindestens {least_s:.0f} s, empfohlen 10 Minuten. Legen Sie den Handschuh auf einen Tisch und berühren Sie ihn nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The IMU {imu} is missing in {missing_percent:.0f} % of the rest.</source>
      <translation>Die IMU {imu} fehlt in {missing_percent:.0f} % der Ruhe.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove file has no IMU {names:list}.</source>
      <translation>Die Handschuhdatei hat keine IMU {names:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording shows {postures} different postures; at least {least} are required. Move all fingers freely in front of the camera for two minutes.</source>
      <translation>Die Aufnahme zeigt {postures} verschiedene Haltungen; mindestens {least} sind nötig. Bewegen Sie zwei Minuten lang alle Finger frei vor der Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove file cannot be fitted to this recording: the postures contradict each other, or markers are more than {most_mm:.0f} mm from their positions. Check that the file is of this glove.</source>
      <translation>Die Handschuhdatei lässt sich nicht an diese Aufnahme anpassen: Die Haltungen widersprechen einander, oder Marker sind mehr als {most_mm:.0f} mm von ihren Positionen entfernt. Prüfen Sie, ob die Datei zu diesem Handschuh gehört.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove file has no table with an id or name for {names:list}, so it cannot be changed.</source>
      <translation>Die Handschuhdatei hat keine Tabelle mit der Nummer oder dem Namen {names:list} und kann daher nicht geändert werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains two hands. Record the glove alone, then fit it.</source>
      <translation>{path} enthält zwei Hände. Nehmen Sie den Handschuh allein auf, dann passen Sie ihn an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Give --set or --name, not both.</source>
      <translation>Geben Sie entweder --set oder --name an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no stereo camera, which is required to measure the markers.</source>
      <translation>{path} enthält keine Stereokamera; sie ist nötig, um die Marker zu vermessen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A profile contains the length of the hand. Leave out --hand-length.</source>
      <translation>Ein Profil enthält die Länge der Hand. Lassen Sie --hand-length weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The scene {scene} requires a camera that does not move.</source>
      <translation>Die Szene {scene} braucht eine Kamera, die sich nicht bewegt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Both hands are simulated with random postures in front of a fixed camera. Leave out --motion, --guided, --hand, --camera and --lenses none.</source>
      <translation>Beide Hände werden mit zufälligen Haltungen vor einer festen Kamera simuliert. Lassen Sie --motion, --guided, --hand, --camera und --lenses none weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Smoothing requires the engine chain, not {engine}.</source>
      <translation>Glätten erfordert das Verfahren chain, nicht {engine}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Smoothing requires both lenses. Leave out --smooth or --lenses.</source>
      <translation>Glätten erfordert beide Objektive. Lassen Sie --smooth oder --lenses weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} changes its camera calibration; --smooth requires a single one.</source>
      <translation>{path} wechselt die Kamerakalibrierung; --smooth braucht eine einzige.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{why} Use the default settings: --settings default.</source>
      <translation>{why} Verwenden Sie die Standardeinstellungen: --settings default.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The simulator has no fabric of the hue "{hue}". Available: {known:list}.</source>
      <translation>Der Simulator hat keinen Stoff im Farbton „{hue}“. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The desk requires a camera on a stand, not on the head.</source>
      <translation>Der Schreibtisch braucht eine Kamera auf einem Stativ, nicht auf dem Kopf.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--light requires the scene desk, not {scene}.</source>
      <translation>--light erfordert die Szene desk, nicht {scene}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The scene photo requires an image (--photo); other scenes have none.</source>
      <translation>Die Szene photo braucht ein Bild (--photo); andere Szenen haben keines.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no show "{name}". Available: {known:list}.</source>
      <translation>Eine Vorführung „{name}“ gibt es nicht. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Two hands can be simulated in the scenes plain, painted and photo.</source>
      <translation>Zwei Hände lassen sich in den Szenen plain, painted und photo simulieren.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has no gap to fill ({kinds:list}).</source>
      <translation>{file} hat keine Lücke, die zu füllen ist ({kinds:list}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>All {count} gaps of {file} that could be filled are longer than {max_gap_s:g} s. Choose a longer --max-gap.</source>
      <translation>Alle {count} füllbaren Lücken von {file} sind länger als {max_gap_s:g} s. Wählen Sie ein größeres --max-gap.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No gap of {file} has estimates on both sides.</source>
      <translation>Keine Lücke von {file} hat auf beiden Seiten Schätzungen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no images, so other colours cannot be used.</source>
      <translation>{path} enthält keine Bilder; andere Farben lassen sich daher nicht verwenden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains neither detected markers nor images.</source>
      <translation>{path} enthält weder erkannte Marker noch Bilder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not valid TOML: {why}.</source>
      <translation>{file} ist kein gültiges TOML: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not valid TOML: it is nested too deeply.</source>
      <translation>{file} ist kein gültiges TOML: Es ist zu tief verschachtelt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is larger than {limit_bytes} bytes, so it is not a configuration file.</source>
      <translation>{file} ist größer als {limit_bytes} Bytes, also keine Konfigurationsdatei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not valid TOML: a text in line {line} is not closed.</source>
      <translation>{file} ist kein gültiges TOML: Ein Text in Zeile {line} ist nicht geschlossen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}, line {line}: {key} {why}.</source>
      <translation>{file}, Zeile {line}: {key} {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a UTF-8 text file.</source>
      <translation>{file} ist keine UTF-8-Textdatei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>settings: {key} {why}.</source>
      <translation>Einstellungen: {key} {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}: streams must be a table.</source>
      <translation>{file}: streams muss eine Tabelle sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}: streams.{key} {why}.</source>
      <translation>{file}: streams.{key} {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be written: {why:word}.</source>
      <translation>{path} kann nicht geschrieben werden: {why:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a regular file.</source>
      <translation>{path} ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is larger than {limit_bytes} bytes, so it is not {what:word}.</source>
      <translation>{path} ist größer als {limit_bytes} Bytes, also nicht {what:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is an input. Choose another name for the output.</source>
      <translation>{path} ist eine Eingabe. Wählen Sie für die Ausgabe einen anderen Namen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} already exists and is {what:word}. Choose another name.</source>
      <translation>{path} gibt es schon und ist {what:word}. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} already exists. Choose another name, or use --force to replace it.</source>
      <translation>{path} gibt es schon. Wählen Sie einen anderen Namen, oder ersetzen Sie sie mit --force.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The folder {folder} is not empty. Choose another one, or use --force to replace files in it.</source>
      <translation>Der Ordner {folder} ist nicht leer. Wählen Sie einen anderen, oder ersetzen Sie Dateien darin mit --force.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} already exists. Choose another name.</source>
      <translation>{path} gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be read: {why}.</source>
      <translation>{path} kann nicht gelesen werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no file {path}.</source>
      <translation>Es gibt keine Datei {path}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no {kind} "{name}". Available: {known:list}.</source>
      <translation>{kind} „{name}“ gibt es nicht. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} {name} cannot be loaded: {why}</source>
      <translation>{kind} {name} kann nicht geladen werden: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} {name} cannot be loaded: {entry} is not a {expected}.</source>
      <translation>{kind} {name} kann nicht geladen werden: {entry} ist kein {expected}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{what} requires a package that is not installed ({why}).{install}</source>
      <translation>{what} braucht ein Paket, das nicht installiert ist ({why}).{install}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>"{value}" is not a port for the {kind} {what}: ports are 1 to 65535.</source>
      <translation>„{value}“ ist kein Port für {kind} ({what}): Ports sind 1 bis 65535.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} {what} has no port: clients find it by its name.</source>
      <translation>{kind} {what} hat keinen Port: Programme finden es über seinen Namen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {what} stream cannot go to {host}:{port}: {why}.</source>
      <translation>Der Stream {what} kann nicht an {host}:{port} gehen: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {what} stream cannot go to {host}:{port}: ports are 1 to 65535.</source>
      <translation>Der Stream {what} kann nicht an {host}:{port} gehen: Ports sind 1 bis 65535.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Joints can be {known:or}, not "{value}".</source>
      <translation>Gelenke können {known:or} sein, nicht {value}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} stream made {made} publishers for {hands} hands.</source>
      <translation>Der Stream {kind} hat {made} Sender für {hands} Hände erstellt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} server cannot start at {host}:{port}: {why}.</source>
      <translation>Der Server {kind} kann an {host}:{port} nicht starten: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process of the streams has ended. Switch the streams on again.</source>
      <translation>Der Prozess der Streams ist beendet. Schalten Sie die Streams erneut ein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process of the streams does not answer.</source>
      <translation>Der Prozess der Streams antwortet nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: switch it on and start tracking, then test it.</source>
      <translation>{stream}: Schalten Sie ihn ein und starten Sie das Tracking; testen Sie ihn dann.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: received by {count} connected programs.</source>
      <translation>{stream}: von {count} verbundenen Programmen empfangen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: received by at least one program.</source>
      <translation>{stream}: von mindestens einem Programm empfangen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: no program is connected.</source>
      <translation>{stream}: Kein Programm ist verbunden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: {size} bytes were sent and refused (port unreachable). No program receives at this address.</source>
      <translation>{stream}: {size} Bytes wurden gesendet und abgewiesen (Port nicht erreichbar). Unter dieser Adresse empfängt kein Programm.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: {size} bytes were sent and not refused. UDP sends no answer, so whether a program received them is unknown.</source>
      <translation>{stream}: {size} Bytes wurden gesendet und nicht abgewiesen. UDP sendet keine Antwort; ob ein Programm sie empfangen hat, ist daher unbekannt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: nothing has been sent yet, because no hand is tracked.</source>
      <translation>{stream}: Es wurde noch nichts gesendet, weil keine Hand getrackt wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: {count} messages were sent. The protocol does not report whether a program received them.</source>
      <translation>{stream}: {count} Nachrichten wurden gesendet. Das Protokoll meldet nicht, ob ein Programm sie empfangen hat.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream} to {host}:{port}</source>
      <translation>{stream} an {host}:{port}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream} at {host}:{port}</source>
      <translation>{stream} auf {host}:{port}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream} outlet {name}</source>
      <translation>{stream}-Ausgang {name}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stream {stream} fails. {why}</source>
      <translation>Der Stream {stream} schlägt fehl. {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stream {stream} works again.</source>
      <translation>Der Stream {stream} funktioniert wieder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Remote control by {kind} cannot start at {host}:{port}: {why}.</source>
      <translation>Die Fernsteuerung über {kind} kann an {host}:{port} nicht starten: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The window is closing.</source>
      <translation>Das Fenster wird geschlossen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The message is a reply, not a request.</source>
      <translation>Die Nachricht ist eine Antwort, keine Anfrage.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is already being recorded.</source>
      <translation>{file} wird bereits aufgenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing can be recorded: no device is running.</source>
      <translation>Aufnahme nicht möglich: Es läuft kein Gerät.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A replayed session cannot be recorded.</source>
      <translation>Eine Sitzung, die wiedergegeben wird, kann nicht aufgenommen werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording did not start.</source>
      <translation>Die Aufnahme wurde nicht gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing is being recorded.</source>
      <translation>Es läuft keine Aufnahme.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The note was not added: no device or session is open.</source>
      <translation>Die Notiz wurde nicht hinzugefügt: Weder ein Gerät noch eine Sitzung ist geöffnet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove with motors is running.</source>
      <translation>Es läuft kein Handschuh mit Motoren.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A motor accepts at most {rate_hz:.0f} requests per second.</source>
      <translation>Ein Motor nimmt höchstens {rate_hz:.0f} Anfragen pro Sekunde an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A finger accepts at most {rate_hz:.0f} contacts per second.</source>
      <translation>Ein Finger nimmt höchstens {rate_hz:.0f} Kontakte pro Sekunde an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove's send queue is full. The motor was not started.</source>
      <translation>Die Sendewarteschlange des Handschuhs ist voll. Der Motor wurde nicht gestartet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing is being tracked, so contacts are not accepted.</source>
      <translation>Es wird nichts getrackt, daher werden keine Kontakte angenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No glove for this side is running.</source>
      <translation>Für diese Seite läuft kein Handschuh.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The window did not respond, so nothing was done.</source>
      <translation>Das Fenster hat nicht geantwortet, es geschah also nichts.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The system has less than {needed_mb:.0f} MB of shared memory left, which is required to pass images between processes. Close other programs.</source>
      <translation>Das System hat weniger als {needed_mb:.0f} MB gemeinsamen Speicher frei, der zum Übergeben von Bildern zwischen Prozessen nötig ist. Schließen Sie andere Programme.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A request has at most {most} bytes.</source>
      <translation>Eine Anfrage hat höchstens {most} Bytes.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A request is JSON or plain text, in UTF-8.</source>
      <translation>Eine Anfrage ist JSON oder Klartext in UTF-8.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The field do must be {known:or}.</source>
      <translation>Das Feld do muss {known:or} sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{do} has no field "{field}".</source>
      <translation>{do} hat kein Feld „{field}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The field text must be a text.</source>
      <translation>Das Feld text muss ein Text sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A note requires a text.</source>
      <translation>Eine Notiz braucht einen Text.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A note has at most {most} characters.</source>
      <translation>Eine Notiz hat höchstens {most} Zeichen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>finger must be {fingers:or}.</source>
      <translation>finger muss {fingers:or} sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{do} requires a finger: {fingers:or}.</source>
      <translation>{do} braucht einen Finger: {fingers:or}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{field} must be an integer from {least} to {most}.</source>
      <translation>{field} muss eine ganze Zahl von {least} bis {most} sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>strength is a number from 0 (no contact) to 1.</source>
      <translation>strength ist eine Zahl von 0 (kein Kontakt) bis 1.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>object is a name of at most {most} characters.</source>
      <translation>object ist ein Name von höchstens {most} Zeichen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>id is an integer or a text of at most {most} characters.</source>
      <translation>id ist eine ganze Zahl oder ein Text von höchstens {most} Zeichen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>At most {rate_hz:.0f} requests per second are accepted.</source>
      <translation>Es werden höchstens {rate_hz:.0f} Anfragen pro Sekunde angenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The window is loaded: too many requests are waiting. Try again later.</source>
      <translation>Das Fenster ist ausgelastet: Zu viele Anfragen warten. Versuchen Sie es später erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains more than {limit_mb} MB.</source>
      <translation>{path} enthält mehr als {limit_mb} MB.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {kind} {what} has no option "{option}". Options: {known:list}.</source>
      <translation>{what} {kind} hat keine Option „{option}“. Optionen: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>"{value}" is not a value for {option} of the {kind} {what}.</source>
      <translation>„{value}“ ist kein Wert für {option} von {what} {kind}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The schema of JSON messages can be {known}, not {schema}.</source>
      <translation>Das Schema der JSON-Nachrichten kann {known} sein, nicht {schema}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stream is of another hand or another version.</source>
      <translation>Der Stream gehört zu einer anderen Hand oder einer anderen Version.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stream contains a message that is not from Glovetrack: {why}.</source>
      <translation>Der Stream enthält eine Nachricht, die nicht von Glovetrack stammt: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No window responds at {host}:{port}: {why}. Check that remote control by UDP is on.</source>
      <translation>Unter {host}:{port} antwortet kein Fenster: {why}. Prüfen Sie, ob die Fernsteuerung über UDP eingeschaltet ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The {what} is closed.</source>
      <translation>{what} ist geschlossen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The program at the other end of {address} does not belong to you. End it, or ask your administrator to, then start again.</source>
      <translation>Das Programm am anderen Ende von {address} gehört nicht Ihnen. Beenden Sie es, oder bitten Sie die Administration darum, und starten Sie dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The program that listens at {address} belongs to another user (id {uid}). Remove that file, or set XDG_RUNTIME_DIR to a folder of your own, then start again.</source>
      <translation>Das Programm, das unter {address} wartet, gehört einer anderen Person (id {uid}). Löschen Sie diese Datei, oder setzen Sie XDG_RUNTIME_DIR auf einen eigenen Ordner, und starten Sie dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{folder} is used for the window's socket and must be a folder of your own that no other user can enter (mode 0700). Remove it, or set XDG_RUNTIME_DIR to a folder of your own, then start again.</source>
      <translation>{folder} wird für den Socket des Fensters gebraucht und muss ein eigener Ordner sein, den sonst niemand betreten kann (Modus 0700). Löschen Sie ihn, oder setzen Sie XDG_RUNTIME_DIR auf einen eigenen Ordner, und starten Sie dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be used: {why}.</source>
      <translation>{path} kann nicht verwendet werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The program that listens at the address of Glovetrack is not a Glovetrack window. Close it, then start Glovetrack again.</source>
      <translation>Das Programm, das unter der Adresse von Glovetrack wartet, ist kein Fenster von Glovetrack. Schließen Sie es, und starten Sie Glovetrack dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be created: {why}.</source>
      <translation>{path} kann nicht angelegt werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}: {key} {why}.</source>
      <translation>{file}: {key} {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The window does not answer within {seconds} s. It may still do what was requested.</source>
      <translation>Das Fenster antwortet nicht innerhalb von {seconds} s. Möglicherweise tut es das Gewünschte noch.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No window is open. Open one with glovetrack.</source>
      <translation>Es ist kein Fenster geöffnet. Öffnen Sie eines mit glovetrack.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: {why}.</source>
      <translation>{stream}: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: not connected.</source>
      <translation>{stream}: nicht verbunden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: no connection ({why}).</source>
      <translation>{stream}: keine Verbindung ({why}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} can be {known:or}, not "{value}".</source>
      <translation>{option} kann {known:or} sein, nicht „{value}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} must be between {low} and {high}.</source>
      <translation>{option} muss zwischen {low} und {high} liegen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The command {command} requires packages that are not installed ({why}). Install them: pip install "glovetrack[{extra}]".</source>
      <translation>Der Befehl {command} braucht Pakete, die nicht installiert sind ({why}). Installieren Sie sie: pip install "glovetrack[{extra}]".</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A cluster requires Dask. Install glovetrack[cluster].</source>
      <translation>Ein Cluster braucht Dask. Installieren Sie glovetrack[cluster].</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No Dask scheduler responds at {address}.</source>
      <translation>Unter {address} antwortet kein Scheduler von Dask.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The work was stopped.</source>
      <translation>Die Arbeit wurde abgebrochen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The process that worked on it ended unexpectedly ({kind}: {why}).</source>
      <translation>Der Prozess, der daran gearbeitet hat, ist unerwartet beendet worden ({kind}: {why}).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no check {names:list}. Available: {known:list}.</source>
      <translation>Es gibt keine Prüfung {names:list}. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{options:words} must be given together.</source>
      <translation>{options:words} müssen zusammen angegeben werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} requires {needed}.</source>
      <translation>{option} erfordert {needed}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} must be at least {least}.</source>
      <translation>{option} muss mindestens {least} sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{options:words} cannot be used together.</source>
      <translation>{options:words} lassen sich nicht zusammen verwenden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} must be greater than 0.</source>
      <translation>{option} muss größer als 0 sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Specify exactly one of {options:list}.</source>
      <translation>Geben Sie genau eines davon an: {options:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{option} requires packages that are not installed. Install them: pip install "glovetrack[{extra}]".</source>
      <translation>{option} braucht Pakete, die nicht installiert sind. Installieren Sie sie: pip install "glovetrack[{extra}]".</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The report is an HTML page: {file} must end in .html.</source>
      <translation>Der Bericht ist eine HTML-Seite: {file} muss auf .html enden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No commands are registered, because the installation is incomplete or older than the program. Install Glovetrack again.</source>
      <translation>Es sind keine Befehle registriert: Die Installation ist unvollständig oder älter als das Programm. Installieren Sie Glovetrack erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is missing</source>
      <translation>fehlt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a text</source>
      <translation>muss ein Text sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is "{value}"; it must be {known:or}</source>
      <translation>ist „{value}“; möglich ist {known:or}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>has the name "{name}"; a name is a letter, followed by at most 63 letters, digits, _ and -</source>
      <translation>hat den Namen „{name}“; ein Name ist ein Buchstabe, gefolgt von höchstens 63 Buchstaben, Ziffern, _ und -</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is "{label}"; a label has at most 64 printable characters and no comma</source>
      <translation>ist „{label}“; eine Bezeichnung hat höchstens 64 druckbare Zeichen und kein Komma</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be an integer</source>
      <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is too large</source>
      <translation>ist zu groß</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a number</source>
      <translation>muss eine Zahl sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a finite number</source>
      <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is {value:g}; it must be between {low:g} and {high:g}</source>
      <translation>ist {value:g}; möglich ist {low:g} bis {high:g}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a list of {count} numbers</source>
      <translation>muss eine Liste von {count} Zahlen sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>has length {norm:.4g}; it must be 1 within {tolerance:g}</source>
      <translation>hat die Länge {norm:.4g}; sie muss bis auf {tolerance:g} gleich 1 sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a list that contains only {known:or}</source>
      <translation>muss eine Liste sein, die nur {known:or} enthält</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains a value twice</source>
      <translation>enthält einen Wert zweimal</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a table</source>
      <translation>muss eine Tabelle sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be written as [[{key}]] tables</source>
      <translation>muss in Tabellen [[{key}]] geschrieben sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>has {count} tables; at most {most} are allowed</source>
      <translation>hat {count} Tabellen; erlaubt sind höchstens {most}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is not a known key</source>
      <translation>ist kein bekannter Schlüssel</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a text or a list of texts</source>
      <translation>muss ein Text oder eine Liste von Texten sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is not {expected}; this version cannot read the file</source>
      <translation>ist nicht {expected}; diese Version kann die Datei nicht lesen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is {side:word}, but the hand {hand} is a {hand_side:word} hand</source>
      <translation>ist {side:word}, die Hand {hand} aber {hand_side:word}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must have the ids 0 to {last}</source>
      <translation>muss die Nummern 0 bis {last} haben</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>repeats the name "{name}" of the skeleton</source>
      <translation>wiederholt den Namen „{name}“ des Skeletts</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains the unknown segment "{segment}"</source>
      <translation>enthält das unbekannte Segment „{segment}“</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>does not contain {root}</source>
      <translation>enthält {root} nicht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be [lower, upper]</source>
      <translation>muss [unten, oben] sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is {length_m:g} m, but {segments:words} add up to {sum_m:.4g} m</source>
      <translation>ist {length_m:g} m, aber {segments:words} ergeben zusammen {sum_m:.4g} m</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>gives {segment} the unknown parent "{parent}"</source>
      <translation>gibt {segment} das unbekannte übergeordnete Segment „{parent}“</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains a loop through {names:list}</source>
      <translation>enthält eine Schleife über {names:list}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>defines two joints for {segment}</source>
      <translation>legt für {segment} zwei Gelenke fest</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>may contain abduction only where abduction is free and twist is not</source>
      <translation>darf abduction nur enthalten, wo die Abduktion frei ist und die Torsion nicht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains the unknown angle "{angle}"</source>
      <translation>enthält den unbekannten Winkel „{angle}“</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must contain at least one hue</source>
      <translation>muss mindestens einen Farbton enthalten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is damaged: it must be base64 of zlib data</source>
      <translation>ist beschädigt: Erwartet wird Base64 von zlib-Daten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must contain {expected} bytes</source>
      <translation>muss {expected} Bytes enthalten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>refers to a hue beyond the {hues} hues of the file</source>
      <translation>verweist auf einen Farbton jenseits der {hues} Farbtöne der Datei</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be two integers</source>
      <translation>muss aus zwei ganzen Zahlen bestehen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be between {low:g} and {high:g}</source>
      <translation>muss zwischen {low:g} und {high:g} liegen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must contain the smaller number first</source>
      <translation>muss die kleinere Zahl zuerst enthalten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be two numbers of at least 0, the smaller one first</source>
      <translation>muss aus zwei Zahlen ab 0 bestehen, die kleinere zuerst</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains "{name}" twice</source>
      <translation>enthält „{name}“ zweimal</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>has two IMUs on {segment}</source>
      <translation>hat zwei IMUs auf {segment}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is not a setting</source>
      <translation>ist keine Einstellung</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be of the type {type}</source>
      <translation>muss vom Typ {type} sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is a number of {digits} digits</source>
      <translation>ist eine Zahl mit {digits} Ziffern</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>has more than {most} parts</source>
      <translation>hat mehr als {most} Teile</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is nested more than {most} deep</source>
      <translation>ist mehr als {most}-fach verschachtelt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>and accel_sd must not be negative</source>
      <translation>und accel_sd dürfen nicht negativ sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be within {limit:g} of the identity matrix</source>
      <translation>darf höchstens {limit:g} von der Einheitsmatrix abweichen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>That is not a command for an arm: {why}.</source>
      <translation>Das ist kein Befehl für einen Arm: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A robot is at host:port, not "{address}".</source>
      <translation>Ein Roboter ist unter host:port, nicht „{address}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The application {application} requires a package that is not installed ({why}).{install}</source>
      <translation>Die Anwendung {application} braucht ein Paket, das nicht installiert ist ({why}).{install}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Vehicles are at host:port, such as 127.0.0.1:14550, not "{address}".</source>
      <translation>Fahrzeuge sind unter host:port, etwa 127.0.0.1:14550, nicht „{address}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no mesh "{name}". For a file, include its extension.</source>
      <translation>Es gibt kein Netz „{name}“. Geben Sie bei einer Datei die Endung an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a mesh that can be read: .obj or .stl.</source>
      <translation>{path} ist kein lesbares Netz: .obj oder .stl.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} is not an OBJ file: {why}.</source>
      <translation>{name} ist keine OBJ-Datei: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} is not an STL file: {why}.</source>
      <translation>{name} ist keine STL-Datei: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} does not contain a mesh: a closed one has at least four triangles.</source>
      <translation>{name} enthält kein Netz: Ein geschlossenes hat mindestens vier Dreiecke.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} refers to points that it does not have, or that are not finite.</source>
      <translation>{name} verweist auf Punkte, die es nicht hat oder die nicht endlich sind.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A setting is KEY=VALUE, not "{text}".</source>
      <translation>Eine Einstellung hat die Form KEY=VALUE, nicht „{text}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no application.</source>
      <translation>{path} enthält keine Anwendung.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A live stream is udp, udp:PORT or ws://HOST:PORT, not "{address}".</source>
      <translation>Ein Live-Stream ist udp, udp:PORT oder ws://HOST:PORT, nicht „{address}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No hand was received at {where} within {wait_s:.0f} s.</source>
      <translation>An {where} ist innerhalb von {wait_s:.0f} s keine Hand angekommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no {side:word} hand.</source>
      <translation>{path} enthält keine Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No program responds at {address}: {why}.</source>
      <translation>Unter {address} antwortet kein Programm: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Specify a file for the Isaac record: isaac:take.mcap.</source>
      <translation>Geben Sie eine Datei für den Isaac-Datensatz an: isaac:take.mcap.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Isaac record {file}</source>
      <translation>Isaac-Handdaten {file}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: {count} hands were written. The file is complete when the stream is switched off.</source>
      <translation>{stream}: {count} Hände wurden geschrieben. Die Datei ist vollständig, sobald der Stream ausgeschaltet ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an MCAP file, or it is truncated.</source>
      <translation>{path} ist keine MCAP-Datei oder ist abgeschnitten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A hand record is damaged.</source>
      <translation>Ein Datensatz einer Hand ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{name} contains no hand records.</source>
      <translation>{name} enthält keine Datensätze einer Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no records of these hands: {sides:words}.</source>
      <translation>{path} enthält keine Datensätze dieser Hände: {sides:words}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove {glove} is for the {side:word} hand.</source>
      <translation>Der Handschuh {glove} gilt für die Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The Isaac record requires the joints of OpenXR.</source>
      <translation>Der Isaac-Datensatz braucht die Gelenke von OpenXR.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a list of labelled steps.</source>
      <translation>{path} ist keine Liste beschrifteter Schritte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--pairs must be at least 1, --seconds at least 4, and --fps between 5 and 240.</source>
      <translation>--pairs muss mindestens 1 sein, --seconds mindestens 4 und --fps zwischen 5 und 240.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{folder} contains no BROAD recordings (*.mat).</source>
      <translation>{folder} enthält keine BROAD-Aufnahmen (*.mat).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not a recording of the BROAD data set: {why}.</source>
      <translation>{path} ist keine Aufnahme des Datensatzes BROAD: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This protocol requires the extension extensions/robot.</source>
      <translation>Dieses Protokoll braucht die Erweiterung extensions/robot.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--participants must be at least 1, --seconds at least 5, and --readout-ms greater than 0 and at most 50.</source>
      <translation>--participants muss mindestens 1 sein, --seconds mindestens 5 und --readout-ms größer als 0 und höchstens 50.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unknown {what}: "{name}". Available: {known:list}.</source>
      <translation>Unbekannt ({what}): „{name}“. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Other sessions need a camera and --level points. Leave out --sessions.</source>
      <translation>Andere Sitzungen brauchen eine Kamera und --level points. Lassen Sie --sessions weg.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only the engine inertial can be evaluated without a camera.</source>
      <translation>Ohne Kamera lässt sich nur das Verfahren inertial auswerten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine inertial does not use images. Add --lenses none.</source>
      <translation>Das Verfahren inertial verwendet keine Bilder. Ergänzen Sie --lenses none.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The engine {engine} requires both lenses. Add --engines chain.</source>
      <translation>Das Verfahren {engine} braucht beide Objektive. Ergänzen Sie --engines chain.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only the engine chain uses a wearer's profile. Add --engines chain.</source>
      <translation>Nur das Verfahren chain verwendet das Profil einer Person. Ergänzen Sie --engines chain.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The report could not be written: {why}.</source>
      <translation>Der Bericht konnte nicht geschrieben werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{folder} contains trials of another version of the program, which cannot be combined with new ones. Choose another folder, or empty it.</source>
      <translation>{folder} enthält Versuche einer anderen Programmversion; sie lassen sich nicht mit neuen zusammenführen. Wählen Sie einen anderen Ordner, oder leeren Sie ihn.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stored trial {path} is damaged. Delete it to compute it again.</source>
      <translation>Der gespeicherte Versuch {path} ist beschädigt. Löschen Sie ihn, damit er neu berechnet wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--participants must be at least 1, and --seconds at least 5.</source>
      <translation>--participants muss mindestens 1 sein und --seconds mindestens 5.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain a true hand. Choose a simulated session that was recorded with it.</source>
      <translation>{file} enthält keine wahre Hand. Wählen Sie eine simulierte Aufnahme, die damit aufgenommen wurde.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--participants must be at least 1, and --gaps between 0.1 and 60.</source>
      <translation>--participants muss mindestens 1 sein, und --gaps muss zwischen 0,1 und 60 liegen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no channel {channel}.</source>
      <translation>Es gibt keinen Kanal {channel}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Subscription {subscription} to channel {channel} is a second one.</source>
      <translation>Das Abonnement {subscription} des Kanals {channel} ist ein zweites.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The message is invalid: {why}.</source>
      <translation>Die Nachricht ist ungültig: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Glovetrack has no operation "{operation}".</source>
      <translation>Glovetrack hat keine Operation „{operation}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>ffmpeg could not write {file}: {why}</source>
      <translation>ffmpeg konnte {file} nicht schreiben: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenCV cannot write {file} on this computer.</source>
      <translation>OpenCV kann {file} auf diesem Rechner nicht schreiben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>ffmpeg could not write {file}.</source>
      <translation>ffmpeg konnte {file} nicht schreiben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} contains no images of the tracked time.</source>
      <translation>{path} enthält keine Bilder aus der getrackten Zeit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No skeleton: both ends of a bone are never known at the same time.</source>
      <translation>Kein Skelett: Nie sind beide Enden eines Knochens zugleich bekannt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A skeleton requires the wrist. Export all joints.</source>
      <translation>Ein Skelett braucht das Handgelenk. Exportieren Sie alle Gelenke.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No skeleton: {keypoint:word} was never tracked.</source>
      <translation>Kein Skelett: {keypoint:word} wurde nie getrackt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>URDF requires right-handed axes; {axes} is left-handed.</source>
      <translation>URDF braucht rechtshändige Achsen; {axes} ist linkshändig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Videos require {program}, which is not installed. Keep the images as recorded.</source>
      <translation>Videos brauchen {program}, das nicht installiert ist. Behalten Sie die Bilder, wie sie aufgenommen wurden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{program} could not write {path}: {why}.</source>
      <translation>{program} konnte {path} nicht schreiben: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The images of camera {camera} differ in size, which a data set does not allow. Export it with --images none.</source>
      <translation>Die Bilder der Kamera {camera} sind verschieden groß, was ein Datensatz nicht zulässt. Exportieren Sie ihn mit --images none.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A part of {path} has no images of camera {camera}.</source>
      <translation>Ein Teil von {path} hat keine Bilder der Kamera {camera}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No episodes: parts between notes require at least two frames.</source>
      <translation>Keine Episoden: Teile zwischen Notizen brauchen mindestens zwei Bilder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>LeRobot requires an integer rate, not {rate_hz:g} Hz.</source>
      <translation>LeRobot braucht eine ganzzahlige Rate, nicht {rate_hz:g} Hz.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The images of camera {camera} in {path} are not JPEG or PNG.</source>
      <translation>Die Bilder der Kamera {camera} in {path} sind weder JPEG noch PNG.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An image is damaged.</source>
      <translation>Ein Bild ist beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{first} and {other} differ in their {what:word}, which must be the same for all episodes. Export them one by one, or leave the difference out (--images none).</source>
      <translation>{first} und {other} unterscheiden sich ({what:word}); bei allen Episoden muss das gleich sein. Exportieren Sie sie einzeln, oder lassen Sie den Unterschied weg (--images none).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Only {pulses} pulses of the light are in the images, {least} are required. Measure longer.</source>
      <translation>Nur {pulses} Impulse des Lichts sind in den Bildern, {least} sind erforderlich. Messen Sie länger.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No place in the left image follows the commands (correlation {correlation}). The light must be connected to this motor output and be in the picture, and the exposure be short enough that it is not saturated.</source>
      <translation>Keine Stelle im linken Bild folgt den Befehlen (Korrelation {correlation}). Das Licht muss an diesem Motorausgang angeschlossen und im Bild sein, und die Belichtung muss so kurz sein, dass es nicht übersteuert.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No place in the left image follows the flashes of the screen (correlation {correlation}). The window must be in the picture, and the exposure be short enough that it is not saturated.</source>
      <translation>Keine Stelle im linken Bild folgt dem Blinken des Bildschirms (Korrelation {correlation}). Das Fenster muss im Bild und die Belichtung so kurz sein, dass es nicht überbelichtet ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has measured no tap. Tap on a table with it, firmly, at irregular times.</source>
      <translation>Der Handschuh hat kein Klopfen gemessen. Klopfen Sie damit kräftig und in unregelmäßigen Abständen auf einen Tisch.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no screen that could flash.</source>
      <translation>Es gibt keinen Bildschirm, der blinken könnte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has sent no packets.</source>
      <translation>Der Handschuh hat keine Pakete gesendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The camera has sent no images.</source>
      <translation>Die Kamera hat keine Bilder gesendet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has accepted no command.</source>
      <translation>Der Handschuh hat keinen Befehl angenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} is not an OpenSim model.</source>
      <translation>{path} ist kein OpenSim-Modell.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has the format of OpenSim 3. Open it in OpenSim 4 and save it, then use that file.</source>
      <translation>{path} hat das Format von OpenSim 3. Öffnen Sie die Datei in OpenSim 4, speichern Sie sie und verwenden Sie dann diese Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} has no body {name}. Available: {known:list}.</source>
      <translation>{path} hat keinen Körper {name}. Vorhanden: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The motion of the body has no row between {start_s:.2f} and {end_s:.2f} s, where the session is. Specify another --offset.</source>
      <translation>Die Bewegung des Körpers hat keine Zeile zwischen {start_s:.2f} und {end_s:.2f} s, wo die Sitzung liegt. Geben Sie ein anderes --offset an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenXR layer</source>
      <translation>OpenXR-Schicht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No C++ compiler was found. Install one; on Debian: apt-get install g++</source>
      <translation>Es wurde kein C++-Compiler gefunden. Installieren Sie einen; unter Debian: apt-get install g++</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The headers of OpenXR were not found. Install them; on Debian: apt-get install libopenxr-dev</source>
      <translation>Die Header von OpenXR wurden nicht gefunden. Installieren Sie sie; unter Debian: apt-get install libopenxr-dev</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} cannot be compiled: {why}</source>
      <translation>{file} lässt sich nicht übersetzen: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand lacks joints that OpenXR requires: {joints}.</source>
      <translation>Der Hand fehlen Gelenke, die OpenXR verlangt: {joints}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} cannot be created: another program removes it repeatedly.</source>
      <translation>{path} kann nicht angelegt werden: Ein anderes Programm löscht es immer wieder.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The OpenXR layer requires Linux or Windows.</source>
      <translation>Die OpenXR-Schicht braucht Linux oder Windows.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} belongs to another user.</source>
      <translation>{path} gehört einer anderen Person.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Another Glovetrack already sends its hand to OpenXR.</source>
      <translation>Ein anderes Glovetrack sendet seine Hand schon an OpenXR.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>OpenXR has only one {side:word} hand.</source>
      <translation>OpenXR hat nur eine Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The OpenXR layer is not part of this installation. In a checkout, run make openxr-layer.</source>
      <translation>Die OpenXR-Schicht gehört nicht zu dieser Installation. Führen Sie in einem Checkout make openxr-layer aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The OpenXR layer cannot be registered: {why}.</source>
      <translation>Die OpenXR-Schicht kann nicht registriert werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The OpenXR layer cannot be unregistered: {why}.</source>
      <translation>Die OpenXR-Schicht kann nicht abgemeldet werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The OSC addresses are {addresses}.</source>
      <translation>Die OSC-Adressen sind {addresses}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{address} has {expected} values, not {found}.</source>
      <translation>{address} hat {expected} Werte, nicht {found}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This is not an OSC message: {why}.</source>
      <translation>Das ist keine OSC-Nachricht: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>An OSC message was expected: {why}.</source>
      <translation>Erwartet wurde eine OSC-Nachricht: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an OSC address begins with a slash</source>
      <translation>eine OSC-Adresse beginnt mit einem Schrägstrich</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the OSC type tags are missing</source>
      <translation>die OSC-Typkennungen fehlen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the OSC bundle is truncated</source>
      <translation>das OSC-Bündel ist abgeschnitten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the OSC bundle contains more than one message</source>
      <translation>das OSC-Bündel enthält mehr als eine Nachricht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the OSC type "{tag}" is unknown, or its value is truncated</source>
      <translation>der OSC-Typ „{tag}“ ist unbekannt, oder sein Wert ist abgeschnitten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an OSC text has no end</source>
      <translation>ein OSC-Text hat kein Ende</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>an OSC text is not UTF-8</source>
      <translation>ein OSC-Text ist nicht UTF-8</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the OSC bundles are nested too deeply</source>
      <translation>die OSC-Bündel sind zu tief verschachtelt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a pose requires {count} numbers</source>
      <translation>eine Lage braucht {count} Zahlen</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a pose contains numbers that are not finite</source>
      <translation>eine Lage enthält Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a quaternion is not of unit length</source>
      <translation>ein Quaternion hat nicht die Länge 1</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain two instants with a point.</source>
      <translation>{file} enthält keine zwei Zeitpunkte mit einem Punkt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} cannot be read: {why}.</source>
      <translation>{file} kann nicht gelesen werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is shorter than its header states. Copy it from the source again.</source>
      <translation>{file} ist kürzer, als der Dateikopf angibt. Kopieren Sie die Datei erneut von der Quelle.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not state its points' names and sample rate.</source>
      <translation>{file} gibt die Namen der Punkte und die Abtastrate nicht an.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has lengths in {unit!r}; known units: {known}.</source>
      <translation>{file} enthält Längen in {unit!r}; bekannte Einheiten: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not a C3D, TRC, BVH, Qualisys, OptiTrack or Vicon file. For another CSV, write a mapping file with [columns].</source>
      <translation>{file} ist keine C3D-, TRC-, BVH-, Qualisys-, OptiTrack- oder Vicon-Datei. Schreiben Sie für eine andere CSV-Datei eine Zuordnungsdatei mit [columns].</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain the point {point}. Its points: {known}.</source>
      <translation>{file} enthält den Punkt {point} nicht. Enthaltene Punkte: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} does not contain the column {column}. Its columns: {known}.</source>
      <translation>{file} enthält die Spalte {column} nicht. Enthaltene Spalten: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file}: {found} of its points are named like keypoints of the hand; at least 3 are needed. Name them in a mapping file. Its points: {known}.</source>
      <translation>{file}: {found} Punkte heißen wie Schlüsselpunkte der Hand; mindestens 3 sind nötig. Ordnen Sie die Punkte in einer Zuordnungsdatei zu. Enthaltene Punkte: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The reference of {session} does not contain the time of its first frame. State it (--start), or align by movement.</source>
      <translation>Die Referenz zu {session} enthält die Zeit des ersten Bildes nicht. Geben Sie sie an (--start), oder richten Sie nach der Bewegung aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{text!r} is not a time. Example: 2026-03-31T14:05:09.120+02:00.</source>
      <translation>{text!r} ist keine Zeitangabe. Beispiel: 2026-03-31T14:05:09.120+02:00.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The reference and {session} do not overlap in time.</source>
      <translation>Die Referenz und {session} überschneiden sich zeitlich nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session does not contain events of the kind pulse.</source>
      <translation>Die Sitzung enthält keine Ereignisse der Art „pulse“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The reference does not contain events of this name. State the name of its events or of an analogue channel (--pulse).</source>
      <translation>Die Referenz enthält keine Ereignisse dieses Namens. Geben Sie den Namen ihrer Ereignisse oder eines analogen Kanals an (--pulse).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The pulses of the reference ({theirs}) and of the session ({ours}) do not match at one offset.</source>
      <translation>Die Pulse der Referenz ({theirs}) und der Sitzung ({ours}) passen bei keinem eindeutigen Zeitversatz zueinander.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The movement does not determine the time offset: {windows} parts of the recording agree. Record larger movements, or align by clock or pulse.</source>
      <translation>Die Bewegung bestimmt den Zeitversatz nicht: {windows} Abschnitte der Aufnahme stimmen überein. Nehmen Sie größere Bewegungen auf, oder richten Sie nach Uhrzeit oder Puls aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is mirrored: its points fit the session after a reflection ({mirrored_mm:.1f} mm) and not without ({residual_mm:.1f} mm). Export it with right-handed axes.</source>
      <translation>{file} ist gespiegelt: Die Punkte passen nach einer Spiegelung zur Sitzung ({mirrored_mm:.1f} mm), ohne sie nicht ({residual_mm:.1f} mm). Exportieren Sie die Datei mit rechtshändigen Achsen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} and the session have {found} instants in common; at least {needed} are needed.</source>
      <translation>{file} und die Sitzung haben {found} Zeitpunkte gemeinsam; mindestens {needed} sind nötig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand has no keypoint {name}. Its keypoints: {known}.</source>
      <translation>Die Hand hat keinen Schlüsselpunkt {name}. Ihre Schlüsselpunkte: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{session} does not contain a reference. Import one (Replay, Import reference…, or glovetrack import-reference).</source>
      <translation>{session} enthält keine Referenz. Importieren Sie eine (Wiedergabe, Referenz importieren… oder glovetrack import-reference).</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The reference covers {share:.0f} % of the session. The remaining time is not evaluated.</source>
      <translation>Die Referenz deckt {share:.0f} % der Sitzung ab. Die übrige Zeit wird nicht ausgewertet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The drift of the clocks cannot be determined to 100 ppm and is taken as 0.</source>
      <translation>Die Drift der Uhren lässt sich nicht auf 100 ppm bestimmen und wird als 0 angenommen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The time offset varies by {residual_ms:.1f} ms (rms) over the recording. Errors of fast movements contain this.</source>
      <translation>Der Zeitversatz schwankt im Lauf der Aufnahme um {residual_ms:.1f} ms (RMS). Fehler schneller Bewegungen enthalten dies.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>After the registration, reference and session are {residual_mm:.0f} mm apart (rms). Check the names of the points, the unit, and that both recorded the same hand.</source>
      <translation>Nach der Registrierung liegen Referenz und Sitzung {residual_mm:.0f} mm auseinander (RMS). Prüfen Sie die Namen der Punkte, die Einheit und ob beide dieselbe Hand aufgenommen haben.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The marker offsets of {keypoints:list} are known to {sd_mm:.0f} mm only. In the next recording, turn the hand about all axes.</source>
      <translation>Der Markerversatz von {keypoints:list} ist nur auf {sd_mm:.0f} mm bekannt. Drehen Sie die Hand bei der nächsten Aufnahme um alle Achsen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{keypoints:list}: never or hardly measured by the glove. Their marker offsets are medians over the recording.</source>
      <translation>{keypoints:list}: vom Handschuh nie oder kaum gemessen. Der Markerversatz ist jeweils der Median über die Aufnahme.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The replay draws the points of the reference instead of a hand, because of missing ones: {keypoints:list}.</source>
      <translation>Die Wiedergabe zeichnet die Punkte der Referenz statt einer Hand, da Schlüsselpunkte fehlen: {keypoints:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{session}: the description of the reference cannot be read.</source>
      <translation>{session}: Die Beschreibung der Referenz kann nicht gelesen werden.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>or else rate must be given, not both</source>
      <translation>oder rate muss angegeben sein, nicht beides</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>must be a list of its three columns x, y and z</source>
      <translation>muss eine Liste der drei Spalten x, y und z sein</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Keyed poses to {host}:{port}</source>
      <translation>Benannte Posen an {host}:{port}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand {file} is larger than {limit_bytes} bytes.</source>
      <translation>Die Roboterhand {file} ist größer als {limit_bytes} Byte.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand {file} cannot be used: {why}</source>
      <translation>Die Roboterhand {file} kann nicht verwendet werden: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand cannot be mirrored: it has {what}.</source>
      <translation>Die Roboterhand lässt sich nicht spiegeln: sie hat {what}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A thumb and two other fingers were not found in the robot hand. Choose the links of its fingertips.</source>
      <translation>In der Roboterhand wurden ein Daumen und zwei weitere Finger nicht gefunden. Wählen Sie die Glieder ihrer Fingerspitzen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unknown finger "{finger}". Use {known:or}.</source>
      <translation>Unbekannter Finger „{finger}“. Verwenden Sie {known:or}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The link "{link}" is the tip of two fingers.</source>
      <translation>Das Glied „{link}“ ist die Spitze von zwei Fingern.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand has no link called "{link}".</source>
      <translation>Die Roboterhand hat kein Glied namens „{link}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} has no table [fingers] with a link for each finger.</source>
      <translation>{file} enthält keine Tabelle [fingers] mit einem Glied für jeden Finger.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The joint {joint} of the robot hand is not a hinge.</source>
      <translation>Das Gelenk {joint} der Roboterhand ist kein Scharniergelenk.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand's fingers do not share a palm.</source>
      <translation>Die Finger der Roboterhand haben keine gemeinsame Handfläche.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unknown robot command "{command}". Use {known:or}.</source>
      <translation>Unbekannter Roboterbefehl „{command}“. Verwenden Sie {known:or}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>A robot hand requires MuJoCo, which is not installed. Run: {install}</source>
      <translation>Eine Roboterhand braucht MuJoCo, das nicht installiert ist. Führen Sie aus: {install}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot hand {name} is not installed. Run: {install}</source>
      <translation>Die Roboterhand {name} ist nicht installiert. Führen Sie aus: {install}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Robot hand "{name}" not found. Use {known:or} or the path of an MJCF or URDF file.</source>
      <translation>Die Roboterhand „{name}“ wurde nicht gefunden. Verwenden Sie {known:or} oder den Pfad einer MJCF- oder URDF-Datei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Add a cube to the objects: pick and place requires one.</source>
      <translation>Fügen Sie den Objekten einen Würfel hinzu: Greifen und Ablegen braucht einen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The side must be right or left, not "{side}".</source>
      <translation>Die Seite muss rechts oder links sein, nicht „{side}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The clutch must be {known:or}, not "{clutch}".</source>
      <translation>Die Kupplung muss {known:or} sein, nicht „{clutch}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unknown object "{value}". Use {known:or}.</source>
      <translation>Unbekanntes Objekt „{value}“. Verwenden Sie {known:or}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The motion scale must be 0.1 to 10, the reach scale 0.5 to 2.</source>
      <translation>Die Bewegungsskala muss 0,1 bis 10 sein, die Reichweitenskala 0,5 bis 2.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Robot speeds must be greater than zero.</source>
      <translation>Robotergeschwindigkeiten müssen größer als null sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session's robot settings are damaged.</source>
      <translation>Die Robotereinstellungen der Sitzung sind beschädigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording was made with another robot: {why}.</source>
      <translation>Die Aufnahme wurde mit einem anderen Roboter gemacht: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recorded robot does not match its model.</source>
      <translation>Der aufgezeichnete Roboter passt nicht zu seinem Modell.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The robot's process has ended. Start the robot again.</source>
      <translation>Der Prozess des Roboters ist beendet. Starten Sie den Roboter neu.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--send requires HOST:PORT, not "{target}".</source>
      <translation>--send verlangt HOST:PORT, nicht „{target}“.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Invalid address "{address}". Use a UDP port or ws://HOST:PORT.</source>
      <translation>Ungültige Adresse „{address}“. Verwenden Sie einen UDP-Port oder ws://HOST:PORT.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Port {port} cannot be opened: {why}.</source>
      <translation>Port {port} lässt sich nicht öffnen: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain the initial state of its robot {robot}.</source>
      <translation>{path} enthält den Anfangszustand seines Roboters {robot} nicht.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{path} does not contain a robot. Requested: {robot}.</source>
      <translation>{path} enthält keinen Roboter. Angefordert: {robot}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The movement is too short. Turn the hand for at least {least_s:.0f} s while both the glove and the tracking system measure it.</source>
      <translation>Die Bewegung ist zu kurz. Drehen Sie die Hand mindestens {least_s:.0f} s lang, während Handschuh und Trackingsystem sie messen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove and the tracker do not move together (correlation {correlation:.2f}). Check that the tracker is on this hand and that it is tracked all the time.</source>
      <translation>Handschuh und Tracker bewegen sich nicht gemeinsam (Korrelation {correlation:.2f}). Prüfen Sie, ob der Tracker an dieser Hand befestigt ist und durchgehend erfasst wird.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand was turned about one axis only. Turn it about all axes: palm up and down, fingers up and down, left and right.</source>
      <translation>Die Hand wurde nur um eine Achse gedreht. Drehen Sie sie um alle Achsen: Handfläche nach oben und unten, Finger nach oben und unten, nach links und rechts.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The rotations of the glove and the tracker differ by {rms_deg:.0f}° (rms). Check that the tracker is fixed to the back of the hand and which axis of the room points up.</source>
      <translation>Die Drehungen von Handschuh und Tracker weichen um {rms_deg:.0f}° (RMS) voneinander ab. Prüfen Sie, ob der Tracker fest auf dem Handrücken sitzt und welche Achse des Raums nach oben zeigt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The wrist moved by {rms_mm:.0f} mm (rms). Rest it on a point while you turn the hand.</source>
      <translation>Das Handgelenk hat sich um {rms_mm:.0f} mm (RMS) bewegt. Stützen Sie es auf einem Punkt ab, während Sie die Hand drehen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} contains no poses of a tracker on the {side:word} hand.</source>
      <translation>{file} enthält keine Lagen eines Trackers an der Hand {side:word}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} contains positions of a tracker on the {side:word} hand, but no rotations. They cannot be aligned.</source>
      <translation>{file} enthält Positionen eines Trackers an der Hand {side:word}, aber keine Drehungen. Sie lassen sich nicht ausrichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The glove has no IMU on the segment {segment}. It cannot be aligned.</source>
      <translation>Der Handschuh hat keine IMU am Segment {segment}. Er lässt sich nicht ausrichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{file} is not an alignment: {why}.</source>
      <translation>{file} ist keine Ausrichtung: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No packets of the glove arrived. Check that it is connected.</source>
      <translation>Vom Handschuh kamen keine Pakete an. Prüfen Sie, ob er verbunden ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No poses of the tracker {name} arrived. Test the source, and check the tracker's name.</source>
      <translation>Vom Tracker {name} kamen keine Posen an. Testen Sie die Quelle und prüfen Sie den Namen des Trackers.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The tracker {name} has positions, but no rotations. It cannot be aligned.</source>
      <translation>Der Tracker {name} liefert Positionen, aber keine Drehungen. Er lässt sich nicht ausrichten.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{address}: there is no connection. Check that the program runs there, the address, and the firewall.</source>
      <translation>{address}: Es besteht keine Verbindung. Prüfen Sie, ob das Programm dort läuft, sowie die Adresse und die Firewall.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{address}: nothing was received in {seconds:.0f} s. Check that the other program sends to this address, and the firewall.</source>
      <translation>{address}: In {seconds:.0f} s wurde nichts empfangen. Prüfen Sie, ob das andere Programm an diese Adresse sendet, sowie die Firewall.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{address}: {count} packets were received that are not poses of this protocol.</source>
      <translation>{address}: Es wurden {count} Pakete empfangen, die keine Posen dieses Protokolls sind.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Poses arrive, but none of {names}. Choose one of these trackers:</source>
      <translation>Posen kommen an, aber keine von {names}. Wählen Sie einen dieser Tracker:</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Poses of {count} trackers arrive. Choose the tracker on each hand:</source>
      <translation>Posen von {count} Trackern kommen an. Wählen Sie den Tracker an jeder Hand:</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Poses of {count} trackers arrive:</source>
      <translation>Posen von {count} Trackern kommen an:</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The axis {axis} cannot point up. Choose y or z.</source>
      <translation>Die Achse {axis} kann nicht nach oben zeigen. Wählen Sie y oder z.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The protocol has no participant {name}. It has: {known:list}.</source>
      <translation>Das Protokoll hat keine Versuchsperson {name}. Es hat: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The folder {folder} contains a study by another protocol. Continue with the protocol in {stored}, or choose another folder.</source>
      <translation>Der Ordner {folder} enthält eine Studie nach einem anderen Protokoll. Fahren Sie mit dem Protokoll in {stored} fort, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{folder} contains no study. Start one with: glovetrack study run.</source>
      <translation>{folder} enthält keine Studie. Beginnen Sie eine mit: glovetrack study run.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The progress file {path} is damaged: {why}.</source>
      <translation>Die Fortschrittsdatei {path} ist beschädigt: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Another program is running the trials of {participant} in {folder}.</source>
      <translation>Ein anderes Programm führt gerade die Durchgänge von {participant} in {folder} aus.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The study in {folder} has no accepted trial yet.</source>
      <translation>Die Studie in {folder} hat noch keinen angenommenen Durchgang.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No accepted trial has a reference. Add motion-capture recordings with glovetrack import-reference; only simulated trials contain their truth.</source>
      <translation>Kein angenommener Durchgang hat eine Referenz. Fügen Sie Motion-Capture-Aufnahmen mit glovetrack import-reference hinzu; nur simulierte Durchgänge enthalten ihre Wahrheit.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Unknown variant {name}. Available: {known:list}.</source>
      <translation>Unbekannte Variante {name}. Verfügbar: {known:list}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This requires the extension {name}, which is not installed.</source>
      <translation>Hierfür ist die Erweiterung {name} nötig, die nicht installiert ist.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Nothing is tracked. Connect the glove and the camera, then start again.</source>
      <translation>Es wird nichts getrackt. Schließen Sie Handschuh und Kamera an, und starten Sie dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Another recording is running. Stop it, then start again.</source>
      <translation>Eine andere Aufnahme läuft. Beenden Sie diese, und starten Sie dann erneut.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording was interrupted before its end.</source>
      <translation>Die Aufnahme wurde vor ihrem Ende abgebrochen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording cannot be read: {why}</source>
      <translation>Die Aufnahme ist nicht lesbar: {why}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The recording lasts {duration_s:.1f} s; the protocol requires {least_s:.1f} s.</source>
      <translation>Die Aufnahme dauert {duration_s:.1f} s; das Protokoll verlangt {least_s:.1f} s.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The hand was tracked for {found_percent:.0f} % of the time; the protocol requires {least_percent:.0f} %.</source>
      <translation>Die Hand wurde {found_percent:.0f} % der Zeit getrackt; das Protokoll verlangt {least_percent:.0f} %.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Keypoints were measured for {found_percent:.0f} % of the time; the protocol requires {least_percent:.0f} %.</source>
      <translation>Punkte der Hand wurden {found_percent:.0f} % der Zeit gemessen; das Protokoll verlangt {least_percent:.0f} %.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{found_percent:.1f} % of the packets were lost; the protocol allows {most_percent:.1f} %.</source>
      <translation>{found_percent:.1f} % der Pakete gingen verloren; das Protokoll erlaubt {most_percent:.1f} %.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{found_hz:.0f} packets per second arrived; the protocol requires {least_hz:.0f}.</source>
      <translation>{found_hz:.0f} Pakete pro Sekunde kamen an; das Protokoll verlangt {least_hz:.0f}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{found_percent:.0f} % of the images were not searched; the protocol allows {most_percent:.0f} %.</source>
      <translation>{found_percent:.0f} % der Bilder wurden nicht durchsucht; das Protokoll erlaubt {most_percent:.0f} %.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{found_hz:.1f} images per second arrived; the protocol requires {least_hz:.1f}.</source>
      <translation>{found_hz:.1f} Bilder pro Sekunde kamen an; das Protokoll verlangt {least_hz:.1f}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is missing: a study has at least one condition</source>
      <translation>fehlt: Eine Studie hat mindestens eine Bedingung</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is not part of any condition</source>
      <translation>kommt in keiner Bedingung vor</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is missing: give a number or a list of labels</source>
      <translation>fehlt: Geben Sie eine Anzahl oder eine Liste von Bezeichnungen an</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains a task twice; use trials instead</source>
      <translation>enthält eine Aufgabe zweimal; verwenden Sie trials</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>is {drawn}, but there are {count} things</source>
      <translation>ist {drawn}, vorhanden sind aber {count} Dinge</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>requires things_drawn: how many things a trial uses</source>
      <translation>erfordert things_drawn: wie viele Dinge ein Durchgang verwendet</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>requires a duration</source>
      <translation>erfordert eine Dauer</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>leaves no time for cues</source>
      <translation>lässt keine Zeit für Hinweise</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains the picture "{picture}", which is outside its folder</source>
      <translation>enthält das Bild „{picture}“, das außerhalb des Ordners liegt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains the picture "{picture}", which does not exist</source>
      <translation>enthält das Bild „{picture}“, das es nicht gibt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains "{task}", which is not a task. Known tasks: {known}</source>
      <translation>enthält „{task}“, das ist keine Aufgabe. Bekannte Aufgaben: {known}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>contains "{label}", which is not a label: use 1 to 32 letters and digits</source>
      <translation>enthält „{label}“, das ist keine Bezeichnung: Verwenden Sie 1 bis 32 Buchstaben und Ziffern</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No image shows the sheet of the touch test. Print it with: glovetrack print touch. Record with images, with the whole sheet in view.</source>
      <translation>Kein Bild zeigt das Blatt des Berührungstests. Drucken Sie es mit: glovetrack print touch. Nehmen Sie mit Bildern auf; das ganze Blatt muss im Bild sein.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The printed squares measure {found_mm:.2f} mm instead of 20.00 mm ({percent:+.1f} %). Print at 100 %, not fitted to the page.</source>
      <translation>Die gedruckten Quadrate messen {found_mm:.2f} mm statt 20,00 mm ({percent:+.1f} %). Drucken Sie mit 100 %, nicht an die Seite angepasst.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The stereo camera measures the sheet {percent:+.1f} % off its size. Calibrate the camera.</source>
      <translation>Die Stereokamera misst das Blatt mit einer Abweichung von {percent:+.1f} %. Kalibrieren Sie die Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The sheet's corners differ by {fit_px:.1f} px from a flat sheet. Flatten the sheet, or calibrate the camera.</source>
      <translation>Die Ecken des Blatts weichen um {fit_px:.1f} px von einem ebenen Blatt ab. Glätten Sie das Blatt oder kalibrieren Sie die Kamera.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The sheet moved by {moved_mm:.1f} mm during the test. Tape it to the table and repeat.</source>
      <translation>Das Blatt hat sich während des Tests um {moved_mm:.1f} mm bewegt. Kleben Sie es auf dem Tisch fest und wiederholen Sie den Test.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The printed line of 260 mm was not measured. The scale of the camera is therefore taken to be right.</source>
      <translation>Die gedruckte Linie von 260 mm wurde nicht gemessen. Der Maßstab der Kamera gilt daher als richtig.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The touch test requires a camera that does not move.</source>
      <translation>Der Berührungstest braucht eine Kamera, die sich nicht bewegt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The session contains no tracked hand. Track it first: glovetrack track.</source>
      <translation>Die Aufnahme enthält keine getrackte Hand. Verfolgen Sie sie zuerst: glovetrack track.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{count} touches were found; the touch test requires {least} of at least one finger.</source>
      <translation>{count} Berührungen wurden gefunden; der Berührungstest braucht {least} von mindestens einem Finger.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The sessions belong to several people or hands ({found}). Repeatability is that of one hand.</source>
      <translation>Die Aufnahmen gehören zu mehreren Personen oder Händen ({found}). Wiederholbarkeit gilt für eine Hand.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No finger was tested in all of these sessions.</source>
      <translation>Kein Finger wurde in allen diesen Aufnahmen geprüft.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>No touch was found for {count} cues: {numbers}.</source>
      <translation>Für {count} Aufgaben wurde keine Berührung gefunden: {numbers}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The contact of the {finger:word} is {off_mm:.1f} mm from the hand file's. Check the lengths in the hand file and the glove file.</source>
      <translation>Die Kontaktstelle ({finger:word}) liegt {off_mm:.1f} mm neben der aus der Handdatei. Prüfen Sie die Längen in der Handdatei und der Handschuhdatei.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Touch {number}: cross {touched} was touched instead of cross {asked}.</source>
      <translation>Berührung {number}: Kreuz {touched} wurde statt Kreuz {asked} berührt.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Touch cross {target} with the {finger:word}: {how}.</source>
      <translation>Berühren Sie Kreuz {target} ({finger:word}): {how}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Pinch thumb and index finger 20 times.</source>
      <translation>Führen Sie Daumen und Zeigefinger 20-mal zusammen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>Hold the hand still for 10 seconds.</source>
      <translation>Halten Sie die Hand 10 Sekunden lang still.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The printed line of 260 mm measures {length_mm:.1f} mm.</source>
      <translation>Die gedruckte Linie von 260 mm misst {length_mm:.1f} mm.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>--ruler must be 240 to 280 mm. Measure the printed line of 260 mm.</source>
      <translation>--ruler muss 240 bis 280 mm sein. Messen Sie die gedruckte Linie von 260 mm.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream} at {path}</source>
      <translation>{stream} unter {path}</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: received. VMT {version} responds.</source>
      <translation>{stream}: empfangen. VMT {version} antwortet.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: lines were sent, and the terminal has room for more.</source>
      <translation>{stream}: Zeilen wurden gesendet, und das Terminal kann weitere aufnehmen.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{stream}: no program reads the terminal. Open it as a serial port.</source>
      <translation>{stream}: Kein Programm liest das Terminal. Öffnen Sie es als seriellen Anschluss.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no gesture "{name}". Available: {known}.</source>
      <translation>Eine Geste „{name}“ gibt es nicht. Vorhanden: {known}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{address} has an index, a frequency, an amplitude and a duration.</source>
      <translation>{address} hat einen Index, eine Frequenz, eine Amplitude und eine Dauer.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>There is no finger "{name}". Available: {known}, {all}.</source>
      <translation>Einen Finger „{name}“ gibt es nicht. Vorhanden: {known}, {all}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>This system has no pseudo-terminals.</source>
      <translation>Dieses System hat keine Pseudoterminals.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>The link {link} cannot be created: {why}.</source>
      <translation>Die Verknüpfung {link} kann nicht angelegt werden: {why}.</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>left lens</source>
      <translation>linkes Objektiv</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>right lens</source>
      <translation>rechtes Objektiv</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>lens</source>
      <translation>Objektiv</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>top left</source>
      <translation>oben links</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>top</source>
      <translation>oben</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>top right</source>
      <translation>oben rechts</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the middle</source>
      <translation>die Mitte</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>bottom left</source>
      <translation>unten links</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>bottom</source>
      <translation>unten</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>bottom right</source>
      <translation>unten rechts</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>still</source>
      <translation>unbewegt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>silent</source>
      <translation>schweigt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>unclear</source>
      <translation>unklar</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>elsewhere</source>
      <translation>an anderer Stelle</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>turned</source>
      <translation>verdreht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>hands</source>
      <translation>Hände</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>gloves</source>
      <translation>Handschuhe</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>colours</source>
      <translation>Farben</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>cameras</source>
      <translation>Kameras</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>robots</source>
      <translation>Roboter</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the camera</source>
      <translation>der Kamera</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>both cameras</source>
      <translation>beiden Kameras</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>too long</source>
      <translation>zu lang</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>nothing before or after it</source>
      <translation>davor oder danach liegt nichts</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>its ends or the sensors are not known</source>
      <translation>ihre Enden oder die Sensorwerte sind nicht bekannt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a configuration file</source>
      <translation>eine Konfigurationsdatei</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a mesh that can be read</source>
      <translation>ein lesbares Netz</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a folder</source>
      <translation>ein Ordner</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a device, not a file</source>
      <translation>ein Gerät, keine Datei</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk is full</source>
      <translation>die Festplatte ist voll</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk quota is used up</source>
      <translation>das Kontingent ist aufgebraucht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk allows no file this large</source>
      <translation>das Dateisystem erlaubt keine so große Datei</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>you may not write there</source>
      <translation>Sie dürfen dort nicht schreiben</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk can only be read</source>
      <translation>der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk failed or was taken away</source>
      <translation>der Datenträger ist ausgefallen oder wurde entfernt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the disk was taken away</source>
      <translation>der Datenträger wurde entfernt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the network disk is disconnected</source>
      <translation>das Netzlaufwerk ist getrennt</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the folder does not exist</source>
      <translation>der Ordner existiert nicht</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>the name is too long</source>
      <translation>der Name ist zu lang</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a file of that name exists already</source>
      <translation>eine Datei dieses Namens gibt es schon</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>a folder of that name exists already</source>
      <translation>einen Ordner dieses Namens gibt es schon</translation>
    </message>
    <message>
      <location filename="glovetrack.notices" />
      <source>{} or {}</source>
      <translation>{} oder {}</translation>
    </message>
  </context>
</TS>