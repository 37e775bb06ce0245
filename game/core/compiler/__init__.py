"""From the table of a rule to machine code that moves the blocks of many words."""
