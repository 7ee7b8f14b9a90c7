## Optimal motions whose inputs the goal does not determine by itself: singular arcs found, told and
## made smooth; a motor within electrical limits. Expected values: closed forms, shooting.

function test_singular ()
  aly_chan (gsmbp_fixture ("optimal_block"));
  jacobson (gsmbp_fixture ("optimal_block"));
  motor (gsmbp_fixture ("optimal_motor"));
  limits (gsmbp_fixture ("optimal_motor"));
end

## Aly and Chan (1973): singular throughout, F = -sin t, the least value 0
function aly_chan (m)
  asked = {m, [0 1], [NaN NaN], "goal", {"x_b_d^2", 0.5, "x_b^2", -0.5}, "time", pi/2, ...
           "inputs", {"F", -1, 1}, "accuracy", 1e-5, "method"};
  for method = {"radau", "lobatto"}
    off = @(r) max (abs (r.v + sin (r.t)));
    rough = gsmbp_collocate (asked{:}, method{1}, "regularize", 0);
    gsmbp_check (sprintf ("%s: chatters by %.2g, is told so: %s", method{1}, off (rough), ...
                          rough.ended), off (rough) > 0.1 && numel (rough.singular) == 1 ...
                 && rough.singular.weight == 0 && strcmp (rough.singular.name, "F") ...
                 && ! isempty (strfind (rough.ended, "; F is singular from")));
    r = gsmbp_collocate (asked{:}, method{1});
    gsmbp_check (sprintf ("%s: made smooth: -sin t within 0.02, found %.2g, goal %.2g", ...
                          method{1}, off (r), r.goal), r.solved && off (r) < 0.02 ...
                 && abs (r.goal) < 1e-7 && r.singular.weight > 0 ...
                 && r.error < rough.meshes(numel (r.meshes)).error / 10 ...   # as fine a mesh
                 && ! isempty (strfind (r.ended, "made smooth")));
  end
end

## Jacobson, Gershwin and Lele (1970): at the limit, then singular from 1.4138 s
function jacobson (m)
  r = gsmbp_collocate (m, [0 1], [NaN NaN], "goal", {"x_b_d^2", 0.5, "x_b^2", 0.5}, "time", 5, ...
                       "inputs", {"F", -1, 1});
  gsmbp_check (sprintf ("a limit, then a singular arc from 1.414 s: found %.4f", ...
                        r.singular.from), r.solved && abs (r.goal - 0.37699193028794) < 2e-8 ...
               && abs (r.singular.from - 1.41376) < 0.02 && r.singular.until == 5);
  k = r.t > 1.6;
  gsmbp_check ("F = x on it", max (abs (r.v(k) - r.x(k,1))) < 1e-3);
  r = gsmbp_collocate (m, [0 0], [1 0], "time", [0.1 5], "inputs", {"F", -2, 2});
  gsmbp_check ("jumps are no singular arcs", isempty (r.singular) && strcmp (r.ended, "solved"));
end

## D3a: the copper loss of a motor with viscous friction; the loss has no voltage: it is singular.
function motor (m)
  for method = {"radau", "lobatto"}
    r = gsmbp_collocate (m, [0 0 NaN], [1 0 NaN], "goal", "loss", "time", 0.5, "method", ...
                         method{1}, "accuracy", 1e-8);
    off = r.goal / 4.43890294795247960 - 1;
    gsmbp_check (sprintf ("D3a, %s: energy within 1e-9, found %.2g, first current, %.2g", ...
                          method{1}, off, r.x(1,3) - 4.92362868494059950), ...
                 r.solved && abs (off) < 1e-9 && abs (r.x(1,3) - 4.92362868494059950) < 1e-4 ...
                 && strcmp (r.singular.name, "motor.v"));
  end
  i = @(t) 8.877805895904974 - 3.954177210964367 * exp (2.5 * t);
  gsmbp_check ("the current throughout", max (abs (r.x(:,3) - i (r.t))) < 1e-4);
end

## 4.2 A: at the limit, a + c exp(2.5 t), at the other; 6 V: two jumps of the voltage
function limits (m)
  r = gsmbp_collocate (m, [0 0 NaN], [1 0 NaN], "goal", "loss", "time", 0.5, "states", ...
                       {"motor.i", -4.2, 4.2}, "refinements", 9);
  off = r.goal - 4.46461102058745;
  gsmbp_check (sprintf ("4.2 A: 4.464611 J within 1e-8, found %.2g", off), ...
               r.solved && abs (off) < 1e-8 ...
               && isequal (sort ({r.active.bound}), {"largest", "least"}));
  r = gsmbp_collocate (m, [0 0 0], [1 0 0], "time", [0.1 5], "inputs", {"motor.v", -6, 6});
  off = [r.switches; r.T] - [0.2369330022314; 0.3808333903223; 0.3878007761818];
  gsmbp_check (sprintf ("6 V: 0.3878 s, jumps within 1e-8, found %.2g", norm (off, Inf)), ...
               r.solved && norm (off, Inf) < 1e-8);
end
