## bench_save (file, text): the file appears whole or not at all.

function bench_save (file, text)
  fid = fopen ([file ".new"], "w");
  fputs (fid, text);
  fclose (fid);
  rename ([file ".new"], file);
end
