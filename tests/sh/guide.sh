#!/bin/sh
# The maps are true: gsmbp/README.md, share/fortran/README.md, share/c/README.md and tests/README.md
# name every file and routine that is there and none that is not; comments name files that exist;
# one version.
/usr/bin/python3 tests/tools/guide.py .
