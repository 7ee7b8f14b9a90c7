## gs.sweep.check_same (who, place, there, here)
## An error of WHO unless what PLACE says of its sweep, THERE, is what this one says, HERE
## (gs.sweep.describe_sweep): it tells the first line in which they differ.

function check_same (who, place, there, here)
  if (numel (there) < numel (here) && strncmp (there, here, numel (there)))
    error ("%s: what %s says of its sweep is cut short: remove it to begin anew", who, place);
  endif
  [there, here] = deal (strsplit (there, "\n"), strsplit (here, "\n"));
  alone = {setdiff(there, here, "stable"), setdiff(here, there, "stable")};
  keys = cellfun (@(list) regexprep (list, ':.*', ''), alone, "UniformOutput", false);
  key = [keys{:}, {""}]{1};
  if (! isempty (key))
    said = cellfun (@(list, key_of) line_of (list(strcmp (key_of, key)), key), alone, keys, ...
                    "UniformOutput", false);
    error ("%s: %s is of another sweep: there %s, here %s", who, place, said{:});
  endif
endfunction

function text = line_of (lines, key)
  text = ["no " key];
  if (! isempty (lines))
    text = ["`" lines{1} "`"];
  endif
endfunction
