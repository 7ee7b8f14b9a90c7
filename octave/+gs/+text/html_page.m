## [head, foot] = gs.text.html_page (title)
## What stands ahead of and behind the parts of a page with that TITLE, in the style of a report.
## The page fetches nothing.

function [head, foot] = html_page (title)
  style = fileread (gs.files.own_place ("share", "report", "style.css"));
  policy = ["default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; " ...
            "img-src data:"];
  title = gs.text.html_escaped (title);
  head = [sprintf("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"), ...
          sprintf("<meta http-equiv=\"Content-Security-Policy\" content=\"%s\" />\n", policy), ...
          sprintf("<title>%s</title>\n<style>\n%s</style>\n</head>\n", title, style), ...
          sprintf("<body>\n<main>\n<h1>%s</h1>\n", title)];
  foot = sprintf ("\n</main>\n</body>\n</html>\n");
endfunction
