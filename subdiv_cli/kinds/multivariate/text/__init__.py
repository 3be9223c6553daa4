"""The text of a mask in several variables: the forms of [mask], one a file, and the way back in `writing`.

`reading` is where the reader comes in; the forms themselves are data, in `bodies`.
"""
