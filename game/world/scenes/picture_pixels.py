"""Pixels of a picture file, read in one way for all who need them: no more than it may have, upright, in eight bits."""

import io
import warnings
from contextlib import contextmanager

import numpy as np

from game.world.files.atomic import load
from game.world.sand import parameters

FORMATS = ("PNG", "GIF", "BMP", "JPEG", "WEBP")
LARGEST_FILE = 2**28  # bytes
MOST_PIXELS = 2**26  # of a picture: about half a gigabyte while it is read
PICTURE_SIZE = f"{MOST_PIXELS} pixels and {parameters.SIDE.high} a side"
LARGE = 4096  # pixels of a side, beyond which a thumbnail is made of some of the pixels only
CHUNK = "sandglass"  # the key of the text in the PNG of a saved scene


@contextmanager
def opened(path, error, saved_too=False):
    """Yield the Pillow picture in a file, of which so far only the head is decoded.

    saved_too: let a saved scene be as large as a lattice. Raises FileError for a file that cannot be read, and
    error(found, wanted) for one that is no picture, is damaged or too large, also where decoding it finds that out.
    """
    from PIL import Image  # only those who open a picture wait for Pillow

    Image.MAX_IMAGE_PIXELS = None  # what is too large is found out here, before its pixels are read
    data = load(path, LARGEST_FILE)
    wrong = f"an unreadable {path.name!r}", f"a {', '.join(FORMATS)} of at most {PICTURE_SIZE}"
    try:
        with warnings.catch_warnings(action="ignore"), Image.open(io.BytesIO(data), formats=FORMATS) as picture:
            too_large = _too_large(picture, saved_too)
            if not too_large:
                picture.verify()  # the checksums of a PNG, which decoding passes over
                with Image.open(io.BytesIO(data), formats=FORMATS) as picture:
                    yield picture
                return
            wrong = too_large
    except Exception:  # Pillow's decoders raise whatever a damaged file makes them trip over
        pass
    raise error(*wrong)


def is_saved(picture):
    """Return whether a Pillow picture is as a scene is saved: a palette of materials, with its settings as text."""
    return CHUNK in picture.info and picture.mode == "P" and "transparency" not in picture.info


def upright(picture):
    """Return a Pillow picture turned as the camera was held."""
    from PIL import ImageOps

    return ImageOps.exif_transpose(picture)


def rgba(picture):
    """Return the (H, W, 4) uint8 pixels of a Pillow picture, upright, each channel in eight bits."""
    sixteen, clear = ";16" in str(picture.tile), picture.info.get("transparency")
    picture = upright(picture)
    if picture.mode.startswith("I"):  # grey in sixteen bits
        levels = np.asarray(picture).clip(0, 2**16 - 1)
        grey, alpha = (levels >> 8).astype(np.uint8), np.where(levels == clear, 0, 255).astype(np.uint8)
        return np.dstack([grey, grey, grey, alpha])
    if sixteen and clear is not None:  # Pillow halves the bits of the pixels, not those of the clear colour
        picture.info["transparency"] = tuple(part >> 8 for part in clear)
    return np.asarray(picture.convert("RGBA"))


def thumbnail(picture, largest):
    """Return (size, RGB bytes) of a Pillow picture made as small as `largest`, upright."""
    from PIL import Image

    if max(picture.size) > LARGE:  # the mean of all its cells would take gigabytes
        picture.thumbnail((LARGE, LARGE), Image.Resampling.NEAREST)
    small = Image.fromarray(rgba(picture)).convert("RGB")
    small.thumbnail(largest, Image.Resampling.BOX)
    return small.size, small.tobytes()


def _too_large(picture, saved_too):
    """Return what is found and wanted where a Pillow picture has too many pixels, else None."""
    width, height = picture.size
    most = parameters.SIDE.high**2 if saved_too and is_saved(picture) else MOST_PIXELS
    if max(width, height) <= parameters.SIDE.high and width * height <= most:
        return None
    return f"{width}×{height} pixels", f"at most {PICTURE_SIZE}"
