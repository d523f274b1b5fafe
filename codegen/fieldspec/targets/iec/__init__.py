"""The output as Structured Text that compilers of IEC 61131-3 take."""
