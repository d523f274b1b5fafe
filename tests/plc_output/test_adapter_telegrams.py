"""The program for telegram 111 runs, compiled, with its adapters: every code of DPRD_DAT and DPWR_DAT is shown."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import SIEMENS, called_in, siemens, siemens_types
from compiled import Block, Compiled
from loaded import programs
from st_syntax import parsed
from standard_text import named, needed
from vendor_codes import DPRD_DAT, DPWR_DAT

from fieldspec.codec.reference import codec
from layouts import SPECS, newest

INPUTS = {
    **dict.fromkeys(("panel.Servo", "panel.Home", "panel.MoveAbsolute", "panel.Stop"), "bool"),
    "panel.Position": "dint",
    **dict.fromkeys(("panel.Velocity", "panel.Acceleration", "panel.Deceleration", "panel.SpeedOverride"), "lreal"),
    "input.returned": "int",
    "output.returned": "int",
    "input.bytes": ("array", 0, 23, "byte"),
    "axis/request.velocityOverride": "uint",
}
OUTPUTS = {
    "panel.Ready": "bool",
    "panel.Status": "word",
    "status": "word",
    "diagnostics": "int",
    "axis/valid": "bool",
    "input.error": "bool",
    "input.readResult": "int",
    "input.lastFault": "int",
    "output.error": "bool",
    "output.writeResult": "int",
    "output.packStatus": "uint",
    "output.lastFault": "int",
}


def standing() -> bytes:
    """The response of a drive that stands and is off, by the reference."""
    layout = newest(SPECS, "hiwin-e")
    names = [field.name for field in layout.messages["telegram_111"].response.fields]
    return codec(layout).links["cyclic"].encode("response", "telegram_111", dict.fromkeys(names, 0))


class Walk:
    """The walk between two scans: `inputs` and `outputs` by their names."""

    def __init__(self, folder: Path) -> None:
        adapters = "".join(siemens(SIEMENS[f"HiwinETelegram111{way}"]) for way in ("Input", "Output"))
        block = siemens(SIEMENS["HiwinETelegram111Program"])
        types = needed(siemens_types("hiwin-e"), called_in(adapters + block))
        unit = parsed(needed(types, ()))
        program = Block("HiwinETelegram111Program", tuple(INPUTS.items()), tuple(OUTPUTS.items()))
        self._program = Compiled(named(types + adapters + block), folder, program, unit)
        self.restart()

    def restart(self) -> None:
        """Switches the controller on; the drive stands, without an alarm, and is off."""
        self._program.restart()
        self.inputs: dict[str, Any] = {name: self._program.fresh(kind) for name, kind in INPUTS.items()}
        self.inputs["input.bytes"] = list(standing())
        self.outputs: dict[str, Any] = {}

    def scan(self, scans: int = 1, **inputs: Any) -> Walk:
        """Sets inputs, `__` for a point, and runs some scans."""
        self.inputs |= {name.replace("__", "."): value for name, value in inputs.items()}
        for _ in range(scans):
            self.outputs = dict(zip(OUTPUTS, self._program.scan(4, [*self.inputs.values()]), strict=True))
        return self

    def show(self, *names: str) -> list[Any]:
        """Some outputs."""
        return [self.outputs[name] for name in names]


@cache
def compiled_walk(folder: Path) -> Walk:
    """The walk, which is compiled once."""
    return Walk(folder)


@pytest.fixture
def walk(tmp_path_factory: pytest.TempPathFactory) -> Walk:
    """The walk, just switched on."""
    result = compiled_walk(programs(tmp_path_factory))
    result.restart()
    return result.scan(3)


def signed(code: int) -> int:
    """A return value as an INT."""
    return code - 0x10000


def test_a_telegram_that_arrives_is_valid(walk: Walk) -> None:
    names = ("axis/valid", "input.error", "output.error", "status", "diagnostics")
    assert walk.show(*names) == [True, False, False, 0, 0]


@pytest.mark.parametrize("code", DPRD_DAT)
def test_a_code_of_dprd_dat_makes_the_telegram_invalid_and_is_shown(code: int, walk: Walk) -> None:
    walk.scan(input__returned=signed(code))
    names = ("axis/valid", "input.error", "input.readResult", "output.error", "status", "diagnostics")
    assert walk.show(*names) == [False, True, signed(code), False, 0x8600, signed(code)]


@pytest.mark.parametrize("code", DPWR_DAT)
def test_a_code_of_dpwr_dat_makes_the_next_telegram_invalid_and_is_shown(code: int, walk: Walk) -> None:
    walk.scan(output__returned=signed(code)).scan()
    names = ("axis/valid", "input.error", "output.writeResult", "output.error", "status", "diagnostics")
    assert walk.show(*names) == [False, False, signed(code), True, 0x8601, signed(code)]


def test_a_line_that_is_back_is_valid_by_itself_and_its_fault_stays_to_be_seen(walk: Walk) -> None:
    walk.scan(3, input__returned=signed(0x80A0), output__returned=signed(0x80A1))
    walk.scan(3, input__returned=0, output__returned=0)
    names = ("axis/valid", "input.error", "output.error", "input.lastFault", "output.lastFault")
    assert walk.show(*names) == [True, False, False, signed(0x80A0), signed(0x80A1)]


def test_a_request_that_cannot_be_packed_is_shown_and_makes_the_next_telegram_invalid(walk: Walk) -> None:
    walk.scan(2, **{"axis/request.velocityOverride": 40000})
    assert walk.show("output.error", "output.packStatus", "output.writeResult", "axis/valid") == [True, 10, 0, False]


@pytest.mark.parametrize("way", ["input", "output"])
def test_a_block_that_works_while_a_telegram_fails_ends_with_error_7(way: str, walk: Walk) -> None:
    walk.scan(3, panel__Servo=True)
    assert walk.show("panel.Status") == [0]
    walk.scan(2, **{f"{way}__returned": signed(0x80A0)})
    assert walk.show("panel.Status") == [0x8600 + 7]


def test_the_error_of_the_walk_goes_with_that_of_its_block(walk: Walk) -> None:
    walk.scan(2, panel__MoveAbsolute=True)
    assert walk.show("panel.Status") != [0]
    walk.scan(2, panel__MoveAbsolute=False)
    assert walk.show("panel.Status") == [0]
