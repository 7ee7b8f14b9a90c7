## run_blocks (FILE): the %! blocks of one function file as lines `ok`, `not ok`,
## from the same random numbers every time.

function run_blocks (file)
  [~, name] = fileparts (file);
  if (isempty (regexp (fileread (file), '(?m)^%!(test|assert|error|fail)', "once")))
    printf ("not ok %s: expected %%! tests, found none\n", name);
    return;
  end
  log = tempname ();
  rand ("twister", 1);
  randn ("twister", 1);
  [passed, all] = test (file, "quiet", log);
  said = fileread (log);
  unlink (log);
  for k = 1:passed
    printf ("ok %s: %d of %d blocks\n", name, k, all);
  end
  for reason = reasons (said, all - passed)
    printf ("not ok %s: a block failed: %s\n", name, reason{1});
  end
  if (passed < all)
    puts (said);
  end
end

## what the log of `test` says of each of N failures, in one line
function list = reasons (log, n)
  list = regexp (log, '!!!!! (?:test|error|fail)\w* failed\.?\s*(.*?)(?=\n\*\*\*\*\*|$)', "tokens");
  list = cellfun (@(one) strtrim (regexprep (one{1}, '\s+', " ")), list, "UniformOutput", false);
  list(end+1:n) = {"expected that it passes, found no reason in the log"};
  list = list(1:n);
end
