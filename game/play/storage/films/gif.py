"""GIF: what every messenger, forum and slide plays."""

from game.play.storage.films.film_file import enlarged, patch

FOR_EVER = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"  # repeat for ever
TRAILER = b";"


class GifEncoder:
    """Writes frames as blocks of a GIF with one palette; what stays as it is between two is transparent."""

    suffix = ".gif"
    unit_ms = 10  # in which a GIF counts time

    def __init__(self, colours, zoom=1):
        """`colours`: the RGB bytes of the palette. `zoom`: pixels across a pixel of the frames."""
        self._colours, self._zoom = colours.ljust(768, b"\0"), zoom
        self._file, self._head = None, b""

    def begin(self, part, shape):
        """Write to a Part."""
        self._file, self._head = part.file, FOR_EVER

    def write(self, before, now, ms):
        """Write a frame, which follows another or None."""
        from PIL import GifImagePlugin

        left, top, pixels, unchanged = patch(before, now)
        image = self._image(enlarged(pixels, self._zoom))
        how = {"duration": ms, "disposal": 1, "include_color_table": False}
        if unchanged is not None:
            how["transparency"] = unchanged
        blocks = GifImagePlugin.getdata(image, (left * self._zoom, top * self._zoom), **how)
        if self._head:
            self._file.write(b"".join(GifImagePlugin.getheader(image)[0]) + self._head)
            self._head = b""
        self._file.writelines(blocks)

    def end(self):
        """Write what comes after the last frame."""
        self._file.write(TRAILER)

    def drop(self):
        """Leave nothing behind."""

    def _image(self, pixels):
        from PIL import Image

        image = Image.fromarray(pixels, "P")
        image.putpalette(self._colours)
        return image
