"""Audits: what shows that a spec is right, one section a question. `report.py` is the table of contents."""
