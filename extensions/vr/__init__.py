"""Virtual reality: hands as controllers of SteamVR and of runtimes that read OpenGloves."""
