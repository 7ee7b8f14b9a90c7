## The handles of a model called wrongly: every handle, every argument of it, every kind of wrong
## value. The error names the handle and the argument, and says what was expected and what was
## found; nothing else is touched. Also: subroutines that a scene does not have, and files of scenes
## that are damaged.

function test_calls ()
  models = {gsmbp_hand("hand_crank"), gsmbp_fixture("redundant_bricard"), ...
            gsmbp_fixture("batch_arm"), gsmbp_fixture("sampled_drive"), ...
                gsmbp_fixture("event_arm"), ...
            gsmbp_fixture("rolling_disc"), gsmbp_fixture("base_tree"), ...
                gsmbp_fixture("trim_hydraulic"), gsmbp_fixture("points_bars"), ...
                gsmbp_fixture("points_puma"), gsmbp_fixture("sensitivity_crank"), ...
            gsmbp_fixture("sensitivity_belt")};
  called = {};
  for k = 1:numel (models)
    called = union (called, every_handle (models{k}));
  end
  fields = fieldnames (models{1})(structfun (@is_function_handle, models{1}));
  ## CTP and SWI take nothing: test_sampled, test_switches
  others = setxor (fields, [fieldnames(signatures ()); {"module"; "ctp"; "swi"}]);
  gsmbp_check (["all functions of a model are called: ", strjoin(others', ", ")], isempty (others));
  gsmbp_check (sprintf ("each handle was called wrongly: %s", ...
                        strjoin (setdiff (fieldnames (signatures ()), called), ", ")), ...
               isequal (called(:), sort (fieldnames (signatures ()))));
  absent (models);
  many (models{[1, 4, 7, 6]});
  no_orientation (gsmbp_fixture ("rolling_disc"), gsmbp_fixture ("batch_arm"));
  rank_once (gsmbp_fixture ("redundant_bricard"));
  meanings (models{1});
  sentences (models);
  provoked (models{1});
  damaged ();
  cut_modules ();
  altered ();
end

## a handle of one state called at many, as the package's own functions do
function many (crank, sampled, tree, disc)
  [nq, n] = deal (tree.sizes.nq, tree.sizes.nu);
  [q, u, ud, v] = deal (rand (nq, 5), rand (n, 5), rand (n, 5), rand (tree.sizes.nv, 1));
  at = @(varargin) tree.module ("many", "reg", tree.cst, varargin{:});
  [Y, p, r] = at (0, q, u, ud, v);
  same = size (Y, 3) == 5;
  for k = 1:5
    [one, values, rest] = tree.reg (0, q(:,k), u(:,k), ud(:,k), v);
    same &= isequal (one, Y(:,:,k)) && isequal (values, p(:,k)) && isequal (rest, r(:,k));
  end
  gsmbp_check ("many states: as one by one", same);
  [a, b] = deal (rand (crank.sizes.nq, 3), rand (crank.sizes.nu, 3));
  [phi, ~, ~, ~, info] = crank.module ("many", "con", crank.cst, 0, a, b);
  gsmbp_check ("... with indicators", isequal (info, zeros (1, 3)) ...
               && isequal (phi(:,2), crank.con (0, a(:,2), b(:,2))));
  says = @(text, f) gsmbp_check (["many states: " text], any (strfind (gsmbp_complaint (f), text)));
  says ("argument u: expected 5 columns (or one for all), found 4", ...
        @() at (0, q, u(:,1:4), ud, v));
  says ("reg: argument ud is missing", @() at (0, q, u));
  says ("argument q(1,3) is not finite: NaN", @() at (0, [rand(1, 2), NaN; rand(nq-1, 3)], u, ud));
  says ("found zeros, which are no orientation", @() disc.module ( ...
    "many", "mas", disc.cst, 0, [disc.initial(1:disc.sizes.nq), zeros(disc.sizes.nq, 1)]));
  says ("ctl: it is called at one state", @() sampled.module ("many", "ctl", sampled.cst, 1, 0, ...
                                                              0, 0));
  says ("expected the name of a subroutine and its arguments", ...
        @() crank.module ("many", "nothing", crank.cst, 0));
end

## the arguments of each handle; those from the second number on may be left out
function s = signatures ()
  s = struct ("kin", {{"t q u", 3}}, "inv", {{"t q u ud v", 4}}, "mas", {{"t q", ...
        2}}, "reg", {{"t q u ud v", 4}}, "bia", {{"t q u v", 3}}, "fwd", {{"t q u v tau", 3}},
              "con", {{"t q u", 2}}, "inl", {{"t q u ud v", 4}}, "lin", {{"t q u ud v", ...
                    4}}, "rhs", {{"t x v", 2}}, "acc", {{"t x v", 2}}, "acd", {{"t x v way", ...
                    4}},
              "tan", {{"t x", 2}}, "prj", {{"t x", 2}}, "jac", {{"t x v", 2}},
              "jad", {{"t x v", 2}}, "pnj", {{"t q", 2}}, "pnr", {{"t q u", 3}},
              "rhp", {{"t x v", 2}}, "inp", {{"t q u ud v", 4}}, "oup", {{"t x v", 2}},
              "ilp", {{"t q u ud v taua lam", 7}}, "evp", {{"t x v mode k", 5}},
              "adj", {{"t x v l", 4}},
              "cop", {{"t x", 2}}, "out", {{"t x v", ...
                    2}}, "cmd", {{"t qj xi", 2}}, "cmx", {{"t qj xi", 2}},
              "cmp", {{"t qj xi", 2}}, "cmj", {{"t qj xi", 2}},
              "ctl", {{"k t y xk v", 4}}, "evt", {{"t x v mode", 4}}, "hld", {{"t x v", 2}},
              "rst", {{"t x v mode k", 5}}, "clo", {{"t qj", 2}}, "ene", {{"t x v", 2}},
              "ske", {{"t q", 2}}, "mar", {{"t x v", 2}},
              "pnt", {{"t q", 2}}, "jpt", {{"t q u", 3}}, "gra", {{"t q", 2}}, "cor", {{"t q u", ...
                    3}}, "ind", {{"t q u", 3}}, "red", {{"t q u v", 3}}, "jpi", {{"t q u", 3}},
              "pnt_v", {{"t q", 2}}, "jpt_v", {{"t q u", 3}},
              "inv_v", {{"t q u ud v", 4}}, "mas_v", {{"t q", 2}}, "bia_v", {{"t q u v", ...
                    3}}, "fwd_v", {{"t q u v tau", 3}}, "rhs_v", {{"t x v", 2}});
end

function done = every_handle (m)
  done = {};
  all_of = signatures ();
  for name = intersect (fieldnames (all_of)', m.subroutines')
    [text, needed] = all_of.(name{1}){:};
    names = strsplit (text, " ");
    good = cellfun (@(n) right (m, n), names, "UniformOutput", false);
    many = ! isempty (regexp (name{1}, '_v$', "once"));
    wrong = 0;
    total = 0;
    for k = 1:numel (names)
      if (k <= needed)
        [wrong, total] = count (wrong, total, m, name{1}, names{k}, good(1:k-1), ...
                                "is missing; expected m\\.");
      end
      for bad = kinds (good{k}, names{k}, many)
        given = good;
        given{k} = bad{1}{1};
        [wrong, total] = count (wrong, total, m, name{1}, names{k}, given, bad{1}{2});
      end
    end
    [wrong, total] = count (wrong, total, m, name{1}, "", [good, {0}], ...
                            sprintf ("expected m\\.%s \\(.*\\), at most %d arguments, found %d", ...
                                     name{1}, numel (names), numel (names) + 1));
    f = m.(name{1});
    try
      f (good{:});
    catch err
      if (! any (strcmp (err.identifier, {"gsmbp:info"})))
        printf ("  %s.%s, rightly called: %s\n", m.name, name{1}, err.message);
        wrong++;
      end
    end
    done{end+1} = name{1};
    gsmbp_check (sprintf ("%s.%s: %d wrong calls", m.name, name{1}, total), wrong == 0);
  end
end

function x = right (m, name)
  d = m.sizes;
  q = m.initial(1:d.nq);
  switch (name)
    case "t"             x = 0;
    case {"way", "k"}    x = 1;
    case "taua"          x = zeros (d.nact, 1);
    case "lam"           x = zeros (d.nlam, 1);
    case "q"             x = q;
    case {"u", "ud", "tau"}  x = zeros (d.nu, 1);
    case "x"             x = m.initial;
    case "v"             x = zeros (d.nv, 1);
    case "y"             x = zeros (d.ny, 1);
    case "l"             x = zeros (d.nx, 1);
    case "xk"            x = zeros (size_of (d, "nxk"), 1);
    case "mode"          x = zeros (size_of (d, "nmode"), 1);
    case "xi"            x = zeros (size_of (d, "na"), 1);
    case "qj"            x = [m.initial(1:d.nu), zeros(d.nu, d.nqj)];
  end
end

## descriptions written by hand leave some out
function n = size_of (d, name)
  n = 0;
  if (isfield (d, name))
    n = d.(name);
  end
end

## {value, what is said of it}
function list = kinds (x, name, many)
  n = numel (x);
  list = {{repmat(x, 1, 1, 2), "expected"}, {{1}, "expected .*found cell"}, ...
          {struct("a", 1), "expected .*found .*struct"}, ...
          {@sin, "expected .*found function_handle"}, {"text", "expected .*found char"}};
  if (n == 0)   # nothing to give is never wrong in its kind
    list = {{1, "expected 0"}};
    return;
  end
  list{end+1} = {x + 1i, "expected real numbers, found complex"};
  wider = [x; x(end,:)];
  list{end+1} = {wider, "expected .*found"};
  if (! any (strcmp (name, {"t", "k", "way"})))
    list{end+1} = {x(1:end-1,:), "expected .*found|is missing"};
  end
  if (! many)   # a state that is no number is the matter of that state
    for value = [NaN, Inf, -Inf, 1e301]
      bad = x;
      bad(end) = value;
      list{end+1} = {bad, "is not finite"};
    end
  end
  if (any (strcmp (name, {"way", "k", "mode"})))
    list = [list, ...
            {{0 * x + 0.5, "expected whole numbers, found 0\\.5"}, ...
             {0 * x - 7, "expected .*found -7"}, {0 * x + 77, "expected .*found 77"}}];
  end
end

function [wrong, total] = count (wrong, total, m, handle, argument, given, what)
  total++;
  if (isempty (given) && isempty (argument))
    return;
  end
  found = "no error";
  f = m.(handle);
  try
    f (given{:});
  catch err
    found = err.message;
  end
  ## an optional argument that is empty is one that was left out
  if (strcmp (found, "no error") && any (cellfun (@isempty, given)))
    return;
  end
  place = sprintf ("^%s\\.%s: ", m.name, handle);
  if (! isempty (argument))
    place = [place "argument " argument "[ :(]"];
  end
  if (isempty (regexp (found, place, "once")) || isempty (regexp (found, what, "once")) ...
        || any (found == "\n"))
    wrong++;
    printf ("  %s.%s, argument %s, expected to be told \"%s\", found: %s\n", m.name, handle, ...
            argument, what, found);
  end
end

## a handle of a subroutine that the scene was emitted without says why, or what to ask for
function absent (models)
  reasons = ...
      ["it has no loops|no device of it has a margin that its state decides|it has neither " ...
       "loops nor Euler parameters|it has no sampled devices|it has no events|it has no " ...
       "outputs|derive it with the request \\w+ of gsmbp_fortran"];
  for k = 1:numel (models)
    m = models{k};
    said = true (1, 0);
    [impossible, why] = left_out (m);
    for name = setdiff (fieldnames (signatures ()), m.subroutines)'
      found = gsmbp_complaint (@() m.(name{1}) (0));
      told = regexp (found, sprintf (["^%s\\.%s: the scene was emitted without the " ...
                                      "subroutine %s: (%s)$"], m.name, name{1}, ...
                                     upper (name{1}), strjoin ([{reasons}, why], "|")), ...
                     "once");
      asked = regexp (found, 'request (\w+) of gsmbp_fortran', "tokens", "once");
      said(end+1) = ! isempty (told) && ! any (ismember (asked, impossible));
      if (! said(end))
        printf ("  %s\n", found);
      end
    end
    gsmbp_check (sprintf ("%s: %d handles without a subroutine", m.name, numel (said)), all (said));
    if (isequal (ismember ({"rhs", "cmd"}, m.subroutines), [true, false]) && m.sizes.nlam == 0)
      motion = gsmbp_plan ("quintic", [zeros(m.sizes.nu, 1), ones(m.sizes.nu, 1)], [0, 1]);
      gsmbp_check ([m.name ": a motion without CMD is the error of the handle"], ...
                   strcmp (gsmbp_complaint (@() gsmbp_simulate (m, m.initial, [0, 1], ...
                                                                "motion", motion)), ...
                           gsmbp_complaint (@() m.cmd (0))));
    end
  end
end

## requests that the scene cannot have, and the reasons as regular expressions
function [requests, reasons] = left_out (m)
  [requests, reasons] = deal ({});
  if (! isfield (m.json, "left_out"))
    return
  end
  for one = m.json.left_out(:)'
    if (isempty (strfind (one.reason, "made on request")))
      requests{end+1} = one.request;
      reasons{end+1} = regexptranslate ("escape", one.reason);
    end
  end
end

function no_orientation (m, batch)
  x = m.initial;
  x(m.orientation(1,:)) = 0;
  q = x(1:m.sizes.nq);
  calls = struct ("rhs", {{0, x}}, "mas", {{0, q}}, "prj", {{0, x}}, "con", {{0, q}}, "jac", ...
                  {{0, x}}, "ene", {{0, x}}, "ske", {{0, q}});
  for [given, name] = calls
    found = gsmbp_complaint (@() m.(name) (given{:}));
    gsmbp_check (["Euler parameters that are all zero: " name], ...
                 ! isempty (regexp (found, ...
                                    sprintf (["^%s\\.%s: argument [qx]: expected Euler " ...
                                              "parameters of length 1 in " ...
                                        "[qx]\\(4\\), .*found zeros"], m.name, name), "once")));
  end
  if (! isempty (batch.orientation))
    X = [batch.initial, batch.initial];
    X(batch.orientation(1,:),2) = 0;
    [xd, info] = batch.rhs_v (0, X);
    gsmbp_check ("of many states the one without orientation has its own INFO", ...
                 info(1) == 0 && info(2) < 0 && all (isnan (xd(:,2))));
  end
end

## lost rank is said once of a model whose constraints are redundant
function rank_once (m)
  n = 0;
  for k = 1:5
    lastwarn ("", "");
    evalc ("m.acc (0, m.initial); m.rhs (0, m.initial);");
    [~, id] = lastwarn ();
    n += strcmp (id, "gsmbp:rank");
  end
  gsmbp_check (sprintf ("redundant everywhere: %d of 10 calls warn of lost rank", n), n == 0);
  bar = gsmbp_hand ("hand_fourbar");   # its JSON does not state the rank
  bar = gsmbp_set (bar, "l1", 0.3, "l3", 0.3, "l2", 0.7, "l4", 0.7);
  lastwarn ("", "");
  evalc ("bar.rhs (0, zeros (6, 1), 0);");
  [text, id] = lastwarn ();
  gsmbp_check (["a change position is a warning: " text], strcmp (id, "gsmbp:rank"));
end

## indicators are sentences, the right ones for each subroutine
function meanings (m)
  say = @(name, info) m.module ("meaning", name, info);
  gsmbp_check ("INFO of CLO and of RHS differ", ! isempty (strfind (say ("clo", 2), ...
          "loops do not close")) && ! isempty (strfind (say ("rhs", 2), "are dependent"))
               && ! isempty (strfind (say ("rhs", 3), "angles of orientation")) ...
                   && ! isempty (strfind (say ("prj", 3), "no position")) ...
                   && ! isempty (strfind (say ("cmd", 5), "actuators")));
  gsmbp_check ("arguments of the Fortran by their names", ! isempty (strfind (say ("rhs", -2), ...
          "argument x (the states) is")) ...
      && ! isempty (strfind (say ("fwd", -5), "argument tau (the efforts) is"))
               && ! isempty (strfind (say ("con", -3), "argument u (the speeds) is")) ...
                   && ! isempty (strfind (say ("prj", -2), "argument x")) ...
                   && ! isempty (strfind (say ("clo", -2), "argument qj")));
  text = gsmbp_complaint (@() gsmbp_inverse (gsmbp_fixture ("trim_integral"), ...
                                             gsmbp_plan ("quintic", [0, 1], [0, 1]), 0:1));
  gsmbp_check (["a chain that one plan does not determine: " text], ...
               ! isempty (strfind (text, "as many actuated coordinates as freedoms")));
  short = gsmbp_set (m, "l2", 0.1);
  gsmbp_check ("gsmbp_inverse", ...
               ! isempty (strfind (gsmbp_complaint (@() gsmbp_inverse (short, ...
                                       gsmbp_plan ("quintic", [0, 3], [0, 1]), 0:0.1:1)), ...
                                   "it does not close beyond 0.523599 (")));
  gsmbp_check ("... nor a way there and back between two times", ...
               ! isempty (strfind (gsmbp_complaint (@() gsmbp_inverse (short, ...
                                       gsmbp_plan ("septic", [0, 3, 0], [0, 1, 2]), [0, 2])), ...
                                   "it does not close beyond 0.523599 (")));
end

## each number above 0 that the text of a subroutine sets is told in the JSON, and what the JSON
## tells, the handles and the integrators have a sentence for
function sentences (models)
  said = unsaid = untold = {};
  for k = 2:numel (models)
    m = models{k};
    file = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out", [m.name ".f"]);
    parts = regexp (fileread (file), "\n      SUBROUTINE ", "split")(2:end);
    rows = m.json.subroutines;
    if (! iscell (rows))
      rows = num2cell (rows);
    end
    for row = rows(:)'
      told = codes_of (row{1});
      call = lower (row{1}.name(numel (m.name)+2:end));
      own = parts(strncmp (parts, [row{1}.name "("], numel (row{1}.name) + 1)){1};
      own = strjoin (regexp (own, "^ .*$", "match", "lineanchors", "dotexceptnewline"), "\n");
      set = unique (str2double ([regexp(own, "INFO = (\\d+)", "tokens"){:}]));
      for info = setdiff (set(set > 0), told)
        untold{end+1} = sprintf ("%s %d", row{1}.name, info);
      end
      for info = told(told > 0)
        text = m.module ("meaning", call, info);
        said{end+1} = call;
        if (! isempty (regexp (text, "no sentence")) || numel (strsplit (text)) < 5)
          unsaid{end+1} = sprintf ("%s %d: %s", row{1}.name, info, text);
        end
      end
    end
  end
  gsmbp_check (["INFO that is set is told in the JSON: " strjoin(untold, ", ")], isempty (untold));
  gsmbp_check (["INFO that is told has a sentence: " strjoin(unsaid, ", ")], isempty (unsaid));
  gsmbp_check (["... of " strjoin(unique (said), " ")], numel (unique (said)) >= 10);
end

function list = codes_of (row)
  list = zeros (1, 0);
  if (isfield (row, "info") && ! isempty (row.info))
    list = [row.info.code];
  end
end

## events that a user meets, as the errors of the handles
function provoked (crank)
  has = @(f, text) any (strfind (gsmbp_complaint (f), text));
  short = gsmbp_set (crank, "l2", 0.1);
  open = [pi/2, 0, 0; zeros(2, 3)];
  gsmbp_check ("CLO, loops that do not close", has (@() short.clo (0, open), "clo: INFO = "));
  light = gsmbp_set (crank, "m1", 0, "m2", 0, "m3", 0);
  gsmbp_check ("FWD, RHS without mass", ...
               [has(@() light.fwd (0, crank.initial(1:3), zeros (3, 1)), ...
                    "INFO = 1: the mass matrix is not positive definite"), ...
                has(@() light.rhs (0, crank.initial), "INFO = 1: the mass matrix is singular")]);
  gsmbp_check ("PRJ, no position nearby", has (@() light.prj (0, [0; 50; 100; 0; 0; 0]), ...
                                               "INFO = 3: no position near X satisfies"));
  gsmbp_check ("numbers without a sentence say where to look", ...
               any (strfind (crank.module ("meaning", "rhs", 77), "ERROR INDICATOR")));
end

## what is cut off, empty or of another derivation is an error that names the file
function damaged ()
  folder = tempname ();
  mkdir (folder);
  here = fileparts (which ("gsmbp_hand"));
  unwind_protect
    for name = {"motor_pendulum", "hand_crank"}
      copyfile (fullfile (here, [name{1} ".*"]), folder);
    end
    source = fullfile (folder, "hand_crank.f");
    description = fullfile (folder, "hand_crank.json");
    f = fileread (source);
    j = fileread (description);
    cases = ...
        {"empty .f", "", j, "hand_crank\\.f is empty"; "empty .json", f, "", ...
         "hand_crank\\.json is empty"; ...
             "blank .json", f, " \n", ...
                 "hand_crank\\.json is no whole description"; ".json of no scene", f, ...
                     "{\"a\": 1}", "hand_crank\\.json is no whole description"; ...
             ".json a list", f, "[1, 2]", ...
                 "hand_crank\\.json is no whole description"; "other scene's .json", f, ...
                     fileread(fullfile (folder, ...
                   "motor_pendulum.json")), ["describes the scene \"motor_pendulum\", expected " ...
                                             "hand_crank"]; ...
             "other scene's .f", fileread(fullfile (folder, ...
                   "motor_pendulum.f")), j, "hand_crank\\.f has no SUBROUTINE HAND_CRANK_PAR"; ...
             "other arguments", strrep(f, "HAND_CRANK_MAS( T, Q, CST, M, LDM )", ...
                 "HAND_CRANK_MAS( T, Q, M, CST, LDM )"), j, ...
                     ["SUBROUTINE HAND_CRANK_MAS has the arguments \\(T, Q, M, CST, LDM\\), " ...
                      "the .json beside it says"]; ...
             "other parameters", f, strrep(j, "\"npar\": 8", ...
                 "\"npar\": 9"), "has 8 parameters, the .json beside it says 9"};
    for share = 0.05:0.1:0.95
      cases(end+1,:) = {sprintf(".json cut at %.0f %%", 100 * share), f, ...
                        j(1:round (share * end)), "hand_crank\\.json is no whole description"};
      cases(end+1,:) = {sprintf(".f cut at %.0f %%", 100 * share), f(1:round (share * end)), j, ...
                        "hand_crank\\.f (has no SUBROUTINE HAND_CRANK_\\w+, which|is cut off)"};
    end
    for k = 1:rows (cases)
      put (source, cases{k,2});
      put (description, cases{k,3});
      found = gsmbp_complaint (@() gsmbp_build ("hand_crank", "directory", folder));
      if (! gsmbp_check (["files: " cases{k,1}], ...
                         ! isempty (regexp (found, ["^gsmbp_build: .*" cases{k,4}], "once")) ...
                           && ! any (found == "\n")))
        printf ("  %s\n", found);
      end
    end
    gsmbp_check ("and nothing was compiled", ! exist (fullfile (folder, "build"), "dir"));
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
end

function put (file, text)
  f = fopen (file, "w");
  fputs (f, text);
  fclose (f);
end

## a module (or a part that all modules share) that is cut short or altered is built anew; loaded
## as it is it would end Octave
function cut_modules ()
  folder = tempname ();
  guard = onCleanup (@() rmdir_all (folder));
  mkdir (folder);
  here = fileparts (which ("gsmbp_hand"));
  build = @() gsmbp_build ("motor_pendulum", "directory", here, "build", folder);
  m = build ();
  xd = m.rhs (0, [0.1; 0; 0], 1);
  common = fullfile (folder, "double", "common");
  stiff = @(m) gsmbp_simulate (m, [0; 0; 0], [0, 0.1], "method", "cvode").x(end,:);
  x = stiff (m);
  whole = ! isempty (getenv ("GSMBP_WHOLE"));
  files = {m.file, fullfile(common, "libgsmbp.a"), fullfile(common, "gsmbp_module.o"), ...
           fullfile(common, "libgsmbp_cvode.so")};
  for k = 1:numel (files)
    file = files(k);
    text = fileread (file{1});
    parts = {text(1:round (end / 2)), "", [text(1:end-100), zeros(1, 100)]};
    if (k > 1 && ! whole)     # what takes long to build: each in one of the ways
      parts = parts(k - 1);
    end
    for part = parts
      delete (file{1});   # what is loaded now must not change
      put (file{1}, part{1});
      if (! strcmp (file{1}, m.file))
        delete (m.file);
      end
      clear ("-f", m.symbol);
      n = build ();
      same = isequal (n.rhs (0, [0.1; 0; 0], 1), xd) && isequal (stiff (n), x);
      [~, name, kind] = fileparts (file{1});
      gsmbp_check (sprintf ("%s of %d bytes of %d: built anew", strrep ([name kind], m.symbol, ...
          "module"),
                            numel (part{1}), numel (text)), same);
    end
  end
end

function rmdir_all (folder)
  confirm_recursive_rmdir (false, "local");
  rmdir (folder, "s");
end

## a name of a parameter, state or subroutine that was changed in one of the two files
function altered ()
  folder = tempname ();
  guard = onCleanup (@() rmdir_all (folder));
  mkdir (folder);
  source = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out", "trim_hydraulic");
  f = fileread ([source ".f"]);
  j = fileread ([source ".json"]);
  put (fullfile (folder, "trim_hydraulic.f"), f);
  for pair = {"\"name\": \"fl\"", "\"name\": \"fk\""; "\"value\": 5000", "\"value\": 5001"; ...
              "\"C_a1\"", "\"C_a9\""}'
    put (fullfile (folder, "trim_hydraulic.json"), strrep (j, pair{:}));
    changed = ! strcmp (strrep (j, pair{:}), j);
    said = gsmbp_complaint (@() gsmbp_build ("trim_hydraulic", "directory", folder));
    gsmbp_check (sprintf ("JSON with %s for %s: %s", pair{2}, pair{1}, said),
                 changed && any (strfind (said, "they are of two derivations")) ...
                     && ! any (said == "\n"));
  end
end
