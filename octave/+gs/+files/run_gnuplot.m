## gs.files.run_gnuplot (who, file, terminal, lines, table)
## Runs gnuplot on the cell array LINES; TERMINAL draws into FILE, which appears
## whole or not at all: gnuplot itself does not notice a full disk.  An error of WHO
## shows what gnuplot wrote.  TABLE, a file with the numbers, takes its place beside
## FILE (.csv) together with it.

function run_gnuplot (who, file, terminal, lines, table)
  [~, ~, kind] = fileparts (file);
  new = gs.files.new_beside (who, file);
  script = [tempname() ".gp"];
  guards = {onCleanup(@() gs.files.discard_file (script)), ...
            onCleanup(@() gs.files.discard_file (new)), ...
            onCleanup(@() gs.files.discard_file (table))};
  gs.files.write_text (who, script, ...
                       sprintf ("%s\n", ["set terminal " terminal], ...
                                ["set output " gs.text.gnuplot_quoted(new)], lines{:}));
  gs.files.run_command (who, ["gnuplot '" strrep(script, "'", "'\\''") "'"]);
  if (! whole (new, kind))
    error (["%s: cannot write %s: gnuplot left a part of it (is the disk full?); " ...
            "what was there before is as it was"], who, file);
  endif
  gs.files.rename_new (who, table, [file(1:end-numel (kind)) ".csv"]);
  gs.files.rename_new (who, new, file);
endfunction

## does the picture end as its format says?
function yes = whole (file, kind)
  f = fopen (file, "r");
  if (f < 0)
    yes = false;
    return;
  endif
  fseek (f, -min (40, stat (file).size), "eof");
  last = fread (f, 40, "uint8=>char")';
  fclose (f);
  switch (tolower (kind))
    case ".gif"
      yes = ! isempty (last) && last(end) == ";";
    case ".png"
      yes = numel (last) >= 8 && strcmp (last(end-7:end-4), "IEND");
    case ".svg"
      yes = ! isempty (strfind (last, "</svg>"));
    otherwise
      yes = ! isempty (strfind (last, "%%EOF"));
  endswitch
endfunction
