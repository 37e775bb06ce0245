"""The clipboard of the system: pictures put there and taken from there, by the program that the system has for it."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from game.world.files.atomic import FileError
from game.world.scenes.picture_file import open_picture

PATIENCE_S = 10.0  # for a program that puts a picture there
NAME = "Clipboard.png"
MAC = 'set the clipboard to (read (POSIX file "{}") as «class PNGf»)'
WINDOWS = (
    "Add-Type -AssemblyName System.Windows.Forms, System.Drawing; "
    "[System.Windows.Forms.Clipboard]::SetImage([System.Drawing.Image]::FromFile($env:SANDGLASS_PICTURE))"
)


class ClipboardError(FileError):
    """Why a picture was not put on the clipboard, or not found there, as one line."""


def put_picture(data):
    """Put the picture in the bytes of a PNG on the clipboard; raise ClipboardError where that fails."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, NAME)
        path.write_bytes(data)
        command = _command(path)
        if not shutil.which(command[0]):
            raise ClipboardError(f"clipboard: found no {command[0]}, wanted that program to put pictures there")
        try:
            with open(path, "rb") as picture:
                subprocess.run(  # without pipes: the program may stay, to hand the picture out
                    command,
                    stdin=picture,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    env={**os.environ, "SANDGLASS_PICTURE": str(path)},
                    timeout=PATIENCE_S,
                    check=True,
                )
        except (OSError, subprocess.SubprocessError):
            raise ClipboardError(f"clipboard: {command[0]} did not put the picture there") from None


def picture_there():
    """Return what is on the clipboard, a picture or the name of a file, as `open_picture` does.

    Raises ClipboardError, or the FileError of the picture.
    """
    from PIL import ImageGrab

    try:
        found = ImageGrab.grabclipboard()
    except Exception as error:  # whatever a damaged picture or a missing program makes Pillow trip over
        raise ClipboardError(f"clipboard: cannot be read: {error}") from None
    if isinstance(found, list) and found:
        return open_picture(found[0])
    if not found:
        raise ClipboardError("clipboard: found no picture, wanted one that was copied elsewhere")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, NAME)
        found.save(path, "PNG")
        return open_picture(path)


def _command(path):
    """Return the command that takes a PNG from a file, or from its standard input."""
    if sys.platform == "darwin":
        return ["osascript", "-e", MAC.format(path)]
    if sys.platform == "win32":
        return ["powershell", "-NoProfile", "-STA", "-Command", WINDOWS]
    if os.environ.get("WAYLAND_DISPLAY") and shutil.which("wl-copy"):
        return ["wl-copy", "--type", "image/png"]
    return ["xclip", "-selection", "clipboard", "-t", "image/png", "-i"]
