"""Conversions between counts and shares of a reference, as functions."""

from __future__ import annotations

from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.text import described, docstring, literal, sentence
from fieldspec.backends.python.writing import pairs
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.ranges import Ranges
from fieldspec.model.signal import Conversion
from fieldspec.names import Name


@dataclass(frozen=True, slots=True)
class ConversionView:
    """The names of the two functions, the constant that they use, the call that makes it, and their docstrings."""

    name: str
    inverse: str
    constant: str
    call: str
    doc: list[str]
    inverse_doc: list[str]


def conversion_view(conversion: Conversion, device: Device, scope: Scope) -> ConversionView:
    """The view of a conversion."""
    full_scale = f"{conversion.full_scale:#x}"
    arguments = [literal(conversion.name), full_scale, pairs(_ranges(conversion, device))]
    arguments += ["complement=True"] if conversion.complement else []
    formula = f"reference * {f'(1 - raw / {full_scale})' if conversion.complement else f'raw / {full_scale}'}"
    printed = f"Printed: {sentence(conversion.printed)}" if conversion.printed else ""
    held = ", ".join(f"`{name}`" for name in conversion.signals)
    of = f"The count is that of {held}." if held else f"The count is of type {conversion.type.name}."
    references = " or ".join(_reference(path, device) for path in conversion.references)
    where = f" The device holds it in {references}." if references else ""
    about = [of, f"The quantity is in the unit of the reference.{where}", printed]
    title = sentence(conversion.title or Name.of(conversion.name).title())
    inverse_doc = [
        f"The count that is nearest to a quantity; of two the even one. {title}",
        *about[:2],
        "Raises CodecError where the quantity is out of range, and where the reference is 0.",
    ]
    return ConversionView(
        name=scope.take(conversion.name),
        inverse=scope.take(f"{conversion.name}_to_raw"),
        constant=f"_{Name.of(conversion.name).upper()}_CONVERSION",
        call=f"_Conversion({', '.join(arguments)})",
        doc=docstring(described(f"{title.rstrip('.')}: {formula}", conversion, *about), 4),
        inverse_doc=docstring(inverse_doc, 4),
    )


def _ranges(conversion: Conversion, device: Device) -> Ranges:
    """The counts that the signals may have where all may have the same ones, else those of the type."""
    found = {device.signals[name].value.ranges for name in conversion.signals}
    ranges = found.pop() if len(found) == 1 else None
    return ranges or Ranges(((conversion.type.low, conversion.type.high),))


def _reference(path: str, device: Device) -> str:
    """What holds a reference: `Pt317 (reference_speed, in rpm)`, or the name of another fact."""
    *_, owner, name = path.split("/")
    held = device.parameters.get(owner)
    row = next((one for one in held.parameters if one.name == name), None) if held is not None else None
    if held is None or row is None:
        return f"`{name}`"
    unit = f", in {row.value.unit}" if row.value.unit else ""
    return f"{row.printed_name or held.written(row.number)} (`{name}`{unit})"
