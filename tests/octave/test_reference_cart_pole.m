## Cart and pole: the state space's exact Jacobians upright and hanging.

function test_reference_cart_pole ()
  m = gsmbp_fixture ("case_15a");
  [~, ref] = gsmbp_case ("15a_cart_pole_linear");
  for place = {"upright", "hanging"}
    wanted = ref.values.(place{1});
    x = [0; pi * strcmp(place{1}, "hanging"); 0; 0];
    [A, B, C, D] = m.jac (0, x, 0);
    A_wanted = ne_numbers (wanted.A);
    gsmbp_check (["cart_pole: A " place{1}], (A - A_wanted) / max (abs (A_wanted(:))), 1e-13);
    gsmbp_check (["cart_pole: B " place{1}], ...
                 (B - ne_numbers (wanted.B)) / max (abs (ne_numbers (wanted.B))), 1e-13);
    gsmbp_check (["cart_pole: C, D " place{1}], [C - eye(2, 4), D], 0);
    poles = ordered (ne_numbers (wanted.eig));
    found = ordered ([real(eig (A)), imag(eig (A))]);
    ## the double-precision matrix moves a pole near zero by a few units of its largest entry, 21
    gsmbp_check (["cart_pole: poles " place{1}], found - poles, 1e-12);
  end
end

## rows [real, imaginary] in an order that rounding does not change
function z = ordered (z)
  [~, order] = sortrows (round (z * 1e6));
  z = z(order, :);
end
