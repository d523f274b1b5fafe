"""The Structured Text output."""
