"""The JavaScript output: an ES module with types for each version of a device."""
