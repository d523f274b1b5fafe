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
    **dict.fromkeys(("instPanel.Servo", "instPanel.Home", "instPanel.MoveAbsolute", "instPanel.Stop"), "bool"),
    "instPanel.Position": "dint",
    **dict.fromkeys(
        ("instPanel.Velocity", "instPanel.Acceleration", "instPanel.Deceleration", "instPanel.SpeedOverride"), "lreal"
    ),
    "instInput.returned": "int",
    "instOutput.returned": "int",
    "instInput.statBytes": ("array", 0, 23, "byte"),
    "statAxis/request.velocityOverride": "uint",
}
OUTPUTS = {
    "instPanel.Ready": "bool",
    "instPanel.Status": "word",
    "status": "word",
    "diagnostics": "int",
    "statAxis/valid": "bool",
    "instInput.error": "bool",
    "instInput.diagnostics": "int",
    "instInput.lastFault": "int",
    "instOutput.error": "bool",
    "instOutput.diagnostics": "int",
    "instOutput.lastFault": "int",
}


def standing() -> bytes:
    """The response of a drive that stands and is off, by the reference."""
    layout = newest(SPECS, "hiwin-e")
    names = [field.name for field in layout.messages["telegram_111"].response.fields]
    return codec(layout).links["cyclic"].encode("response", "telegram_111", dict.fromkeys(names, 0))


class Walk:
    """The walk between two scans: `inputs` and `outputs` by their names."""

    def __init__(self, folder: Path) -> None:
        adapters = "".join(siemens(SIEMENS[f"HiwinE_Telegram111{way}"]) for way in ("Input", "Output"))
        block = siemens(SIEMENS["HiwinE_Telegram111Program"])
        types = needed(siemens_types("hiwin-e"), called_in(adapters + block))
        unit = parsed(needed(types, ()))
        program = Block("HiwinE_Telegram111Program", tuple(INPUTS.items()), tuple(OUTPUTS.items()))
        self._program = Compiled(named(types + adapters + block), folder, program, unit)
        self.restart()

    def restart(self) -> None:
        """Switches the controller on; the drive stands, without an alarm, and is off."""
        self._program.restart()
        self.inputs: dict[str, Any] = {name: self._program.fresh(kind) for name, kind in INPUTS.items()}
        self.inputs["instInput.statBytes"] = list(standing())
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
    names = ("statAxis/valid", "instInput.error", "instOutput.error", "status", "diagnostics")
    assert walk.show(*names) == [True, False, False, 0, 0]


@pytest.mark.parametrize("code", DPRD_DAT)
def test_a_code_of_dprd_dat_makes_the_telegram_invalid_and_is_shown(code: int, walk: Walk) -> None:
    walk.scan(instInput__returned=signed(code))
    names = ("statAxis/valid", "instInput.error", "instInput.diagnostics", "instOutput.error", "status", "diagnostics")
    assert walk.show(*names) == [False, True, signed(code), False, 0x8600, signed(code)]


@pytest.mark.parametrize("code", DPWR_DAT)
def test_a_code_of_dpwr_dat_makes_the_next_telegram_invalid_and_is_shown(code: int, walk: Walk) -> None:
    walk.scan(instOutput__returned=signed(code)).scan()
    names = ("statAxis/valid", "instInput.error", "instOutput.diagnostics", "instOutput.error", "status", "diagnostics")
    assert walk.show(*names) == [False, False, signed(code), True, 0x8601, signed(code)]


def test_a_line_that_is_back_is_valid_by_itself_and_its_fault_stays_to_be_seen(walk: Walk) -> None:
    walk.scan(3, instInput__returned=signed(0x80A0), instOutput__returned=signed(0x80A1))
    walk.scan(3, instInput__returned=0, instOutput__returned=0)
    names = ("statAxis/valid", "instInput.error", "instOutput.error", "instInput.lastFault", "instOutput.lastFault")
    assert walk.show(*names) == [True, False, False, signed(0x80A0), signed(0x80A1)]


def test_a_request_that_cannot_be_packed_is_shown_and_makes_the_next_telegram_invalid(walk: Walk) -> None:
    walk.scan(2, **{"statAxis/request.velocityOverride": 40000})
    assert walk.show("instOutput.error", "instOutput.diagnostics", "statAxis/valid") == [True, 10, False]


@pytest.mark.parametrize("way", ["instInput", "instOutput"])
def test_a_block_that_works_while_a_telegram_fails_ends_with_error_7(way: str, walk: Walk) -> None:
    walk.scan(3, instPanel__Servo=True)
    assert walk.show("instPanel.Status") == [0]
    walk.scan(2, **{f"{way}__returned": signed(0x80A0)})
    assert walk.show("instPanel.Status") == [0x8600 + 7]


def test_the_error_of_the_walk_goes_with_that_of_its_block(walk: Walk) -> None:
    walk.scan(2, instPanel__MoveAbsolute=True)
    assert walk.show("instPanel.Status") != [0]
    walk.scan(2, instPanel__MoveAbsolute=False)
    assert walk.show("instPanel.Status") == [0]
