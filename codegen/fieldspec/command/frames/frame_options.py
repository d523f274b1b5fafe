"""The options of a frame: its link, its direction and its message, as the device calls them."""

from __future__ import annotations

import argparse
import os
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

from fieldspec.codec.explain.option_names import option_word
from fieldspec.codec.explain.readings import DIRECTIONS, FrameOptions
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.sources import layout_cache, spec_files
from fieldspec.language.model.quantity import count_of
from fieldspec.language.reading.findings import MAIN


def frame_options(layout: DeviceLayout, arguments: argparse.Namespace) -> FrameOptions:
    """The meaning of the options. Raises UsageError for names that the device does not have."""
    links = _links(layout, arguments.link)
    message_word, text, links = _word(layout, arguments, links)
    message = ""
    if text:
        message = _message(layout, message_word, text, links)
        links = [link for link in links if message in layout.links[link].messages]
    places = _places(layout, links, arguments.direction, [link for link in layout.links if link not in links])
    return FrameOptions(places if arguments.link or arguments.direction or text else (), message)


def _links(layout: DeviceLayout, name: str | None) -> list[str]:
    if name and name not in layout.links:
        raise unknown("link", name, layout.links)
    return [name] if name else list(layout.links)


def _word(layout: DeviceLayout, arguments: argparse.Namespace, links: list[str]) -> tuple[str, str, list[str]]:
    """The term for a message, the requested name, and the links with such messages."""
    words = {f"--{option_word(link.link.message_name)}": link.link.message_name for link in layout.links.values()}
    stated = [("--message", arguments.message)] if arguments.message is not None else []
    stated += [(option.replace("_", "-"), text) for option, text in arguments.words]
    for option, text in stated:
        if option not in words and option != "--message":
            raise unknown("option", option, ["--link", "--direction", "--message", "--format", *words])
        if not text:
            raise UsageError(f"{option} needs a name or a number")
    if not stated:
        return "message", "", links
    if len(stated) > 1:
        raise UsageError(f"{stated[0][0]} and {stated[1][0]} both name the message; use one of them")
    ((option, text),) = stated
    word = words.get(option, "message")
    if option == "--message":
        return word, text, links
    own = [link for link in links if layout.links[link].link.message_name == word]
    if not own:
        message_words = sorted({layout.links[link].link.message_name for link in links})
        raise UsageError(f"{' and '.join(links)} has no {word}; what it sends is called {' or '.join(message_words)}")
    return word, text, own


def _message(layout: DeviceLayout, message_word: str, text: str, links: Collection[str]) -> str:
    """The message with a name or a number, on some links. Raises UsageError."""
    messages = {name: message for link in links for name, message in layout.links[link].messages.items()}
    if text in messages:
        return text
    number = number_of(text)
    candidates = [name for name, message in messages.items() if number is not None and message.message.number == number]
    candidates = candidates or [
        name for name, message in messages.items() if number is not None and message.message.code == number
    ]
    if len(candidates) == 1:
        return candidates[0]
    if candidates:
        raise UsageError(f"{text} may be {' or '.join(candidates)}; use the name")
    elsewhere = [link.name for link in layout.links.values() if text in link.messages]
    if elsewhere:
        raise UsageError(f"{text} is not sent on {' or '.join(links)}, but on {' and '.join(elsewhere)}")
    raise unknown(message_word, text, _numbers(messages.values()) if number is not None else messages)


def _numbers(candidates: Iterable[MessageLayout]) -> Iterable[str]:
    """The numbers of messages, or else their names."""
    messages = list(candidates)
    numbers = [str(message.message.number) for message in messages if message.message.number is not None]
    return numbers or [message.name for message in messages]


def number_of(text: str) -> int | None:
    """`0x2011`, `2011h` or `8209` as a number."""
    digits = text[:-1] if text[-1:] in ("h", "H") else text
    try:
        return int(digits, 16) if digits != text else count_of(text)
    except ValueError:
        return None


def _places(
    layout: DeviceLayout, links: Collection[str], text: str | None, other_links: Collection[str]
) -> tuple[tuple[str, str], ...]:
    """The links with a direction of that name. Names of the link take precedence over `request` and `response`."""
    if not text:
        return tuple((link, direction) for link in links for direction in DIRECTIONS)
    places = []
    for link in links:
        own = {layout.links[link].link.direction_name(direction): direction for direction in DIRECTIONS}
        direction = own.get(text, text)
        if direction in DIRECTIONS:
            places.append((link, direction))
    if places:
        return tuple(places)
    names = dict.fromkeys(name for link in links for name in direction_names(layout, link))
    elsewhere = [link for link in other_links if text in direction_names(layout, link)]
    if elsewhere:
        names_text = " and ".join(names)
        raise UsageError(f"{text} is a direction of {' and '.join(elsewhere)}; {' and '.join(links)} has {names_text}")
    raise unknown("direction", text, [*names, *DIRECTIONS])


def direction_names(layout: DeviceLayout, link: str) -> tuple[str, str]:
    """The names that a link has for its directions: to the device, and from it."""
    named_link = layout.links[link].link
    return named_link.request_name, named_link.response_name


def device_help(arguments: Sequence[str]) -> str:
    """What `--help` adds for the device among some arguments: its messages and directions. Empty without a device."""
    with suppress(UsageError):
        specs_option = next((after for before, after in pairwise(arguments) if before == "--specs"), None)
        path = spec_files.folder(specs_option)
        for argument in arguments:
            name, _ = spec_files.split(argument)
            if not name.startswith("-") and name and os.path.isfile(os.path.join(path, name, MAIN)):
                return " ".join(_sentences(layout_cache.layout(specs_option, argument)))
    return ""


def _sentences(layout: DeviceLayout) -> Iterator[str]:
    for link in layout.links.values():
        messages = (message.message for message in link.messages.values())
        names = ", ".join(message.name if message.number is None else str(message.number) for message in messages)
        directions = " or ".join(direction_names(layout, link.name))
        yield f"On {link.name}, --{option_word(link.link.message_name)} is one of {names}; --direction is {directions}."
