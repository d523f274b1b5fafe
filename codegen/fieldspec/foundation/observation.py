"""Objects of data that know which of their attributes have been read.

Such an object takes an attribute from another one when it is first read, and notes it; then it has it like any object.
"""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING, attributes

if TYPE_CHECKING:
    from typing import Any, TypeVar

    Instance = TypeVar("Instance")

_classes: dict[type, type] = {}
"""The classes of observed objects, by the classes of the objects and by themselves."""


def observed(instance: Instance, inner: tuple[type, ...] = ()) -> Instance:
    """An object like another one that knows its attributes that have been read.

    So do its attributes, and the objects in its tuples and dictionaries, that are of the `inner` classes. A copy with
    other values for some attributes takes the others from the observed object, when they are read.
    """
    cls = type(instance)
    observing: Any = _classes.get(cls) or _observing(cls)
    result: Instance = object.__new__(observing)
    observing.source.__set__(result, (instance, inner, {}))
    return result


def read_attributes(instance: Any) -> dict[str, object]:
    """The attributes of an observed object that have been read, with their values."""
    read: dict[str, object] = instance.source[-1]
    return read


def is_same(old: object, new: object) -> bool:
    """Whether two objects are the same, or consist of the same ones, in all that was read of the old one."""
    if old is new:
        return True
    if _classes.get(type(old)) is type(old):
        return all(is_same(value, getattr(new, name)) for name, value in read_attributes(old).items())
    if isinstance(old, tuple) and isinstance(new, tuple):
        return len(old) == len(new) and all(map(is_same, old, new))
    if isinstance(old, dict) and isinstance(new, dict):
        return [*old] == [*new] and all(map(is_same, old.values(), new.values()))
    return old == new


def _with_observed(value: Any, inner: tuple[type, ...]) -> Any:
    """A value, or the elements of a tuple or a dictionary, observed where they are of the `inner` classes."""
    if isinstance(value, inner):
        return observed(value, inner)
    items = value if value.__class__ is tuple else value.values() if value.__class__ is dict else ()
    if not any(isinstance(item, inner) for item in items):
        return value  # the same object, by which caches know it
    of_items = [observed(item, inner) if isinstance(item, inner) else item for item in items]
    return tuple(of_items) if value.__class__ is tuple else dict(zip(value, of_items, strict=True))
    return value


def _observing(cls: type) -> type:
    puts = {name: getattr(cls, name).__set__ for name in attributes(cls)}  # the class itself forbids assignment

    def read(instance: Any, name: str) -> Any:
        if name not in puts:
            raise AttributeError(f"{cls.__name__} has no attribute {name}")
        source, inner, attributes_read = instance.source
        value = getattr(source, name)
        if inner:
            value = _with_observed(value, inner)
        puts[name](instance, value)
        attributes_read[name] = value
        return value

    def replaced(instance: Any, /, **changes: Any) -> Any:
        copy = observed(instance)
        for name, value in changes.items():
            puts[name](copy, value)
        return copy

    space = {
        "__slots__": ("source",),
        "__module__": cls.__module__,
        "__class__": property(lambda instance: cls),
        "__getattr__": read,
        "_replaced": staticmethod(replaced),
    }
    observing = type(cls.__name__, (cls,), space)
    _classes[cls] = _classes[observing] = observing
    return observing
