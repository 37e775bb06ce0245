"""The lines of a session file: JSON objects, each sealed with a checksum of itself and of all lines before it."""

import json
import re
import zlib

from game.world.files.atomic import FileError
from game.world.files.checked_table import CheckedTable, shown
from game.world.sand import parameters
from game.world.sand.parameters import Knob
from game.world.scenes import scene_json
from game.world.sessions import action_json

VERSION = 1
LARGEST_FILE = 2**28  # bytes: a lattice of the largest size full of noise fits
SEALED = re.compile(rb'(\{.*),"sum":"([0-9a-f]{8})"\}', re.DOTALL)
DIGEST = re.compile("([0-9a-f]{32})?")


class ReplayError(FileError):
    """What is wrong with a session file, as one line: FILE: line N: KEY: found X, wanted Y."""


class LineWriter:
    """Writes the lines of one file, in order."""

    def __init__(self, checksum=0, known=None):
        self.checksum = checksum  # of all lines so far
        self.known = scene_json.KnownScenes() if known is None else known

    def header(self, scene, seed):
        """Return the first line."""
        return self.line({"sandglass": VERSION, "scene": scene_json.encode(scene, self.known), "seed": seed})

    def entry(self, entry):
        """Return the line of an Entry."""
        return self.line(action_json.encode(entry, self.known))

    def end(self, at, digest):
        """Return the last line: where the session ended, and the world's digest there ("" where nobody knows)."""
        return self.line({"at": at, "do": "end", "digest": digest})

    def line(self, values):
        """Return the line of a dict, with its seal."""
        body = json.dumps(values, separators=(",", ":"))[:-1].encode()
        self.checksum = zlib.crc32(body, self.checksum)
        return b'%s,"sum":"%08x"}\n' % (body, self.checksum)


class LineReader:
    """Reads the lines of one file, in order; raises ReplayError or TableError for the first that is wrong."""

    def __init__(self, file):
        self.file = file
        self.version = VERSION
        self.checksum, self.known, self.number = 0, scene_json.KnownScenes(), 0

    def header(self, line):
        """Return (scene, seed) from the first line."""
        table = self._opened(line)
        self.version = table.number("sandglass", Knob("version", VERSION, 1, 2**31, "", "", whole=True))
        if self.version == VERSION:
            table.allow(("sandglass", "scene", "seed"))
        return scene_json.decode(table.table("scene"), self.known), table.number("seed", parameters.SEED)

    def entries(self, line):
        """Return the entries of a line as a list, or the (iteration, digest) of the last line."""
        table = self._opened(line)
        if table.values.get("do") != "end":
            return action_json.decode(table, self.known)
        table.allow(("at", "do", "digest"))
        digest = table.line("digest", "")
        if not DIGEST.fullmatch(digest):
            raise table.error("digest", shown(digest), "32 hex digits or none")
        return table.number("at", parameters.MOMENT), digest

    def _opened(self, line):
        """Return the CheckedTable of a line whose seal is whole."""
        self.number += 1
        where = f"line {self.number}"
        seal = SEALED.fullmatch(line)
        if not seal:
            raise ReplayError(f"{self.file}: {where}: found no sealed record, wanted a line as Sandglass writes it")
        body, checksum = seal[1], zlib.crc32(seal[1], self.checksum)
        if checksum != int(seal[2], 16):
            raise ReplayError(f"{self.file}: {where}: found the seal {seal[2].decode()}, wanted {checksum:08x}: edited")
        try:
            values = json.loads(body + b"}")
        except (ValueError, RecursionError):
            raise ReplayError(f"{self.file}: {where}: found broken JSON, wanted an object") from None
        self.checksum = checksum
        return CheckedTable(self.file, values, f"{where}: ")
