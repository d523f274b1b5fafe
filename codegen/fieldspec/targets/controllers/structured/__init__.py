"""Declarations and routines as Structured Text, in pieces: for plain text, TwinCAT files and PLCopen XML."""
