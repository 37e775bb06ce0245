"""A rule as a C header, for other engines."""
