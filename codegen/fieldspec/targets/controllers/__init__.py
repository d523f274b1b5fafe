"""What all outputs for programmable controllers share: dialects, names, declarations, layouts in memory, routines."""
