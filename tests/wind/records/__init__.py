"""Wind records: files as people and providers write them."""
