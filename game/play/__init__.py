"""The window: the only part that knows pygame."""

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # what we print is ours
os.environ.setdefault("SDL_VIDEO_X11_WMCLASS", "sandglass")  # by which a desktop finds the icon
