# Six scenes made by chance, each by one way of coding, against the independent formulation in
# Python (make test-random takes 2000).
/usr/bin/python3 tests/random/check.py "$GSMBP_TEST_DIR/scenes_of_chance" 11 6 1
