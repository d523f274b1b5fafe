"""YAML to nodes that know their lines, against PyYAML's fastest loader, which does not."""

from __future__ import annotations

from collections.abc import Iterator

import yaml
from peers import registers
from rows import Row, printed, timed

from fieldspec.language.reading.yaml_reader import decoded, parsed

GROUP = "YAML with line numbers"
COUNT = 2000


def rows() -> Iterator[Row]:
    """The row."""
    (text,) = registers.spec(COUNT).values()
    data = text.encode()
    file, findings = decoded("device.yaml", data)
    assert not findings
    peer = f"PyYAML {yaml.__version__}, CSafeLoader"
    yield timed(GROUP, f"{COUNT} registers", lambda: parsed(file), peer,
                lambda: yaml.load(data, yaml.CSafeLoader), at_most=0.40)  # fmt: skip


if __name__ == "__main__":
    printed(rows())
