"""Findings, changes, facts and audits as text for people and for programs."""
