"""Our data classes behave like those of `dataclasses`; each test runs on both."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from types import ModuleType
from typing import Any, ClassVar
from unittest.mock import ANY

import pytest

from fieldspec.foundation import classes

BOTH = pytest.mark.parametrize("module", [classes, dataclasses], ids=["ours", "standard"])


def point(module: ModuleType) -> type:
    @module.dataclass(frozen=True, slots=True)
    class Point:
        kind: ClassVar[str] = "point"
        x: int
        y: int = 0
        near: list[int] = module.field(default_factory=list, repr=False, compare=False)

        def moved(self, by: int) -> Any:
            return module.replace(self, x=self.x + by)

    return Point


def named(module: ModuleType) -> tuple[type, type]:
    @module.dataclass(frozen=True, slots=True, kw_only=True)
    class Base:
        name: str
        label: str = ""

    @module.dataclass(frozen=True, slots=True)
    class Child(Base):
        number: int

        def __repr__(self) -> str:
            return f"<{self.name} {self.number}>"

        @property
        def doubled(self) -> int:
            return self.number * 2

    return Base, Child


def counter(module: ModuleType) -> type:
    @module.dataclass(slots=True)
    class Counter:
        value: int = 0

    return Counter


@BOTH
def test_an_object_of_another_class_says_itself_whether_it_is_equal(module: ModuleType) -> None:
    instance = point(module)(1)
    assert (instance == ANY) is True
    assert (instance == 1) is False
    assert (instance != 1) is True


@BOTH
def test_attributes_are_passed_by_position_by_name_and_by_default(module: ModuleType) -> None:
    Point = point(module)
    points = (Point(1), Point(1, 2), Point(y=2, x=1), Point(1, 2, [3]))
    assert [(instance.x, instance.y, instance.near) for instance in points] == [
        (1, 0, []), (1, 2, []), (1, 2, []), (1, 2, [3]),
    ]  # fmt: skip
    assert Point(1).near is not Point(1).near
    assert Point.kind == "point"


@BOTH
@pytest.mark.parametrize(("arguments", "names"), [((), {}), ((1, 2, [], 4), {}), ((1,), {"z": 1}), ((1,), {"x": 1})])
def test_what_the_constructor_does_not_take_is_refused(module: ModuleType, arguments: Any, names: Any) -> None:
    with pytest.raises(TypeError):
        point(module)(*arguments, **names)


@BOTH
def test_objects_are_equal_if_their_classes_and_compared_attributes_are(module: ModuleType) -> None:
    Point = point(module)
    assert Point(1, 2, [3]) == Point(1, 2, [4])
    assert hash(Point(1, 2, [3])) == hash(Point(1, 2, [4]))
    assert Point(1, 2) != Point(2, 1)
    assert Point(1, 2) != (1, 2, [])
    assert Point(1) != point(module)(1)


@BOTH
def test_frozen_objects_refuse_changes(module: ModuleType) -> None:
    instance = point(module)(1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        instance.x = 2
    with pytest.raises(dataclasses.FrozenInstanceError):
        del instance.x
    with pytest.raises((dataclasses.FrozenInstanceError, AttributeError, TypeError)):
        instance.other = 2
    assert not hasattr(instance, "__dict__")
    assert instance.x == 1


@BOTH
def test_objects_that_are_not_frozen_change_and_have_no_hash(module: ModuleType) -> None:
    Counter = counter(module)
    instance = Counter()
    instance.value += 1
    assert instance.value == 1
    assert instance == Counter(1)
    with pytest.raises(TypeError):
        hash(instance)


@BOTH
def test_a_class_inherits_attributes_and_keeps_methods_of_its_own(module: ModuleType) -> None:
    _, child = named(module)
    instance = child(3, name="a")
    assert (instance.name, instance.label, instance.number, instance.doubled, repr(instance)) == (
        "a",
        "",
        3,
        6,
        "<a 3>",
    )
    assert module.replace(instance, label="b") == child(3, name="a", label="b")
    with pytest.raises(TypeError):
        child(3, "a")


@BOTH
def test_an_object_is_shown_as_the_call_that_makes_it(module: ModuleType) -> None:
    assert repr(point(module)(1, 2)).endswith("Point(x=1, y=2)")


@BOTH
def test_copies_differ_in_what_is_changed_only(module: ModuleType) -> None:
    instance = point(module)(1, 2, [3])
    assert (instance.moved(4).x, instance.moved(4).y, instance.moved(4).near) == (5, 2, [3])
    assert copy.deepcopy(instance) == instance
    with pytest.raises(TypeError):
        module.replace(instance, z=1)


@BOTH
def test_objects_match_patterns_by_position(module: ModuleType) -> None:
    Point = point(module)
    match Point(1, 2):
        case Point(x, y):
            assert (x, y) == (1, 2)


@classes.dataclass(frozen=True, slots=True)
class Note:
    """A class at the top level of a module, so that it can be pickled."""

    text: str


def test_objects_can_be_pickled() -> None:
    assert pickle.loads(pickle.dumps(Note("a"))) == Note("a")


def test_the_standard_library_accepts_them_as_dataclasses() -> None:
    Point = point(classes)
    assert dataclasses.is_dataclass(Point)
    assert [field.name for field in dataclasses.fields(Point)] == list(classes.attributes(Point)) == ["x", "y", "near"]
    assert dataclasses.asdict(Point(1, 2, [3])) == {"x": 1, "y": 2, "near": [3]}
    assert dataclasses.replace(Point(1), y=5) == Point(1, 5)
