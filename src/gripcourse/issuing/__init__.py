"""Who gets which variant, and what was issued: roster, register, signatures."""
