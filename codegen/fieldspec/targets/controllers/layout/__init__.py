"""Where controllers put the members of structs in their memory, and whether that is where they lie on the wire."""
