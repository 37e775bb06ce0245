"""The model: cells, rule, motion and what is measured of them. It knows neither files nor threads."""
