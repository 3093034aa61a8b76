"""What a model of snow is composed of: parameters, layers, the bond clock, and the state under a wind."""
