"""The differences of two versions of a device, and whom they affect.

Each rule is a function in `rules/`, named after what happened. `table` lists them.
"""
