"""Scenarios that ship with Barchan: title, citation and what to look for."""
