"""How the scripts of this folder leave a picture: whole, or not at all."""
import os
import sys


def save(figure, path, **options):
    """Writes a PNG; if that cannot be, ends the program with a line that says why."""
    part = f"{path}.part"
    try:
        figure.savefig(part, format="png", **options)
        os.replace(part, path)
    except OSError as error:
        if os.path.isfile(part) or os.path.islink(part):
            os.unlink(part)
        sys.exit(f"{part}: cannot write: {error.strerror or error}")
