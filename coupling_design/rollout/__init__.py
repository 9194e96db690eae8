"""Marching a step over many steps; nothing here knows of drivelines."""
