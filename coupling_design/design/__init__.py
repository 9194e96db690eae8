"""What should the coupling be?"""
