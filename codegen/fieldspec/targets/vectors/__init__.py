"""Example frames and reads of an idle device as JSON, for codecs in any language; docs/vectors.md describes them."""
