"""Each code of a vendor's block becomes the right ErrorID: the adapters of the documentation run, compiled."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_stands import Adapter, Stand
from loaded import programs
from vendor_codes import COMM_LOAD, IO_DRV_MODBUS, MODBUS_ERRORS, MODBUS_MASTER

COUNTERS = {"Requests": "int", "Code": "int", "First": "word"}
WORDS = {
    "ModbusRequest": Adapter(
        *("FB_Tc100_ModbusRequest", "tc100", "Axis", "ST_Tc100_Axis", "Station := 3"),
        {"fbRequest.Answer": "int"},
        {f"fbRequest.{name}": kind for name, kind in COUNTERS.items()} | {"Diagnostics": "byte"},
    ),
    "ModbusRtuMasterV2": Adapter(
        *("FB_Tc100_ModbusMaster", "tc100", "Axis", "ST_Tc100_Axis", "Station := BYTE#16#03"),
        {"fbMaster.Answer": "int"},
        {f"fbMaster.{name}": kind for name, kind in COUNTERS.items()} | {"Diagnostics": "int"},
    ),
    "Modbus_Master": Adapter(
        *("Tc100_ModbusMaster", "tc100", "axis", "typeTc100Axis", "station := 3"),
        {"instMaster.Answer": "word", "instLoad.Answer": "word", "setUp": "bool"},
        {f"instMaster.{name}": kind for name, kind in COUNTERS.items()}
        | {
            "status": "word",
            "ready": "bool",
            "instLoad.Requests": "int",
            "instLoad.MODE": "usint",
            "instLoad.RETRIES": "word",
        }
        | {
            "instLoad.PARITY": "uint",
            "instLoad.BAUD": "udint",
            "instLoad.STOP_BITS": "usint",
            "instMaster.STATUS": "word",
        },
    ),
}
"""The adapters of words by the vendor's block."""
BLOCKS = {"ModbusRequest": "fbRequest", "ModbusRtuMasterV2": "fbMaster", "Modbus_Master": "instMaster"}
REASONS = {"ModbusRequest": "Diagnostics", "ModbusRtuMasterV2": "Diagnostics", "Modbus_Master": "status"}
CODES = {"ModbusRequest": IO_DRV_MODBUS, "ModbusRtuMasterV2": MODBUS_ERRORS, "Modbus_Master": MODBUS_MASTER}
EACH = [(block, code, error) for block, codes in CODES.items() for code, error in codes.items()]
NAMES = [f"{block}-{code:X}" for block, code, _ in EACH]
ADDRESS = 0x201E


@cache
def stand_of(block: str, folder: Path) -> Stand:
    """The stand of a vendor's block, which is compiled once."""
    return Stand(WORDS[block], folder)


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.fixture(params=WORDS)
def block(request: pytest.FixtureRequest) -> str:
    """Each of the vendors' blocks."""
    return str(request.param)


def begun(block: str, folder: Path, code: int = 0) -> Stand:
    """A stand whose controller was just switched on, and whose vendor's block ends with a code."""
    stand = stand_of(block, folder)
    stand.restart()
    stand.set(**{f"{BLOCKS[block]}__Answer": code})
    stand.run(20)
    return stand


def requests(stand: Stand, block: str) -> int:
    """How many requests have gone out."""
    return int(stand.get(f"{BLOCKS[block]}.Requests"))


@pytest.mark.parametrize(("block", "code", "error"), EACH, ids=NAMES)
def test_a_code_after_a_write_becomes_its_error(block: str, code: int, error: int, folder: Path) -> None:
    assert begun(block, folder, code).ask_words(write=True) == error


@pytest.mark.parametrize(("block", "code", "error"), EACH, ids=NAMES)
def test_a_code_after_a_read_becomes_its_error(block: str, code: int, error: int, folder: Path) -> None:
    assert begun(block, folder, code).ask_words(write=False) == error


@pytest.mark.parametrize(("block", "code", "error"), EACH, ids=NAMES)
def test_a_write_goes_out_once_whatever_comes_back(block: str, code: int, error: int, folder: Path) -> None:
    stand = begun(block, folder, code)
    stand.ask_words(write=True)
    assert requests(stand, block) == 1


@pytest.mark.parametrize(("block", "code", "error"), EACH, ids=NAMES)
def test_a_read_is_tried_twice_more_unless_the_device_refuses(block: str, code: int, error: int, folder: Path) -> None:
    stand = begun(block, folder, code)
    stand.ask_words(write=False)
    assert requests(stand, block) == (1 if error == 6 else 3)


@pytest.mark.parametrize(("block", "code", "error"), EACH, ids=NAMES)
def test_the_code_of_the_vendor_stays_in_an_output(block: str, code: int, error: int, folder: Path) -> None:
    stand = begun(block, folder, code)
    stand.ask_words(write=True)
    stand.run(5)
    assert stand.get(REASONS[block]) == code


def test_words_of_an_answer_that_fails_never_come_into_the_port(block: str, folder: Path) -> None:
    stand = begun(block, folder, next(code for code, error in CODES[block].items() if error == 4))
    stand.ask_words(write=False, words=(0x5678,))
    assert stand.of("words")[0] == 0x5678


def test_a_read_brings_the_words_of_the_device(block: str, folder: Path) -> None:
    stand = begun(block, folder)
    assert stand.ask_words(write=False) == 0
    assert (stand.of("words")[0], stand.get(f"{BLOCKS[block]}.Code")) == (0x1234, 3)


@pytest.mark.parametrize(("words", "function"), [((0xABCD,), 6), ((0xABCD, 1), 16)])
def test_a_write_sends_its_words_by_the_function_of_their_number(
    block: str, folder: Path, words: tuple[int, ...], function: int
) -> None:
    stand = begun(block, folder)
    assert stand.ask_words(write=True, words=words) == 0
    assert [stand.get(f"{BLOCKS[block]}.{name}") for name in ("First", "Code")] == [0xABCD, function]


def test_a_request_after_one_that_failed_begins_anew(block: str, folder: Path) -> None:
    stand = begun(block, folder, next(iter(CODES[block])))
    stand.ask_words(write=False)
    stand.set(**{f"{BLOCKS[block]}__Answer": 0})
    assert stand.ask_words(write=False) == 0


def test_a_request_that_is_abandoned_frees_the_port(block: str, folder: Path) -> None:
    stand = begun(block, folder)
    stand.put(write=False, address=ADDRESS, count=1)
    stand.abandoned()
    assert stand.ask_words(write=False) == 0


def test_an_answer_to_a_request_that_another_has_replaced_is_not_its_answer(block: str, folder: Path) -> None:
    stand = begun(block, folder)
    stand.put(write=True, address=ADDRESS, count=1)
    stand.ask()
    stand.run(4)
    stand.put(state=0)
    assert (stand.ask_words(write=True), requests(stand, block)) == (0, 2)


@pytest.mark.parametrize("scans", [0, 1])
def test_words_that_are_not_sent_yet_give_way_to_a_stop(block: str, scans: int, folder: Path) -> None:
    stand = begun(block, folder)
    assert stand.gives_way(scans) == 65535
    assert requests(stand, block) == 0


def test_words_of_a_stop_are_sent(block: str, folder: Path) -> None:
    stand = begun(block, folder)
    stand.put(urgent=6, first=stand.of("request") + 1)
    assert (stand.ask_words(write=True), requests(stand, block)) == (0, 1)


def test_words_that_are_abandoned_before_they_are_sent_are_not_sent(block: str, folder: Path) -> None:
    stand = begun(block, folder)
    stand.put(write=True, address=ADDRESS, count=1)
    stand.ask()
    stand.scan()
    stand.put(state=3)
    stand.run(20)
    assert (stand.of("state"), requests(stand, block)) == (0, 0)


# The port of an S7


def test_the_port_is_set_up_in_the_first_cycles(folder: Path) -> None:
    stand = begun("Modbus_Master", folder)
    assert (stand.get("ready"), stand.get("instLoad.Requests")) == (True, 1)


def test_the_port_is_half_duplex_without_parity_and_without_repetitions(folder: Path) -> None:
    stand = begun("Modbus_Master", folder)
    names = ("MODE", "RETRIES", "PARITY", "BAUD", "STOP_BITS")
    assert [stand.get(f"instLoad.{name}") for name in names] == [4, 0, 0, 19200, 1]


def test_an_edge_sets_the_port_up_once_more(folder: Path) -> None:
    stand = begun("Modbus_Master", folder)
    stand.set(setUp=True)
    stand.run(40)
    assert stand.get("instLoad.Requests") == 2


@pytest.mark.parametrize(("code", "loads"), [(0x8280, 2), (0x80C9, 2), (0x80C8, 1), (0x8381, 1)])
def test_the_port_is_set_up_again_where_it_may_have_lost_its_settings(code: int, loads: int, folder: Path) -> None:
    stand = begun("Modbus_Master", folder, code)
    stand.ask_words(write=True)
    stand.set(instMaster__Answer=0)
    assert stand.ask_words(write=True) == 0
    assert stand.get("instLoad.Requests") == loads


@pytest.mark.parametrize("code", COMM_LOAD)
def test_a_port_that_cannot_be_set_up_is_an_error_of_the_port(code: int, folder: Path) -> None:
    stand = begun("Modbus_Master", folder)
    stand.restart()
    stand.set(instLoad__Answer=code)
    assert stand.ask_words(write=True) == 7
    assert (stand.get("status"), stand.get("instMaster.Requests"), stand.get("ready")) == (code, 0, False)


def test_the_status_outlives_the_cycle_in_which_it_is_valid(folder: Path) -> None:
    stand = begun("Modbus_Master", folder, 0x8383)
    stand.ask_words(write=True)
    stand.set(instMaster__Answer=0)
    stand.ask_words(write=True)
    assert (stand.get("instMaster.STATUS"), stand.get("status")) == (0, 0x8383)
