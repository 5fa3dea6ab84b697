"""What WeasyPrint works out anew for each document, worked out once for all documents of a process.

Reports of a class are the same words in the same few styles. Kept are the styles of elements that
stand alike, lines of text as Pango shaped and WeasyPrint drew them, and the sizes of boxes.

WeasyPrint has no public place for any of this, so functions of its own are replaced by name: only
while a document of ours is laid out, and only in the one version whose source was read for it. In
any other, and wherever a value is not of a kind that was thought of, WeasyPrint does the work
itself, with the same bytes. `switch` puts the functions in place, `bounded` is what they keep
things in; `styles`, `lines`, `drawings` and `sizes` must not be imported before `switch` has found
the version to be the one it knows.
"""
