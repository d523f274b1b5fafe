"""The adapters of frames run, compiled: every error of their ports, and answers that are late, long, cut or silent."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_stands import Adapter, Stand
from adapter_texts import CODESYS as TEXTS
from adapter_texts import standard
from compiled import Block, Compiled
from loaded import programs
from st_syntax import parsed
from standard_text import named
from vendor_blocks import ALL
from vendor_codes import CAA_SERIAL_COM, COM_ERROR, PORT_CONFIG, RECEIVE_P2P, SEND_P2P

LINE = ("array", 0, 254, "byte")
CODESYS = Adapter(
    *("FB_Tc100_SerialPort", "tc100", "Frames", "ST_Tc100_Frames", "Port := 7"),
    {"Open": "bool", "fbRead.Line": LINE, "fbRead.Arrived": "int", "fbRead.Taken": "int", "fbRead.Waits": "bool"}
    | {"fbRead.Answer": "uint", "fbWrite.Answer": "uint"},
    {"fbWrite.Requests": "int", "iStep": "int", "Diagnostics": "uint", "Lost": "bool"},
    milliseconds=5,
)
TWINCAT = Adapter(
    *("FB_Esc11_SerialPort", "esc11", "Frames", "ST_Esc11_Frames", "Pause := T#200ms"),
    {"fbReceive.Line": LINE, "fbReceive.Arrived": "int", "fbReceive.Taken": "int", "fbReceive.Answer": "int"}
    | {"fbSend.Answer": "int", "fbSend.Full": "bool", "iLineError": "int"},
    {"fbSend.Requests": "int", "iStep": "int", "Diagnostics": "int"},
)
SIEMENS = Adapter(
    *("Esc11_PointToPoint", "esc11", "frames", "typeEsc11Frames", "pause := T#200ms"),
    {"instReceive.Line": LINE, "instReceive.Arrived": "int", "instReceive.Taken": "int", "instReceive.Answer": "word"}
    | {"instSend.Answer": "word", "instConfig.Answer": "word", "instReset.Answer": "word", "setUp": "bool"},
    {"instSend.Requests": "int", "instReset.Requests": "int", "instConfig.Requests": "int", "statPhase": "int"}
    | {"status": "word", "ready": "bool"},
)
ADAPTERS = {"codesys": CODESYS, "twincat": TWINCAT, "siemens": SIEMENS}
RECEIVERS = {"codesys": "fbRead", "twincat": "fbReceive", "siemens": "instReceive"}
STEPS = {"codesys": ("iStep", 3), "twincat": ("iStep", 3), "siemens": ("statPhase", 4)}
"""The step in which an adapter waits for the answer."""
SENT = {"codesys": "fbWrite.Requests", "twincat": "fbSend.Requests", "siemens": "instSend.Requests"}


@cache
def stand_of(name: str, folder: Path) -> Stand:
    """The stand of an adapter, which is compiled once."""
    return Stand(ADAPTERS[name], folder)


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.fixture(params=ADAPTERS)
def name(request: pytest.FixtureRequest) -> str:
    """Each adapter."""
    return str(request.param)


class Line:
    """A stand with a device on its line: `answer` comes `delay` ms after the request, at `rate` bytes a millisecond.

    A module of an S7 gives an answer when it is whole.
    """

    def __init__(self, name: str, folder: Path, answer: bytes = b"", delay: int = 0, rate: float = 0.87) -> None:
        self.stand, self.name, self.answer, self.delay, self.rate = stand_of(name, folder), name, answer, delay, rate
        self.receiver = RECEIVERS[name]
        self.stand.restart()
        if name == "codesys":
            self.stand.set(Open=True)
        self.stand.run(20)
        self.waited = 0

    def put(self, **values: object) -> Line:
        """Sets variables of the adapter."""
        self.stand.set(**values)
        return self

    def scan(self) -> None:
        """What comes on the line in one cycle."""
        variable, step = STEPS[self.name]
        if self.stand.get(variable) == step:
            self.waited += self.stand.adapter.milliseconds
        come = max(0, min(len(self.answer), int((self.waited - self.delay) * self.rate)))
        if self.name == "siemens" and come < len(self.answer):
            come = 0
        if self.waited:
            line = [*self.answer, *bytes(255 - len(self.answer))]
            self.stand.set(**{f"{self.receiver}__Line": line, f"{self.receiver}__Arrived": come})
        type(self.stand).scan(self.stand)

    def ask(self, request: bytes = bytes.fromhex("04 00 4E 52"), until: Callable[[], bool] | None = None) -> int:
        """Sends a request as a block does; gives the error of the answer."""
        stand = self.stand
        stand.put(send=len(request), frame=[*request, *stand.of("frame")[len(request) :]], received=0)
        stand.ask()
        for _ in range(600):
            self.scan()
            if stand.of("state") == 2 or (until is not None and until()):
                assert stand.of("answered") == stand.of("request")
                stand.put(state=0)
                return int(stand.of("error"))
        raise AssertionError("there is no answer")

    @property
    def received(self) -> bytes:
        """The bytes of the answer."""
        return bytes(self.stand.of("frame")[: self.stand.of("received")])


def packet(size: int) -> bytes:
    """A packet whose first byte is its length."""
    return bytes([size, *(at % 251 for at in range(1, size))])


@pytest.mark.proof(9)
@pytest.mark.parametrize("size", [4, 60, 244])
@pytest.mark.parametrize("delay", [0, 400, 590])
def test_an_answer_is_taken_whole_however_long_and_late_it_is(name: str, size: int, delay: int, folder: Path) -> None:
    if name == "codesys":  # its device answers sooner
        delay = delay * 2 // 3
    line = Line(name, folder, packet(size), delay)
    assert (line.ask(), line.received) == (0, packet(size))


def test_silence_is_no_answer_in_time(name: str, folder: Path) -> None:
    line = Line(name, folder)
    assert line.ask() == 2


def test_an_answer_that_ends_too_soon_is_handed_over_as_it_is(name: str, folder: Path) -> None:
    line = Line(name, folder, packet(20)[:7], 100)
    assert (line.ask(), line.received) == (0, packet(20)[:7])


def test_the_next_request_works_after_a_silence(name: str, folder: Path) -> None:
    line = Line(name, folder)
    line.ask()
    line.answer, line.waited = packet(5), 0
    line.put(**{f"{line.receiver}__Taken": 0})
    assert (line.ask(), line.received) == (0, packet(5))


@pytest.mark.parametrize(
    ("name", "sent", "count"),
    [("codesys", "fbWrite.Requests", 2), ("twincat", "fbSend.Requests", 8), ("siemens", "instSend.Requests", 2)],
)
def test_a_frame_that_replaces_another_is_sent_itself(name: str, sent: str, count: int, folder: Path) -> None:
    line = Line(name, folder)
    line.stand.put(send=4)
    line.stand.ask()
    line.stand.run(4)
    line.stand.put(state=0)
    line.ask()
    assert line.stand.get(sent) == count


# CODESYS


@pytest.mark.parametrize("waits", [False, True], ids=["done without bytes", "error 5001"])
def test_a_read_without_bytes_is_no_error(waits: bool, folder: Path) -> None:
    line = Line("codesys", folder, packet(60), 200).put(fbRead__Waits=waits)
    assert (line.ask(), line.received) == (0, packet(60))


def test_a_slow_line_is_no_end_of_the_answer(folder: Path) -> None:
    line = Line("codesys", folder, packet(30), 50, rate=0.06).put(fbRead__Waits=True)
    assert (line.ask(), line.received) == (0, packet(30))


@pytest.mark.parametrize("code", CAA_SERIAL_COM)
@pytest.mark.parametrize("block", ["fbRead", "fbWrite"])
def test_an_error_of_the_com_port_is_one_of_the_port(block: str, code: int, folder: Path) -> None:
    line = Line("codesys", folder, packet(4), 50).put(**{f"{block}__Answer": code})
    assert (line.ask(), line.stand.get("Diagnostics")) == (7, code)


def test_a_write_that_takes_too_long_is_an_error_of_the_port(folder: Path) -> None:
    line = Line("codesys", folder).put(fbWrite__Answer=5001)
    assert (line.ask(), line.stand.get("Diagnostics")) == (7, 5001)


def test_a_port_that_is_not_open_is_an_error_of_the_port_at_once(folder: Path) -> None:
    line = Line("codesys", folder).put(Open=False)
    scans = []
    assert line.ask(until=lambda: bool(scans.append(1))) == 7
    assert (len(scans) < 3, line.stand.get("fbWrite.Requests")) == (True, 0)


# TwinCAT


@pytest.mark.parametrize("code", COM_ERROR)
@pytest.mark.parametrize("block", ["fbSend", "fbReceive"])
def test_an_error_of_the_serial_library_is_one_of_the_port(block: str, code: int, folder: Path) -> None:
    line = Line("twincat", folder).put(**{f"{block}__Answer": code})
    assert (line.ask(), line.stand.get("Diagnostics")) == (7, code)


@pytest.mark.parametrize("code", COM_ERROR)
def test_an_error_of_the_line_in_another_task_is_one_of_the_port(code: int, folder: Path) -> None:
    line = Line("twincat", folder)

    def broken() -> bool:
        if line.stand.get("iStep") == 3:
            line.put(iLineError=code)
        return False

    assert (line.ask(until=broken), line.stand.get("Diagnostics")) == (7, code)


def test_an_error_of_the_line_before_a_request_is_forgotten(folder: Path) -> None:
    line = Line("twincat", folder, packet(4), 50).put(iLineError=2)
    assert line.ask() == 0


def test_a_buffer_that_stays_full_is_an_error_of_the_port(folder: Path) -> None:
    assert Line("twincat", folder).put(fbSend__Full=True).ask() == 7


def test_a_long_answer_takes_no_longer_than_on_the_line(folder: Path) -> None:
    line = Line("twincat", folder, packet(244), 400)
    line.ask()
    assert line.waited <= 400 + 244 / line.rate + 5 * line.stand.adapter.milliseconds


def test_a_long_request_is_sent_in_one_cycle(folder: Path) -> None:
    line = Line("twincat", folder, packet(4), 50)
    line.ask(packet(244))
    assert line.stand.get("fbSend.Requests") == 244


# S7


@pytest.mark.parametrize(("code", "error"), RECEIVE_P2P.items(), ids=[f"{code:X}" for code in RECEIVE_P2P])
def test_a_code_of_receive_p2p_becomes_its_error(code: int, error: int, folder: Path) -> None:
    line = Line("siemens", folder).put(instReceive__Answer=code)
    assert (line.ask(), line.stand.get("status")) == (error, code)


@pytest.mark.parametrize("code", SEND_P2P)
@pytest.mark.parametrize("block", ["instSend", "instReset"])
def test_a_code_of_send_p2p_or_receive_reset_is_an_error_of_the_port(block: str, code: int, folder: Path) -> None:
    line = Line("siemens", folder).put(**{f"{block}__Answer": code})
    assert (line.ask(), line.stand.get("status")) == (7, code)


@pytest.mark.parametrize("code", PORT_CONFIG)
def test_a_code_of_port_config_is_an_error_of_the_port(code: int, folder: Path) -> None:
    line = Line("siemens", folder)
    line.stand.restart()
    line.put(instConfig__Answer=code).stand.scan()
    assert (line.ask(), line.stand.get("status"), line.stand.get("instSend.Requests")) == (7, code, 0)


def test_the_port_is_set_up_at_first_at_an_edge_and_after_its_errors(folder: Path) -> None:
    line = Line("siemens", folder, packet(4), 50)
    assert (line.stand.get("ready"), line.stand.get("instConfig.Requests")) == (True, 1)
    line.put(setUp=True).stand.run(20)
    assert line.stand.get("instConfig.Requests") == 2
    line.put(instSend__Answer=0x8280).ask()
    line.put(instSend__Answer=0).ask()
    assert line.stand.get("instConfig.Requests") == 3


def test_a_frame_that_waits_in_the_module_is_thrown_away_before_a_request(folder: Path) -> None:
    line = Line("siemens", folder, packet(4), 50)
    line.ask()
    assert line.stand.get("instReset.Requests") == line.stand.get("instSend.Requests") == 1


def test_a_request_of_frames_that_is_abandoned_frees_the_port(name: str, folder: Path) -> None:
    line = Line(name, folder)
    line.stand.put(send=4)
    line.stand.abandoned()


@pytest.mark.parametrize("scans", [0, 1])
def test_frames_that_are_not_sent_yet_give_way_to_a_stop(name: str, scans: int, folder: Path) -> None:
    stand = Line(name, folder).stand
    assert stand.gives_way(scans) == 65535
    assert stand.get(SENT[name]) == 0


def test_the_frame_of_a_stop_is_sent(name: str, folder: Path) -> None:
    line = Line(name, folder, packet(4), 50)
    line.stand.put(urgent=6, first=line.stand.of("request") + 1)
    assert line.ask() == 0


def test_a_frame_that_is_abandoned_before_it_is_sent_is_not_sent(name: str, folder: Path) -> None:
    stand = Line(name, folder).stand
    stand.put(send=4)
    stand.ask()
    stand.scan()
    stand.put(state=3)
    stand.run(100)
    assert (stand.of("state"), stand.get(SENT[name])) == (0, 0)


# The program that opens the port of CODESYS


@cache
def opening(folder: Path) -> Compiled:
    """PRG_Tc100_SerialPort; what it gives to the walk is its own."""
    program = standard(TEXTS["PRG_Tc100_SerialPort"])
    program = re.sub(r"PRG_Tc100\.(\w+)", r"\1", program)
    program = program.replace("\nVAR\n", "\nVAR\n    Open : BOOL;\n    Port : UDINT;\n    Lost : BOOL;\n", 1)
    parameter = "TYPE Parameter : STRUCT udiParameterId : UDINT; udiValue : UDINT; END_STRUCT; END_TYPE\n"
    program = program.replace("OF COM.PARAMETER", "OF Parameter")
    outputs = (("Open", "bool"), ("Port", "udint"), ("Error", "bool"), ("Diagnostics", "uint"))
    inputs = (("fbOpen.Answer", "uint"), ("Lost", "bool"), ("fbClose.Answer", "uint"))
    block = Block("PRG_Tc100_SerialPort", inputs, (*outputs, ("fbOpen.Requests", "int"), ("fbClose.Requests", "int")))
    return Compiled(named(parameter + ALL + program), folder, block, parsed(parameter))


def opened(folder: Path, answer: int, scans: int) -> list[object]:
    """The outputs of the program some cycles of 5 ms after the controller was switched on."""
    program = opening(folder)
    program.restart()
    return [program.scan(5, [answer, False, 0]) for _ in range(scans)][-1][:-1]


def test_a_port_that_opens_is_given_to_the_walk(folder: Path) -> None:
    assert opened(folder, 0, 5) == [True, 7, False, 0, 1]


@pytest.mark.parametrize("code", [5001, *CAA_SERIAL_COM])
def test_a_port_that_does_not_open_is_an_error_with_its_reason(code: int, folder: Path) -> None:
    is_open, _, error, reason, _ = opened(folder, code, 5)
    assert (is_open, error, reason) == (False, True, code)


def test_a_port_that_does_not_open_is_tried_again_each_second(folder: Path) -> None:
    assert opened(folder, 5003, 650)[-1] == 4


def test_a_port_that_opens_later_is_no_error_any_more(folder: Path) -> None:
    opened(folder, 5003, 5)
    program = opening(folder)
    assert [program.scan(5, [0, False, 0]) for _ in range(210)][-1] == [True, 7, False, 0, 2, 0]


@pytest.mark.parametrize("closes", [0, 5003])
def test_a_port_that_fails_is_closed_and_opened_again(closes: int, folder: Path) -> None:
    opened(folder, 0, 5)
    program = opening(folder)
    states: list[list[object]] = [program.scan(5, [0, True, closes])]
    while states[-1][0] and len(states) < 250:
        states.append(program.scan(5, [0, True, closes]))
    assert states[-1] == [False, 7, True, 0, 1, 1]
    assert [program.scan(5, [0, False, closes]) for _ in range(3)][-1] == [True, 7, False, 0, 2, 1]


@pytest.mark.parametrize("block", ["fbRead", "fbWrite"])
def test_a_port_whose_calls_fail_is_lost_until_it_is_closed(block: str, folder: Path) -> None:
    line = Line("codesys", folder, packet(4), 50).put(**{f"{block}__Answer": 5003})
    line.ask()
    assert line.stand.get("Lost")
    line.put(Open=False).stand.scan()
    assert not line.stand.get("Lost")


def test_a_read_without_bytes_loses_no_port(folder: Path) -> None:
    line = Line("codesys", folder).put(fbRead__Waits=True)
    assert (line.ask(), line.stand.get("Lost")) == (2, False)
