"""`hdl_registers_header.py TOML OUT [html]`: the C header, or the page, that hdl-registers makes of registers."""

from __future__ import annotations

import sys
from pathlib import Path

from hdl_registers.parser.toml import from_toml


def main(source: str, out: str, form: str = "c") -> None:
    """Makes it."""
    if form == "html":
        from hdl_registers.generator.html.page import HtmlPageGenerator as Generator
    else:
        from hdl_registers.generator.c.header import CHeaderGenerator as Generator
    Generator(from_toml("large", Path(source)), Path(out)).create()


if __name__ == "__main__":
    main(*sys.argv[1:])
