"""Evidence from real units: what dumps, scans and captures of them show of each fact of a spec."""
