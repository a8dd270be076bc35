"""Near–far reduction: a scene becomes near geometry and a map of what is far, kept as a folder of files."""
