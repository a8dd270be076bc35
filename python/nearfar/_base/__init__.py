"""Code that every stage uses: argument checks, errors, files and formats, cache, progress, random numbers."""
