"""The hiss of flowing sand: louder the more of it moves, and heard from where it moves."""

import math

import numpy as np

from game.play.window.audio import RATE, sound_of
from game.world.sand.measure import MotionMeter

LOOK_S = 0.1  # from one look at the sand to the next
GLIDE_S = 0.15  # how fast loudness and side follow
LOUDEST = 10  # log2 of the number of moving grains from which on it gets no louder
CONTRAST = 1.5  # above 1, a trickle is quieter beside a flood
WIDTH = 0.8  # of full stereo
SILENT = 0.002
LOOP_S = 4.0
RMS = 0.1  # of the loop, where full scale is 1
TURBULENCE = 0.25  # standard deviation of its loudness, as a part of it
SEED = 11
SILENCE = "No sound card was found, so the sand stays silent."


class Hiss:
    """Follows the sand, if sound is chosen and there is a sound card."""

    def __init__(self, sessions, settings, audio, background, notices):
        self._sessions, self._settings, self._audio = sessions, settings, audio
        self._background, self._notices = background, notices
        self._motion = MotionMeter()
        self._sound = self._channel = None
        self._making = False
        self._chosen = False  # sound was chosen, and whether there is a card is not known yet
        self._looked_s = self._then_s = 0.0
        self._goal = 0.0, 0.0  # loudness in [0, 1] and side in [-1, 1]
        self.level = self.side = 0.0  # on the way there

    def toggle(self):
        """Turn the sound on or off."""
        settings, audio = self._settings, self._audio
        settings["sound"] = not settings["sound"]
        self._chosen = settings["sound"] and audio.trouble is None
        if settings["sound"] and audio.trouble is not None:
            self._notices.say(SILENCE)
        else:
            self._notices.say("Sound is on" if settings["sound"] else "Sound is off")

    def update(self, now_s):
        """Let the hiss follow the sand."""
        wanted = self._settings["sound"]
        if not wanted and self._channel is None:
            return
        if wanted and self._sound is None:
            self._prepare()
            return
        if now_s - self._looked_s >= LOOK_S:
            self._looked_s = now_s
            self._goal = _heard(*self._motion.look(self._sessions.now.world)) if wanted else (0.0, self.side)
        self._glide(min(1.0, (now_s - self._then_s) / GLIDE_S))
        self._then_s = now_s
        self._play(wanted)

    def _prepare(self):
        """Open the sound card and make the loop, beside the frames."""
        audio = self._audio
        audio.open()
        if self._chosen and audio.trouble is not None:
            self._chosen = False
            self._notices.say(SILENCE)
        if audio.ready and not self._making:
            self._making = True
            self._background.do(loop, self._take)

    def _take(self, wave):
        self._making = False
        if self._audio.ready:  # it may have been closed while the loop was made
            self._sound = sound_of(wave)

    def _glide(self, part):
        self.level += part * (self._goal[0] - self.level)
        self.side += part * (self._goal[1] - self.side)

    def _play(self, wanted):
        if self._channel is None:
            self._channel = self._sound.play(loops=-1)
        if self._channel is None:  # all channels are taken
            return
        loudness, angle = self.level * self._settings["volume"], (1 + WIDTH * self.side) * math.pi / 4
        self._channel.set_volume(loudness * math.cos(angle), loudness * math.sin(angle))
        if not wanted and self.level < SILENT:
            self._channel.stop()
            self._channel = None


def _heard(grains, side):
    """Return the loudness in [0, 1] of so many moving grains, and their side."""
    return min(1.0, math.log2(1 + grains) / LOUDEST) ** CONTRAST, side


def loop():
    """Return (samples, 2) floats: noise as of dry sand on glass, whose end meets its beginning."""
    count = round(LOOP_S * RATE)
    frequencies = np.fft.rfftfreq(count, 1 / RATE)
    rise, fall = (frequencies / 2500) ** 1.5, (frequencies / 9000) ** 4
    shape = rise / (1 + rise) / (1 + fall)
    rng = np.random.default_rng(SEED)
    noise = np.stack([_noise(shape, rng, count) for _ in range(2)], axis=1)
    slow = (frequencies > 0) & (frequencies < 12)
    wavering = 1 + TURBULENCE * np.clip(_noise(slow.astype(float), rng, count), -3, 3)
    wave = noise * wavering[:, None]
    return wave * (RMS / np.sqrt(np.mean(wave**2)))


def _noise(spectrum, rng, count):
    """Return periodic noise of a spectrum, with a root mean square of 1."""
    turned = spectrum * np.exp(2j * np.pi * rng.random(len(spectrum)))
    wave = np.fft.irfft(turned, count)
    return wave / np.sqrt(np.mean(wave**2))
