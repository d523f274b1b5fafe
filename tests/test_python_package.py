"""The generated package as a whole: type checkers, versions of Python, hostile texts, independence, sameness."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from fieldspec.foundation.names import stem
from fieldspec.targets.python.backend import PACKAGE, files
from fieldspec.targets.python.naming import Scope, module_name, package_name
from fieldspec.targets.python.text import docstring, literal
from layouts import SPECS, TEST_SPECS, layouts, newest
from proofs import share
from python_package import module_of, texts, write

PYTHONS = ("3.10", "3.11", "3.12", "3.13", "3.14")
HOSTILE = newest(TEST_SPECS, "hostile")
SMOKE = """

for name in MODULES:
    __import__(name)
assert not {"fieldspec", "yaml", "jinja2", "construct", "typing"} & {name.split(".")[0] for name in sys.modules}
from fieldspec_devices import tc100
frame = tc100.rtu.encode_request(1, tc100.WriteRegisterRequest(0x201E, 3))
assert frame.hex(" ") == "01 06 20 1e 00 03 a2 0d", frame.hex(" ")
assert tc100.rtu.decode_request(frame).message == tc100.WriteRegisterRequest(0x201E, 3)
print("well")
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that holds the package."""
    folder = tmp_path_factory.mktemp("python")
    write(folder, texts())
    return folder


def environment() -> dict[str, str]:
    """What a checker's process may know: nothing of this project."""
    return {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "MYPYPATH")}


def test_mypy_is_content_with_the_package(package: Path) -> None:
    command = [sys.executable, "-m", "mypy", "--strict", "--python-version=3.10", "--config-file=", PACKAGE]
    done = subprocess.run(command, cwd=package, env=environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-5000:]


@pytest.mark.proof
def test_pyright_is_content_with_the_package(package: Path) -> None:
    # Versions and devices differ little, and mypy reads all of them.
    devices = [versions for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]
    judged = {package_name(versions[-1].device.id) for versions in share(devices, 4)}
    older = tuple(stem(layout.device.id, layout.device.version) for versions in devices for layout in versions[:-1])
    files = sorted((package / PACKAGE).rglob("*.py"))
    newest = [
        str(path)
        for path in files
        if path.parent.name in (PACKAGE, *judged) and not f"{path.parent.name}_{path.name}".startswith(older)
    ]
    assert len(newest) < len(files)
    command = [sys.executable, "-m", "pyright", "--outputjson", *newest]
    done = subprocess.run(command, cwd=package, env=environment(), capture_output=True, text=True, check=False)
    report = json.loads(done.stdout)
    assert report["generalDiagnostics"] == []
    assert report["summary"]["filesAnalyzed"] > 10


USER = """# pyright: strict
from decimal import Decimal
from fractions import Fraction
from typing_extensions import assert_type
from fieldspec_devices import ExceptionResponse, Parameter, Register, Request, Response, glider_x, widget
from fieldspec_devices import transports
from fieldspec_devices.glider_x import client as glider_client
from fieldspec_devices.widget import before_2_0
from fieldspec_devices.widget import client as widget_client

request = widget.ReadRegistersRequest(0x1000, 2)
reply = widget.rtu.decode_response(b"", request)
assert_type(reply, Response[widget.ReadRegistersResponse] | ExceptionResponse[widget.ExceptionRecord])
stopped = widget.rtu.decode_response(b"", widget.StopRequest)
assert_type(stopped, Response[widget.StopResponse] | ExceptionResponse[widget.ExceptionRecord])
packet = widget.packet.decode_response(b"", widget.StopRequest())
assert_type(packet.message, widget.StopResponse)
assert_type(packet.status, widget.PacketStatus)
assert_type(packet.status.busy, bool)
assert_type(widget.LAMP.decode(b""), widget.Color)
assert_type(widget.ALARM_HISTORY[1].decode(b""), widget.Alarm | int)
assert_type(widget.POSITION.decode(b""), int)
assert_type(widget.RATIO.decode(b""), float)
assert_type(widget.points[5].decode(b""), widget.Point)
assert_type(widget.points.read_value(5), widget.Point)
assert_type(widget.read_value(widget.STATUS_WORD), widget.Status)
assert_type(widget.parameters.read_value(widget.parameters.HOME, widget.ReadOneResponse(2, 0)), widget.Direction)
assert_type(widget.Point.decode(b"").speed, int)
assert_type(widget.Corner(1, 2).x_mm, float)
assert_type(widget.Corner(x_mm=0.5, y=12), widget.Corner)
assert_type(widget.Corner(5, y_mm=Decimal("1.2")), widget.Corner)
assert_type(widget.Corner(x_mm=Fraction(1, 2), y_mm=1), widget.Corner)
widget.Corner(1, 2).x_mm = Decimal("0.1")
assert_type(glider_x.commanded_speed_to_raw(Decimal("1.5"), 3000), int)
assert_type(before_2_0.LAMP, Register[before_2_0.Color])

cyclic = glider_x.cyclic
assert_type(cyclic.decode_request(b"", glider_x.Telegram3Request), Request[glider_x.Telegram3Request])
assert_type(cyclic.decode_request(b"", 11), Request[glider_x.Telegram11Request])
assert_type(cyclic.decode_request(b"", "telegram_70").message, glider_x.Telegram70Request)
assert_type(cyclic.decode_response(b"", 3), Response[glider_x.Telegram3Response])
assert_type(cyclic.decode_response(b"", glider_x.Telegram11Request), Response[glider_x.Telegram11Response])
assert_type(cyclic.decode_request(b"", str(3)).message, glider_x.AnyCyclicRequest)
assert_type(glider_x.ControlWord(on=True, sign_of_life=3).on, bool)
assert_type(glider_x.ControlWordPositioning(path=glider_x.Path.POSITIVE).path, glider_x.Path | int)
assert_type(glider_x.StatusWord(3).state, glider_x.StatusWordState | None)
assert_type(glider_x.commanded_speed_from_raw(1, 3000), float)
assert_type(glider_x.commanded_speed_to_raw(1.5, 3000), int)
values = glider_x.ReadParameterResponse(glider_x.Format.WORD, (1,))
assert_type(values.values, tuple[bool | int | float, ...])
assert_type(glider_x.servo.REFERENCE_SPEED, Parameter[int])
assert_type(glider_x.monitor.UNUSED[1], Parameter[int])
assert_type(glider_x.pnu.read_value(glider_x.monitor.ALARM_CODE, values), glider_x.Alarm | int)
assert_type(glider_x.pnu.read_values(glider_x.profile.FAULT_CODES, values), list[glider_x.Alarm | int])
assert_type(glider_x.pnu(0x2317).applies_to, tuple[str, ...])
assert_type(glider_x.pnu.write_request(glider_x.servo.REFERENCE_SPEED, 1), glider_x.WriteParameterRequest)
assert_type(glider_x.Alarm.by_printed_name("AL.024").number, int | None)
reference = glider_x.channel.decode_response(b"", glider_x.ReadParameterRequest)
assert_type(reference.reference, int)

device = widget_client.Client(transports.tcp("localhost", 502), link="rtu")
assert_type(device.read(widget.LAMP), widget.Color)
assert_type(device.read(widget.points[5]), widget.Point)
assert_type(device.read_group(widget_client.STATE)[widget.RATIO], float)
assert_type(device.move_absolute(position_mm=Decimal("1.5")), float | None)
device.write_in_unit(widget.TARGET, Fraction(1, 3))
channel = glider_client.Client(transports.udp("localhost", 502))
assert_type(channel.read_parameter(glider_x.servo.REFERENCE_SPEED), int)
assert_type(channel.ask(glider_x.ReadParameterRequest(1, 2, 3)).message, glider_x.ReadParameterResponse)
assert_type(glider_client.Telegram3(transports.udp("localhost", 1)).exchange(), glider_x.Telegram3Response)


async def work() -> None:
    device = widget_client.AsyncClient(await transports.async_tcp("localhost", 502))
    assert_type(await device.read(widget.LAMP), widget.Color)
    await device.write(widget.TARGET, 5)
"""

WRONG = """
from fieldspec_devices import glider_x, transports, widget
from fieldspec_devices.widget import client as widget_client
widget.rtu.encode_request(1, widget.StopResponse())
widget.write_request(widget.LAMP, "red")
widget.Corner(x=1)
widget.Status(redy=True)
widget.LAMP.encode(1.5)
widget.Corner(1, 2).x_mm = "1"
widget.Corner(x=1, x_mm=0.1, y=2)
widget.Corner(x_mm=0.1)
widget.Corner(x_mm="0.1", y=2)
widget.Corner(1, 2, 0.1)
glider_x.ControlWord(onn=True)
glider_x.servo.REFERENCE_SPED
glider_x.pnu.write_request(glider_x.servo.REFERENCE_SPEED, "fast")
glider_x.cyclic.encode_request(glider_x.ReadParameterRequest(1, 2, 3))
glider_x.pnu.read_request(glider_x.servo.REFERENCE_SPEED)
device = widget_client.Client(transports.tcp("localhost", 502))
device.write(widget.TARGET, "far")
device.move_absolute(position_mm="5")
widget_client.Client(transports.tcp("localhost", 502), link="usb")
widget_client.AsyncClient(transports.tcp("localhost", 502))
"""


def test_a_type_checker_knows_what_users_get(package: Path) -> None:
    (package / "user.py").write_text(USER, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--python-version=3.10", "--config-file=", "user.py"]
    done = subprocess.run(command, cwd=package, env=environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-5000:]


def test_pyright_knows_what_users_get(package: Path) -> None:
    (package / "user_of_pyright.py").write_text(USER, encoding="utf-8")
    command = [sys.executable, "-m", "pyright", "--pythonversion=3.11", "--outputjson", "user_of_pyright.py"]
    done = subprocess.run(command, cwd=package, env=environment(), capture_output=True, text=True, check=False)
    report = json.loads(done.stdout)
    assert [finding["message"] for finding in report["generalDiagnostics"]] == []
    assert report["summary"]["filesAnalyzed"] == 1


def test_a_type_checker_finds_what_users_get_wrong(package: Path) -> None:
    (package / "wrong.py").write_text(WRONG, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--python-version=3.10", "--config-file=", "wrong.py"]
    done = subprocess.run(command, cwd=package, env=environment(), capture_output=True, text=True, check=False)
    lines = sorted(int(line) for line in re.findall(r"wrong\.py:(\d+): error", done.stdout))
    assert lines == [*range(4, 19), *range(20, 24)], done.stdout[-5000:]


@pytest.mark.parametrize("version", PYTHONS)
def test_the_package_works_alone_under_every_python(package: Path, version: str) -> None:
    python = _python(version)
    paths = (path.relative_to(package).with_suffix("") for path in sorted(package.rglob(f"{PACKAGE}/**/*.py")))
    modules = [".".join(path.parts).removesuffix(".__init__") for path in paths]
    start = f"import sys; sys.path.insert(0, {str(package)!r}); MODULES = {modules!r}"
    command = [python, "-W", "error", "-I", "-c", start + SMOKE]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True, check=False)
    assert done.stdout == "well\n", done.stderr[-3000:]


def _python(version: str) -> str:
    """An interpreter of a version, where there is one."""
    if version == f"{sys.version_info.major}.{sys.version_info.minor}":
        return sys.executable
    interpreters = sorted(Path.home().glob(f".pyenv/versions/{version}.*/bin/python"))
    return str(interpreters[-1]) if interpreters else _skipped(version)


def _skipped(version: str) -> str:
    path = shutil.which(f"python{version}")
    if path is None:
        pytest.skip(f"there is no Python {version} here")
    return path


def test_the_same_specs_give_the_same_bytes() -> None:
    versions = layouts(TEST_SPECS)["widget"]
    assert files(versions) == files(versions)


def test_an_output_names_no_machine_and_no_day() -> None:
    for path, text in texts().items():
        assert not re.search(r"/(work|root|home|tmp)/|20\d\d-\d\d-\d\d", text), path


def test_every_module_of_a_version_holds_its_identity() -> None:
    for versions in layouts(SPECS).values():
        for layout in versions:
            path = f"{PACKAGE}/{package_name(layout.device.id)}/{module_name(layout.device.version)}.py"
            text = texts()[path]
            assert layout.identity in text[:3000]
            assert f'IDENTITY: _Final = "{layout.identity}"' in text


def test_no_module_of_the_package_depends_on_the_compiler_and_those_of_many_records_alone_on_numpy() -> None:
    for path, text in texts().items():
        for node in ast.walk(ast.parse(text)) if path.endswith(".py") else ():
            if isinstance(node, ast.ImportFrom) and node.level == 0:
                assert node.module in ALLOWED, path
            of_many = path.endswith(("/many.py", "/_columns.py"))
            if isinstance(node, ast.Import) and not (of_many and node.names[0].name == "numpy"):
                pytest.fail(f"{path} imports {node.names[0].name}")


ALLOWED = {
    "__future__",
    "array",
    "asyncio",
    "binascii",
    "collections.abc",
    "contextlib",
    "decimal",
    "enum",
    "fractions",
    "importlib",
    "operator",
    "re",
    "socket",
    "struct",
    "sys",
    "time",
    "types",
    "typing",
    "typing_extensions",
}


# Hostile texts


def test_hostile_texts_arrive_as_they_are() -> None:
    module = module_of(HOSTILE)
    assert 'Line one line two */ // """ \\' in module.ClassLink.__doc__
    assert 'None ("""*/</script>\\)' in module.NoneCode.__doc__
    assert "# and a hash, and a backslash at the end \\" in module.Struct.__doc__
    assert "🤖🦾 emoji" in source_of_hostile()


def test_hostile_characters_are_escaped_where_they_would_not_be_seen() -> None:
    text = source_of_hostile()
    for char in "\x00\t\r\u2028\u202e":
        assert char not in text
    assert "\\x00" in text
    assert "\\u202e" in text


def source_of_hostile() -> str:
    """The module of the hostile device."""
    return files([HOSTILE])[f"{PACKAGE}/hostile/v1.py"]


def test_hostile_names_become_names_of_python() -> None:
    module = module_of(HOSTILE)
    assert module.class_.decode_request(bytes.fromhex("07 02 09 12")).return_ == 9
    assert module.Flags_ if hasattr(module, "Flags_") else module.FlagsFlags(class_=True, raw_=True).raw == 5
    assert [member.name for member in module.NoneCode][:3] == ["NONE", "TRUE", "MRO"]
    assert module.Struct.__match_args__[:3] == ("class_", "int_", "int_percent")
    assert module.CLASS.address == 0
    assert module.main.GET.number == 1


TEXTS = [
    '"""',
    "\\",
    'ends with "',
    '\\"""',
    "a\\",
    "\n\n",
    "'''",
    '""""',
    '"',
    "{{ x }}",
    "%s",
    "tab\tand\rreturn",
    "\x00\x7f",
    "é🤖",
    "\\N{BULLET}",
]


@pytest.mark.parametrize("text", TEXTS)
def test_any_text_is_a_literal_and_a_docstring(text: str) -> None:
    assert ast.literal_eval(literal(text)) == text
    lines = docstring([f"Begins. {text}", text], 4)
    read = ast.literal_eval("\n".join(lines).strip())
    assert " ".join(read.split()) == " ".join(f"Begins. {text} {text}".split())


def test_a_name_that_is_taken_gets_another_form() -> None:
    scope = Scope(frozenset({"Point"}))
    assert [scope.take("Point", "PointRecord"), scope.take("Point", "PointRecord"), scope.take("class")] == [
        "PointRecord",
        "PointRecord_",
        "class_",
    ]


MODULES = [("2.0", "v2_0"), ("before-1.17", "before_1_17"), ("V2", "v2"), ("1", "v1"), ("class", "vclass")]


@pytest.mark.parametrize(("version", "module"), MODULES)
def test_a_version_gives_its_module_a_name(version: str, module: str) -> None:
    assert module_name(version) == module
    assert module.isidentifier()


def test_a_device_gives_the_names_of_its_newest_version() -> None:
    widget = module_of(newest(TEST_SPECS, "widget"))
    package = sys.modules[widget.__name__.rpartition(".")[0]]
    assert package.Point is widget.Point
    assert package.LATEST == "2.0"
    assert package.VERSIONS == {"before-2.0": "before_2_0", "2.0": "v2_0"}
    assert set(widget.__all__) < set(package.__all__)
