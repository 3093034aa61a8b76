"""Snow: stacks of layers of unlike density and age, and the polls that move one quantum of mass at a time."""
