"""Random devices that make sense, and the comparison of all codecs on them."""
