"""The command line. Arguments are parsed here; each verb is a module of `commands`, imported when it is called.

Exit codes: 0 fine, 1 findings, 2 wrong use or unreadable input.
"""

from __future__ import annotations

import argparse
import errno
import gc
import os
import re
import sys
from collections.abc import Sequence
from importlib import import_module
from io import TextIOWrapper

from fieldspec import __version__
from fieldspec.commands.usage import UsageError

TYPE_CHECKING = False  # as of `typing`, which takes longer to import than the help to print
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any, NoReturn

FINE, FINDINGS, WRONG_USE, INTERRUPTED = 0, 1, 2, 130


def _help(prog: str) -> argparse.HelpFormatter:
    """The form of help texts; argparse would import the whole of shutil to ask for the width."""
    try:
        width = int(os.environ.get("COLUMNS") or os.get_terminal_size().columns)
    except (ValueError, OSError):
        width = 80
    return argparse.HelpFormatter(prog, width=max(width - 2, 40))


class _Parser(argparse.ArgumentParser):
    """Says wrong use in one line, with where to read more."""

    def __init__(self, **options: Any) -> None:
        super().__init__(formatter_class=_help, **options)

    def error(self, message: str) -> None:  # type: ignore[override]
        raise UsageError(f"{message}; see: {self.prog} --help")


class _Word(argparse.Action):
    """An option that bears a word of the device. It is kept for the verb, which knows the device."""

    def __call__(self, parser: object, namespace: Any, values: Any, option: str | None = None) -> None:
        namespace.words = [*namespace.words, (option, values)]


class _Suggested(tuple[str, ...]):
    """What a shell offers for an option that takes other texts, too."""

    __slots__ = ()

    def __contains__(self, text: object) -> bool:
        return True


class _Names:
    """Names that are imported when they are listed. The verb itself refuses others."""

    def __init__(self, module: str, attribute: str) -> None:
        self._module, self._attribute = module, attribute

    def __contains__(self, text: object) -> bool:
        return True

    def __iter__(self) -> Iterator[str]:
        return iter(getattr(import_module(self._module), self._attribute))


class _Verb(_Parser):
    """The arguments of one verb; options may stand between the others. They wait until the verb is the one called.

    Where the verb has a default for `words`, options that it does not know are kept there.
    """

    late_help: tuple[str, str] | None = None
    """The module and function that write the end of the help, given the arguments; imported for help alone."""

    _mixing = False

    def __init__(self, **options: Any) -> None:
        self._waiting: list[tuple[tuple[str, ...], dict[str, Any]]] | None = []
        super().__init__(**options)

    def add_argument(self, *names: str, **options: Any) -> None:  # type: ignore[override]
        """Adds an argument, or notes it while they wait."""
        if self._waiting is None:
            super().add_argument(*names, **options)
        else:
            self._waiting.append((names, options))

    def settle(self) -> None:
        """Adds the arguments that wait."""
        waiting, self._waiting = self._waiting or [], None
        for names, options in waiting:
            self.add_argument(*names, **options)

    def _learn(self, arguments: Sequence[str]) -> None:
        for argument in arguments:
            if argument == "--":
                return
            option = argument.partition("=")[0]
            known = any(text.startswith(option) for text in self._option_string_actions)
            if re.fullmatch("--[A-Za-z][A-Za-z0-9_-]*", option) and not known:
                self.add_argument(option, action=_Word, nargs="?", dest="words", help=argparse.SUPPRESS)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        if self._mixing:
            return super().parse_known_args(args, namespace)
        self.settle()
        self._mixing = True
        if self.get_default("words") is not None:
            self._learn(args)
        if self.late_help and {"-h", "--help"} & {*args}:
            module, function = self.late_help
            self.epilog = getattr(import_module(module), function)(args) or self.epilog
        try:
            return self.parse_known_intermixed_args(args, namespace)
        finally:
            self._mixing = False


def parser() -> argparse.ArgumentParser:
    """All verbs with their arguments."""
    top = _parser()
    for action in top._actions:
        for verb in action.choices.values() if isinstance(action.choices, dict) else ():
            verb.settle()
    return top


def _parser() -> argparse.ArgumentParser:
    """All verbs, with arguments that wait."""
    argparse._ = str  # type: ignore[attr-defined]  # help is English; gettext would look for other words of each text
    top = _Parser(prog="fieldspec", description="Protocol specs to code: check, build, explain.")
    top.add_argument("--version", action="version", version=f"fieldspec {__version__}")
    verbs = top.add_subparsers(dest="verb", metavar="VERB", required=True, parser_class=_Verb)

    def verb(name: str, help: str, compiled: bool = False) -> _Verb:
        inner: _Verb = verbs.add_parser(name, help=help, description=help[:1].upper() + help[1:] + ".")
        inner.add_argument("--specs", metavar="DIR", help="the folder of the specs")
        if compiled:
            inner.add_argument(
                "--no-cache", action="store_true", help="compile the device anew, and keep nothing of it"
            )
        return inner

    build = verb("build", "write the outputs")
    build.add_argument("devices", nargs="*", metavar="DEVICE[@VERSION]", help="left out: all devices")
    build.late_help = ("fieldspec.commands.plugin_loading", "outputs_help")
    build.add_argument("--to", metavar="NAME,...", help="the outputs to write; left out: all")
    build.add_argument("--out", metavar="DIR", default="generated", help="the folder to write to (generated)")
    build.add_argument("--check", action="store_true", help="write nothing; tell which files are not fresh")
    build.add_argument(
        "--no-cache", action="store_true", help="make all outputs anew, whatever is fresh, and note nothing of it"
    )
    build.add_argument("--watch", action="store_true", help="build again whenever a spec is saved, until interrupted")

    check = verb("check", "find what is wrong with the specs")
    check.add_argument("devices", nargs="*", metavar="DEVICE", help="left out: all devices")
    check.add_argument("--format", choices=("text", "json", "sarif", "github", "junit"), default="text")

    show = verb("show", "show a device, or one item of it", compiled=True)
    show.add_argument("device", metavar="DEVICE[@VERSION]")
    show.add_argument("item", nargs="?", metavar="ITEM", help="a name, a printed name, an address or a code")

    placed = verb("layout", "tell where a controller has the members of a record in its memory", compiled=True)
    placed.add_argument("device", metavar="DEVICE[@VERSION]")
    placed.add_argument("record", metavar="RECORD", help="a record, a table, or a message by name or number")
    placed.add_argument(
        "--target",
        required=True,
        choices=_Names("fieldspec.plc.layout.memory", "MEMORIES"),
        metavar="NAME",
        help="one of %(choices)s",
    )

    facts = verb("facts", "list every fact of a device", compiled=True)
    facts.add_argument("device", metavar="DEVICE[@VERSION]")
    facts.add_argument("--format", choices=("csv", "json"), default="csv")

    def sent(inner: _Verb, direction: str, message: str) -> None:
        """The options that say how a frame is sent."""
        inner.set_defaults(words=[])
        inner.late_help = ("fieldspec.commands.frame_options", "device_help")
        inner.add_argument("--link", help="the link that the frame is sent on")
        inner.add_argument("--direction", choices=_Suggested(("request", "response")), metavar="NAME", help=direction)
        inner.add_argument("--message", metavar="NAME", help=message)
        inner.epilog = (
            "A message may have a number beside its name. Where a link has a word of its own for messages, --WORD NAME "
            "is as --message NAME. With a device before it, --help tells which words there are."
        )

    way = "request, response, or what the link calls them"
    decode = verb("decode", "explain a frame, or a log of frames, byte by byte", compiled=True)
    decode.add_argument("device", metavar="DEVICE[@VERSION]")
    frames = "the bytes; - or nothing: lines of standard input"
    decode.add_argument("frame", nargs="*", default=[], metavar="HEX|-", help=frames)
    sent(decode, way, "the message by name or number, where the frame does not say it")
    decode.add_argument("--request", metavar="HEX", help="the request that a response answers")
    decode.add_argument("--format", choices=("text", "json"), default="text")

    encode = verb("encode", "write the frame of a message", compiled=True)
    encode.add_argument("device", metavar="DEVICE[@VERSION]")
    encode.add_argument("given", nargs="*", metavar="MESSAGE NAME=VALUE", help="counts, 20.00mm, names of members")
    sent(encode, f"{way}; left out: request", "the message by name or number, instead of MESSAGE")
    encode.add_argument("--format", choices=("text", "hex", "json"), default="text")

    forms = ("csv", "xlsx", "json")
    export = verb("export", "write the registers and parameters of a device as a list", compiled=True)
    export.add_argument("device", metavar="DEVICE[@VERSION]")
    export.add_argument("--to", choices=forms, default="csv")
    export.add_argument("--out", metavar="FILE", help="the file to write; left out: the output")

    def list_options(inner: argparse.ArgumentParser) -> None:
        """The options that say how a list is read."""
        inner.add_argument("--encoding", metavar="NAME", help="how the text is encoded, such as gbk, big5 or utf-16")
        inner.add_argument("--sheet", metavar="NAME", help="the sheet of a workbook; left out: the first with cells")
        where = "a heading, a letter or a number; left out: guessed from the headings"
        inner.add_argument("--address", metavar="COLUMN", help=f"the column of the addresses: {where}")
        for role in ("name", "words", "type", "access", "space"):
            inner.add_argument(f"--{role}", metavar="COLUMN", help="likewise")
        bases = "how addresses are written; 4xxxx: 40001 is address 0"
        inner.add_argument("--base", choices=("hex", "decimal", "4xxxx"), help=bases)
        higher = "what the list's addresses are higher by than on the wire: 1 where they count from 1"
        inner.add_argument("--offset", type=int, metavar="NUMBER", help=higher)

    compare = verb("compare", "compare a device with a register list that someone else has made", compiled=True)
    compare.add_argument("device", metavar="DEVICE[@VERSION]")
    kinds = "CSV, XLSX, JSON, or a table with tabs or bars; -: standard input"
    compare.add_argument("file", metavar="FILE", help=kinds)
    list_options(compare)
    compare.add_argument("--ignore", metavar="WHAT,...", help="what is not compared, such as name or unit")
    compare.add_argument("--format", choices=("text", "json", "csv"), default="text")

    into = verb("import", "write the first file of a device from a register list, with nothing verified")
    into.add_argument("file", metavar="FILE", help=kinds)
    target = "the file to write, DEVICE/device.yaml; -: the output"
    into.add_argument("--to", metavar="YAML", required=True, help=target)
    list_options(into)
    into.set_defaults(verb="importing")

    audit = verb("audit", "tell what shows that the spec of a device is right, and what does not")
    audit.add_argument("device", metavar="DEVICE[@VERSION]")
    audit.add_argument("--manual", metavar="FILE", help="the text of the manual; left out: its recorded index")
    audit.add_argument("--record", action="store_true", help="write the index of that text beside the spec")
    audit.add_argument("--all", action="store_true", help="the long tables too")
    audit.add_argument(
        "--as-printed", action="store_true", help="what the checks find in the print, as if no erratum were written"
    )
    audit.add_argument("--table", metavar="NAME", help="one table alone, such as ledger; csv and xlsx hold one")
    audit.add_argument("--format", choices=("text", "json", "html", "sarif", "csv", "xlsx"), default="text")
    audit.add_argument("--out", metavar="FILE", help="the file for the page or the table; left out: the output")
    audit.add_argument("--dump", metavar="FILE", help="judge what was read from a device: CSV, XLSX or JSON; -: input")
    for role in ("address", "value", "words", "space"):
        audit.add_argument(f"--{role}", metavar="COLUMN", help=f"the column of its {role}, where it is not found")
    audit.add_argument("--base", choices=("hex", "decimal", "4xxxx"), help="how the dump's addresses are written")
    audit.add_argument("--offset", type=int, metavar="NUMBER", help="by how much they are higher than on the wire")
    audit.add_argument("--encoding", metavar="NAME", help="how the dump is encoded, such as gbk, big5 or utf-16")
    audit.add_argument("--sheet", metavar="NAME", help="the sheet of a dump that is a workbook")
    signs = "record that a section of the manual was compared with the spec; `all` for every one"
    audit.add_argument("--sign", metavar="SECTION", help=signs)
    audit.add_argument("--by", metavar="NAME", help="who compared it, for --sign: a name or a role")
    audit.add_argument("--on", metavar="DATE", help="when, for --sign; left out: today")
    audit.add_argument("--how", metavar="TEXT", help="how, for --sign")

    versions = verb("versions", "list the versions of a device, and what depends on them")
    versions.add_argument("device", metavar="DEVICE[@VERSION]")

    resolve = verb("resolve", "print the whole spec of a version, with the place of each value")
    resolve.add_argument("device", metavar="DEVICE[@VERSION]")

    blame = verb("blame", "tell which file and line set each attribute of a fact")
    blame.add_argument("device", metavar="DEVICE[@VERSION]")
    blame.add_argument("path", metavar="PATH", help="the path of the fact, such as registers/NAME")

    new = verb("new", "write the first file of a device, or the file of a version")
    new.add_argument("kind", choices=("device", "version"))
    new.add_argument("name", metavar="DEVICE")
    new.add_argument("version", nargs="?", metavar="VERSION", help="the version, for a new version")
    new.add_argument("--based-on", metavar="VERSION", help="what the version changes; left out: the newest one")
    new.add_argument("--line", help="the line of the version; left out: that of the one it is based on")
    new.add_argument("--protocol", help="a protocol of the specs, or packet, or telegram, for a new device")

    matrix = verb("matrix", "list facts by versions")
    matrix.add_argument("device", metavar="DEVICE")
    matrix.add_argument("--all", action="store_true", help="facts that are the same in all versions too")
    matrix.add_argument("--format", choices=("text", "csv", "html"), default="text")

    rule = verbs.add_parser("rule", help="explain a rule that a check follows")
    rule.add_argument("code", nargs="?", metavar="CODE", help="left out: list all rules")

    diff = verb("diff", "tell what differs between two versions, and whom it hurts")
    side = "DEVICE@VERSION, a folder of specs, or a git revision such as HEAD~3 or main:specs"
    diff.add_argument("old", metavar="A", help=side)
    diff.add_argument("new", metavar="B", help="likewise")
    diff.add_argument("--format", choices=("text", "json", "markdown", "html", "sarif", "github"), default="text")
    fails = "exit with 1 where there is such a change; breaking ones are those of classes wire and source"
    diff.add_argument("--fail-on", choices=("breaking", "behaviour", "any"), help=fails)

    verb("devices", "list the devices and their versions")

    completion = verbs.add_parser("completion", help="print the completion script of a shell")
    completion.add_argument("shell", choices=("bash", "zsh", "tcsh"))
    completion.set_defaults(parser=parser)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one verb and returns its exit code."""
    collecting = gc.isenabled()
    gc.disable()  # a run is short, and the trees it keeps are never garbage
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace", newline="\n")
    try:
        parsed = _parser().parse_args(arguments)
        code: int = import_module(f"fieldspec.commands.{parsed.verb}").run(parsed)
        sys.stdout.flush()
        return code
    except UsageError as error:
        print(f"fieldspec: {error}", file=sys.stderr)
        return WRONG_USE
    except OSError as error:
        return _unwritten(error)
    except KeyboardInterrupt:
        return INTERRUPTED
    finally:
        if collecting:
            gc.enable()


def command() -> NoReturn:
    """What a shell calls. The process ends at once: to take the objects of a run apart takes longer than a verb."""
    code = main()
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            try:
                stream.flush()
            except OSError as error:
                code = _unwritten(error)
    os._exit(code)


def _unwritten(error: OSError) -> int:
    """What to do when the output cannot be written."""
    # Nothing more may be written, not even what is left when Python shuts down.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if isinstance(error, BrokenPipeError) or (os.name == "nt" and error.errno == errno.EINVAL):
        return FINE  # whoever read the output has seen enough
    print(f"fieldspec: cannot write the output: {error.strerror}", file=sys.stderr)
    return WRONG_USE


if __name__ == "__main__":
    command()
