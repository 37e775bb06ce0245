"""The laws the toy keeps, tested floor by floor; the folders mirror game/."""
