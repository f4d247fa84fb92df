"""The 3D hand panel."""
