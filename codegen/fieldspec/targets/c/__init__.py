"""C headers: one for each device and version, with a program that tests it."""
