## run_blocks (FILE): the %! blocks of one function file as lines `ok`, `not ok`.

function run_blocks (file)
  [~, name] = fileparts (file);
  if (isempty (regexp (fileread (file), '(?m)^%!(test|assert|error|fail)', "once")))
    printf ("not ok %s has no %%! tests\n", name);
    return;
  end
  log = tempname ();
  [passed, all] = test (file, "quiet", log);
  for k = 1:all
    if (k <= passed)
      printf ("ok %s: %d of %d blocks\n", name, k, all);
    else
      printf ("not ok %s: a block failed\n", name);
    end
  end
  if (passed < all)
    puts (fileread (log));
  end
  unlink (log);
end
