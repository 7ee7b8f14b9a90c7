## [head, foot, drawing] = gs.report.page_parts (who, m, o)
## The page of Maxima for the model M, ahead of the place of the run's parts and behind it,
## and what is drawn in the player: a struct, [] where there is no page.  O: the options
## page and scene.

function [head, foot, drawing] = page_parts (who, m, o)
  mark = "<!-- parts of a run -->";
  text = page (who, m, o);
  if (isempty (text))
    text = plain_page (m, mark, fullfile (m.directory, [m.name ".html"]));
  endif
  place = strfind (text, mark);
  if (numel (place) != 1)
    error ("%s: option page: expected a page that gsmbp_report of Maxima wrote", who);
  endif
  head = text(1:place-1);
  foot = text(place+numel (mark):end);
  drawing = [];
  data = regexp (text, '<script type="application/json" id="drawing">(.*?)</script>', "tokens", ...
                 "once");
  if (! isempty (data))
    drawing = jsondecode (data{1});
    if (! strcmp (drawing.hash, m.scene_hash))
      error (["%s: the page of Maxima is of another scene than the model %s (hash %s, " ...
              "expected %s): write it again"], who, m.name, drawing.hash, m.scene_hash);
    endif
  endif
endfunction

## the text of the page that an option names, or that lies beside the .json; "" if there is none
function text = page (who, m, o)
  text = "";
  beside = fullfile (m.directory, [m.name ".html"]);
  if (! isempty (o.scene))
    text = written_now (who, o.scene);
  elseif (! isempty (o.page))
    if (exist (o.page, "file") != 2)
      error ("%s: option page: there is no file %s", who, o.page);
    endif
    text = fileread (o.page);
  elseif (exist (beside, "file") == 2)
    text = fileread (beside);
  endif
endfunction

## the page of a scene file, by Maxima
function text = written_now (who, scene)
  if (exist (scene, "file") != 2)
    error ("%s: there is no scene file %s", who, scene);
  endif
  file = [tempname() ".html"];
  guard = onCleanup (@() gs.files.discard_file (file));
  parts = {gs.files.own_place("share", "make", "page"), make_absolute_filename(scene), file};
  quoted = cellfun (@(s) ["'" strrep(s, "'", "'\\''") "'"], parts, "UniformOutput", false);
  [status, said] = system ([strjoin(quoted, " "), " 2>&1"]);
  if (status != 0)
    error ("%s: %s", who, strtrim (regexprep (said, '^page: ', "", "lineanchors")));
  endif
  text = fileread (file);
endfunction

## a page without that of Maxima, which was not found at the place FILE
function text = plain_page (m, mark, file)
  [head, foot] = gs.text.html_page (["Run of " m.name]);
  text = [head, ...
          sprintf(["<p>Omitted: equations, graph and player. There is no report page of Maxima " ...
                   "at %s: write it with gsmbp_report(scene, html = \"%s\") in Maxima, or pass " ...
                   "the scene file: \"scene\", \"%s.mac\".</p>\n"], gs.text.html_escaped(file), ...
                  gs.text.html_escaped(file), gs.text.html_escaped(m.name)), ...
          mark, foot];
endfunction
