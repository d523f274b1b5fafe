"""Lists of registers as people keep them in files: read whatever their columns are, written, compared with a device."""
