# Six trees and loops with beams made by chance against an absolute Lagrange formulation in Python
# (make test-random takes as many as it is told).
/usr/bin/python3 tests/random/beams.py "$GSMBP_TEST_DIR/beams_of_chance" 7 6
