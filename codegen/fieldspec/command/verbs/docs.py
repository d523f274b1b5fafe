"""`fieldspec docs`: builds the documentation, serves it on this machine, and opens it in a browser."""

from __future__ import annotations

import argparse
import sys
import webbrowser
from pathlib import Path

from fieldspec.command.console.streams import print_line
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.placement import JournalError, inside
from fieldspec.command.sources import spec_files
from fieldspec.command.sources.project_choices import project_choices
from fieldspec.command.verbs.build import build
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.carriers.pages import PageServer

OUTPUT = "docs"
PORTS = range(1 << 16)


def run(arguments: argparse.Namespace) -> int:
    """Builds and serves until interrupted. Exit code 1 for findings, with nothing served. Raises UsageError."""
    if arguments.port not in PORTS:
        raise UsageError(f"--port {arguments.port} is not a port; use 0 to {PORTS[-1]}, 0 for one that is free")
    output_folder = arguments.out or project_choices(spec_files.folder(arguments.specs)).folder("")
    options = argparse.Namespace(
        specs=arguments.specs, out=output_folder, devices=(), to=OUTPUT, check=False, no_cache=False, watch=False
    )
    if code := build(options):
        return code
    folder = Path(output_folder) / OUTPUT
    if not (folder / "index.html").is_file():
        raise UsageError("there is no device, so there are no pages")
    try:
        inside(folder.parent, [f"{OUTPUT}/index.html"])
        server = PageServer(folder, arguments.port)
    except JournalError as error:
        raise UsageError(str(error)) from None
    except CarrierError as error:
        raise UsageError(f"{error}; choose another one with --port, or 0 for one that is free") from None
    try:
        print_line(f"serving {folder} at {server.address}, until interrupted")
        sys.stdout.flush()
        if not arguments.no_open and not webbrowser.open(server.address):
            print_line("there is no browser to open it")
            sys.stdout.flush()
        server.serve()
    except KeyboardInterrupt:
        return 0
    finally:
        server.close()
    return 0
