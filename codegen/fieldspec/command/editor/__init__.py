"""Specs in an editor: what `fieldspec lsp` answers, on documents that need not be saved."""
