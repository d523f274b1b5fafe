"""The reserved words of targets, and how each target writes a name that is one of them."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass

# Fixed lists rather than those of some installed tool: an output is the same on every machine.

_DEVICES = frozenset({"con", "prn", "aux", "nul", "conin$", "conout$", "clock$"}) | {
    f"{port}{number}" for port in ("com", "lpt") for number in "0123456789\u00b9\u00b2\u00b3"
}
"""The names of devices in Windows, which no file can have, whatever follows after a point."""
_LONGEST_FILE_NAME = 255
"""Bytes of the name of a file or a folder, on the usual file systems of Linux and macOS."""


def file_name_fault(name: str) -> str:
    """Why a file system of some user cannot have a file or a folder of a name; empty where all can."""
    if name.partition(".")[0].rstrip(" ").lower() in _DEVICES:
        return "is the name of a device in Windows"
    if not name.isprintable() or any(char in '<>:"/\\|?*' for char in name):
        return "has a character that no file name may have in Windows, or that cannot be seen"
    if name in ("", ".", "..") or name != name.strip(" ") or name.endswith("."):
        return "is empty, or begins or ends with a blank or a point"
    if len(name.encode("utf-8", "surrogateescape")) > _LONGEST_FILE_NAME:
        return f"has more than {_LONGEST_FILE_NAME} bytes"
    return ""


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


PYTHON = _words(
    """
    False None True and as assert async await break class continue def del elif else except finally for from global
    if import in is lambda nonlocal not or pass raise return try while with yield
    """
)

C = _words(
    """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    _Alignas _Alignof _Atomic _Bool _Complex _Generic _Imaginary _Noreturn _Static_assert _Thread_local
    alignas alignof bool constexpr false nullptr static_assert thread_local true typeof typeof_unqual
    and and_eq asm bitand bitor catch char8_t char16_t char32_t class co_await co_return co_yield compl concept
    consteval constinit const_cast decltype delete dynamic_cast explicit export friend mutable namespace new noexcept
    not not_eq operator or or_eq private protected public reinterpret_cast requires static_cast template this throw
    try typeid typename using virtual wchar_t xor xor_eq
    linux unix i386 errno stdin stdout stderr assert offsetof near far interrupt
    int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t size_t ptrdiff_t intptr_t uintptr_t intmax_t
    uintmax_t max_align_t memcmp memcpy memmove memset strlen
    """
)
"""The words of C and of C++, the macros of common headers and compilers, and the types and functions of a header."""

IEC = _words(
    """
    abstract action array at bool by byte case char class configuration constant continue date date_and_time dint do dt
    dword else elsif en end_action end_case end_class end_configuration end_for end_function end_function_block end_if
    end_interface end_method end_namespace end_program end_repeat end_resource end_step end_struct end_transition
    end_type end_var end_while eno exit extends f_edge false final for from function function_block if implements
    initial_step int interface internal interval ldate ldate_and_time ldt lint lreal ltime ltime_of_day ltod lword
    method mod namespace non_retain not null of on or and overlap override priority private program protected public
    r_edge read_only read_write real ref ref_to repeat resource retain return single sint step string struct super task
    then this time time_of_day tod to transition true type udint uint ulint until using usint var var_access
    var_config var_external var_global var_in_out var_input var_output var_temp wchar while with word wstring xor
    abs sqrt ln log exp sin cos tan asin acos atan atan2 add mul sub div expt move shl shr rol ror sel max min limit
    mux gt ge eq le lt ne len left right mid concat insert delete replace find trunc round
    sr rs r_trig f_trig ctu ctd ctud tp ton tof rtc sema
    ld ldn st stn s r cal calc calcn ret retc retcn jmp jmpc jmpcn andn orn xorn
    bit pointer reference property union adr sizeof persistent var_stat var_inst bitadr ini indexof ton_ltime
    """
)
"""The words of IEC 61131-3, its standard functions and blocks, and of the dialects of CODESYS and TwinCAT."""

SIEMENS = IEC | _words(
    """
    begin data_block db end_data_block end_organization_block fb fc goto label end_label ob organization_block
    sdb sfb sfc title version author family name know_how_protect array any block_db block_fb block_fc counter timer
    s5time variant void dtl ltime nil ok region end_region pragma_begin pragma_end
    """
)
"""The words of SCL and of IEC 61131-3."""


@dataclass(frozen=True, slots=True)
class Target:
    """The reserved words of one kind of output. `folds`: case makes no difference. `escape` is the format of a reserved
    name."""

    name: str
    words: frozenset[str]
    folds: bool
    escape: str

    def legal_name(self, text: str) -> str:
        """The text, or its escaped form where it is a reserved word."""
        word = text.lower() if self.folds else text
        return self.escape.format(text) if word in self.words else text


TARGETS = {
    target.name: target
    for target in (
        Target("python", PYTHON, False, "{}_"),
        Target("c", C, False, "{}_"),
        # IEC 61131-3 has no name that ends in an underscore.
        Target("iec", IEC, True, "{}Value"),
        Target("siemens", SIEMENS, True, '"{}"'),
    )
}
