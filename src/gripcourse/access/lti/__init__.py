"""Learning platforms by LTI 1.3: who is let in by one, and what is sent back to it.

What is signed is read and written by a library of its own (`joserfc`); here stand the rules of the
standard about it, each of them once.
"""
