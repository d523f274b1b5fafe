"""Enums as frozen objects, and words of flags as functions between a number and its bits."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.foundation.names import Name
from fieldspec.language.model.enums import Bit, Enum, Flags, Member
from fieldspec.targets.fact_texts import described, sentence
from fieldspec.targets.js.declaration import Declaration
from fieldspec.targets.js.naming import Scope, property_scope
from fieldspec.targets.js.text import comment, flag, literal, runs_of
from fieldspec.targets.js.units import unit_of_bits
from fieldspec.targets.runtime_values import is_wide


def member_keys(enum: Enum) -> dict[str, str]:
    """The key of each member of an enum in JavaScript, by its name in the spec; unavailable members have none."""
    return {member.name: key for key, member in _members(enum, property_scope())}


def _members(enum: Enum, scope: Scope) -> list[tuple[str, Member]]:
    return [(scope.take(Name.of(member.name).pascal()), member) for member in enum.members if not member.unavailable]


def declare_enum(enum: Enum, name: str) -> Declaration:
    """The members of an enum by name."""
    scope = property_scope()
    members = _members(enum, scope)
    code = [f"export const {name} = /* @__PURE__ */ Object.freeze({{"]
    aliases = [
        (scope.take(Name.of(alias).pascal()), key, member) for key, member in members for alias in member.aliases
    ]
    code += [f"  {key}: {member.value}," for key, member in members]
    code += [f"  {alias}: {member.value}," for alias, _, member in aliases]
    code += ["});", ""]
    remark = "Other values are passed on as numbers." if enum.open else "Other values are refused."
    types = comment(described(enum.title or Name.of(enum.name).title(), enum, remark))
    types += [f"export declare const {name}: {{"]
    for key, member in members:
        causes = [
            f"Cause: {sentence(cause.cause)} {' '.join(map(sentence, cause.remedies))}" for cause in member.causes
        ]
        remedies = [f"Remedy: {sentence(remedy)}" for remedy in member.remedies]
        types += comment(
            described(Name.of(member.name).title(), member, sentence(member.problem), *causes, *remedies), 2
        )
        types.append(f"  readonly {key}: {member.value};")
    for alias, key, member in aliases:
        types += comment([f"An alias of {key}."], 2)
        types.append(f"  readonly {alias}: {member.value};")
    types.append("};")
    if members:
        types += [f"export type {name} = (typeof {name})[keyof typeof {name}];", ""]
    else:
        types += [f"export type {name} = never;", ""]
    return Declaration(code, types)


def declare_flags(flags: Flags, name: str, enums: Mapping[str, Enum]) -> Declaration:
    """The functions `of`, from a number to its bits, and `raw` back; the latter keeps all other bits of a number.

    Without a number, `raw` begins with the defaults, and throws where a number that has to be given is left out.
    """
    scope = property_scope()
    bits = [(scope.take(Name.of(bit.name).camel()), bit) for bit in flags.bits if not bit.reserved]
    wide = is_wide(flags.type.encoding)
    code = [f"export const {name} = /* @__PURE__ */ Object.freeze({{"]
    code.append("  of: (raw) => ({")
    code += [f"    {key}: {_bit(bit, wide)}," for key, bit in bits]
    code.append("  }),")
    arguments = f"{literal(flags.name)}, BITS_OF_{name}, bits, raw, {8 * flags.type.size}"
    keys = {id(bit): key for key, bit in bits}
    required = [
        (keys[id(own.bit)], own.reason, [keys[id(other)] for other in own.bits]) for own in needed_bits(flags, enums)
    ]
    initial = f"{flags.initial}{'n' * wide}"
    if required:
        rows = ", ".join(
            f"[{literal(key)}, {literal(reason)}, [{', '.join(map(literal, other_keys))}]]"
            for key, reason, other_keys in required
        )
        initial = f"initialWord({literal(flags.name)}, bits, {initial}, [{rows}])"
    code.append(f"  raw: (bits, raw = {initial}) => setBits({arguments}),")
    units = {key: unit for key, bit in bits if bit.is_number and (unit := unit_of_bits(bit))}
    if units:
        code.append("  units: /* @__PURE__ */ Object.freeze({")
        code += [f"    {key}: {unit}," for key, unit in units.items()]
        code.append("  }),")
    code += ["});", ""]
    table = ", ".join(f"{key}: [{_place(bit)}]" for key, bit in bits)
    code.insert(0, f"const BITS_OF_{name} = {{ __proto__: null{', ' + table if table else ''} }};")
    types = comment(described(Name.of(flags.name).title(), flags))
    types.append(f"export interface {name} {{")
    for key, bit in bits:
        number = f"bit{'s' * (bit.width > 1)} {bit.number_text}"
        meanings = [f"{value} = {sentence(text)}" for value, text in ((0, bit.zero), (1, bit.one)) if text]
        if bit.default is not None:
            meanings.append(f"{bit.default} where it is left out.")
        if reason := bit.reason_to_give(enums.get(bit.enum)):
            meanings.append(f"It has to be given: its {sentence(reason)}")
        if key in units:
            meanings.append(f"A count of `units.{key}`.")
        types += comment(described(f"{Name.of(bit.name).title()}, {number}", bit, *meanings), 2)
        types.append(f"  readonly {key}: {'boolean' if bit.width == 1 else 'number'};")
    rows = " ".join(f"readonly {key}: Unit;" for key in units)
    with_units = f" & {{ readonly units: {{ {rows} }} }}" if units else ""
    single = " | ".join(literal(key) for key, _, other_keys in required if len(other_keys) == 1)
    parameters = f"{name}, {'bigint' if wide else 'number'}{f', {single}' if single else ''}"
    types += ["}", f"export declare const {name}: Flags<{parameters}>{with_units};", ""]
    return Declaration(code, types)


def _place(bit: Bit) -> str:
    """The first bit, the number of bits and whether there is a sign, and the runs of bits that lie apart."""
    runs = f", {flag(bit.signed)}, {runs_of(bit)}" if bit.pieces else ", true" * bit.signed
    return f"{bit.first}, {bit.width}{runs}"


def _bit(bit: Bit, wide: bool) -> str:
    if bit.pieces:
        return f"Number(bitsNumber({runs_of(bit)}, raw, {flag(bit.signed)}))"
    if wide:
        mask = bit.mask >> bit.first
        field = f"(raw >> {bit.first}n) & {mask}n"
        if bit.width == 1:
            return f"({field}) !== 0n"
        return f"Number(BigInt.asIntN({bit.width}, {field}))" if bit.signed else f"Number({field})"
    if bit.last > 31:  # operators on bits cut numbers to 32 bits
        number = f"Math.floor(raw / {1 << bit.first}) % {1 << bit.width}"
        return f"{number} !== 0" if bit.width == 1 else f"signed48({number}, {bit.width})" if bit.signed else number
    if bit.width == 1:
        return f"(raw & {bit.mask}) !== 0" if bit.first < 31 else f"raw >>> {bit.first} !== 0"
    mask = bit.mask >> bit.first
    number = f"(raw >>> {bit.first}) & {mask}" if mask < 1 << 31 else f"raw >>> {bit.first}"
    return f"signed48({number}, {bit.width})" if bit.signed else number
