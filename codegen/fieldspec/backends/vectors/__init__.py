"""The example frames of a device as JSON, for codecs in any language. docs/vectors.md describes the format."""
