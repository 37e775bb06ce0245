"""What the toy is: rule, world, scenes and actions; no window, no bit tricks."""
