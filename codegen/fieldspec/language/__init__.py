"""What a spec says: the schema, its reading, the model that it becomes, and what is judged and compared there."""
