"""What the explanation of a frame is made of: marks, values, bodies, registers. `layout.explanation` joins it."""
