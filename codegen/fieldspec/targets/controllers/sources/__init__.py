"""Blocks whose source is Structured Text with slots. See docs/architecture.md."""
