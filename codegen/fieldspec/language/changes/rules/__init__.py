"""The rules of changes: each is a function, and its docstring is its documentation."""
