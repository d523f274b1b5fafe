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
# The locals and helpers of generated functions, so that no name of a spec hides one.
HELPERS = _words(
    "absentValues addressIntervals allowed bitsOf booleanOf doubleBitsOf doubleOf"
    " adding brokenList canIdentifier cobs escapeFramer inserting replacing bytesOf checkList checkSize codeFramer"
    " conversion delimiterFramer device endFramer"
    " floatOf frame frames knownKeys lengthFramer link listLength message noMessage numberOf parameter"
    " parameterSet putBytes putText record refusedBits refusedMember refusedNumber register registerArray"
    " spans table textOf unit encodedTextOf narrowedImage putEncodedText readImage wordsOf wrongNumber"
    " avoiding crc16 crcOf fletcherOf followedBy lrc sum8 swapping totalOf"
)


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
