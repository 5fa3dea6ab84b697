"""Kinds of documents, a module each, in which `KIND` says what `documents.registry` needs."""
