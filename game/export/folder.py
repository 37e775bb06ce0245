"""Files of one export: all of them are written, or none; and none that somebody else wrote is replaced."""

from game.world.files.atomic import FileError, Part, make_folder, trouble

MARK = "Written by Sandglass; a new export replaces this file unless this line is taken out."


def write_all(folder, texts):
    """Write {name: text} to a folder; raise FileError if that is not possible, or a file there has not the MARK."""
    make_folder(folder)
    for name in texts:
        _check_own(folder / name)
    parts = {}
    try:
        for name, text in texts.items():
            parts[name] = Part(folder, name)
            parts[name].file.write(text.encode())
            parts[name].file.flush()
        for name, part in parts.items():
            part.put(folder / name)
    except OSError as error:
        for part in parts.values():
            part.drop()
        raise trouble(folder / name, "cannot save", error) from None


def _check_own(path):
    try:
        with open(path, "rb") as file:
            is_own = MARK.encode() in file.read(1024)
    except FileNotFoundError:
        return
    except OSError as error:
        raise trouble(path, "cannot read", error) from None
    if not is_own:
        raise FileError(f"{path}: file: found one that no export wrote, wanted another folder; nothing is written")
