"""Plants: species and their growth curves, and how they stand on a field.

Nothing here knows what plants do to the wind: that is a model's or a closure's business.
"""
