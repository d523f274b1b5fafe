"""Clients of TOYO TC100.

This module has the names of the newest version.
"""

from __future__ import annotations

from .._typing import TYPE_CHECKING as _TYPE_CHECKING
from . import v2_0_client as latest
from .v2_0_client import *  # noqa: F403

if _TYPE_CHECKING:
    from types import ModuleType as _ModuleType


def for_firmware(firmware: str, *, nearest: bool = False) -> _ModuleType:
    """The module of the clients for the firmware that a device reports, as the device's own `for_firmware` finds it.

    Raises `UnknownFirmwareError` for a firmware that no version of the spec is for.
    """
    from importlib import import_module

    from . import for_firmware as codec_for_firmware

    return import_module(f"{codec_for_firmware(firmware, nearest=nearest).__name__}_client")


__all__ = ["for_firmware", "latest"]
__all__ += latest.__all__
