"""Classes of data behave as those of `dataclasses` do; each test runs on both."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from types import ModuleType
from typing import Any, ClassVar

import pytest

from fieldspec import classes

BOTH = pytest.mark.parametrize("made_by", [classes, dataclasses], ids=["ours", "standard"])


def point(made_by: ModuleType) -> type:
    @made_by.dataclass(frozen=True, slots=True)
    class Point:
        kind: ClassVar[str] = "point"
        x: int
        y: int = 0
        near: list[int] = made_by.field(default_factory=list, repr=False, compare=False)

        def moved(self, by: int) -> Any:
            return made_by.replace(self, x=self.x + by)

    return Point


def named(made_by: ModuleType) -> tuple[type, type]:
    @made_by.dataclass(frozen=True, slots=True, kw_only=True)
    class Base:
        name: str
        label: str = ""

    @made_by.dataclass(frozen=True, slots=True)
    class Child(Base):
        number: int

        def __repr__(self) -> str:
            return f"<{self.name} {self.number}>"

        @property
        def doubled(self) -> int:
            return self.number * 2

    return Base, Child


def counter(made_by: ModuleType) -> type:
    @made_by.dataclass(slots=True)
    class Counter:
        value: int = 0

    return Counter


@BOTH
def test_attributes_are_given_by_place_by_name_and_by_default(made_by: ModuleType) -> None:
    made = point(made_by)
    assert [(held.x, held.y, held.near) for held in (made(1), made(1, 2), made(y=2, x=1), made(1, 2, [3]))] == [
        (1, 0, []), (1, 2, []), (1, 2, []), (1, 2, [3]),
    ]  # fmt: skip
    assert made(1).near is not made(1).near
    assert made.kind == "point"


@BOTH
@pytest.mark.parametrize(("given", "names"), [((), {}), ((1, 2, [], 4), {}), ((1,), {"z": 1}), ((1,), {"x": 1})])
def test_what_the_constructor_does_not_take_is_refused(made_by: ModuleType, given: Any, names: Any) -> None:
    with pytest.raises(TypeError):
        point(made_by)(*given, **names)


@BOTH
def test_objects_are_equal_where_their_classes_and_what_is_compared_are(made_by: ModuleType) -> None:
    made = point(made_by)
    assert made(1, 2, [3]) == made(1, 2, [4])
    assert hash(made(1, 2, [3])) == hash(made(1, 2, [4]))
    assert made(1, 2) != made(2, 1)
    assert made(1, 2) != (1, 2, [])
    assert made(1) != point(made_by)(1)


@BOTH
def test_frozen_objects_refuse_changes(made_by: ModuleType) -> None:
    held = point(made_by)(1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        held.x = 2
    with pytest.raises(dataclasses.FrozenInstanceError):
        del held.x
    with pytest.raises((dataclasses.FrozenInstanceError, AttributeError, TypeError)):
        held.other = 2
    assert not hasattr(held, "__dict__")
    assert held.x == 1


@BOTH
def test_objects_that_are_not_frozen_change_and_have_no_hash(made_by: ModuleType) -> None:
    held = counter(made_by)()
    held.value += 1
    assert held == counter(made_by)(1) or held.value == 1
    with pytest.raises(TypeError):
        hash(held)


@BOTH
def test_a_class_inherits_attributes_and_keeps_methods_of_its_own(made_by: ModuleType) -> None:
    _, child = named(made_by)
    held = child(3, name="a")
    assert (held.name, held.label, held.number, held.doubled, repr(held)) == ("a", "", 3, 6, "<a 3>")
    assert made_by.replace(held, label="b") == child(3, name="a", label="b")
    with pytest.raises(TypeError):
        child(3, "a")


@BOTH
def test_an_object_is_shown_as_the_call_that_makes_it(made_by: ModuleType) -> None:
    assert repr(point(made_by)(1, 2)).endswith("Point(x=1, y=2)")


@BOTH
def test_copies_differ_in_what_is_changed_only(made_by: ModuleType) -> None:
    held = point(made_by)(1, 2, [3])
    assert (held.moved(4).x, held.moved(4).y, held.moved(4).near) == (5, 2, [3])
    assert copy.deepcopy(held) == held
    with pytest.raises(TypeError):
        made_by.replace(held, z=1)


@BOTH
def test_objects_match_patterns_by_place(made_by: ModuleType) -> None:
    made = point(made_by)
    match made(1, 2):
        case made(x, y):
            assert (x, y) == (1, 2)


@classes.dataclass(frozen=True, slots=True)
class Kept:
    """A class that other processes find."""

    text: str


def test_objects_go_to_other_processes() -> None:
    assert pickle.loads(pickle.dumps(Kept("a"))) == Kept("a")


def test_the_standard_library_takes_them_for_its_own() -> None:
    made = point(classes)
    assert dataclasses.is_dataclass(made)
    assert [field.name for field in dataclasses.fields(made)] == list(classes.attributes(made)) == ["x", "y", "near"]
    assert dataclasses.asdict(made(1, 2, [3])) == {"x": 1, "y": 2, "near": [3]}
    assert dataclasses.replace(made(1), y=5) == made(1, 5)
