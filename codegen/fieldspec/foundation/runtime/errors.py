"""The exceptions of clients. All of them are a `DeviceError`."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any


class DeviceError(Exception):
    """The errors of a client about a device, its line, or a request."""


class InvalidValueError(DeviceError, ValueError):
    """A value that no request can carry, or a request that does not fit the link or the call. Nothing was sent."""


class TransportError(DeviceError):
    """The transport has failed: the port is gone, or the connection is closed."""


class NoAnswerError(DeviceError):
    """No frame that answers the request has come in time. Whether the device carried it out is unknown."""


class InvalidAnswerError(DeviceError):
    """The device has answered with a value that its spec does not have."""


class RefusedError(DeviceError):
    """The device has refused a request by an exception response, or a task by the value that shows refusals.

    `number` is the number of the exception or of the refusal, and `exception` the whole record, None for tasks.
    """

    def __init__(self, text: str, number: int, exception: Any = None) -> None:
        super().__init__(text)
        self.number, self.exception = number, exception

    def __reduce__(self) -> tuple[Any, ...]:
        return RefusedError, (str(self), self.number, self.exception)


class AlarmError(DeviceError):
    """The device has an alarm."""


class ServoOffError(DeviceError):
    """A task moves, and the servo is off."""


class NotReadyError(DeviceError):
    """What must hold before a task does not hold. Nothing was started."""


class TimeLimitError(DeviceError):
    """The condition of a task was not met within its time limit. A task that moves has told the device to stop."""


class MotionError(DeviceError):
    """A motion that the device has taken did not begin, or ended before its target. The device was told to stop."""
