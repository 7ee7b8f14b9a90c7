## [m, way, index2] = gs.run.loop_way (who, o, m)
## The way of the loops: its number, whether they are in index 2, and the model M with its parameter
## loop_method.  O: the options of gsmbp_simulate.

function [m, way, index2] = loop_way (who, o, m)
  words = gs.text.table_rows ("GS_LOOP_METHODS");
  words = words(:,1)';
  d = m.sizes;
  has = @(name) any (strcmp (m.subroutines, name));
  euler = d.nq > d.nu;
  word = o.loops;
  if (isempty (word))
    word = words{1 + (has ("prj") && (d.nlam > 0 || euler))};
    if (strcmp (o.method, "gauss") && d.nlam > 0 && ! euler && has ("kin") && has ("con"))
      word = "partitioning";   # the steps are those of the independent coordinates alone
    endif
    if (! isempty (o.projection))
      word = words{1 + logical(o.projection)};
    endif
  elseif (! isempty (o.projection))
    error ("%s: give \"loops\" or \"projection\", not both", who);
  endif
  way = find (strcmp (word, words));
  if (isempty (way))
    error ("%s: option loops %s", who, ...
           gs.text.refusal_text ("loops", strjoin (words, ", "), gs.text.shown_value (word)));
  endif
  if (! isempty (o.loops) && d.nlam == 0 && ! euler && way < 7)
    warning ("gsmbp:option", ["%s: option loops: %s is an open chain without constraints and " ...
                              "does not use it"], who, m.name);
  endif
  index2 = way == 7;
  if (index2)
    check_index2 (who, o, m);
    way = 2;
  endif
  if (d.nlam == 0 && isempty (o.projection))
    way = 1 + (way > 1 && euler);   # nothing but Euler parameters to look after
  endif
  method = max (1, way - 2);
  if (isfield (m.par, "loop_method"))
    if (m.par.loop_method != method)
      m = gsmbp_set (m, "loop_method", method);
    endif
  elseif (method > 1)
    error (["%s: %s was derived without the ways nullspace, svd and kane (it has no " ...
            "parameter loop_method): derive the scene again"], who, m.name);
  endif
  needs = {{}, {"prj"}, {"con", "kin", {"prj"}{ones (1, euler)}}, {"prj"}, {"prj"}, ...
           {"con", "kin", "prj"}}{way};
  for name = needs
    if (! has (name{1}))
      error ("%s: the way \"%s\" needs the subroutine %s, which %s was emitted without", who, ...
             words{way}, toupper (name{1}), m.name);
    endif
  endfor
endfunction

## what index 2 needs
function check_index2 (who, o, m)
  if (m.sizes.nlam == 0)
    error ("%s: option loops: %s", who, gs.text.refusal_text ("no_loops", m.name));
  elseif (! any (strcmp (o.method, {"radau", "auto"})))
    error ("%s: %s", who, gs.text.refusal_text ("index2_method", gs.text.shown_value (o.method)));
  endif
  for name = {"mas", "con", "tan"}
    if (! any (strcmp (m.subroutines, name{1})))
      error (["%s: the way \"index2\" needs the subroutine %s, which %s was emitted " ...
              "without"], who, toupper (name{1}), m.name);
    endif
  endfor
endfunction
