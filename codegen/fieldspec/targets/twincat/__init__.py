"""The output as source files of TwinCAT 3."""
