"""The documentation of a device: one page a version, as HTML and as Markdown, from the same document."""
