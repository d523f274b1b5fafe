"""A cache by identity knows the objects that it has seen, and no others that are equal to them."""

from __future__ import annotations

import gc

import pytest

from fieldspec.foundation.caches import ByIdentity, ObjectsKey


def test_an_equal_object_is_another_key() -> None:
    first, equal = [1], [1]
    cache: ByIdentity[list[int], str] = ByIdentity()
    cache[first] = "first"
    assert first in cache
    assert equal not in cache
    with pytest.raises(KeyError):
        cache[equal]


def test_a_value_is_computed_once_for_each_object() -> None:
    calls = []
    cache: ByIdentity[list[int], int] = ByIdentity()
    for key in ([1, 2], [3]):
        for _ in range(2):
            assert cache.get_or_compute(key, lambda numbers: calls.append(numbers) or sum(numbers)) == 3
    assert calls == [[1, 2], [3]]


def test_no_other_object_gets_the_identity_of_a_key() -> None:
    cache: ByIdentity[list[int], int] = ByIdentity()
    for number in range(1000):
        assert cache.get_or_compute([number], lambda numbers: numbers[0]) == number
        gc.collect(0)


def test_the_oldest_entry_goes_where_there_are_too_many() -> None:
    keys = [[number] for number in range(3)]
    cache: ByIdentity[list[int], int] = ByIdentity(limit=2)
    for key in keys:
        cache[key] = key[0]
    assert [key in cache for key in keys] == [False, True, True]
    cache[keys[1]] = 7
    assert [cache[key] for key in keys[1:]] == [7, 2]


def test_a_key_of_several_objects_is_equal_only_for_the_same_objects() -> None:
    first, second = [1], [1]
    assert ObjectsKey([first, second]) == ObjectsKey([first, second])
    assert hash(ObjectsKey([first, second])) == hash(ObjectsKey([first, second]))
    assert ObjectsKey([first, second]) != ObjectsKey([second, first])
    assert ObjectsKey([first]) != ObjectsKey([first, second])
