"""Where files are: those that ship with the toy, and the user's own."""

import os
import re
from datetime import datetime
from functools import cache
from pathlib import Path

from platformdirs import user_config_dir, user_data_dir

from game.world.files.atomic import clear_parts, make_folder, save_as_new

PACKAGE = Path(__file__).resolve().parents[2]
LONGEST_NAME = 40  # characters of a file's name, without time and suffix
NO_NAMES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)  # of files, for Windows
# Of files that the user makes, each in a folder of its own.
KINDS = "scenes", "stamps", "replays", "pictures", "measures", "rules"


def asset(*parts):
    """Return the path of a shipped file or folder: inside an installed package, or beside it in a checkout."""
    return _assets().joinpath(*parts)


@cache
def _assets():
    installed = PACKAGE / "assets"
    return installed if installed.is_dir() else PACKAGE.parent / "assets"


def folder_of(kind):
    """Return the folder of the user's files of a kind: in $SANDGLASS_DATA_DIR, or where the system keeps such data."""
    home = os.environ.get("SANDGLASS_DATA_DIR") or user_data_dir("sandglass", appauthor=False)
    return Path(home) / kind


def config_file():
    """Return the path of the settings: in $SANDGLASS_CONFIG_DIR, or where the system keeps such files."""
    home = os.environ.get("SANDGLASS_CONFIG_DIR") or user_config_dir("sandglass", appauthor=False)
    return Path(home) / "settings.toml"


def new_name(kind, name, suffix):
    """Return a function of 1, 2 … that gives the paths a new file may have, by a name and the time; make its folder.

    Raises FileError.
    """
    folder = folder_of(kind)
    make_folder(folder)
    plain = re.sub(r"[^\w-]+", "-", _without_time(name)).strip("-")[:LONGEST_NAME] or "sand"
    stem = f"{plain} {datetime.now():%Y-%m-%d %H.%M.%S}"
    return numbered(folder / f"{stem}{suffix}")


def numbered(path):
    """Return a function of 1, 2 … that gives a path, and after it the same with a number in its name."""
    return lambda number: path if number == 1 else path.with_name(f"{path.stem} {number}{path.suffix}")


def save_new(kind, name, suffix, data):
    """Write bytes to a new file among the user's of a kind and return its path; raise FileError."""
    return save_as_new(new_name(kind, name, suffix), data)


def save_named(kind, name, suffix, data):
    """Write bytes to a new file among the user's of a kind, called by a name; return its path, or raise FileError.

    Where there is such a file already, the new one has a number in its name.
    """
    folder = folder_of(kind)
    make_folder(folder)
    return save_as_new(numbered(folder / f"{file_stem(name)}{suffix}"), data)


def file_stem(name):
    """Return the name of a file, without suffix, that is as near to a name as systems allow."""
    plain = re.sub(r'[<>:"/\\|?*\x00-\x1f]+', "-", name).strip(" .")[:LONGEST_NAME].strip(" .") or "sand"
    return f"{plain}-" if NO_NAMES.fullmatch(plain) else plain


def clear_user_parts():
    """Remove what processes that were killed have left of the user's files."""
    for folder in (*map(folder_of, KINDS), config_file().parent):
        clear_parts(folder)


def _without_time(name):
    """Return the name of a scene that was saved before without the time of that."""
    return re.sub(r" \d{4}-\d\d-\d\d \d\d\.\d\d\.\d\d.*$", "", name)
