## The handles of a model: the subroutines against each other, double against quad, parameters, what
## a wrong argument is told, what is built anew.

function test_handles ()
  m = gsmbp_hand ("motor_pendulum");
  c = gsmbp_hand ("hand_crank");
  each_other (m);
  precision (m, "motor_pendulum");
  precision (c, "hand_crank");
  parameters (m);
  wrong (m, c);
  of_the_json (m);
  outputs_of_a_run (m);
  divided ();
  built_once ();
  saved (m);
end

## a subroutine that no table knows has the handle that its row in the JSON tells
function of_the_json (m)
  [told, info] = m.toy (0, 0.7, -0.4);
  kinetic = m.mas (0, 0.7) * 0.4 ^ 2 / 2;
  gsmbp_check ("a handle from the JSON alone", [told(1) - kinetic; info], 1e-15);
  gsmbp_check ("... in quad precision", ...
               gsmbp_hand ("motor_pendulum", "precision", "quad").toy (0, 0.7, -0.4) - told, 1e-15);
  says (@() m.toy (0, 0.7), ...
        "motor_pendulum.toy: argument u is missing; expected m.toy (t, q, u[, v])");
  says (@() m.toy (0, [1; 2], 0), "motor_pendulum.toy: argument q: expected 1 number, found 2x1");
  says (@() m.toy (0, 3, 0), "motor_pendulum.toy: INFO = 1: the pendulum stands on its head");
end

## a model that is saved, as part of a result too, is the same one when it is loaded
function saved (m)
  file = tempname ();
  for format = {"-binary", "-text"}
    save (format{1}, file, "m");
    other = load (file).m;
    unlink (file);
    x = m.initial + 0.1;
    gsmbp_check (["saved as " format{1}(2:end)], other.rhs (0.2, x, 3) - m.rhs (0.2, x, 3), 0);
  end
end

## the outputs of a result are those of m.out, which the interpreter does not call for each row; a
## row that holds no numbers has none
function outputs_of_a_run (m)
  t = 0:0.01:0.2;
  lame = m;
  lame.out = @(varargin) error ("m.out is called");
  r = gsmbp_simulate (lame, [0.2, 0, 0], t, "input", 3);
  wanted = arrayfun (@(k) m.out (t(k), r.x(k,:), r.v(k,:)), 1:numel (t))';
  gsmbp_check ("outputs of a run without a call of m.out for each row", r.y - wanted, 0);
  plan = gsmbp_plan ("quintic", [0.2, 0.5], [0, 0.2]);
  r = gsmbp_inverse (lame, plan, t, "input", 1);   # v is not determined
  gsmbp_check ("outputs where inputs are none", isnan (r.y));
  r = gsmbp_inverse (lame, plan, t);
  wanted = arrayfun (@(k) m.out (t(k), r.x(k,:), r.v(k,:)), 1:numel (t))';
  gsmbp_check ("outputs along an inverse motion", r.y - wanted, 0);
  part = @(varargin) m.module ("outputs", m.cst, 2, varargin{:});
  gsmbp_check ("... without inputs", part ([0; 1], ones (2, 3), []) ...
                                     - part ([0; 1], ones (2, 3), [0; 0]), 0);
  says (@() part ([0; 1], ones (3, 2), []), ...
        "motor_pendulum.outputs: argument states: expected 2 x 3, found 3x2");
  says (@() part (0, ones (2, 3), []), "outputs: argument times: expected 2 x 1, found 1x1");
  says (@() part ([0; 1], ones (2, 3), 1), "outputs: argument inputs: expected 2 x 1, found 1x1");
  says (@() part ([0; 1], [], []), "outputs: argument states: expected 2 x 3, found 0x0");
  m.states = {"x"; "t"; "y"};   # names that a result has itself
  r = gsmbp_simulate (m, [0.2, 0, 0], t, "input", 3);
  gsmbp_check ("states x, t, y by name", [r.of.("x"), r.of.("t"), r.of.("y")] - r.x, 0);
  gsmbp_check ("... times are still t", r.t - t', 0);
  file = [tempname() ".csv"];
  gsmbp_csv (file, m, r, {"t", "x", "y"});
  gsmbp_check ("... in a table", isequal (strtok (fileread (file), "\n"), ...
                                          "t [s],t [rad/s],x [rad],y [A]"));
  delete (file);
end

function each_other (m)
  [q, u, ud] = deal (0.7, -0.4, 2);
  tau = m.inv (0, q, u, ud, 0);
  gsmbp_check ("fwd inverts inv", m.fwd (0, q, u, 0, tau) - ud, 1e-14);
  gsmbp_check ("inv = mas*ud + bia", m.mas (0, q) * ud + m.bia (0, q, u) - tau, 1e-14);
  gsmbp_check ("v may be left out or empty", [m.inv(0, q, u, ud), m.inv(0, q, u, ud, [])] - tau, 0);
  x = [q; u; 0.3];
  [A, B, C, D] = m.jac (0, x, 1);
  h = 1e-6;
  for k = 1:3
    e = h * ((1:3)' == k);
    numeric(:,k) = (m.rhs (0, x + e, 1) - m.rhs (0, x - e, 1)) / (2 * h);
    outputs(:,k) = (m.out (0, x + e, 1) - m.out (0, x - e, 1)) / (2 * h);
  end
  gsmbp_check ("jac against differences of rhs and out", ...
               [A - numeric; C - outputs] ./ max (1, norm (A)), 1e-9);
  gsmbp_check ("sizes of B and D", isequal (size (B), [3, 1]) && isequal (size (D), [1, 1]));
  sys = gsmbp_linear (m, 0, x, 1);
  gsmbp_check ("gsmbp_linear has the names", ...
               isequal (get (sys, "stname"), m.states) ...
                 && isequal (get (sys, "inname"), m.inputs) ...
                 && isequal (get (sys, "outname"), m.outputs));
  [a, b, c] = ssdata (sys);
  gsmbp_check ("gsmbp_linear has the matrices", [a - A, b - B; c - C, 0], 0);
  gsmbp_check ("row or column, the same", m.rhs (0, x', 1) - m.rhs (0, x, 1), 0);
end

## the quad module rounds its exact result once: double must agree to a few units of the last place
function precision (m, name)
  q = gsmbp_hand (name, "precision", "quad");
  x = m.initial + 0.1 * (1:m.sizes.nx)';
  v = 0.3 * ones (m.sizes.nv, 1);
  d = m.sizes;
  [q0, u0] = deal (x(1:d.nq), x(d.nq + (1:d.nu)));
  gsmbp_check ([name, " rhs in double against quad"], ...
               relative (m.rhs (0, x, v), q.rhs (0, x, v)), 1e-14);
  gsmbp_check ([name, " inv in double against quad"], ...
               relative (m.inv (0, q0, u0, u0, v), q.inv (0, q0, u0, u0, v)), 1e-15);
  gsmbp_check ([name, " mas in double against quad"], relative (m.mas (0, q0), q.mas (0, q0)), ...
               1e-15);
  par = [fieldnames(m.par)'(1:2); {0.3, 0.7}];
  gsmbp_check ([name, " new parameters in double against quad"], ...
               relative (gsmbp_set (m, par{:}).rhs (0, x, v), ...
                         gsmbp_set (q, par{:}).rhs (0, x, v)), 1e-14);
end

function e = relative (a, b)
  e = norm (a(:) - b(:)) / norm (b(:));
end

function parameters (m)
  half = gsmbp_set (m, "g", 9.81 / 2);
  gsmbp_check ("a parameter changed", half.inv (0, 1, 0, 0) - m.inv (0, 1, 0, 0) / 2, 1e-15);
  gsmbp_check ("the first model keeps its own", m.par.g - 9.81, 0);
  both = gsmbp_set (m, struct ("g", 9.81 / 2, "l", 1));
  gsmbp_check ("parameters from a struct", both.inv (0, 1, 0, 0) - m.inv (0, 1, 0, 0), 1e-15);
end

## every mistake: an error that names the argument, what was expected and what was found
function wrong (m, c)
  says (@() m.rhs (0, [1; 2]), "motor_pendulum.rhs: argument x: expected 3 numbers, found 2x1");
  says (@() m.rhs (0, [1; 2; 3], [1, 2]), ...
        "motor_pendulum.rhs: argument v: expected 1 number, found 1x2");
  says (@() m.rhs (NaN, [1; 2; 3]), "motor_pendulum.rhs: argument t is not finite: NaN");
  says (@() m.rhs (0, [1; -Inf; 3]), "motor_pendulum.rhs: argument x(2) is not finite: -Inf");
  says (@() m.rhs (0, {1}), "motor_pendulum.rhs: argument x: expected real numbers, found cell");
  says (@() m.rhs (0, [1; 2i; 3]), ...
        "motor_pendulum.rhs: argument x: expected real numbers, found complex");
  says (@() m.inv (0, 1, 2, [1; 2]), ...
        "motor_pendulum.inv: argument ud: expected 1 number, found 2x1");
  says (@() m.fwd (0, 1, 2, 0, "a"), ...
        "motor_pendulum.fwd: argument tau: expected real numbers, found char");
  says (@() c.con (0, [1; 2], [1; 2; 3]), ...
        "hand_crank.con: argument q: expected 3 numbers, found 2x1");
  says (@() c.cmd (0, zeros (3, 2)), "hand_crank.cmd: argument qj: expected 3 x 3, found 3x2");
  says (@() c.clo (0, [1, 0, 0; NaN, 0, 0; 0, 0, 0]), ...
        "hand_crank.clo: argument qj(2,1) is not finite: NaN");
  says (@() m.inv (0, ones (1, 1, 2), 0, 0), ...
        "motor_pendulum.inv: argument q: expected a matrix, found 1x1x2");
  says (@() gsmbp_set (m, "mass", 1), "unknown parameter \"mass\"; known: g, l, m,");
  says (@() gsmbp_set (m, "g", NaN), "parameter g must be one finite number, found: NaN");
  says (@() gsmbp_build ("motor_pendulum", "precision", "half"), ...
        "option precision: expected one of \"double\", \"quad\", found \"half\"");
  says (@() gsmbp_simulate (c, gsmbp_assemble (c, [0.3, -0.1, 0.7]), [0, 1], "motion", ...
                            gsmbp_plan ("quintic", [0, 1; 0, 1], [0, 1])),
        "expected 1 components (q1), found 2");
  says (@() gsmbp_simulate (m, [0; 0; 0], [0, 1], "audit", true), ...
        "gsmbp_simulate: option audit: expected a finite number above 0, found true");
  says (@() gsmbp_simulate (m, [0; 0; 0], [0, 1], "maxorder", true), ...
        "gsmbp_simulate: option maxorder: expected a finite number, found true");
  short = gsmbp_set (c, "l2", 0.1);
  [qj, res, info] = short.clo (0, [pi/2, 0, 0; 0, 0, 0; 0, 0, 0]);
  gsmbp_check ("INFO as last output is no error", info == 3 && abs (res(1) - 0.1) < 1e-15);
  says (@() short.clo (0, [pi/2, 0, 0; 0, 0, 0; 0, 0, 0]), ...
        "hand_crank.clo: INFO = 3: the iteration did not converge");
  says (@() gsmbp_set (c, "l2", -1), "hand_crank.pre: INFO = -1");
end

## the passes that divide by lengths: the same efforts, and an error where such a length becomes 0
function divided ()
  root = fileparts (fileparts (fileparts (mfilename ("fullpath"))));
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "divided");
  models = {};
  for passes = {"gsmbp_passes", "gsmbp_all_passes"}
    place = fullfile (folder, passes{1});
    [status, text] = ...
        system (sprintf (["'%s/share/make/maxima' '%s/log' 'load(\"%s/gsmbp/gsmbp.mac\")$ " ...
                          "load(\"%s/tests/bench/systems/pend2.mac\")$ gsmbp_passes : %s$ " ...
                          "gsmbp_fortran(scene, [inverse], [directory = \"%s\"])$' 2>&1"],
                                      root, place, root, root, passes{1}, place));
    if (! gsmbp_check ([passes{1} ": derived"], status == 0))
      puts (text);
      return;
    end
    models{end+1} = gsmbp_build ("pend2", "directory", place);
  end
  given = {0, [0.3; -1.2], [0.7; 2], [-1; 0.4]};
  efforts = cellfun (@(m) m.inv (given{:}), models, "UniformOutput", false);
  gsmbp_check ("gauge and unit change no efforts", relative (efforts{2}, efforts{1}), 1e-15);
  says (@() gsmbp_set (models{2}, "a2", 0), ...
        "pend2.pre: INFO = 4: a length is 0 by which these equations divide");
  gsmbp_check ("without them the length may be 0", ...
               all (isfinite (gsmbp_set (models{1}, "a2", 0).inv (given{:}))));
end

function says (f, text)
  found = "no error";
  try
    f ();
  catch err
    found = err.message;
  end
  passed = gsmbp_check (sprintf ("message: %s", text), ! isempty (strfind (found, text)));
  if (! passed)
    printf ("  found: %s\n", found);
  end
end

## a second build takes nothing but a look at the files; a newer source is compiled and takes the
## place of the old one
function built_once ()
  folder = tempname ();
  mkdir (folder);
  here = fileparts (which ("gsmbp_hand"));
  copyfile (fullfile (here, "motor_pendulum.*"), folder);
  unwind_protect
    build = fileparts (fileparts (fileparts (gsmbp_hand ("motor_pendulum").file)));
    source = fullfile (folder, "motor_pendulum.f");
    m = gsmbp_build ("motor_pendulum", "directory", folder, "build", build);
    before = stat (m.file);
    m = gsmbp_build ("motor_pendulum", "directory", folder, "build", build);
    gsmbp_check ("a second build compiles nothing", ...
                 stat (m.file).mtime == before.mtime && stat (m.file).ino == before.ino);
    text = strrep (fileread (source), "PAR(1) = 9.81D0", "PAR(1) = 1.62D0");
    f = fopen (source, "w");
    fputs (f, text);
    fclose (f);
    m = gsmbp_build ("motor_pendulum", "directory", folder, "build", build);
    gsmbp_check ("a newer source is compiled and used", m.par.g - 1.62, 0);
    f = fopen (source, "w");
    fputs (f, "      this is no Fortran\n");
    fclose (f);
    says (@() gsmbp_build ("motor_pendulum", "directory", folder, "build", build), ...
          "motor_pendulum.f has no SUBROUTINE MOTOR_PENDULUM_PAR");
    f = fopen (source, "w");
    fputs (f, strrep (text, "PAR(1) = 1.62D0", "this is no Fortran"));
    fclose (f);
    says (@() gsmbp_build ("motor_pendulum", "directory", folder, "build", build), ...
          "Unclassifiable statement");
    delete (m.file);
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
end
