# Sessions printed in help texts of Octave, in the README and with the functions of Maxima are
# typed and compared; those of the other chapters by manual.sh.
/usr/bin/python3 tests/tools/sessions.py share/manual/functions.texi share/manual/examples.texi \
  octave/gsmbp_*.m README.md
