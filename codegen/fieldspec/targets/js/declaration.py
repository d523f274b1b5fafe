"""What a module declares: the JavaScript, and its types."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.primitives import Kind
from fieldspec.language.model.value import Value
from fieldspec.targets.js.naming import Scope


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

    def type_of(self, value: Value, size: int) -> str:
        """The type of a value in TypeScript, in `size` bytes."""
        kind = value.type.kind
        if kind is Kind.BOOLEAN:
            return "boolean"
        if kind is Kind.TEXT:
            return "string"
        if kind is Kind.BYTES:
            return "Uint8Array"
        enum = self.layout.device.enums.get(value.enum)
        if enum is not None and not enum.open and not value.sentinels:
            return self.enums[enum.name]
        return "bigint" if kind is Kind.INTEGER and value.number_size(size) > 6 else "number"
