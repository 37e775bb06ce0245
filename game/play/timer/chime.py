"""The chime: a small bell that rings when the time is over."""

import numpy as np

from game.play.window.audio import RATE

STRUCK_S = 0.0, 0.55  # two strokes
NOTES_HZ = 523.25, 659.25  # c'' and e''
# A bell's partials, softened: (multiple of the note, loudness, seconds until it is e times softer)
PARTIALS = (0.5, 0.25, 1.6), (1.0, 1.0, 1.1), (2.0, 0.35, 0.6), (2.76, 0.22, 0.35), (5.4, 0.08, 0.12)
LENGTH_S = 3.5
ATTACK_S = 0.006  # without it a stroke begins with a click
FADE_S = 0.3
LOUDEST = 0.5  # of what the card takes


class Chime:
    """Rings if that is set; its samples are made beside the frames."""

    def __init__(self, settings, audio, background):
        self._settings, self._audio, self._background = settings, audio, background
        self._samples = None

    def prepare(self):
        """Make the samples, unless they have been made."""
        if self._samples is None:
            self._background.do(chime_samples, self._keep)

    def ring(self):
        """Ring once."""
        if self._settings["chime"] and self._samples is not None:
            self._audio.play(self._samples, self._settings["volume"])

    def _keep(self, samples):
        self._samples = samples


def chime_samples():
    """Return the samples of the chime: (samples, 2) float32, left and right."""
    wave = np.zeros(round(LENGTH_S * RATE))
    for start_s, note_hz in zip(STRUCK_S, NOTES_HZ, strict=True):
        first = round(start_s * RATE)
        wave[first:] += _stroke(note_hz, len(wave) - first)
    fade = round(FADE_S * RATE)
    wave[-fade:] *= np.linspace(1.0, 0.0, fade)
    wave *= LOUDEST / np.abs(wave).max()
    return np.repeat(wave[:, None], 2, axis=1).astype(np.float32)


def _stroke(note_hz, samples):
    """Return one stroke of the bell, (samples,) float64."""
    seconds = np.arange(samples) / RATE
    tones = (
        loud * np.exp(-seconds / decay_s) * np.sin(2 * np.pi * multiple * note_hz * seconds)
        for multiple, loud, decay_s in PARTIALS
    )
    return sum(tones) * np.minimum(seconds / ATTACK_S, 1.0)
