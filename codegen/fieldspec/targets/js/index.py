"""The module `index` of a device in JavaScript: the names of the newest version, and the choice of another one."""

from __future__ import annotations

import json
from collections.abc import Mapping

from fieldspec.codec.layout.detection import version_detection, version_lines
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.targets.fact_texts import detection_text
from fieldspec.targets.js.text import comment, literal

_FOR_VERSION = "The module of a version. Throws RangeError for a version that the spec does not have."

_FOR_FIRMWARE = (
    "The module of the firmware that a device reports. Blanks around the version, a `v` before it and leading or "
    "trailing zeros do not matter: ` v02.0 ` is 2.0. The version `before-2.0` of a spec is all firmware below 2.0. "
    "With `nearest`, a version that the spec does not list gets the module of the newest version below it on its line; "
    "the caller answers for that choice.",
    "Throws UnknownFirmwareError, which lists the known versions, for every other firmware. Nothing is guessed.",
)


def index_texts(layout: DeviceLayout, folder: str, modules: Mapping[str, str]) -> dict[str, str]:
    """The module and its types; `modules` has the module of each version, `layout` is the newest one."""
    device = layout.device
    head = comment(
        [
            f"{device.vendor} {device.name}: the names of the newest version.",
            *(f"Version {version}: ./{module}.js" for version, module in modules.items()),
        ]
    )
    return {
        f"{folder}/index.js": "\n".join([*head, *_code(device, modules), ""]),
        f"{folder}/index.d.ts": "\n".join([*head, *_types(device, modules), ""]),
    }


def _code(device: Device, modules: Mapping[str, str]) -> list[str]:
    detection = version_detection(device)
    lines = json.dumps(version_lines(device, modules))
    rows = [f'  {literal(version)}: () => import("./{module}.js"),' for version, module in modules.items()]
    reads = detection is not None and detection.reads_values
    imports = "versionIn, versionOf" if reads else "versionOf"
    code = [
        f'import {{ {imports} }} from "../runtime/firmware.js";',
        f'export * from "./{modules[device.version]}.js";',
        "",
        "const VERSIONS_BY_NAME = {",
        "  __proto__: null,",
        *rows,
        "};",
        f"const LINES = {lines};",
        f"export const VERSIONS = Object.freeze({json.dumps(list(modules))});",
    ]
    version = "firmware"
    if detection is not None:
        code += ["", *comment(["The value of the device that tells its version."])]
        code += [f"export const DETECTED_BY = {literal(detection.fact)};"]
    if detection is not None and reads:
        entries = ", ".join(
            f"[{literal(value) if isinstance(value, str) else value}, {literal(name)}]"
            for value, name in detection.named
        )
        code += [f"const DETECTED_AS = new Map([{entries}]);"]
        version = f"versionIn(LINES, firmware, {literal(detection.form)}, {detection.places}, DETECTED_AS)"
    return [
        *code,
        "",
        *comment([_FOR_VERSION]),
        "export async function forVersion(version) {",
        "  const load = VERSIONS_BY_NAME[version];",
        "  if (load === undefined) {",
        f'    throw new RangeError(`{Name.of(device.id).snake()} has the versions ${{VERSIONS.join(", ")}}`);',
        "  }",
        "  return load();",
        "}",
        "",
        *comment([*_FOR_FIRMWARE, detection_text(device.detection) if device.detection is not None else ""]),
        "export async function forFirmware(firmware, { nearest = false } = {}) {",
        f"  return forVersion(versionOf(LINES, {version}, nearest));",
        "}",
    ]


def _types(device: Device, modules: Mapping[str, str]) -> list[str]:
    detection = version_detection(device)
    union = " | ".join(f'typeof import("./{module}.js")' for module in dict.fromkeys(modules.values()))
    known = " | ".join(map(literal, modules))
    takes = "string | number | bigint" if detection is not None and detection.takes_numbers else "string"
    overloads = [
        f'export declare function forVersion(version: {literal(version)}): Promise<typeof import("./{module}.js")>;'
        for version, module in modules.items()
    ]
    detected = [
        *comment(["The value of the device that tells its version."]),
        f"export declare const DETECTED_BY: {literal(detection.fact)};",
    ] if detection is not None else []  # fmt: skip
    return [
        f'export * from "./{modules[device.version]}.js";',
        f"export declare const VERSIONS: readonly ({known})[];",
        *detected,
        *comment([_FOR_VERSION]),
        *overloads,
        f"export declare function forVersion(version: string): Promise<{union}>;",
        *comment([*_FOR_FIRMWARE, detection_text(device.detection) if device.detection is not None else ""]),
        f"export declare function forFirmware(firmware: {takes}, options?: {{ readonly nearest?: boolean }}): "
        f"Promise<{union}>;",
    ]
