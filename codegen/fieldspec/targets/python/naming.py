"""Names that Python allows, each once in its scope."""

from __future__ import annotations

from fieldspec.foundation.names import free_name


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


# Fixed lists rather than `keyword` and `builtins`: those differ between the versions of Python.
KEYWORDS = _words(
    "False None True and as assert async await break class continue def del elif else except finally for from global"
    " if import in is lambda nonlocal not or pass raise return try while with yield"
)
TYPES = _words("bool bytes classmethod dict float int list object property staticmethod str super tuple type")
BUILTINS = _words(
    "all any bytearray callable chr enumerate filter hash id input isinstance iter len map max memoryview min next"
    " open pow print range repr reversed round set slice sorted sum vars zip"
)
EXCEPTIONS = _words(
    "ArithmeticError AssertionError AttributeError BaseException BufferError EOFError Ellipsis Exception"
    " ImportError IndexError KeyError LookupError MemoryError NameError NotImplemented OSError OverflowError"
    " ReferenceError RuntimeError StopIteration SyntaxError SystemError SystemExit TypeError ValueError Warning"
    " ZeroDivisionError"
)
SHARED = _words(
    "CodecError ExceptionResponse Flags Framer Parameter ParameterSet ParameterSpace Register RegisterArray Request"
    " Response Subindex Table"
)
MODULE = _words(
    "DETECTED_BY DEVICE IDENTITY LATEST REGISTERS TABLES TYPE_CHECKING VERSION VERSIONS annotations for_firmware latest"
    " read_request read_requests read_value register_at write_request write_requests"
)
RECORD = _words("decode encode self")
MESSAGE = RECORD | _words("CODE NUMBER SUPPLEMENTS response_type")
FLAGS = _words("_ flags raw self")
STATES = _words("state")
PARAMETERS = _words(
    "base from_raws name numbers printed_as read_request read_value read_values self space title to_raws write_request"
    " write_values_request number_text"
)


class Scope:
    """The names of one scope. A name that is taken, or reserved by Python or the generated code, gets another form."""

    def __init__(self, *reserved: frozenset[str]) -> None:
        self._taken = set(KEYWORDS).union(*reserved)
        self._taken_in_order: list[str] = []

    @property
    def names(self) -> list[str]:
        """The names taken in this scope, in order."""
        return list(self._taken_in_order)

    def take(self, name: str, *alternatives: str) -> str:
        """The first free name of several; where none is free, the last one with underscores appended."""
        candidate = free_name(self._taken, name, *alternatives)
        self._taken.add(candidate)
        self._taken_in_order.append(candidate)
        return candidate


def module_scope() -> Scope:
    """The scope of a version's module."""
    return Scope(TYPES, BUILTINS, EXCEPTIONS, SHARED, MODULE)


def package_name(device: str) -> str:
    """The subpackage of a device, by its id: `drive_x`."""
    return Scope().take(device.replace("-", "_"))


def module_name(version: str) -> str:
    """The module of a version: `v2_0`, `before_1_17`."""
    words = "".join(char.lower() if char.isalnum() and char.isascii() else "_" for char in version)
    return f"v{words}" if words[:1].isdigit() or words in KEYWORDS else words
