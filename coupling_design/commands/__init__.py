"""What can one ask of it? One module per command of the command line."""
