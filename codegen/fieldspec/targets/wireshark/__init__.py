"""The Wireshark output: a dissector in Lua for each version of a device."""
