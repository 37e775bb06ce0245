"""Where files are: those that ship with the toy, and the user's own."""

import os
import re
import threading
from datetime import datetime
from pathlib import Path

from platformdirs import user_config_dir, user_data_dir

from game.world.files.atomic import trouble

PACKAGE = Path(__file__).resolve().parents[2]
LONGEST_NAME = 40  # characters of a file's name, without time and suffix

_given, _giving = set(), threading.Lock()  # the paths that were returned for new files, one thread at a time


def asset(*parts):
    """Return the path of a shipped file or folder: inside an installed package, or beside it in a checkout."""
    installed = PACKAGE / "assets"
    home = installed if installed.is_dir() else PACKAGE.parent / "assets"
    return home.joinpath(*parts)


def folder_of(kind):
    """Return the folder of the user's files of a kind: in $SANDGLASS_DATA_DIR, or where the system keeps such data."""
    home = os.environ.get("SANDGLASS_DATA_DIR") or user_data_dir("sandglass", appauthor=False)
    return Path(home) / kind


def config_file():
    """Return the path of the settings: in $SANDGLASS_CONFIG_DIR, or where the system keeps such files."""
    home = os.environ.get("SANDGLASS_CONFIG_DIR") or user_config_dir("sandglass", appauthor=False)
    return Path(home) / "settings.toml"


def new_file(kind, name, suffix):
    """Return a path for a new file, made of a name and the time; its folder is made. Raises FileError.

    No path is returned twice, even before its file is written.
    """
    folder = folder_of(kind)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise trouble(folder, "cannot make the folder", error) from None
    plain = re.sub(r"[^\w-]+", "-", _without_time(name)).strip("-")[:LONGEST_NAME] or "sand"
    stem = f"{plain} {datetime.now():%Y-%m-%d %H.%M.%S}"
    with _giving:
        path, number = folder / f"{stem}{suffix}", 1
        while path in _given or path.exists():
            number += 1
            path = folder / f"{stem} {number}{suffix}"
        _given.add(path)
    return path


def _without_time(name):
    """Return the name of a scene that was saved before without the time of that."""
    return re.sub(r" \d{4}-\d\d-\d\d \d\d\.\d\d\.\d\d.*$", "", name)
