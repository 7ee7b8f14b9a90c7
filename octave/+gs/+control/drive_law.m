## c = gs.control.drive_law (who, m, o, law)
## A controller of gsmbp_model_control for the model M through loops and drives: it calls the
## closure of the loops (CLO) and the command of the drives (CMD; CMQ where they have states).
## Its memory: integrals, coordinates of the loops, how many samples had no command (for
## gs.run.held_samples).  Field THROUGH: the independent coordinates, derivatives in the motion, the
## subroutine, which inputs an effort on each independent coordinate asks for.

function c = drive_law (who, m, o, law)
  t.law = law;
  t.independent = (1:m.sizes.nu)';
  if (m.sizes.nlam > 0)
    t.independent = m.actuated;
  endif
  t.loops = m.sizes.nlam > 0;
  t.order = max (m.order, 2);
  t.cartesian = strcmp (law, "cartesian impedance");
  [t.command, t.derivatives] = command (who, m, law, t);
  needs (who, m, "mas", "mass");
  if (m.sizes.nlam > 0)
    needs (who, m, "clo", "closure");
  endif
  x = m.initial;
  if (! isempty (o.trim))
    x = gs.given.given_vector (who, "option trim", o.trim.x, m.sizes.nx, "", m.states);
  endif
  [q, u] = deal (x(1:m.sizes.nq), x(m.sizes.nq + (1:m.sizes.nu)));
  t.guess = closed (who, m, [q, zeros(m.sizes.nu, t.order)])(:,1);
  c = struct ("method", law, "name", o.name, "period", o.period, "delay", o.delay);
  [v, S] = inputs_of (who, m, t, t.guess, u);
  [c.driven, t.acts] = driven (who, m, o, S);
  k = gs.given.places_of (c.driven, m.inputs);
  c.u0 = v(k);
  t.margins = numel (m.static_margins);
  [~, t.pair] = max (t.acts, [], 1);
  if (strcmp (law, "feedforward") && ! (all (sum (t.acts, 1) == 1) && all (sum (t.acts, 2) == 1)))
    error (["%s: %s: feedforward has a PID controller of each coordinate on its own drive: " ...
            "expected drives that move one of %s each, found others"], who, m.name, ...
           strjoin (m.coordinates(t.independent)', ", "));
  endif
  c.through = t;
  guess = t.guess(1:end * (m.sizes.nlam > 0));
  integrals = zeros (numel (t.independent) * (1 - t.cartesian), 1);
  c.starts = [integrals; guess; 0];   # the last one counts samples without a command
  c.A = eye (numel (c.starts));
endfunction

## CMD or CMQ, and the derivatives of the references
function [name, k] = command (who, m, law, t)
  k = 2;
  has = @(name) any (strcmp (m.subroutines, name));
  if (t.cartesian)
    k = 1;
  endif
  if (has ("cmd") && isempty (m.internal) && (m.order <= 2 || strcmp (law, "feedforward")))
    name = "cmd";
    k = max (k, m.order * strcmp (law, "feedforward"));
  elseif (has ("cmq"))
    name = "cmq";
  elseif (has ("cmd") && ! isempty (m.internal))
    error (["%s: %s: the inputs of a motion depend on states of devices that nothing measures " ...
            "(%s), and there is no command without them: %s"], who, m.name, ...
           strjoin (m.states(m.internal)', ", "), gs.text.why_left_out (m, "quasi_static"));
  else
    request = "command";
    if (has ("cmd"))
      request = "quasi_static";
    endif
    error ("%s: %s has no inputs of a motion: request %s: %s", who, m.name, request, ...
           gs.text.why_left_out (m, request));
  endif
endfunction

function needs (who, m, suffix, request)
  if (! any (strcmp (m.subroutines, suffix)))
    error ("%s: %s was emitted without %s: request %s: %s", who, m.name, upper (suffix), ...
           request, gs.text.why_left_out (m, request));
  endif
endfunction

## inputs that hold the state with no acceleration, and by how much an effort of 1 on each
## independent speed changes them
function [v, S] = inputs_of (who, m, t, q, u)
  n = numel (t.independent);
  TR = zeros (m.sizes.nu, n);
  one = zeros (m.sizes.nu, t.order + 1);
  [one(:,1), one(:,2)] = deal (q, u);
  rest = one;
  rest(:,2) = 0;
  still = closed (who, m, rest);
  for j = 1:n
    rest(:,2) = 0;
    rest(t.independent(j),2) = 1;
    TR(:,j) = (closed (who, m, rest) - still)(:,2);
  endfor
  v = at (m, t.command, closed (who, m, one));
  if (numel (v) != m.sizes.nv)
    error (["%s: %s has references of a controller among its inputs (%s): expected the model " ...
            "of the scene, without controllers"], who, m.name, m.inputs{end});
  endif
  name = t.command;   # rates within the drives apart
  if (any (strcmp (m.subroutines, "cmq")))
    name = "cmq";
  endif
  least = at (m, name, closed (who, m, one));
  Y = zeros (m.sizes.nv, n);
  for j = 1:n
    more = one;
    more(t.independent(j),3) = 1;
    Y(:,j) = at (m, name, closed (who, m, more)) - least;
  endfor
  S = Y / (TR' * m.mas (0, q) * TR);
endfunction

function one = closed (who, m, one)
  if (m.sizes.nlam > 0)
    [one, ~, info] = m.clo (0, one);
    if (info != 0)
      error (["%s: %s: the loops do not close where it starts (%s): expected option trim, a " ...
              "position near which they do"], who, m.name, gs.text.info_meaning (m, "clo", info));
    endif
  endif
endfunction

function v = at (m, name, one)
  if (strcmp (name, "cmq"))
    v = m.cmq (0, one(:,1:3));
  else
    v = m.cmd (0, one);
  endif
  v = v(:);
endfunction

## inputs of the drives, in the order of the independent coordinates where each has its own; ACTS:
## which of them an effort on each coordinate changes
function [names, acts] = driven (who, m, o, S)
  acts = abs (S) > 1e-7 * max (abs (S(:)));
  drives = any (acts, 2);
  names = gs.given.asked_names (o.inputs);
  if (isempty (names))
    k = find (drives);
    [~, order] = sort (arrayfun (@(i) find (acts(i,:), 1), k));
    names = m.inputs(k(order));
  endif
  k = gs.given.places_of (names, m.inputs);
  if (! all (k) || ! isequal (sort (k), find (drives)))
    error ("%s: option inputs: expected those of the drives (%s), found %s", who, ...
           strjoin (m.inputs(drives)', ", "), strjoin (names', ", "));
  endif
  acts = acts(k,:);
endfunction
