"""Results that others published, set up again and compared with what they reported."""
