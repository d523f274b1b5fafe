"""Functions that convert what is on the wire to what a program works with, and back, for programmable controllers.

They are data: typed statements of the subset that IEC 61131-3 Structured Text and SCL have in common. Each dialect
prints the same statements, so that what is proven of one holds for the other.
"""
