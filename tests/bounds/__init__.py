"""Every preset for a few steps with every access to an array checked."""
