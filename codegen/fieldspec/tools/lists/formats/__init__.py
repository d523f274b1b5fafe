"""Lists in the formats of other programs, each as the rows of a list."""
