"""Audits: evidence that a spec is right, one section for each question. `report.py` is the table of contents."""
