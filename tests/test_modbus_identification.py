"""The texts of the function 43/14 are exchanged with pymodbus, as its client and as its server."""

from __future__ import annotations

import pytest
from pymodbus.pdu.device import ModbusDeviceIdentification

import test_modbus_peers
from test_modbus_peers import LINKS, STATION, TEXTS, Client, line_to_server, served, simulated


@pytest.mark.parametrize("link", LINKS)
def test_the_texts_of_a_server_of_pymodbus_are_read_in_several_responses(
    link: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = {number: f"{number:x}" * 100 for number in (0, 1, 2, 4, 5)} | {6: "x" * 244}
    identity = ModbusDeviceIdentification(info={number: text.encode() for number, text in texts.items()})
    monkeypatch.setattr(test_modbus_peers, "IDENTITY", identity)
    with line_to_server(link, simulated()) as line:
        client, read, first, more = Client(STATION, link, line), {}, 0, 0xFF
        while more:
            request = STATION.ReadDeviceIdentificationRequest(category=2, first_object=first)
            response = client.ask(request).message
            read |= {own.number: own.value for own in response.objects if own.value}
            first, more = response.next_object, response.more_follows
        assert read == texts
        request = STATION.ReadDeviceIdentificationRequest(category=4, first_object=5)
        assert [(own.number, own.value) for own in client.ask(request).message.objects] == [(5, texts[5])]


@pytest.mark.parametrize("link", LINKS)
def test_a_client_of_pymodbus_reads_the_texts_of_the_generated_codec(link: str) -> None:
    with served(link) as (client, _):
        response = client.read_device_information(read_code=1, object_id=0, device_id=1)
        assert response.information == {number: text.encode() for number, text in enumerate(TEXTS)}
        assert (response.conformity, response.more_follows) == (0x81, 0)
        response = client.read_device_information(read_code=4, object_id=1, device_id=1)
        assert response.information == {1: TEXTS[1].encode()}
