"""Text lists for operator panels: alarms, faults, warnings and other codes, with causes and remedies."""
