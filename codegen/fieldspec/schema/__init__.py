"""The language: `spec.schema.json` is the one table of legal keys."""
