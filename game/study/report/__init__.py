"""How a study is written down."""
