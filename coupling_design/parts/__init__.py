"""What wears, and what is it rated for? A package a part, strangers to each other.

Knows loads and speeds, not what makes them.
"""
