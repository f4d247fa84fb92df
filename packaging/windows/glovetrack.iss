; Inno Setup's script for Windows: an installer of dist\glovetrack. See packaging/README.md.

#ifndef Version
  #error "Give the version: iscc /DVersion=0.2.0 glovetrack.iss"
#endif

[Setup]
AppId={{6E6C4D0B-5B1F-4E39-9A0E-3C5C0A5F7B21}
AppName=Glovetrack
AppVersion={#Version}
DefaultDirName={autopf}\Glovetrack
DefaultGroupName=Glovetrack
PrivilegesRequiredOverridesAllowed=dialog
ArchitecturesAllowed=x64compatible
ArchitecturesInstallIn64BitMode=x64compatible
ChangesAssociations=yes
LicenseFile=..\..\LICENSE
OutputDir=..\..\dist
OutputBaseFilename=glovetrack-{#Version}-setup
Compression=lzma2
SolidCompression=yes
UninstallDisplayIcon={app}\glovetrack.exe
WizardStyle=modern

[Tasks]
Name: desktopicon; Description: "{cm:CreateDesktopIcon}"; Flags: unchecked

[Files]
Source: "..\..\dist\glovetrack\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion

[Run]
Filename: "{app}\glovetrack.exe"; Description: "{cm:LaunchProgram,Glovetrack}"; Flags: nowait postinstall skipifsilent

[Icons]
Name: "{group}\Glovetrack"; Filename: "{app}\glovetrack.exe"
Name: "{autodesktop}\Glovetrack"; Filename: "{app}\glovetrack.exe"; Tasks: desktopicon

[Registry]
Root: HKA; Subkey: "Software\Classes\.mcap\OpenWithProgids"; ValueType: string; ValueName: "Glovetrack.Session"; ValueData: ""; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\Glovetrack.Session"; ValueType: string; ValueData: "Glovetrack session"; Flags: uninsdeletekey
Root: HKA; Subkey: "Software\Classes\Glovetrack.Session\shell\open\command"; ValueType: string; ValueData: """{app}\glovetrack.exe"" ""%1"""

[UninstallDelete]
Type: filesandordirs; Name: "{app}\_internal"
Type: filesandordirs; Name: "{localappdata}\glovetrack\kernels-*"
