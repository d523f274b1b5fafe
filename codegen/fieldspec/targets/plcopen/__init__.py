"""The output as PLCopen TC6 XML."""
