## c = ne_cross (A, B): cross product of two columns (cross is slow).

function c = ne_cross (a, b)
  c = [a(2) * b(3) - a(3) * b(2); a(3) * b(1) - a(1) * b(3); a(1) * b(2) - a(2) * b(1)];
end
