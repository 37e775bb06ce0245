"""The process: how it ends when a signal asks for it, and what it does where its streams cannot take what is said."""

import os
import signal
import sys
import threading
from contextlib import contextmanager, suppress

LONGEST_S = 2.0  # until a process ends that was asked to, whatever it is at
ASKING = "SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK"  # Ctrl+C, kill, a terminal that is closed, Ctrl+Break on Windows


class EndedError(BaseException):
    """A signal has asked the process to end."""


class _Ending:
    asked = None  # the signal that asked for the end, once one has
    noted = False  # somebody looks for it, so that it need not be raised


def run(command):
    """Call `command()` and return the exit status: what it returns, 2 where it cannot print, or 128 + a signal."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError):
            stream.reconfigure(errors="replace")
    with _listening():
        try:
            status = _printed(command)
        except (EndedError, KeyboardInterrupt):
            status = 130
    return _status(status)


def is_asked_to_end():
    """Return whether a signal has asked for the end."""
    return _Ending.asked is not None


@contextmanager
def noting_signals():
    """Let a signal only be noted meanwhile: who calls this asks `is_asked_to_end` often."""
    _Ending.noted = True
    try:
        yield
    finally:
        _Ending.noted = False


@contextmanager
def ending_within(seconds, at_last):
    """Let the process end even if the body takes longer than that; call `at_last()` before."""

    def end():
        at_last()
        os._exit(_status(0))

    timer = threading.Timer(seconds, end)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def leave_threads(status):
    """Return `status`, or end with it at once where threads are at work: nobody waits for what they find."""
    if any(thread.daemon for thread in threading.enumerate()):
        _flush()
        os._exit(_status(status))
    return status


def _status(status):
    return status if _Ending.asked is None else 128 + _Ending.asked


def _printed(command):
    try:
        try:
            return command()
        finally:
            _flush()
    except BrokenPipeError:  # who was to read it has gone
        _discard()
        return 0
    except OSError as error:
        what = error.filename or "the output cannot be written"
        with suppress(OSError, AttributeError):
            sys.stderr.write(f"sandglass: {what}: {(error.strerror or str(error)).lower()}\n")
        _discard()
        return 2


def _flush():
    for stream in (sys.stdout, sys.stderr):
        if stream:
            stream.flush()


def _discard():
    """Let go of what could not be printed: Python would try it again at the end, and complain."""
    null = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, AttributeError):
            with suppress(OSError, AttributeError, ValueError):
                os.dup2(null, stream.fileno())
    os.close(null)


@contextmanager
def _listening():
    """Hear the signals meanwhile, but those that are ignored, as under nohup."""
    numbers = [getattr(signal, name) for name in ASKING if hasattr(signal, name)]
    before = {number: signal.getsignal(number) for number in numbers}
    heard = [number for number in numbers if before[number] != signal.SIG_IGN]
    hook, sys.unraisablehook = sys.unraisablehook, _unraisable
    for number in heard:
        signal.signal(number, _hear)
    try:
        yield
    finally:
        for number in heard:
            signal.signal(number, before[number] if _Ending.asked is None else signal.SIG_IGN)
        sys.unraisablehook = hook


def _hear(number, frame):
    """Raise EndedError for the first signal, unless it is only to be noted; end at once where it comes again.

    Some libraries catch whatever is raised while they are imported or compile: the process ends all the same.
    """
    again, _Ending.asked = _Ending.asked is not None, _Ending.asked or number
    if _Ending.noted:
        return
    if again:
        os._exit(128 + _Ending.asked)
    last = threading.Timer(LONGEST_S, os._exit, [128 + _Ending.asked])
    last.daemon = True
    last.start()
    raise EndedError


def _unraisable(what):
    """End at once where EndedError came up in what cannot raise, such as a finalizer."""
    if isinstance(what.exc_value, EndedError):
        os._exit(128 + _Ending.asked)
    sys.__unraisablehook__(what)
