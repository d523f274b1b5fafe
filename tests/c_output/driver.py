"""A C program for the tests: it decodes the bytes of each input line, encodes them again, and prints both results."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.names import stem
from fieldspec.targets.c.backend import headers
from fieldspec.targets.c.delimiters import is_wrapped
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.naming import Naming

_MAIN = """
static int hex(const char *text, uint8_t *out)
{
    int size = 0;
    unsigned byte;
    while (sscanf(text + 2 * size, "%2x", &byte) == 1) {
        out[size++] = (uint8_t)byte;
    }
    return size;
}

static void show(const uint8_t *data, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        printf("%02x", data[offset]);
    }
}

int main(void)
{
    static char name[256], text[131073];
    static uint8_t data[65536], again[65536], buffer[65536];
    static char line[131584];
    (void)buffer;
    while (fgets(line, sizeof line, stdin)) {
        size_t length = 0;
        int size = 0, status = -1, second = -1;
        text[0] = 0;
        if (sscanf(line, "%255s %131072s", name, text) >= 1) {
            size = hex(text, data);
        }
        CASES
        printf("%d %d ", status, second);
        show(again, second == 0 ? length : 0);
        printf("\\n");
    }
    return 0;
}
"""


def records(layout: DeviceLayout) -> dict[str, RecordLayout]:
    """The records and message bodies of a device, which are decoded without a frame."""
    records = dict(layout.records)
    for message in layout.messages.values():
        records |= {data.name: data for data in message.bodies}
    return records


def settled(layout: DeviceLayout) -> Naming:
    """The C names in the header of a layout."""
    naming = Naming(layout.device.id)
    headers(layout, naming)
    return naming


def source(layout: DeviceLayout) -> str:
    """The source of the program."""
    naming = settled(layout)
    cases = []
    for name, record in records(layout).items():
        decode, encode = naming.function("record", name, "decode"), naming.function("record", name, "encode")
        has_members = bool(members(record))
        argument = "&value, " if has_members else ""
        cases.append(
            f'if (strcmp(name, "{name}") == 0) {{'
            + (f" {naming.type('record', name)} value; memset(&value, 0, sizeof value);" if has_members else "")
            + f" status = (int){decode}(data, (size_t)size{', &value' if has_members else ''});"
            + f" if (status == 0) second = (int){encode}({argument}again, sizeof again, &length); }}"
        )
    for link in layout.links.values():
        wrapped = is_wrapped(link)
        for direction in ("request", "response"):
            frame = naming.type("link", link.name, direction, "frame")
            call = naming.function("link", link.name, direction, "open")
            cases.append(
                f'if (strcmp(name, "{link.name}.{direction}") == 0) {{ {frame} value; memset(&value, 0, sizeof value);'
                f" status = (int){call}(data, (size_t)size, {'buffer, sizeof buffer, ' if wrapped else ''}&value);"
                " if (status == 0) { second = 0; length = value.body_length; memcpy(again, value.body, length); } }"
            )
    name = stem(layout.device.id, layout.device.version) + ".h"
    included = f'#include "{name}"\n#include <stdio.h>\n#include <string.h>\n'
    return included + _MAIN.replace("CASES", "\n        ".join(cases))
