"""The dialects of programmable controllers, one row of facts each, and names as they accept them."""

from __future__ import annotations

import re
from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.foundation.reserved import TARGETS
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.model.fact import Fact
from fieldspec.targets.controllers.statements.expressions import ArrayType
from fieldspec.targets.controllers.statements.routine import SECTIONS


@dataclass(frozen=True, slots=True)
class Spelling:
    """What differs between dialects where a routine is written.

    With `siemens_names` variables are called as Siemens calls them: `names` has the names of the current routine.
    `variable` and `routine` hold a name, `shift` holds the function, the value and the number of bits. `member` holds
    an enum, a member and its number; where `enums` is false, the dialect has none, and a variable has the type of the
    numbers. `struct` holds the name of a declared type. `array` is the form of the names of array types, which the
    arrays in `named` have, or all where a variable cannot have an array without a name. `sections` are the words for
    the roles of variables. `comment` is the form of a comment, `timer` the type of an on-delay timer. `has_regions`
    says that REGION gives statements a heading.
    """

    variable: str = "{}"
    siemens_names: bool = False
    names: Mapping[str, str] = field(default_factory=dict)
    routine: str = "{}"
    shift: str = "{}({}, {})"
    member: str = "{0}.{1}"
    struct: str = "{}"
    array: str = ""
    named: frozenset[ArrayType] = frozenset()
    all_named: bool = False
    enums: bool = True
    sections: Mapping[str, str] = field(default_factory=lambda: SECTIONS)
    head: str = "FUNCTION {} : {}"
    begin: str = ""
    end: str = "END_FUNCTION"
    attributes: tuple[str, ...] = ()
    comment: str = "// {}"
    timer: str = "TON"
    has_regions: bool = False


STRUCTURED_TEXT = Spelling(array="T_{}_{}")
STANDARD = Spelling(member="{2}", array="T_{}_{}", all_named=True, enums=False, comment="(* {} *)")
SCL = Spelling(
    variable="#{}",
    siemens_names=True,
    routine='"{}"',
    shift="{}(IN := {}, N := {})",
    member="{2}",
    struct='"{}"',
    enums=False,
    sections={
        "input": "VAR_INPUT",
        "output": "VAR_OUTPUT",
        "in_out": "VAR_IN_OUT",
        "local": "VAR_TEMP",
    },
    head="FUNCTION {} : {}",
    begin="BEGIN",
    timer="TON_TIME",
    has_regions=True,
    attributes=("{ S7_Optimized_Access := 'TRUE' }", "VERSION : 0.1"),
)


@dataclass(frozen=True, slots=True)
class Dialect:
    """What differs between dialects where something is declared.

    `reserved` is the table of words that it keeps for itself. `struct`, `image`, `bit_struct`, `enum`, `constants` and
    `texts` are forms of names: of a device and what is declared. `prefixed` says that names of members begin with
    letters for their type. `qualified` says that constants are used with the name of their list before them; else their
    own names have the device and the list in them. `name_length` are the most characters of a name.

    `enums` says whether enums are types, of at least `enum_members` members; else their form is empty. `widest` are the
    bytes of its widest whole number; wider ones are split in two. `nested_arrays` says that elements of arrays may be
    arrays, `wide_texts` that texts of codes may have characters outside of ASCII. `bits` says whether words of flags
    lie in an image as a struct of BOOL (`packed`) or as a `word`. `target` is the model of memory of its images, and
    `longest_image` the most bytes of process data. `packs` says that a struct can be told to have no gaps; `texts` is
    empty where constants cannot be texts of codes. `has_status` says that blocks have a WORD that says how they are, in
    place of the number of an error. `foreign` is what tools of others lose of it, empty for nothing.

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
    packs: bool = True
    has_status: bool = False
    foreign: str = ""
    comment: str = "// {}"
    byte_order_mark: str = ""
    line_end: str = "\n"

    def legal_name(self, text: str) -> str:
        """A name in the form that the dialect accepts."""
        return TARGETS[self.reserved].legal_name(text)


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

IEC = replace(
    STRUCTURED,
    name="iec",
    title="Structured Text of IEC 61131-3, for Beremiz and OpenPLC",
    # Members of enums have no numbers there, so that enums are numbers with constants.
    enum="",
    constants="{}{}",
    texts="",
    qualified=False,
    enums=False,
    enum_members=1,
    wide_texts=False,
    packs=False,
    spelling=STANDARD,
    comment="(* {} *)",
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
    has_status=True,
    byte_order_mark="\ufeff",
    line_end="\r\n",
)


def _in_other_files(name: str, title: str, foreign: str = "") -> Dialect:
    """STRUCTURED under another title: its text is written once, for all outputs that differ in their files alone."""
    return replace(STRUCTURED, name=name, title=title, foreign=foreign)


DIALECTS = {
    dialect.name: dialect
    for dialect in (
        STRUCTURED,
        _in_other_files("twincat", "Structured Text in source files of TwinCAT 3"),
        _in_other_files(
            "plcopen",
            "PLCopen XML",
            "attributes and constant lists are CODESYS extensions, which other tools ignore",
        ),
        IEC,
        SIEMENS,
    )
}


_IDENTIFIER = re.compile("[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")


@dataclass(slots=True)
class Scope:
    """Names that must differ, whatever the case of their letters. `what` says what they are names of.

    Names are taken in the order of the spec, so that a new fact after the others changes none of theirs.
    """

    dialect: Dialect
    what: str
    findings: list[Diagnostic]
    _taken: dict[str, tuple[str, Fact | None]] = field(default_factory=dict)

    def take(self, text: str, fact: Fact | None) -> str:
        """The name of a fact as it is spelled; a name that another fact has, or that is too long, is a finding."""
        legal_name = self.dialect.legal_name(text)
        limit = self.dialect.name_length
        bare = legal_name.strip('"')
        before = self._taken.setdefault(bare.lower(), (text, fact))
        if fact is not None:
            if before[1] is not fact:
                self.findings.append(_same(self, text, fact, *before))
            if len(bare) > limit or not _IDENTIFIER.fullmatch(bare):
                self.findings.append(_long(self, text, fact, limit))
        return legal_name

    def free(self, text: str) -> str:
        """A name that no fact has: a number is added to a text that is in use."""
        number, tried = 1, text
        while self.dialect.legal_name(tried).strip('"').lower() in self._taken:
            number += 1
            tried = f"{text}{number}"
        return self.take(tried, None)


def _same(scope: Scope, text: str, fact: Fact, other: str, first: Fact | None) -> Diagnostic:
    subject = f"{fact.name} and {first.name} are" if first is not None else f"{fact.name} and a name of our own are"
    labels = (Label(first.place["name"], f"this one is {other}"),) if first is not None else ()
    return Diagnostic(
        "plc_names_distinct",
        f"{subject} the same {scope.what} in {scope.dialect.title}: {text}",
        fact.place["name"],
        labels,
        help="give one of them another name; capital letters and underscores make no difference there",
    )


def _long(scope: Scope, text: str, fact: Fact, limit: int) -> Diagnostic:
    return Diagnostic(
        "plc_names_fit",
        f"{text} is not a valid {scope.what} in {scope.dialect.title}: {limit} letters, digits and single underscores",
        fact.place["name"],
        help="give it a shorter name",
    )
