"""Where the specs and layouts of a verb come from: folders, revisions, installed files, the cache."""
