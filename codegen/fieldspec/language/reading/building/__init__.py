"""Node tree to model, one kind of object a file; the tree is typed and fits the schema."""
