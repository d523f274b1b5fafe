"""Generated clients say what is wrong with a call before anything is sent."""

from __future__ import annotations

import importlib
import json
import subprocess
from collections.abc import Callable
from typing import Any

import pytest

from external_tools import require_tool
from js_output.javascript import module_path
from layouts import TEST_SPECS, newest
from python_package import module_of, runtime

WIDGET = newest(TEST_SPECS, "widget")
CODEC = module_of(WIDGET)
CLIENT = importlib.import_module(f"{CODEC.__package__}.client")
ERRORS = runtime("errors")


class Silence:
    """A transport on which nothing may be sent."""

    def read(self, size: int) -> bytes:
        """No bytes."""
        return b""

    def write(self, data: bytes) -> None:
        """Refuses all bytes."""
        raise AssertionError(data.hex())


class ClosedPort(Silence):
    """A port that refuses to drop what it has received."""

    def reset_input_buffer(self) -> None:
        """Fails, as a closed port does."""
        raise OSError("the port is closed")


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda client: client.read("lamp"), "'lamp' is not a register: pass a constant of the device, not its name"),
        (lambda client: client.read(CODEC.points), r"points has several registers: pass one of them, such as \[1\]"),
        (lambda client: client.read_in_unit(CODEC.OUTPUT), r"output has several registers: .*\[1\]"),
        (lambda client: client.write(CODEC.points, 1), "points has several registers"),
        (lambda client: client.write_in_unit("lamp", 1), "'lamp' is not a register"),
        (lambda client: client.read_table(CODEC.LAMP), "lamp at 0x2000> is not a table of records"),
        (lambda client: client.read_group([CODEC.LAMP]), "is not a group: pass one of the module of the client"),
        (lambda client: client.read_parameter("stroke"), "'stroke' is not a parameter: pass a constant"),
        (lambda client: client.write_parameter_in_unit("stroke", 1), "'stroke' is not a parameter"),
    ],
)
def test_a_client_refuses_what_is_no_single_value_of_the_device(call: Callable[[Any], object], text: str) -> None:
    client = CLIENT.Client(Silence(), unit_address=1)
    with pytest.raises(ERRORS.InvalidValueError, match=text):
        call(client)


def test_a_client_names_the_links_of_the_device() -> None:
    with pytest.raises(ValueError, match="there is no link 'rs485'; known are rtu, ascii"):
        CLIENT.Client(Silence(), link="rs485", unit_address=1)


def test_a_closed_port_is_an_error_of_the_transport() -> None:
    client = CLIENT.Client(ClosedPort(), unit_address=1)
    with pytest.raises(ERRORS.TransportError, match="the port is closed"):
        client.read(CODEC.LAMP)


def test_javascript_refuses_responses_without_words_and_several_registers() -> None:
    program = f"""
    import * as widget from "{module_path(WIDGET)}";
    const calls = [
      () => widget.readValue(widget.LAMP, {{ kind: "response", data: {{ values: [1] }} }}),
      () => widget.readRequests(widget.POINTS),
      () => widget.readRequests("lamp"),
    ];
    const outcome = (call) => {{ try {{ return call(); }} catch (error) {{ return error.message; }} }};
    console.log(JSON.stringify(calls.map(outcome)));
    """
    command = [require_tool("node"), "--input-type=module", "--eval", program]
    output = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert output == [
        "missing_value: values is missing: pass the data of the response that reads lamp",
        "wrong_type: points has several registers: pass one of them, such as at(1)",
        "wrong_type: lamp is not a register",
    ]
