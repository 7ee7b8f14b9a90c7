# Sessions that the manual, the help texts and the README print, typed and compared: part 3 of 4.
PATH=/usr/lib/ccache:$PATH exec /usr/bin/python3 tests/tools/sessions.py --part=3/4
