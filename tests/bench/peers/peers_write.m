## peers_write (file, text)

function peers_write (file, text)
  f = fopen (file, "w");
  fputs (f, text);
  fclose (f);
end
