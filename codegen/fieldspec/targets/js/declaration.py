"""The declarations of a module: the JavaScript, and its types."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.value import Value
from fieldspec.targets.js.naming import Scope
from fieldspec.targets.runtime_values import is_wide


@dataclass(frozen=True, slots=True)
class Declaration:
    """The lines of a declaration in the module and in its types."""

    code: list[str]
    types: list[str]


@dataclass(frozen=True, slots=True)
class Names:
    """The names in a module: of enums, words of flags, records, messages and registers by their names in the spec."""

    layout: DeviceLayout
    scope: Scope
    enums: dict[str, str] = field(default_factory=dict)
    flags: dict[str, str] = field(default_factory=dict)
    records: dict[str, str] = field(default_factory=dict)
    messages: dict[str, str] = field(default_factory=dict)
    registers: dict[str, str] = field(default_factory=dict)

    def type_of(self, value: Value) -> str:
        """The type of a value in TypeScript."""
        encoding = value.encoding
        match encoding:
            case Truth():
                return "boolean"
            case Text():
                return "string"
            case Octets():
                return "Uint8Array"
            case Real():
                return "number"
            case Whole() | Digits():
                enum = self.layout.device.enums.get(value.enum)
                if enum is not None and not enum.open and not value.sentinels:
                    return self.enums[enum.name]
                return "bigint" if is_wide(encoding) else "number"
            case _:
                assert_never(encoding)
