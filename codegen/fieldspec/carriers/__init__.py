"""Carriers of bytes: serial ports, pseudo-terminals, TCP and UDP. They know no frames."""
