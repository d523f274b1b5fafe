"""What becomes of facts that an output cannot express, as a part of the page of capabilities."""

from __future__ import annotations

from collections.abc import Iterator

_INTRODUCTION = """\
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
    yield _INTRODUCTION
    yield "| fact | rules | consequence |"
    yield "|---|---|---|"
    for subject, rules, result in ROWS:
        yield f"| {subject} | {', '.join(f'[{code}](checks.md#{code})' for code in rules)} | {result} |"
    yield ""
    yield "Codecs in Python, C and JavaScript, documentation, vectors and lists for operator panels support all facts"
    yield "except codecs of packages."
