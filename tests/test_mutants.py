"""Slips in the specs of the four devices are noticed: a fixed sample of what `make mutants` tries."""

from __future__ import annotations

from functools import cache

import pytest

from mutants import DEVICES, files, judged, right
from spec_mutants import KINDS, Slip, scalars, slips

ALWAYS_NOTICED = ("address", "code", "order", "enum value", "bit", "checksum")
"""The kinds of slips of which `docs/trust.md` says that all are noticed."""


@cache
def sample(device: str) -> list[Slip]:
    return [slip for slip in slips(right(device), 1) if slip.kind in ALWAYS_NOTICED]


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", DEVICES)
def test_slips_in_facts_that_are_printed_twice_or_proven_are_noticed(device: str) -> None:
    verdicts = [judged(device, slip) for slip in sample(device)]
    assert len(verdicts) >= 3
    assert [verdict.slip for verdict in verdicts if verdict is not None and not verdict.judge] == []


def test_a_slip_that_contradicts_nothing_is_not_noticed() -> None:
    path, text = "tc100/registers-motion.yaml", files()["tc100/registers-motion.yaml"].decode()
    start = text.index("access: wo", text.index("0x999B")) + len("access: ")
    slip = Slip("access", path, start, start + 2, 0, "access", "wo", "rw")
    verdict = judged("tc100", slip)
    assert verdict is not None
    assert (verdict.wire, verdict.judge) == (True, "")


def test_a_change_of_nothing_is_no_slip() -> None:
    path, text = "tc100/registers-motion.yaml", files()["tc100/registers-motion.yaml"].decode()
    start = text.index("0x201E")
    assert judged("tc100", Slip("address", path, start, start + 6, 0, "at", "0x201E", "8222")) is None


def test_there_are_facts_of_every_kind() -> None:
    assert {kind for device in DEVICES for kind, _, _, _ in scalars(right(device))} == set(KINDS)


def test_the_same_seed_gives_the_same_slips() -> None:
    assert slips(right("esc11"), 2) == slips(right("esc11"), 2) != slips(right("esc11"), 2, seed=2)
