"""Many runs of one world at once."""
