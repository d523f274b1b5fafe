"""What bytes mean: layouts, explanations of frames, and the reference that every other codec is compared with."""
