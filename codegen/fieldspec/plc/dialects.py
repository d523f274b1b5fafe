"""The dialects of programmable controllers: one row of facts each."""

from __future__ import annotations

from fieldspec.classes import dataclass, replace
from fieldspec.plc.routines.spelling import SCL, STRUCTURED_TEXT, Spelling
from fieldspec.reserved import TARGETS


@dataclass(frozen=True, slots=True)
class Dialect:
    """What differs between dialects where something is declared.

    `reserved` is the table of words that it keeps for itself. `struct`, `image`, `bit_struct`, `enum`, `constants` and
    `texts` are forms of names: of a device and what is declared. `prefixed` says that names of members begin with
    letters for their type. `qualified` says that constants are used with the name of their list before them; else their
    own names have the device and the list in them. `name_length` are the most characters of a name.

    `enums` says whether enums are types, of at least `enum_members` members; else their form is empty. `widest` are the
    bytes of its widest whole number; wider ones are split in two. `nested_arrays` says that elements of arrays may be
    arrays, `wide_texts` that texts of codes may have other characters than those of ASCII. `bits` says whether words of
    flags lie in an image as a struct of BOOL (`packed`) or as a `word`. `target` is the model of memory of its images,
    and `longest_image` the most bytes of process data. `foreign` is what tools of others lose of it, empty for nothing.

    `comment` is the form of a comment, `byte_order_mark` what its files begin with, `line_end` how lines end there.
    """

    name: str
    title: str
    reserved: str
    struct: str
    image: str
    bit_struct: str
    enum: str
    constants: str
    texts: str
    prefixed: bool
    qualified: bool
    name_length: int
    enums: bool
    enum_members: int
    widest: int
    nested_arrays: bool
    wide_texts: bool
    bits: str
    target: str
    longest_image: int
    spelling: Spelling
    foreign: str = ""
    comment: str = "// {}"
    byte_order_mark: str = ""
    line_end: str = "\n"

    def spelled(self, text: str) -> str:
        """A name as the dialect accepts it."""
        return TARGETS[self.reserved].spelled(text)


STRUCTURED = Dialect(
    name="st",
    title="Structured Text of CODESYS and TwinCAT 3",
    reserved="iec",
    struct="ST_{}_{}",
    image="ST_{}_{}Image",
    bit_struct="ST_{}_{}Bits",
    enum="E_{}_{}",
    constants="GVL_{}_{}",
    texts="ST_{}_{}Text",
    prefixed=True,
    qualified=True,
    # Nothing limits a name there; a reader of symbols that takes only 32 characters cuts them by itself.
    name_length=255,
    enums=True,
    # CODESYS: "The enumeration must have at least two components."
    enum_members=2,
    widest=8,
    nested_arrays=True,
    wide_texts=True,
    # A BOOL is a byte there, and BIT hides from other tools.
    bits="word",
    target="tc3:1",
    # The most data in a frame of PROFINET.
    longest_image=1440,
    spelling=STRUCTURED_TEXT,
)

SIEMENS = Dialect(
    name="scl",
    title="SCL of TIA Portal, for S7-1200 and S7-1500",
    reserved="siemens",
    struct="type{}{}",
    image="type{}{}Image",
    bit_struct="type{}{}Bits",
    enum="",
    constants="{}{}",
    texts="type{}{}Text",
    prefixed=False,
    qualified=False,
    # TIA Portal takes 125 characters for a block, and more for a constant.
    name_length=125,
    enums=False,
    enum_members=1,
    # An S7-1200 has no LWORD, no LINT and no ULINT.
    widest=4,
    nested_arrays=False,
    wide_texts=False,
    bits="packed",
    target="s7",
    longest_image=1440,
    spelling=SCL,
    byte_order_mark="\ufeff",
    line_end="\r\n",
)

DIALECTS = {
    dialect.name: dialect
    for dialect in (
        STRUCTURED,
        replace(STRUCTURED, name="twincat", title="TwinCAT 3 source files"),
        replace(
            STRUCTURED,
            name="plcopen",
            title="PLCopen XML",
            foreign="attributes and lists of constants are data of CODESYS, which tools of others leave out",
        ),
        SIEMENS,
    )
}
