# Six scenes of two to four features each made by chance, beside twins of the same physics: base
# moved and turned, joints reversed, names and order, units, a link split, the other ways of
# derivation; modules of Python beside Fortran (make test-random takes 200).
. tests/tools/check.sh
export GSMBP_TWINS=short
to_the_end /usr/bin/python3 tests/twins/check.py "$GSMBP_TEST_DIR/twins_of_chance" 94 6 1
if /usr/bin/python3 tests/twins/check.py --one "$GSMBP_TEST_DIR/twins_of_chance" 101 heavier |
  grep -q '^wrong seed 101: (heavier) RHS'; then
  echo 'ok a mass that is larger by 1e-7 of itself is found'
else
  echo 'not ok a mass that is larger by 1e-7 of itself is not found'
fi
