"""A server that answers every request for one register with the same frame, as fast as a loop can: prints its port."""

from __future__ import annotations

import socket

ANSWER = bytes.fromhex("01 03 02 00 05 78 47")


def main() -> None:
    """Serves one connection after the other."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        print(listener.getsockname()[1], flush=True)
        while True:
            connection, _ = listener.accept()
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            with connection:
                while connection.recv(256):
                    connection.sendall(ANSWER)


if __name__ == "__main__":
    main()
