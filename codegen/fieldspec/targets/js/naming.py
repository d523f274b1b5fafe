"""Names that JavaScript and TypeScript allow, each once in its scope."""

from __future__ import annotations

from fieldspec.foundation.names import free_name


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


KEYWORDS = _words(
    "arguments as async await break case catch class const continue debugger default delete do else enum"
    " eval export extends false finally for function get if implements import in instanceof interface let"
    " new null of package private protected public return set static super switch this throw true try type"
    " typeof undefined var void while with yield any bigint boolean declare never number object string"
    " symbol unknown"
)
GLOBALS = _words(
    "Array ArrayBuffer BigInt Boolean DataView Date Error Function Infinity Intl JSON Map Math NaN Number"
    " Object Partial Promise Proxy RangeError Readonly Record Reflect RegExp Required Set String Symbol"
    " SyntaxError TypeError Uint8Array"
)
SHARED = _words(
    "CodecError Conversion ExceptionFrame Flags Framer Link Message Parameter ParameterSet Quantity"
    " RecordCodec Register RegisterArray RequestFrame ResponseFrame RecordTable Unit"
)
MODULE = _words(
    "DEVICE IDENTITY LATEST REGISTERS TABLES VERSION VERSIONS forFirmware readRequests readValue writeRequests"
)
IMPORTS = {
    "absent": "absentValues",
    "checksums": "avoiding crc16 crcOf fletcherOf followedBy lrc sum8 swapping totalOf",
    "digits": "bcdOf blankDigitsOf codedNumberOf digitsOf putBcd putBlankDigits putCodedNumber putDigits",
    "end_framer": "endFramer",
    "error": "brokenList refusedBits refusedMember refusedNumber wrongNumber wrongSize",
    "escapes": "adding canIdentifier cobs inserting replacing",
    "framer": "addressIntervals codeFramer delimiterFramer escapeFramer lengthFramer",
    "link": "frames link message",
    "parameter": "parameter parameterSet parameters",
    "quantity": "conversion powerUnit realUnit unit",
    "record": "record",
    "register": "register registerArray registerFunctions table",
    "values": "bitsNumber bitsOf booleanOf checkList doubleBitsOf doubleOf encodedTextOf floatOf halfBitsOf initialWord"
    " listLength numberOf putBytes putEncodedText putText setBits signed48 textOf within",
    "number_bits": "halfOf magnitudeBits magnitudeOf",
    "lists": "elementBytes elementsInImage elementsLength readAround sentOfImage",
    "widths": "narrowedImage readImage",
}
"""The helpers of the runtime that modules import, by the module of the runtime."""

HELPERS = _words(" ".join(IMPORTS.values())) | {"chosen", "device", "frame", "registersOn"}
"""The helpers, and the locals of generated functions, so that no name of a spec hides one."""


class Scope:
    """The names of one scope. A name that is taken or reserved gets another form."""

    def __init__(self, *reserved: frozenset[str]) -> None:
        self._taken = set(KEYWORDS).union(*reserved)

    def take(self, name: str, *alternatives: str) -> str:
        """The first free name of several; where none is free, the last one with underscores appended."""
        candidate = free_name(self._taken, name, *alternatives)
        self._taken.add(candidate)
        return candidate


def module_scope() -> Scope:
    """The scope of a version's module."""
    return Scope(GLOBALS, SHARED, MODULE, HELPERS)


def property_scope() -> Scope:
    """The scope of the properties of an object, where reserved words are not a problem."""
    scope = Scope()
    scope._taken.clear()
    return scope
