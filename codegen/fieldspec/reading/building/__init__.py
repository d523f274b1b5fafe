"""Node tree -> model. One noun a file; the tree is typed and fits the schema."""
