"""The spec language: the schema, reading, the model, and the checks and comparisons of the model."""
