"""Adapters between the blocks of a device and the communication of a controller, and programs that use both."""
