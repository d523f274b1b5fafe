"""The base of all records and frames."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any


class Record:
    """Fields by name. Records are equal where all fields are; `repr` has all of them."""

    __slots__ = ()
    __match_args__: tuple[str, ...] = ()

    def _set_fields(self, /, *values: Any, **quantities: tuple[Any, ...]) -> None:
        """Sets every field by its raw value or by its quantity; an argument that is missing is None.

        `quantities` has, by the name of the field, the name of the argument in its unit, the quantity, and what a
        missing one is, if not None. Raises TypeError where a field has neither or both, and CodecError as setting the
        quantity does.
        """
        for name, value in zip(self.__match_args__, values, strict=True):
            keyword, quantity, *marks = quantities.get(name, ("", None))
            left_out = marks[0] if marks else None
            if (value is None) == (quantity is left_out):
                arguments = f"{name!r} or {keyword!r}" if keyword else repr(name)
                problem = "is missing" if value is None else "takes only one of"
                raise TypeError(f"{self.__class__.__name__}() {problem} {arguments}")
            if quantity is left_out:
                setattr(self, name, value)
            else:
                setattr(self, keyword, quantity)

    def __eq__(self, other: object) -> bool:
        if other.__class__ is not self.__class__:
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.__match_args__)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__match_args__)
        return f"{self.__class__.__name__}({fields})"
