"""Decoding as queries: SQL for DuckDB, and expressions for Polars."""
