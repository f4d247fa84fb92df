"""What dialogs have in common that lead the wearer from pose to pose and tell what came of it."""
