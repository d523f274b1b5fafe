"""The command line: parses the arguments and runs a verb. Each verb is a module of `command.verbs`.

Exit codes: 0 success, 1 findings, 2 wrong use or unreadable input, 141 if the reader of the output stopped early.
"""

from __future__ import annotations

import argparse
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from fieldspec import __version__
from fieldspec.command.console import streams
from fieldspec.command.console.usage import WRONG_USE, UsageError
from fieldspec.command.console.verb_parsers import DEVICE_HELP, ImportedNames, LineParser, Suggested, VerbParser

TYPE_CHECKING = False  # as of `typing`, which takes longer to import than the help to print
if TYPE_CHECKING:
    from typing import NoReturn

INTERRUPTED = 130


def parser() -> argparse.ArgumentParser:
    """All verbs with their arguments."""
    top = _parser()
    for action in top._actions:
        for verb in action.choices.values() if isinstance(action.choices, dict) else ():
            verb.settle()
    return top


def _parser() -> argparse.ArgumentParser:
    """All verbs, without their arguments."""
    argparse._ = str  # type: ignore[attr-defined]  # help is English; gettext would look for other words of each text
    top = LineParser(
        prog="fieldspec",
        description="Checks protocol specs, builds code and documentation from them, and explains frames.",
    )
    top.add_argument("--version", action="version", version=f"fieldspec {__version__}")
    verbs = top.add_subparsers(dest="verb", metavar="VERB", required=True, parser_class=VerbParser)

    def verb(name: str, help: str, compiled: bool = False) -> VerbParser:
        inner: VerbParser = verbs.add_parser(name, help=help, description=help[:1].upper() + help[1:] + ".")
        inner.add_argument(
            "--specs", metavar="DIR", help="the folder with the specs (default: specs, here or in a parent folder)"
        )
        if compiled:
            inner.add_argument("--no-cache", action="store_true", help="compile the device again and cache nothing")
        return inner

    build = verb("build", "generate code and documentation")
    build.add_argument("devices", nargs="*", default=[], metavar="DEVICE[@VERSION]", help="the devices (default: all)")
    build.late_help = ("fieldspec.command.packages.plugin_loading", "outputs_help")
    to_help = "the outputs to write, separated by commas (default: from fieldspec.yaml, or all)"
    build.add_argument("--to", metavar="NAME,...", help=to_help)
    out_help = "the folder to write to (default: from fieldspec.yaml, or generated)"
    build.add_argument("--out", metavar="DIR", help=out_help)
    build.add_argument("--check", action="store_true", help="write nothing; list the files that are out of date")
    build.add_argument("--no-cache", action="store_true", help="rebuild everything and cache nothing")
    build.add_argument("--watch", action="store_true", help="rebuild whenever a spec is saved, until interrupted")

    docs = verb("docs", "build the documentation, serve it on this machine, and open it in a browser")
    docs.add_argument(
        "--out", metavar="DIR", help="the folder to write to (default: from fieldspec.yaml, or generated)"
    )
    docs.add_argument(
        "--port", type=int, default=8080, metavar="NUMBER", help="the port (default: 8080; 0: any free port)"
    )
    docs.add_argument("--no-open", action="store_true", help="do not open a browser")

    check = verb("check", "check the specs")
    check.add_argument("devices", nargs="*", default=[], metavar="DEVICE", help="the devices (default: all)")
    check.add_argument(
        "--format",
        choices=("text", "json", "sarif", "github", "junit"),
        default="text",
        help="the output format (default: text)",
    )

    show = verb("show", "show a device or one of its items", compiled=True)
    show.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    item = "a name, a name as printed in the manual, an address or a code"
    show.add_argument("item", nargs="?", metavar="ITEM", help=item)

    placed = verb("layout", "show where a PLC places the members of a record in memory", compiled=True)
    placed.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    placed.add_argument("record", metavar="RECORD", help="a record, a table, or a message (by name or number)")
    memories = ImportedNames("fieldspec.targets.controllers.layout.memory", "MEMORIES")
    placed.add_argument("--target", required=True, choices=memories, metavar="NAME", help="one of %(choices)s")

    facts = verb("facts", "list all facts of a device", compiled=True)
    facts.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    facts.add_argument("--format", choices=("csv", "json"), default="csv", help="the output format (default: csv)")

    def add_frame_options(inner: VerbParser, direction: str, message: str) -> None:
        """The options that say how a frame is sent."""
        inner.set_defaults(words=[])
        inner.late_help = ("fieldspec.command.frames.frame_options", "device_help")
        inner.add_argument("--link", help="the link on which the frame is sent")
        inner.add_argument("--direction", choices=Suggested(("request", "response")), metavar="NAME", help=direction)
        inner.add_argument("--message", metavar="NAME", help=message)
        inner.epilog = (
            "A message has a name or a number. Where a link has its own word for messages, --WORD NAME is the same "
            "as --message NAME. Put the device before --help to see its words."
        )

    direction_names = "request, response, or the names that the link has for them"
    decode = verb("decode", "explain a frame or a log of frames, byte by byte", compiled=True)
    decode.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    frames = "the bytes in hexadecimal (default, or -: lines of standard input); with --to: captures, logs, folders"
    decode.add_argument("frame", nargs="*", default=[], metavar="HEX|-|FILE", help=frames)
    add_frame_options(decode, direction_names, "the message, if the frame does not identify it")
    decode.add_argument("--request", metavar="HEX", help="the request that the response answers")
    decode.add_argument("--format", choices=("text", "json"), default="text", help="the output format (default: text)")
    strict = "also exit with 1 for doubtful values, which the manual does not list but no decoder rejects"
    decode.add_argument("--strict", action="store_true", help=strict)
    all_errata = "also print errata about other links, and about the message and the link as a whole"
    decode.add_argument("--errata", action="store_true", help=all_errata)
    to = "decode captures and logs in bulk, into tables of frames and values"
    decode.add_argument("--to", choices=("parquet", "csv", "jsonl", "arrow"), help=to)
    out_help = "with --to: the folder for the tables; a repeated run continues where the last run stopped"
    decode.add_argument("--out", metavar="FOLDER", help=out_help)
    decode.add_argument("--port", metavar="NUMBERS", help="with --to: TCP and UDP ports of the devices, such as 502")
    decode.add_argument("--units", metavar="NUMBERS", help="with --to: only these unit addresses, such as 1,3-5")
    rows = "with --to: the number of frames per file (default: 1000000)"
    decode.add_argument("--part-frames", type=int, metavar="NUMBER", help=rows)

    encode = verb("encode", "encode the frame of a message", compiled=True)
    encode.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    encode.add_argument(
        "assignments",
        nargs="*",
        default=[],
        metavar="MESSAGE NAME=VALUE",
        help="a message, or `write` with registers or parameters; a value is a raw value, a quantity such as 20.00mm "
        "(without a unit: 2.0, with a decimal point), or the name of an enum member or bit; bits are "
        "status=on,mode=auto or status.mode=auto; a list is 1,2,3, an empty list points=[], a member point.x=1, a "
        "member of a record in a list points.0.x=1 or points[0].x=1",
    )
    add_frame_options(encode, f"{direction_names} (default: request)", "the message, instead of MESSAGE")
    encode.add_argument(
        "--format", choices=("text", "hex", "json"), default="text", help="the output format (default: text)"
    )

    forms = ("csv", "xlsx", "json")
    export = verb("export", "export the registers and parameters of a device as a list", compiled=True)
    export.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    export.add_argument("--to", choices=forms, default="csv", help="the output format (default: csv)")
    export.add_argument("--messages", action="store_true", help="also export the fields of messages")
    export.add_argument("--out", metavar="FILE", help="the file to write (default: standard output)")

    def list_options(inner: argparse.ArgumentParser) -> None:
        """The options that say how a list is read."""
        inner.add_argument("--encoding", metavar="NAME", help="the encoding of the text, such as gbk, big5 or utf-16")
        inner.add_argument(
            "--sheet", metavar="NAME", help="the sheet of a workbook (default: the sheet with most columns of a list)"
        )
        column_help = "a heading, a letter or a number (default: guessed from the headings)"
        inner.add_argument("--address", metavar="COLUMN", help=f"the column with the addresses: {column_help}")
        for role in ("name", "words", "type", "access", "space"):
            inner.add_argument(f"--{role}", metavar="COLUMN", help=f"the column with the {role}")
        bases = "the notation of addresses; 4xxxx: 40001 is address 0"
        inner.add_argument("--base", choices=("hex", "decimal", "4xxxx"), help=bases)
        roles = "the column of any role, such as scale=F; repeat it for further columns"
        inner.add_argument("--column", action="append", metavar="ROLE=COLUMN", help=roles)
        inner.add_argument("--decimal", choices=("comma", "point"), help="the decimal separator")
        gains = "how to apply the factors of the list: quantity = raw value \u00d7 factor, or raw value ÷ factor"
        inner.add_argument("--gain", choices=("multiply", "divide"), help=gains)
        inner.add_argument(
            "--bounds",
            choices=("counts", "unit"),
            help="whether bounds and defaults are raw values (counts) or quantities (unit)",
        )
        inner.add_argument("--length", choices=("words", "bytes", "bits"), help="the unit of lengths")
        inner.add_argument("--address-unit", choices=("words", "bytes"), help="the unit of addresses")
        orders = "the byte order of two words, if the list does not state it"
        inner.add_argument("--order", choices=("ABCD", "CDAB", "BADC", "DCBA"), help=orders)
        inner.add_argument("--node", metavar="NAME", help="the node of the device in a CAN database")
        higher = "the difference between addresses in the list and on the wire: 1 if the list counts from 1"
        inner.add_argument("--offset", type=int, metavar="NUMBER", help=higher)

    compare = verb("compare", "compare a device with a register list from another source", compiled=True)
    compare.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    kinds = "CSV, XLSX, JSON, EDS, DBC, YAML, HTML, or a table with tabs or bars (-: standard input)"
    compare.add_argument("file", metavar="FILE", help=kinds)
    list_options(compare)
    compare.add_argument("--ignore", metavar="WHAT,...", help="the keys to ignore, such as name or unit")
    compare.add_argument(
        "--format", choices=("text", "json", "csv"), default="text", help="the output format (default: text)"
    )

    into = verb("import", "write a first spec of a device from a register list, marked as unverified")
    into.add_argument("file", metavar="FILE", help=kinds)
    target = "the file to write, DEVICE/device.yaml (-: standard output)"
    into.add_argument("--to", metavar="YAML", required=True, help=target)
    list_options(into)
    frames = "the protocol that carries the registers, or none (default: the only protocol that reads words)"
    into.add_argument("--protocol", metavar="NAME", help=frames)
    into.add_argument("--strict", action="store_true", help="reject a list with unused content")
    rows = "print the first rows as interpreted, by default 10"
    into.add_argument("--preview", type=int, nargs="?", const=10, metavar="NUMBER", help=rows)
    into.set_defaults(verb="importing")

    audit = verb("audit", "report the evidence for the spec of a device, and its gaps")
    audit.late_arguments = ("fieldspec.command.audit_inputs.audit_options", "add_audit")

    for name, help in (
        ("simulate", "simulate a device from its spec"),
        ("live", "read, write, watch, scan, back up or restore a device"),
        ("scan", "find the addresses that respond, and compare them with all versions"),
        ("redact", "copy captures, dumps and scans of a unit with identifying data removed"),
        ("mcp", "run a Model Context Protocol (MCP) server for decode, show, audit and reads"),
    ):
        verb(name, help).late_arguments = ("fieldspec.command.console.device_options", f"add_{name}")
    for name, help in (
        ("versions", "list the versions of a device and the facts that depend on them"),
        ("resolve", "print the complete spec of a version, with the file and line of each value"),
    ):
        verb(name, help).add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)

    blame = verb("blame", "show which file and line set each attribute of a fact")
    blame.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    blame.add_argument("path", metavar="FACT", help="the path of the fact, such as registers/NAME")

    new = verb("new", "create the first file of a device, the file of a version, or the schema for editors")
    new.add_argument(
        "kind", choices=("device", "version", "schema"), metavar="{device,version,schema}", help="the file to create"
    )
    new.add_argument("name", nargs="?", metavar="DEVICE", help="the device, by the name of its folder")
    new.add_argument("version", nargs="?", metavar="VERSION", help="the version to create")
    new.add_argument("--based-on", metavar="VERSION", help="the base of the new version (default: the newest version)")
    new.add_argument("--line", help="the version line (default: the line of the base)")
    kinds = "packet, text, escapes, status, bytes, can or telegram"
    new.add_argument("--protocol", help=f"a new device's protocol or, if it follows none, its kind of frame: {kinds}")

    matrix = verb("matrix", "compare the facts of all versions")
    matrix.add_argument("device", metavar="DEVICE", help="the device")
    matrix.add_argument("--all", action="store_true", help="include facts that are the same in all versions")
    matrix.add_argument(
        "--format", choices=("text", "csv", "html"), default="text", help="the output format (default: text)"
    )

    lsp = verb("lsp", "run a Language Server Protocol (LSP) server: findings, completion and hover texts in an editor")
    lsp.add_argument("--manuals", metavar="DIR", help="the folder of the manuals (default: manuals, next to the specs)")

    rule = verbs.add_parser("rule", help="explain a rule")
    rule.add_argument("code", nargs="?", metavar="CODE", help="the rule (default: list all)")

    diff = verb("diff", "list the differences between two versions and whom they affect")
    side = "DEVICE@VERSION, a folder of specs, or a git revision such as HEAD~3 or main:specs"
    diff.add_argument("old", metavar="A", help=side)
    diff.add_argument("new", metavar="B", help="as for A")
    diff.add_argument(
        "--format",
        choices=("text", "json", "markdown", "html", "sarif", "github"),
        default="text",
        help="the output format (default: text)",
    )
    fails = "exit with 1 on such a change; breaking: the classes wire and source"
    diff.add_argument("--fail-on", choices=("breaking", "behaviour", "any"), help=fails)

    verb("devices", "list the devices and their versions")

    completion = verbs.add_parser("completion", help="print the completion script of a shell")
    completion.add_argument("shell", choices=("bash", "zsh", "tcsh"), help="the shell")
    completion.set_defaults(parser=parser)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one verb and returns its exit code."""
    collecting = gc.isenabled()
    gc.disable()  # a run is short, and its trees are never garbage
    streams.prepare()
    code: int | None = None
    try:
        try:
            parsed = _parser().parse_args(arguments)
            code = int(import_module(f"fieldspec.command.verbs.{parsed.verb}").run(parsed))
            sys.stdout.flush()
        except UsageError as error:
            code = WRONG_USE
            streams.print_error(error)
        except KeyboardInterrupt:
            code = INTERRUPTED
        return code
    except OSError as error:
        return streams.unwritten(error, code)
    finally:
        if collecting:
            gc.enable()


def command() -> NoReturn:
    """The entry point of a shell. Ends the process at once: freeing the objects of a run would take
    longer than a verb.
    """
    os._exit(streams.finished(main()))


if __name__ == "__main__":
    command()
