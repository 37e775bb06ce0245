"""Audio: the one place that opens the sound card, when the first sound is wanted. Without a card all is silent."""

import contextlib
import os
import sys
import time

import numpy as np
import pygame

RATE = 44_100  # samples a second
BUFFER = 1024  # samples: with fewer it stutters on a busy machine, with more it lags behind the sand
LATE_S = 2.0  # a sound that had to wait longer for the card is not played any more


class Audio:
    """Sounds as (samples, 2) float arrays in [-1, 1], left and right, played when the card is there."""

    def __init__(self, background):
        self._background = background
        self.asked = False  # a sound was wanted
        self.ready = False
        self.trouble = None  # why there is no sound, or None
        self._waiting = []  # (when asked for, wave, volume)

    def open(self):
        """Open the sound card beside the frames, if that was not tried before; `ready` tells when it is there."""
        if not self.asked:
            self.asked = True
            self._background.do(_opened, self._take)

    def play(self, wave, volume=1.0):
        """Play a sound once, or nothing where there is no card."""
        self.open()
        if self.ready:
            sound_of(wave, volume).play()
        elif self.trouble is None:
            self._waiting.append((time.monotonic(), wave, volume))

    def close(self):
        """Close the sound card, if it was opened or is being opened."""
        if self.asked:
            self.ready = False
            pygame.mixer.quit()

    def _take(self, trouble):
        self.trouble, self.ready = trouble, trouble is None
        waiting, self._waiting = self._waiting, []
        for since_s, wave, volume in waiting:
            if time.monotonic() - since_s < LATE_S:
                self.play(wave, volume)


def sound_of(wave, volume=1.0):
    """Return the pygame Sound of a (samples, 2) float array; the mixer must be ready."""
    samples = np.clip(np.asarray(wave) * (volume * 32767), -32768, 32767).astype("<i2")
    return pygame.mixer.Sound(buffer=samples.tobytes())


def _opened():
    """Open the card and return None, or the reason why that failed."""
    try:
        with _quiet():
            pygame.mixer.init(RATE, -16, 2, BUFFER, allowedchanges=0)
    except pygame.error as error:
        return str(error)
    return None


@contextlib.contextmanager
def _quiet():
    """Keep stderr quiet meanwhile: on Linux the sound library prints a page there where the card is missing."""
    if sys.platform != "linux":
        yield
        return
    try:
        kept = os.dup(2)
    except OSError:  # started without a terminal
        yield
        return
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(silent)
