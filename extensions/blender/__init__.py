"""An add-on for Blender, a file that Blender loads; the program itself does not import it."""
