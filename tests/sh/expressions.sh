# Forty expressions made by chance in every place of a scene: what is literal is what is emitted
# (make test-random takes 300).
tests/random/expressions 40 1
