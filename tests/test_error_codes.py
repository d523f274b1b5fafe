"""An exception response is encoded by the code of the usual response; the generated texts say so where it differs."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts, load
from fieldspec.targets.c.backend import files
from python_package import module_apart

SPEC = """
device:
  id: gatekeeper
  name: Gatekeeper
  vendor: Nobody
  manual: {title: The manual of a gate, file: gate.txt, sha256: "%s", lines: 99}
links:
  - name: line
    transmission: binary
    byte_order: big
    source: 1 L1
    request: &frame
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *frame
    exception_response: {flag: 0x40, record: refusal, source: 1 L2}
records:
  - {name: refusal, source: 1 L2, fields: [{name: reason, type: u8}]}
messages:
  - {name: open, code: 0x11,%s source: 2 L1, request: [], response: [{name: angle, type: u8}]}
"""


def gatekeeper(response_code: str) -> DeviceLayout:
    """The gate; the response to `open` may have a code of its own."""
    text = SPEC.replace("%s", "1" * 64, 1).replace("%s", response_code)
    return layouts(load({"gatekeeper/device.yaml": text.encode()}).devices["gatekeeper"])[0]


@pytest.mark.parametrize(
    ("response_code", "python", "c"),
    [
        ("", "to the request with a code", "exception response to a code."),
        (" response_code: 0x91,", "by the code of its usual response", "by the code of the usual response."),
    ],
)
def test_the_texts_say_whose_code_an_exception_response_takes(response_code: str, python: str, c: str) -> None:
    layout = gatekeeper(response_code)
    module = module_apart(layout, f"gatekeeper_{bool(response_code)}")
    assert python in module.line.encode_exception_response.__doc__
    assert c in " ".join(" ".join(files([layout]).values()).split())
    code = 0x91 if response_code else 0x11
    frame = module.line.encode_exception_response(code, module.Refusal(3))
    assert module.line.decode_response(frame, module.OpenRequest).code == code
