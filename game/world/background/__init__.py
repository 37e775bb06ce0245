"""What is computed beside the window: forecasts and compiled kernels."""
