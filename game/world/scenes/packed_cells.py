"""Cells as text for JSON: their bits one after the other, compressed."""

import base64
import binascii
import zlib

import numpy as np


def bits_of(numbers, depth):
    """Return the bits of (H, W) uint8 numbers as bool arrays, the lowest first; none where there are no numbers."""
    return () if numbers is None else [(numbers >> bit & 1).astype(bool) for bit in range(depth)]


def cells_of_bits(bits):
    """Return the (H, W) uint8 numbers, not writable, of bool arrays of their bits."""
    numbers = sum(plane.view(np.uint8) << bit for bit, plane in enumerate(bits)).astype(np.uint8)
    numbers.flags.writeable = False
    return numbers


def packed(planes):
    """Return (H, W) bool arrays as text."""
    bits = b"".join(np.packbits(plane).tobytes() for plane in planes)
    return base64.b64encode(zlib.compress(bits, 9)).decode()


def unpacked(table, key, width, height, number):
    """Return the (height, width) bool arrays, not writable, that the text at `key` holds, so many of them."""
    length = -(-width * height // 8)  # bytes
    wanted = f"{number * length} bytes, packed, of {number} bits for each of {width}×{height} cells"
    unpacker = zlib.decompressobj()
    try:
        bits = unpacker.decompress(base64.b64decode(table.values[key], validate=True), number * length + 1)
    except (TypeError, ValueError, binascii.Error, zlib.error):
        raise table.error(key, "damaged ones", wanted) from None
    if len(bits) != number * length or not unpacker.eof:
        raise table.error(key, "another number of them", wanted)
    planes = []
    for start in range(0, number * length, length):
        part = np.frombuffer(bits[start : start + length], np.uint8)
        plane = np.unpackbits(part, count=width * height).reshape(height, width).view(np.bool_)
        plane.flags.writeable = False
        planes.append(plane)
    return planes
