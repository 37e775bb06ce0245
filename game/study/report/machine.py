"""The machine that figures are measured on, in one line."""

import os
import platform
from importlib.metadata import version
from pathlib import Path


def line():
    """Return processor, cores, caches, system, versions and how busy the machine is, as one line."""
    caches = " + ".join(_readable(size) for size in cache_bytes()) or "unknown"
    parts = (
        f"{_processor()}, {os.cpu_count()} cores, caches {caches}",
        f"{platform.system()} {platform.machine()}",
        f"Python {platform.python_version()}",
        *(f"{name} {version(name)}" for name in ("numpy", "numba")),
        *([f"load {os.getloadavg()[0]:.1f}"] if hasattr(os, "getloadavg") else []),
    )
    return "; ".join(parts)


def cache_bytes():
    """Return the sizes of the data caches, the first level first; nothing where the system does not tell."""
    found = {}
    for folder in Path("/sys/devices/system/cpu/cpu0/cache").glob("index*"):
        kind, level, size = ((folder / name).read_text().strip() for name in ("type", "level", "size"))
        if kind != "Instruction":
            found[level] = int(size.removesuffix("K")) * 1024
    return [found[level] for level in sorted(found)]


def _readable(size):
    return f"{size // 2**20} MiB" if size >= 2**20 else f"{size // 2**10} KiB"


def _processor():
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    names = [text.split(":", 1)[1].strip() for text in lines if text.startswith("model name")]
    return names[0] if names else platform.processor() or "unknown processor"
