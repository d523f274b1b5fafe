"""Python codecs: a package without dependencies, one module for each version of a device."""
