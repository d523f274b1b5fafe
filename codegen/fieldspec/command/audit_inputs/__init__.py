"""What `audit` reads beside the spec: manuals, reviews, captures and evidence."""
