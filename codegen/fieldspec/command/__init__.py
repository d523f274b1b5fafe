"""The command line: the compiler as a line of functions, what verbs print, and the verbs. Only verbs and what they
share read or write files, or print.
"""
