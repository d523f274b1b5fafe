"""Carriers of bytes: serial ports, pseudo-terminals, TCP, UDP and WebSockets. They know no frames."""
