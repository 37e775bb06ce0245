"""Where the files that ship with the toy are: beside the code in a checkout, inside the package when installed."""

from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2]


def asset(*parts):
    """Return the path of a shipped file or folder."""
    installed = PACKAGE / "assets"
    home = installed if installed.is_dir() else PACKAGE.parent / "assets"
    return home.joinpath(*parts)
