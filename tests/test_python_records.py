"""The generated records against the reference codec, on random values and on random bytes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference.records import decoded, encoded
from layouts import all_layouts
from python_package import built, module_of, only_stored, outcome, raws, record_class
from random_values import bytes_of, values_of

EXAMPLE_COUNT = 150
LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts()}
EACH = pytest.mark.parametrize("name", LAYOUTS)


def records(layout: DeviceLayout) -> list[RecordLayout]:
    """All records, and the data of all messages."""
    data = [side for message in layout.messages.values() for side in message.bodies]
    return [*layout.records.values(), *data]


@pytest.mark.proof(8)
@EACH
@examples(EXAMPLE_COUNT)
@given(data=st.data())
def test_values_become_the_bytes_of_the_reference_or_are_refused_by_both(name: str, data: st.DataObject) -> None:
    layout = LAYOUTS[name]
    record = data.draw(st.sampled_from(records(layout)))
    values = data.draw(values_of(layout, record))
    instance = built(module_of(layout), layout, record, values)
    actual = outcome(instance.encode)
    assert actual == outcome(lambda: encoded(record, values, layout.device))
    if not actual[0]:
        data_again = type(instance).decode(instance.encode()).encode()
        assert data_again == instance.encode()


@pytest.mark.proof(8)
@EACH
@examples(EXAMPLE_COUNT)
@given(data=st.data())
def test_bytes_become_the_values_of_the_reference_or_are_refused_by_both(name: str, data: st.DataObject) -> None:
    layout = LAYOUTS[name]
    record = data.draw(st.sampled_from(records(layout)))
    drawn_bytes = data.draw(bytes_of(record))
    cls = record_class(module_of(layout), record)
    expected = outcome(lambda: only_stored(record, decoded(record, drawn_bytes, layout.device)))
    for form in (drawn_bytes, bytearray(drawn_bytes), memoryview(drawn_bytes)):
        assert outcome(lambda form=form: raws(cls.decode(form), record)) == expected
