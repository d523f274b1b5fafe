"""`fieldspec completion`: the completion script of a shell."""

from __future__ import annotations

import argparse

from fieldspec.commands.device_help import suggest


def run(arguments: argparse.Namespace) -> int:
    """Prints the script; source it, or save it where the shell looks for completions."""
    import shtab

    parser = arguments.parser()
    suggest(parser)
    print(shtab.complete(parser, shell=arguments.shell))
    return 0
