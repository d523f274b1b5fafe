"""What is proven by running things: examples through the reference codec, errata by putting the print back."""
