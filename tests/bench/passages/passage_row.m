## m = passage_row (ROOT, N, OUT): tests/scenes/parallelograms3.mac with N of them, derived into the
## folder OUT and built.

function m = passage_row (root, n, out)
  text = fileread (fullfile (root, "tests", "scenes", "parallelograms3.mac"));
  text = strrep (text, "n_ : 3", sprintf ("n_ : %d", n));
  text = strrep (text, "\"parallelograms3\"", sprintf ("\"parallelograms%d\"", n));
  file = fullfile (out, sprintf ("parallelograms%d.mac", n));
  bench_save (file, text);
  gsmbp_derive (file, out);
  m = gsmbp_build (sprintf ("parallelograms%d", n), "directory", out);
end
