## text = gs.model.routine_signature (row)
## The arguments of an emitted subroutine as glue/signature.h reads them, "t q(2) cst >e(3)",
## from its ROW of the JSON's "subroutines".  "" where ROW has no shapes, or a handle needs more
## than they tell (the range of a number, a leading dimension): such a subroutine has a row in the
## table of the module, or no handle.  For many states at once the arrays are told as for one.

function text = routine_signature (row)
  text = "";
  if (! isfield (row, "shapes") || isempty (row.shapes))
    return;
  endif
  names = tolower (cellstr (row.arguments)(:)');
  shapes = cellstr (row.shapes)(:)';
  if (strcmp (names{end}, "ldk"))
    shapes = strrep (strrep (shapes, "(LDK,", "("), "(LDK)", "");
    shapes(end-1:end) = {"states", "leading"};
  endif
  words = cellfun (@word, names, shapes, "UniformOutput", false);
  if (any (strcmp (names, "cst")) && ! any (cellfun (@isempty, words)))
    text = strjoin (optional (words), " ");
  endif
endfunction

## "t(1)", ">e(3)", "cst", ">#ns(1)" (whole numbers), "k[-9:9]" (a whole number that is read); ""
## where it cannot be told.  SHAPE: "in", "out(3)", "integer in", "integer out(8)"
function text = word (name, shape)
  text = "";
  shape = from_one (shape);
  part = regexp (shape, '^(in|out|inout)((?:\(.*\))?)$', "tokens", "once");
  if (any (strcmp (name, {"cst", "info"})))
    text = name;
  elseif (any (strcmp (shape, {"states", "leading"})))
    text = struct ("states", "k", "leading", "ld").(shape);
  elseif (! isempty (part) && isempty (regexp (shape, '[*:]', "once")))
    text = [mark(part{1}), name, dimensions(part{2})];
  elseif (strcmp (shape, "integer in") && ! strncmp (name, "ld", 2))
    text = [name, "[-99999999:99999999]"];   # the subroutine checks it
  elseif (strncmp (shape, "integer out", 11))
    text = [">#", name, dimensions(shape(12:end))];
  elseif (strcmp (shape, "in(*)") && any (strcmp (name, {"v", "xi"})))
    text = name;   # none in this scene
  elseif (strcmp (shape, "in(*)") && strcmp (name, "lam"))
    text = "lam(0)";
  endif
endfunction

## in(3,0:2) as in(3,3)
function shape = from_one (shape)
  last = str2double (regexp (shape, '0:(\d+)', "tokens", "once"));
  if (! isempty (last))
    shape = regexprep (shape, '0:\d+', sprintf ("%d", last + 1));
  endif
endfunction

function text = mark (intent)
  text = struct ("in", "", "out", ">", "inout", "<").(intent);
endfunction

function text = dimensions (text)
  if (isempty (text))
    text = "(1)";
  endif
endfunction

## what may be left out: inputs and states of the inverse model that nothing is read behind
function words = optional (words)
  for k = find (strcmp (words, "cst"), 1)-1:-1:1
    if (isempty (regexp (words{k}, '^(v|xi)\>', "once")))
      break;
    endif
    words{k} = ["?" words{k}];
  endfor
endfunction
