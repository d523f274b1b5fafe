"""Register lists in files: reads them whatever their columns are, writes them, and compares them with a device."""
