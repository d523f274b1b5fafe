"""`python -m fieldspec`"""

from fieldspec.cli import command

command()
