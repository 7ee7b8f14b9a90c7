## rows = gs.optimize.goal_rows (who, what, given, cases, goal)
## Goals (GOAL: true) or demands, a struct array: word, name, factor, relation, bound, cases (their
## numbers), f (a function instead), text.  GIVEN: a cell array, a row for each: {word, name},
## {word, name, factor} of a goal, {word, name, relation, bound} of a demand, each with the name of
## a load case after it if it is of one alone; {f}, {f, factor}, {f, relation, bound} of functions.

function list = goal_rows (who, what, given, cases, goal)
  list = struct ("word", {}, "name", {}, "factor", {}, "relation", {}, "bound", {}, ...
                 "cases", {}, "f", {}, "text", {});
  if (is_function_handle (given))
    given = {given};
  elseif (isempty (given))
    return;
  elseif (! iscell (given))
    error ("%s: argument %s: expected a cell array, a row for each, found %s", who, what, ...
           gs.text.shown_value (given));
  endif
  for k = 1:rows (given)
    here = sprintf ("argument %s: row %d", what, k);
    row = given(k,:);
    while (numel (row) > 1 && isempty (row{end}))
      row(end) = [];
    endwhile
    list(end+1) = one (who, here, row, cases, goal);
  endfor
endfunction

function r = one (who, here, row, cases, goal)
  r = struct ("word", "", "name", "", "factor", 1, "relation", "", "bound", 0, ...
              "cases", 1:numel (cases), "f", [], "text", "");
  if (is_function_handle (row{1}))
    r.f = row{1};
    r.text = func2str (row{1});
    rest = row(2:end);
  else
    r = named (who, here, r, row, cases);
    rest = row(3:end);
  endif
  if (numel (rest) > 0 && isempty (r.f) && ischar (rest{end}) ...
      && ! any (strcmp (rest{end}, {"<", ">", "="})))
    r.cases = find (strcmp (rest{end}, {cases.name}));
    if (isempty (r.cases))
      error ("%s: %s: unknown load case %s", who, here, gs.text.nearest_word (rest{end}, ...
                                                                              {cases.name}));
    endif
    r.text = [r.text " in " rest{end}];
    rest(end) = [];
  endif
  if (goal)
    r = of_goal (who, here, r, rest);
  else
    r = of_demand (who, here, r, rest);
  endif
endfunction

function r = named (who, here, r, row, cases)
  words = gs.text.table_rows ("GS_DESIGN_WORDS")';
  if (! (numel (row) > 1 && ischar (row{1}) && ischar (row{2})))
    error ("%s: %s: expected a word and a name, or a function, found %s", who, here, ...
           strjoin (cellfun (@gs.text.shown_value, row, "UniformOutput", false), ", "));
  elseif (! any (strcmp (row{1}, words)))
    error ("%s: %s: unknown word %s", who, here, gs.text.nearest_word (row{1}, words));
  elseif (isempty (cases) && ! any (strcmp (row{1}, {"value", "mass"})))
    error ("%s: %s: %s %s needs a load case (argument cases)", who, here, row{1:2});
  endif
  [r.word, r.name] = row{1:2};
  r.text = [row{1} " " row{2}];
endfunction

function r = of_goal (who, here, r, rest)
  if (numel (rest) > 1)
    error ("%s: %s: expected a word, a name and a factor, found %d more", who, here, ...
           numel (rest) - 1);
  elseif (! isempty (rest))
    gs.given.check_kind (who, [here ": factor"], rest{1}, "number");
    r.factor = rest{1};
  endif
  if (strcmp (r.word, "each"))
    error ("%s: %s: each is a word of demands; expected one number to make small", who, here);
  endif
endfunction

function r = of_demand (who, here, r, rest)
  if (numel (rest) != 2 || ! ischar (rest{1}))
    error ("%s: %s: expected a relation (\"<\", \">\", \"=\") and a bound behind %s", who, here, ...
           r.text);
  endif
  gs.given.check_kind (who, [here ": relation"], rest{1}, {"<", ">", "="});
  gs.given.check_kind (who, [here ": bound"], rest{2}, "number");
  [r.relation, r.bound] = rest{:};
  r.text = sprintf ("%s %s %g", r.text, rest{:});
endfunction
