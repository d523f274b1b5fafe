"""Proofs by running: examples through the reference codec, errata by putting the printed value back."""
