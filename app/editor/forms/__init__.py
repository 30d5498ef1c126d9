"""Parts of forms that several panels use: ordered lists, choosing by typing, slots, words beside a field."""
