"""The verbs of the command line, one file each. Nothing else reads or writes files, or prints."""
