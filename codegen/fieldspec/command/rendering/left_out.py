"""What becomes of facts that an output cannot express, as a part of the page of capabilities."""

from __future__ import annotations

from collections.abc import Iterator

_INTRODUCTION = """\
### What is left out

Where a device has something that an output refuses by a rule, the output leaves out the least that has it, and what
needs it: a message with its functions, a table of the record, a register whose exponent it is, a task that reads it.
The build warns of each such fact and writes all the rest; the generated files name what is left out, and why. A
finding about the device as a whole is an error: the output leaves the device out, with one warning, and the others are
written. Where `--to` names the output, nothing of the device is written. `fieldspec rule CODE` explains a rule.
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
    ("a value in pieces", ("plc_values_whole",), "its message and the messages of the pieces are left out"),
    ("a telegram", ("plc_telegrams_fit",), "it is left out"),
    ("the image of a telegram", ("plc_images_exact",), "it is left out; functions convert the bytes"),
    ("a table that moves", ("plc_addresses_constant", "output_addresses_constant"), "it is left out"),
    ("a conversion", ("plc_numbers_fit",), "it is left out"),
    ("a register or a field, in dissectors", (*TABLES, "wireshark_parameters_typed"), "it is shown as bytes"),
    (
        "a field that says how long something is, in dissectors",
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
        "an error, since a program must know that a request was not carried out",
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
    yield "| what breaks a rule | rules | becomes of it |"
    yield "|---|---|---|"
    for subject, rules, result in ROWS:
        yield f"| {subject} | {', '.join(f'[{code}](checks.md#{code})' for code in rules)} | {result} |"
    yield ""
    yield "Codecs in Python, C and JavaScript, documentation, vectors and lists for operator panels refuse only codecs"
    yield "of packages."
