"""Sessions, files, recordings and settings, as the window keeps them."""
