"""The page of capabilities as Markdown: what outputs express exactly, adapt or refuse, and which keys change them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from itertools import groupby

from fieldspec.language.schema.capabilities import AUDIT, CHECK, EXPORT, SIMULATOR, effects
from fieldspec.targets import BUILT_IN, OUTPUTS
from fieldspec.targets.controllers.capabilities import CONSTRUCTS, EXACT, Capability, of_dialect
from fieldspec.targets.controllers.dialects import DIALECTS

COLUMNS = ("st", "twincat", "plcopen", "iec", "scl", "kv", "hmi")
"""The outputs for engineering tools, in the order of the columns."""

_INTRODUCTION = """\
<!-- Written by `fieldspec.command.rendering.capabilities.page`; a test keeps it fresh. -->

# What the outputs express

The [first table](#constructs) shows for each construct whether the outputs for engineering tools express, adapt or
refuse it. The [tables of keys](#keys) list the outputs that each key of the language changes.

## Constructs

**exact**: the output expresses the construct completely. **adapted**: the output expresses the construct in a
different form. **refused**: the output omits the construct. The number in brackets refers to a reason
[below](#why). If the reason ends with the name of a rule, the build reports the [omission](#what-is-left-out).
"""

_KEYS = """\
## Keys

The tables list the outputs that change if a key changes in a spec. The identity is not counted, because every output
contains it. Outputs that a row does not list do not use the key. For example, the lists for operator panels contain no
registers, and codecs do not need the line of a manual. A key with only `docs` is documentation. `export` is the list of
`fieldspec export`, `audit` the report of `fieldspec audit`, and `simulate` the behaviour of `fieldspec simulate`.
`check` means that only findings use the key. `none` means that no output uses the key; it only informs readers of the
spec. Tests verify the rows: they change a key in sample devices and compare all outputs.
"""

_ALL = "all outputs"


def page() -> str:
    """The text of the page of capabilities."""
    reasons: dict[str, int] = {}
    tables = {name: capabilities(name) for name in COLUMNS}
    lines = [_INTRODUCTION, f"| construct | {' | '.join(COLUMNS)} |", f"|---{'|---' * len(COLUMNS)}|"]
    for key, title in CONSTRUCTS.items():
        cells = [_cell(tables[name][key], reasons) for name in COLUMNS]
        lines.append(f"| {title} | {' | '.join(cells)} |")
    lines += ["", *(f"- `{name}`: {OUTPUTS[name].title}" for name in COLUMNS), "", "### Why", ""]
    lines += [f"{number}. {reason[:1].upper()}{reason[1:]}." for reason, number in reasons.items()]
    lines += ["", *left_out_lines(), ""]
    lines += [_KEYS, *(f"- `{name}`: {OUTPUTS[name].title}" for name in OUTPUTS if name in BUILT_IN)]
    for part, keys in effects().items():
        lines += ["", f"### {part or 'the file'}", "", "| keys | change |", "|---|---|", *_rows(keys)]
    return "\n".join(lines) + "\n"


def _rows(keys: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
    """A row for the keys that change the same outputs."""
    by_outputs = sorted(keys.items(), key=lambda item: (-len(item[1]), item[1], item[0]))
    for outputs, entries in groupby(by_outputs, key=lambda item: item[1]):
        yield f"| {', '.join(f'`{key}`' for key, _ in entries)} | {_outputs_text(outputs)} |"


def _outputs_text(outputs: tuple[str, ...]) -> str:
    ordered = [name for name in (*OUTPUTS, EXPORT, AUDIT, SIMULATOR, CHECK) if name in outputs]
    return _ALL if set(outputs) >= BUILT_IN else ", ".join(ordered) or "none"


def capabilities(name: str) -> Mapping[str, Capability]:
    """The capabilities of an output, from its dialect or its back end."""
    if name in DIALECTS:
        return of_dialect(DIALECTS[name])
    table: Mapping[str, Capability] = import_module(f"fieldspec.targets.{name}.backend").capabilities()
    return table


def _cell(capability: Capability, reasons: dict[str, int]) -> str:
    if capability.level == EXACT:
        return EXACT
    return f"{capability.level} ({reasons.setdefault(capability.reason, len(reasons) + 1)})"


_LEFT_OUT = """\
### What is left out

If a rule excludes a fact from an output, the output leaves out the fact, and the facts that need it: a message with
its functions, a table of the record, a register with this exponent, a task that reads it. The build warns of each
omitted fact and writes the rest; the generated files list the omitted facts with the reasons. A finding about the
whole device is an error: the output leaves the device out, with one warning, and writes the others. If `--to` names
the output, no file of the device is written. `fieldspec rule CODE` explains a rule.
"""

NUMBERS = ("plc_numbers_binary", "plc_numbers_fit", "plc_reals_fit", "plc_reals_present", "plc_texts_ascii")
TABLES = ("output_has_codec", "output_numbers_binary", "output_texts_ascii")
LISTS = ("plc_lists_last", "output_lists_last")

ROWS: tuple[tuple[str, tuple[str, ...], str], ...] = (
    ("a register or a parameter", (*NUMBERS, *TABLES), "it is left out"),
    (
        "a field",
        (*NUMBERS, "plc_arrays_flat", *TABLES, *LISTS),
        "its message, or its record with all messages and tables of that record, is left out",
    ),
    ("a segmented value", ("plc_values_whole",), "its message and the messages of its segments are left out"),
    ("a telegram", ("plc_telegrams_fit",), "it is left out"),
    ("the image of a telegram", ("plc_images_exact",), "it is left out; functions convert the bytes"),
    ("a table with a variable base", ("plc_addresses_constant", "output_addresses_constant"), "it is left out"),
    ("a conversion", ("plc_numbers_fit",), "it is left out"),
    ("a register or a field, in dissectors", (*TABLES, "wireshark_parameters_typed"), "it is shown as bytes"),
    (
        "a field with a length or count, in dissectors",
        ("output_numbers_binary",),
        "the data of the message are shown as bytes",
    ),
    ("a field in a message, in dissectors", ("output_lists_last",), "the data of the message are shown as bytes"),
    ("a register of bits or bytes, in word maps", ("output_registers_words",), "it is left out"),
    ("a link, in word maps", ("output_frames_words",), "its frames are left out"),
    ("a part of a frame", (*NUMBERS, *TABLES), "an error"),
    (
        "a field of an exception response",
        NUMBERS,
        "an error, because a program must detect rejected requests",
    ),
    (
        "frames, address spaces, names, enums",
        (
            *("plc_frames_supported", "wireshark_frames_unescaped", "plc_spaces_supported"),
            *("plc_names_distinct", "plc_names_fit", "plc_enums_fit"),
        ),
        "an error",
    ),
)
"""What breaks rules, the rules, and what becomes of it."""


def left_out_lines() -> Iterator[str]:
    """The lines of the part about what outputs leave out."""
    yield _LEFT_OUT
    yield "| fact | rules | consequence |"
    yield "|---|---|---|"
    for subject, rules, result in ROWS:
        yield f"| {subject} | {', '.join(f'[{code}](checks.md#{code})' for code in rules)} | {result} |"
    yield ""
    yield "Codecs in Python, C and JavaScript, documentation, vectors and lists for operator panels support all facts"
    yield "except codecs of packages."
