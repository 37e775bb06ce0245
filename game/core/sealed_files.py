"""Files of machine code behind a checksum: code with a wrong byte crashes."""

import hashlib
import os
import threading

_SEAL = 32  # bytes of the checksum before the code


def read_sealed(path):
    """Return the bytes in a file; raise ValueError if they are not those that were written, OSError as reading does."""
    sealed = path.read_bytes()
    if hashlib.sha256(sealed[_SEAL:]).digest() != sealed[:_SEAL]:
        raise ValueError("found other bytes than were written")
    return sealed[_SEAL:]


def write_sealed(path, data):
    """Write bytes to a file in one step, and its folder if need be."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}-{threading.get_ident()}.part")
    try:
        part.write_bytes(hashlib.sha256(data).digest() + data)
        os.replace(part, path)
    except OSError:
        part.unlink(missing_ok=True)
        raise
